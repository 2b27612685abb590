#include "half_space/box_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "base/vector_clones.hpp"
#include "half_space/constants.hpp"

namespace wrc {

namespace {

static_assert(transposed_rows / 2 == block_lines);

template <typename Real>
WRC_VECTOR_BODY void multiply_body(Real* values, const Real* factors, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    values[2 * i] *= factors[i];
    values[2 * i + 1] *= factors[i];
  }
}

/// Two real rows as the real and the imaginary part of a complex line.
template <typename Real>
WRC_VECTOR_BODY void interleave_body(const Real* first, const Real* second, Real* line,
                                     std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    line[2 * i] = first[i];
    line[2 * i + 1] = second[i];
  }
}

template <typename Real>
WRC_VECTOR_BODY void separate_body(const Real* line, Real* first, Real* second, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    first[i] = line[2 * i];
    second[i] = line[2 * i + 1];
  }
}

/// Spectra A, B of two real rows from that of their pair, Z = A + i B, into the columns: A[k] =
/// (Z[k] + conj Z[n - k]) / 2, B[k] = (Z[k] - conj Z[n - k]) / (2 i). All as pairs of real numbers;
/// Z[n] is Z[0].
template <typename Real>
WRC_VECTOR_BODY void scatter_body(const Real* lines, std::size_t line_pitch, std::size_t length,
                                  Real* columns, std::size_t column_pitch, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t mirrored = k == 0 ? 0 : length - k;
    Real* to = columns + 2 * k * column_pitch;
    for (std::size_t pair = 0; pair < transposed_rows / 2; ++pair) {
      const Real* z = lines + 2 * pair * line_pitch;
      const Real x = z[2 * k];
      const Real y = z[2 * k + 1];
      const Real u = z[2 * mirrored];
      const Real v = z[2 * mirrored + 1];
      to[4 * pair] = Real(0.5) * (x + u);
      to[4 * pair + 1] = Real(0.5) * (y - v);
      to[4 * pair + 2] = Real(0.5) * (y + v);
      to[4 * pair + 3] = Real(0.5) * (u - x);
    }
  }
}

/// The way back: Z[k] = A[k] + i B[k] and Z[n - k] = conj A[k] + i conj B[k].
template <typename Real>
WRC_VECTOR_BODY void gather_body(const Real* columns, std::size_t column_pitch, Real* lines,
                                 std::size_t line_pitch, std::size_t length, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t mirrored = k == 0 ? 0 : length - k;
    const Real* from = columns + 2 * k * column_pitch;
    for (std::size_t pair = 0; pair < transposed_rows / 2; ++pair) {
      const Real a = from[4 * pair];
      const Real b = from[4 * pair + 1];
      const Real c = from[4 * pair + 2];
      const Real d = from[4 * pair + 3];
      Real* z = lines + 2 * pair * line_pitch;
      z[2 * mirrored] = a + d;
      z[2 * mirrored + 1] = c - b;
      z[2 * k] = a - d;
      z[2 * k + 1] = b + c;
    }
  }
}

WRC_VECTOR_CLONES void multiply(float* values, const float* factors, std::size_t count) {
  multiply_body(values, factors, count);
}
WRC_VECTOR_CLONES void multiply(double* values, const double* factors, std::size_t count) {
  multiply_body(values, factors, count);
}
WRC_VECTOR_CLONES void interleave(const float* first, const float* second, float* line,
                                  std::size_t count) {
  interleave_body(first, second, line, count);
}
WRC_VECTOR_CLONES void separate(const float* line, float* first, float* second, std::size_t count) {
  separate_body(line, first, second, count);
}
WRC_VECTOR_CLONES void scatter(const float* lines, std::size_t line_pitch, std::size_t length,
                               float* columns, std::size_t column_pitch, std::size_t count) {
  scatter_body(lines, line_pitch, length, columns, column_pitch, count);
}
WRC_VECTOR_CLONES void gather(const float* columns, std::size_t column_pitch, float* lines,
                              std::size_t line_pitch, std::size_t length, std::size_t count) {
  gather_body(columns, column_pitch, lines, line_pitch, length, count);
}
WRC_VECTOR_CLONES void interleave(const double* first, const double* second, double* line,
                                  std::size_t count) {
  interleave_body(first, second, line, count);
}
WRC_VECTOR_CLONES void separate(const double* line, double* first, double* second,
                                std::size_t count) {
  separate_body(line, first, second, count);
}
WRC_VECTOR_CLONES void scatter(const double* lines, std::size_t line_pitch, std::size_t length,
                               double* columns, std::size_t column_pitch, std::size_t count) {
  scatter_body(lines, line_pitch, length, columns, column_pitch, count);
}
WRC_VECTOR_CLONES void gather(const double* columns, std::size_t column_pitch, double* lines,
                              std::size_t line_pitch, std::size_t length, std::size_t count) {
  gather_body(columns, column_pitch, lines, line_pitch, length, count);
}

std::size_t line_length(std::size_t in, std::size_t out, std::ptrdiff_t offset) {
  const auto least = offset - (static_cast<std::ptrdiff_t>(in) - 1);
  const auto largest = offset + static_cast<std::ptrdiff_t>(out) - 1;
  const auto reach = static_cast<std::size_t>(std::max(std::abs(least), std::abs(largest)));
  return fast_line_length(2 * reach + 1);
}

bool is_plane(const RowAngles& angles) {
  const auto is_first = [&angles](double angle) { return angle == angles.in.front(); };
  return angles.in.empty() ||
         (std::ranges::all_of(angles.in, is_first) && std::ranges::all_of(angles.out, is_first));
}

template <typename Real>
std::vector<Real> factors_of(std::span<const double> angles, double (*function)(double)) {
  std::vector<Real> factors(angles.size());
  std::ranges::transform(angles, factors.begin(),
                         [&](double angle) { return static_cast<Real>(function(angle)); });
  return factors;
}

template <typename Real>
void multiply_rows(const std::vector<Real>& factors, std::size_t columns, const Real* from,
                   Real* to) {
  for (const Real factor : factors) {
    std::transform(from, from + columns, to, [factor](Real value) { return factor * value; });
    from += columns;
    to += columns;
  }
}

} // namespace

template <typename Real>
BoxConvolution<Real> BoxConvolution<Real>::linear(const ConvolutionShape& shape,
                                                  const InfluenceKernel& kernel,
                                                  InfluenceCache& cache, const RowAngles& angles) {
  BoxConvolution result;
  result.shape_ = shape;
  if (!is_plane(angles)) {
    const auto add = [&](double (*function)(double)) {
      result.factors_.push_back(
          {factors_of<Real>(angles.in, function), factors_of<Real>(angles.out, function)});
    };
    add([](double angle) { return std::cos(angle); });
    add([](double angle) { return std::sin(angle); });
  }
  const std::size_t rows = line_length(shape.rows_in, shape.rows_out, shape.row_offset);
  const std::size_t columns = line_length(shape.columns_in, shape.columns_out, shape.column_offset);
  result.spectrum_ = cache.spectrum<Real>(kernel, rows, columns);
  result.row_fft_ = &cache.line_fft<Real>(columns);
  result.column_fft_ = &cache.line_fft<Real>(rows);
  return result;
}

template <typename Real>
BoxConvolution<Real> BoxConvolution<Real>::inverse_periodic(std::size_t rows, std::size_t columns,
                                                            const InfluenceKernel& kernel,
                                                            InfluenceCache& cache) {
  BoxConvolution result;
  result.shape_ = {rows, columns, rows, columns, 0, 0};
  const std::size_t row_period = fast_line_length(rows);
  const std::size_t column_period = fast_line_length(columns);
  result.spectrum_ = cache.inverse_spectrum<Real>(kernel, row_period, column_period);
  result.row_fft_ = &cache.line_fft<Real>(column_period);
  result.column_fft_ = &cache.line_fft<Real>(row_period);
  return result;
}

/// What the three steps of one convolution share. Rows in pairs are lines; `columns` holds the
/// spectra of the rows, and then of the rows out, column by column.
template <typename Real> struct BoxConvolution<Real>::Lines {
  std::size_t length;          ///< of a line of rows
  std::size_t spectral_length; ///< of it
  std::size_t line_pitch;
  std::size_t column_pitch;
  Complex* lines;
  Complex* spectral_lines;
  Complex* columns;
};

template <typename Real>
void BoxConvolution<Real>::apply(const Real* in, Real* out,
                                 ConvolutionWorkspace<Real>& workspace) const {
  if (factors_.empty()) {
    convolve(in, out, workspace);
    return;
  }
  const std::size_t count = shape_.rows_out * shape_.columns_out;
  provide(workspace.turned, std::max(shape_.rows_in * shape_.columns_in, count));
  provide(workspace.sum, count);
  Real* turned = workspace.turned.data();
  Real* sum = workspace.sum.data();
  std::fill_n(sum, count, Real{0});
  for (const RowFactors& factors : factors_) {
    multiply_rows(factors.in, shape_.columns_in, in, turned);
    convolve(turned, turned, workspace);
    multiply_rows(factors.out, shape_.columns_out, turned, turned);
    std::transform(sum, sum + count, turned, sum, std::plus<>());
  }
  std::copy_n(sum, count, out);
}

template <typename Real>
void BoxConvolution<Real>::convolve(const Real* in, Real* out,
                                    ConvolutionWorkspace<Real>& workspace) const {
  const std::size_t length = spectrum_->columns;
  const std::size_t spectral_length = length / 2 + 1;
  const std::size_t line_pitch = aligned_pitch<Complex>(length);
  const std::size_t max_rows = std::max(shape_.rows_in, shape_.rows_out);
  const std::size_t column_pitch =
      aligned_pitch<Complex>((max_rows + transposed_rows - 1) / transposed_rows * transposed_rows);
  provide(workspace.lines, transposed_rows / 2 * line_pitch);
  provide(workspace.spectral_lines, transposed_rows / 2 * line_pitch);
  provide(workspace.columns, spectral_length * column_pitch);
  const Lines lines{length,
                    spectral_length,
                    line_pitch,
                    column_pitch,
                    workspace.lines.data(),
                    workspace.spectral_lines.data(),
                    workspace.columns.data()};
  transform_rows(in, lines);
  convolve_columns(lines, workspace);
  transform_rows_back(lines, out);
}

template <typename Real>
void BoxConvolution<Real>::transform_rows(const Real* in, const Lines& to) const {
  for (std::size_t pair = 0; pair < transposed_rows / 2; ++pair) {
    std::fill_n(to.lines + pair * to.line_pitch, to.length, Complex{});
  }
  for (std::size_t first = 0; first < shape_.rows_in; first += transposed_rows) {
    const std::size_t end = std::min(first + transposed_rows, shape_.rows_in);
    for (std::size_t row = first; row < first + transposed_rows; row += 2) {
      Complex* pair_line = to.lines + (row - first) / 2 * to.line_pitch;
      if (row + 1 < end) {
        interleave(in + row * shape_.columns_in, in + (row + 1) * shape_.columns_in,
                   pairs_of(pair_line), shape_.columns_in);
      } else {
        std::fill_n(pair_line, shape_.columns_in, Complex{});
        if (row < end) {
          std::copy_n(in + row * shape_.columns_in, shape_.columns_in, pair_line);
        }
      }
    }
    row_fft_->forward(to.lines, to.spectral_lines, transposed_rows / 2);
    scatter(pairs_of(to.spectral_lines), to.line_pitch, to.length, pairs_of(to.columns + first),
            to.column_pitch, to.spectral_length);
  }
}

template <typename Real>
void BoxConvolution<Real>::convolve_columns(const Lines& at,
                                            ConvolutionWorkspace<Real>& workspace) const {
  const std::size_t group = column_fft_->best_count();
  const std::size_t group_pitch = aligned_pitch<Complex>(spectrum_->rows);
  provide(workspace.column_lines, group * group_pitch);
  provide(workspace.column_spectra, group * group_pitch);
  const std::size_t padded_rows =
      (shape_.rows_out + transposed_rows - 1) / transposed_rows * transposed_rows;
  // Displacements before the first pressure are found at the end of the period.
  const auto shift = static_cast<std::ptrdiff_t>(spectrum_->rows);
  const auto first_out = static_cast<std::size_t>((shape_.row_offset % shift + shift) % shift);
  const std::size_t rows_until_end = std::min(shape_.rows_out, spectrum_->rows - first_out);
  for (std::size_t first = 0; first < at.spectral_length; first += group) {
    const std::size_t count = std::min(group, at.spectral_length - first);
    for (std::size_t k = 0; k < count; ++k) {
      Complex* line = workspace.column_lines.data() + k * group_pitch;
      std::copy_n(at.columns + (first + k) * at.column_pitch, shape_.rows_in, line);
      std::fill(line + shape_.rows_in, line + spectrum_->rows, Complex{});
    }
    for (std::size_t k = count; k < group; ++k) { // a block that is not full
      std::fill_n(workspace.column_lines.data() + k * group_pitch, spectrum_->rows, Complex{});
    }
    column_fft_->forward(workspace.column_lines.data(), workspace.column_spectra.data(), count);
    for (std::size_t k = 0; k < count; ++k) {
      multiply(pairs_of(workspace.column_spectra.data() + k * group_pitch),
               spectrum_->column(first + k), spectrum_->rows);
    }
    column_fft_->backward(workspace.column_spectra.data(), workspace.column_lines.data(), count);
    for (std::size_t k = 0; k < count; ++k) {
      const Complex* line = workspace.column_lines.data() + k * group_pitch;
      Complex* values = at.columns + (first + k) * at.column_pitch;
      std::copy_n(line + first_out, rows_until_end, values);
      std::copy_n(line, shape_.rows_out - rows_until_end, values + rows_until_end);
      // A row without partner is paired with nothing.
      std::fill(values + shape_.rows_out, values + padded_rows, Complex{});
    }
  }
}

template <typename Real>
void BoxConvolution<Real>::transform_rows_back(const Lines& from, Real* out) const {
  const auto period = static_cast<std::ptrdiff_t>(from.length);
  const auto start = static_cast<std::size_t>((shape_.column_offset % period + period) % period);
  const std::size_t until_end = std::min(shape_.columns_out, from.length - start);
  for (std::size_t first = 0; first < shape_.rows_out; first += transposed_rows) {
    const std::size_t last = std::min(first + transposed_rows, shape_.rows_out);
    gather(pairs_of(from.columns + first), from.column_pitch, pairs_of(from.spectral_lines),
           from.line_pitch, from.length, from.spectral_length);
    row_fft_->backward(from.spectral_lines, from.lines, (last - first + 1) / 2);
    for (std::size_t row = first; row < last; row += 2) {
      const Complex* values = from.lines + (row - first) / 2 * from.line_pitch;
      Real* target = out + row * shape_.columns_out;
      if (row + 1 < last) {
        Real* next = target + shape_.columns_out;
        separate(pairs_of(values + start), target, next, until_end);
        separate(pairs_of(values), target + until_end, next + until_end,
                 shape_.columns_out - until_end);
      } else {
        const auto real_part = [](const Complex& value) { return value.real(); };
        std::transform(values + start, values + start + until_end, target, real_part);
        std::transform(values, values + (shape_.columns_out - until_end), target + until_end,
                       real_part);
      }
    }
  }
}

template class BoxConvolution<float>;
template class BoxConvolution<double>;

} // namespace wrc
