/// Unlike bodies: what pressures and tractions change in each other, against values of CONTACT and
/// identities.
#include "rolling/unlike_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "half_space/material.hpp"
#include "half_space/traction_convolution.hpp"
#include "support/patch_problem.hpp"

namespace wrc::test::unlike_bodies_test {
namespace {

constexpr double radius = 4.0;
constexpr double load = 30000.0;
constexpr double friction = 0.3;
const Material aluminium{2.0 * (1.0 + 0.33) * 27000.0, 0.33};
const Material steel{2.0 * (1.0 + 0.28) * 82000.0, 0.28};

/// Spheres whose contact is a circle of this radius, with `count` elements over it and two more on
/// each side, and the pressures without tractions.
struct Spheres {
  Spheres(const Material& wheel, const Material& rail, std::size_t count)
      : modulus(combined_modulus(wheel, rail)) {
    const std::size_t all = count + 4;
    const double step = 2.0 * radius / static_cast<double>(count);
    const double first = -0.5 * static_cast<double>(all - 1) * step;
    problem.grid = {all, all, step, step, first, first};
    const double curvature = 0.75 * load / (modulus * radius * radius * radius);
    for (std::size_t j = 0; j < all; ++j) {
      for (std::size_t i = 0; i < all; ++i) {
        const double x = problem.grid.longitudinal(i);
        const double y = problem.grid.lateral(j);
        distance.push_back(0.5 * curvature * (x * x + y * y));
      }
    }
    PatchProblem normal(problem.grid, distance, modulus);
    normal.load = load;
    normal.elements = Elements::smooth;
    pressure = PatchSolution(NormalSolver().solve(normal)).pressure;
    problem.pressure = pressure;
    const ShearConstants shear = shear_constants(wheel, rail);
    problem.shear_modulus = shear.modulus;
    problem.poisson = shear.poisson;
    problem.difference_parameter = shear.difference_parameter;
    problem.friction = friction;
    problem.tolerance = 1e-4;
  }

  UnlikeSolution solve(const Creepages& creepages) {
    problem.creepages = creepages;
    return solve_unlike(problem, distance, modulus, 1e-4, solver);
  }

  double modulus;
  std::vector<double> distance;
  std::vector<double> pressure;
  RollingProblem problem;
  RollingSolver solver;
};

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Midpoint rule on 200 x 200 pieces of the element.
TEST(CrossTable, IsTheIntegralOverTheElement) {
  constexpr double aspect = 0.7;
  const CrossTable table = cross_table(aspect, 4, 4);
  for (const auto& [column, row] :
       std::vector<std::pair<std::size_t, std::size_t>>{{1, 0}, {0, 1}, {3, 2}, {1, 3}}) {
    const auto i = static_cast<double>(column);
    const auto j = static_cast<double>(row);
    double x_sum = 0.0;
    double y_sum = 0.0;
    constexpr int pieces = 200;
    for (int k = 0; k < pieces * pieces; ++k) {
      const double x = i - ((k % pieces + 0.5) / pieces - 0.5);
      const double y = aspect * (j - ((k / pieces + 0.5) / pieces - 0.5));
      const double weight = aspect / (pieces * pieces) / (x * x + y * y);
      x_sum += weight * x;
      y_sum += weight * y;
    }
    EXPECT_NEAR(table.longitudinal(row)[column], x_sum, 2e-5);
    EXPECT_NEAR(table.lateral(row)[column], y_sum, 2e-5);
  }
  EXPECT_EQ(table.longitudinal(2)[0], 0.0);
  EXPECT_EQ(table.lateral(0)[2], 0.0);
}

// CONTACT (Vollebregt, open source, 2024), extrapolated from 32 and 64 elements by the first order;
// its own error is 8e-4 to 2e-3 of mu N. Its largest pressures on 64 elements are 901.65, 893.85
// and 898.76 MPa, against 895 without tractions.
TEST(UnlikeBodies, AluminiumOnSteelGivesWhatContactGives) {
  struct Case {
    Creepages creepages;
    double x, y, moment, largest;
  };
  Spheres spheres(aluminium, steel, 64);
  const double scale = friction * load;
  for (const Case& c :
       {Case{{0.0, 0.0, 0.0}, -0.228475, 0.0, 0.0, 901.65},
        Case{{-0.0032201140568013944, 0.0, 0.0}, 0.614423, 0.0, 0.0, 893.85},
        Case{{-0.0012880456227205579, -0.0014854664338383925, -0.0009229147422610221},
             0.129251,
             0.658947,
             0.147112,
             898.76}}) {
    const UnlikeSolution both = spheres.solve(c.creepages);
    EXPECT_TRUE(both.converged);
    EXPECT_NEAR(both.rolling.longitudinal_force / scale, c.x, 5e-3);
    EXPECT_NEAR(both.rolling.lateral_force / scale, c.y, 5e-3);
    EXPECT_NEAR(both.rolling.spin_moment / (scale * radius), c.moment, 5e-3);
    EXPECT_NEAR(*std::max_element(both.pressure.begin(), both.pressure.end()), c.largest, 0.3);
    EXPECT_NEAR(sum_of(both.pressure), sum_of(spheres.pressure), 1e-9 * sum_of(spheres.pressure));
    EXPECT_GT(both.pressure_change, 5e-3);
    EXPECT_LT(both.pressure_change, 3e-2);
  }
}

TEST(UnlikeBodies, TheAnswerSolvesTheTangentialProblem) {
  Spheres spheres(aluminium, steel, 16);
  const UnlikeSolution both = spheres.solve({-0.001, 0.0005, 0.0002});
  RollingProblem problem = spheres.problem;
  problem.pressure = both.pressure;
  LinePlans plans;
  const TangentialResiduals residuals =
      compute_residuals(problem, both.rolling.traction_x, both.rolling.traction_y, plans);
  EXPECT_LT(residuals.natural, 3e-4);
  EXPECT_LT(residuals.complementarity, 1e-3);
}

// What slip times traction shows on the elements falls short of the power by the first order.
TEST(UnlikeBodies, PowerIsThatOfSlipAndTraction) {
  const Creepages creepages{-0.001, 0.0005, 0.0002};
  const double coarse = Spheres(aluminium, steel, 16).solve(creepages).rolling.numerical_loss;
  const double fine = Spheres(aluminium, steel, 64).solve(creepages).rolling.numerical_loss;
  EXPECT_GT(fine, 0.0);
  EXPECT_LT(fine, 0.35 * coarse);
}

TEST(UnlikeBodies, ExchangedBodiesPullTheOtherWay) {
  const UnlikeSolution one = Spheres(aluminium, steel, 16).solve({});
  const UnlikeSolution other = Spheres(steel, aluminium, 16).solve({});
  const double scale = friction * load;
  EXPECT_LT(one.rolling.longitudinal_force, -0.2 * scale);
  EXPECT_NEAR(one.rolling.longitudinal_force, -other.rolling.longitudinal_force, 1e-6 * scale);
  for (std::size_t i = 0; i < one.pressure.size(); ++i) {
    EXPECT_NEAR(one.pressure[i], other.pressure[i], 1e-3);
  }
}

TEST(UnlikeBodies, LikeBodiesCostNothingMore) {
  Spheres spheres(steel, steel, 16);
  const UnlikeSolution both = spheres.solve({-0.001, 0.0, 0.0});
  const RollingSolution plain = RollingSolver().solve(spheres.problem);
  EXPECT_EQ(both.alternations, 0);
  EXPECT_EQ(both.pressure, spheres.pressure);
  EXPECT_EQ(both.rolling.traction_x, plain.traction_x);
  EXPECT_TRUE(both.rolling.normal_displacement.empty());
}

TEST(UnlikeBodies, TheLargestDifferenceAndFrictionConverge) {
  Spheres spheres(Material{1000.0, 0.0}, Material{1e9, 0.5}, 16);
  EXPECT_NEAR(spheres.problem.difference_parameter, 0.5, 1e-6);
  spheres.problem.friction = 1.0;
  for (const double creepage : {0.0, 0.1, 10.0}) {
    const UnlikeSolution both = spheres.solve({creepage, 0.0, 0.0});
    EXPECT_TRUE(both.converged) << creepage;
    EXPECT_LT(both.alternations, 12);
  }
}

TEST(UnlikeBodies, OnlySteadyRollingIsSupported) {
  Spheres spheres(aluminium, steel, 8);
  for (const TangentialMotion motion : {TangentialMotion::transient, TangentialMotion::shift}) {
    spheres.problem.motion = motion;
    EXPECT_THROW((void)RollingSolver().solve(spheres.problem), Error);
  }
  spheres.problem.motion = TangentialMotion::rolling;
  spheres.problem.difference_parameter = 0.6;
  EXPECT_THROW((void)RollingSolver().solve(spheres.problem), Error);
}

} // namespace
} // namespace wrc::test::unlike_bodies_test
