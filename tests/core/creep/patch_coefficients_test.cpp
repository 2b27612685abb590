// Coefficients of a patch of any shape: of an ellipse Kalker's, wherever its reference is.
#include "creep/patch_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "records/wheel_result.hpp"
#include "rolling/kalker_coefficients.hpp"

namespace wrc::test::patch_coefficients_test {
namespace {

constexpr double poisson = 0.28;

/// Pressures above 0 in a shape around a centre beside the reference, on a coarse grid.
template <class Shape> WheelResult wheel_on(double a, double b, Shape height) {
  constexpr std::size_t count = 24;
  WheelResult wheel;
  PatchResult& patch = wheel.patches.emplace_back();
  const double dx = 2.7 * a / count;
  const double dy = 2.7 * b / count;
  patch.grid = {count, count, dy, dx, -1.1 - 0.5 * (count - 1) * dy, 0.7 - 0.5 * (count - 1) * dx};
  for (std::size_t i = 0; i < patch.grid.element_count(); ++i) {
    const double u = (patch.grid.longitudinal(i % count) - 0.7) / a;
    const double v = (patch.grid.lateral(i / count) + 1.1) / b;
    patch.pressure.push_back(1000.0 * std::sqrt(std::max(height(u, v), 0.0)));
  }
  patch.contact = summarise_pressure(patch.grid, patch.pressure);
  patch.semi_axis_longitudinal = patch.contact.semi_axis_longitudinal;
  patch.semi_axis_lateral = patch.contact.semi_axis_lateral;
  patch.normal_force = 8e4;
  return wheel;
}

double ellipse(double u, double v) {
  return 1.0 - u * u - v * v;
}

// The pressures' second moments on elements give semi-axes 0.5 % off.
TEST(PatchCoefficients, OfAnEllipseAreKalkers) {
  RollingSolver solver;
  for (const double ratio : {0.5, 1.0, 3.0}) {
    SCOPED_TRACE(ratio);
    WheelResult wheel = wheel_on(4.0 * std::sqrt(ratio), 4.0 / std::sqrt(ratio), ellipse);
    find_patch_coefficients(wheel, poisson, solver);
    const KalkerCoefficients found = wheel.patches[0].kalker.value();
    const KalkerCoefficients exact = kalker_coefficients(ratio, poisson);
    constexpr double tolerance = 0.01;
    EXPECT_NEAR(found.c11 / exact.c11, 1.0, tolerance);
    EXPECT_NEAR(found.c22 / exact.c22, 1.0, tolerance);
    EXPECT_NEAR(found.c23 / exact.c23, 1.0, tolerance);
    EXPECT_NEAR(found.c33 / exact.c33, 1.0, tolerance);
  }
}

// Two lobes side by side with a gap between them: two ellipses that hardly know of each other have
// each half of the area, so c11 is about that of one with its own semi-axes.
TEST(PatchCoefficients, OfTwoLobesAreThoseOfTheirSum) {
  RollingSolver solver;
  WheelResult wheel = wheel_on(4.0, 12.0, [](double u, double v) {
    const double w = 4.0 * (std::abs(v) - 0.7); // lobes of 4 x 3 mm
    return ellipse(u, w);
  });
  find_patch_coefficients(wheel, poisson, solver);
  const PatchResult& patch = wheel.patches[0];
  const double of_both = 2.0 * 4.0 * 3.0 * kalker_coefficients(4.0 / 3.0, poisson).c11;
  const double found =
      patch.kalker.value().c11 * patch.semi_axis_longitudinal * patch.semi_axis_lateral;
  EXPECT_NEAR(found / of_both, 1.0, 0.15);
  // The ellipse with their second moments would transmit more than half as much again.
  const double of_ellipse =
      kalker_coefficients(patch.semi_axis_longitudinal / patch.semi_axis_lateral, poisson).c11 *
      patch.semi_axis_longitudinal * patch.semi_axis_lateral;
  EXPECT_GT(of_ellipse / of_both, 1.4);
}

TEST(PatchCoefficients, AnUnloadedPatchHasNone) {
  RollingSolver solver;
  WheelResult wheel = wheel_on(4.0, 4.0, ellipse);
  wheel.patches[0].normal_force = 0.0;
  find_patch_coefficients(wheel, poisson, solver);
  EXPECT_FALSE(wheel.patches[0].kalker);
}

} // namespace
} // namespace wrc::test::patch_coefficients_test
