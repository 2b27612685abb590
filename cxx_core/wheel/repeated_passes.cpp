#include "wheel/repeated_passes.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/reductions.hpp"
#include "remesh/row_scales.hpp"
#include "wheel/constants.hpp"

namespace wrc {
namespace {

/// Of rows, interpolated at a place across them; none outside.
double at_row(const Grid& grid, std::span<const double> rows, double lateral) {
  const double place = (lateral - grid.lateral_first) / grid.lateral_step;
  const double last = static_cast<double>(grid.lateral_count - 1);
  if (rows.empty() || !(place >= 0.0) || place > last) {
    return 0.0;
  }
  const auto row = static_cast<std::size_t>(place);
  const std::size_t next = std::min(row + 1, rows.size() - 1);
  return std::lerp(rows[row], rows[next], place - static_cast<double>(row));
}

/// The largest value of each row of a field.
std::vector<double> largest_of_rows(const Grid& grid, std::span<const double> field) {
  std::vector<double> largest;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    largest.push_back(
        std::ranges::max(field.subspan(row * grid.longitudinal_count, grid.longitudinal_count)));
  }
  return largest;
}

/// How much deeper a pass has made the groove where it did most, over its greatest depth.
double deepened(const GridSolution& solution) {
  double most = 0.0;
  double deepest = 0.0;
  for (const Patch& patch : solution.patches) {
    const Groove& groove = patch.groove;
    for (std::size_t row = 0; row < groove.depth[0].size(); ++row) {
      const double depth = groove.depth[0][row] + groove.depth[1][row];
      most = std::max(most, depth - (groove.found.empty() ? 0.0 : groove.found[row]));
      deepest = std::max(deepest, depth);
    }
  }
  return deepest > 0.0 ? most / deepest : 0.0;
}

} // namespace

void take_groove(const GridSolution& before, Patch& patch) {
  const Grid& grid = patch.grid;
  Groove& groove = patch.groove;
  groove.carried.assign(grid.lateral_count, 0.0);
  groove.depth.fill(groove.carried);
  for (const Patch& other : before.patches) {
    const std::vector<double> pressure = largest_of_rows(other.grid, other.pressure);
    const double shift = patch.frame.lateral_of(other.frame.origin - patch.frame.origin);
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      const auto raise = [&](double& value, std::span<const double> rows) {
        value = std::max(value, at_row(other.grid, rows, grid.lateral(row) - shift));
      };
      raise(groove.carried[row], pressure);
      raise(groove.carried[row], other.groove.carried);
      for (std::size_t body = 0; body < groove.depth.size(); ++body) {
        raise(groove.depth[body][row], other.groove.depth[body]);
      }
    }
  }
  groove.found = groove.depth[0];
  add_scaled(groove.found.data(), 1.0, groove.depth[1].data(), groove.found.size());
  for (std::size_t i = 0; i < patch.undeformed_distance.size(); ++i) {
    patch.undeformed_distance[i] += groove.found[i / grid.longitudinal_count];
  }
}

void leave_groove(std::span<const YieldingBody> bodies,
                  std::span<const std::vector<double>> indentation, Patch& patch) {
  for (std::vector<double>& depth : patch.groove.depth) {
    depth.resize(patch.grid.lateral_count, 0.0);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::vector<double> added =
        largest_of_rows(patch.grid, over_scales(patch.grid, patch.row_scales, indentation[b]));
    for (std::size_t row = 0; row < added.size(); ++row) {
      patch.groove.depth[0][row] += bodies[b].of_wheel * added[row];
      patch.groove.depth[1][row] += (1.0 - bodies[b].of_wheel) * added[row];
    }
  }
}

bool another_pass(const GridSolution& solution, int pass, int passes, Warnings& warnings) {
  if (pass >= passes) {
    return false;
  }
  if (solution.stop_reason != StopReason::tolerance_met) {
    warnings.push_back({WarningClass::not_converged,
                        "pass " + text_of(pass) + " of solve.passes = " + text_of(passes) +
                            " is not solved to the tolerance: no later one was made"});
    return false;
  }
  return deepened(solution) > settled_groove;
}

} // namespace wrc
