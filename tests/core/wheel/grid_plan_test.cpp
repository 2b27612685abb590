#include "wheel/grid_plan.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "accuracy/constants.hpp"
#include "support/simple_profiles.hpp"
#include "wheel/constants.hpp"

namespace wrc::test::grid_plan_test {
namespace {

/// Wheel and rail at their first touch.
struct Touching {
  Touching(const Profile& wheel_profile, double at)
      : wheel(wheel_profile, {1360.0, 70.0, 460.0}),
        rail(circular_rail(300.0), {1435.0, 14.0, 0.0}) {
    EquilibriumRequest request;
    request.lateral = at;
    request.roll = 0.0;
    request.right = false;
    side = *find_equilibrium({wheel, rail}, {wheel, rail}, request).left;
  }
  WheelSurface wheel;
  RailSurface rail;
  SideEquilibrium side;
};

GridSolution plan_grids(const Touching& pair, const WheelRequest& request, double depth,
                        const GridChoice& grids) {
  GridSolution plan = plan_patches(pair.rail, pair.side, request, depth);
  set_grids(plan, pair.rail, grids, 1e9);
  return plan;
}

/// Where they overlap by d: half of it sqrt(2 R d) each way, and 5 % of the whole on each side.
TEST(GridPlan, SpansThePenetrationWithASmallMargin) {
  const Touching pair(cylindrical_wheel(), 0.0);
  constexpr double depth = 0.05;
  const GridSolution plan = plan_grids(pair, {}, depth, GridChoice(ElementCounts{40, 18}));
  ASSERT_EQ(plan.patches.size(), 1u);
  const Grid& grid = plan.patches[0].grid;
  EXPECT_EQ(plan.depth, depth);
  EXPECT_EQ(grid.lateral_count, 40u);
  EXPECT_EQ(grid.longitudinal_count, 18u);
  const double width = 1.1 * 2.0 * std::sqrt(2.0 * 300.0 * depth);
  const double length = 1.1 * 2.0 * std::sqrt(2.0 * 460.0 * depth);
  EXPECT_NEAR(40.0 * grid.lateral_step, width, 5e-3 * width);
  EXPECT_NEAR(18.0 * grid.longitudinal_step, length, 5e-3 * length);
  EXPECT_NEAR(grid.lateral_first + 19.5 * grid.lateral_step, 0.0, 5e-3 * width);
  EXPECT_FALSE(plan.interaction);
}

/// Those of the nearest patch, whatever the number of patches.
TEST(GridPlan, ElementsAreThoseOfTheNearestPatch) {
  const Touching corner(wheel_with_flank(), -1.35);
  const GridSolution counted = plan_grids(corner, {}, 0.12, GridChoice(ElementCounts{20, 10}));
  ASSERT_EQ(counted.patches.size(), 2u);
  const double y = counted.patches[0].penetration.mean_y;
  const GridSolution chosen =
      plan_grids(corner, {}, 0.12,
                 GridChoice({{0.0, y + 100.0, 0.5, 0.9},
                             {0.0, y + 1.0, 0.02, 0.07, 0.3},
                             {0.0, y - 50.0, 0.3, 0.3},
                             {46.0, y, 0.4, 0.4}})); // at the other end of a flat
  const Grid& before = counted.patches[0].grid;
  const Grid& grid = chosen.patches[0].grid;
  EXPECT_EQ(grid.lateral_step, 0.02);
  EXPECT_EQ(grid.longitudinal_step, 0.07);
  const double middle = before.lateral_first + (0.3 * 20.0 - 0.5) * before.lateral_step;
  const double elements = (middle - grid.lateral_first) / grid.lateral_step - 0.5;
  EXPECT_NEAR(elements, std::round(elements), 1e-9);
}

/// Crown and a flank of 60 degrees, which touches 0.06 mm later; planes are the rail's.
TEST(GridPlan, EachPatchHasItsPlane) {
  const Touching corner(wheel_with_flank(), -1.35);
  const GridSolution plan = plan_grids(corner, {}, 0.12, GridChoice(ElementCounts{20, 10}));
  ASSERT_EQ(plan.patches.size(), 2u);
  EXPECT_EQ(plan.main, 1u);
  EXPECT_LT(plan.patches[0].frame.normal.z, 0.995);
  EXPECT_GT(plan.patches[1].frame.normal.z, 0.995);
}

/// In proportion to the cosine between their planes; as CONTACT couples them, these do not.
TEST(GridPlan, AllPatchesInteractUnlessNearOnesShall) {
  const Touching corner(wheel_with_flank(), -1.35);
  WheelRequest request;
  const GridSolution plan = plan_grids(corner, request, 0.12, GridChoice(ElementCounts{20, 10}));
  ASSERT_TRUE(plan.interaction);
  const double cosine = dot(plan.patches[0].frame.normal, plan.patches[1].frame.normal);
  EXPECT_LT(cosine, 0.999);
  EXPECT_NEAR(plan.patches[0].coupling_weight, cosine, 1e-12);
  request.interaction = Interaction::near;
  EXPECT_FALSE(plan_grids(corner, request, 0.12, GridChoice(ElementCounts{20, 10})).interaction);
  const Vector3 apart = plan.patches[1].frame.origin - plan.patches[0].frame.origin;
  EXPECT_NEAR(plan.interaction->places[1].lateral, std::hypot(apart.y, apart.z), 1e-12);
}

TEST(GridPlan, TheVerticalConventionHasOnePlaneAndReportsOmittedPatches) {
  const Touching corner(wheel_with_flank(), -1.35);
  WheelRequest request;
  request.gap = GapConvention::vertical;
  const GridSolution plan = plan_grids(corner, request, 0.12, GridChoice(ElementCounts{20, 10}));
  ASSERT_EQ(plan.patches.size(), 1u);
  EXPECT_EQ(plan.patches[0].frame.normal.z, 1.0);
  ASSERT_TRUE(plan.left_out_s);
  EXPECT_NEAR(*plan.left_out_s, -30.0, 5.0);
}

/// A limit of elements that is raised permits as many iterations on them as the default one does.
TEST(GridPlan, IterationsStayAffordableUnderAnyLimit) {
  const int by_default = affordable_iterations(default_element_limit, default_element_limit);
  EXPECT_EQ(by_default, 500);
  const double raised = 67108864.0;
  EXPECT_EQ(affordable_iterations(raised, raised), by_default);
  EXPECT_EQ(affordable_iterations(default_element_limit, 1000.0), by_default);
  EXPECT_EQ(affordable_iterations(raised, 1000.0), 1);
  EXPECT_EQ(affordable_iterations(0.0, raised), static_cast<int>(most_work));
}

} // namespace
} // namespace wrc::test::grid_plan_test
