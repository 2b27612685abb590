// The paper's Table 2: largest pressure of the left wheel over the lateral displacement.
#include <gtest/gtest.h>

#include "scene/solve_scene.hpp"

namespace wrc::test::paper_table2_test {
namespace {

/// The load of the table is not printed; 80 kN along the wheelset's vertical fits. The paper's
/// grid, profile points and roll are not known in digits, so this share is asked for.
constexpr double calm = 0.01;
/// About to jump to the gauge corner: 0.1 mm of displacement change it by 2 %, the paper's two
/// programs differ by 4.5 %.
constexpr double jump = 0.08;
/// The peak stands on a strip 1.8 mm wide: 0.1 mm of displacement or another variant of the rail
/// change it by 10 to 14 %.
constexpr double strip = 0.25;

Scene paper_scene(double lateral) {
  Scene scene;
  scene.lateral = lateral;
  scene.gap = GapConvention::vertical;
  scene.normal_load = 80000.0;
  scene.grid = {{256, 128}};
  scene.side = SideChoice::left;
  return scene;
}

struct Entry {
  double lateral;
  double pmax; // MPa, "the present model"
  double tolerance;
};

class PaperTable2 : public testing::TestWithParam<Entry> {};

TEST_P(PaperTable2, LargestPressure) {
  const SceneResult result = solve_scene(paper_scene(GetParam().lateral));
  const WheelResult& left = *result.left;
  EXPECT_NEAR(left.pmax, GetParam().pmax, GetParam().tolerance * GetParam().pmax);
  EXPECT_EQ(left.stop_reason, StopReason::tolerance_met);
  EXPECT_EQ(left.patches.at(0).grid.lateral_count, 256u);
  EXPECT_EQ(left.patches.at(0).grid.longitudinal_count, 128u);
}

// y = 1 and y = 5 are sensitive scenes: docs/validation.md reports them with their sensitivity.
INSTANTIATE_TEST_SUITE_P(AllScenes, PaperTable2,
                         testing::Values(Entry{-5.0, 1115.0, calm}, Entry{-3.0, 1010.0, calm},
                                         Entry{-1.0, 852.0, calm}, Entry{1.0, 1165.0, jump},
                                         Entry{3.0, 1470.0, calm}, Entry{5.0, 2150.0, strip}));

} // namespace
} // namespace wrc::test::paper_table2_test
