/// Wheel and rail rotated together about the track's x axis: the same contact, whose forces turn.
///
/// Gravity does not enter, since positions are prescribed. Without yaw, which is about z.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mechanics/normal_solver.hpp"
#include "remesh/mean_curve.hpp"
#include "remesh/rail_normals.hpp"
#include "remesh/undeformed_distance.hpp"
#include "support/energy_pairs.hpp"

namespace wrc::test::rotated_scene_test {
namespace {

constexpr std::array laterals{0.0, 3.0, 4.7, 5.0, 6.0, 6.5, 7.0, 8.0};
constexpr std::array angles{0.01, -0.05, 0.1};

Vector3 turned(const Vector3& vector, double angle) {
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  return {vector.x, cosine * vector.y - sine * vector.z, sine * vector.y + cosine * vector.z};
}

/// S1002 on the Manchester UIC60 where 80 kN press it: tread, two lobes, gauge corner and flange.
Scene scene_at(double lateral, AccuracyOf accuracy_of, CurvedChoice curved) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "UIC60-Manchester";
  scene.lateral = lateral;
  scene.side = SideChoice::left;
  scene.accuracy_of = accuracy_of;
  scene.curved = curved;
  stay_where_loaded(scene);
  return scene;
}

Scene turned(Scene scene, double angle) {
  const RailSurface rail(standard_profile(scene.left.rail.name), scene.track);
  const Vector3 origin{0.0, rail.origin_y(), rail.origin_z()};
  const Vector3 moved = turned(origin, angle) - origin;
  scene.left.displacement = {moved.y, moved.z, angle};
  const Vector3 centre = turned(Vector3{0.0, scene.lateral, *scene.vertical}, angle);
  scene.lateral = centre.y;
  scene.vertical = centre.z;
  scene.roll = *scene.roll + angle;
  return scene;
}

struct Contact {
  std::vector<double> distance;
  std::vector<double> angles;
  std::vector<double> pressure;
  Vector3 force;
};

/// On rows along the curve over a plane, at the position of the wheel.
Contact contact_over(const WheelResult& wheel, ContactFrame frame, const Grid& grid) {
  const PosedPair pair = wheel.details.pair();
  frame.curve =
      mean_curve(pair, frame, grid.lateral_first, grid.lateral(grid.lateral_count - 1)).curve;
  Contact contact{sample_undeformed_distance(pair, frame, grid), row_angles(frame, grid), {}, {}};
  const PatchGap gap{grid, contact.distance, 1.0, {}, {}, contact.angles};
  NormalProblem problem;
  problem.patches = {&gap, 1};
  problem.combined_modulus = wheel.details.request.combined_modulus;
  problem.approach = 0.0;
  problem.tolerance = 1e-9;
  contact.pressure = NormalSolver().solve(problem).patches[0].pressure;
  contact.force = RailNormals(pair.rail, frame, grid).force(contact.pressure).force;
  return contact;
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  EXPECT_EQ(one.size(), other.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (one[i] != other[i]) {
      largest = std::max(largest, std::abs(one[i] - other[i]));
    }
  }
  return largest;
}

/// A patch that is rotated too stays as it is, except for the rounding of positions of 1e3 mm. The
/// solver's tolerance is 1e-9.
TEST(RotatedScene, HasTheSamePressuresOnTheSameElements) {
  constexpr double rounding = 2e-12; // mm
  constexpr double rounding_of_angles = 1e-10;
  constexpr double solver = 2e-9;
  for (const double lateral : laterals) {
    const Scene scene = scene_at(lateral, AccuracyOf::forces, CurvedChoice::yes);
    const SceneResult result = solve_scene(scene);
    const PatchResult& patch = result.left->patches.at(0);
    const double plane = patch.frame.angle();
    const Contact here =
        contact_over(*result.left, tangent_frame(patch.frame.origin, plane), patch.grid);
    const double largest = *std::max_element(here.pressure.begin(), here.pressure.end());
    for (const double angle : angles) {
      const std::string where = std::to_string(lateral) + ", " + std::to_string(angle);
      const SceneResult other = solve_scene(turned(scene, angle));
      const Contact there = contact_over(
          *other.left, tangent_frame(turned(patch.frame.origin, angle), plane + angle), patch.grid);
      EXPECT_LT(largest_difference(there.distance, here.distance), rounding) << where;
      EXPECT_LT(largest_difference(there.angles, here.angles), rounding_of_angles) << where;
      EXPECT_LT(largest_difference(there.pressure, here.pressure), solver * largest) << where;
      EXPECT_LT(norm(there.force - turned(here.force, angle)), solver * norm(here.force)) << where;
    }
  }
}

void expect_results_to(double accuracy, CurvedChoice curved) {
  for (const double lateral : laterals) {
    Scene scene = scene_at(lateral, AccuracyOf::pressures, curved);
    scene.accuracy = accuracy;
    const SceneResult here = solve_scene(scene);
    const Vector3& force = here.left->force;
    for (const double angle : angles) {
      const SceneResult there = solve_scene(turned(scene, angle));
      EXPECT_LT(norm(there.left->force - turned(force, angle)), accuracy * norm(force))
          << accuracy << ", " << lateral << ", " << angle;
      // Each is within the accuracy.
      EXPECT_NEAR(there.left->pmax, here.left->pmax, 2.0 * accuracy * here.left->pmax)
          << accuracy << ", " << lateral << ", " << angle;
    }
  }
}

/// As a whole its elements come from overlaps that are measured vertically, and differ: results
/// change by less than the accuracy, whatever it is.
TEST(RotatedScene, HasTheSameForcesAndPressuresToTheAccuracy) {
  for (const double accuracy : {1e-2, 1e-3, 1e-4}) {
    expect_results_to(accuracy, CurvedChoice::yes);
    expect_results_to(accuracy, CurvedChoice::by_accuracy);
  }
}

/// The directions of planes change too. They count to second order, which no accuracy reduces.
TEST(RotatedScene, HasTheSameResultsInPlanesToTheirModelError) {
  expect_results_to(1e-3, CurvedChoice::no);
}

} // namespace
} // namespace wrc::test::rotated_scene_test
