#include "profile/smoothing.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.hpp"

extern "C" {
/// LAPACK: solves A x = b with A symmetric positive definite and banded.
void dpbsv_(const char* uplo, const int* n, const int* kd, const int* nrhs, double* ab,
            const int* ldab, double* b, const int* ldb, int* info);
}

namespace wrc {
namespace {

/// Of the matrix (not a tuning constant).
constexpr int bandwidth = 2;
constexpr int band_rows = bandwidth + 1;

void check(std::span<const double> abscissa, std::span<const double> value, double wavelength) {
  if (abscissa.size() != value.size()) {
    throw_invalid_argument("number of values", std::to_string(value.size()),
                           std::to_string(abscissa.size()) + ", as there are abscissae");
  }
  if (abscissa.size() < 3 ||
      abscissa.size() > static_cast<std::size_t>(std::numeric_limits<int>::max() / band_rows)) {
    throw_invalid_argument("number of values", std::to_string(value.size()), "at least 3");
  }
  if (!(wavelength > 0.0) || !std::isfinite(wavelength)) {
    throw_invalid_argument("smoothing wavelength", wavelength, "a positive finite number, mm");
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!std::isfinite(value[i])) {
      throw_invalid_argument("value " + std::to_string(i), value[i], "a finite number");
    }
    if (i > 0 && !(abscissa[i] > abscissa[i - 1])) {
      throw_invalid_argument("abscissa " + std::to_string(i), abscissa[i],
                             "above " + text_of(abscissa[i - 1]));
    }
  }
}

/// Column j of Q: the second difference over points j, j + 1, j + 2.
struct SecondDifference {
  double first;
  double middle;
  double last;
};

std::vector<Position> smooth_over(const std::vector<double>& arc, std::span<const Position> points,
                                  double wavelength) {
  std::vector<double> lateral;
  std::vector<double> height;
  for (const Position& point : points) {
    lateral.push_back(point[0]);
    height.push_back(point[1]);
  }
  lateral = smooth_values(arc, lateral, wavelength);
  height = smooth_values(arc, height, wavelength);
  std::vector<Position> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back({lateral[i], height[i]});
  }
  return result;
}

std::vector<double> chord_lengths(std::span<const Position> points) {
  std::vector<double> arc;
  for (std::size_t i = 0; i < points.size(); ++i) {
    arc.push_back(i == 0 ? 0.0
                         : arc.back() + std::hypot(points[i][0] - points[i - 1][0],
                                                   points[i][1] - points[i - 1][1]));
  }
  return arc;
}

} // namespace

std::vector<double> smooth_values(std::span<const double> abscissa, std::span<const double> value,
                                  double wavelength) {
  check(abscissa, value, wavelength);
  const std::size_t n = abscissa.size();
  const std::size_t m = n - 2;
  const double lambda = std::pow(wavelength / (2.0 * std::numbers::pi), 4);
  const auto step = [&](std::size_t i) { return abscissa[i + 1] - abscissa[i]; };
  const auto inverse_weight = [&](std::size_t i) {
    return 2.0 / ((i > 0 ? step(i - 1) : 0.0) + (i + 1 < n ? step(i) : 0.0));
  };
  const auto column = [&](std::size_t j) {
    const double first = 1.0 / step(j);
    const double last = 1.0 / step(j + 1);
    return SecondDifference{first, -first - last, last};
  };

  // (R + lambda Q' W^-1 Q) g = Q' z, upper band by columns: row 2 is the diagonal.
  std::vector<double> band(static_cast<std::size_t>(band_rows) * m, 0.0);
  std::vector<double> second(m);
  for (std::size_t j = 0; j < m; ++j) {
    const SecondDifference q = column(j);
    double* const entry = band.data() + static_cast<std::size_t>(band_rows) * j;
    entry[2] =
        (step(j) + step(j + 1)) / 3.0 + lambda * (q.first * q.first * inverse_weight(j) +
                                                  q.middle * q.middle * inverse_weight(j + 1) +
                                                  q.last * q.last * inverse_weight(j + 2));
    if (j >= 1) {
      const SecondDifference before = column(j - 1);
      entry[1] = step(j) / 6.0 + lambda * (before.middle * q.first * inverse_weight(j) +
                                           before.last * q.middle * inverse_weight(j + 1));
    }
    if (j >= 2) {
      entry[0] = lambda * column(j - 2).last * q.first * inverse_weight(j);
    }
    second[j] = q.first * value[j] + q.middle * value[j + 1] + q.last * value[j + 2];
  }
  const char upper = 'U';
  const int order = static_cast<int>(m);
  const int right_sides = 1;
  int info = 0;
  dpbsv_(&upper, &order, &bandwidth, &right_sides, band.data(), &band_rows, second.data(), &order,
         &info);
  if (info != 0) {
    throw Error(ErrorCode::internal,
                "smoothing wavelength = " + text_of(wavelength) +
                    " mm: too long relative to the spacing of the closest points");
  }

  std::vector<double> smoothed(value.begin(), value.end());
  for (std::size_t j = 0; j < m; ++j) {
    const SecondDifference q = column(j);
    smoothed[j] -= lambda * inverse_weight(j) * q.first * second[j];
    smoothed[j + 1] -= lambda * inverse_weight(j + 1) * q.middle * second[j];
    smoothed[j + 2] -= lambda * inverse_weight(j + 2) * q.last * second[j];
  }
  return smoothed;
}

std::vector<Position> smooth_points(std::span<const Position> points, double wavelength) {
  const std::vector<Position> first = smooth_over(chord_lengths(points), points, wavelength);
  return smooth_over(chord_lengths(first), points, wavelength);
}

} // namespace wrc
