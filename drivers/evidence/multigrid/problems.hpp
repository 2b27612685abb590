/// The two normal problems that all methods solve, and what checks their answers.
///
/// Lengths in mm, and pressures as lengths too: q = p dx/(pi E*), dx the longitudinal step of the
/// grid at hand, so that u = K q with the influence coefficients of half_space/influence_cache.hpp:
///   g = h + K q - approach >= 0,  q >= 0,  q g = 0,  sum q = load/(pi E* dy).
/// Elements are smooth ones, the default of scenes. All elements share the approach: the second
/// problem leaves out that the wheel's surface turns within the patch.
#pragma once

#include <cstddef>
#include <vector>

#include "mechanics/normal_contact.hpp"

namespace multigrid {

using wrc::Grid;

struct Problem {
  Grid grid;
  std::vector<double> distance; ///< h, mm
  double sum = 0.0;             ///< of q, mm

  [[nodiscard]] std::size_t rows() const { return grid.lateral_count; }
  [[nodiscard]] std::size_t columns() const { return grid.longitudinal_count; }
  [[nodiscard]] std::size_t count() const { return grid.element_count(); }
  [[nodiscard]] wrc::InfluenceKernel kernel() const {
    return {grid.lateral_step / grid.longitudinal_step, wrc::Elements::smooth};
  }
  /// MPa for q = 1 mm.
  [[nodiscard]] double pressure_unit() const;
  /// N
  [[nodiscard]] double load() const;
};

enum class Shape { hertz, two_lobes };

/// On side x side elements, over the least rectangle around the contact and 5 % beyond each side.
/// hertz: 80 kN, relative curvatures 1/460 mm along and 1/250 mm across, an ellipse of ratio 1.5.
/// two_lobes: S1002 on 60E1 at y = `two_lobed_lateral`, 80 kN, gap in the tangent plane at the
/// first touch.
Problem make_problem(Shape shape, std::size_t side);
inline constexpr double two_lobed_lateral = 4.7; ///< mm

/// Means over 2 x 2 elements, as the cascade of the library's solver takes them.
Problem coarser(const Problem& fine);

/// The problem as the library takes it; `patch` outlives the answer's use.
wrc::NormalProblem library_problem(const Problem& problem, wrc::PatchGap& patch, double tolerance);

/// Whether q solves the problem, by an exact product of its own.
struct Residual {
  double gap = 0.0;  ///< mean of |g| weighted with the load, and overlap outside; relative to depth
  double load = 0.0; ///< relative
};
Residual residual_of(const Problem& problem, const std::vector<double>& q);

} // namespace multigrid
