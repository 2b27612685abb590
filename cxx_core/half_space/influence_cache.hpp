/// Influence coefficients and their spectra, computed once and kept.
///
/// Lengths are counted in longitudinal element steps, so that one table for elements of 1 x aspect
/// (influence_coefficients.hpp) serves grids of any size and every level of a cascade. A spectrum
/// belongs to a periodic convolution of rows x columns: the kernel is wrapped around with its true
/// coefficients at every offset and even in both directions, so its spectrum is real. Divided by
/// the number of elements, since the transforms are not normalised. Nothing kept here changes a
/// result: a kept value has the same bits as a new one. Contacts of wheels have aspect ratios of
/// their own in every solution, so tables and spectra stay for two solutions only (a coarse and a
/// final one), for those who solve on the same grids again. Thread rule: LinePlans serve any number
/// of threads at once, an InfluenceCache one at a time. What was handed out stays valid when it is
/// dropped here.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "half_space/fft.hpp"
#include "half_space/influence_coefficients.hpp"

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

/// The transforms of lines by their length, with one rigor.
class LinePlans {
public:
  explicit LinePlans(PlannerRigor rigor = PlannerRigor::estimate) : rigor_(rigor) {}

  /// Kept as long as the process.
  template <typename Real> const LineFft<Real>& line_fft(std::size_t length) const {
    return wrc::line_fft<Real>(length, rigor_);
  }

private:
  PlannerRigor rigor_;
};

class InfluenceCache {
public:
  explicit InfluenceCache(PlannerRigor rigor = PlannerRigor::estimate)
      : InfluenceCache(std::make_shared<LinePlans>(rigor)) {}
  explicit InfluenceCache(std::shared_ptr<LinePlans> plans) : plans_(std::move(plans)) {}

  template <typename Real> const LineFft<Real>& line_fft(std::size_t length) {
    return plans_->line_fft<Real>(length);
  }
  /// At least rows x columns offsets.
  std::shared_ptr<const InfluenceTable> table(const InfluenceKernel& kernel, std::size_t rows,
                                              std::size_t columns);
  template <typename Real>
  std::shared_ptr<const KernelSpectrum<Real>> spectrum(const InfluenceKernel& kernel,
                                                       std::size_t rows, std::size_t columns) {
    return spectrum_of<Real>({kernel, rows, columns, Content::direct});
  }
  /// The inverse of the spectrum, for use as a preconditioner.
  template <typename Real>
  std::shared_ptr<const KernelSpectrum<Real>>
  inverse_spectrum(const InfluenceKernel& kernel, std::size_t rows, std::size_t columns) {
    return spectrum_of<Real>({kernel, rows, columns, Content::inverse});
  }

  /// Drops what has not been used since the call before the last one. To be called after each
  /// solution.
  void drop_unused();

private:
  enum class Content { direct, inverse };
  using SpectrumKey = std::tuple<InfluenceKernel, std::size_t, std::size_t, Content>;
  template <typename Item> struct Kept {
    std::shared_ptr<const Item> item;
    int unused = 0; ///< solutions since its last use
  };
  template <typename Real> using Spectra = std::map<SpectrumKey, Kept<KernelSpectrum<Real>>>;

  template <typename Real>
  std::shared_ptr<const KernelSpectrum<Real>> spectrum_of(const SpectrumKey& key);
  template <typename Real> KernelSpectrum<Real> compute_spectrum(const SpectrumKey& key);

  std::shared_ptr<LinePlans> plans_;
  std::tuple<Spectra<float>, Spectra<double>> spectra_;
  std::map<InfluenceKernel, Kept<InfluenceTable>> tables_;
};

} // namespace wrc
