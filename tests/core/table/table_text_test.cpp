#include "table/table_text.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "table/small_table.hpp"
#include "table/table_build.hpp"

namespace wrc::test {
namespace {

void expect_line(const ContactTable& table, const std::string& line) {
  const std::vector<std::string> lines = lines_of(table);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), line), 1) << line;
}

TEST(TableText, SaysWhatATableIsOfInItsUnits) {
  ContactTable table = small_table();
  expect_line(table, "wheelset.wheel = " + table.identity.wheel);
  expect_line(table, "track.rail = " + table.identity.rail);
  expect_line(table, "wheelset.radius = " + text_of(table.identity.numbers[0]) + " mm");
  expect_line(table, "track.inclination = " + text_of(table.identity.numbers[5]) + " rad");
  expect_line(table, "solve.method = auto");
  table.identity.numbers[0] = 460.0;
  table.identity.numbers[6] = 210000.0;
  table.ranges = {8.0, 0.01, 0.02, 150000.0};
  table.convention = {Units::si, TrackFrame::right_down};
  expect_line(table, "wheelset.radius = 0.46 m");
  expect_line(table, "material.wheel.youngs_modulus = 2.1e+11 Pa");
  expect_line(table, "units and axes of steps: m, N, Pa, rad; x forward, y right, z down");
  expect_line(table, "reaches to lateral 0.008 m, roll 0.01 rad, yaw 0.02 rad, load 150000 N");
}

/// Numbers of a refusal are those that the caller gave.
TEST(TableText, RefusalsAreInTheUnitsOfTheScene) {
  Scene scene;
  scene.convention = {Units::si, TrackFrame::left_up};
  TableOptions options;
  options.ranges.lateral = 40.0;
  expect_error(
      ErrorCode::invalid_argument, [&] { (void)build_table(scene, options, SceneSolver()); },
      "lateral = 0.04 m: must be between 5e-04 m and 0.03 m");
}

} // namespace
} // namespace wrc::test
