#include "mechanics/influence_cache.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc {

template <> InfluenceCache::Store<float>& InfluenceCache::store<float>() {
  return single_;
}
template <> InfluenceCache::Store<double>& InfluenceCache::store<double>() {
  return double_;
}

namespace {

/// The transform of a length, made when it is first asked for.
template <class Fft>
const Fft& fft_of(std::map<std::size_t, std::unique_ptr<Fft>>& kept, std::size_t length,
                  PlannerRigor rigor) {
  auto found = kept.find(length);
  if (found == kept.end()) {
    found = kept.emplace(length, std::make_unique<Fft>(length, rigor)).first;
  }
  return *found->second;
}

std::size_t bytes_of(const InfluenceTable& table) {
  return table.values.size() * sizeof(double);
}

template <typename Real> std::size_t bytes_of(const KernelSpectrum<Real>& spectrum) {
  return spectrum.values.size() * sizeof(Real);
}

} // namespace

template <typename Real> const LineFft<Real>& InfluenceCache::line_fft(std::size_t length) {
  const std::lock_guard<std::mutex> guard(fft_mutex_);
  return fft_of(store<Real>().line_ffts, length, rigor_);
}

/// What is kept under a key, if it serves; else it is made, by the first one who asks.
template <typename Key, typename Item, class Serves, class Make>
std::shared_ptr<const Item> InfluenceCache::obtain(Kept<Key, Item>& kept, const Key& key,
                                                   const Serves& serves, const Make& make) {
  std::shared_ptr<Place<Item>> place;
  {
    const std::lock_guard<std::mutex> guard(mutex_);
    std::shared_ptr<Place<Item>>& entry = kept[key];
    if (!entry) {
      entry = std::make_shared<Place<Item>>();
    }
    entry->last_use = ++clock_;
    place = entry;
  }
  const std::lock_guard<std::mutex> making(place->making);
  if (!place->item || !serves(*place->item)) {
    // Complete before it takes the old one's place: memory may run out.
    auto item = std::make_shared<const Item>(make(place->item.get()));
    const std::lock_guard<std::mutex> guard(mutex_);
    place->item = std::move(item);
    if (!place->dropped) {
      held_bytes_ -= place->bytes;
      place->bytes = bytes_of(*place->item);
      held_bytes_ += place->bytes;
      place->last_use = ++clock_;
    }
  }
  return place->item;
}

std::shared_ptr<const InfluenceTable> InfluenceCache::table(const InfluenceKernel& kernel,
                                                            std::size_t rows, std::size_t columns) {
  return obtain(
      tables_, kernel,
      [&](const InfluenceTable& kept) { return kept.rows >= rows && kept.columns >= columns; },
      [&](const InfluenceTable* smaller) {
        InfluenceTable table;
        table.rows = std::max(rows, smaller != nullptr ? smaller->rows : 0);
        table.columns = std::max(columns, smaller != nullptr ? smaller->columns : 0);
        table.values.resize(table.rows * table.columns);
        fill_influence_table(kernel, table.rows, table.columns, table.values);
        return table;
      });
}

template <typename Real>
KernelSpectrum<Real> InfluenceCache::compute_spectrum(const SpectrumKey& key) {
  const auto& [kernel, rows, columns, content] = key;
  const std::size_t half_rows = rows / 2;
  const std::size_t half_columns = columns / 2;
  const auto influence = table(kernel, half_rows + 1, half_columns + 1);

  // Lines that are even have real spectra: two of them make one complex transform, one as its real
  // and one as its imaginary part.
  using Complex = std::complex<double>;
  const LineFft<double>& row_fft = line_fft<double>(columns);
  AlignedArray<Complex> row_line(columns);
  AlignedArray<Complex> row_spectrum(columns);
  // By column: half[column * (half_rows + 1) + row].
  std::vector<double> half((half_columns + 1) * (half_rows + 1));
  for (std::size_t row = 0; row <= half_rows; row += 2) {
    const bool pair = row < half_rows;
    const double* first = influence->row(row);
    const double* second = influence->row(pair ? row + 1 : row);
    Complex* line = row_line.data();
    for (std::size_t column = 0; column <= half_columns; ++column) {
      line[column] = {first[column], second[column]};
    }
    for (std::size_t column = half_columns + 1; column < columns; ++column) {
      line[column] = line[columns - column];
    }
    row_fft.forward(line, row_spectrum.data());
    for (std::size_t column = 0; column <= half_columns; ++column) {
      double* values = half.data() + column * (half_rows + 1) + row;
      values[0] = row_spectrum.data()[column].real();
      if (pair) {
        values[1] = row_spectrum.data()[column].imag();
      }
    }
  }

  KernelSpectrum<Real> spectrum;
  spectrum.rows = rows;
  spectrum.columns = columns;
  spectrum.pitch = aligned_pitch<Real>(rows);
  spectrum.values = AlignedArray<Real>(spectrum.pitch * (half_columns + 1));
  const LineFft<double>& column_fft = line_fft<double>(rows);
  AlignedArray<Complex> column_line(rows);
  AlignedArray<Complex> column_spectrum(rows);
  const double element_count = static_cast<double>(rows) * static_cast<double>(columns);
  const auto entry_of = [&, inverse = content == Content::inverse](double value) {
    return static_cast<Real>(inverse ? 1.0 / (value * element_count) : value / element_count);
  };
  for (std::size_t column = 0; column <= half_columns; column += 2) {
    const bool pair = column < half_columns;
    const double* first = half.data() + column * (half_rows + 1);
    const double* second = pair ? first + (half_rows + 1) : first;
    Complex* line = column_line.data();
    for (std::size_t row = 0; row <= half_rows; ++row) {
      line[row] = {first[row], second[row]};
    }
    for (std::size_t row = half_rows + 1; row < rows; ++row) {
      line[row] = line[rows - row];
    }
    column_fft.forward(line, column_spectrum.data());
    Real* values = spectrum.values.data() + column * spectrum.pitch;
    for (std::size_t row = 0; row < rows; ++row) {
      values[row] = entry_of(column_spectrum.data()[row].real());
    }
    if (pair) {
      for (std::size_t row = 0; row < rows; ++row) {
        values[spectrum.pitch + row] = entry_of(column_spectrum.data()[row].imag());
      }
    }
  }
  return spectrum;
}

template <typename Real>
std::shared_ptr<const KernelSpectrum<Real>> InfluenceCache::spectrum_of(const SpectrumKey& key) {
  return obtain(
      store<Real>().spectra, key, [](const KernelSpectrum<Real>&) { return true; },
      [&](const KernelSpectrum<Real>*) { return compute_spectrum<Real>(key); });
}

template <typename Real>
std::shared_ptr<const KernelSpectrum<Real>>
InfluenceCache::spectrum(const InfluenceKernel& kernel, std::size_t rows, std::size_t columns) {
  return spectrum_of<Real>({kernel, rows, columns, Content::direct});
}

template <typename Real>
std::shared_ptr<const KernelSpectrum<Real>>
InfluenceCache::inverse_spectrum(const InfluenceKernel& kernel, std::size_t rows,
                                 std::size_t columns) {
  return spectrum_of<Real>({kernel, rows, columns, Content::inverse});
}

std::uint64_t InfluenceCache::now() const {
  const std::lock_guard<std::mutex> guard(mutex_);
  return clock_;
}

void InfluenceCache::trim(std::size_t bytes, std::uint64_t since) {
  const std::lock_guard<std::mutex> guard(mutex_);
  while (held_bytes_ > bytes) {
    std::uint64_t oldest = std::numeric_limits<std::uint64_t>::max();
    const auto look = [&oldest](const auto& kept) {
      for (const auto& [key, place] : kept) {
        oldest = place->bytes > 0 ? std::min(oldest, place->last_use) : oldest;
      }
    };
    look(tables_);
    look(single_.spectra);
    look(double_.spectra);
    if (oldest > since) {
      return;
    }
    const auto drop = [&](auto& kept) {
      std::erase_if(kept, [&](const auto& entry) {
        auto& place = *entry.second;
        if (place.last_use != oldest) {
          return false;
        }
        held_bytes_ -= place.bytes;
        place.dropped = true;
        return true;
      });
    };
    drop(tables_);
    drop(single_.spectra);
    drop(double_.spectra);
  }
}

double shared_aspect(double aspect) {
  constexpr double bits = 0x1p48;
  int exponent = 0;
  const double fraction = std::frexp(aspect, &exponent);
  return std::ldexp(std::nearbyint(fraction * bits) / bits, exponent);
}

template const LineFft<float>& InfluenceCache::line_fft<float>(std::size_t);
template const LineFft<double>& InfluenceCache::line_fft<double>(std::size_t);
template std::shared_ptr<const KernelSpectrum<float>>
InfluenceCache::spectrum<float>(const InfluenceKernel&, std::size_t, std::size_t);
template std::shared_ptr<const KernelSpectrum<double>>
InfluenceCache::spectrum<double>(const InfluenceKernel&, std::size_t, std::size_t);
template std::shared_ptr<const KernelSpectrum<float>>
InfluenceCache::inverse_spectrum<float>(const InfluenceKernel&, std::size_t, std::size_t);
template std::shared_ptr<const KernelSpectrum<double>>
InfluenceCache::inverse_spectrum<double>(const InfluenceKernel&, std::size_t, std::size_t);

} // namespace wrc
