#include "remesh/rail_normals.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "profile/standard_profiles.hpp"

namespace wrc::test::rail_normals_test {
namespace {

const RailSurface& rail() {
  static const RailSurface surface(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  return surface;
}

ContactFrame frame_at(double y, double angle) {
  return tangent_frame({2.0, y, rail().graph().at_lateral(y).height}, angle);
}

const Grid grid{9, 7, 0.4, 0.9, -1.6, -2.7};

std::vector<double> pressures() {
  std::vector<double> pressure(grid.element_count());
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    pressure[i] = 100.0 + 37.0 * static_cast<double>(i % 5);
  }
  return pressure;
}

/// Near the gauge corner, where the rail's radius is 13 mm, in a plane beside it.
TEST(RailNormals, AlongThePlanesNormalPressuresAddUp) {
  const ContactFrame frame = frame_at(725.0, -0.5);
  const RailNormals normals(rail(), frame, grid);
  const std::vector<double> pressure = pressures();
  double sum = 0.0;
  for (const double p : pressure) {
    sum += p * grid.element_area();
  }
  const ContactForce force = normals.force(pressure);
  EXPECT_NEAR(dot(force.force, frame.normal), sum, 1e-10 * sum);
  EXPECT_EQ(force.force.x, 0.0);
  EXPECT_GT(std::abs(dot(force.force, frame.lateral)), 1e-2 * sum);
  // A vertical shift is shared out as the vertical force is.
  const std::vector<double> shares = normals.shares({0.0, 0.0, 1.0});
  double vertical = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    vertical += shares[i] * pressure[i] * grid.element_area();
  }
  EXPECT_NEAR(force.force.z, vertical, 1e-10 * sum);
}

TEST(RailNormals, RatesAreThoseOfDifferences) {
  const ContactFrame frame = frame_at(725.0, -0.5);
  constexpr double step = 1e-5;
  const RailNormals normals(rail(), frame, grid);
  const auto moved = [&](double sign) {
    Grid other = grid;
    other.longitudinal_first += sign * step * 0.3;
    other.lateral_first += sign * step * 0.7;
    return RailNormals(rail(), frame, other);
  };
  const RailNormals ahead = moved(1.0);
  const RailNormals behind = moved(-1.0);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const RailNormals::Rates rates = normals.rates(row, 2, 0.3, 0.7);
    const Vector3 direction = (0.5 / step) * (ahead.direction(row, 2) - behind.direction(row, 2));
    const Vector3 arm = (0.5 / step) * (ahead.arm(row, 2) - behind.arm(row, 2));
    EXPECT_LT(norm(rates.direction - direction), 1e-6) << row;
    EXPECT_LT(norm(rates.arm - arm), 1e-6) << row;
  }
}

/// To first order: what is left goes with the square of the shift.
TEST(RailNormals, AShiftedPlaneHasTheNormalsOfItsNewPosition) {
  ContactFrame frame = frame_at(725.0, -0.5);
  constexpr double shift = 5e-4;
  RailNormals shifted(rail(), frame, grid);
  const RailNormals before = shifted;
  shifted.shift({0.0, 0.0, -shift});
  frame.origin.z -= shift;
  const RailNormals anew(rail(), frame, grid);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    EXPECT_LT(norm(shifted.direction(row, 0) - anew.direction(row, 0)), 1e-7) << row;
    EXPECT_GT(norm(before.direction(row, 0) - anew.direction(row, 0)), 5e-6) << row;
    EXPECT_LT(norm(shifted.arm(row, 0) - anew.arm(row, 0)), 1e-7) << row;
  }
}

TEST(RailNormals, TheTurnIsThatUnderThePressures) {
  const ContactFrame frame = frame_at(725.0, -0.5);
  const RailNormals normals(rail(), frame, grid);
  std::vector<double> pressure(grid.element_count(), 0.0);
  const auto inclination = [&](std::size_t row) {
    return -dot(normals.direction(row, 0), frame.lateral);
  };
  pressure[2 * grid.longitudinal_count + 3] = 100.0;
  pressure[6 * grid.longitudinal_count + 1] = 300.0;
  const SurfaceTurn turn = normals.turn(pressure);
  const double mean = 0.25 * inclination(2) + 0.75 * inclination(6);
  EXPECT_NEAR(turn.mean, mean, 1e-12);
  EXPECT_NEAR(turn.deviation, std::sqrt(0.1875) * std::abs(inclination(6) - inclination(2)), 1e-12);
  EXPECT_NEAR(turn.range(), std::abs(std::atan(inclination(6)) - std::atan(inclination(2))), 1e-12);
  EXPECT_NEAR(turn.weight, 400.0 * grid.element_area(), 1e-9);
  EXPECT_EQ(normals.turn(std::vector<double>(grid.element_count(), 0.0)).weight, 0.0);
}

} // namespace
} // namespace wrc::test::rail_normals_test
