// Random patches together: nothing fails, and the answer is that of double precision and a far
// smaller tolerance, to the tolerance asked.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "support/solver_checks.hpp"

namespace wrc::test::joint_contact_random_test {
namespace {

/// Two or three patches, paraboloids with or without waves, on grids of all shapes.
class RandomPatches {
public:
  explicit RandomPatches(std::uint64_t seed) : generator_(seed) {
    const std::size_t count = even(0.0, 1.0) < 0.25 ? 3 : 2;
    distances_.resize(count);
    double beside = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const auto rows = static_cast<std::size_t>(even(5.0, 60.0));
      const auto columns = static_cast<std::size_t>(even(4.0, 40.0));
      const double width = spread(1.0, 12.0);
      const double length = spread(4.0, 14.0);
      const Grid grid = centred_grid(rows, columns, width / static_cast<double>(rows),
                                     length / static_cast<double>(columns));
      fill_distance(grid, k, width);
      PatchGap& gap = gaps_.emplace_back();
      gap.grid = grid;
      gap.approach_cosine = even(0.4, 1.0);
      interaction_.places.push_back({beside + 0.5 * width, even(-1.0, 1.0)});
      // Apart enough for interpolation to be good to 1e-5.
      beside += width + std::max(width, length) * spread(0.6, 3.0);
    }
    interaction_.coupling_weight.assign(count * count, even(0.0, 1.0));
    for (std::size_t k = 0; k < count; ++k) {
      gaps_[k].undeformed_distance = distances_[k];
    }
    problem_.combined_modulus = steel_modulus;
    problem_.elements = Elements::smooth;
    problem_.tolerance = spread(3e-5, 1e-2);
    if (even(0.0, 1.0) < 0.8) {
      problem_.load = spread(1.0, 2e5);
    } else {
      problem_.approach = spread(1e-3, 0.2);
    }
    if (even(0.0, 1.0) < 0.7) {
      problem_.interaction = &interaction_;
    }
  }
  RandomPatches(const RandomPatches&) = delete;
  RandomPatches& operator=(const RandomPatches&) = delete;

  [[nodiscard]] NormalProblem problem() const {
    NormalProblem problem = problem_;
    problem.patches = gaps_;
    return problem;
  }

private:
  double even(double from, double to) { return from + (to - from) * uniform(generator_); }
  double spread(double from, double to) { return std::exp(even(std::log(from), std::log(to))); }

  void fill_distance(const Grid& grid, std::size_t k, double width) {
    const double lateral_radius = spread(10.0, 600.0);
    const double longitudinal_radius = spread(150.0, 900.0);
    const double middle = even(-0.3, 0.3) * width;
    const double offset = k > 0 ? even(-0.02, 0.05) : 0.0;
    const double wave = even(0.0, 1.0) < 0.3 ? even(0.0, 0.002) : 0.0;
    for (std::size_t i = 0; i < grid.lateral_count; ++i) {
      for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
        const double y = grid.lateral(i) - middle;
        const double x = grid.longitudinal(j);
        distances_[k].push_back(offset +
                                0.5 * (y * y / lateral_radius + x * x / longitudinal_radius) +
                                wave * std::cos(4.0 * y));
      }
    }
  }

  std::mt19937_64 generator_;
  std::vector<std::vector<double>> distances_;
  std::vector<PatchGap> gaps_;
  PatchInteraction interaction_;
  NormalProblem problem_;
};

std::vector<double> pressures_of(const NormalSolution& solution) {
  std::vector<double> all;
  for (const NormalSolution::Patch& patch : solution.patches) {
    all.insert(all.end(), patch.pressure.begin(), patch.pressure.end());
  }
  return all;
}

TEST(JointContactRandom, MeetsTheRequestedTolerance) {
  constexpr int count = 300;
  NormalSolver solver;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE(seed);
    const RandomPatches patches(seed);
    NormalProblem exact = patches.problem();
    exact.tolerance = exact_tolerance;
    const std::vector<double> expected =
        pressures_of(NormalSolver(PlannerRigor::estimate, Precision::double_only).solve(exact));
    const NormalProblem problem = patches.problem();
    const NormalSolution found = solver.solve(problem);
    const std::vector<double> pressures = pressures_of(found);
    EXPECT_EQ(found.stop_reason, StopReason::tolerance_met);
    EXPECT_TRUE(std::isfinite(found.approach));
    EXPECT_TRUE(std::all_of(pressures.begin(), pressures.end(),
                            [](double pressure) { return std::isfinite(pressure); }));
    EXPECT_LE(pressure_error(pressures, expected), problem.tolerance);
  }
}

} // namespace
} // namespace wrc::test::joint_contact_random_test
