/// Products u = K q, by FFT or otherwise, with the floating-point operations that they take.
///
/// Operations are counted, not measured: 5 n log2 n for a complex transform of n values, two for a
/// multiplication and an addition. Thread rule: one object serves one thread at a time.
#pragma once

#include <cmath>
#include <cstddef>

#include "half_space/box_convolution.hpp"

namespace multigrid {

class Product {
public:
  Product() = default;
  Product(const Product&) = delete;
  Product& operator=(const Product&) = delete;
  virtual ~Product() = default;
  virtual void apply(const double* from, double* to) = 0;
  [[nodiscard]] virtual double operations() const = 0; ///< of one application
};

/// Of a convolution on rows x columns by lines of the lengths given (box_convolution.hpp): two rows
/// at a time as a complex line, half of the columns, forward and inverse.
inline double fft_operations(std::size_t rows, std::size_t row_length, std::size_t column_length) {
  const auto line = [](double n) { return 5.0 * n * std::log2(n); };
  const auto length = static_cast<double>(row_length);
  const auto height = static_cast<double>(column_length);
  return static_cast<double>(rows) * line(length) +
         (0.5 * length + 1.0) * (2.0 * line(height) + 2.0 * height);
}

/// The library's DC-FFT convolution, or its periodic inverse: the preconditioner.
class FftProduct : public Product {
public:
  enum class Kind { exact, periodic_inverse };
  FftProduct(std::size_t rows, std::size_t columns, const wrc::InfluenceKernel& kernel,
             wrc::InfluenceCache& cache, Kind kind)
      : convolution_(kind == Kind::exact ? wrc::BoxConvolution<double>::linear(
                                               {rows, columns, rows, columns, 0, 0}, kernel, cache)
                                         : wrc::BoxConvolution<double>::inverse_periodic(
                                               rows, columns, kernel, cache)),
        operations_(kind == Kind::exact ? exact_operations(rows, columns)
                                        : fft_operations(rows, columns, rows)) {}

  void apply(const double* from, double* to) override { convolution_.apply(from, to, workspace_); }
  [[nodiscard]] double operations() const override { return operations_; }
  static double exact_operations(std::size_t rows, std::size_t columns) {
    return fft_operations(rows, wrc::fast_line_length(2 * columns - 1),
                          wrc::fast_line_length(2 * rows - 1));
  }

private:
  wrc::BoxConvolution<double> convolution_;
  wrc::ConvolutionWorkspace<double> workspace_;
  double operations_;
};

} // namespace multigrid
