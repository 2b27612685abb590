#include "pressure/smooth_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wrc {

namespace {

/// Keys, IEEE Trans. Acoust. Speech Signal Process. 29 (1981), eq. 4 with a = -1/2, between the
/// second and the third of four values.
std::array<double, 4> cubic_weights(double t) {
  return {0.5 * t * (-1.0 + t * (2.0 - t)), 1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
          0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

/// The place before, and how far beyond it.
struct Place {
  std::size_t before = 0;
  double beyond = 0.0;
  bool inside = false;
};

/// Of `steps` from the first of `count` places, with `room` places kept free on both sides.
Place place_of(double steps, std::size_t count, std::size_t room) {
  const auto first = static_cast<double>(room);
  const auto last = static_cast<double>(count - 1 - room);
  if (!(steps >= first && steps <= last)) {
    return {};
  }
  const std::size_t before = std::min(static_cast<std::size_t>(steps), count - 2 - room);
  return {before, steps - static_cast<double>(before), true};
}

} // namespace

SmoothPressure::SmoothPressure(const Grid& grid, std::span<const double> pressure) : grid_(grid) {
  // Contact may reach the grid's edge: room for the two elements outside.
  constexpr std::size_t room = 2;
  grid_.lateral_count += 2 * room;
  grid_.longitudinal_count += 2 * room;
  grid_.lateral_first -= static_cast<double>(room) * grid.lateral_step;
  grid_.longitudinal_first -= static_cast<double>(room) * grid.longitudinal_step;
  loaded_.resize(grid_.element_count());
  known_.resize(grid_.element_count());
  squares_.resize(grid_.element_count());
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
      const double p = pressure[i * grid.longitudinal_count + j];
      const std::size_t at = (i + room) * grid_.longitudinal_count + j + room;
      loaded_[at] = p > 0.0;
      squares_[at] = p > 0.0 ? p * p : 0.0;
    }
  }
  replace_ends_of_rows();
  fill_in_ring();
  fill_in_ring();
}

double SmoothPressure::Continuation::value() const {
  return found == 3   ? 3.0 * (values[0] - values[1]) + values[2]
         : found == 2 ? 2.0 * values[0] - values[1]
                      : -values[0];
}

SmoothPressure::Continuation SmoothPressure::continuation(std::size_t at,
                                                          std::ptrdiff_t step) const {
  Continuation result;
  std::ptrdiff_t place = static_cast<std::ptrdiff_t>(at) + step;
  while (result.found < 3 && place >= 0 && place < static_cast<std::ptrdiff_t>(known_.size()) &&
         known_[static_cast<std::size_t>(place)]) {
    result.values[result.found++] = squares_[static_cast<std::size_t>(place)];
    place += step;
  }
  return result;
}

void SmoothPressure::replace_ends_of_rows() {
  const std::size_t columns = grid_.longitudinal_count;
  for (std::size_t at = columns; at + columns < squares_.size(); ++at) {
    known_[at] = loaded_[at] && loaded_[at - 1] && loaded_[at + 1] && loaded_[at - columns] &&
                 loaded_[at + columns];
  }
  for (std::size_t at = 0; at < squares_.size(); ++at) {
    if (!loaded_[at] || known_[at]) {
      continue;
    }
    for (const std::ptrdiff_t step : {-1, 1}) {
      if (const Continuation inwards = continuation(at, step); inwards.found == 3) {
        squares_[at] = inwards.value();
      }
    }
  }
  known_ = loaded_;
}

/// Directions weigh with the slope of p^2 along them, that is, those across the edge most.
void SmoothPressure::fill_in_ring() {
  const auto columns = static_cast<std::ptrdiff_t>(grid_.longitudinal_count);
  std::vector<std::pair<std::size_t, double>> ring;
  for (std::size_t at = 0; at < squares_.size(); ++at) {
    if (known_[at]) {
      continue;
    }
    std::array<double, 3> sums{};
    std::array<double, 3> weights{};
    for (const std::ptrdiff_t down : {-1, 0, 1}) {
      for (const std::ptrdiff_t right : {-1, 0, 1}) {
        const Continuation one = continuation(at, down * columns + right);
        if (one.found == 0) { // nor is the element itself known
          continue;
        }
        const double length = std::hypot(static_cast<double>(down) * grid_.lateral_step,
                                         static_cast<double>(right) * grid_.longitudinal_step);
        // Where p^2 falls inwards a direction counts only if there is no other.
        const double least = std::numeric_limits<double>::epsilon() * std::abs(one.values[0]);
        const double slope = one.found == 1 ? one.values[0] : one.values[1] - one.values[0];
        const double weight = std::max(slope, least) / length;
        sums[one.found - 1] += weight * one.value();
        weights[one.found - 1] += weight;
      }
    }
    for (std::size_t found = 3; found > 0; --found) {
      if (weights[found - 1] > 0.0) {
        ring.emplace_back(at, std::min(sums[found - 1] / weights[found - 1], 0.0));
        break;
      }
    }
  }
  for (const auto& [at, value] : ring) {
    squares_[at] = value;
    known_[at] = true;
  }
}

std::optional<SmoothPressure::Extent> SmoothPressure::extent(std::size_t lines,
                                                             std::size_t line_stride,
                                                             std::size_t count,
                                                             std::size_t stride) const {
  std::optional<Extent> all;
  for (std::size_t line = 0; line < lines; ++line) {
    const auto at = [&](std::size_t index) {
      return squares_[line * line_stride + index * stride];
    };
    // Of the edge between two places, from the one inside.
    const auto beyond = [](double inside, double outside) {
      return outside < 0.0 ? inside / (inside - outside) : 0.5;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (!(at(i) > 0.0)) {
        continue;
      }
      const auto place = static_cast<double>(i);
      const double first = place - beyond(at(i), at(i - 1));
      const double last = place + beyond(at(i), at(i + 1));
      all = all ? Extent{std::min(all->first, first), std::max(all->last, last)}
                : Extent{first, last};
    }
  }
  return all;
}

std::optional<SmoothPressure::Extent> SmoothPressure::longitudinal_extent() const {
  auto result = extent(grid_.lateral_count, grid_.longitudinal_count, grid_.longitudinal_count, 1);
  if (result) {
    result = Extent{grid_.longitudinal_first + result->first * grid_.longitudinal_step,
                    grid_.longitudinal_first + result->last * grid_.longitudinal_step};
  }
  return result;
}

std::optional<SmoothPressure::Extent> SmoothPressure::lateral_extent() const {
  auto result = extent(grid_.longitudinal_count, 1, grid_.lateral_count, grid_.longitudinal_count);
  if (result) {
    result = Extent{grid_.lateral_first + result->first * grid_.lateral_step,
                    grid_.lateral_first + result->last * grid_.lateral_step};
  }
  return result;
}

void SmoothPressure::fill(const Grid& other, std::vector<double>& pressure) const {
  pressure.assign(other.element_count(), 0.0);
  const std::size_t columns = grid_.longitudinal_count;
  std::vector<Place> along(other.longitudinal_count);
  std::vector<std::array<double, 4>> weights(along.size());
  for (std::size_t j = 0; j < along.size(); ++j) {
    along[j] = place_of(
        (other.longitudinal(j) - grid_.longitudinal_first) / grid_.longitudinal_step, columns, 1);
    weights[j] = cubic_weights(along[j].beyond);
  }
  for (std::size_t i = 0; i < other.lateral_count; ++i) {
    const Place across = place_of((other.lateral(i) - grid_.lateral_first) / grid_.lateral_step,
                                  grid_.lateral_count, 0);
    for (std::size_t j = 0; j < along.size() && across.inside; ++j) {
      const std::size_t corner = across.before * columns + along[j].before;
      if (!along[j].inside || !(loaded_[corner] || loaded_[corner + 1] ||
                                loaded_[corner + columns] || loaded_[corner + columns + 1])) {
        continue;
      }
      double before = 0.0;
      double after = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        before += weights[j][k] * squares_[corner + k - 1];
        after += weights[j][k] * squares_[corner + columns + k - 1];
      }
      const double square = before + across.beyond * (after - before);
      pressure[i * other.longitudinal_count + j] = std::sqrt(std::max(square, 0.0));
    }
  }
}

} // namespace wrc
