/// Tractions and pressures along a curve: against sums element by element, reciprocity, CONTACT.
#include "rolling/curve_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "half_space/material.hpp"
#include "half_space/traction_convolution.hpp"
#include "mechanics/normal_solver.hpp"
#include "rolling/rolling_contact.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::curve_displacement_test {
namespace {

constexpr double poisson = 0.28;
constexpr DifferenceWeights of_displacements{0.0, 1.0, 0.0, 0.0};

std::vector<double> drawn(std::size_t count, double least, std::mt19937& draw) {
  std::uniform_real_distribution<double> from(least, 1.0);
  std::vector<double> values(count);
  std::ranges::generate(values, [&] { return from(draw); });
  return values;
}

/// What tractions open of the gap, summed element by element, mm.
std::vector<double> opened_by_tractions(const RollingProblem& problem,
                                        const std::vector<double>& traction_x,
                                        const std::vector<double>& traction_y) {
  const Grid& grid = problem.grid;
  const std::size_t rows = grid.longitudinal_count;
  const TractionTable table =
      traction_table(grid.lateral_step / grid.longitudinal_step, grid.lateral_count, rows);
  const double nu = problem.poisson;
  std::vector<double> opened(grid.element_count());
  const auto apart = [](std::size_t one, std::size_t other) {
    return one > other ? one - other : other - one;
  };
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    for (std::size_t j = 0; j < grid.lateral_count; ++j) {
      const double whole = std::sin(problem.angles[i] - problem.angles[j]);
      const double half = std::sin(0.5 * (problem.angles[i] - problem.angles[j]));
      const std::size_t across = apart(i, j);
      for (std::size_t k = 0; k < rows * rows; ++k) {
        const std::size_t to = k / rows;
        const std::size_t from = k % rows;
        const std::size_t along = apart(to, from);
        const double mean = (1.0 - nu) * table.longitudinal(across)[along] +
                            (1.0 - 0.5 * nu) * table.lateral(across)[along];
        const double sign = (to > from) == (i > j) ? 1.0 : -1.0;
        const double mixed = sign * nu * table.mixed(across)[along];
        opened[i * rows + to] -=
            whole * mean * traction_y[j * rows + from] + half * mixed * traction_x[j * rows + from];
      }
    }
  }
  for (double& value : opened) {
    value *= grid.longitudinal_step / (std::numbers::pi * problem.shear_modulus);
  }
  return opened;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

struct Curve {
  TractionShape shape{6, 9};
  std::vector<double> angles;
  TractionTable table = traction_table(1.3, shape.table_rows(), shape.table_columns());
  LinePlans plans;
  ConvolutionWorkspace<double> workspace;

  explicit Curve(double turn) {
    for (std::size_t j = 0; j < shape.columns; ++j) {
      angles.push_back(turn * (static_cast<double>(j) / 8.0 - 0.4) + 0.02 * std::sin(double(j)));
    }
  }
  [[nodiscard]] std::size_t count() const { return shape.rows * shape.columns; }
  TractionConvolution<double> convolution(std::span<const double> along, double nu = poisson) {
    return {shape, shape.columns, nu, of_displacements, table, plans, along};
  }
  /// The displacements (x, y) of one element by another with unit tractions.
  std::vector<double> of_element(const TractionConvolution<double>& by, std::size_t element,
                                 std::size_t component) {
    std::vector<double> in(2 * count());
    in[component * count() + element] = 1.0;
    by.apply(in.data(), in.data() + count(), in.data(), in.data() + count(), workspace);
    return in;
  }
};

/// m and A_ss from planes of two Poisson's ratios: A_ss = a + b - nu a with m = a + b - nu (a +
/// b/2), a and b from nu = 0 and 1.
TEST(CurveDisplacement, LateralTractionsActAlongTheirRows) {
  Curve curve(1.1);
  const TractionConvolution<double> plane = curve.convolution({});
  const TractionConvolution<double> round = curve.convolution(curve.angles);
  const TractionConvolution<double> stiff = curve.convolution({}, 0.0);
  const TractionConvolution<double> soft = curve.convolution({}, 1.0);
  for (const std::size_t j : {0u, 13u, 31u}) {
    for (const std::size_t component : {0u, 1u}) {
      const std::vector<double> expected = curve.of_element(plane, j, component);
      const std::vector<double> found = curve.of_element(round, j, component);
      const std::vector<double> whole = curve.of_element(stiff, j, 1); // a + b
      const std::vector<double> across = curve.of_element(soft, j, 1); // b
      for (std::size_t i = 0; i < curve.count(); ++i) {
        const std::size_t y = curve.count() + i;
        EXPECT_NEAR(found[i], expected[i], 1e-13);
        const double cosine = std::cos(curve.angles[i % 9] - curve.angles[j % 9]);
        const double mean = whole[y] - poisson * (whole[y] - 0.5 * across[y]);
        const double lost = component == 1 ? (1.0 - cosine) * mean : 0.0;
        EXPECT_NEAR(found[y], expected[y] - lost, 1e-13) << i << " by " << j;
      }
    }
  }
  const auto self = round.self_influence();
  EXPECT_NEAR(self[1], plane.self_influence()[1], 1e-14);
}

TEST(CurveDisplacement, RowsOfOneAngleAreAPlaneToTheBit) {
  Curve curve(0.0);
  const std::vector<double> tilted(curve.shape.columns, 0.3);
  for (const std::size_t component : {0u, 1u}) {
    EXPECT_EQ(curve.of_element(curve.convolution(tilted), 20, component),
              curve.of_element(curve.convolution({}), 20, component));
  }
}

struct Problem {
  Grid grid{7, 5, 0.4, 0.5, -1.4, -1.0};
  std::vector<double> angles{-0.4, -0.25, -0.1, 0.0, 0.12, 0.2, 0.5};
  std::vector<double> pressure;
  RollingProblem rolling;

  Problem() {
    std::mt19937 draw(56);
    pressure = drawn(grid.element_count(), 0.0, draw);
    rolling.grid = grid;
    rolling.pressure = pressure;
    rolling.angles = angles;
    rolling.shear_modulus = 82000.0;
    rolling.poisson = poisson;
  }
};

/// The work of tractions in the slip by pressures is that of pressures in what is opened by the
/// differences of these tractions.
TEST(CurveDisplacement, WorkIsReciprocal) {
  Problem problem;
  problem.rolling.difference = SlipDifference::first_order; // u(x) - u(x + h)
  std::mt19937 draw(57);
  const Grid& grid = problem.grid;
  const std::size_t count = grid.element_count();
  std::vector<double> x = drawn(count, -1.0, draw);
  std::vector<double> y = drawn(count, -1.0, draw);
  for (std::size_t at = grid.longitudinal_count - 1; at < count; at += grid.longitudinal_count) {
    x[at] = y[at] = 0.0; // there the difference would leave the grid
  }
  std::vector<double> rise_x(x);
  std::vector<double> rise_y(y);
  for (std::size_t at = 0; at < count; ++at) {
    if (at % grid.longitudinal_count != 0) {
      rise_x[at] -= x[at - 1];
      rise_y[at] -= y[at - 1];
    }
  }
  LinePlans plans;
  const std::vector<double> opened = opened_by_tractions(problem.rolling, rise_x, rise_y);
  const SlipByPressures slip = slip_by_pressures(problem.rolling, problem.rolling.angles, plans);
  const double along = grid.longitudinal_step * product(x, slip.x);
  const double work = along + grid.longitudinal_step * product(y, slip.y);
  EXPECT_GT(std::abs(along), 1e-2 * std::abs(work));
  EXPECT_NEAR(product(problem.pressure, opened), work, 1e-11 * std::abs(work));
}

TEST(CurveDisplacement, OfAPlaneIsNone) {
  Problem problem;
  LinePlans plans;
  EXPECT_TRUE(slip_by_pressures(problem.rolling, {}, plans).y.empty());
  const std::vector<double> level(problem.angles.size());
  EXPECT_TRUE(slip_by_pressures(problem.rolling, level, plans).y.empty());
}

/// Pressures of a semi-ellipsoid on rows that turn: between means of two by two elements the slip
/// is that of all elements to 3 %; moved by half an element it is not.
TEST(CurveDisplacement, MeansOfFourElementsGiveASmoothSlip) {
  RollingProblem problem;
  problem.grid = {32, 28, 0.5, 0.4, -7.75, -5.4};
  problem.shear_modulus = 82000.0;
  problem.poisson = poisson;
  std::vector<double> pressure;
  std::vector<double> angles;
  for (std::size_t i = 0; i < problem.grid.lateral_count; ++i) {
    const double y = problem.grid.lateral(i) / 8.0;
    angles.push_back(0.02 * y + 0.01 * y * y);
    for (std::size_t j = 0; j < problem.grid.longitudinal_count; ++j) {
      const double x = problem.grid.longitudinal(j) / 5.6;
      pressure.push_back(1000.0 * std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
  }
  problem.pressure = pressure;
  LinePlans plans;
  const SlipByPressures exact = slip_by_pressures(problem, angles, plans);
  const SlipByPressures smooth = smooth_slip_by_pressures(problem, angles, plans);
  const auto difference = [&](const std::vector<double>& of_all,
                              const std::vector<double>& of_means) {
    double squares = 0.0;
    double missed = 0.0;
    for (std::size_t at = 0; at < of_all.size(); ++at) {
      if (pressure[at] > 0.0) {
        squares += of_all[at] * of_all[at];
        missed += (of_means[at] - of_all[at]) * (of_means[at] - of_all[at]);
      }
    }
    return std::sqrt(missed / squares);
  };
  EXPECT_LT(difference(exact.x, smooth.x), 0.03);
  EXPECT_LT(difference(exact.y, smooth.y), 0.03);
  EXPECT_TRUE(smooth_slip_by_pressures(problem, {}, plans).x.empty());
}

TEST(CurveDisplacement, IsThatOfRollingAtAnyStepAndNoneOfAShift) {
  Problem problem;
  LinePlans plans;
  const SlipByPressures steady = slip_by_pressures(problem.rolling, problem.rolling.angles, plans);
  problem.rolling.step_length = 0.3;
  problem.rolling.rolling_share = 0.25;
  const SlipByPressures step = slip_by_pressures(problem.rolling, problem.rolling.angles, plans);
  EXPECT_EQ(step.x, steady.x);
  EXPECT_EQ(step.y, steady.y);
  problem.rolling.motion = TangentialMotion::shift;
  EXPECT_TRUE(slip_by_pressures(problem.rolling, problem.rolling.angles, plans).y.empty());
}

TEST(CurveDisplacement, AnglesThatDoNotFitAreRefused) {
  Problem problem;
  problem.angles.pop_back();
  problem.rolling.angles = problem.angles;
  EXPECT_THROW(RollingSolver().solve(problem.rolling), Error);
  problem.angles.push_back(std::nan(""));
  problem.rolling.angles = problem.angles;
  EXPECT_THROW(RollingSolver().solve(problem.rolling), Error);
}

/// Forces that CONTACT has, with its elements and its difference, normal and tangential contact in
/// turn.
struct ConformalContact {
  nlohmann::json reference = reference_data("conformal_contact.json").at("conformal");
  Grid grid{39, 51, 0.4, 0.4, -7.6, -10.0};
  std::vector<double> distance;
  std::vector<double> angles;
  std::vector<double> slip_x; ///< of the table
  std::vector<double> slip_y;
  Material steel{2.0 * 82000.0 * (1.0 + poisson), poisson};
  double normal_force = 0.0;
  double pmax = 0.0;
  RollingSolution rolling;

  ConformalContact() {
    for (const auto& row : reference.at("rows")) {
      angles.push_back(-row[0].get<double>() / 10.0);
      for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
        const double x = grid.longitudinal(column);
        distance.push_back(row[1].get<double>() + row[2].get<double>() * x * x);
        slip_x.push_back(row[3].get<double>());
        slip_y.push_back(row[4].get<double>() + row[5].get<double>() * x);
      }
    }
  }

  void solve(bool varying, bool turned) {
    LinePlans plans;
    std::vector<double> gap = distance;
    const int rounds = turned ? 4 : 1;
    for (int round = 0; round < rounds; ++round) {
      PatchGap patch{grid, gap};
      if (turned) {
        patch.angles = angles;
      }
      NormalProblem normal;
      normal.patches = {&patch, 1};
      normal.combined_modulus = combined_modulus(steel, steel);
      normal.approach = 0.0;
      const NormalSolution found = NormalSolver().solve(normal);
      const std::vector<double>& pressure = found.patches[0].pressure;
      normal_force = found.patches[0].normal_force;
      pmax = *std::ranges::max_element(pressure);
      RollingProblem problem;
      problem.grid = grid;
      problem.pressure = pressure;
      problem.angles = patch.angles;
      problem.shear_modulus = 82000.0;
      problem.poisson = poisson;
      problem.difference = SlipDifference::first_order;
      problem.tolerance = 1e-5;
      SlipByPressures slip = slip_by_pressures(problem, problem.angles, plans);
      slip.x.resize(grid.element_count());
      slip.y.resize(grid.element_count());
      if (varying) {
        std::transform(slip_x.begin(), slip_x.end(), slip.x.begin(), slip.x.begin(), std::plus<>());
        std::transform(slip_y.begin(), slip_y.end(), slip.y.begin(), slip.y.begin(), std::plus<>());
      } else {
        problem.creepages = {-0.004, -0.0098995, -0.0015372};
      }
      problem.slip_x = slip.x;
      problem.slip_y = slip.y;
      rolling = RollingSolver().solve(problem);
      if (turned) {
        gap = opened_by_tractions(problem, rolling.traction_x, rolling.traction_y);
        std::transform(gap.begin(), gap.end(), distance.begin(), gap.begin(), std::plus<>());
      }
    }
  }

  /// Tolerances of the normal force, of forces over the friction force, and of the moment.
  void compare(const char* name, double of_normal, double of_forces, double of_moment) const {
    const auto& expected = reference.at("creep").at(name);
    const double theirs = expected.at("Fn_N");
    EXPECT_NEAR(normal_force, theirs, of_normal * theirs) << name;
    EXPECT_NEAR(pmax, expected.at("pmax_MPa"), of_normal * pmax) << name;
    EXPECT_NEAR(rolling.longitudinal_force / normal_force,
                expected.at("Fx_N").get<double>() / theirs, 0.3 * of_forces)
        << name;
    EXPECT_NEAR(rolling.lateral_force / normal_force, expected.at("Fs_N").get<double>() / theirs,
                0.3 * of_forces)
        << name;
    const double moment = expected.at("Mn_Nmm").get<double>() / theirs;
    EXPECT_NEAR(rolling.spin_moment / normal_force, moment, of_moment * moment) << name;
  }
};

TEST(CurveDisplacement, AlongArcsForcesAreThoseOfContact) {
  ConformalContact contact;
  contact.solve(false, false);
  contact.compare("constant_half_space", 1e-6, 1e-4, 1e-4);
  contact.solve(true, false);
  contact.compare("varying_half_space", 1e-6, 1e-4, 1e-4);
}

/// CONTACT's normal force is 0.8 % larger: it leaves (A_ss - A_nn)/2 as in a plane in the influence
/// of pressures, too, where ours has cos(a_i - a_j) A_nn. Along arcs alone (the test before) Fx is
/// 0.03 of the friction force less.
TEST(CurveDisplacement, WithTurnedNormalsForcesAreThoseOfContact) {
  ConformalContact contact;
  contact.solve(false, true);
  contact.compare("constant_v4", 1e-2, 2e-3, 1.5e-2);
  contact.solve(true, true);
  contact.compare("varying_v4", 1e-2, 2e-3, 1.5e-2);
}

} // namespace
} // namespace wrc::test::curve_displacement_test
