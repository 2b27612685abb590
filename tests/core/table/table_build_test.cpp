#include "table/table_build.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "table/small_table.hpp"
#include "table/table_nodes.hpp"
#include "table/table_options.hpp"

namespace wrc::test {
namespace {

TEST(TableBuild, ThreadsDoNotChangeABit) {
  TableOptions options = options_of_small_table();
  options.threads = 3;
  double last = 0.0;
  bool falls = false;
  options.progress = [&](double share) {
    falls = falls || share < last;
    last = share;
  };
  const ContactTable table = build_table(scene_of_small_table(), options, SceneSolver());
  EXPECT_EQ(table.contact.coefficients(), small_table().contact.coefficients());
  EXPECT_EQ(table.errors.vertices(), small_table().errors.vertices());
  EXPECT_EQ(table.measured.worst, small_table().measured.worst);
  EXPECT_FALSE(falls);
  EXPECT_GT(last, 0.9);
}

/// The promises: at most 2 in 1000 fresh states err by more than the bound returned with them, and
/// 1 in 100 by more than the likely error; of a sample, with three standard deviations.
TEST(TableBuild, FreshStatesKeepWithinTheErrorReturned) {
  ContactTable table = small_table();
  TableNodes nodes(scene_of_small_table(), SceneSolver(), table);
  const std::size_t cells = table.errors.cell_count();
  constexpr std::size_t count = 6000;
  std::size_t beyond = 0;
  std::size_t beyond_likely = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const TableState state = random_state(table, i % cells, (7ULL << 40U) + i / cells);
    const TableContact found = contact_in_table(table, state, false);
    const Vector3 exact = force_of(nodes.solve_exactly(state, false, 1e-2));
    const Vector3 force{found.force[0], found.force[1], found.force[2]};
    const double load = std::max(exact.z, 0.5 * table.ranges.load);
    beyond += norm(force - exact) > found.errors[bound_of_force] * load ? 1 : 0;
    beyond_likely += norm(force - exact) > found.errors[likely_of_force] * load ? 1 : 0;
  }
  const double promised = 2e-3 * count;
  EXPECT_LE(static_cast<double>(beyond), promised + 3.0 * std::sqrt(promised));
  const double likely = 1e-2 * count;
  EXPECT_LE(static_cast<double>(beyond_likely), 1.5 * likely);
  EXPECT_GE(static_cast<double>(beyond_likely), 0.5 * likely);
}

TEST(TableBuild, RefusesWhatATableCannotHave) {
  const auto message_of = [](Scene scene, const TableOptions& options) -> std::string {
    try {
      build_table(scene, options, SceneSolver());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const TableOptions options = options_of_small_table();
  Scene scene = scene_of_small_table();
  scene.left.friction.places = {{0.0, 0.3}};
  EXPECT_NE(message_of(scene, options).find("friction.left = 0.3"), std::string::npos);
  scene = scene_of_small_table();
  scene.model = ModelRequest::hertz;
  EXPECT_NE(message_of(scene, options).find("solve.model = hertz"), std::string::npos);
  scene = scene_of_small_table();
  scene.rail_steel.yield_stress = 500.0;
  EXPECT_NE(message_of(scene, options).find("material.rail.yield_stress = 500"), std::string::npos);
  scene = scene_of_small_table();
  scene.right.radius = 459.0;
  EXPECT_NE(message_of(scene, options).find("both sides"), std::string::npos);
  scene = scene_of_small_table();
  scene.right.friction.coefficient = 0.1;
  EXPECT_NE(message_of(scene, options).find("friction.right = 0.1"), std::string::npos);
  scene = scene_of_small_table();
  scene.left.wheel.name = scene.right.wheel.name = "S1002\x1b[31m";
  EXPECT_NE(message_of(scene, options).find("must be text of one line"), std::string::npos);
  TableOptions large = options;
  large.ranges.lateral = 30.0;
  large.fineness = 4.0;
  EXPECT_NE(message_of(scene_of_small_table(), large).find("MB"), std::string::npos);
  TableOptions wrong = options;
  wrong.fineness = 7.0;
  EXPECT_NE(
      message_of(scene_of_small_table(), wrong).find("fineness = 7: must be between 0.2 and 4"),
      std::string::npos);
}

} // namespace
} // namespace wrc::test
