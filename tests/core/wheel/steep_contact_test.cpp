// A sphere on a plane does not know how the plane is inclined.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "half_space/material.hpp"
#include "patches/plane_area.hpp"
#include "pressure/contact_area.hpp"
#include "support/patch_problem.hpp"
#include "support/simple_profiles.hpp"
#include "wheel/solve_wheel.hpp"

namespace wrc::test::steep_contact_test {
namespace {

const double modulus = combined_modulus({210000.0, 0.3}, {210000.0, 0.3});
constexpr double radius = 460.0;
constexpr double approach = 0.05;
constexpr std::array angles{0.0, 1.0, 10.0, 20.0, 30.0, 45.0, 60.0, 70.0, 75.0}; // degrees
/// Coordinates of some hundred mm carry 1e-13 mm, distances along a normal at 75 degrees four
/// times as much, of an approach of 0.05 mm; 1e-9 were measured, for the area 1.4e-8.
constexpr double exact = 1e-7;
/// With the load given the final area is drawn around the elements of a coarse solution in contact;
/// one row of them more or less moves the elements of the final grid: 2.3e-5 were measured.
/// Of the area from the zero line, which tells more of the rounding at the edge of contact.
constexpr double area_tolerance = 1e-6;
constexpr double row_tolerance = 5e-5;

struct Answer {
  double normal_force = 0.0;
  double peak_pressure = 0.0;
  double area = 0.0;
  double element = 0.0; ///< size, mm: that of a side follows from the ends of penetration
};

struct SphereOnPlane {
  explicit SphereOnPlane(double plane_angle)
      : angle(plane_angle), wheel(spherical_wheel(radius), {1360.0, 70.0, radius}),
        rail(inclined_rail(plane_angle), {1435.0, 14.0, 0.0}) {
    double lateral = 0.0;
    double height = 0.0;
    rail.to_profile_frame(0.0, 0.0, lateral, height);
    middle = {0.0, -lateral, -height};
    EquilibriumRequest request;
    request.roll = 0.0;
    request.right = false;
    // The contact lies in the middle of the plane.
    request.lateral = middle.y - radius * std::sin(angle) - 750.0;
    equilibrium = *find_equilibrium({wheel, rail}, {wheel, rail}, request).left;
  }
  [[nodiscard]] double pressed_in() const {
    return middle.z + radius * std::cos(angle) - approach / std::cos(angle);
  }
  [[nodiscard]] Answer solve(WheelRequest request) const {
    request.combined_modulus = modulus;
    request.grid = {{64, 64}};
    request.tolerance = 1e-9;
    NormalSolver solver;
    const WheelSolution solution = solve_wheel(wheel, rail, equilibrium, request, solver);
    EXPECT_EQ(solution.patches.size(), 1u);
    EXPECT_TRUE(solution.warnings.empty());
    const Patch& patch = solution.patches.at(0);
    EXPECT_NEAR(patch.frame.angle(), angle, 1e-10);
    return {patch.normal_force, solution.peak_pressure, contact_area(patch.grid, patch.pressure),
            patch.grid.lateral_step};
  }

  double angle;
  WheelSurface wheel;
  RailSurface rail;
  Vector3 middle;
  SideEquilibrium equilibrium;
};

void expect_same(const Answer& answer, const Answer& level, double tolerance) {
  EXPECT_NEAR(answer.normal_force, level.normal_force, tolerance * level.normal_force);
  EXPECT_NEAR(answer.peak_pressure, level.peak_pressure, tolerance * level.peak_pressure);
  // The area's own error, 2/n^2, depends on where the elements lie.
  const double scaled = std::abs(answer.element / level.element - 1.0);
  EXPECT_LE(scaled, 1e-5);
  EXPECT_NEAR(answer.area, level.area, (std::max(tolerance, area_tolerance) + scaled) * level.area);
}

TEST(SteepContact, DistancesAndPressuresAgreeInTheFrameOfThePlane) {
  Answer level;
  for (const double degrees : angles) {
    SCOPED_TRACE(degrees);
    const SphereOnPlane made(degrees * std::numbers::pi / 180.0);
    // The sphere that sinks also slides along the plane.
    const double slide = approach * std::tan(made.angle);
    const Vector3 origin{0.0, made.middle.y - slide * std::cos(made.angle),
                         made.middle.z - slide * std::sin(made.angle)};
    const PosedPair pair{made.wheel, made.rail, made.equilibrium.pose, made.pressed_in()};
    const Grid grid = grid_over({-6.0, 6.0, -6.0, 6.0}, 64, 64);
    const auto distance = sample_undeformed_distance(pair, tangent_frame(origin, made.angle), grid);
    PatchProblem problem(grid, distance, modulus);
    problem.approach = 0.0;
    problem.tolerance = 1e-9;
    const PatchSolution solution = NormalSolver().solve(problem);
    const Answer answer{solution.normal_force, peak_pressure(grid, solution.pressure),
                        contact_area(grid, solution.pressure), grid.lateral_step};
    if (degrees == 0.0) {
      level = answer;
    }
    expect_same(answer, level, exact);
  }
}

TEST(SteepContact, WholeSideAtTheSamePosition) {
  Answer level;
  for (const double degrees : angles) {
    SCOPED_TRACE(degrees);
    const SphereOnPlane made(degrees * std::numbers::pi / 180.0);
    WheelRequest request;
    request.vertical = made.pressed_in();
    const Answer answer = made.solve(request);
    if (degrees == 0.0) {
      level = answer;
    }
    expect_same(answer, level, exact);
  }
}

TEST(SteepContact, WholeSideUnderTheSameNormalForce) {
  constexpr double normal_force = 36893.0;
  Answer level;
  for (const double degrees : angles) {
    SCOPED_TRACE(degrees);
    const SphereOnPlane made(degrees * std::numbers::pi / 180.0);
    WheelRequest request;
    request.vertical_load = normal_force * std::cos(made.angle);
    const Answer answer = made.solve(request);
    EXPECT_NEAR(answer.normal_force, normal_force, exact * normal_force);
    if (degrees == 0.0) {
      level = answer;
    }
    EXPECT_NEAR(answer.peak_pressure, level.peak_pressure, row_tolerance * level.peak_pressure);
    // The area from the zero line of p^2 has an error of 7 / n^2 with n elements across.
    EXPECT_NEAR(answer.area, level.area, 2e-3 * level.area);
  }
}

} // namespace
} // namespace wrc::test::steep_contact_test
