/// Lines that meet wheels, against bisection, and the derivatives of F against differences.
#include "geometry/wheel_line.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"
#include "profile/standard_profiles.hpp"

namespace wrc::test::wheel_line_test {
namespace {

std::vector<WheelSurface> wheels() {
  const Profile s1002 = standard_profile("S1002");
  return {WheelSurface(s1002, wheelset),
          wavy_wheel(s1002.curve, {{1, 0.5, 0.3}, {20, 0.01, -1.0}}, 0.7),
          wheel_of(flattened_cylinder(460.0, 0.2, 0.004,
                                      [](double t) { return rounded_depth(t, 0.9, 0.1); }),
                   0.031)};
}

double radius_at(const WheelSurface& wheel, const Vector3& point) {
  return wheel.radius() + wheel.over(point)->height;
}

double function_at(const WheelSurface& wheel, const Vector3& point) {
  const double radius = radius_at(wheel, point);
  return 0.5 * (point.x * point.x + point.z * point.z - radius * radius);
}

/// From well outside, below the wheel, to its axle.
double bisected(const WheelSurface& wheel, const Vector3& from, const Vector3& direction) {
  double low = -60.0;
  double high = 300.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (function_at(wheel, from + middle * direction) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST(WheelLine, MeetsTheWheelWhereBisectionDoes) {
  for (const WheelSurface& wheel : wheels()) {
    WheelLine line(wheel, 0.0);
    for (const double along : {0.0, 0.1, -0.05})
      for (const double across : {0.0, 0.05, -0.1})
        for (double x = -60.0; x <= 60.0; x += 17.3)
          for (double y = -10.0; y <= 20.0; y += 6.1) {
            const double length = std::hypot(1.0, along, across);
            const Vector3 direction{along / length, across / length, 1.0 / length};
            const Vector3 from{x, y, -465.0};
            const auto position = line.meet(from, direction);
            ASSERT_TRUE(position) << x << ' ' << y;
            EXPECT_NEAR(*position, bisected(wheel, from, direction), 1e-11) << x << ' ' << y;
            const Vector3 met = from + *position * direction;
            EXPECT_NEAR(line.lateral(), met.y, 1e-12);
            EXPECT_NEAR(wheel.radius() + line.height(), std::hypot(met.x, met.z), 1e-10);
          }
  }
}

TEST(WheelLine, MeetsNothingBesideTheWheel) {
  for (const WheelSurface& wheel : wheels()) {
    WheelLine line(wheel, 0.0);
    EXPECT_FALSE(line.meet({0.0, 150.0, -465.0}, {0.0, 0.0, 1.0}));
    EXPECT_FALSE(line.meet({0.0, -100.0, -465.0}, {0.0, 0.0, 1.0}));
    EXPECT_FALSE(line.meet({500.0, 0.0, -465.0}, {0.0, 0.0, 1.0})); // ahead of it
  }
}

/// Differences of the fourth order over 0.05 mm, away from joints of the profile and from slices.
TEST(WheelLine, HasTheDerivativesOfDifferences) {
  const std::array<Vector3, 3> axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  const double step = 0.05;
  for (const WheelSurface& wheel : wheels()) {
    const WheelLine line(wheel, 0.0);
    for (const Vector3& point : {Vector3{10.3, 12.3, -459.0}, Vector3{-31.0, -8.3, -458.1}}) {
      const auto rate = [&](const auto& function, const Vector3& axis) {
        const auto at = [&](double steps) { return function(point + (steps * step) * axis); };
        return (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
      };
      const Vector3 gradient = line.gradient(point);
      const std::array<double, 3> first{gradient.x, gradient.y, gradient.z};
      const SecondDerivatives second = line.second_derivatives(point, wheel.over(point).value());
      const double matrix[3][3] = {{second.xx, second.xy, second.xz},
                                   {second.xy, second.yy, second.yz},
                                   {second.xz, second.yz, second.zz}};
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(first.at(i),
                    rate([&](const Vector3& at) { return function_at(wheel, at); }, axes.at(i)),
                    1e-6 * wheel.radius());
        for (std::size_t j = 0; j < 3; ++j)
          EXPECT_NEAR(matrix[i][j],
                      rate([&](const Vector3& at) { return dot(line.gradient(at), axes.at(i)); },
                           axes.at(j)),
                      1e-6)
              << i << ' ' << j;
      }
    }
  }
}

} // namespace
} // namespace wrc::test::wheel_line_test
