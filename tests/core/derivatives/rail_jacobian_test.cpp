/// Derivatives of contact forces by a rail's position and velocity, against central differences of
/// whole scenes.
#include "derivatives/rail_jacobian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "creep/rolling_frame.hpp"
#include "support/state_differences.hpp"

namespace wrc::test::rail_jacobian_test {
namespace {

/// Of a column's largest entry, as for the wheelset's own columns (force_jacobian_test.cpp).
constexpr double tolerance = 1.2e-2;
/// By the roll of a rail: three columns, which cancel in part.
constexpr double roll_tolerance = 2e-2;

/// The contact may lie so close to the point about which the rail rolls that nothing but small
/// terms are left: then of the column of a point this far away, mm.
constexpr double usual_arm = 10.0;

/// In a curve of 300 m, on a rail that is displaced and moves.
Scene curving_scene(double lateral) {
  Scene scene;
  scene.lateral = lateral;
  scene.yaw = 4e-3;
  scene.accuracy = 6e-4;
  scene.accuracy_of = AccuracyOf::forces;
  scene.left.displacement = {0.5, -0.2, 2e-3};
  scene.right.displacement = {-0.3, 0.1, -1e-3};
  const SceneResult under_load = solve_scene(scene);
  scene.roll = under_load.roll;
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  scene.motion = Motion{.speed = 2e4,
                        .pitch = 1.0005 * 2e4 / 460.0,
                        .lateral = 20.0,
                        .vertical = 5.0,
                        .roll = 0.005,
                        .yaw = 0.01,
                        .curvature = 1.0 / 3e5};
  scene.left.velocity = {10.0, -5.0, 0.02};
  scene.right.velocity = {-8.0, 3.0, -0.01};
  return scene;
}

double& rail_state(SceneSide& side, std::size_t which) {
  RailDisplacement& moved = which < 3 ? side.displacement : side.velocity;
  return which % 3 == 0 ? moved.lateral : which % 3 == 1 ? moved.height : moved.roll;
}

class RailJacobians : public testing::TestWithParam<double> {};

TEST_P(RailJacobians, AreThoseOfCentralDifferences) {
  Scene scene = curving_scene(GetParam());
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  scene.derivatives = false;
  for (const bool right : {false, true}) {
    const auto side = right ? &SceneResult::right : &SceneResult::left;
    SceneSide Scene::*moved_side = right ? &Scene::right : &Scene::left;
    const RailJacobian jacobian = rail_jacobian_of(*(here.*side), *(here.*side)->jacobian());
    scene.side = right ? SideChoice::right : SideChoice::left;
    // Rolling about a point some 10 mm below the contact moves it little.
    const std::array<double, rail_state_count> steps{0.01, 0.002, 2e-5, 2.0, 10.0, 0.2};
    for (std::size_t which = 0; which < rail_state_count; ++which) {
      ForceColumn found{};
      for (std::size_t row = 0; row < found.size(); ++row) {
        found[row] = jacobian[row][which] / (row < 3 ? 1.0 : contact_arm);
      }
      double least = 0.0;
      for (std::size_t row = 0; row < 3; ++row) {
        const double of_lateral = usual_arm * std::abs(jacobian[row][which - which % 3]);
        least = std::max(least, which % 3 == 2 ? of_lateral : 0.0);
      }
      const auto error_over = [&](double step) {
        const auto forces = [&](double change) {
          Scene moved = scene;
          rail_state(moved.*moved_side, which) += change;
          return force_column(*(solve_scene(moved).*side));
        };
        const ForceColumn ahead = forces(step);
        const ForceColumn behind = forces(-step);
        ForceColumn rate{};
        for (std::size_t row = 0; row < rate.size(); ++row) {
          rate[row] = (ahead[row] - behind[row]) / (2.0 * step);
        }
        double apart = 0.0;
        double largest = least;
        for (std::size_t row = 0; row < rate.size(); ++row) {
          apart = std::max(apart, std::abs(found[row] - rate[row]));
          largest = std::max(largest, std::abs(rate[row]));
        }
        return apart / largest;
      };
      // A jump of elements within the step, as in force_jacobian_test.cpp.
      const double limit = which % 3 == 2 ? roll_tolerance : tolerance;
      double error = error_over(steps.at(which));
      for (const double times : {3.0, 0.25}) {
        error = error > limit ? std::min(error, error_over(times * steps.at(which))) : error;
      }
      EXPECT_LE(error, limit) << which << (right ? " right" : " left");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(LateralPositions, RailJacobians, testing::Values(-2.0, 1.0, 6.5));

/// Without friction and motion a rolled rail turns the force with it.
TEST(RailJacobiansWithoutCreepForces, HoldTheRatesAtZero) {
  Scene scene = curving_scene(1.0);
  scene.motion.reset();
  SceneResult here = solve_scene(scene);
  const RailJacobian jacobian = rail_jacobian_of(*here.left, *here.left->jacobian());
  for (const auto& row : jacobian) {
    for (std::size_t which = 3; which < rail_state_count; ++which) {
      EXPECT_EQ(row[which], 0.0);
    }
  }
  EXPECT_EQ(jacobian[2][1], -(*here.left->jacobian())[2][1]);
}

TEST(RailJacobiansOfMirrorImages, MirrorToTheLastBit) {
  Scene scene = curving_scene(2.0);
  scene.derivatives = true;
  SceneResult one = solve_scene(scene);
  std::swap(scene.left, scene.right);
  for (SceneSide* side : {&scene.left, &scene.right}) {
    side->displacement = mirrored(side->displacement);
    side->velocity = mirrored(side->velocity);
  }
  scene.lateral = -scene.lateral;
  scene.yaw = -scene.yaw;
  *scene.roll = -*scene.roll;
  scene.motion = mirrored(*scene.motion);
  SceneResult other = solve_scene(scene);
  const RailJacobian left = rail_jacobian_of(*one.left, *one.left->jacobian());
  const RailJacobian right = rail_jacobian_of(*other.right, *other.right->jacobian());
  for (std::size_t which = 0; which < rail_state_count; ++which) {
    const bool turns = which % 3 != 1;
    for (std::size_t row = 0; row < 6; ++row) {
      EXPECT_EQ(left[row][which], (row % 2 == 1) == turns ? right[row][which] : -right[row][which])
          << row << ' ' << which;
    }
  }
}

} // namespace
} // namespace wrc::test::rail_jacobian_test
