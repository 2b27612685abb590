#include "table/error_map.hpp"

#include <utility>

#include "base/smoothstep.hpp"

namespace wrc {

ErrorMap::ErrorMap(const Ranges& ranges, const Counts& counts, std::vector<double> errors)
    : ranges_(ranges), counts_(counts), cells_(std::move(errors)),
      errors_(largest_around([](double error) { return error; })), weights_(errors_.size()) {}

template <class Value> std::vector<double> ErrorMap::largest_around(const Value& value) const {
  const Counts vertices{counts_[0] + 1, counts_[1] + 1, counts_[2] + 1};
  std::vector<double> result(vertices[0] * vertices[1] * vertices[2]);
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const double of_cell = value(cells_[cell]);
    const Counts at{cell / (counts_[1] * counts_[2]), cell / counts_[2] % counts_[1],
                    cell % counts_[2]};
    for (std::size_t corner = 0; corner < 8; ++corner) {
      double& vertex =
          result[((at[0] + corner / 4) * vertices[1] + at[1] + corner / 2 % 2) * vertices[2] +
                 at[2] + corner % 2];
      vertex = std::max(vertex, of_cell);
    }
  }
  return result;
}

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
  return (index_in(0, place[0], unused) * counts_[1] + index_in(1, place[1], unused)) * counts_[2] +
         index_in(2, place[2], unused);
}

ErrorMap::Ranges ErrorMap::ranges_of(std::size_t cell) const {
  const Counts at{cell / (counts_[1] * counts_[2]), cell / counts_[2] % counts_[1],
                  cell % counts_[2]};
  Ranges result;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double size = (ranges_[i].last - ranges_[i].first) / static_cast<double>(counts_[i]);
    result[i].first = ranges_[i].first + size * static_cast<double>(at[i]);
    result[i].last = result[i].first + size;
  }
  return result;
}

ErrorMap::Weight ErrorMap::at(const std::vector<double>& vertices, const Place& place) const {
  Counts index{};
  std::array<std::array<double, 2>, 3> share{};
  std::array<std::array<double, 2>, 3> slope{};
  for (std::size_t i = 0; i < place.size(); ++i) {
    double t = 0.0;
    index[i] = index_in(i, place[i], t);
    const double rise = smooth_rise(t);
    const double rate = 6.0 * t * (1.0 - t) * static_cast<double>(counts_[i]) /
                        (ranges_[i].last - ranges_[i].first);
    share[i] = {1.0 - rise, rise};
    slope[i] = {-rate, rate};
  }
  Weight result;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const Counts k{corner / 4, corner / 2 % 2, corner % 2};
    const double vertex =
        vertices[((index[0] + k[0]) * (counts_[1] + 1) + index[1] + k[1]) * (counts_[2] + 1) +
                 index[2] + k[2]];
    result.value += vertex * share[0][k[0]] * share[1][k[1]] * share[2][k[2]];
    result.slope[0] += vertex * slope[0][k[0]] * share[1][k[1]] * share[2][k[2]];
    result.slope[1] += vertex * share[0][k[0]] * slope[1][k[1]] * share[2][k[2]];
    result.slope[2] += vertex * share[0][k[0]] * share[1][k[1]] * slope[2][k[2]];
  }
  return result;
}

void ErrorMap::set_tolerance(double tolerance) {
  weights_ = largest_around([tolerance](double error) { return error > tolerance ? 1.0 : 0.0; });
}

double ErrorMap::share_beyond(double tolerance) const {
  return static_cast<double>(std::count_if(cells_.begin(), cells_.end(),
                                           [&](double error) { return error > tolerance; })) /
         static_cast<double>(cells_.size());
}

} // namespace wrc
