/// How well pressures solve a problem of a gap.
///
/// Residuals are computed by direct summation over all elements under pressure with this program's
/// own influence coefficients, in double precision: no transform, no table and no code of the
/// library's solver. On large grids a random sample of elements is checked, whose size bounds the
/// work. Units mm, N, MPa.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "wrc_extremes/gap_problem.hpp"

namespace extremes {

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
