/// A normal contact problem of a gap on a grid. Units mm, N, MPa.
#pragma once

#include <cstddef>
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

} // namespace extremes
