/// Influence coefficients and their spectra, computed once and kept.
///
/// Lengths are counted in longitudinal element steps, so that one table for elements of 1 x aspect
/// (influence_coefficients.hpp) serves grids of any size and every level of a cascade. A spectrum
/// belongs to a periodic convolution of rows x columns: the kernel is wrapped around with its true
/// coefficients at every place and even in both directions, so its spectrum is real. Divided by the
/// number of elements, since the transforms are not normalised.
/// Nothing kept here changes a result: asking again gives the same bits as computing anew.
/// Thread rule: one object serves one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "mechanics/fft.hpp"
#include "mechanics/influence_coefficients.hpp"

namespace wrc {

/// K[row * pitch + column] for offsets below `rows` and `columns`.
struct InfluenceTable {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;

  [[nodiscard]] const double* row(std::size_t index) const {
    return values.data() + index * columns;
  }
};

/// Spectrum of a periodic convolution, stored by column: values[column * pitch + row] for
/// column <= columns/2 and all rows.
template <typename Real> struct KernelSpectrum {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t pitch = 0;
  AlignedArray<Real> values;

  [[nodiscard]] const Real* column(std::size_t index) const {
    return values.data() + index * pitch;
  }
};

/// An aspect ratio without its last bits, so that grids whose steps were multiplied out with
/// different roundings share their influence coefficients.
double shared_aspect(double aspect);

class InfluenceCache {
public:
  explicit InfluenceCache(PlannerRigor rigor = PlannerRigor::estimate) : rigor_(rigor) {}

  template <typename Real> const LineFft<Real>& line_fft(std::size_t length);
  /// At least rows x columns offsets; valid until the next call for the same kernel.
  const InfluenceTable& table(const InfluenceKernel& kernel, std::size_t rows, std::size_t columns);
  template <typename Real>
  std::shared_ptr<const KernelSpectrum<Real>> spectrum(const InfluenceKernel& kernel,
                                                       std::size_t rows, std::size_t columns);
  /// The inverse of the spectrum, for use as a preconditioner.
  template <typename Real>
  std::shared_ptr<const KernelSpectrum<Real>>
  inverse_spectrum(const InfluenceKernel& kernel, std::size_t rows, std::size_t columns);

  /// Drops what was used longest ago, until no more than this is held, but nothing that was used
  /// since a time that now() has told. To be called between solutions.
  void trim(std::size_t bytes, std::uint64_t since);
  [[nodiscard]] std::uint64_t now() const { return clock_; }

private:
  enum class Content { direct, inverse };
  using SpectrumKey = std::tuple<InfluenceKernel, std::size_t, std::size_t, Content>;
  template <typename Item> struct Kept {
    Item item;
    std::size_t bytes;
    std::uint64_t last_use;
  };
  template <typename Real> struct Store {
    std::map<std::size_t, std::unique_ptr<LineFft<Real>>> line_ffts;
    std::map<SpectrumKey, Kept<std::shared_ptr<const KernelSpectrum<Real>>>> spectra;
  };

  template <typename Real> Store<Real>& store();
  template <typename Real>
  std::shared_ptr<const KernelSpectrum<Real>> spectrum_of(const SpectrumKey& key);
  template <typename Real>
  std::shared_ptr<const KernelSpectrum<Real>> compute_spectrum(const SpectrumKey& key);

  PlannerRigor rigor_;
  std::uint64_t clock_ = 0;
  std::size_t held_bytes_ = 0;
  Store<float> single_;
  Store<double> double_;
  std::map<InfluenceKernel, Kept<InfluenceTable>> tables_;
};

} // namespace wrc
