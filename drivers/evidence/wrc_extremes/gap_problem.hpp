/// A normal contact problem of a gap on a grid, and how well pressures solve it.
///
/// Residuals are computed by direct summation over all elements under pressure with this program's
/// own influence coefficients, in double precision: no transform, no table and no code of the
/// library's solver. On large grids a random sample of elements is judged, limited by the work
/// allows. Units mm, N, MPa.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace extremes {

struct GapProblem {
  std::size_t rows = 0; ///< across the rail
  std::size_t columns = 0;
  double lateral_step = 0.0;
  double longitudinal_step = 0.0;
  double combined_modulus = 0.0;
  std::vector<double> distance;   ///< longitudinal index fastest
  double normal_load = 0.0;       ///< unless the approach is given
  std::optional<double> approach; ///< mm

  [[nodiscard]] std::size_t count() const { return rows * columns; }
};

/// Relative to the largest displacement, the load balance to the load.
struct OwnResiduals {
  double load_balance = 0.0;
  double overlap = 0.0;         ///< largest overlap of elements without pressure; >= 0
  double complementarity = 0.0; ///< largest |gap| of elements under pressure
  double tension = 0.0;         ///< most negative pressure over the largest; >= 0
  std::size_t judged = 0;       ///< elements whose gap was computed
};

/// `load` is what the pressures should add up to. Without an approach the one is taken that suits
/// the elements under pressure: the mean of distance and displacement there.
OwnResiduals judge_pressures(const GapProblem& problem, const std::vector<double>& pressure,
                             const std::optional<double>& approach, double load,
                             std::uint64_t seed);

} // namespace extremes
