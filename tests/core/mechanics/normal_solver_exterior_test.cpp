/// A second contact far from the first one, too small for the coarser grids to see, is never lost:
/// without the check of the elements outside the rectangle of the iteration the `Finds` tests fail.
#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "half_space/displacement_operator.hpp"
#include "support/solver_checks.hpp"

namespace wrc::test::normal_solver_exterior_test {
namespace {

using Place = std::pair<std::size_t, std::size_t>;

/// A sphere in the middle of 256 x 128 elements and its answer, contact 8 elements across under
/// 50 N, 80 under 50 kN.
class LoneSphere {
public:
  explicit LoneSphere(double load_on_it = 50.0) : load(load_on_it) {
    const PatchProblem problem = with_load(grid, distance, load, exact_tolerance);
    const PatchSolution alone = solve_exactly(problem);
    approach = alone.approach;
    displacement.resize(grid.element_count());
    DisplacementOperator(grid, steel_modulus).apply(alone.pressure, displacement);
    largest = *std::max_element(displacement.begin(), displacement.end());
  }

  [[nodiscard]] std::size_t index_of(const Place& place) const {
    return place.first * grid.longitudinal_count + place.second;
  }
  /// Overlap of the rigid shape with the displaced surface at one element.
  void press_in(std::vector<double>& gap, const Place& place, double share) const {
    const std::size_t index = index_of(place);
    gap[index] = approach - displacement[index] - share * largest;
  }

  const double load;
  const Grid grid = centred_grid(256, 128, 0.05, 0.05);
  const std::vector<double> distance = hertz_gap(grid, 0.05, 0.05);
  double approach = 0.0;
  std::vector<double> displacement;
  double largest = 0.0;
};

/// Answers for load and approach have pressure at the place, and no overlap. An element pressed in
/// by this share bears 3 to 6 times this share of the largest pressure: more than the tolerances.
void expect_found(NormalSolver& solver, const LoneSphere& sphere,
                  const std::vector<double>& distance, const Place& place, double share,
                  const std::string& name) {
  for (const double tolerance : {0.1 * share, 1e-6}) {
    for (const bool by_load : {true, false}) {
      const PatchProblem problem =
          by_load ? with_load(sphere.grid, distance, sphere.load, tolerance)
                  : with_approach(sphere.grid, distance, sphere.approach, tolerance);
      const PatchSolution solution = solver.solve(problem);
      const std::string text = name + " pressed in by " + std::to_string(share) + " at row " +
                               std::to_string(place.first) + ", column " +
                               std::to_string(place.second) + (by_load ? ", load" : ", approach");
      EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met) << text;
      EXPECT_GT(solution.pressure[sphere.index_of(place)], 0.0) << text;
      const Residuals residuals = compute_residuals(problem, solution.pressure, solution.approach);
      EXPECT_GE(residuals.least_gap, -std::max(gap_share * tolerance, unseen_overlap)) << text;
      EXPECT_LE(residuals.complementarity, gap_share * tolerance) << text;
    }
  }
}

TEST(ExteriorCheck, FindsOneElement) {
  const LoneSphere sphere;
  NormalSolver solver;
  for (const Place& place :
       {Place{0, 0}, {255, 127}, {0, 64}, {128, 0}, {3, 125}, {200, 17}, {101, 126}}) {
    for (const double share : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
      std::vector<double> distance = sphere.distance;
      sphere.press_in(distance, place, share);
      expect_found(solver, sphere, distance, place, share, "element");
    }
  }
}

/// All around a large contact gaps are narrow, and looked at with larger elements first.
TEST(ExteriorCheck, FindsOneElementBesideALargeContact) {
  const LoneSphere sphere(5e4);
  NormalSolver solver;
  const std::vector<Place> places{{128, 107}, {128, 18}, {84, 64},   {83, 63}, {175, 80},
                                  {170, 98},  {60, 64},  {128, 127}, {0, 0},   {255, 1}};
  for (const Place& place : places) {
    for (const double share : {1e-1, 1e-3, 1e-5}) {
      std::vector<double> distance = sphere.distance;
      sphere.press_in(distance, place, share);
      expect_found(solver, sphere, distance, place, share, "element");
    }
  }
}

TEST(ExteriorCheck, FindsANarrowRidge) {
  const LoneSphere sphere;
  NormalSolver solver;
  for (const Place& place : {Place{6, 3}, {250, 64}, {128, 127}, {190, 40}}) {
    for (const double share : {1e-2, 1e-4}) {
      std::vector<double> distance = sphere.distance;
      const std::size_t last = std::min<std::size_t>(place.first + 6, 255);
      for (std::size_t row = place.first - 6; row <= last; ++row) {
        sphere.press_in(distance, {row, place.second}, share);
      }
      expect_found(solver, sphere, distance, place, share, "ridge");
    }
  }
}

TEST(ExteriorCheck, FindsSeveralAtOnce) {
  const LoneSphere sphere;
  NormalSolver solver;
  std::vector<double> distance = sphere.distance;
  const std::vector<Place> places{{2, 2}, {253, 100}, {60, 127}, {230, 5}};
  for (const Place& place : places) {
    sphere.press_in(distance, place, 1e-2);
  }
  for (const Place& place : places) {
    expect_found(solver, sphere, distance, place, 1e-2, "one of several");
  }
}

TEST(ExteriorCheck, FindsNothingForSeparateBodies) {
  // A hair's breadth of room: no pressure there, and the answer of the sphere alone.
  const LoneSphere sphere;
  NormalSolver solver;
  constexpr double tolerance = 1e-6;
  const PatchSolution alone =
      solver.solve(with_load(sphere.grid, sphere.distance, sphere.load, tolerance));
  for (const Place& place : {Place{0, 0}, {200, 17}, {101, 126}}) {
    std::vector<double> distance = sphere.distance;
    sphere.press_in(distance, place, -1e-5);
    const PatchSolution solution =
        solver.solve(with_load(sphere.grid, distance, sphere.load, tolerance));
    EXPECT_EQ(solution.pressure[sphere.index_of(place)], 0.0);
    EXPECT_LE(pressure_error(solution.pressure, alone.pressure), 2.0 * tolerance);
  }
}

} // namespace
} // namespace wrc::test::normal_solver_exterior_test
