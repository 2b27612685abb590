#include "table/tensor_spline.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace wrc {
namespace {

/// Rounding of a few hundred products.
constexpr double spline_rounding = 1e-12;

double cubic(double x) {
  return 0.3 - x + 0.5 * x * x - 0.2 * x * x * x;
}
double slope_of_cubic(double x) {
  return -1.0 + x - 0.6 * x * x;
}

using Spline = TensorSpline<2, 2>;

Spline spline_of_cubics(std::size_t first, std::size_t second) {
  const Spline::Axes axes{SplineAxis(-1.0, 2.0, first), SplineAxis(0.5, 1.5, second)};
  std::vector<double> values;
  for (std::size_t i = 0; i < first; ++i) {
    for (std::size_t j = 0; j < second; ++j) {
      const double x = cubic(axes[0].node(i));
      const double y = cubic(axes[1].node(j));
      values.insert(values.end(), {x * y, x - y});
    }
  }
  return {axes, values};
}

TEST(TensorSpline, RepeatsProductsOfCubicsWithTheirSlopes) {
  for (const std::size_t count : {4U, 5U, 6U, 11U}) {
    const Spline spline = spline_of_cubics(count, 4);
    for (const double x : {-1.0, -0.8, 0.1, 1.0, 1.99, 2.0}) {
      for (const double y : {0.5, 0.7, 1.5}) {
        Spline::Values found;
        spline.evaluate({x, y}, found);
        EXPECT_NEAR(found.value[0], cubic(x) * cubic(y), spline_rounding);
        EXPECT_NEAR(found.value[1], cubic(x) - cubic(y), spline_rounding);
        EXPECT_NEAR(found.slope[0][0], slope_of_cubic(x) * cubic(y), 10.0 * spline_rounding);
        EXPECT_NEAR(found.slope[1][0], cubic(x) * slope_of_cubic(y), 10.0 * spline_rounding);
        EXPECT_NEAR(found.slope[1][1], -slope_of_cubic(y), 10.0 * spline_rounding);
      }
    }
  }
}

TEST(TensorSpline, GoesOnAlongItsTangent) {
  const Spline spline = spline_of_cubics(7, 4);
  Spline::Values found;
  spline.evaluate({2.5, 1.0}, found);
  EXPECT_NEAR(found.value[1], cubic(2.0) + 0.5 * slope_of_cubic(2.0) - cubic(1.0), spline_rounding);
  EXPECT_NEAR(found.slope[0][1], slope_of_cubic(2.0), 10.0 * spline_rounding);
}

TEST(TensorSpline, ErrorFallsWithTheFourthPowerOfTheSpacing) {
  const auto error_of = [](std::size_t count) {
    using Line = TensorSpline<1, 1>;
    const Line::Axes axes{SplineAxis(0.0, 3.0, count)};
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(std::sin(axes[0].node(i)));
    }
    const Line line(axes, values);
    double worst = 0.0;
    for (double x = 0.0; x < 3.0; x += 0.01) {
      Line::Values found;
      line.evaluate({x}, found);
      worst = std::max(worst, std::abs(found.value[0] - std::sin(x)));
    }
    return worst;
  };
  EXPECT_GT(error_of(21) / error_of(41), 12.0);
}

} // namespace
} // namespace wrc
