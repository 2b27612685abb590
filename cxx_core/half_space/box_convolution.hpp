/// Convolution with the influence coefficients between two rectangles of elements, pruned.
///
///   out[i, j] = sum_{k, l} K[i + row_offset - k, j + column_offset - l] in[k, l]
/// by transforms of lines: rows first, two at a time as one complex line, then columns, each
/// multiplied with the kernel's spectrum and transformed back while it is in cache, then the rows
/// requested. A line's length is at least twice the largest offset + 1, which makes the convolution
/// exact and linear (Liu, Wang & Liu, Wear 243 (2000) 101-111), or, for `periodic`, the rectangle
/// itself. In units of influence_cache.hpp: lengths in longitudinal steps, u = K p. Errors are
/// those of the precision, relative to the largest value.
///
/// Rows of a patch that is not plane lie along a curve across the rail, at equal distances of its
/// arc, and row i has the inclination a_i. Pressures act, and displacements count, along the
/// normals of their rows; elements of two rows influence each other as in a plane at the distance
/// along the arc, times the cosine of the angle between their normals (Blanco-Lorenzo et al.,
/// 2016):
///   out[i, j] = sum cos(a_i - a_k) K[i - k, j - l] in[k, l].
/// With cos(a - b) = cos a cos b + sin a sin b these are two convolutions, C K C + S K S, at any
/// curvature: symmetric, and positive definite where K is. Rows of one angle are a plane.
/// Does not handle gaps or contact. Thread rule: one workspace serves one thread at a time;
/// convolutions hold no state.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "half_space/influence_cache.hpp"

namespace wrc {

/// Buffers for the lines of one convolution; grow to the largest one and are kept.
template <typename Real> struct ConvolutionWorkspace {
  using Complex = std::complex<Real>;
  AlignedArray<Complex> lines;
  AlignedArray<Complex> spectral_lines;
  AlignedArray<Complex> columns;
  AlignedArray<Complex> column_lines;
  AlignedArray<Complex> column_spectra;
  AlignedArray<Real> turned; ///< of rows along a curve
  AlignedArray<Real> sum;
};

/// Two rectangles of elements: where the pressures are and where displacements are wanted.
struct ConvolutionShape {
  std::size_t rows_in = 0;
  std::size_t columns_in = 0;
  std::size_t rows_out = 0;
  std::size_t columns_out = 0;
  std::ptrdiff_t row_offset = 0;    ///< of the first row out from the first row in
  std::ptrdiff_t column_offset = 0; ///< likewise
};

/// Inclinations of the rows of the two rectangles, rad; none: a plane.
struct RowAngles {
  std::span<const double> in = {};
  std::span<const double> out = {};
};

template <typename Real> class BoxConvolution {
public:
  BoxConvolution() = default;
  /// u = K p from a rectangle to another.
  static BoxConvolution linear(const ConvolutionShape& shape, const InfluenceKernel& kernel,
                               InfluenceCache& cache, const RowAngles& angles = {});
  /// The inverse of the periodic convolution on a rectangle, as a preconditioner.
  static BoxConvolution inverse_periodic(std::size_t rows, std::size_t columns,
                                         const InfluenceKernel& kernel, InfluenceCache& cache);

  /// Rows of `in` and `out` follow each other without gaps; the two may be the same array.
  void apply(const Real* in, Real* out, ConvolutionWorkspace<Real>& workspace) const;

private:
  using Complex = std::complex<Real>;
  struct Lines;
  /// Factors of rows, of which the products add up.
  struct RowFactors {
    std::vector<Real> in;
    std::vector<Real> out;
  };

  void convolve(const Real* in, Real* out, ConvolutionWorkspace<Real>& workspace) const;
  void transform_rows(const Real* in, const Lines& to) const;
  void convolve_columns(const Lines& at, ConvolutionWorkspace<Real>& workspace) const;
  void transform_rows_back(const Lines& from, Real* out) const;

  ConvolutionShape shape_;
  const LineFft<Real>* row_fft_ = nullptr;
  const LineFft<Real>* column_fft_ = nullptr;
  std::shared_ptr<const KernelSpectrum<Real>> spectrum_;
  std::vector<RowFactors> factors_; ///< cosines and sines; none of a plane
};

} // namespace wrc
