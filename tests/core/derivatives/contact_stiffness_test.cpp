/// Pressures that answer changes of the gap: against dense elimination, against differences of the
/// contact problem's solutions, and against Hertz.
#include "derivatives/contact_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "half_space/influence_coefficients.hpp"
#include "models/hertz.hpp"
#include "support/contact_cases.hpp"
#include "support/solver_checks.hpp"

namespace wrc::test::contact_stiffness_test {
namespace {

using Fields = std::vector<std::vector<double>>;

/// Tolerance of answers that count as exact, and what rounding leaves of them: the operator's
/// condition number is some hundreds.
constexpr double exact = 1e-13;
constexpr double rounding = 1e-10;

std::vector<std::span<const double>> spans_of(const Fields& fields) {
  return {fields.begin(), fields.end()};
}

/// Gaussian elimination without pivoting, which symmetric positive definite matrices allow.
std::vector<double> solve_matrix(std::vector<double> matrix, std::vector<double> values) {
  const std::size_t size = values.size();
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = k + 1; i < size; ++i) {
      const double factor = matrix[i * size + k] / matrix[k * size + k];
      for (std::size_t j = k; j < size; ++j) {
        matrix[i * size + j] -= factor * matrix[k * size + j];
      }
      values[i] -= factor * values[k];
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    for (std::size_t j = k + 1; j < size; ++j) {
      values[k] -= matrix[k * size + j] * values[j];
    }
    values[k] /= matrix[k * size + k];
  }
  return values;
}

struct Element {
  std::size_t patch;
  std::size_t index;
};

/// Point forces on a half-space, between patches whose grids lie in one plane.
class PointForces : public PatchInfluence {
public:
  PointForces(std::vector<Grid> grids, double share) : grids_(std::move(grids)), share_(share) {}
  [[nodiscard]] double coefficient(const Element& to, const Element& from) const {
    const auto x = [&](const Element& e) {
      return grids_[e.patch].longitudinal(e.index % grids_[e.patch].longitudinal_count);
    };
    const auto y = [&](const Element& e) {
      return grids_[e.patch].lateral(e.index / grids_[e.patch].longitudinal_count);
    };
    return share_ * grids_[from.patch].element_area() /
           (std::numbers::pi * steel_modulus * std::hypot(x(to) - x(from), y(to) - y(from)));
  }
  void add(std::span<const std::vector<double>> pressure,
           std::span<std::vector<double>> displacement) override {
    for (std::size_t to = 0; to < grids_.size(); ++to) {
      for (std::size_t from = 0; from < grids_.size(); ++from) {
        for (std::size_t i = 0; to != from && i < displacement[to].size(); ++i) {
          for (std::size_t j = 0; j < pressure[from].size(); ++j) {
            displacement[to][i] += coefficient({to, i}, {from, j}) * pressure[from][j];
          }
        }
      }
    }
  }

private:
  std::vector<Grid> grids_;
  double share_;
};

Fields solve_dense(std::span<const SolvedPatch> patches, const Fields& displacement,
                   const PointForces* influence = nullptr) {
  std::vector<Element> active;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    for (std::size_t i = 0; i < patches[k].pressure.size(); ++i) {
      if (patches[k].pressure[i] > 0.0) {
        active.push_back({k, i});
      }
    }
  }
  const std::size_t size = active.size();
  std::vector<double> matrix(size * size, 0.0);
  std::vector<double> values(size);
  for (std::size_t to = 0; to < size; ++to) {
    const Grid& grid = patches[active[to].patch].grid;
    const std::size_t columns = grid.longitudinal_count;
    values[to] = displacement[active[to].patch][active[to].index];
    for (std::size_t from = 0; from < size; ++from) {
      if (active[to].patch == active[from].patch) {
        matrix[to * size + from] = influence_coefficient(
            grid.longitudinal(active[to].index % columns) -
                grid.longitudinal(active[from].index % columns),
            grid.lateral(active[to].index / columns) - grid.lateral(active[from].index / columns),
            grid.longitudinal_step, grid.lateral_step, steel_modulus);
      } else if (influence != nullptr) {
        matrix[to * size + from] = influence->coefficient(active[to], active[from]);
      }
    }
  }
  const std::vector<double> answer = solve_matrix(std::move(matrix), std::move(values));
  Fields pressure;
  for (const SolvedPatch& patch : patches) {
    pressure.emplace_back(patch.pressure.size(), 0.0);
  }
  for (std::size_t i = 0; i < size; ++i) {
    pressure[active[i].patch][active[i].index] = answer[i];
  }
  return pressure;
}

std::vector<double> random_field(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> field(count);
  for (double& value : field) {
    value = uniform(generator) - 0.3;
  }
  return field;
}

double largest(const std::vector<double>& field) {
  double value = 0.0;
  for (const double entry : field) {
    value = std::max(value, std::abs(entry));
  }
  return value;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected,
                 double tolerance, const std::string& name) {
  ASSERT_EQ(found.size(), expected.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    worst = std::max(worst, std::abs(found[i] - expected[i]));
  }
  EXPECT_LE(worst, tolerance * largest(expected)) << name;
}

class ContactStiffnessTest : public testing::Test {
protected:
  void set_contact(const Grid& grid, const std::vector<double>& pressure) {
    const std::vector<SolvedPatch> patches{{grid, pressure}};
    stiffness.set_contact(patches, steel_modulus);
  }
  Fields answer_to(const Fields& change, double tolerance = exact) {
    Fields answer;
    outcome = stiffness.solve(spans_of(change), answer, tolerance);
    return answer;
  }

  InfluenceCache cache;
  ContactStiffness stiffness{cache};
  StiffnessOutcome outcome{}; ///< of the last answer
};

TEST_F(ContactStiffnessTest, IsThatOfDenseElimination) {
  for (const double aspect : {0.05, 0.4, 1.0, 6.0}) {
    for (const ContactCase& example : contact_cases(23, 17, 1.0 / aspect)) {
      const PatchSolution solution =
          solve_exactly(with_load(example.grid, example.distance, case_load / aspect, 1e-11));
      const std::vector<SolvedPatch> patches{{example.grid, solution.pressure}};
      stiffness.set_contact(patches, steel_modulus);
      for (const std::uint64_t seed : {1U, 2U}) {
        const Fields change{random_field(example.grid.element_count(), seed)};
        expect_near(answer_to(change)[0], solve_dense(patches, change)[0], rounding,
                    example.name + ", aspect " + std::to_string(aspect));
        EXPECT_EQ(outcome.stop_reason, StopReason::tolerance_met) << example.name;
      }
    }
  }
}

TEST_F(ContactStiffnessTest, ToleranceBoundsTheErrorOfForces) {
  // Forces were right to 0.16 of the tolerance; <r, M r> was down to 0.6 of the error's energy.
  constexpr double slack = 2.0;
  for (const double aspect : {0.2, 1.0, 6.0}) {
    for (const ContactCase& example : contact_cases(60, 44, aspect)) {
      const PatchSolution solution =
          solve_exactly(with_load(example.grid, example.distance, case_load * aspect, 1e-11));
      std::vector<double> slope(example.grid.element_count());
      for (std::size_t i = 0; i < slope.size(); ++i) {
        slope[i] = 1.0 + 0.1 * example.grid.lateral(i / example.grid.longitudinal_count);
      }
      const Fields one{std::vector<double>(slope.size(), 1.0)};
      const Fields other{slope};
      const auto force_for = [&](const Fields& change, double tolerance) {
        set_contact(example.grid, solution.pressure);
        return force_of(example.grid, answer_to(change, tolerance)[0]);
      };
      const double quadratic = force_for(one, exact);
      const double force = force_for(other, exact);
      for (const double tolerance : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8}) {
        EXPECT_LE(std::abs(force_for(other, tolerance) / force - 1.0), tolerance)
            << example.name << " " << tolerance;
        EXPECT_LE(outcome.error, tolerance);
        // By rounding, later iterations lose what makes the error quadratic: in rough contacts
        // early.
        EXPECT_LE(std::abs(force_for(one, tolerance) / quadratic - 1.0),
                  slack * tolerance * (tolerance >= 1e-4 ? tolerance : 1.0))
            << example.name << " " << tolerance;
      }
    }
  }
}

TEST_F(ContactStiffnessTest, IsTheDerivativeOfTheContactProblem) {
  // Pressures are linear in the change as long as no element joins or leaves, so the step may be as
  // large as that allows; the solver's 1e-11 counts over the step.
  int unchanged = 0;
  for (const double aspect : {0.05, 1.0, 6.0}) {
    for (const ContactCase& example : contact_cases(40, 36, 1.0 / aspect)) {
      const PatchSolution middle =
          solve_exactly(with_load(example.grid, example.distance, case_load / aspect, 1e-11));
      // The derivative at an answer to a prescribed approach.
      const double step = 1e-5 * std::abs(middle.approach);
      std::vector<double> change = random_field(example.grid.element_count(), 3);
      const auto solve_at = [&](double by) {
        std::vector<double> distance = example.distance;
        for (std::size_t i = 0; i < distance.size(); ++i) {
          distance[i] += by * change[i];
        }
        return solve_exactly(with_approach(example.grid, distance, middle.approach, 1e-11));
      };
      const PatchSolution ahead = solve_at(step);
      const PatchSolution behind = solve_at(-step);
      bool same = true;
      std::vector<double> difference(change.size());
      for (std::size_t i = 0; i < change.size(); ++i) {
        same = same && (ahead.pressure[i] > 0.0) == (middle.pressure[i] > 0.0) &&
               (behind.pressure[i] > 0.0) == (middle.pressure[i] > 0.0);
        difference[i] = (ahead.pressure[i] - behind.pressure[i]) / (2.0 * step);
        change[i] = -change[i];
      }
      if (!same) {
        continue;
      }
      ++unchanged;
      set_contact(example.grid, middle.pressure);
      const Fields pressure = answer_to({change});
      expect_near(pressure[0], difference, 1e-5, example.name + std::to_string(aspect));
      const double force = force_of(example.grid, pressure[0]);
      EXPECT_NEAR(force, (ahead.normal_force - behind.normal_force) / (2.0 * step),
                  1e-5 * std::abs(force))
          << example.name;
    }
  }
  EXPECT_GE(unchanged, 14) << "of 18";
}

TEST_F(ContactStiffnessTest, HertzInTheLimit) {
  // N goes with the approach to the power of 3/2. What the elements at the edge do to the
  // derivative of the discrete force is chance, so the error falls irregularly: 0.03 for 16
  // elements, 0.004 for 64, 0.0003 for 256.
  constexpr double order = 1.25;
  constexpr double largest_share = 1.2;
  for (const double curvature : {1.0 / 460.0, 1.0 / 80.0}) {
    const HertzContact hertz = solve_hertz(1.0 / 460.0, curvature, steel_modulus, 80000.0);
    for (const std::size_t count : {16U, 32U, 64U, 128U, 256U}) {
      double worst = 0.0;
      for (const double room : {1.17, 1.22, 1.29}) {
        const double n = static_cast<double>(count);
        const Grid grid = centred_grid(count, count, 2.0 * room * hertz.semi_axis_lateral / n,
                                       2.0 * room * hertz.semi_axis_longitudinal / n);
        const std::vector<double> distance = hertz_gap(grid, 1.0 / 460.0, curvature);
        const PatchSolution solution =
            solve_exactly(with_approach(grid, distance, hertz.approach, 1e-9));
        set_contact(grid, solution.pressure);
        const Fields one{std::vector<double>(grid.element_count(), 1.0)};
        Fields pressure;
        stiffness.solve(spans_of(one), pressure);
        const double expected = 1.5 * 80000.0 / hertz.approach;
        worst = std::max(worst, std::abs(force_of(grid, pressure[0]) / expected - 1.0));
      }
      EXPECT_LE(worst, largest_share * std::pow(static_cast<double>(count), -order)) << count;
    }
  }
}

TEST_F(ContactStiffnessTest, OneElement) {
  const Grid grid{5, 7, 0.3, 0.2, -0.6, -0.6};
  std::vector<double> pressure(grid.element_count(), 0.0);
  pressure[17] = 12.0;
  set_contact(grid, pressure);
  const Fields answer = answer_to({std::vector<double>(grid.element_count(), 1.0)});
  const double expected = 1.0 / influence_coefficient(0.0, 0.0, 0.2, 0.3, steel_modulus);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    EXPECT_NEAR(answer[0][i], i == 17 ? expected : 0.0, 1e-12 * expected);
  }
}

TEST_F(ContactStiffnessTest, AllElementsAndScales) {
  // A change of all lengths by a factor changes the answer to one unit of displacement by its
  // inverse.
  Fields first;
  for (const double scale : {1.0, 1e-15, 1e18}) {
    const Grid grid = centred_grid(13, 21, 0.2 * scale, 0.1 * scale);
    const std::vector<double> pressure(grid.element_count(), 3.0);
    const std::vector<SolvedPatch> patches{{grid, pressure}};
    stiffness.set_contact(patches, steel_modulus);
    const Fields change{random_field(grid.element_count(), 4)};
    Fields answer = answer_to(change);
    if (scale == 1.0) {
      expect_near(answer[0], solve_dense(patches, change)[0], rounding, "all elements");
      first = answer;
    }
    for (double& value : answer[0]) {
      value *= scale;
    }
    expect_near(answer[0], first[0], rounding, "scaled");
  }
}

TEST_F(ContactStiffnessTest, TouchingWithoutPressureIsNoContact) {
  // Two elements far enough in a row; the second touches with no pressure. Pressing it down on the
  // first only lifts the gap there: the derivative of the direction in which it parts.
  const Grid grid = centred_grid(1, 8, 0.1, 0.1);
  std::vector<double> pressure(8, 0.0);
  pressure[2] = pressure[3] = 5.0;
  std::vector<double> distance(8, 1.0);
  const auto coefficient = [](double apart) {
    return influence_coefficient(0.1 * apart, 0.0, 0.1, 0.1, steel_modulus);
  };
  for (const std::size_t i : {2U, 3U, 4U}) {
    const double x = static_cast<double>(i);
    distance[i] = -5.0 * (coefficient(x - 2.0) + coefficient(x - 3.0));
  }
  set_contact(grid, pressure);
  const Fields answer = answer_to({{0, 0, 1.0, 1.0, 0, 0, 0, 0}});
  EXPECT_EQ(answer[0][4], 0.0);
  const double step = 1e-7;
  for (const double by : {step, -step}) {
    std::vector<double> moved = distance;
    moved[2] -= by;
    moved[3] -= by;
    const PatchSolution solution = solve_exactly(with_approach(grid, moved, 0.0, 1e-11));
    const double rate = (solution.pressure[2] - 5.0) / by;
    if (by > 0.0) {
      EXPECT_NEAR(rate, answer[0][2], 1e-4 * rate) << "it parts";
    } else {
      EXPECT_GT(std::abs(rate - answer[0][2]), 1e-3 * rate) << "it takes pressure";
    }
  }
}

/// Two patches of different elements side by side in one plane.
struct TwoPatches {
  Grid left = centred_grid(14, 18, 0.12, 0.2);
  Grid right = centred_grid(20, 11, 0.3, 0.15);
  std::vector<double> left_pressure;
  std::vector<double> right_pressure;

  TwoPatches() {
    left.lateral_first -= 1.5;
    right.lateral_first += 3.5;
    left_pressure = of_ellipse(left, -1.5, 0.7, 1.4);
    right_pressure = of_ellipse(right, 3.5, 2.2, 0.6);
  }
  static std::vector<double> of_ellipse(const Grid& grid, double middle, double across,
                                        double along) {
    std::vector<double> pressure;
    for (std::size_t i = 0; i < grid.element_count(); ++i) {
      const double y = (grid.lateral(i / grid.longitudinal_count) - middle) / across;
      const double x = grid.longitudinal(i % grid.longitudinal_count) / along;
      pressure.push_back(std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
    return pressure;
  }
  [[nodiscard]] std::vector<SolvedPatch> patches() const {
    return {{left, left_pressure}, {right, right_pressure}};
  }
};

TEST_F(ContactStiffnessTest, PatchesThatDoNotInteract) {
  const TwoPatches two;
  const Grid empty = centred_grid(3, 3, 0.1, 0.1);
  const std::vector<double> nothing(9, 0.0);
  std::vector<SolvedPatch> patches = two.patches();
  patches.insert(patches.begin() + 1, SolvedPatch{empty, nothing});
  stiffness.set_contact(patches, steel_modulus);
  const Fields change{random_field(two.left.element_count(), 5), std::vector<double>(9, 1.0),
                      random_field(two.right.element_count(), 6)};
  const Fields together = answer_to(change);
  EXPECT_EQ(together[1], nothing);
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
    stiffness.set_contact(std::span(patches).subspan(k, 1), steel_modulus);
    expect_near(together[k], answer_to({change[k]})[0], rounding, "alone");
  }
}

TEST_F(ContactStiffnessTest, PatchesThatInteract) {
  const TwoPatches two;
  const std::vector<SolvedPatch> patches = two.patches();
  PointForces influence({two.left, two.right}, 0.8);
  stiffness.set_contact(patches, steel_modulus, &influence);
  for (const std::uint64_t seed : {7U, 8U}) {
    const Fields change{random_field(two.left.element_count(), seed),
                        random_field(two.right.element_count(), seed + 2)};
    const Fields answer = answer_to(change);
    EXPECT_EQ(outcome.stop_reason, StopReason::tolerance_met);
    const Fields expected = solve_dense(patches, change, &influence);
    expect_near(answer[0], expected[0], rounding, "left");
    expect_near(answer[1], expected[1], rounding, "right");
  }
  // One patch moves, the other answers.
  const Fields answer = answer_to({std::vector<double>(two.left.element_count(), 1.0), {}});
  EXPECT_LT(force_of(two.right, answer[1]), 0.0);
}

TEST_F(ContactStiffnessTest, AnswersAreKeptUntilTheContactChanges) {
  const TwoPatches two;
  const std::vector<SolvedPatch> patches = two.patches();
  stiffness.set_contact(patches, steel_modulus);
  const Fields one{std::vector<double>(two.left.element_count(), 1.0),
                   std::vector<double>(two.right.element_count(), 1.0)};
  const Fields noise{random_field(two.left.element_count(), 1),
                     random_field(two.right.element_count(), 2)};
  Fields both = one;
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < both[k].size(); ++i) {
      both[k][i] = 3.0 * one[k][i] - 7.0 * noise[k][i];
    }
  }
  Fields first;
  Fields second;
  Fields sum;
  EXPECT_GT(stiffness.solve(spans_of(one), first, 1e-10).iterations, 5);
  EXPECT_GT(stiffness.solve(spans_of(noise), second, 1e-10).iterations, 5);
  EXPECT_LE(stiffness.solve(spans_of(both), sum, 1e-8).iterations, 1);
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < both[k].size(); ++i) {
      first[k][i] = 3.0 * first[k][i] - 7.0 * second[k][i];
    }
    expect_near(sum[k], first[k], 1e-8, "combined");
  }
  const Fields zero{{}, {}};
  EXPECT_EQ(stiffness.solve(spans_of(zero), sum).iterations, 0);
  EXPECT_EQ(largest(sum[0]), 0.0);
  stiffness.set_contact(patches, steel_modulus);
  EXPECT_GT(stiffness.solve(spans_of(one), first, 1e-10).iterations, 5);
}

TEST_F(ContactStiffnessTest, WithoutContactThereIsNoStiffness) {
  const Grid grid = centred_grid(4, 5, 0.1, 0.1);
  const std::vector<double> nothing(grid.element_count(), 0.0);
  set_contact(grid, nothing);
  EXPECT_EQ(answer_to({std::vector<double>(grid.element_count(), 1.0)})[0], nothing);
  EXPECT_EQ(outcome.stop_reason, StopReason::tolerance_met);
}

TEST_F(ContactStiffnessTest, LimitOfIterations) {
  const TwoPatches two;
  stiffness.set_contact(two.patches(), steel_modulus);
  const Fields noise{random_field(two.left.element_count(), 1),
                     random_field(two.right.element_count(), 2)};
  Fields answer;
  const StiffnessOutcome limited = stiffness.solve(spans_of(noise), answer, 1e-12, 3);
  EXPECT_EQ(limited.stop_reason, StopReason::iteration_limit);
  EXPECT_EQ(limited.iterations, 3);
  EXPECT_GT(limited.error, 1e-12);
  // What cannot be reached ends all the same.
  const StiffnessOutcome stuck = stiffness.solve(spans_of(noise), answer, 1e-30);
  EXPECT_EQ(stuck.stop_reason, StopReason::stagnation);
}

TEST_F(ContactStiffnessTest, RefusesWhatItCannotSolve) {
  const Grid grid = centred_grid(4, 5, 0.1, 0.1);
  const std::vector<double> pressure(grid.element_count(), 1.0);
  const std::vector<double> shorter(3, 1.0);
  const std::vector<SolvedPatch> patches{{grid, pressure}};
  const std::vector<SolvedPatch> misfit{{grid, shorter}};
  EXPECT_THROW(stiffness.set_contact({}, steel_modulus), Error);
  EXPECT_THROW(stiffness.set_contact(misfit, steel_modulus), Error);
  EXPECT_THROW(stiffness.set_contact(patches, 0.0), Error);
  stiffness.set_contact(patches, steel_modulus);
  Fields answer;
  EXPECT_THROW(stiffness.solve(spans_of({pressure, pressure}), answer), Error);
  EXPECT_THROW(stiffness.solve(spans_of({shorter}), answer), Error);
  EXPECT_THROW(stiffness.solve(spans_of({pressure}), answer, 0.0), Error);
}

} // namespace
} // namespace wrc::test::contact_stiffness_test
