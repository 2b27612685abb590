/// Curves through points: order of convergence, arc length, errors.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/spline.hpp"
#include "support/errors.hpp"

namespace wrc::test::spline_test {
namespace {

std::vector<Position> arc_points(double radius, int count) {
  std::vector<Position> points;
  for (int i = 0; i < count; ++i) {
    const double angle = -1.0 + 2.0 * i / (count - 1);
    points.push_back({radius * std::sin(angle), radius * (1.0 - std::cos(angle))});
  }
  return points;
}

double largest_error(const Curve& curve, double radius) {
  double largest = 0.0;
  for (double s = 0.0; s < curve.length(); s += 0.013)
    largest = std::max(
        largest, std::abs(std::hypot(curve.at(s).lateral, curve.at(s).height - radius) - radius));
  return largest;
}

TEST(Spline, ConvergesWithTheFourthOrder) {
  const double radius = 20.0;
  double before = 0.0;
  for (const int count : {11, 21, 41}) {
    const Curve curve = curve_through(arc_points(radius, count));
    const double error = largest_error(curve, radius);
    if (before > 0.0) {
      EXPECT_GT(std::log2(before / error), 3.5) << count; // 4 asymptotically
    }
    before = error;
    EXPECT_NEAR(curve.length(), 2.0 * radius, error);
  }
}

TEST(Spline, RunsByArcLengthAlongUnevenPoints) {
  std::vector<Position> points = arc_points(20.0, 81);
  for (std::size_t i = 70; i > 10; i -= 3)
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
  const Curve curve = curve_through(points);
  for (double s = 0.0; s < curve.length(); s += 0.013) {
    const CurvePoint point = curve.at(s);
    EXPECT_NEAR(std::hypot(point.tangent_lateral, point.tangent_height), 1.0, 1e-6);
    // Second order of the spline's second derivative, spacing up to 1 mm on R 20.
    EXPECT_NEAR(point.curvature() * 20.0, 1.0, 3e-3);
  }
}

TEST(Spline, PassesThroughItsPoints) {
  const std::vector<Position> points = arc_points(20.0, 15);
  const Curve curve = curve_through(points);
  for (const Position& point : points) {
    double least = HUGE_VAL;
    for (const double s : curve.starts())
      least = std::min(least,
                       std::hypot(curve.at(s).lateral - point[0], curve.at(s).height - point[1]));
    EXPECT_LT(least, 1e-12);
  }
}

TEST(Spline, TakesVerticalParts) {
  // A quarter of a circle that begins vertically: no slope d height / d lateral exists there.
  std::vector<Position> points;
  for (int i = 0; i <= 20; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / 20.0;
    points.push_back({-10.0 * std::cos(angle), 10.0 * std::sin(angle)});
  }
  const Curve curve = curve_through(points);
  EXPECT_NEAR(curve.at(0.0).tangent_lateral, 0.0, 1e-4);
  EXPECT_NEAR(curve.at(0.0).tangent_height, 1.0, 1e-4);
}

TEST(Spline, RefusesPointsThatJumpBackAndForth) {
  // A digit lost and lines missing, as in a damaged file: the curve would swing ever further.
  std::vector<Position> points;
  for (int i = -34; i <= -17; ++i) {
    points.push_back({static_cast<double>(i), -0.01 * i * i});
  }
  points.push_back({34.0, -11.56});
  EXPECT_NO_THROW((void)curve_through(points));
  points[6][0] = -14.0;
  points[15][1] = -3.22;
  test::expect_error(
      ErrorCode::invalid_argument, [&] { (void)curve_through(points); }, "jump back and forth");
}

TEST(Spline, RefusesDegeneratePoints) {
  EXPECT_THROW((void)curve_through(std::vector<Position>{{0, 0}, {1, 0}, {2, 0}}), Error);
  EXPECT_THROW((void)curve_through(std::vector<Position>{{0, 0}, {1, 0}, {1, 0}, {2, 0}}), Error);
  EXPECT_THROW((void)curve_through(std::vector<Position>{{0, 0}, {1, 0}, {NAN, 0}, {2, 0}}), Error);
}

} // namespace
} // namespace wrc::test::spline_test
