/// Contact of bodies that yield: its conditions by dense matrices, closed-form limits, and that it
/// does not depend on where it starts.
#include "mechanics/yielding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "half_space/constants.hpp"
#include "half_space/displacement_operator.hpp"
#include "mechanics/normal_solver.hpp"
#include "pressure/contact_area.hpp"
#include "pressure/pressure_field.hpp"
#include "support/contact_cases.hpp"

namespace wrc::test::yielding_test {
namespace {

constexpr double load = 8e4;
/// Of pressures: the tolerance of the solutions.
constexpr double tolerance = 1e-7;

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

struct Contact {
  Grid grid;
  std::vector<double> distance;
  std::vector<double> angles{};
  std::vector<double> row_scales{};
  std::vector<YieldingBody> bodies{};
  std::vector<double> carried{};
  PatchGap gap{};
  NormalProblem problem{};

  void make(std::optional<double> at_approach = std::nullopt) {
    gap = {grid, distance};
    gap.angles = angles;
    gap.row_scales = row_scales;
    gap.carried = carried;
    problem.patches = {&gap, 1};
    problem.combined_modulus = steel_modulus;
    problem.tolerance = tolerance;
    problem.elements = Elements::smooth;
    problem.yielding = bodies;
    if (at_approach) {
      problem.approach = at_approach;
    } else {
      problem.load = load;
    }
  }
};

/// The paraboloid of curvatures 1/400 and 1/300 mm, which carries 1090 MPa at 80 kN.
Contact paraboloid(std::size_t rows, std::size_t columns) {
  Contact contact;
  contact.grid = centred_grid(rows, columns, 20.0 / static_cast<double>(rows),
                              20.0 / static_cast<double>(columns));
  contact.distance = hertz_gap(contact.grid, 1.0 / 400.0, 1.0 / 300.0);
  return contact;
}

/// A times each unit pressure.
std::vector<std::vector<double>> dense_influence(const Contact& contact) {
  DisplacementOperator displace(contact.grid, steel_modulus, Elements::smooth, contact.angles);
  std::vector<std::vector<double>> columns;
  for (std::size_t i = 0; i < contact.grid.element_count(); ++i) {
    std::vector<double> unit(contact.grid.element_count(), 0.0);
    unit[i] = 1.0;
    displace.apply(unit, columns.emplace_back(unit.size()));
  }
  return columns;
}

/// h + A p + sum_b c_b P_b' A P_b - s delta, from the dense matrix and the law as it is written.
std::vector<double> dense_gap(const Contact& contact, const NormalSolution& solution) {
  const auto influence = dense_influence(contact);
  const std::vector<double>& pressure = solution.patches[0].pressure;
  const auto displaced = [&](const std::vector<double>& by) {
    std::vector<double> result(by.size(), 0.0);
    for (std::size_t i = 0; i < by.size(); ++i) {
      for (std::size_t j = 0; j < by.size(); ++j) {
        result[j] += influence[i][j] * by[i];
      }
    }
    return result;
  };
  std::vector<double> gap = displaced(pressure);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    gap[i] += contact.distance[i] - solution.approach;
  }
  for (const YieldingBody& body : contact.bodies) {
    std::vector<double> excess(pressure.size());
    std::vector<double> slope(pressure.size());
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      const double scale = contact.row_scales.empty()
                               ? 1.0
                               : contact.row_scales[i / contact.grid.longitudinal_count];
      const double beyond = std::max(scale * pressure[i] / body.stress - yield_onset, 0.0);
      excess[i] = body.stress * std::pow(beyond, yield_exponent) / scale;
      slope[i] = yield_exponent * std::pow(beyond, yield_exponent - 1.0);
    }
    const std::vector<double> by_excess = displaced(excess);
    for (std::size_t i = 0; i < gap.size(); ++i) {
      gap[i] += yield_stiffness * body.share * slope[i] * by_excess[i];
    }
  }
  return gap;
}

void expect_conditions(const Contact& contact, const NormalSolution& solution) {
  ASSERT_EQ(solution.stop_reason, StopReason::tolerance_met);
  const std::vector<double>& pressure = solution.patches[0].pressure;
  const double sum = std::accumulate(pressure.begin(), pressure.end(), 0.0);
  EXPECT_NEAR(sum * contact.grid.element_area(), load, 1e-9 * load);
  const std::vector<double> gap = dense_gap(contact, solution);
  const double scale = solution.approach;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    EXPECT_GE(pressure[i], 0.0);
    EXPECT_GE(gap[i], -1e-6 * scale) << i;
    if (pressure[i] > 0.0) {
      EXPECT_LE(gap[i], 1e-6 * scale) << i;
    }
  }
}

TEST(Yielding, MeetsTheConditionsOfContactByDenseMatrices) {
  Contact contact = paraboloid(18, 14);
  contact.bodies = {{300.0, 0.4}, {550.0, 0.6}};
  contact.make();
  expect_conditions(contact, NormalSolver().solve_yielding(contact.problem));
}

TEST(Yielding, MeetsThemAlongACurveWithScaledRows) {
  Contact contact = paraboloid(16, 14);
  for (std::size_t row = 0; row < 16; ++row) {
    contact.angles.push_back(0.05 * static_cast<double>(row));
    contact.row_scales.push_back(1.0 - 0.01 * static_cast<double>(row));
  }
  contact.bodies = {{350.0, 1.0}};
  contact.make();
  expect_conditions(contact, NormalSolver().solve_yielding(contact.problem));
}

/// Of 16 contacts the largest error against finite elements is 10 %; this is the law itself, as its
/// trial had it on other grids and with a dense solver.
TEST(Yielding, OfAParaboloidGivesTheTrialsPressures) {
  constexpr std::array pairs{std::pair(1.6, 1.60), std::pair(2.0, 1.93), std::pair(2.5, 2.16),
                             std::pair(3.0, 2.31), std::pair(4.0, 2.50), std::pair(5.0, 2.65),
                             std::pair(6.0, 2.76), std::pair(8.0, 2.95)};
  Contact contact = paraboloid(40, 40);
  contact.make();
  const double elastic =
      peak_pressure(contact.grid, NormalSolver().solve(contact.problem).patches[0].pressure);
  for (const auto& [before, after] : pairs) {
    contact.bodies = {{elastic / before, 1.0}};
    contact.make();
    const NormalSolution solution = NormalSolver().solve_yielding(contact.problem);
    EXPECT_NEAR(peak_pressure(contact.grid, solution.patches[0].pressure), after * elastic / before,
                0.01 * after * elastic / before)
        << before;
  }
}

TEST(Yielding, DoesNotDependOnItsStart) {
  Contact contact = paraboloid(24, 20);
  contact.bodies = {{250.0, 0.5}, {400.0, 0.5}};
  contact.make();
  const NormalSolution first = NormalSolver().solve_yielding(contact.problem);
  const std::size_t count = contact.grid.element_count();
  std::vector<double> everywhere(count, 1.0);
  std::vector<double> corner(count, 0.0);
  corner[0] = 1.0;
  for (const std::vector<double>* start : {&everywhere, &corner}) {
    contact.gap.start = *start;
    const NormalSolution other = NormalSolver().solve_yielding(contact.problem);
    EXPECT_EQ(other.stop_reason, StopReason::tolerance_met);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(other.patches[0].pressure[i], first.patches[0].pressure[i],
                  10.0 * tolerance * largest(first.patches[0].pressure));
    }
    EXPECT_NEAR(other.approach, first.approach, 10.0 * tolerance * first.approach);
  }
}

TEST(Yielding, IsElasticBelowTheOnset) {
  Contact contact = paraboloid(30, 30);
  contact.make();
  const NormalSolution elastic = NormalSolver().solve(contact.problem);
  contact.bodies = {{1.001 * largest(elastic.patches[0].pressure) / yield_onset, 1.0}};
  contact.make();
  const NormalSolution solution = NormalSolver().solve_yielding(contact.problem);
  for (std::size_t i = 0; i < contact.grid.element_count(); ++i) {
    EXPECT_NEAR(solution.patches[0].pressure[i], elastic.patches[0].pressure[i],
                10.0 * tolerance * largest(elastic.patches[0].pressure));
  }
}

TEST(Yielding, AtTheApproachFoundCarriesTheLoad) {
  Contact contact = paraboloid(24, 24);
  contact.bodies = {{300.0, 1.0}};
  contact.make();
  const double approach = NormalSolver().solve_yielding(contact.problem).approach;
  Contact at = paraboloid(24, 24);
  at.bodies = contact.bodies;
  at.make(approach);
  EXPECT_NEAR(NormalSolver().solve_yielding(at.problem).patches[0].normal_force, load, 1e-5 * load);
}

/// The contact, once it has carried the pressures of a solution in place.
Contact pressed_before(const Contact& contact, const NormalSolution& solution) {
  Contact dented = contact;
  for (const std::vector<double>& by_body : solution.patches[0].indentation) {
    for (std::size_t i = 0; i < by_body.size(); ++i) {
      dented.distance[i] += by_body[i];
    }
  }
  dented.carried = solution.patches[0].pressure;
  return dented;
}

TEST(Yielding, PressedAgainInPlaceIsElasticWithTheSamePressures) {
  Contact contact = paraboloid(30, 30);
  contact.bodies = {{300.0, 0.5}, {400.0, 0.5}};
  contact.make();
  const NormalSolution first = NormalSolver().solve_yielding(contact.problem);
  Contact again = pressed_before(contact, first);
  again.make();
  const double greatest = largest(first.patches[0].pressure);
  for (const NormalSolution& second :
       {NormalSolver().solve_yielding(again.problem), NormalSolver().solve(again.problem)}) {
    EXPECT_EQ(second.stop_reason, StopReason::tolerance_met);
    for (std::size_t i = 0; i < again.carried.size(); ++i) {
      EXPECT_NEAR(second.patches[0].pressure[i], first.patches[0].pressure[i], 1e-5 * greatest);
    }
    EXPECT_NEAR(second.approach, first.approach, 1e-5 * first.approach);
  }
}

/// With rows that have carried pressures: the gap is the derivative of the energy.
TEST(Yielding, OfSteelPressedBeforeClosesTheGapsOfItsEnergy) {
  Contact contact = paraboloid(24, 20);
  contact.bodies = {{300.0, 1.0}};
  contact.make();
  const double first = largest(NormalSolver().solve_yielding(contact.problem).patches[0].pressure);
  for (std::size_t row = 0; row < 24; ++row) {
    contact.carried.push_back(row < 12 ? 0.9 * first : 0.0);
  }
  contact.make();
  const NormalSolution solution = NormalSolver().solve_yielding(contact.problem);
  ASSERT_EQ(solution.stop_reason, StopReason::tolerance_met);
  const std::vector<double>& pressure = solution.patches[0].pressure;
  EXPECT_GT(largest({pressure.begin(), pressure.begin() + 240}), 1.02 * first);
  DisplacementOperator displace(contact.grid, steel_modulus, Elements::smooth, {});
  const YieldTerms terms(contact.grid, pressure, {}, contact.bodies, contact.carried);
  std::vector<double> gap(pressure.size());
  std::vector<double> by_excess(pressure.size());
  displace.apply(pressure, gap);
  displace.apply(terms.excess[0], by_excess);
  terms.add_indentation(0, by_excess, gap);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const double rest = gap[i] + contact.distance[i] - solution.approach;
    EXPECT_GE(rest, -1e-6 * solution.approach);
    EXPECT_LE(pressure[i] > 0.0 ? rest : 0.0, 1e-6 * solution.approach);
  }
}

/// Two patches that displace each other: each alone and less stiff would carry more.
TEST(Yielding, PatchesThatDisplaceEachOtherShareTheLoad) {
  Contact one = paraboloid(20, 20);
  one.bodies = {{350.0, 1.0}};
  one.make();
  std::array<PatchGap, 2> gaps{one.gap, one.gap};
  PatchInteraction interaction{{{-12.0, 0.0}, {12.0, 0.0}}, {0.0, 1.0, 1.0, 0.0}};
  NormalProblem problem = one.problem;
  problem.patches = gaps;
  problem.load = 2.0 * load;
  problem.interaction = &interaction;
  const NormalSolution solution = NormalSolver().solve_yielding(problem);
  EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met);
  EXPECT_NEAR(solution.patches[0].normal_force, load, 1e-6 * load);
  EXPECT_NEAR(solution.patches[1].normal_force, load, 1e-6 * load);
  EXPECT_GT(solution.approach, 1.05 * NormalSolver().solve_yielding(one.problem).approach);
  // The middle of the other one is 24 mm off: about F/(pi E* r), with yielding a little more.
  const double by_other = load / (3.14159 * steel_modulus * 24.0);
  EXPECT_NEAR(solution.approach - NormalSolver().solve_yielding(one.problem).approach, by_other,
              0.25 * by_other);
}

} // namespace
} // namespace wrc::test::yielding_test
