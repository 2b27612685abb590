/// Virtual penetration of an ellipse in closed form, its scaling laws, and the yawed strips.
#include "models/kik_piotrowski.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "models/hertz.hpp"
#include "support/errors.hpp"

namespace wrc::test::kik_piotrowski_test {
namespace {

constexpr double modulus = 115384.6;

/// Strips of A x^2 + B y^2 - 2 B y0 y ... about the contact point at y = 0, by the midpoint rule
/// in t^2 to both sides: error 1/n^2.
std::vector<KikPiotrowskiStrip> ellipse_strips(double a, double b, double approach,
                                               double drift = 0.0) {
  constexpr int count = 400;
  const double half_width = std::sqrt(virtual_penetration_share * approach / b);
  std::vector<KikPiotrowskiStrip> strips;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    for (const double side : {-1.0, 1.0}) {
      const double y = side * half_width * t * t;
      strips.push_back({y, half_width * 2.0 * t / count,
                        (virtual_penetration_share * approach - b * y * y) / a, drift * y});
    }
  }
  return strips;
}

KikPiotrowskiContact solve_ellipse(double a, double b, double approach, double drift = 0.0) {
  return solve_virtual_penetration(ellipse_strips(a, b, approach, drift),
                                   std::sqrt(virtual_penetration_share * approach / a), modulus,
                                   approach);
}

TEST(KikPiotrowski, EllipseHasHertzsShapeAndLawOnItsOwnArea) {
  constexpr double approach = 0.08;
  for (const double ratio : {0.01, 0.2, 1.0, 3.0, 50.0}) {
    const double a = 1.0 / 920.0;
    const double b = ratio * a;
    const KikPiotrowskiContact contact = solve_ellipse(a, b, approach);
    const double area = virtual_penetration_share * std::numbers::pi * approach / std::sqrt(a * b);
    EXPECT_NEAR(contact.area / area, 1.0, 1e-4);
    // Along over across: that of Hertz's ellipse for the same bodies.
    const HertzContact hertz = solve_hertz(2.0 * a, 2.0 * b, modulus, 1.0);
    const double axes = hertz.semi_axis_longitudinal / hertz.semi_axis_lateral;
    EXPECT_NEAR(contact.semi_axis_longitudinal / contact.semi_axis_lateral / axes, 1.0, 1e-3);
    const double along = std::sqrt(area * axes / std::numbers::pi);
    const double across = along / axes;
    EXPECT_NEAR(contact.semi_axis_longitudinal / along, 1.0, 1e-3);
    const auto [shorter, longer] = std::minmax({along, across});
    const double eccentricity = std::sqrt(1.0 - shorter * shorter / (longer * longer));
    const double load = 2.0 / 3.0 * std::numbers::pi * modulus * longer * approach /
                        std::comp_ellint_1(eccentricity);
    EXPECT_NEAR(contact.normal_force / load, 1.0, 1e-3) << ratio;
    EXPECT_NEAR(contact.peak_pressure / (1.5 * load / area), 1.0, 1e-3) << ratio;
    EXPECT_NEAR(contact.centroid_lateral, 0.0, 1e-12);
  }
}

TEST(KikPiotrowski, CircleIsFivePerCentTooWideAtTheSameApproach) {
  // 0.55 in place of 0.5: semi-axes and load too large by sqrt(1.1), pressures too small by it.
  const KikPiotrowskiContact contact = solve_ellipse(1.0 / 920.0, 1.0 / 920.0, 0.08);
  const HertzContact hertz = solve_hertz_for_approach(1.0 / 460.0, 1.0 / 460.0, modulus, 0.08);
  const double factor = std::sqrt(1.1);
  EXPECT_NEAR(contact.semi_axis_lateral / hertz.semi_axis_lateral, factor, 1e-3);
  EXPECT_NEAR(contact.normal_force / hertz.normal_force, factor, 1e-3);
  EXPECT_NEAR(contact.peak_pressure / hertz.peak_pressure, 1.0 / factor, 1e-3);
}

TEST(KikPiotrowski, ScalesLikeTheHalfSpace) {
  const KikPiotrowskiContact one = solve_ellipse(1e-3, 5e-3, 0.05);
  // Approach: load to the power of 3/2, pressures and axes with its root.
  const KikPiotrowskiContact deeper = solve_ellipse(1e-3, 5e-3, 0.2);
  EXPECT_NEAR(deeper.normal_force / one.normal_force, 8.0, 1e-9);
  EXPECT_NEAR(deeper.peak_pressure / one.peak_pressure, 2.0, 1e-9);
  EXPECT_NEAR(deeper.semi_axis_lateral / one.semi_axis_lateral, 2.0, 1e-9);
  // All lengths times ten.
  const KikPiotrowskiContact larger = solve_ellipse(1e-4, 5e-4, 0.5);
  EXPECT_NEAR(larger.normal_force / one.normal_force, 100.0, 1e-7);
  EXPECT_NEAR(larger.peak_pressure / one.peak_pressure, 1.0, 1e-9);
}

TEST(KikPiotrowski, StripsBesideTheContactPointMeetAPlainSum) {
  // No stretch for a circle but for the drift; I2 by brute force from peak pressure and approach.
  constexpr double a = 1.0 / 920.0;
  constexpr double approach = 0.08;
  for (const double drift : {1e-6, 0.02, 0.3}) {
    const KikPiotrowskiContact contact = solve_ellipse(a, a, approach, drift);
    const double half = std::sqrt(virtual_penetration_share * approach / a);
    // x = centre + l sin(angle): the pressure's root at both ends is gone; points miss x = y = 0.
    double displaced = 0.0;
    constexpr int angles = 400;
    for (const KikPiotrowskiStrip& strip : ellipse_strips(a, a, approach, drift)) {
      const double square = strip.half_length_square;
      for (int i = 0; i < angles; ++i) {
        const double angle = std::numbers::pi * ((i + 0.5) / angles - 0.5);
        const double x = strip.centre + std::sqrt(square) * std::sin(angle);
        displaced += strip.weight * square * std::cos(angle) * std::cos(angle) * std::numbers::pi /
                     angles / std::hypot(x, strip.lateral);
      }
    }
    const double peak = std::numbers::pi * modulus * approach / displaced * half;
    // The sum over angles is coarse next to the contact point.
    EXPECT_NEAR(contact.peak_pressure / peak, 1.0, 4e-3) << drift;
  }
  // The two ways to integrate a strip meet where the centre moves to 0.
  const double straight = solve_ellipse(a, 4.0 * a, approach).peak_pressure;
  EXPECT_NEAR(solve_ellipse(a, 4.0 * a, approach, 1e-9).peak_pressure / straight, 1.0, 1e-4);
}

/// At the end of a profile: once "curvature_ratio = inf".
TEST(KikPiotrowski, SaysThatAContactHasNoWidth) {
  for (const std::vector<KikPiotrowskiStrip>& strips :
       {std::vector<KikPiotrowskiStrip>{}, {{0.01, 0.02, 0.0, 0.0}}}) {
    expect_error(
        ErrorCode::no_contact, [&] { (void)solve_virtual_penetration(strips, 2.0, modulus, 0.01); },
        "kik-piotrowski", "narrower than a row", "half-space");
  }
}

} // namespace
} // namespace wrc::test::kik_piotrowski_test
