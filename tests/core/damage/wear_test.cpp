// Wear: balance of energy and volume, and each law by hand.
#include "damage/wear.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace wear_test {
namespace {

using namespace wrc;

constexpr double rounding = 1e-12;

/// Random pressures that slide in part, tractions against the slip.
struct Contact {
  Grid grid{12, 16, 0.5, 0.4, -3.0, -3.2};
  std::vector<double> p, qx, qy, sx, sy;
  SlidingContact sliding;

  explicit Contact(double slip) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < grid.element_count(); ++i) {
      p.push_back(800.0 * any(random));
      const double angle = 6.28 * any(random);
      const double s = any(random) < 0.6 ? slip * any(random) : 0.0;
      sx.push_back(s * std::cos(angle));
      sy.push_back(s * std::sin(angle));
      qx.push_back(-0.3 * p.back() * std::cos(angle));
      qy.push_back(-0.3 * p.back() * std::sin(angle));
      sum += 0.3 * p.back() * s * grid.element_area();
    }
    // A tenth of the power is lost on the grid.
    sliding = {grid, p, qx, qy, sx, sy, 0.3, 20000.0, sum > 0.0 ? sum / 0.9 : 5.0};
  }
};

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Wear, EnergyOfAllElementsIsThePower) {
  for (const double slip : {0.01, 0.0}) { // and where the grid shows no slip
    const Contact contact(slip);
    const Wear wear = wear_of(contact.sliding, {});
    EXPECT_NEAR(sum_of(wear.energy) * contact.grid.element_area(), contact.sliding.power_per_speed,
                rounding * contact.sliding.power_per_speed);
  }
}

TEST(Wear, VolumeIsCoefficientTimesWork) {
  const Contact contact(0.002); // 40 mm/s at most: mild
  const double work = contact.sliding.power_per_speed;
  const Wear energy = wear_of(contact.sliding, {WearLaw::energy, 2e-8, 0.0, 1.5});
  EXPECT_NEAR(energy.volume, 1.5 * 2e-8 * work, rounding * 1.5 * 2e-8 * work);
  const double hardness = 3000.0;
  const Wear archard = wear_of(contact.sliding, {WearLaw::archard, 0.0, hardness, 1.0});
  const double expected = 5e-4 / (0.3 * hardness) * work; // k W/(mu H)
  EXPECT_NEAR(archard.volume, expected, rounding * expected);
}

TEST(Wear, DepthAcrossHoldsTheVolume) {
  const Contact contact(0.02);
  for (const WearLaw law : {WearLaw::usfd, WearLaw::archard}) {
    const Wear wear = wear_of(contact.sliding, {law, 0.0, 3000.0, 1.0});
    const double all = sum_of(wear.rate) * contact.grid.element_area();
    EXPECT_NEAR(wear.volume, all, rounding * all);
    EXPECT_NEAR(sum_of(wear.depth) * contact.grid.lateral_step, all, rounding * all);
    EXPECT_GT(all, 0.0);
  }
}

TEST(Wear, MapOfArchardsCoefficient) {
  EXPECT_EQ(archard_coefficient(100.0, 1000.0, 3000.0), 5e-4);
  EXPECT_EQ(archard_coefficient(500.0, 1000.0, 3000.0), 35e-4);
  EXPECT_EQ(archard_coefficient(900.0, 1000.0, 3000.0), 5e-4);
  EXPECT_EQ(archard_coefficient(100.0, 2500.0, 3000.0), 350e-4);
}

TEST(Wear, UsfdLawByHand) {
  EXPECT_DOUBLE_EQ(usfd_wear_rate(2.0), 10.6);
  EXPECT_DOUBLE_EQ(usfd_wear_rate(30.0), 55.0);
  EXPECT_DOUBLE_EQ(usfd_wear_rate(87.2), 55.0 + 619.0);
  // One element of 1 mm^2, 2 N/mm^2: 10.6 ug/m are 10.6e-6 g/m / 7.85e-3 g/mm^3 = 1.35e-3 mm^3/m.
  const std::vector<double> one{100.0};
  const std::vector<double> traction{-20.0};
  const std::vector<double> slip{0.1};
  const std::vector<double> none{0.0};
  const Wear wear =
      wear_of({{1, 1, 1.0, 1.0, 0.0, 0.0}, one, traction, none, slip, none, 0.2, 1e4, 2.0}, {});
  EXPECT_NEAR(wear.volume, 10.6e-6 / 7.85e-3 / 1000.0, 1e-18);
  EXPECT_DOUBLE_EQ(wear.depth.front(), wear.volume);
}

} // namespace
} // namespace wear_test
