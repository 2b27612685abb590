/// Slip and tractions of rows along a curve, against velocities and sums in space.
#include <cmath>

#include <gtest/gtest.h>

#include "creep/creep_on_patch.hpp"
#include "creep/kinematics.hpp"
#include "creep/patch_motion.hpp"
#include "creep/rigid_slip.hpp"
#include "creep/total_force.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::curved_slip_test {
namespace {

/// Two lobes at the gauge corner, which turn by 0.28 rad.
Scene rolling(CurvedChoice curved) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "UIC60-Manchester";
  scene.lateral = 5.0;
  scene.yaw = 2e-3;
  scene.side = SideChoice::left;
  scene.curved = curved;
  scene.accuracy_of = AccuracyOf::forces;
  scene.motion = Motion{.speed = 2e4};
  return scene;
}

TEST(CurvedSlip, IsTheVelocityOfTheElementAlongItsTangent) {
  const SceneResult result = solve_scene(rolling(CurvedChoice::yes));
  const PatchResult& patch = result.left->patches.at(0);
  ASSERT_TRUE(patch.frame.curve);
  const ContactFrame& frame = patch.frame;
  const Twist twist = rigid_slip(*result.left->details.motion, frame, patch.approach, 0.0).twist;
  const Vector3 velocity =
      twist[0] * frame.longitudinal + twist[1] * frame.lateral + twist[2] * frame.normal;
  const Vector3 turning =
      twist[3] * frame.longitudinal + twist[4] * frame.lateral + twist[5] * frame.normal;
  const Vector3 origin = frame.origin - patch.approach * frame.normal;
  const Grid& grid = patch.creep->grid;
  const std::vector<SlipRow> rows = rows_on(*result.left, patch, grid, SlipChoice{});
  ASSERT_EQ(rows.size(), grid.lateral_count);
  const SlipField beyond = slip_beyond(*patch.slip, rows, grid, twist);
  const Creepages fitted = fitted_creepages(*patch.slip, twist);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const SurfacePlace place =
        surfaces_at(result.left->details.pair(), frame, 0.0, grid.lateral(row));
    if (!place.on_wheel || !place.on_rail) {
      continue;
    }
    const Vector3 tangent = rows[row].cosine * frame.lateral + rows[row].sine * frame.normal;
    EXPECT_NEAR(dot(tangent, frame.row_at(grid.lateral(row)).lateral), 1.0, 1e-6) << row;
    for (const std::size_t column : {std::size_t{0}, grid.longitudinal_count - 1}) {
      const double x = grid.longitudinal(column);
      // The height is that of the wheel at x = 0.
      const Vector3 here = place.wheel + x * frame.longitudinal;
      const Vector3 moves = velocity + cross(turning, here - origin);
      const double y = grid.lateral(row);
      const std::size_t at = row * grid.longitudinal_count + column;
      EXPECT_NEAR(beyond.x[at] + fitted.longitudinal - fitted.spin * y,
                  dot(moves, frame.longitudinal), 1e-12)
          << row;
      EXPECT_NEAR(beyond.y[at] + fitted.lateral + fitted.spin * x, dot(moves, tangent), 1e-12)
          << row;
    }
  }
}

TEST(CurvedSlip, ForcesAreThoseOfTractionsAlongTheTangents) {
  const SceneResult result = solve_scene(rolling(CurvedChoice::yes));
  const PatchResult& patch = result.left->patches.at(0);
  ASSERT_TRUE(patch.parts.empty());
  const CreepResult& creep = *patch.creep;
  const Grid& grid = creep.grid;
  const std::vector<SlipRow> rows = rows_on(*result.left, patch, grid, SlipChoice{});
  Vector3 sum;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const Vector3 tangent =
        rows[row].cosine * patch.frame.lateral + rows[row].sine * patch.frame.normal;
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const std::size_t at = row * grid.longitudinal_count + column;
      sum = sum + creep.traction_x[at] * patch.frame.longitudinal + creep.traction_y[at] * tangent;
    }
  }
  sum = grid.element_area() * sum;
  const Vector3 of_creep = patch.total_force - patch.force;
  // Sums of the solver and of the fields differ by single precision.
  EXPECT_LT(norm(sum - of_creep), 1e-5 * norm(sum));
  // Along the plane they would be others.
  const Vector3 planar = creep.longitudinal_force * patch.frame.longitudinal +
                         creep.lateral_force * patch.frame.lateral;
  EXPECT_GT(norm(planar - of_creep), 1e-3 * norm(sum));
}

/// The power of the force and moment on the wheel's motion over the rail is what friction takes,
/// less what pressures take in the slip that they cause.
TEST(CurvedSlip, ForceTimesMotionIsTheDissipation) {
  for (const CurvedChoice curved : {CurvedChoice::no, CurvedChoice::yes}) {
    const SceneResult result = solve_scene(rolling(curved));
    const PatchResult& patch = result.left->patches.at(0);
    const CreepResult& creep = *patch.creep;
    const RigidSlip slip =
        rigid_slip(*result.left->details.motion, patch.frame, patch.approach, 0.0);
    const Wrench fitted =
        wrench_of(patch.slip->creepages_by_twist,
                  {creep.longitudinal_force, creep.lateral_force, creep.spin_moment});
    double power = 0.0;
    for (std::size_t i = 0; i < twist_count; ++i) {
      power -= slip.twist[i] * (fitted[i] + creep.beyond_creepages[i]);
    }
    EXPECT_GT(power, 0.0);
    EXPECT_NEAR(power + creep.power_of_pressures, creep.power_per_speed, 1e-9 * power);
    EXPECT_NE(creep.power_of_pressures, 0.0);
    EXPECT_LT(std::abs(creep.power_of_pressures), 1e-2 * power);
    // Slip times traction of the elements shows it but for the discretisation.
    double work = 0.0;
    for (std::size_t i = 0; i < creep.traction_x.size(); ++i) {
      work -= creep.traction_x[i] * creep.slip_x[i] + creep.traction_y[i] * creep.slip_y[i];
    }
    EXPECT_NEAR(creep.grid.element_area() * work, power, 0.05 * power);
  }
}

/// Pressures slide over each other in proportion to the speed of rolling, so that nothing is left
/// of creep forces at standstill, nor jumps where the wheel starts to roll backwards.
TEST(CurvedSlip, VanishesAtStandstill) {
  const auto force = [](double speed) {
    Scene scene = rolling(CurvedChoice::yes);
    scene.yaw = 0.0;
    scene.motion = Motion{.speed = speed};
    const PatchResult patch = solve_scene(scene).left->patches.at(0);
    return norm(patch.total_force - patch.force) / (patch.creep->friction * patch.normal_force);
  };
  EXPECT_EQ(force(0.0), 0.0);
  const double slow = force(1e-4);
  EXPECT_GT(slow, 0.0);
  EXPECT_LT(slow, 1e-3);
  EXPECT_NEAR(force(-1e-4), slow, 1e-3 * slow);
}

/// At small creepages, where what pressures add shows; in steady rolling and in a step of time.
TEST(CurvedSlip, ForcesChangeWithTheShareOfRolling) {
  const SceneResult result = solve_scene(rolling(CurvedChoice::yes));
  const WheelResult& wheel = *result.left;
  CreepRequest request;
  request.model = CreepModel::full;
  request.derivatives = true;
  request.material.modulus = 82000.0;
  request.material.poisson = 0.28;
  RollingSolver solver;
  for (const double step_length : {0.0, 3.0}) {
    const auto at = [&](double share, CreepResult& creep) {
      PatchMotion motion;
      motion.creepages = {1e-4, -5e-5, 1e-6};
      motion.friction = 0.3;
      motion.step_length = step_length;
      motion.rolling_share = share;
      return forces_on_patch({wheel, wheel.patches.at(0), motion, request, nullptr}, solver, creep);
    };
    constexpr double step = 0.01;
    CreepResult creep;
    CreepResult unused;
    const CreepForces ahead = at(0.5 + step, unused);
    const CreepForces behind = at(0.5 - step, unused);
    const CreepForces here = at(0.5, creep);
    const double by_share = (ahead.longitudinal - behind.longitudinal) / (2.0 * step);
    ASSERT_TRUE(creep.derivatives->by_rolling_share);
    EXPECT_GT(std::abs(by_share), 0.05 * std::abs(here.longitudinal));
    EXPECT_NEAR((*creep.derivatives->by_rolling_share)[0], by_share, 0.02 * std::abs(by_share))
        << step_length;
  }
}

} // namespace
} // namespace wrc::test::curved_slip_test
