#include "support/refined_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace driver {
namespace {

/// Weights of the values before, at, behind a place and of the next one.
using Weights = std::array<double, 4>;

Weights straight(double t) {
  return {0.0, 1.0 - t, t, 0.0};
}

/// Cubic, with the slope of both neighbours (Catmull & Rom 1974).
Weights smooth(double t) {
  return {0.5 * t * (-1.0 + t * (2.0 - t)), 1.0 + 0.5 * t * t * (3.0 * t - 5.0),
          0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

/// p^2 of each element, and what parabolas (lines, where there are only two elements) through those
/// under pressure say of two rings of elements around them: the mean of both directions, at most 0.
std::vector<double> squares_of(const std::vector<double>& pressure, std::size_t rows,
                               std::size_t columns) {
  std::vector<double> squares;
  std::vector<bool> known;
  for (const double value : pressure) {
    squares.push_back(value > 0.0 ? value * value : 0.0);
    known.push_back(value > 0.0);
  }
  const auto index = [&](std::ptrdiff_t row, std::ptrdiff_t column) { // of a known one, or none
    const bool inside = row >= 0 && column >= 0 && row < static_cast<std::ptrdiff_t>(rows) &&
                        column < static_cast<std::ptrdiff_t>(columns);
    const std::size_t at =
        inside ? static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column) : 0;
    return inside && known[at] ? std::optional(at) : std::nullopt;
  };
  constexpr std::array<std::array<std::ptrdiff_t, 2>, 4> ways{{{0, 1}, {0, -1}, {1, 0}, {-1, 0}}};
  constexpr int rings = 2;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<std::pair<std::size_t, double>> found;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      double sum = 0.0;
      int count = 0;
      for (const auto& [down, on] : ways) {
        const auto at = [&, down = down, on = on](std::ptrdiff_t steps) {
          return index(static_cast<std::ptrdiff_t>(i / columns) + steps * down,
                       static_cast<std::ptrdiff_t>(i % columns) + steps * on);
        };
        const auto first = at(1);
        const auto second = at(2);
        const auto third = at(3);
        if (!known[i] && first && second) {
          sum += third ? 3.0 * (squares[*first] - squares[*second]) + squares[*third]
                       : 2.0 * squares[*first] - squares[*second];
          ++count;
        }
      }
      if (count > 0) {
        found.emplace_back(i, std::min(sum / count, 0.0));
      }
    }
    for (const auto& [i, value] : found) {
      squares[i] = value;
      known[i] = true;
    }
  }
  return squares;
}

} // namespace

RefinedMap::RefinedMap(std::size_t rows, std::size_t columns)
    : rows_(rows), columns_(columns), down_(std::clamp<std::size_t>(240 / rows, 1, 8)),
      on_(std::clamp<std::size_t>(240 / columns, 1, 8)) {}

template <class WeightsAt>
std::vector<double> RefinedMap::refine(const std::vector<double>& values, WeightsAt weights) const {
  const auto value = [&](std::size_t row, std::size_t column) {
    // `row` and `column` count from one before the grid.
    return values[(std::clamp<std::size_t>(row, 1, rows_) - 1) * columns_ +
                  std::clamp<std::size_t>(column, 1, columns_) - 1];
  };
  std::vector<double> fine;
  fine.reserve(rows() * columns());
  for (std::size_t i = 0; i < rows(); ++i) {
    const Weights down = weights(static_cast<double>(i % down_) / static_cast<double>(down_));
    for (std::size_t j = 0; j < columns(); ++j) {
      const Weights on = weights(static_cast<double>(j % on_) / static_cast<double>(on_));
      double sum = 0.0;
      for (std::size_t k = 0; k < down.size(); ++k) {
        for (std::size_t l = 0; l < on.size(); ++l) {
          sum += down[k] * on[l] * value(i / down_ + k, j / on_ + l);
        }
      }
      fine.push_back(sum);
    }
  }
  return fine;
}

std::vector<double> RefinedMap::linear(const std::vector<double>& values) const {
  return refine(values, straight);
}

std::vector<double> RefinedMap::pressure(const std::vector<double>& pressure) const {
  std::vector<double> fine = refine(squares_of(pressure, rows_, columns_), smooth);
  for (std::size_t k = 0; k < fine.size(); ++k) {
    const std::size_t row = k / columns() / down_;
    const std::size_t column = k % columns() / on_;
    double greatest = 0.0; // of the elements around
    for (const std::size_t i : {row, std::min(row + 1, rows_ - 1)}) {
      for (const std::size_t j : {column, std::min(column + 1, columns_ - 1)}) {
        greatest = std::max(greatest, pressure[i * columns_ + j]);
      }
    }
    fine[k] = greatest > 0.0 ? std::sqrt(std::max(fine[k], 0.0)) : 0.0;
  }
  return fine;
}

} // namespace driver
