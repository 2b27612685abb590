/// u = A p: surface displacements of a half-space from element pressures, by DC-FFT.
///
///   u[i, j] = sum_{k, l} K[i - k, j - l] p[k, l]
/// with K the influence coefficients (influence_coefficients.hpp), as an exact linear convolution:
/// pressures padded with zeros to a good length of at least 2 N - 1 in each direction, the kernel
/// wrapped around (Liu, Wang & Liu, Wear 243 (2000) 101-111, discrete convolution with FFT).
/// Spare entries between 2 N - 1 and the padded length keep the true coefficient of their
/// wrapped-around distance; no pressure ever meets them. The kernel is even in both directions,
/// hence its spectrum is real and is kept as such.
/// Units mm, MPa; fields in the order of base/grid.hpp. Knows nothing of gaps or contact.
/// Thread rule: holds work buffers, so one object serves one thread at a time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/grid.hpp"
#include "half_space/fft.hpp"
#include "half_space/influence_coefficients.hpp"

namespace wrc {

class DisplacementOperator {
public:
  /// Any size from 1 x 1 and any element aspect ratio; steps and modulus > 0.
  DisplacementOperator(const Grid& grid, double combined_modulus,
                       Elements elements = Elements::constant);

  /// Displacement in mm from pressure in MPa, one value per element; the spans may be the same.
  void apply(std::span<const double> pressure, std::span<double> displacement);

private:
  std::size_t lateral_count_;
  std::size_t longitudinal_count_;
  RealFft transform_;
  std::vector<double> kernel_spectrum_; ///< with the transform's 1/size and 1/(pi E*) taken in
};

} // namespace wrc
