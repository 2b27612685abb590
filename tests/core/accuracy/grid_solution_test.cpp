#include "accuracy/grid_solution.hpp"

#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include "remesh/met_distance.hpp"

namespace wrc::test::grid_solution_test {
namespace {

/// A paraboloid whose vertex, at -0.02, lies between elements.
Patch paraboloid(double row, double column) {
  Patch patch;
  patch.grid = {7, 9, 0.5, 0.5, 0.0, 0.0};
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = 0; j < 9; ++j) {
      const double across = static_cast<double>(i) - row;
      const double along = static_cast<double>(j) - column;
      patch.undeformed_distance.push_back(-0.02 + 1e-3 * across * across + 2e-3 * along * along);
    }
  }
  return patch;
}

TEST(GridSolution, TheOverlapIsThatOfTheVertexBetweenElements) {
  EXPECT_NEAR(paraboloid(3.2, 4.4).overlap(), 0.02, 1e-16);
}

/// Without a neighbour on one side there is no parabola that way.
TEST(GridSolution, AtAnEdgeTheOverlapIsThatOfTheElement) {
  EXPECT_NEAR(paraboloid(-0.3, 4.4).overlap(), 0.02 - 0.09e-3, 1e-16);
}

/// A body that ends within the contact: distances beyond are no part of a parabola.
TEST(GridSolution, BesideTheEndOfABodyTheOverlapIsThatOfTheElement) {
  Patch patch = paraboloid(3.2, 4.4);
  const std::size_t first_beyond = 4 * patch.grid.longitudinal_count;
  std::fill(patch.undeformed_distance.begin() + static_cast<std::ptrdiff_t>(first_beyond),
            patch.undeformed_distance.end(), no_material_distance);
  EXPECT_NEAR(patch.overlap(), 0.02 - 0.04e-3, 1e-16);
}

Patch patch_with(double force, bool shares_plane) {
  Patch patch;
  patch.normal_force = force;
  patch.contact.element_count = force > 0.0 ? 1 : 0;
  patch.contact.peak_pressure = 10.0 * force;
  patch.penetration.shares_plane_with_previous = shares_plane;
  return patch;
}

TEST(GridSolution, PlanesAndPatchesAreSortedByForce) {
  GridSolution solution;
  solution.patches = {patch_with(5.0, false), patch_with(2.0, false), patch_with(0.0, true),
                      patch_with(4.0, true)};
  EXPECT_FALSE(solution.no_contact());
  EXPECT_EQ(solution.peak_pressure(), 50.0);
  const auto touching = solution.patches_by_plane(true);
  ASSERT_EQ(touching.size(), 2u);
  EXPECT_EQ(touching[0].normal_force, 6.0);
  EXPECT_EQ(touching[0].patches, (std::vector<std::size_t>{3, 1}));
  EXPECT_EQ(touching[1].patches, (std::vector<std::size_t>{0}));
  EXPECT_EQ(solution.patches_by_plane(false)[0].patches, (std::vector<std::size_t>{3, 1, 2}));
}

} // namespace
} // namespace wrc::test::grid_solution_test
