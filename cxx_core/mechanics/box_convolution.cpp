#include "mechanics/box_convolution.hpp"

#include <algorithm>
#include <cstdlib>

#include "vector_clones.hpp"

namespace wrc {

namespace {

/// Rows that are transposed together: eight single-precision complex values fill a cache line.
constexpr std::size_t block_rows = 8;

template <typename Real>
WRC_VECTOR_BODY void multiply_body(Real* values, const Real* factors, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    values[2 * i] *= factors[i];
    values[2 * i + 1] *= factors[i];
  }
}

/// columns[k][r] = lines[r][k] for a block of rows, all as pairs of real numbers.
template <typename Real>
WRC_VECTOR_BODY void scatter_body(const Real* lines, std::size_t line_pitch, Real* columns,
                                  std::size_t column_pitch, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    Real* to = columns + 2 * k * column_pitch;
    const Real* from = lines + 2 * k;
    for (std::size_t r = 0; r < block_rows; ++r) {
      to[2 * r] = from[2 * r * line_pitch];
      to[2 * r + 1] = from[2 * r * line_pitch + 1];
    }
  }
}

template <typename Real>
WRC_VECTOR_BODY void gather_body(const Real* columns, std::size_t column_pitch, Real* lines,
                                 std::size_t line_pitch, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const Real* from = columns + 2 * k * column_pitch;
    Real* to = lines + 2 * k;
    for (std::size_t r = 0; r < block_rows; ++r) {
      to[2 * r * line_pitch] = from[2 * r];
      to[2 * r * line_pitch + 1] = from[2 * r + 1];
    }
  }
}

WRC_VECTOR_CLONES void multiply(float* values, const float* factors, std::size_t count) {
  multiply_body(values, factors, count);
}
WRC_VECTOR_CLONES void multiply(double* values, const double* factors, std::size_t count) {
  multiply_body(values, factors, count);
}
WRC_VECTOR_CLONES void scatter(const float* lines, std::size_t line_pitch, float* columns,
                               std::size_t column_pitch, std::size_t count) {
  scatter_body(lines, line_pitch, columns, column_pitch, count);
}
WRC_VECTOR_CLONES void scatter(const double* lines, std::size_t line_pitch, double* columns,
                               std::size_t column_pitch, std::size_t count) {
  scatter_body(lines, line_pitch, columns, column_pitch, count);
}
WRC_VECTOR_CLONES void gather(const float* columns, std::size_t column_pitch, float* lines,
                              std::size_t line_pitch, std::size_t count) {
  gather_body(columns, column_pitch, lines, line_pitch, count);
}
WRC_VECTOR_CLONES void gather(const double* columns, std::size_t column_pitch, double* lines,
                              std::size_t line_pitch, std::size_t count) {
  gather_body(columns, column_pitch, lines, line_pitch, count);
}

template <typename Value> void provide(AlignedArray<Value>& array, std::size_t size) {
  if (array.size() < size) {
    array = AlignedArray<Value>(size);
  }
}

/// Complex values as pairs of real ones, which the standard permits.
template <typename Real> Real* pairs_of(std::complex<Real>* values) {
  return reinterpret_cast<Real*>(values);
}

std::size_t line_length(std::size_t in, std::size_t out, std::ptrdiff_t offset) {
  const auto least = offset - (static_cast<std::ptrdiff_t>(in) - 1);
  const auto largest = offset + static_cast<std::ptrdiff_t>(out) - 1;
  const auto reach = static_cast<std::size_t>(std::max(std::abs(least), std::abs(largest)));
  return fast_line_length(2 * reach + 1);
}

} // namespace

template <typename Real>
BoxConvolution<Real> BoxConvolution<Real>::linear(const ConvolutionShape& shape, double aspect,
                                                  InfluenceCache& cache) {
  BoxConvolution result;
  result.shape_ = shape;
  const std::size_t rows = line_length(shape.rows_in, shape.rows_out, shape.row_offset);
  const std::size_t columns = line_length(shape.columns_in, shape.columns_out, shape.column_offset);
  result.spectrum_ = cache.spectrum<Real>(aspect, rows, columns);
  result.row_fft_ = &cache.real_line_fft<Real>(columns);
  result.column_fft_ = &cache.complex_line_fft<Real>(rows);
  return result;
}

template <typename Real>
BoxConvolution<Real> BoxConvolution<Real>::inverse_periodic(std::size_t rows, std::size_t columns,
                                                            double aspect, InfluenceCache& cache) {
  BoxConvolution result;
  result.shape_ = {rows, columns, rows, columns, 0, 0};
  const std::size_t row_period = fast_line_length(rows);
  const std::size_t column_period = fast_line_length(columns);
  result.spectrum_ = cache.inverse_spectrum<Real>(aspect, row_period, column_period);
  result.row_fft_ = &cache.real_line_fft<Real>(column_period);
  result.column_fft_ = &cache.complex_line_fft<Real>(row_period);
  return result;
}

template <typename Real>
void BoxConvolution<Real>::apply(const Real* in, Real* out,
                                 ConvolutionWorkspace<Real>& workspace) const {
  using Complex = std::complex<Real>;
  const std::size_t length = spectrum_->columns;
  const std::size_t spectral_length = length / 2 + 1;
  const std::size_t real_pitch = aligned_pitch<Real>(length);
  const std::size_t spectral_pitch = aligned_pitch<Complex>(spectral_length);
  const std::size_t most_rows = std::max(shape_.rows_in, shape_.rows_out);
  const std::size_t column_pitch =
      aligned_pitch<Complex>((most_rows + block_rows - 1) / block_rows * block_rows);
  provide(workspace.real_lines, block_rows * real_pitch);
  provide(workspace.spectral_lines, block_rows * spectral_pitch);
  provide(workspace.columns, spectral_length * column_pitch);
  provide(workspace.column_line, spectrum_->rows);
  provide(workspace.column_spectrum, spectrum_->rows);
  Real* real_lines = workspace.real_lines.data();
  Complex* spectral_lines = workspace.spectral_lines.data();
  Complex* columns = workspace.columns.data();

  std::fill_n(real_lines, block_rows * real_pitch, Real{0});
  for (std::size_t first = 0; first < shape_.rows_in; first += block_rows) {
    const std::size_t count = std::min(block_rows, shape_.rows_in - first);
    for (std::size_t row = 0; row < count; ++row) {
      std::copy_n(in + (first + row) * shape_.columns_in, shape_.columns_in,
                  real_lines + row * real_pitch);
      row_fft_->forward(real_lines + row * real_pitch, spectral_lines + row * spectral_pitch);
    }
    // Lines of an earlier block may stand beyond `count`; they go to rows that are not read.
    scatter(pairs_of(spectral_lines), spectral_pitch, pairs_of(columns + first), column_pitch,
            spectral_length);
  }

  Complex* line = workspace.column_line.data();
  Complex* line_spectrum = workspace.column_spectrum.data();
  for (std::size_t column = 0; column < spectral_length; ++column) {
    Complex* values = columns + column * column_pitch;
    std::copy_n(values, shape_.rows_in, line);
    std::fill(line + shape_.rows_in, line + spectrum_->rows, Complex{});
    column_fft_->forward(line, line_spectrum);
    multiply(pairs_of(line_spectrum), spectrum_->column(column), spectrum_->rows);
    column_fft_->backward(line_spectrum, line);
    // Displacements before the first pressure are found at the end of the period.
    const auto shift = static_cast<std::ptrdiff_t>(spectrum_->rows);
    const auto start = static_cast<std::size_t>((shape_.row_offset % shift + shift) % shift);
    const std::size_t until_end = std::min(shape_.rows_out, spectrum_->rows - start);
    std::copy_n(line + start, until_end, values);
    std::copy_n(line, shape_.rows_out - until_end, values + until_end);
  }

  const auto period = static_cast<std::ptrdiff_t>(length);
  const auto start = static_cast<std::size_t>((shape_.column_offset % period + period) % period);
  const std::size_t until_end = std::min(shape_.columns_out, length - start);
  for (std::size_t first = 0; first < shape_.rows_out; first += block_rows) {
    const std::size_t count = std::min(block_rows, shape_.rows_out - first);
    gather(pairs_of(columns + first), column_pitch, pairs_of(spectral_lines), spectral_pitch,
           spectral_length);
    for (std::size_t row = 0; row < count; ++row) {
      Real* values = real_lines + row * real_pitch;
      row_fft_->backward(spectral_lines + row * spectral_pitch, values);
      Real* target = out + (first + row) * shape_.columns_out;
      std::copy_n(values + start, until_end, target);
      std::copy_n(values, shape_.columns_out - until_end, target + until_end);
    }
  }
}

template class BoxConvolution<float>;
template class BoxConvolution<double>;

} // namespace wrc
