/// Convolution with the influence coefficients between two rectangles of elements, pruned.
///
///   out[i, j] = sum_{k, l} K[i + row_offset - k, j + column_offset - l] in[k, l]
/// by transforms of lines: rows first, two at a time as one complex line, then columns, each
/// multiplied with the kernel's spectrum and transformed back while it is in cache, then the rows
/// requested. A line's length is at least twice the largest offset + 1, which makes the convolution
/// exact and linear (Liu, Wang & Liu, Wear 243 (2000) 101-111), or, for `periodic`, the rectangle
/// itself. In units of influence_cache.hpp: lengths in longitudinal steps, u = K p. Errors are
/// those of the precision, relative to the largest value. Does not handle gaps or contact. Thread
/// rule: one workspace serves one thread at a time; convolutions hold no state.
#pragma once

#include <cstddef>
#include <memory>
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

template <typename Real> class BoxConvolution {
public:
  BoxConvolution() = default;
  /// u = K p from a rectangle to another.
  static BoxConvolution linear(const ConvolutionShape& shape, const InfluenceKernel& kernel,
                               InfluenceCache& cache);
  /// The inverse of the periodic convolution on a rectangle, as a preconditioner.
  static BoxConvolution inverse_periodic(std::size_t rows, std::size_t columns,
                                         const InfluenceKernel& kernel, InfluenceCache& cache);

  /// Rows of `in` and `out` follow each other without gaps; the two may be the same array.
  void apply(const Real* in, Real* out, ConvolutionWorkspace<Real>& workspace) const;

private:
  using Complex = std::complex<Real>;
  struct Lines;

  void transform_rows(const Real* in, const Lines& to) const;
  void convolve_columns(const Lines& at, ConvolutionWorkspace<Real>& workspace) const;
  void transform_rows_back(const Lines& from, Real* out) const;

  ConvolutionShape shape_;
  const LineFft<Real>* row_fft_ = nullptr;
  const LineFft<Real>* column_fft_ = nullptr;
  std::shared_ptr<const KernelSpectrum<Real>> spectrum_;
};

} // namespace wrc
