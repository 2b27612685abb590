#include "half_space/traction_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/vector_clones.hpp"

namespace wrc {

namespace {

/// Columns that are gathered at a time.
/// origin: derived: a block of LineFft, so that short lines are transformed together.
constexpr std::size_t block_columns = block_lines;

std::size_t up_to_multiple(std::size_t value, std::size_t unit) {
  return (value + unit - 1) / unit * unit;
}

/// (first, conj second) <- (al first + be conj second, be' first + al conj second), as pairs of
/// real numbers.
template <typename Real>
WRC_VECTOR_BODY void multiply_body(Real* first, Real* second, const Real* al, const Real* be,
                                   const Real* be_mirrored, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < 2 * count; i += 2) {
    const Real u = first[i];
    const Real v = first[i + 1];
    const Real s = second[i];
    const Real t = -second[i + 1];
    first[i] = (al[i] * u - al[i + 1] * v) + (be[i] * s - be[i + 1] * t);
    first[i + 1] = (al[i] * v + al[i + 1] * u) + (be[i] * t + be[i + 1] * s);
    second[i] = (be_mirrored[i] * u - be_mirrored[i + 1] * v) + (al[i] * s - al[i + 1] * t);
    second[i + 1] = -(be_mirrored[i] * v + be_mirrored[i + 1] * u) - (al[i] * t + al[i + 1] * s);
  }
}

template <typename Real>
WRC_VECTOR_BODY void join_body(const Real* x, const Real* y, Real* line, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    line[2 * i] = x[i];
    line[2 * i + 1] = y[i];
  }
}

template <typename Real>
WRC_VECTOR_BODY void split_body(const Real* line, Real* x, Real* y, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = line[2 * i];
    y[i] = line[2 * i + 1];
  }
}

WRC_VECTOR_CLONES void multiply(float* first, float* second, const float* al, const float* be,
                                const float* mirrored, std::size_t count) {
  multiply_body(first, second, al, be, mirrored, count);
}
WRC_VECTOR_CLONES void multiply(double* first, double* second, const double* al, const double* be,
                                const double* mirrored, std::size_t count) {
  multiply_body(first, second, al, be, mirrored, count);
}
WRC_VECTOR_CLONES void join(const float* x, const float* y, float* line, std::size_t count) {
  join_body(x, y, line, count);
}
WRC_VECTOR_CLONES void join(const double* x, const double* y, double* line, std::size_t count) {
  join_body(x, y, line, count);
}
WRC_VECTOR_CLONES void split(const float* line, float* x, float* y, std::size_t count) {
  split_body(line, x, y, count);
}
WRC_VECTOR_CLONES void split(const double* line, double* x, double* y, std::size_t count) {
  split_body(line, x, y, count);
}

bool is_plane(std::span<const double> angles) {
  return std::ranges::all_of(angles, [&](double angle) { return angle == angles.front(); });
}

/// Lines of complex numbers, transformed in whole blocks.
template <typename Real> class SpectrumLines {
public:
  SpectrumLines(const LineFft<Real>& fft, std::size_t length, std::size_t count)
      : fft_(fft), pitch_(aligned_pitch<std::complex<Real>>(length)),
        count_(up_to_multiple(count, fft.best_count())), from_(count_ * pitch_),
        to_(count_ * pitch_) {
    std::fill_n(from_.data(), count_ * pitch_, std::complex<Real>{});
  }
  std::complex<Real>* line(std::size_t index) { return from_.data() + index * pitch_; }
  const std::complex<Real>* transformed(std::size_t index) { return to_.data() + index * pitch_; }
  void transform() { fft_.forward(from_.data(), to_.data(), count_); }

private:
  const LineFft<Real>& fft_;
  std::size_t pitch_;
  std::size_t count_;
  AlignedArray<std::complex<Real>> from_;
  AlignedArray<std::complex<Real>> to_;
};

/// al, be and be mirrored from the transforms of xx + i yy and of xy. The first holds xx and yy as
/// its Hermitian and its anti-Hermitian part; the second is -i times that of a real line.
template <typename Real>
void store_column(const std::complex<Real>* even, const std::complex<Real>* odd, std::size_t length,
                  std::complex<Real>* al, std::size_t pitch) {
  std::complex<Real>* be = al + pitch;
  std::complex<Real>* be_mirrored = be + pitch;
  for (std::size_t i = 0; i < length; ++i) {
    const std::complex<Real> one = even[i];
    const std::complex<Real> other = even[i == 0 ? 0 : length - i];
    const Real xx_re = Real(0.5) * (one.real() + other.real());
    const Real xx_im = Real(0.5) * (one.imag() - other.imag());
    const Real yy_re = Real(0.5) * (one.imag() + other.imag());
    const Real yy_im = Real(0.5) * (other.real() - one.real());
    const Real sum_re = Real(0.5) * (xx_re + yy_re);
    const Real sum_im = Real(0.5) * (xx_im + yy_im);
    const Real difference_re = Real(0.5) * (xx_re - yy_re);
    const Real difference_im = Real(0.5) * (xx_im - yy_im);
    const Real mixed_re = -odd[i].imag(); // i times odd
    const Real mixed_im = odd[i].real();
    al[i] = {sum_re, sum_im};
    be[i] = {difference_re + mixed_re, difference_im + mixed_im};
    be_mirrored[i] = {difference_re - mixed_re, difference_im - mixed_im};
  }
}

} // namespace

/// The weighted coefficients of all offsets, each component in lines of constant lateral offset:
/// offsets from -last to last upstream, contiguous.
class WeightedCoefficients {
public:
  WeightedCoefficients(const TractionShape& shape, double poisson, const DifferenceWeights& weights,
                       const TractionTable& table, TractionPart part)
      : WeightedCoefficients(shape) {
    const Mixture mixture = mixture_of(part, poisson);
    std::vector<double> weighted(2 * length_);
    double* along = weighted.data();
    double* across = along + length_;
    for (std::size_t aside = 0; aside < shape.columns; ++aside) {
      weigh(table.longitudinal(aside), 1.0, weights, along);
      weigh(table.lateral(aside), 1.0, weights, across);
      weigh(table.mixed(aside), -1.0, weights, component(2, aside));
      double* xx = component(0, aside);
      double* yy = component(1, aside);
      double* xy = component(2, aside);
      for (std::size_t i = 0; i < length_; ++i) {
        xx[i] = mixture.xx_along * along[i] + mixture.xx_across * across[i];
        yy[i] = mixture.yy_along * along[i] + mixture.yy_across * across[i];
        xy[i] *= mixture.mixed;
      }
    }
  }

  /// Coefficients of unlike bodies across directions: xx and xy.
  WeightedCoefficients(const TractionShape& shape, const DifferenceWeights& weights,
                       const CrossTable& table)
      : WeightedCoefficients(shape) {
    for (std::size_t aside = 0; aside < shape.columns; ++aside) {
      weigh(table.longitudinal(aside), -1.0, weights, component(0, aside));
      weigh(table.lateral(aside), 1.0, weights, component(2, aside));
    }
  }

  [[nodiscard]] double at(std::size_t index, std::ptrdiff_t downstream, std::size_t aside) const {
    const auto place = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(last_) - downstream);
    return values_[(3 * aside + index) * length_ + place];
  }

private:
  /// What the components consist of.
  struct Mixture {
    double xx_along;
    double xx_across;
    double yy_along;
    double yy_across;
    double mixed;
  };
  static Mixture mixture_of(TractionPart part, double poisson) {
    switch (part) {
    case TractionPart::fixed:
      return {1.0, 1.0 - poisson, 0.0, 0.5 * poisson, poisson};
    case TractionPart::turned:
      return {1.0 - poisson, 1.0 - 0.5 * poisson, 1.0 - poisson, 1.0 - 0.5 * poisson, 0.0};
    case TractionPart::mixed:
      return {0.0, 0.0, 0.0, 0.0, poisson};
    default:
      return {1.0, 1.0 - poisson, 1.0 - poisson, 1.0, poisson};
    }
  }

  explicit WeightedCoefficients(const TractionShape& shape)
      : last_(shape.rows - 1), length_(2 * shape.rows - 1), line_(length_ + difference_reach + 1),
        values_(3 * shape.columns * length_) {}
  /// Weighted sums of the values in `half`, and `sign` times that on the other side: from one
  /// offset downstream of the first to two upstream of the last.
  void weigh(const double* half, double sign, const DifferenceWeights& c, double* sums) {
    const std::size_t middle = last_ + 1;
    for (std::size_t i = 0; i < middle; ++i) {
      line_[i] = sign * half[middle - i];
    }
    std::copy_n(half, line_.size() - middle, line_.begin() + static_cast<std::ptrdiff_t>(middle));
    for (std::size_t i = 0; i < length_; ++i) {
      sums[i] = c[0] * line_[i] + c[1] * line_[i + 1] + c[2] * line_[i + 2] + c[3] * line_[i + 3];
    }
  }
  double* component(std::size_t index, std::size_t aside) {
    return values_.data() + (3 * aside + index) * length_;
  }

  std::size_t last_;
  std::size_t length_;
  std::vector<double> line_;
  std::vector<double> values_;
};

template <typename Real>
TractionConvolution<Real>::TractionConvolution(const TractionShape& shape, std::size_t pitch,
                                               double poisson, const DifferenceWeights& weights,
                                               const TractionTable& table, LinePlans& plans,
                                               std::span<const double> angles)
    : TractionConvolution(shape, pitch, poisson, weights, table, plans,
                          is_plane(angles) ? TractionPart::plane : TractionPart::fixed) {
  if (is_plane(angles)) {
    return;
  }
  turned_ = std::make_unique<TractionConvolution>(shape, pitch, poisson, weights, table, plans,
                                                  TractionPart::turned);
  self_[1] += turned_->self_[1];
  for (const double angle : angles) {
    cosines_.push_back(static_cast<Real>(std::cos(angle)));
    sines_.push_back(static_cast<Real>(std::sin(angle)));
  }
}

template <typename Real>
TractionConvolution<Real>::TractionConvolution(const TractionShape& shape, std::size_t pitch,
                                               double poisson, const DifferenceWeights& weights,
                                               const TractionTable& table, LinePlans& plans,
                                               TractionPart part)
    : TractionConvolution(shape, pitch, WeightedCoefficients(shape, poisson, weights, table, part),
                          plans) {}

template <typename Real>
TractionConvolution<Real>::TractionConvolution(const TractionShape& shape, std::size_t pitch,
                                               const DifferenceWeights& weights,
                                               const CrossTable& table, LinePlans& plans)
    : TractionConvolution(shape, pitch, WeightedCoefficients(shape, weights, table), plans) {}

template <typename Real>
TractionConvolution<Real>::TractionConvolution(const TractionShape& shape, std::size_t pitch,
                                               const WeightedCoefficients& coefficients,
                                               LinePlans& plans)
    : shape_(shape), pitch_(pitch), row_period_(fast_line_length(2 * shape.columns - 1)),
      column_period_(fast_line_length(2 * shape.rows - 1)),
      spectrum_pitch_(aligned_pitch<Complex>(column_period_)),
      row_fft_(&plans.line_fft<Real>(row_period_)),
      column_fft_(&plans.line_fft<Real>(column_period_)),
      spectrum_(3 * (row_period_ / 2 + 1) * spectrum_pitch_) {
  fill_spectrum(coefficients, plans);
}

// Along y the coefficients xx and yy are even and xy is odd: the line xx + xy + i yy gives the
// transforms of xx and yy as the real and the imaginary part of its even part, and that of xy,
// imaginary, as its odd part.
template <typename Real>
void TractionConvolution<Real>::fill_spectrum(const WeightedCoefficients& coefficients,
                                              LinePlans& plans) {
  const double scale = 1.0 / (std::numbers::pi * static_cast<double>(row_period_ * column_period_));
  self_ = {coefficients.at(0, 0, 0) / std::numbers::pi,
           coefficients.at(1, 0, 0) / std::numbers::pi};

  const auto last = static_cast<std::ptrdiff_t>(shape_.rows) - 1;
  const std::size_t row_count = 2 * shape_.rows - 1;
  SpectrumLines<Real> rows(plans.line_fft<Real>(row_period_), row_period_, row_count);
  for (std::size_t row = 0; row < row_count; ++row) {
    const std::ptrdiff_t downstream = static_cast<std::ptrdiff_t>(row) - last;
    Complex* line = rows.line(row);
    for (std::size_t aside = 0; aside < shape_.columns; ++aside) {
      const auto xx = static_cast<Real>(scale * coefficients.at(0, downstream, aside));
      const auto yy = static_cast<Real>(scale * coefficients.at(1, downstream, aside));
      const auto xy = static_cast<Real>(scale * coefficients.at(2, downstream, aside));
      if (aside > 0) {
        line[row_period_ - aside] = {xx - xy, yy};
      }
      line[aside] = {xx + xy, yy};
    }
  }
  rows.transform();

  // Some columns at a time, each as what is even and what is odd along y.
  const std::size_t half = row_period_ / 2 + 1;
  SpectrumLines<Real> columns(plans.line_fft<Real>(column_period_), column_period_,
                              2 * block_columns);
  for (std::size_t first = 0; first < half; first += block_columns) {
    const std::size_t count = std::min(block_columns, half - first);
    for (std::size_t row = 0; row < row_count; ++row) {
      const std::ptrdiff_t downstream = static_cast<std::ptrdiff_t>(row) - last;
      const auto place = static_cast<std::size_t>(
          downstream < 0 ? downstream + static_cast<std::ptrdiff_t>(column_period_) : downstream);
      const Complex* line = rows.transformed(row);
      for (std::size_t k = 0; k < count; ++k) {
        const Complex one = line[first + k];
        const Complex mirrored = line[first + k == 0 ? 0 : row_period_ - (first + k)];
        columns.line(2 * k)[place] = Real(0.5) * (one + mirrored);
        columns.line(2 * k + 1)[place] = Real(0.5) * (one - mirrored);
      }
    }
    columns.transform();
    for (std::size_t k = 0; k < count; ++k) {
      store_column(columns.transformed(2 * k), columns.transformed(2 * k + 1), column_period_,
                   spectrum_.data() + 3 * (first + k) * spectrum_pitch_, spectrum_pitch_);
    }
  }
}

template <typename Real>
void TractionConvolution<Real>::transform_columns(Complex* rows, std::size_t row_pitch,
                                                  ConvolutionWorkspace<Real>& workspace) const {
  const std::size_t pitch = aligned_pitch<Complex>(column_period_);
  provide(workspace.column_lines, 2 * block_columns * pitch);
  provide(workspace.column_spectra, 2 * block_columns * pitch);
  Complex* lines = workspace.column_lines.data();
  Complex* mirrored_lines = lines + block_columns * pitch;
  Complex* spectra = workspace.column_spectra.data();
  Complex* mirrored_spectra = spectra + block_columns * pitch;
  const std::size_t half = row_period_ / 2 + 1;
  const auto mirrored = [&](std::size_t k) { return k == 0 ? 0 : row_period_ - k; };

  for (std::size_t first = 0; first < half; first += block_columns) {
    const std::size_t count = std::min(block_columns, half - first);
    for (std::size_t k = 0; k < block_columns; ++k) {
      Complex* line = lines + k * pitch;
      Complex* mirrored_line = mirrored_lines + k * pitch;
      const std::size_t used = k < count ? shape_.rows : 0;
      for (std::size_t i = 0; i < used; ++i) {
        const Complex* row = rows + i * row_pitch;
        line[i] = row[first + k];
        mirrored_line[i] = row[mirrored(first + k)];
      }
      std::fill(line + used, line + column_period_, Complex{});
      std::fill(mirrored_line + used, mirrored_line + column_period_, Complex{});
    }
    column_fft_->forward(lines, spectra, count);
    column_fft_->backward(mirrored_lines, mirrored_spectra, count);
    for (std::size_t k = 0; k < count; ++k) {
      const Complex* al = spectrum_.data() + 3 * (first + k) * spectrum_pitch_;
      multiply(pairs_of(spectra + k * pitch), pairs_of(mirrored_spectra + k * pitch), pairs_of(al),
               pairs_of(al + spectrum_pitch_), pairs_of(al + 2 * spectrum_pitch_), column_period_);
    }
    column_fft_->backward(spectra, lines, count);
    column_fft_->forward(mirrored_spectra, mirrored_lines, count);
    for (std::size_t i = 0; i < shape_.rows; ++i) {
      Complex* row = rows + i * row_pitch;
      for (std::size_t k = 0; k < count; ++k) {
        row[mirrored(first + k)] = mirrored_lines[k * pitch + i];
        row[first + k] = lines[k * pitch + i];
      }
    }
  }
}

template <typename Real>
void TractionConvolution<Real>::apply(const Real* in_x, const Real* in_y, Real* out_x, Real* out_y,
                                      ConvolutionWorkspace<Real>& workspace) const {
  if (!turned_) {
    convolve(in_x, in_y, out_x, out_y, workspace);
    return;
  }
  // C m C + S m S, both at once.
  provide(workspace.turned, 2 * shape_.rows * pitch_);
  Real* by_cosine = workspace.turned.data();
  Real* by_sine = by_cosine + shape_.rows * pitch_;
  for (std::size_t i = 0; i < shape_.rows; ++i) {
    for (std::size_t j = 0; j < shape_.columns; ++j) {
      const std::size_t at = i * pitch_ + j;
      by_cosine[at] = cosines_[j] * in_y[at];
      by_sine[at] = sines_[j] * in_y[at];
    }
  }
  turned_->convolve(by_cosine, by_sine, by_cosine, by_sine, workspace);
  convolve(in_x, in_y, out_x, out_y, workspace);
  for (std::size_t i = 0; i < shape_.rows; ++i) {
    for (std::size_t j = 0; j < shape_.columns; ++j) {
      const std::size_t at = i * pitch_ + j;
      out_y[at] += cosines_[j] * by_cosine[at] + sines_[j] * by_sine[at];
    }
  }
}

template <typename Real>
void TractionConvolution<Real>::convolve(const Real* in_x, const Real* in_y, Real* out_x,
                                         Real* out_y, ConvolutionWorkspace<Real>& workspace) const {
  const std::size_t pitch = aligned_pitch<Complex>(row_period_);
  const std::size_t rows = up_to_multiple(shape_.rows, row_fft_->best_count());
  provide(workspace.lines, rows * pitch);
  provide(workspace.columns, rows * pitch);
  Complex* lines = workspace.lines.data();
  Complex* spectra = workspace.columns.data();
  for (std::size_t i = 0; i < rows; ++i) {
    Complex* line = lines + i * pitch;
    const std::size_t used = i < shape_.rows ? shape_.columns : 0;
    if (used > 0) {
      join(in_x + i * pitch_, in_y + i * pitch_, pairs_of(line), used);
    }
    std::fill(line + used, line + row_period_, Complex{});
  }
  row_fft_->forward(lines, spectra, rows);
  transform_columns(spectra, pitch, workspace);
  row_fft_->backward(spectra, lines, rows);
  for (std::size_t i = 0; i < shape_.rows; ++i) {
    split(pairs_of(lines + i * pitch), out_x + i * pitch_, out_y + i * pitch_, shape_.columns);
  }
}

template class TractionConvolution<float>;
template class TractionConvolution<double>;

} // namespace wrc
