/// The shipped study of a crossing: both wheels, from the wing rail to the nose.
#include <algorithm>
#include <cmath>

#include "run_driver.hpp"
#include "support/csv_table.hpp"

namespace crossing_test {
namespace {

using driver::CsvTable;

class Crossing : public Driver {
protected:
  Crossing() : Driver(WRC_SWEEP_PROGRAM) {}

  [[nodiscard]] CsvTable solved(const std::string& options) const {
    const Outcome outcome = run("crossing --no-pictures --out o " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return CsvTable(folder() / "o/crossing.csv");
  }
};

/// Pairs 0.002 mm apart: where the nose begins, where both share the load, where the wing ends.
TEST_F(Crossing, CarriesTheLoadAtContinuousHeights) {
  const CsvTable table =
      solved("--set 'pose.longitudinal=[-500, -400, -300, -200, -100, 0, 89.999, 90.001, 150, 176, "
             "184, 184.002, 188, 200, 250, 350, 450, 559.999, 560.001, 700]'");
  ASSERT_EQ(table.row_count(), 20U);
  constexpr double load = 60000.0;
  constexpr double accuracy = 1e-2;
  constexpr double steepest = 0.02; // 0.009 measured at 1 mm
  int shared = 0;
  const auto height_at = [&](std::size_t i) { // under the left wheel's load
    return table.numbers("vertical")[i] - table.numbers("left.depth")[i];
  };
  double before = height_at(0);
  double place = table.numbers("pose.longitudinal")[0];
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    SCOPED_TRACE(table.texts("pose.longitudinal")[i]);
    EXPECT_EQ(table.texts("status")[i], "ok");
    EXPECT_EQ(table.numbers("warning_count")[i], 0.0) << table.texts("warnings")[i];
    for (const std::string side : {"left", "right"}) {
      EXPECT_NEAR(table.numbers(side + ".pressure_force.z")[i], load, accuracy * load);
      EXPECT_LT(table.numbers(side + ".error_estimate")[i], accuracy);
    }
    const double height = height_at(i);
    const double now = table.numbers("pose.longitudinal")[i];
    EXPECT_LE(std::abs(height - before), steepest * (now - place));
    before = height;
    place = now;
    if (table.numbers("left.patch_count")[i] > 1.0 &&
        table.numbers("left.patches.1.normal_force")[i] > 0.05 * load) {
      ++shared;
      EXPECT_GT(
          std::abs(table.numbers("left.patches.0.y")[i] - table.numbers("left.patches.1.y")[i]),
          70.0)
          << "wing and nose";
    }
  }
  EXPECT_GE(shared, 3);
  // The wheel on the plain rail before it is as the other one.
  EXPECT_NEAR(table.numbers("left.pmax")[0], table.numbers("right.pmax")[0],
              0.03 * table.numbers("right.pmax")[0]);
  EXPECT_NEAR(table.numbers("vertical")[0], table.numbers("vertical")[19], 0.01);
  EXPECT_LT(table.numbers("vertical")[11], table.numbers("vertical")[0] - 0.4) << "the dip";
}

/// What a page draws.
nlohmann::json data_of(const std::string& page) {
  const std::string mark = "const data = ";
  const std::size_t begin = page.find(mark) + mark.size();
  return nlohmann::json::parse(page.substr(begin, page.find('\n', begin) - begin - 1));
}

/// The outline is that of all parts of the rail at the wheelset.
TEST_F(Crossing, OutlinesShowNoseAndWing) {
  const Outcome outcome =
      run("crossing --page p.html --set 'pose.longitudinal=[-500, 300]' --set solve.creep=none");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto data = data_of(read("p.html"));
  const auto width = [&](std::size_t scene) {
    const auto& rail = data["scenes"][scene]["left"]["rail"];
    double low = rail[0];
    double high = rail[0];
    for (std::size_t i = 0; i < rail.size(); i += 2) {
      low = std::min(low, rail[i].get<double>());
      high = std::max(high, rail[i].get<double>());
    }
    return high - low;
  };
  constexpr double wing_end = (300.0 + 369.0) / 9.0 + 72.0;
  EXPECT_NEAR(width(0), 74.0, 2.0);
  EXPECT_NEAR(width(1), wing_end, 4.0);
}

/// A number that the end of a part leaves without a bound is left out, which the page can show.
TEST_F(Crossing, PageLeavesOutWhatHasNoBound) {
  const Outcome outcome =
      run("crossing --page p.html --set 'pose.longitudinal=[999, 999.5]' --set solve.creep=none");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  for (const auto& scene : data_of(read("p.html"))["scenes"]) {
    EXPECT_TRUE(scene["left"].contains("area") && scene["right"].contains("pmax"));
    EXPECT_FALSE(scene["left"].contains("pmax"));
  }
}

/// Results know the slices that they depend on.
TEST_F(Crossing, SlicesAreInputs) {
  std::filesystem::create_directories(folder() / "own");
  const std::filesystem::path shipped = std::filesystem::path(WRC_CROSSING).parent_path();
  for (const auto& file : std::filesystem::directory_iterator(shipped)) {
    std::filesystem::copy_file(file.path(), folder() / "own" / file.path().filename());
  }
  write("s.toml", "[track]\nleft.rail = 'own/crossing.slcs'\n[pose]\nlongitudinal = [0, 10]\n"
                  "[load]\nboth = 0\n");
  EXPECT_EQ(run("s.toml --out o").exit_code, 0);
  const std::string content = read("o/s.nc");
  for (const char* name : {"own/crossing.slcs", "own/slice_p0090.txt", "own/slice_p1000.txt"}) {
    EXPECT_NE(content.find(name), std::string::npos) << name;
  }
  std::filesystem::remove(folder() / "own/slice_p0090.txt");
  run("s.toml --out o2").expect_refusal({"slice_p0090.txt"});
}

} // namespace
} // namespace crossing_test
