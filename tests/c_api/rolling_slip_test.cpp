/// Rigid slip that the caller gives for each element of a rolling contact.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "wrcontact.hpp"

namespace wrc::test::rolling_slip_test {
namespace {

constexpr double radius = 5.0;
constexpr double load = 80000.0;
constexpr double friction = 0.3;

// Slip of each element is added to that of the creepages: what is planar in it counts as they do.
TEST(RollingProblem, SlipOfElementsIsAddedToThatOfCreepages) {
  constexpr int n = 24;
  constexpr double step = 2.0 * radius / n;
  std::vector<double> pressure;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double x = (2 * i + 1.0) / n - 1.0;
      const double y = (2 * j + 1.0) / n - 1.0;
      pressure.push_back(1.5 * load / (std::numbers::pi * radius * radius) *
                         std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
  }
  wrcontact::RollingContact contact;
  contact.set_grid(n, n, step, step);
  contact.set_pressure(pressure);
  contact.set("longitudinal_creepage", -0.001);
  contact.set("lateral_creepage", -0.0008);
  contact.set("spin_creepage", -0.0004);
  contact.set("tolerance", 1e-6);
  ASSERT_TRUE(contact.solve());
  const double whole = contact.number("creep_force.longitudinal");
  const double moment = contact.number("spin_moment");
  const double power = contact.number("friction_power");
  std::vector<double> x;
  std::vector<double> y;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      x.push_back(-0.001 + 0.0004 * ((j + 0.5) * step - radius));
      y.push_back(-0.0008 - 0.0004 * ((i + 0.5) * step - radius));
    }
  }
  contact.set_slip(x, y);
  for (const char* creepage : {"longitudinal_creepage", "lateral_creepage", "spin_creepage"}) {
    contact.set(creepage, 0.0);
  }
  ASSERT_TRUE(contact.solve());
  constexpr double of_iteration = 2e-5; // in mu N
  EXPECT_NEAR(contact.number("creep_force.longitudinal"), whole, of_iteration * friction * load);
  EXPECT_NEAR(contact.number("spin_moment"), moment, of_iteration * friction * load * radius);
  EXPECT_NEAR(contact.number("friction_power"), power, of_iteration * power);
  contact.set_slip({}, {});
  ASSERT_TRUE(contact.solve());
  EXPECT_EQ(contact.number("creep_force.longitudinal"), 0.0);
  EXPECT_THROW(contact.set_slip(x, {}), wrcontact::Error);
}

} // namespace
} // namespace wrc::test::rolling_slip_test
