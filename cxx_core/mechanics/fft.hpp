/// Two-dimensional real fast Fourier transforms in double precision: the one file that sees FFTW.
///
/// Forward: F[k, l] = sum_{m, n} f[m, n] exp(-2 pi i (k m / rows + l n / columns)), kept for
/// l <= columns/2; backward is its conjugate sum, so that backward(forward(f)) = rows columns f
/// (FFTW 3 manual, "What FFTW Really Computes"). Plans are made with FFTW_ESTIMATE: cheap, and the
/// same on every call unless the process has loaded wisdom of its own.
/// Thread rule: planning takes a lock shared by the whole process, since only FFTW's execute is
/// thread-safe; one object serves one thread at a time, different objects are independent.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace wrc {

/// Least 2^a 3^b 5^c not below `least`; other lengths cost several times more.
std::size_t good_fft_length(std::size_t least);

/// Buffers and plans of one size, aligned for vector instructions.
class RealFft {
public:
  /// Throws Error(out_of_memory) when buffers or plans cannot be had.
  RealFft(std::size_t rows, std::size_t columns);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] std::size_t columns() const;
  /// columns/2 + 1, the length of a row of the spectrum.
  [[nodiscard]] std::size_t spectrum_columns() const;

  [[nodiscard]] std::span<double> field();
  [[nodiscard]] std::span<std::complex<double>> spectrum();

  void forward();  ///< field -> spectrum; the field is kept
  void backward(); ///< spectrum -> field, not normalised; the spectrum is lost

private:
  struct Resources;
  std::unique_ptr<Resources> resources_;
};

} // namespace wrc
