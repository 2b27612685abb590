#include "pressure/smooth_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "pressure/constants.hpp"
#include "pressure/pressure_field.hpp"

namespace wrc {

namespace {

/// Keys, IEEE Trans. Acoust. Speech Signal Process. 29 (1981), eq. 4 with a = -1/2, between the
/// second and the third of four values.
std::array<double, 4> cubic_weights(double t) {
  return {0.5 * t * (-1.0 + t * (2.0 - t)), 1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
          0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

/// The position before, and how far beyond it.
struct Place {
  std::size_t before = 0;
  double beyond = 0.0;
  bool inside = false;
};

/// Position after `steps` from the first of `count`, with `room` positions kept free on both sides.
Place place_of(double steps, std::size_t count, std::size_t room) {
  const auto first = static_cast<double>(room);
  const auto last = static_cast<double>(count - 1 - room);
  if (!(steps >= first && steps <= last)) {
    return {};
  }
  const std::size_t before = std::min(static_cast<std::size_t>(steps), count - 2 - room);
  return {before, steps - static_cast<double>(before), true};
}

/// Contact may reach the grid's edge: room for the two elements outside.
constexpr std::size_t room = 2; // not a tuning constant

/// How far a value has grown towards another, 0 to 1.
double grown(double value, double whole) {
  return !(value > 0.0) ? 0.0 : value < whole ? value / whole : 1.0;
}

/// Mean pressure of an element over the pressure at the centre of the next one inwards, where p^2
/// is linear and `share` times as large at its own centre.
double mean_by_share(double share) {
  const double inner = 0.5 * (1.0 + share);
  const double outer = 1.5 * share - 0.5;
  return outer < 0.0 ? 2.0 / 3.0 * inner * std::sqrt(inner) / (1.0 - share)
                     : 2.0 / 3.0 * (inner + std::sqrt(inner * outer) + outer) /
                           (std::sqrt(inner) + std::sqrt(outer));
}

/// The inverse. What rises outwards ends within no element.
double share_by_mean(double mean) {
  if (mean >= 1.0) {
    return mean * mean;
  }
  double low = -1.0; // the edge is at the inner side
  double high = 1.0;
  for (int i = 0; i < row_end_halvings; ++i) {
    const double share = 0.5 * (low + high);
    (mean_by_share(share) < mean ? low : high) = share;
  }
  return 0.5 * (low + high);
}

/// What half of an element adds to its mean pressure and to the fraction of it in contact.
struct HalfElement {
  double mean = 0.0;
  double covered = 0.0;
};

/// Between two values of p^2, where it is linear.
HalfElement half_element(double before, double after) {
  const double high = std::max(before, after);
  const double low = std::min(before, after);
  if (!(high > 0.0)) {
    return {};
  }
  const double share = low < 0.0 ? high / (high - low) : 1.0;
  const double p_high = std::sqrt(high);
  const double p_low = std::sqrt(std::max(low, 0.0));
  // The mean of the square root of a linear function.
  const double mean = 2.0 / 3.0 * (high + p_high * p_low + p_low * p_low) / (p_high + p_low);
  return {0.5 * share * mean, 0.5 * share};
}

/// The elements under pressure with those next to them; without any the first element.
IndexBox around_contact(const Grid& grid, std::span<const double> pressure) {
  IndexBox box{grid.lateral_count, 0, grid.longitudinal_count, 0};
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    const auto row = pressure.subspan(i * grid.longitudinal_count, grid.longitudinal_count);
    const auto positive = [](double p) { return p > 0.0; };
    const auto first = std::find_if(row.begin(), row.end(), positive);
    if (first == row.end()) {
      continue;
    }
    const auto last = std::find_if(row.rbegin(), row.rend(), positive);
    box = {std::min(box.lateral_first, i), i,
           std::min(box.longitudinal_first, static_cast<std::size_t>(first - row.begin())),
           std::max(box.longitudinal_last, static_cast<std::size_t>(row.rend() - last - 1))};
  }
  if (box.lateral_first > box.lateral_last) {
    return {};
  }
  const auto before = [](std::size_t index) { return index > 0 ? index - 1 : 0; };
  return {before(box.lateral_first), std::min(box.lateral_last + 1, grid.lateral_count - 1),
          before(box.longitudinal_first),
          std::min(box.longitudinal_last + 1, grid.longitudinal_count - 1)};
}

} // namespace

SmoothPressure::SmoothPressure(const Grid& grid, std::span<const double> pressure, double bend)
    : grid_(grid) {
  const IndexBox box = around_contact(grid, pressure);
  grid_.lateral_first = grid.lateral(box.lateral_first);
  grid_.longitudinal_first = grid.longitudinal(box.longitudinal_first);
  grid_.lateral_count = box.lateral_last - box.lateral_first + 1;
  grid_.longitudinal_count = box.longitudinal_last - box.longitudinal_first + 1;
  const std::size_t rows = grid_.lateral_count;
  const std::size_t columns = grid_.longitudinal_count;
  grid_.lateral_count += 2 * room;
  grid_.longitudinal_count += 2 * room;
  grid_.lateral_first -= static_cast<double>(room) * grid.lateral_step;
  grid_.longitudinal_first -= static_cast<double>(room) * grid.longitudinal_step;
  known_.resize(grid_.element_count());
  squares_.resize(grid_.element_count());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double p = std::max(
          pressure[(i + box.lateral_first) * grid.longitudinal_count + j + box.longitudinal_first],
          0.0);
      squares_[(i + room) * grid_.longitudinal_count + j + room] = p * p;
    }
  }
  const std::vector<double> given = squares_;
  replace_ends_of_rows(given, bend);
  fill_in_ring(given);
  fill_in_ring(given);
}

SmoothPressure::Continuation SmoothPressure::continuation(std::size_t at,
                                                          std::ptrdiff_t step) const {
  std::array<double, 3> f{};
  Continuation result;
  double known = 1.0;
  auto place = static_cast<std::ptrdiff_t>(at);
  for (std::size_t k = 0; k < 3; ++k) {
    place += step;
    if (place < 0 || place >= static_cast<std::ptrdiff_t>(known_.size())) {
      break;
    }
    f[k] = squares_[static_cast<std::size_t>(place)];
    known *= known_[static_cast<std::size_t>(place)];
    if (known == 0.0) {
      break;
    }
    result.known[k] = known;
  }
  result.values = {-f[0], 2.0 * f[0] - f[1], 3.0 * (f[0] - f[1]) + f[2]};
  result.slopes = {f[0], f[1] - f[0], f[1] - f[0]};
  return result;
}

/// Elements count as inside as far as they and their neighbours have entered the contact; the rest
/// of them is continued along the row from those further in, as far as there are any.
void SmoothPressure::replace_ends_of_rows(const std::vector<double>& given, double bend) {
  const std::size_t columns = grid_.longitudinal_count;
  std::vector<double> entered(squares_.size());
  for (std::size_t at = columns; at + columns < squares_.size(); ++at) {
    const double f = squares_[at];
    if (!(f > 0.0)) {
      continue;
    }
    const double before = squares_[at - 1];
    const double after = squares_[at + 1];
    const double below = squares_[at - columns];
    const double above = squares_[at + columns];
    entered[at] = grown(f, entering_share * std::max({before, after, below, above}));
    known_[at] = std::min({entered[at], grown(std::min(before, after), end_share * f),
                           grown(std::min(below, above), entering_share * f)});
  }
  const std::vector<double> inside = known_;
  // The second time ends are continued from what the first one replaced.
  for (int times = 0; times < 2; ++times) {
    std::vector<double> known = known_;
    std::vector<double> squares = squares_;
    for (std::size_t at = 0; at < given.size(); ++at) {
      if (inside[at] == 1.0 || entered[at] == 0.0) {
        continue;
      }
      double weights = 0.0;
      double sum = 0.0;
      for (const std::ptrdiff_t step : {-1, 1}) {
        const Continuation inwards = continuation(at, step);
        weights += inwards.known[2];
        sum += inwards.known[2] * inwards.values[2];
        const auto to = static_cast<std::ptrdiff_t>(at);
        const double inner = squares_[static_cast<std::size_t>(to + step)];
        if (bend > 0.0 && inwards.known[2] > 0.0 && inner > 0.0) {
          const double outer = given[static_cast<std::size_t>(to - step)];
          const double by_load = inner * share_by_mean(std::sqrt(given[at] / inner));
          sum += inwards.known[2] * bend * (1.0 - grown(outer, end_share * given[at])) *
                 (by_load - inwards.values[2]);
        }
      }
      const double continued = std::min(weights, 1.0);
      const double outer = (1.0 - inside[at]) * entered[at];
      const double by_row = weights > 0.0 ? sum / weights : 0.0;
      known[at] = inside[at] + outer;
      squares[at] = given[at] + outer * continued * (by_row - given[at]) / known[at];
    }
    known_ = std::move(known);
    squares_ = std::move(squares);
  }
}

/// Directions weigh with the slope of p^2 along them, that is, those across the edge most. What
/// they continue to does not exceed what is given.
void SmoothPressure::fill_in_ring(const std::vector<double>& given) {
  const std::size_t columns = grid_.longitudinal_count;
  std::vector<double> near_row(squares_.size()); // something known here or beside it
  for (std::size_t at = 1; at + 1 < squares_.size(); ++at) {
    near_row[at] = std::max({known_[at - 1], known_[at], known_[at + 1]});
  }
  struct Direction {
    std::ptrdiff_t step;
    double length;
  };
  std::vector<Direction> directions;
  for (const std::ptrdiff_t down : {-1, 0, 1}) {
    for (const std::ptrdiff_t right : {-1, 0, 1}) {
      if (down != 0 || right != 0) {
        directions.push_back({down * static_cast<std::ptrdiff_t>(columns) + right,
                              std::hypot(static_cast<double>(down) * grid_.lateral_step,
                                         static_cast<double>(right) * grid_.longitudinal_step)});
      }
    }
  }
  struct Filled {
    std::size_t at;
    double square, known;
  };
  std::vector<Filled> ring;
  for (std::size_t at = 0; at < squares_.size(); ++at) {
    const bool beside = near_row[at] > 0.0 || (at >= columns && near_row[at - columns] > 0.0) ||
                        (at + columns < squares_.size() && near_row[at + columns] > 0.0);
    if (known_[at] == 1.0 || !beside) {
      continue;
    }
    std::array<double, 3> sums{};
    std::array<double, 3> weights{};
    std::array<double, 3> known{};
    for (const auto& [step, length] : directions) {
      const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + step);
      if (next >= known_.size() || known_[next] == 0.0) {
        continue;
      }
      const Continuation one = continuation(at, step);
      // Where p^2 falls inwards a direction counts only if there is no other.
      const double least = std::numeric_limits<double>::epsilon() * std::abs(one.values[0]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double weight = one.known[k] * std::max(one.slopes[k], least) / length;
        sums[k] += weight * one.values[k];
        weights[k] += weight;
        known[k] = std::max(known[k], one.known[k]);
      }
    }
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (weights[k] > 0.0) {
        square += known[k] * (sums[k] / weights[k] - square);
      }
    }
    const double itself = known_[at];
    const double all = itself + (1.0 - itself) * known[0];
    if (all > 0.0) {
      ring.push_back(
          {at, (itself * squares_[at] + (all - itself) * std::min(square, given[at])) / all, all});
    }
  }
  for (const Filled& one : ring) {
    squares_[one.at] = one.square;
    known_[one.at] = one.known;
  }
}

std::optional<SmoothPressure::Extent> SmoothPressure::extent(std::size_t lines,
                                                             std::size_t line_stride,
                                                             std::size_t count,
                                                             std::size_t stride) const {
  std::optional<Extent> all;
  constexpr double edge = static_cast<double>(room) - 0.5; // of the grid of the pressures
  for (std::size_t line = 0; line < lines; ++line) {
    std::optional<Extent> one;
    const auto at = [&](std::size_t index) {
      return squares_[line * line_stride + index * stride];
    };
    // Distance of the edge between two positions from the one inside.
    const auto beyond = [&](std::size_t inside, std::size_t outside) {
      const bool known = known_[line * line_stride + outside * stride] > 0.0;
      return known ? at(inside) / (at(inside) - std::min(at(outside), 0.0)) : 0.5;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (!(at(i) > 0.0)) {
        continue;
      }
      const auto place = static_cast<double>(i);
      const double first = std::max(place - beyond(i, i - 1), edge);
      const double last = std::min(place + beyond(i, i + 1), static_cast<double>(count - 1) - edge);
      one = one ? Extent{std::min(one->first, first), std::max(one->last, last), 0.0}
                : Extent{first, last, 0.0};
    }
    if (one) {
      one->longest = one->last - one->first;
      all = all ? Extent{std::min(all->first, one->first), std::max(all->last, one->last),
                         std::max(all->longest, one->longest)}
                : one;
    }
  }
  return all;
}

std::optional<SmoothPressure::Extent> SmoothPressure::longitudinal_extent() const {
  auto result = extent(grid_.lateral_count, grid_.longitudinal_count, grid_.longitudinal_count, 1);
  if (result) {
    result = Extent{grid_.longitudinal_first + result->first * grid_.longitudinal_step,
                    grid_.longitudinal_first + result->last * grid_.longitudinal_step,
                    result->longest * grid_.longitudinal_step};
  }
  return result;
}

std::optional<SmoothPressure::Extent> SmoothPressure::lateral_extent() const {
  auto result = extent(grid_.longitudinal_count, 1, grid_.lateral_count, grid_.longitudinal_count);
  if (result) {
    result = Extent{grid_.lateral_first + result->first * grid_.lateral_step,
                    grid_.lateral_first + result->last * grid_.lateral_step,
                    result->longest * grid_.lateral_step};
  }
  return result;
}

/// On each row p^2 is known at the centres, and halfway between them by the cubic weights.
SmoothPressure::Columns SmoothPressure::own_columns() const {
  const std::size_t columns = grid_.longitudinal_count;
  Columns result{grid_.longitudinal_first, std::vector<double>(columns)};
  const std::array<double, 4> halfway = cubic_weights(0.5);
  for (std::size_t row = 0; row < grid_.lateral_count; ++row) {
    for (std::size_t j = 1; j + 2 < columns; ++j) {
      const double* squares = &squares_[row * columns + j];
      const double* known = &known_[row * columns + j];
      if (!(known[0] > 0.0 && known[1] > 0.0)) {
        continue;
      }
      const double between = halfway[0] * squares[-1] + halfway[1] * squares[0] +
                             halfway[2] * squares[1] + halfway[3] * squares[2];
      result.sums[j] += half_element(squares[0], between).mean;
      result.sums[j + 1] += half_element(between, squares[1]).mean;
    }
  }
  return result;
}

/// Positions along the rolling direction are the same for all lines.
class SmoothPressure::Line {
public:
  Line(const SmoothPressure& pressure, double first, double step, std::size_t count)
      : of_(pressure), along_(count), weights_(count) {
    const Grid& grid = of_.grid_;
    for (std::size_t j = 0; j < count; ++j) {
      along_[j] = place_of((first + static_cast<double>(j) * step - grid.longitudinal_first) /
                               grid.longitudinal_step,
                           grid.longitudinal_count, 1);
      weights_[j] = cubic_weights(along_[j].beyond);
    }
  }

  void move_to(double lateral) {
    across_ = place_of((lateral - of_.grid_.lateral_first) / of_.grid_.lateral_step,
                       of_.grid_.lateral_count, 0);
  }

  [[nodiscard]] double square(std::size_t j) const {
    const std::size_t columns = of_.grid_.longitudinal_count;
    const std::size_t corner = across_.before * columns + along_[j].before;
    constexpr double outside = -std::numeric_limits<double>::infinity();
    if (!across_.inside || !along_[j].inside) {
      return outside;
    }
    const std::array<std::size_t, 4> corners{corner, corner + 1, corner + columns,
                                             corner + columns + 1};
    if (std::any_of(corners.begin(), corners.end(),
                    [this](auto at) { return of_.known_[at] == 0.0; })) {
      return outside;
    }
    const double before = along_row(j, corner);
    const double after = along_row(j, corner + columns);
    return before + across_.beyond * (after - before) -
           0.5 * across_.beyond * (1.0 - across_.beyond) *
               second_difference(j, corner, before, after);
  }

private:
  /// On the row of elements whose second one of four is `at`.
  [[nodiscard]] double along_row(std::size_t j, std::size_t at) const {
    double square = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      square += weights_[j][k] * of_.squares_[at + k - 1];
    }
    return square;
  }
  /// Across the rows, from their values at `corner` and after it, as far as those beyond are known.
  [[nodiscard]] double second_difference(std::size_t j, std::size_t corner, double before,
                                         double after) const {
    const std::size_t columns = of_.grid_.longitudinal_count;
    if (across_.before < 1 || across_.before + 2 >= of_.grid_.lateral_count) {
      return 0.0;
    }
    double known = 1.0;
    for (const std::size_t row :
         {corner - columns, corner, corner + columns, corner + 2 * columns}) {
      for (std::size_t k = 0; k < 4; ++k) {
        known = std::min(known, of_.known_[row + k - 1]);
      }
    }
    if (known == 0.0) {
      return 0.0;
    }
    const double first = along_row(j, corner - columns) - 2.0 * before + after;
    const double last = before - 2.0 * after + along_row(j, corner + 2 * columns);
    return first * last > 0.0
               ? known * std::copysign(std::min(std::abs(first), std::abs(last)), first)
               : 0.0;
  }

  const SmoothPressure& of_;
  std::vector<Place> along_;
  std::vector<std::array<double, 4>> weights_;
  Place across_;
};

void SmoothPressure::fill(const Grid& other, std::vector<double>& pressure) const {
  pressure.assign(other.element_count(), 0.0);
  Line line(*this, other.longitudinal_first, other.longitudinal_step, other.longitudinal_count);
  for (std::size_t i = 0; i < other.lateral_count; ++i) {
    line.move_to(other.lateral(i));
    for (std::size_t j = 0; j < other.longitudinal_count; ++j) {
      pressure[i * other.longitudinal_count + j] = std::sqrt(std::max(line.square(j), 0.0));
    }
  }
}

void SmoothPressure::fill_means(const Grid& other, std::vector<double>& pressure,
                                std::vector<double>& covered) const {
  const std::size_t columns = other.longitudinal_count;
  pressure.assign(other.element_count(), 0.0);
  covered.assign(other.element_count(), 0.0);
  const double half = 0.5 * other.longitudinal_step;
  Line line(*this, other.longitudinal_first - half, half, 2 * columns + 1);
  for (std::size_t i = 0; i < other.lateral_count; ++i) {
    line.move_to(other.lateral(i));
    double before = line.square(0);
    for (std::size_t j = 0; j < 2 * columns; ++j) {
      const double after = line.square(j + 1);
      const HalfElement half = half_element(before, after);
      before = after;
      pressure[i * columns + j / 2] += half.mean;
      covered[i * columns + j / 2] += half.covered;
    }
  }
}

} // namespace wrc
