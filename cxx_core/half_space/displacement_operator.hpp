/// u = A p: surface displacements of a half-space from element pressures, by DC-FFT.
///
///   u[i, j] = sum_{k, l} K[i - k, j - l] p[k, l]
/// with K the influence coefficients (influence_coefficients.hpp), as an exact linear convolution
/// of the whole grid (box_convolution.hpp); with inclinations of the rows, along a curve.
/// Units mm, MPa; fields in the order of base/grid.hpp.
/// Does not handle gaps or contact. Thread rule: holds work buffers, so one object serves one
/// thread at a time.
#pragma once

#include <cstddef>
#include <span>

#include "base/grid.hpp"
#include "half_space/box_convolution.hpp"
#include "half_space/influence_coefficients.hpp"

namespace wrc {

class DisplacementOperator {
public:
  /// Any size from 1 x 1 and any element aspect ratio; steps and modulus > 0. `angles`: of the
  /// rows, or none.
  DisplacementOperator(const Grid& grid, double combined_modulus,
                       Elements elements = Elements::constant, std::span<const double> angles = {});

  /// Displacement in mm from pressure in MPa, one value per element; the spans may be the same.
  void apply(std::span<const double> pressure, std::span<double> displacement);

private:
  std::size_t lateral_count_;
  std::size_t longitudinal_count_;
  double scale_; ///< longitudinal step / (pi E*)
  BoxConvolution<double> convolution_;
  ConvolutionWorkspace<double> workspace_;
};

/// Throws Error(invalid_argument) unless there are no angles, or a finite one of each row.
void check_angles(std::span<const double> angles, const Grid& grid);

} // namespace wrc
