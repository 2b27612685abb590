/// Pitch rates at which contact forces hold a torque.
#include "creep/free_pitch.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "keys/scene_keys.hpp"
#include "scene/solve_scene.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::free_pitch_test {
namespace {

constexpr double radius = 460.0;
/// Friction's largest force on both wheels, N.
constexpr double bound = 0.3 * 160000.0;

Scene driven_scene(double torque, double lateral = 0.0) {
  Scene scene;
  scene.lateral = lateral;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  scene.motion = Motion{.speed = 2e4};
  scene.pitch_is_free = true;
  scene.torque = torque;
  return scene;
}

double moment_about_axle(const SceneResult& result) {
  return result.left->total->moment.y + result.right->total->moment.y;
}

TEST(FreePitch, ContactForcesHoldTheTorque) {
  for (const double share : {0.0, 0.1, -0.1, 0.5, 0.9, 0.97}) {
    for (const double lateral : {0.0, 4.0}) {
      Scene scene = driven_scene(share * bound * radius, lateral);
      scene.roll = 0.0; // the axle is the track's y
      const SceneResult result = solve_scene(scene);
      EXPECT_FALSE(result.pitch_is_saturated);
      EXPECT_NEAR(moment_about_axle(result) / (bound * radius), -share, 2e-4)
          << share << ' ' << lateral;
      // Driving turns the wheels faster than they roll.
      const double rolling =
          2e4 /
          (0.5 * (result.left->centroid.rolling_radius + result.right->centroid.rolling_radius));
      if (share != 0.0) {
        EXPECT_EQ(*result.pitch > rolling, share > 0.0);
      }
    }
  }
}

TEST(FreePitch, RecoversThePrescribedRateFromItsTorque) {
  Scene scene = driven_scene(0.0, 2.0);
  scene.pitch_is_free = false;
  scene.motion->pitch = 1.002 * 2e4 / radius;
  scene.motion->yaw = 0.01;
  scene.roll = 0.0;
  const SceneResult prescribed = solve_scene(scene);
  scene.motion->pitch.reset();
  scene.pitch_is_free = true;
  scene.torque = -moment_about_axle(prescribed);
  for (const CreepModel model : {CreepModel::full, CreepModel::fastsim}) {
    scene.creep = model;
    const SceneResult found = solve_scene(scene);
    EXPECT_NEAR(*found.pitch / (2e4 / radius), 1.002, model == CreepModel::full ? 2e-6 : 1e-4);
  }
}

TEST(FreePitch, ATorqueAboveFrictionIsReported) {
  const SceneResult result = solve_scene(driven_scene(1.1 * bound * radius));
  EXPECT_TRUE(result.pitch_is_saturated);
  ASSERT_FALSE(result.left->warnings.empty());
  EXPECT_NE(result.left->warnings.back().text.find("motion.torque"), std::string::npos);
  // The wheels turn at twice the speed, and friction drives as far as it can.
  EXPECT_NEAR(*result.pitch * radius, 2.0 * 2e4, 1.0);
  EXPECT_NEAR(result.left->total->force.x / (0.5 * bound), 1.0, 0.01);
  EXPECT_NEAR(result.right->total->force.x / (0.5 * bound), 1.0, 0.01);
}

TEST(FreePitch, OfFallingFrictionIsTheOneWithTheLeastSlip) {
  // At full sliding with a creepage of 1 a third of the friction is left.
  Scene scene = driven_scene(0.0);
  for (SceneSide* side : {&scene.left, &scene.right}) {
    side->friction.limit_ratio = 1.0 / 3.0;
    side->friction.decay = 1e-3;
  }
  const auto with_torque = [&scene](double share) {
    scene.torque = share * bound * radius;
    return solve_scene(scene);
  };
  const auto told = [](const SceneResult& result) {
    const auto& warnings = result.left->warnings;
    return std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
      return warning.text.starts_with("friction falls with slip");
    });
  };
  const SceneResult alone = with_torque(0.3);
  EXPECT_FALSE(told(alone));
  const SceneResult several = with_torque(0.7);
  EXPECT_FALSE(several.pitch_is_saturated);
  EXPECT_TRUE(told(several));
  EXPECT_NEAR(moment_about_axle(several) / (bound * radius), -0.7, 2e-4);
  EXPECT_LT(*several.pitch * radius / 2e4 - 1.0, 0.01);
  EXPECT_TRUE(with_torque(1.0).pitch_is_saturated);
}

TEST(FreePitch, AtAnySpeedAndBackwards) {
  for (const double speed : {0.0, 1e-3, 1.0, -2e4, 1e5}) {
    Scene scene = driven_scene(0.3 * bound * radius);
    scene.motion->speed = speed;
    const SceneResult result = solve_scene(scene);
    EXPECT_FALSE(result.pitch_is_saturated) << speed;
    EXPECT_NEAR(moment_about_axle(result) / (bound * radius), -0.3, 2e-4) << speed;
    const double slip_speed = std::hypot(speed, 1.0);
    EXPECT_LT(std::abs(*result.pitch * radius - speed), 0.01 * slip_speed) << speed;
  }
}

TEST(FreePitch, WithoutContactOrFriction) {
  for (const double friction : {0.0, 1e-12}) {
    for (const double lateral : {0.0, 3.0}) {
      Scene scene = driven_scene(0.0, lateral);
      scene.yaw = 1e-3 * lateral;
      scene.left.friction.coefficient = scene.right.friction.coefficient = friction;
      const SceneResult result = solve_scene(scene);
      EXPECT_FALSE(result.pitch_is_saturated) << friction << ' ' << lateral;
      EXPECT_NEAR(*result.pitch * radius / 2e4, 1.0, 1e-3) << friction << ' ' << lateral;
    }
  }
  for (const double load : {0.0, 1e-30}) {
    Scene unloaded = driven_scene(0.0);
    unloaded.left.load = unloaded.right.load = load;
    EXPECT_DOUBLE_EQ(*solve_scene(unloaded).pitch, 2e4 / radius) << load;
  }
  Scene scene = driven_scene(0.0);
  scene.left.friction.coefficient = scene.right.friction.coefficient = 0.0;
  scene.torque = 1e6;
  EXPECT_TRUE(solve_scene(scene).pitch_is_saturated);
  scene.vertical = 500.0;
  EXPECT_TRUE(solve_scene(scene).pitch_is_saturated);
  scene.torque = 0.0;
  EXPECT_FALSE(solve_scene(scene).pitch_is_saturated);
}

TEST(FreePitch, HasNoJumps) {
  double before = NAN;
  for (int i = 0; i <= 20; ++i) {
    Scene scene = driven_scene(0.6 * bound * radius, 1.0 + 1e-5 * i);
    const double creepage = *solve_scene(scene).pitch * radius / 2e4 - 1.0;
    if (i > 0) {
      EXPECT_NEAR(creepage / before, 1.0, 2e-3) << i;
    }
    before = creepage;
  }
}

// CONTACT finds the pitch rate at which a wheel has a longitudinal force.
TEST(FreePitch, MatchesContactsCasesWithAPrescribedForce) {
  int compared = 0;
  const nlohmann::json cases = creep_wheel_rail_cases();
  for (const auto& entry : cases) {
    const auto& input = entry.at("input");
    if (!input.at("vpitch_rad_s").is_null()) {
      continue;
    }
    SCOPED_TRACE(entry.at("id").get<std::string>());
    const auto& reference = entry.at("grids").back();
    Scene scene;
    scene.side = SideChoice::right;
    scene.right.wheel.name = reference_file(input.at("wheel")).string();
    scene.right.rail.name = reference_file(input.at("rail")).string();
    scene.left = scene.right;
    scene.left.friction.coefficient = scene.right.friction.coefficient = input.at("mu");
    scene.track.gauge = input.at("gauge_mm");
    scene.track.gauge_height = input.at("gauge_height_mm");
    scene.track.inclination = input.at("cant_rad");
    scene.back_to_back = input.at("flange_back_distance_mm");
    scene.lateral = -input.at("y_ws_mm").get<double>();
    scene.yaw = 0.0;
    scene.roll = input.at("roll_rad");
    const double poisson = input.at("nu");
    scene.wheel_material =
        scene.rail_material = {2.0 * (1.0 + poisson) * input.at("G_MPa").get<double>(), poisson};
    scene.right.load = input.at("Fz_N");
    scene.accuracy = 1e-3;
    scene.accuracy_of = AccuracyOf::forces;
    scene.motion = Motion{.speed = 1e3 * input.at("vx_m_s").get<double>()};
    scene.pitch_is_free = true;
    scene.slip.variation = SlipVariation::planar; // D = 2
    // The force on the wheel is the other way round, at the rolling radius.
    const auto& patch = reference.at("patches").at(0);
    const double rolling_radius =
        input.at("nominal_radius_mm").get<double>() + patch.at("z_wheel_mm").get<double>();
    scene.torque = -input.at("prescribed_Fx_ws_N").get<double>() * rolling_radius;
    const SceneResult result = solve_scene(scene);
    const double expected = -reference.at("vpitch_rad_s").get<double>();
    EXPECT_NEAR(*result.pitch / expected, 1.0, 1e-4);
    EXPECT_NEAR(result.right->total->force.x, -input.at("prescribed_Fx_ws_N").get<double>(), 20.0);
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

/// Forces of unlike bodies change by steps, at which 28 rates were tried in vain.
TEST(FreePitch, StepsOfUnlikeBodiesEndTheSearch) {
  Scene scene;
  set_text(scene, "wheelset.wheel", "LM");
  set_text(scene, "track.rail", "54E3");
  set_text(scene, "track.inclination", "1:30");
  scene.wheel_material = {92084.7, 0.03215};
  scene.rail_material = {530561.2, 0.03847};
  scene.left.load = 4086.93;
  scene.right.load = 587.137;
  scene.lateral = 9.330174;
  scene.roll = -0.00414804856;
  scene.accuracy = 1.16786e-3;
  scene.model = ModelRequest::hertz;
  SceneResult normal = solve_scene(scene);
  CreepRequest request;
  request.model = CreepModel::full;
  request.motion = Motion{.speed = -14972.414, .lateral = -261.35979, .yaw = -0.002248564};
  request.nominal_radius = scene.nominal_radius();
  request.friction = {1.15816816, {}, 0.58352634, 0.01168731};
  request.accuracy = scene.accuracy;
  request.pitch_is_free = true;
  request.material = shear_constants(scene.wheel_material, scene.rail_material);
  request.combined_modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  std::vector<DrivenWheel> wheels{{&*normal.left, request}, {&*normal.right, request}};
  RollingSolver solver;
  const FreePitch found = solve_free_pitch(wheels, 104254.53, solver);
  EXPECT_FALSE(found.saturated);
  EXPECT_LE(found.evaluations, 10);
}

/// Forces jump with the elements of a wheel on the edge of its chamfer: no rate balances them, and
/// 28 were tried, for 2.6 s.
TEST(FreePitch, JumpsOfForcesEndTheSearch) {
  Scene scene;
  set_text(scene, "wheelset.wheel", "LM");
  set_text(scene, "track.rail", "54E1");
  set_text(scene, "track.inclination", "1:20");
  set_number(scene, "track.gauge", 1442.107946106634);
  set_number(scene, "track.gauge_height", 12.291186898315406);
  set_number(scene, "wheelset.back_to_back", 1360.5458673425089);
  set_number(scene, "wheelset.radius", 528.20214264168237);
  scene.side = SideChoice::right;
  scene.lateral = 5.3676863941506774;
  scene.roll = 0.10617728777754171;
  scene.vertical = 606.74697540262969;
  scene.accuracy = 1.1056112753860231e-3;
  scene.motion.emplace(); // for the grid of normal contact
  SceneResult normal = solve_scene(scene, {.precision = Precision::double_only});
  CreepRequest request;
  request.model = CreepModel::full;
  request.motion = Motion{.speed = 181.7825001337884};
  request.nominal_radius = scene.nominal_radius();
  request.friction = {0.3, {}, 0.86557472317851736, 0.39095861741163929};
  request.accuracy = scene.accuracy;
  request.pitch_is_free = true;
  request.material = shear_constants(scene.wheel_material, scene.rail_material);
  request.combined_modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  std::vector<DrivenWheel> wheels{{&*normal.right, request}};
  RollingSolver solver;
  const FreePitch found = solve_free_pitch(wheels, 0.0, solver);
  EXPECT_FALSE(found.saturated);
  EXPECT_LE(found.evaluations, 15); // 4 to 11, by rounding
}

} // namespace
} // namespace wrc::test::free_pitch_test
