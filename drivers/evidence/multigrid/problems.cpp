#include "multigrid/problems.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "geometry/wheelset_equilibrium.hpp"
#include "half_space/displacement_operator.hpp"
#include "mechanics/cascade.hpp"
#include "mechanics/normal_solver.hpp"
#include "profile/profile.hpp"
#include "remesh/undeformed_distance.hpp"

namespace multigrid {
namespace {

/// Steel on steel, MPa.
constexpr double modulus = 210000.0 / 1.82;
constexpr double wheel_load = 80e3;

using Gap = std::function<std::vector<double>(const Grid&)>;

Problem problem_on(const Grid& grid, const Gap& gap) {
  return {grid, gap(grid), wheel_load / (std::numbers::pi * modulus * grid.lateral_step)};
}

Grid grid_between(double left, double right, double low, double high, std::size_t side) {
  const auto count = static_cast<double>(side);
  const double across = (high - low) / count;
  const double along = (right - left) / count;
  return {side, side, across, along, low + 0.5 * across, left + 0.5 * along};
}

/// The least rectangle around contact, 5 % beyond each side, found on a generous one.
Grid fitted(const Gap& gap, double half_length, double low, double high, std::size_t side) {
  constexpr std::size_t search_side = 256;
  constexpr double beyond = 0.05;
  const Problem wide =
      problem_on(grid_between(-half_length, half_length, low, high, search_side), gap);
  wrc::PatchGap patch;
  const auto solution = wrc::NormalSolver().solve(library_problem(wide, patch, 1e-4));
  wrc::ElementBox box;
  wrc::find_pressure_box({search_side, search_side}, solution.patches.front().pressure, 0, box);
  const Grid& grid = wide.grid;
  const double along = beyond * static_cast<double>(box.columns()) * grid.longitudinal_step;
  const double across = beyond * static_cast<double>(box.rows()) * grid.lateral_step;
  return grid_between(
      grid.longitudinal(box.first_column) - along, grid.longitudinal(box.last_column) + along,
      grid.lateral(box.first_row) - across, grid.lateral(box.last_row) + across, side);
}

std::vector<double> paraboloid(const Grid& grid) {
  constexpr double along = 1.0 / 460.0; // mm^-1
  constexpr double across = 1.0 / 250.0;
  std::vector<double> distance(grid.element_count());
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const double x = grid.longitudinal(i % grid.longitudinal_count);
    const double y = grid.lateral(i / grid.longitudinal_count);
    distance[i] = 0.5 * (along * x * x + across * y * y);
  }
  return distance;
}

Problem two_lobed(std::size_t side) {
  const wrc::WheelSurface wheel(wrc::standard_profile("S1002"), {});
  const wrc::RailSurface rail(wrc::standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  wrc::EquilibriumRequest request;
  request.lateral = two_lobed_lateral;
  const auto equilibrium = wrc::find_equilibrium({wheel, rail}, {wheel, rail}, request);
  const auto& contact = equilibrium.left->scan.candidates.front();
  const wrc::PosedPair pair{wheel, rail, equilibrium.left->pose, equilibrium.left->vertical};
  const double y = contact.wheel.position.y;
  const wrc::ContactFrame frame = wrc::tangent_frame(
      {contact.wheel.position.x, y, rail.graph().at_lateral(y).height}, contact.rail_angle);
  const Gap gap = [&](const Grid& grid) {
    return wrc::sample_undeformed_distance(pair, frame, grid);
  };
  return problem_on(fitted(gap, 12.0, -20.0, 20.0, side), gap);
}

} // namespace

double Problem::pressure_unit() const {
  return std::numbers::pi * modulus / grid.longitudinal_step;
}

double Problem::load() const {
  return sum * pressure_unit() * grid.element_area();
}

Problem make_problem(Shape shape, std::size_t side) {
  return shape == Shape::hertz ? problem_on(fitted(paraboloid, 15.0, -15.0, 15.0, side), paraboloid)
                               : two_lobed(side);
}

Problem coarser(const Problem& fine) {
  const wrc::LevelSize size{fine.rows(), fine.columns()};
  const wrc::LevelSize half = wrc::coarser_size(size);
  const Grid& grid = fine.grid;
  Problem problem{{half.rows, half.columns, 2.0 * grid.lateral_step, 2.0 * grid.longitudinal_step,
                   grid.lateral_first + 0.5 * grid.lateral_step,
                   grid.longitudinal_first + 0.5 * grid.longitudinal_step},
                  {},
                  0.5 * fine.sum};
  wrc::coarsen_distance(size, fine.distance, problem.distance);
  for (double& distance : problem.distance) {
    distance *= 2.0; // from the coarser grid's unit of length
  }
  return problem;
}

wrc::NormalProblem library_problem(const Problem& problem, wrc::PatchGap& patch, double tolerance) {
  patch = {};
  patch.grid = problem.grid;
  patch.undeformed_distance = problem.distance;
  wrc::NormalProblem given;
  given.patches = {&patch, 1};
  given.combined_modulus = modulus;
  given.load = problem.load();
  given.tolerance = tolerance;
  given.elements = wrc::Elements::smooth;
  return given;
}

Residual residual_of(const Problem& problem, const std::vector<double>& q) {
  std::vector<double> pressure = q;
  for (double& value : pressure) {
    value *= problem.pressure_unit();
  }
  std::vector<double> gap(q.size());
  wrc::DisplacementOperator(problem.grid, modulus, wrc::Elements::smooth).apply(pressure, gap);
  const double sum = std::accumulate(q.begin(), q.end(), 0.0);
  double mean = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    gap[i] += problem.distance[i];
    mean += q[i] * gap[i] / sum;
  }
  double inside = 0.0;
  double overlap = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    inside += q[i] * std::abs(gap[i] - mean) / sum;
    overlap = q[i] > 0.0 ? overlap : std::max(overlap, mean - gap[i]);
  }
  const double depth = mean - *std::min_element(problem.distance.begin(), problem.distance.end());
  return {(inside + overlap) / depth, std::abs(sum / problem.sum - 1.0)};
}

} // namespace multigrid
