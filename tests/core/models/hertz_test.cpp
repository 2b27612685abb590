/// Hertz in closed form: circle, line-contact limit, the standard library's elliptic integrals.
#include "models/hertz.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace wrc::test::hertz_test {
namespace {

constexpr double modulus = 115384.6;
/// A few units of rounding through cube roots and the arithmetic-geometric mean.
constexpr double rounding = 1e-14;

TEST(Hertz, CircleHasItsOwnClosedForm) {
  const double radius = 460.0;
  const double load = 80000.0;
  const HertzContact contact = solve_hertz(1.0 / radius, 1.0 / radius, modulus, load);
  // Johnson (1985), eqs. 4.22 to 4.24.
  const double axis = std::cbrt(0.75 * load * radius / modulus);
  EXPECT_NEAR(contact.semi_axis_longitudinal / axis, 1.0, rounding);
  EXPECT_NEAR(contact.semi_axis_lateral / axis, 1.0, rounding);
  EXPECT_NEAR(contact.peak_pressure / (1.5 * load / (std::numbers::pi * axis * axis)), 1.0,
              rounding);
  EXPECT_NEAR(contact.approach / (axis * axis / radius), 1.0, rounding);
}

TEST(Hertz, AxisRatioSolvesItsEquation) {
  // Johnson (1985), eq. 4.28, with the standard library's K and E; the library works from the
  // modulus e, so the check loses digits as the ellipse gets slender (k^2 = 1 - e^2).
  for (const double axes : {1.5, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    const double k = 1.0 / axes;
    const double e = std::sqrt(1.0 - k * k);
    const double complete_k = std::comp_ellint_1(e);
    const double complete_e = std::comp_ellint_2(e);
    const double curvatures = (complete_e / (k * k) - complete_k) / (complete_k - complete_e);
    EXPECT_NEAR(hertz_axis_ratio(curvatures) * axes, 1.0, 1e-12) << axes;
  }
  EXPECT_EQ(hertz_axis_ratio(1.0), 1.0);
  // Nearly round: a/b = (curvature ratio)^(2/3), next order beyond rounding here.
  EXPECT_NEAR((1.0 - hertz_axis_ratio(1.0 + 1e-7)) / 1e-7, 2.0 / 3.0, 1e-6);
}

TEST(Hertz, AxisRatioOfTheTables) {
  // Hertz's table as in Johnson (1985) and Timoshenko & Goodier (1970), art. 140: theta with
  // cos theta = (B - A)/(B + A); m and n to the four figures printed.
  struct Row {
    double theta;
    double m;
    double n;
  };
  for (const Row& row : {Row{30.0, 2.731, 0.493}, Row{45.0, 1.926, 0.604}, Row{60.0, 1.486, 0.717},
                         Row{75.0, 1.202, 0.846}, Row{90.0, 1.0, 1.0}}) {
    const double cosine = std::cos(row.theta * std::numbers::pi / 180.0);
    const double ratio = (1.0 + cosine) / (1.0 - cosine);
    EXPECT_NEAR(hertz_axis_ratio(ratio), row.n / row.m, 1.5e-3) << row.theta;
  }
}

TEST(Hertz, SlenderEllipseTendsToTheLineContact) {
  // At the centre of a long ellipse pressure per length P' = p0 pi b/2 and b^2 = 4 P' R/(pi E*)
  // (Johnson, 1985, eq. 4.43): p0 = E* b/(2 R). The error falls like k^2 ln(1/k).
  for (const double ratio : {1e6, 1e8, 1e10}) {
    const double radius = 10.0;
    const HertzContact contact = solve_hertz(1.0 / (radius * ratio), 1.0 / radius, modulus, 1e5);
    const double k = contact.semi_axis_lateral / contact.semi_axis_longitudinal;
    const double line = modulus * contact.semi_axis_lateral / (2.0 * radius);
    EXPECT_NEAR(contact.peak_pressure / line, 1.0, 4.0 * k * k * std::log(4.0 / k) + rounding)
        << ratio;
    EXPECT_LT(k, 1e-3);
  }
}

TEST(Hertz, LoadAndApproachAreInverse) {
  for (const double ratio : {1.0, 3.0, 1e2, 1e4}) {
    const HertzContact by_load = solve_hertz(ratio / 300.0, 1.0 / 300.0, modulus, 5e4);
    const HertzContact by_approach =
        solve_hertz_for_approach(ratio / 300.0, 1.0 / 300.0, modulus, by_load.approach);
    EXPECT_NEAR(by_approach.normal_force / 5e4, 1.0, rounding);
    EXPECT_NEAR(by_approach.peak_pressure / by_load.peak_pressure, 1.0, rounding);
    EXPECT_NEAR(by_approach.semi_axis_lateral / by_load.semi_axis_lateral, 1.0, rounding);
    EXPECT_LT(by_load.semi_axis_longitudinal, by_load.semi_axis_lateral * (1.0 + rounding));
  }
}

TEST(Hertz, PressureIntegratesToTheLoad) {
  const HertzContact contact = solve_hertz(1.0 / 460.0, 1.0 / 50.0, modulus, 8e4);
  constexpr int points = 400;
  double sum = 0.0;
  const double step_x = 2.0 * contact.semi_axis_longitudinal / points;
  const double step_y = 2.0 * contact.semi_axis_lateral / points;
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      sum += hertz_pressure(contact, -contact.semi_axis_longitudinal + (i + 0.5) * step_x,
                            -contact.semi_axis_lateral + (j + 0.5) * step_y);
    }
  }
  // The midpoint rule at a square-root edge: order 3/2 of 1/400.
  EXPECT_NEAR(sum * step_x * step_y / contact.normal_force, 1.0, 2e-4);
  EXPECT_EQ(hertz_pressure(contact, contact.semi_axis_longitudinal * 1.001, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(hertz_pressure(contact, 0.0, 0.0), contact.peak_pressure);
}

TEST(Hertz, EllipseAndBodiesAreInverse) {
  // Curvatures from the ellipse and back; the ellipse feels two thirds of their rounding.
  for (const double axes :
       {1e-3, 1e-2, 0.1, 0.5, 0.999, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.001, 2.0, 10.0, 1e2, 1e3}) {
    const double lateral = 4.0;
    const double load = 6e4;
    const HertzBodies bodies = equivalent_hertz_bodies(axes * lateral, lateral, modulus, load);
    EXPECT_DOUBLE_EQ(bodies.longitudinal_radius * 2.0 * bodies.longitudinal_coefficient, 1.0);
    EXPECT_DOUBLE_EQ(bodies.lateral_radius * 2.0 * bodies.lateral_coefficient, 1.0);
    const HertzContact contact =
        solve_hertz(1.0 / bodies.longitudinal_radius, 1.0 / bodies.lateral_radius, modulus, load);
    EXPECT_NEAR(contact.semi_axis_longitudinal / (axes * lateral), 1.0, 100.0 * rounding) << axes;
    EXPECT_NEAR(contact.semi_axis_lateral / lateral, 1.0, 100.0 * rounding) << axes;
  }
  for (const double curvatures : {1e-6, 1e-3, 0.2, 1.0, 3.0, 1e4, 1e6}) {
    const HertzContact contact = solve_hertz(1.0 / 300.0, curvatures / 300.0, modulus, 7e4);
    const HertzBodies bodies = equivalent_hertz_bodies(contact.semi_axis_longitudinal,
                                                       contact.semi_axis_lateral, modulus, 7e4);
    EXPECT_NEAR(bodies.longitudinal_radius / 300.0, 1.0, 100.0 * rounding) << curvatures;
    EXPECT_NEAR(bodies.lateral_radius * curvatures / 300.0, 1.0, 100.0 * rounding) << curvatures;
  }
  // Sphere: a^3 = 3 Q R/(4 E*) (Johnson, 1985, eq. 4.22).
  const HertzBodies sphere = equivalent_hertz_bodies(5.0, 5.0, modulus, 8e4);
  EXPECT_NEAR(sphere.lateral_radius * 0.75 * 8e4 / (modulus * 125.0), 1.0, rounding);
  EXPECT_EQ(sphere.lateral_radius, sphere.longitudinal_radius);
}

TEST(Hertz, NoLoadGivesNoContact) {
  for (const HertzContact& contact : {solve_hertz(0.01, 0.02, modulus, 0.0),
                                      solve_hertz_for_approach(0.01, 0.02, modulus, -1e-3)}) {
    EXPECT_EQ(contact.normal_force, 0.0);
    EXPECT_EQ(contact.peak_pressure, 0.0);
    EXPECT_EQ(contact.semi_axis_lateral, 0.0);
    EXPECT_EQ(hertz_pressure(contact, 0.0, 0.0), 0.0);
  }
}

TEST(Hertz, RefusesBadInput) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) {
    EXPECT_THROW(solve_hertz(bad, 1.0, 1.0, 1.0), Error);
    EXPECT_THROW(solve_hertz(1.0, bad, 1.0, 1.0), Error);
    EXPECT_THROW(solve_hertz(1.0, 1.0, bad, 1.0), Error);
    EXPECT_THROW(equivalent_hertz_bodies(bad, 1.0, 1.0, 1.0), Error);
    EXPECT_THROW(equivalent_hertz_bodies(1.0, bad, 1.0, 1.0), Error);
    EXPECT_THROW(equivalent_hertz_bodies(1.0, 1.0, bad, 1.0), Error);
    EXPECT_THROW(equivalent_hertz_bodies(1.0, 1.0, 1.0, bad), Error);
  }
  for (const double bad : {-1.0, infinity, std::nan("")}) {
    EXPECT_THROW(solve_hertz(1.0, 1.0, 1.0, bad), Error);
  }
  EXPECT_THROW(solve_hertz_for_approach(1.0, 1.0, 1.0, infinity), Error);
  EXPECT_THROW(hertz_axis_ratio(0.5), Error);
}

} // namespace
} // namespace wrc::test::hertz_test
