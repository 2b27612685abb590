/// The closed form of a disc in a hole against what it must satisfy.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/conformal_disc.hpp"

namespace wrc::test::conformal_disc_test {
namespace {

constexpr double rounding =
    1e-11; // of sums of a few hundred values, and of differences of logarithms
constexpr std::array half_angles{0.02, 0.1, 0.3, 0.6, 1.0, 1.4};

/// Double exponential rule: values may be infinite at both ends.
template <class Function> double integral(double from, double to, Function function) {
  constexpr int count = 400;
  constexpr double step = 3.5 / count;
  const double half = 0.5 * (to - from);
  double sum = 0.0;
  for (int i = -count; i <= count; ++i) {
    const double inner = 0.5 * std::numbers::pi * std::sinh(step * i);
    const double cosh = std::cosh(inner);
    const double weight = 0.5 * std::numbers::pi * std::cosh(step * i) / (cosh * cosh);
    sum += weight * function(0.5 * (from + to) + half * std::tanh(inner));
  }
  return sum * step * half;
}

TEST(ConformalDisc, CarriesTheLoad) {
  for (const double end : half_angles) {
    const ConformalDisc disc(end);
    const double load =
        integral(-end, end, [&](double angle) { return disc.pressure(angle) * std::cos(angle); });
    EXPECT_NEAR(load, 1.0, rounding) << end;
  }
}

/// u + dR - (dR + approach) cos(phi) is 0 all over the contact.
TEST(ConformalDisc, TouchesWhereItCarries) {
  for (const double end : half_angles) {
    const ConformalDisc disc(end);
    const auto displacement = [&](double at) {
      const auto influence = [&](double angle) {
        const double chord = 2.0 * std::sin(0.5 * std::abs(at - angle));
        return chord > 0.0 ? disc.pressure(angle) * (-std::cos(at - angle) * std::log(chord) - 0.25)
                           : 0.0;
      };
      return 2.0 / std::numbers::pi *
             (integral(-end, at, influence) + integral(at, end, influence));
    };
    const double middle = displacement(0.0);
    for (const double share : {0.2, 0.5, 0.8, 0.95}) {
      const double fallen = 1.0 - std::cos(share * end);
      const double clearance = (middle - displacement(share * end)) / fallen - middle;
      EXPECT_NEAR(clearance, disc.clearance(), rounding / fallen) << end << ", " << share;
    }
  }
}

TEST(ConformalDisc, IsThatOfHertzIfItIsNarrow) {
  for (const double end : {0.02, 0.1}) {
    const ConformalDisc disc(end);
    const DiscAnswer hertz = disc.by_hertz();
    EXPECT_NEAR(hertz.half_angle / end, 1.0, 0.3 * end * end);
    EXPECT_NEAR(hertz.largest_pressure / disc.pressure(0.0), 1.0, 0.5 * end * end);
    for (const double share : {0.3, 0.6, 0.9}) {
      EXPECT_NEAR(disc.pressure(share * end) / disc.pressure(0.0), std::sqrt(1.0 - share * share),
                  end * end);
    }
  }
}

TEST(ConformalDisc, FillsTheHoleBelow148Rad) {
  EXPECT_GT(ConformalDisc(1.479).clearance(), 0.0);
  EXPECT_LT(ConformalDisc(1.481).clearance(), 0.0);
}

} // namespace
} // namespace wrc::test::conformal_disc_test
