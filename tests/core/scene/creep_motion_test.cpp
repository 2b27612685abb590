/// Creep forces from the motion of the wheelset, and the forces on it.
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "creep/rolling_frame.hpp"
#include "scene/result_names.hpp"
#include "scene/solve_scene.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::creep_motion_test {
namespace {

Scene scene_at(double lateral) {
  Scene scene;
  scene.lateral = lateral;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  return scene;
}

const CreepResult& creep_of(const std::optional<SceneWheel>& wheel) {
  return wheel.value().patches.at(0).creep.value();
}

/// The motion of a case, in our frame.
Motion motion_of_case(const nlohmann::json& input) {
  Motion motion;
  motion.speed = 1e3 * input.at("vx_m_s").get<double>();
  motion.pitch = -input.at("vpitch_rad_s").get<double>();
  motion.lateral = -1e3 * input.at("vy_m_s").get<double>();
  motion.yaw = -input.at("vyaw_rad_s").get<double>();
  motion.curvature = -input.at("track_curvature_per_mm").get<double>();
  return motion;
}

// CONTACT's creepages refer to its own place on the rail and to the pitch rate it was given or
// found.
TEST(CreepMotion, CreepagesOfCreepCasesFollowFromTheMotion) {
  const nlohmann::json cases = creep_wheel_rail_cases();
  int compared = 0;
  for (const auto& entry : cases) {
    // Slip element by element (3) is not three creepages, and a pitch rate may be what is sought.
    if (entry.at("input").at("discretisation_digit") != 2 ||
        entry.at("input").at("vpitch_rad_s").is_null()) {
      continue;
    }
    SCOPED_TRACE(entry.at("id").get<std::string>());
    const auto& input = entry.at("input");
    // That of the wheelset's centre, from the place of the first patch, which bears most. That of
    // the second one of wr79, under 70 degrees, says 0.6 um more.
    std::optional<double> height;
    for (const auto& patch : entry.at("grids").back().at("patches")) {
      const double left = input.at("side") == "left" ? 1.0 : -1.0;
      Motion motion = motion_of_case(input);
      Pose pose{-input.at("y_ws_mm").get<double>(), -input.at("yaw_rad").get<double>(),
                input.at("roll_rad").get<double>()};
      Vector3 place{patch.at("x_tr_mm"), -patch.at("y_tr_mm").get<double>(),
                    -patch.at("z_tr_mm").get<double>()};
      double angle = patch.at("contact_angle_rad");
      if (left < 0.0) {
        motion = mirrored(motion);
        pose = mirrored(pose);
        place.y = -place.y;
        angle = -angle;
      }
      // The place in the wheel profile's coordinates tells the height of the wheelset's centre.
      const Vector3 body = Rotation(pose).to_track(
          {0.0,
           0.5 * input.at("flange_back_distance_mm").get<double>() + 70.0 -
               left * patch.at("y_wheel_mm").get<double>(),
           -input.at("nominal_radius_mm").get<double>() - patch.at("z_wheel_mm").get<double>()});
      height = height.value_or(place.z - body.z);
      const ContactFrame frame = tangent_frame(place, angle);
      const double approach = patch.at("approach_mm");
      const RigidSlip slip = rigid_slip({motion, pose, *height, 460.0, {}}, frame, approach, 0.0);
      EXPECT_NEAR(slip.reference_speed, 1e3 * patch.at("V_ref_m_s").get<double>(), 0.05);
      EXPECT_NEAR(slip.creepages.longitudinal, -patch.at("cksi").get<double>(), 3e-7);
      EXPECT_NEAR(slip.creepages.lateral, left * patch.at("ceta").get<double>(), 3e-7);
      EXPECT_NEAR(slip.creepages.spin, left * patch.at("cphi_per_mm").get<double>(), 2e-9);
      ++compared;
    }
  }
  EXPECT_GE(compared, 25);
}

/// In curves to the left and to the right, and backwards.
TEST(CreepMotion, MotionOfMirrorImagesAndBackwards) {
  Scene scene = scene_at(2.0);
  scene.motion = Motion{.speed = 2e4, .lateral = 10.0, .yaw = 0.01, .curvature = 1e-6};
  const SceneResult one = solve_scene(scene);
  scene.lateral = -2.0;
  scene.motion = mirrored(*scene.motion);
  const SceneResult image = solve_scene(scene);
  EXPECT_EQ(creep_of(one.left).longitudinal_force, creep_of(image.right).longitudinal_force);
  EXPECT_EQ(creep_of(one.left).lateral_force, -creep_of(image.right).lateral_force);
  EXPECT_EQ(creep_of(one.left).spin_moment, -creep_of(image.right).spin_moment);
  EXPECT_GT(creep_of(one.left).friction_power, 0.0);

  // Seen from the front the wheelset that rolls backwards rolls forwards, with left and right
  // exchanged.
  scene.lateral = 2.0;
  scene.motion = Motion{.speed = 2e4, .lateral = 10.0};
  const SceneResult forwards = solve_scene(scene);
  scene.lateral = -2.0;
  scene.motion = Motion{.speed = -2e4, .lateral = -10.0};
  const SceneResult backwards = solve_scene(scene);
  const double bound = 0.3 * forwards.left->normal_force;
  EXPECT_NEAR(creep_of(backwards.right).longitudinal_force,
              -creep_of(forwards.left).longitudinal_force, 1e-4 * bound);
  EXPECT_NEAR(creep_of(backwards.right).lateral_force, -creep_of(forwards.left).lateral_force,
              1e-4 * bound);
  EXPECT_NEAR(creep_of(backwards.right).spin_moment, creep_of(forwards.left).spin_moment,
              1e-3 * bound);
  for (const CreepModel model : {CreepModel::fastsim, CreepModel::polach}) {
    scene.creep = model;
    const SceneResult other = solve_scene(scene);
    EXPECT_NEAR(creep_of(other.right).lateral_force, creep_of(backwards.right).lateral_force,
                0.2 * bound);
  }
}

// A centred wheelset that rolls freely has no net force but that of the cones' spin.
TEST(CreepMotion, ACentredWheelsetRollsFreely) {
  Scene scene = scene_at(0.0);
  scene.motion = Motion{.speed = 3e4};
  const SceneResult result = solve_scene(scene);
  EXPECT_EQ(creep_of(result.left).longitudinal_force, creep_of(result.right).longitudinal_force);
  EXPECT_EQ(creep_of(result.left).lateral_force, -creep_of(result.right).lateral_force);
}

// From 100 m/s to standstill and back, with a skid: finite, and continuous where it stands.
TEST(CreepMotion, AnySpeedIsPermitted) {
  Scene scene = scene_at(1.0);
  double before = 0.0;
  for (const double speed : {-1e5, -1.0, -1e-6, 0.0, 1e-6, 1.0, 1e5}) {
    scene.motion = Motion{.speed = speed, .yaw = 1e-3 * speed};
    const CreepResult creep = creep_of(solve_scene(scene).left);
    ASSERT_TRUE(std::isfinite(creep.longitudinal_force)) << speed;
    ASSERT_TRUE(std::isfinite(creep.lateral_force)) << speed;
    ASSERT_TRUE(std::isfinite(creep.friction_power)) << speed;
    if (speed == 0.0 || speed == 1e-6) {
      EXPECT_NEAR(creep.longitudinal_force, before, 1e-3 * 24000.0) << speed;
    }
    before = creep.longitudinal_force;
  }
}

double number(SceneResult& result, const std::string& name) {
  return number_value(result, name, Convention{}).value();
}

// Rolling along straight track at a given pitch rate the wheels' material moves along the track at
// the patches, so that normal forces do no work.
TEST(CreepMotion, PowerOfTheWheelsetIsThatOfFriction) {
  Scene scene = scene_at(2.0);
  const double pitch = 1.001 * 2e4 / 460.0;
  scene.roll = 0.0;
  scene.motion = Motion{.speed = 2e4, .pitch = pitch};
  SceneResult result = solve_scene(scene);
  double friction = 0.0;
  for (const std::string side : {"left", "right"}) {
    const SceneWheel& wheel = side == "left" ? *result.left : *result.right;
    ASSERT_EQ(wheel.patches.size(), 1U);
    const CreepResult& creep = *wheel.patches[0].creep;
    friction += number(result, side + ".patches.0.friction_power") -
                creep.slip_speed * creep.power_of_pressures;
  }
  const double power =
      number(result, "wheelset.force.x") * 2e4 + number(result, "wheelset.moment.y") * pitch;
  EXPECT_GT(friction, 0.0);
  EXPECT_NEAR(power, -friction, 1e-3 * friction);
}

TEST(CreepMotion, TotalsOfACentredWheelset) {
  Scene scene = scene_at(0.0);
  scene.motion = Motion{.speed = 2e4};
  SceneResult result = solve_scene(scene);
  const double load = 160000.0;
  // Creep forces rise with the plane they act along, and more where their spin is greater.
  const double rise = 2.0 * number(result, "left.patches.0.creep_force.lateral") *
                      std::sin(number(result, "left.patches.0.angle"));
  EXPECT_GT(rise, 5e-4 * load);
  EXPECT_NEAR(number(result, "wheelset.force.z"), load + rise, 5e-4 * load);
  EXPECT_NEAR(number(result, "wheelset.force.y"), 0.0, 1e-9 * load);
  EXPECT_NEAR(number(result, "wheelset.moment.x"), 0.0, 1e-6 * load);
  EXPECT_NEAR(number(result, "wheelset.moment.z"), 0.0, 1e-6 * load);
  EXPECT_EQ(number(result, "left.total.force.x"), number(result, "right.total.force.x"));
  // Without creep forces they are those of normal contact.
  scene.motion.reset();
  result = solve_scene(scene);
  EXPECT_EQ(number(result, "left.total.force.y"), number(result, "left.lateral_force"));
  EXPECT_EQ(number(result, "left.total.force.x"), number(result, "left.longitudinal_force"));
}

} // namespace
} // namespace wrc::test::creep_motion_test
