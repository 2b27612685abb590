#include "mechanics/coupled_influence.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace wrc::test::coupled_influence_test {
namespace {

constexpr double modulus = 1e5;
constexpr double interpolation = 1e-4; // twice the error of the nodes, and sums for integrals

using Fields = std::vector<std::vector<double>>;

/// Two patches of 6 x 4 elements, 8 mm and 3 mm apart in their mean plane.
class CoupledInfluenceTest : public testing::Test {
protected:
  static constexpr std::size_t count = 24;
  const Grid grid{6, 4, 0.2, 0.3, -0.5, -0.45};
  const Fields pressure{std::vector<double>(count, 100.0), std::vector<double>(count, 50.0)};

  [[nodiscard]] Fields displaced(double weight, const Fields& by) const {
    const PatchInteraction interaction{{{0.0, 0.0}, {8.0, 3.0}}, {1.0, weight, weight, 1.0}};
    const SolvedPatch patches[] = {{grid, pressure[0]}, {grid, pressure[1]}};
    CoupledInfluence influence(patches, interaction, modulus);
    Fields displacement(2, std::vector<double>(count, 1.0));
    influence.add(by, displacement);
    return displacement;
  }
};

/// u = F / (pi E* r), added to what is there.
TEST_F(CoupledInfluenceTest, IsBoussinesqsFarFromThePressures) {
  const Fields found = displaced(1.0, pressure);
  double expected = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double across = 8.0 + grid.lateral(2) - grid.lateral(i / 4);
    const double along = 3.0 + grid.longitudinal(1) - grid.longitudinal(i % 4);
    expected += pressure[0][i] * grid.element_area() /
                (std::numbers::pi * modulus * std::hypot(across, along));
  }
  EXPECT_NEAR(found[1][2 * 4 + 1], expected, interpolation * (expected - 1.0));
}

TEST_F(CoupledInfluenceTest, GoesWithTheCouplingWeight) {
  const Fields full = displaced(1.0, pressure);
  const Fields part = displaced(0.25, pressure);
  EXPECT_NEAR(part[0][7] - 1.0, 0.25 * (full[0][7] - 1.0), 1e-12);
  EXPECT_EQ(displaced(0.0, pressure)[0][7], 1.0);
}

TEST_F(CoupledInfluenceTest, IsSymmetric) {
  Fields one(2, std::vector<double>(count, 0.0));
  Fields other = one;
  one[0][5] = 1000.0;
  other[1][18] = 1000.0;
  EXPECT_NEAR(displaced(1.0, one)[1][18], displaced(1.0, other)[0][5], 1e-14);
}

TEST(GridInMeanPlane, IsTheBoxInItsPlane) {
  const Grid box = grid_in_mean_plane({6, 4, 0.2, 0.3, -0.5, -0.45}, {8.0, 3.0}, {1, 3, 2, 3});
  EXPECT_EQ(box.lateral_count, 3u);
  EXPECT_EQ(box.longitudinal_count, 2u);
  EXPECT_NEAR(box.lateral_first, 8.0 - 0.3, 1e-14);
  EXPECT_NEAR(box.longitudinal_first, 3.0 + 0.15, 1e-14);
}

} // namespace
} // namespace wrc::test::coupled_influence_test
