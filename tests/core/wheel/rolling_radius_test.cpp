/// Which radius a deformed wheel rolls on: the stretch of a sphere's surface under its load, where
/// slip by the half-space knows none (cxx_core/creep/README.md, "Which height").
///
/// A sphere of radius 1 under Hertz's pressures at two opposite poles, as a series of Legendre
/// polynomials (Lur'e, Three-Dimensional Problems of the Theory of Elasticity, 1964, ch. 6): with
/// the surface load p_n P_n and N = n^2 + n + 1 + nu (2 n + 1),
///   A = p_n/(4 G N),  B = -A (n^2 + 2 n - 1 + 2 nu)/(n - 1)
///   u_r = (A (n + 1)(n - 2 + 4 nu) + B n) P_n,  u_theta = (A (n + 5 - 4 nu) + B) dP_n/dtheta.
/// The half-space's mean stretch of the surface is -(1 - 2 nu) p/(4 G) at its place.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::rolling_radius_test {
namespace {

struct UnderLoad {
  double stretch = 0.0; ///< beyond the half-space's, in the mean over the pressures
  double depth = 0.0;   ///< of the pole
};

/// Largest pressure 1, shear modulus 1, contact radius `size`.
UnderLoad sphere(double size, double nu) {
  constexpr std::size_t places = 400;
  const auto last = static_cast<int>(60.0 / size);
  std::vector<double> cosine;
  std::vector<double> weight; // of p sin(theta) d theta, theta = size sin(t)
  double load = 0.0;
  for (std::size_t i = 0; i < places; ++i) {
    const double step = 0.5 * std::numbers::pi / static_cast<double>(places);
    const double t = (static_cast<double>(i) + 0.5) * step;
    const double theta = size * std::sin(t);
    cosine.push_back(std::cos(theta));
    weight.push_back(std::cos(t) * std::sin(theta) * size * std::cos(t) * step);
    load += weight.back();
  }
  UnderLoad found;
  std::vector<double> before(places);
  std::vector<double> polynomial(places, 1.0);
  for (int n = 0; n <= last; ++n) {
    double moment = 0.0;
    for (std::size_t i = 0; i < places; ++i) {
      if (n > 0) {
        const double next =
            ((2.0 * n - 1.0) * cosine[i] * polynomial[i] - (n - 1.0) * before[i]) / n;
        before[i] = polynomial[i];
        polynomial[i] = next;
      }
      moment += weight[i] * polynomial[i];
    }
    if (n % 2 == 0) {
      const double pressure = (2.0 * n + 1.0) * moment; // of both poles
      const double a = 0.25 / (n * n + n + 1.0 + nu * (2.0 * n + 1.0));
      const double b = n == 0 ? 0.0 : -a * (n * n + 2.0 * n - 1.0 + 2.0 * nu) / (n - 1.0);
      const double radial = a * (n + 1.0) * (n - 2.0 + 4.0 * nu) + b * n;
      const double along = n == 0 ? 0.0 : a * (n + 5.0 - 4.0 * nu) + b;
      const double stretch = radial - 0.5 * n * (n + 1.0) * along + 0.25 * (1.0 - 2.0 * nu);
      found.stretch += stretch * pressure * moment / load;
      found.depth -= radial * pressure;
    }
  }
  return found;
}

// Were the rolling radius that of the mean surface, the stretch would be -0.8 of the depth (Hertz's
// depths in the mean over his pressures); were it that of the undeformed sphere, 0.
TEST(RollingRadius, OfASphereIsNearerToTheUndeformedOne) {
  constexpr double nu = 0.28;
  for (const double size : {0.05, 0.02}) {
    const UnderLoad found = sphere(size, nu);
    const double hertz = 0.25 * std::numbers::pi * (1.0 - nu) * size;
    EXPECT_NEAR(found.depth, hertz, 0.02 * hertz);
    EXPECT_LT(-found.stretch, 0.4 * found.depth);
    EXPECT_GT(-found.stretch, 0.3 * found.depth);
  }
}

} // namespace
} // namespace wrc::test::rolling_radius_test
