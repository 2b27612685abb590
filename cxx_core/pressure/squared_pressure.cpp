#include "pressure/squared_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "pressure/constants.hpp"

namespace wrc {

namespace {

/// p^2 at one, two and three steps in one direction; whether the grid reaches as far as two.
struct Direction {
  double near;
  double far;
  double farther;
  bool far_is_known;

  /// Steps from the first of them to the edge: the root of their parabola, a little farther out.
  /// Past the centre without pressure it comes back with the slope of p^2.
  [[nodiscard]] double edge() const {
    const double bend = std::clamp(2.0 * far - near - farther, 0.0, farther);
    const double slope = far - near + 0.5 * bend;
    const double root = 2.0 * near / (slope + std::sqrt(slope * slope + 2.0 * bend * near));
    return root < 1.0 ? std::min(root + edge_beyond_pressures, 1.0)
                      : std::max(1.5 - 0.5 * root, 0.5);
  }
};

/// Calls visit(direction) for every direction that has pressure at one step.
template <typename Visit>
void for_each_direction(const LevelSize& size, std::span<const double> pressure, double scale,
                        std::size_t row, std::size_t column, const Visit& visit) {
  const auto rows = static_cast<std::ptrdiff_t>(size.rows);
  const auto columns = static_cast<std::ptrdiff_t>(size.columns);
  const auto inside = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
    return i >= 0 && i < rows && j >= 0 && j < columns;
  };
  const auto square_at = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
    if (!inside(i, j)) {
      return 0.0;
    }
    const double p = scale * pressure[static_cast<std::size_t>(i * columns + j)];
    return p > 0.0 ? p * p : 0.0;
  };
  const auto i = static_cast<std::ptrdiff_t>(row);
  const auto j = static_cast<std::ptrdiff_t>(column);
  for (std::ptrdiff_t di = -1; di <= 1; ++di) {
    for (std::ptrdiff_t dj = -1; dj <= 1; ++dj) {
      const double near = square_at(i + di, j + dj);
      if (near > 0.0) {
        visit(Direction{near, square_at(i + 2 * di, j + 2 * dj), square_at(i + 3 * di, j + 3 * dj),
                        inside(i + 2 * di, j + 2 * dj)});
      }
    }
  }
}

} // namespace

void square_and_continue(const LevelSize& size, std::span<const double> pressure,
                         std::vector<double>& squares) {
  squares.resize(size.count());
  for (std::size_t row = 0; row < size.rows; ++row) {
    for (std::size_t column = 0; column < size.columns; ++column) {
      const std::size_t index = row * size.columns + column;
      const double p = pressure[index];
      squares[index] = p * p;
      if (p > 0.0) {
        continue;
      }
      double sum = 0.0;
      double directions = 0.0;
      for_each_direction(size, pressure, 1.0, row, column, [&](const Direction& one) {
        sum += one.far > 0.0 ? 2.0 * one.near - one.far : -one.near;
        directions += 1.0;
      });
      squares[index] = directions > 0.0 ? std::min(0.0, sum / directions) : 0.0;
    }
  }
}

double edge_square(const LevelSize& size, std::span<const double> pressure, double scale,
                   std::size_t row, std::size_t column) {
  double sum = 0.0;
  double weight = 0.0;
  double unknown_sum = 0.0;
  double unknown_weight = 0.0;
  for_each_direction(size, pressure, scale, row, column, [&](const Direction& one) {
    const double near = one.near;
    if (!one.far_is_known) {
      unknown_sum -= near * near;
      unknown_weight += near;
      return;
    }
    const double edge = one.edge();
    sum -= near * near * (1.0 - edge) / edge;
    weight += near;
  });
  if (weight > 0.0) {
    return std::min(0.0, sum / weight);
  }
  return unknown_weight > 0.0 ? unknown_sum / unknown_weight : 0.0;
}

} // namespace wrc
