#include "table/error_map.hpp"

#include <algorithm>

#include "base/smoothstep.hpp"

namespace wrc {

ErrorMap::ErrorMap(const Ranges& ranges, const Counts& counts)
    : ranges_(ranges), counts_(counts), vertices_((counts[0] + 1) * (counts[1] + 1)) {}

std::size_t ErrorMap::index_in(std::size_t variable, double place, double& fraction) const {
  const Range& range = ranges_[variable];
  const auto count = static_cast<double>(counts_[variable]);
  const double share = (place - range.first) / (range.last - range.first);
  const double cell = share > 0.0 ? std::min(share, 1.0) * count : 0.0;
  const std::size_t index = std::min(static_cast<std::size_t>(cell), counts_[variable] - 1);
  fraction = cell - static_cast<double>(index);
  return index;
}

std::size_t ErrorMap::cell_of(const Place& place) const {
  double unused = 0.0;
  return index_in(0, place[0], unused) * counts_[1] + index_in(1, place[1], unused);
}

ErrorMap::Ranges ErrorMap::ranges_of(std::size_t cell) const {
  const Counts at{cell / counts_[1], cell % counts_[1]};
  Ranges result;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double size = (ranges_[i].last - ranges_[i].first) / static_cast<double>(counts_[i]);
    result[i].first = ranges_[i].first + size * static_cast<double>(at[i]);
    result[i].last = result[i].first + size;
  }
  return result;
}

std::array<std::size_t, 4> ErrorMap::vertices_of(std::size_t cell) const {
  const std::size_t row = counts_[1] + 1;
  const std::size_t first = cell / counts_[1] * row + cell % counts_[1];
  return {first, first + 1, first + row, first + row + 1};
}

template <class Add> void ErrorMap::around(const Place& place, const Add& add) const {
  std::array<std::array<double, 2>, 2> share{};
  std::array<std::array<double, 2>, 2> slope{};
  Counts index{};
  for (std::size_t i = 0; i < place.size(); ++i) {
    double t = 0.0;
    index[i] = index_in(i, place[i], t);
    const double rise = smooth_rise(t);
    const double rate = 6.0 * t * (1.0 - t) * static_cast<double>(counts_[i]) /
                        (ranges_[i].last - ranges_[i].first);
    share[i] = {1.0 - rise, rise};
    slope[i] = {-rate, rate};
  }
  const std::array<std::size_t, 4> vertices = vertices_of(index[0] * counts_[1] + index[1]);
  for (std::size_t corner = 0; corner < vertices.size(); ++corner) {
    const std::size_t i = corner / 2;
    const std::size_t j = corner % 2;
    add(vertices_[vertices[corner]], share[0][i] * share[1][j],
        Place{slope[0][i] * share[1][j], share[0][i] * slope[1][j]});
  }
}

ErrorMap::Errors ErrorMap::at(const Place& place, std::size_t first, std::size_t last) const {
  Errors errors{};
  around(place, [&](const Errors& vertex, double share, const Place&) {
    for (std::size_t kind = first; kind < last; ++kind) {
      errors[kind] += share * vertex[kind];
    }
  });
  return errors;
}

ErrorMap::Weight ErrorMap::weight_at(const Place& place, double tolerance) const {
  Weight weight;
  around(place, [&](const Errors& vertex, double share, const Place& slope) {
    if (vertex[likely_of_force] > tolerance) {
      weight.value += share;
      for (std::size_t i = 0; i < slope.size(); ++i) {
        weight.slope[i] += slope[i];
      }
    }
  });
  return weight;
}

double ErrorMap::share_beyond(double tolerance) const {
  const auto beyond = std::count_if(vertices_.begin(), vertices_.end(), [&](const Errors& vertex) {
    return vertex[likely_of_force] > tolerance;
  });
  return static_cast<double>(beyond) / static_cast<double>(vertices_.size());
}

} // namespace wrc
