/// Tangential contact on given pressures: cost beside the error of the forces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace benchmark {

/// One grid and tolerance over many ellipses.
struct RollingRow {
  std::int64_t along = 0;  ///< elements over the contact along the rolling direction
  std::int64_t across = 0; ///< and across
  double tolerance = 0.0;
  double error_rms = 0.0; ///< of the largest of Fx, Fy over mu N and Mz over mu N sqrt(a b)
  double error_max = 0.0;
  double convolutions = 0.0; ///< mean, all grids
  /// Milliseconds, medians: other creepages on the same elements; and elements of another ratio of
  /// sides, which adds influence coefficients and their transforms.
  double warm_ms = 0.0;
  double new_ratio_ms = 0.0;
  double normal_ms = 0.0; ///< the normal contact of the same patch, at 1e-2 or 1e-3
  double fft_pair_ms = 0.0;
  int cases = 0;
  int failures = 0;

  [[nodiscard]] double pairs() const { return warm_ms / fft_pair_ms; }
};

/// Ellipses of a/b from 0.2 to 5 with 0.1 to 10 times the creepage of saturation, spin included, by
/// the full theory, on 8 x 4 to 256 x 128 elements.
std::vector<RollingRow> measure_rolling(int repeat);

nlohmann::json json_of(const RollingRow& row);
void print_rolling(const std::vector<RollingRow>& rows);

} // namespace benchmark
