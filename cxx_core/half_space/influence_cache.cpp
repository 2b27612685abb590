#include "half_space/influence_cache.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {

namespace {

/// Spectra of real even lines, lines[k * pitch + i] for i <= length/2. They are real and even, so
/// that two lines make one complex transform, one as its real and one as its imaginary part.
/// Calls put(k, i, value) for i <= length/2.
template <class Put>
void transform_even_lines(const LineFft<double>& fft, std::size_t length, const double* lines,
                          std::size_t pitch, std::size_t count, const Put& put) {
  using Complex = std::complex<double>;
  const std::size_t half = length / 2;
  const std::size_t block = fft.best_count();
  const std::size_t line_pitch = aligned_pitch<Complex>(length);
  AlignedArray<Complex> buffer(2 * block * line_pitch);
  Complex* from = buffer.data();
  Complex* to = from + block * line_pitch;
  for (std::size_t first = 0; first < count; first += 2 * block) {
    for (std::size_t k = 0; k < block; ++k) {
      // Positions without a line repeat the last one.
      const double* one = lines + std::min(first + 2 * k, count - 1) * pitch;
      const double* other = lines + std::min(first + 2 * k + 1, count - 1) * pitch;
      Complex* line = from + k * line_pitch;
      for (std::size_t i = 0; i <= half; ++i) {
        line[i] = {one[i], other[i]};
      }
      std::reverse_copy(line + 1, line + (length - half), line + half + 1);
    }
    fft.forward(from, to, block);
    for (std::size_t k = 0; k < block && first + 2 * k < count; ++k) {
      const bool pair = first + 2 * k + 1 < count;
      for (std::size_t i = 0; i <= half; ++i) {
        put(first + 2 * k, i, to[k * line_pitch + i].real());
        if (pair) {
          put(first + 2 * k + 1, i, to[k * line_pitch + i].imag());
        }
      }
    }
  }
}

} // namespace

std::shared_ptr<const InfluenceTable> InfluenceCache::table(const InfluenceKernel& kernel,
                                                            std::size_t rows, std::size_t columns) {
  const auto found = tables_.find(kernel);
  const InfluenceTable* kept = found == tables_.end() ? nullptr : found->second.item.get();
  if (kept != nullptr && kept->rows >= rows && kept->columns >= columns) {
    found->second.unused = 0;
    return found->second.item;
  }
  auto table = std::make_shared<InfluenceTable>();
  table->rows = std::max(rows, kept != nullptr ? kept->rows : 0);
  table->columns = std::max(columns, kept != nullptr ? kept->columns : 0);
  table->values.resize(table->rows * table->columns);
  fill_influence_table(kernel, table->rows, table->columns, table->values);
  return (tables_[kernel] = {std::move(table)}).item;
}

template <typename Real>
KernelSpectrum<Real> InfluenceCache::compute_spectrum(const SpectrumKey& key) {
  const auto& [kernel, rows, columns, content] = key;
  const std::size_t half_rows = rows / 2;
  const std::size_t half_columns = columns / 2;
  const auto influence = table(kernel, half_rows + 1, half_columns + 1);

  // By column: half[column * half_pitch + row].
  const std::size_t half_pitch = half_rows + 1;
  std::vector<double> half((half_columns + 1) * half_pitch);
  transform_even_lines(line_fft<double>(columns), columns, influence->values.data(),
                       influence->columns, half_rows + 1,
                       [&](std::size_t row, std::size_t column, double value) {
                         half[column * half_pitch + row] = value;
                       });
  KernelSpectrum<Real> spectrum;
  spectrum.rows = rows;
  spectrum.columns = columns;
  spectrum.pitch = aligned_pitch<Real>(rows);
  spectrum.values = AlignedArray<Real>(spectrum.pitch * (half_columns + 1));
  const double share = 1.0 / (static_cast<double>(rows) * static_cast<double>(columns));
  const bool inverse = content == Content::inverse;
  transform_even_lines(line_fft<double>(rows), rows, half.data(), half_pitch, half_columns + 1,
                       [&, rows = rows](std::size_t column, std::size_t row, double value) {
                         Real* values = spectrum.values.data() + column * spectrum.pitch;
                         values[row] = static_cast<Real>(inverse ? share / value : value * share);
                         values[row == 0 ? 0 : rows - row] = values[row];
                       });
  return spectrum;
}

template <typename Real>
std::shared_ptr<const KernelSpectrum<Real>> InfluenceCache::spectrum_of(const SpectrumKey& key) {
  auto& spectra = std::get<Spectra<Real>>(spectra_);
  auto found = spectra.find(key);
  if (found == spectra.end()) {
    auto spectrum = std::make_shared<const KernelSpectrum<Real>>(compute_spectrum<Real>(key));
    found = spectra.emplace(key, Kept<KernelSpectrum<Real>>{std::move(spectrum)}).first;
  }
  found->second.unused = 0;
  return found->second.item;
}

void InfluenceCache::drop_unused() {
  const auto drop = [](auto& kept) {
    std::erase_if(kept, [](const auto& entry) { return entry.second.unused > 1; });
    for (auto& entry : kept) {
      ++entry.second.unused;
    }
  };
  drop(tables_);
  drop(std::get<Spectra<float>>(spectra_));
  drop(std::get<Spectra<double>>(spectra_));
}

double shared_aspect(double aspect) {
  constexpr double bits = 0x1p48;
  int exponent = 0;
  const double fraction = std::frexp(aspect, &exponent);
  return std::ldexp(std::nearbyint(fraction * bits) / bits, exponent);
}

template std::shared_ptr<const KernelSpectrum<float>>
InfluenceCache::spectrum_of<float>(const SpectrumKey&);
template std::shared_ptr<const KernelSpectrum<double>>
InfluenceCache::spectrum_of<double>(const SpectrumKey&);

} // namespace wrc
