/// Creep forces of whole wheels: against CONTACT's wheel/rail cases, between mirrored wheels, along
/// small steps, in other units.
#include "wheel/creep_forces.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/scene_keys.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test {
namespace {

Scene scene_at(double lateral, const Creepages& left, double accuracy = 1e-3) {
  Scene scene;
  scene.lateral = lateral;
  scene.accuracy = accuracy;
  scene.accuracy_of = AccuracyOf::forces;
  scene.left_creepages = left;
  scene.right_creepages = {left.longitudinal, -left.lateral, -left.spin};
  return scene;
}

const CreepResult& creep_of(const std::optional<WheelResult>& wheel, std::size_t patch = 0) {
  return wheel.value().patches.at(patch).creep.value();
}

constexpr Creepages moderate{1e-3, 5e-4, 2e-4};

TEST(CreepForces, OnlyWhereCreepagesAreGiven) {
  Scene scene = scene_at(3.0, moderate);
  scene.right_creepages.reset();
  const SceneResult with = solve_scene(scene);
  EXPECT_TRUE(with.left->patches[0].creep);
  EXPECT_FALSE(with.right->patches[0].creep);
  scene.creep = CreepModel::none;
  const SceneResult without = solve_scene(scene);
  EXPECT_FALSE(without.left->patches[0].creep);
  EXPECT_NEAR(without.left->patches[0].normal_force, with.left->patches[0].normal_force,
              scene.accuracy * with.left->patches[0].normal_force);
  // Cheaper models on the ellipse change nothing in the normal contact.
  scene.creep = CreepModel::linear;
  EXPECT_EQ(without.left->pmax, solve_scene(scene).left->pmax);
}

TEST(CreepForces, ZeroCreepagesAndZeroFrictionGiveNone) {
  for (const bool frictionless : {false, true}) {
    Scene scene = scene_at(3.0, frictionless ? moderate : Creepages{});
    scene.left_friction = frictionless ? 0.0 : 0.3;
    const SceneResult result = solve_scene(scene);
    const CreepResult& creep = creep_of(result.left);
    EXPECT_EQ(creep.longitudinal_force, 0.0);
    EXPECT_EQ(creep.lateral_force, 0.0);
    EXPECT_EQ(creep.friction_power, 0.0);
  }
}

TEST(CreepForces, MirroredWheelsHaveMirroredForces) {
  Scene scene = scene_at(0.0, moderate);
  scene.roll = 0.0;
  scene.motion = Motion{.speed = 2e4};
  const SceneResult result = solve_scene(scene);
  const CreepResult& left = creep_of(result.left);
  const CreepResult& right = creep_of(result.right);
  EXPECT_EQ(left.longitudinal_force, right.longitudinal_force);
  EXPECT_EQ(left.lateral_force, -right.lateral_force);
  EXPECT_EQ(left.spin_moment, -right.spin_moment);
  EXPECT_LT(left.longitudinal_force, 0.0); // against the creepage
  EXPECT_DOUBLE_EQ(left.friction_power, 2e4 * left.power_per_speed);
  EXPECT_NEAR(
      left.power_per_speed,
      -(left.longitudinal_force * 1e-3 + left.lateral_force * 5e-4 + left.spin_moment * 2e-4),
      1e-9 * left.power_per_speed);
}

TEST(CreepForces, SumOfTractionsIsTheForce) {
  const SceneResult result = solve_scene(scene_at(3.0, moderate));
  const CreepResult& creep = creep_of(result.right);
  double x = 0.0;
  double y = 0.0;
  double normal = 0.0;
  for (std::size_t i = 0; i < creep.pressure.size(); ++i) {
    x += creep.traction_x[i] * creep.grid.element_area();
    y += creep.traction_y[i] * creep.grid.element_area();
    normal += creep.pressure[i] * creep.grid.element_area();
  }
  EXPECT_NEAR(x, creep.longitudinal_force, 1e-3);
  EXPECT_NEAR(-y, creep.lateral_force, 1e-3); // fields are of the side's left-hand frame
  EXPECT_NEAR(normal, result.right->patches[0].normal_force, 1e-6 * normal);
}

// Every rung of the ladder is near the full theory where creepages are small, spin included; the
// closed formulas are those of an ellipse, and the patch at 3 mm is nearly one.
TEST(CreepForces, CheaperModelsAgreeWhereLittleSlips) {
  Scene scene = scene_at(3.0, {1e-4, 5e-5, 2e-5});
  const SceneResult full = solve_scene(scene);
  const double size =
      std::hypot(creep_of(full.left).longitudinal_force, creep_of(full.left).lateral_force);
  for (const CreepModel model :
       {CreepModel::linear, CreepModel::shen_hedrick_elkins, CreepModel::polach,
        CreepModel::fastsim, CreepModel::fastsim_strips}) {
    scene.creep = model;
    const SceneResult result = solve_scene(scene);
    const CreepResult& creep = creep_of(result.left);
    SCOPED_TRACE(static_cast<int>(model));
    EXPECT_NEAR(creep.longitudinal_force, creep_of(full.left).longitudinal_force, 0.15 * size);
    EXPECT_NEAR(creep.lateral_force, creep_of(full.left).lateral_force, 0.15 * size);
    EXPECT_FALSE(creep.error_estimate);
    // The right wheel is the mirror image only where both stand alike; its signs are.
    EXPECT_LT(creep_of(result.right).longitudinal_force, 0.0);
  }
}

TEST(CreepForces, CheaperModelsSaturate) {
  Scene scene = scene_at(3.0, {0.3, 0.4, 0.0}, 1e-2);
  for (const CreepModel model : {CreepModel::shen_hedrick_elkins, CreepModel::polach,
                                 CreepModel::fastsim, CreepModel::fastsim_strips}) {
    scene.creep = model;
    const SceneResult result = solve_scene(scene);
    const double whole = 0.3 * result.left->patches[0].normal_force;
    SCOPED_TRACE(static_cast<int>(model));
    // Those that stand on the linear theory keep the direction it gives.
    const CreepResult& creep = creep_of(result.left);
    EXPECT_NEAR(std::hypot(creep.longitudinal_force, creep.lateral_force), whole, 0.01 * whole);
    EXPECT_LT(creep.longitudinal_force, 0.0);
    EXPECT_LT(creep.lateral_force, 0.0);
  }
}

// The two patches of one plane are solved one by one: the spin of the whole turns about its
// reference.
TEST(CreepForces, PartsOfOnePlaneAddUp) {
  Scene scene = scene_at(5.0, {5e-4, 0.0, 3e-4});
  scene.rail = "UIC60-Manchester";
  scene.left_load = 10000.0;
  const SceneResult result = solve_scene(scene);
  const PatchResult& patch = result.left.value().patches.at(0);
  ASSERT_EQ(patch.parts.size(), 2U);
  const CreepResult& one = *patch.parts[0].creep;
  const CreepResult& other = *patch.parts[1].creep;
  const CreepResult& whole = *patch.creep;
  EXPECT_EQ(whole.longitudinal_force, one.longitudinal_force + other.longitudinal_force);
  EXPECT_EQ(whole.slip_area, one.slip_area + other.slip_area);
  EXPECT_NE(one.creepages.longitudinal, other.creepages.longitudinal);
  EXPECT_EQ(one.creepages.spin, other.creepages.spin);
  // -F.w of the whole, with the creepages at its reference, is that of the parts with theirs.
  EXPECT_NEAR(whole.power_per_speed, -(whole.longitudinal_force * 5e-4 + whole.spin_moment * 3e-4),
              1e-9 * whole.power_per_speed);
}

// Steps of 0.1 um: forces follow a line but for a small share of the accuracy.
TEST(CreepForces, AreContinuousFunctionsOfTheScene) {
  SceneSolver solver;
  for (const double lateral : {-2.0, 1.0, 4.0}) {
    std::vector<double> forces;
    for (int step = 0; step < 40; ++step) {
      const SceneResult result = solver.solve(scene_at(lateral + 1e-4 * step, moderate, 1e-2));
      forces.push_back(creep_of(result.left).lateral_force);
    }
    for (std::size_t i = 1; i + 1 < forces.size(); ++i) {
      const double bend = forces[i + 1] - 2.0 * forces[i] + forces[i - 1];
      EXPECT_LE(std::abs(bend), 0.1 * 1e-2 * 0.3 * 80000.0) << lateral << " step " << i;
    }
  }
}

TEST(CreepForces, SameBitsWhateverWasSolvedBefore) {
  SceneSolver used;
  (void)used.solve(scene_at(-4.0, {3e-3, 0.0, 0.0}, 1e-2));
  const Scene scene = scene_at(2.0, moderate);
  const SceneResult one = used.solve(scene);
  const SceneResult other = solve_scene(scene);
  EXPECT_EQ(creep_of(one.left).lateral_force, creep_of(other.left).lateral_force);
  EXPECT_EQ(creep_of(one.right).spin_moment, creep_of(other.right).spin_moment);
}

// A stiff wheel on a soft rail that rolls freely is driven; the cheaper models leave it out.
TEST(CreepForces, UnlikeMaterialsPullWithoutCreepage) {
  Scene scene = scene_at(3.0, {});
  scene.rail_material = {70000.0, 0.33};
  SceneResult result = solve_scene(scene);
  const double bound = 0.3 * result.left->normal_force;
  EXPECT_GT(creep_of(result.left).longitudinal_force, 0.15 * bound);
  EXPECT_GT(creep_of(result.left).pressure_change, scene.accuracy);
  ASSERT_FALSE(result.left->warnings.empty());
  EXPECT_NE(result.left->warnings.back().find("tractions change pressures by"), std::string::npos);
  scene.creep = CreepModel::linear;
  result = solve_scene(scene);
  EXPECT_EQ(creep_of(result.left).longitudinal_force, 0.0);
  ASSERT_FALSE(result.left->warnings.empty());
  EXPECT_NE(result.left->warnings.back().find("this model leaves out"), std::string::npos);
}

// Parts of one plane and patches that interact: the pressures stay theirs but for what tractions
// change.
TEST(CreepForces, UnlikeMaterialsOnSeveralPatches) {
  Scene scene = scene_at(4.2, moderate);
  scene.rail = "CHN60";
  scene.wheel = "LMA";
  scene.rail_material = {70000.0, 0.33};
  const SceneResult result = solve_scene(scene);
  for (const PatchResult* patch : solved_patches(*result.left)) {
    ASSERT_TRUE(patch->creep.has_value());
    EXPECT_LT(patch->creep->pressure_change, 0.05);
    EXPECT_LT(std::hypot(patch->creep->longitudinal_force, patch->creep->lateral_force),
              0.3 * patch->normal_force * (1.0 + 1e-9));
  }
}

TEST(CreepForces, KeysInOtherUnitsAndFrames) {
  Scene scene;
  set_text(scene, "convention.units", "SI");
  set_text(scene, "convention.frame", "right-down");
  const std::vector<double> given{1e-3, -5e-4, -0.2}; // 1/m
  set_numbers(scene, "creepage.left", given);
  EXPECT_DOUBLE_EQ(scene.left_creepages->lateral, 5e-4);
  EXPECT_DOUBLE_EQ(scene.left_creepages->spin, 2e-4);
  EXPECT_EQ(std::get<std::vector<double>>(key_value(scene, "creepage.left")), given);
  SceneResult result = solve_scene(scene);
  EXPECT_DOUBLE_EQ(number_value(result, "left.patches.0.creepage.spin", scene.convention).value(),
                   -0.2);
  EXPECT_DOUBLE_EQ(
      number_value(result, "left.patches.0.creep_force.lateral", scene.convention).value(),
      -creep_of(result.left).lateral_force);
  EXPECT_ANY_THROW(set_numbers(scene, "creepage.left", std::vector<double>{1.0, 2.0}));
  EXPECT_ANY_THROW(set_numbers(scene, "creepage.left", std::vector<double>{11.0, 0.0, 0.0}));
  set_text(scene, "creepage.left", "none");
  EXPECT_FALSE(scene.left_creepages);
}

TEST(CreepForces, KeysOfOneComponentSetBothWheels) {
  Scene scene;
  EXPECT_EQ(std::get<std::string>(key_value(scene, "creepage.spin")), "none");
  set_number(scene, "creepage.longitudinal", 1e-3);
  set_number(scene, "creepage.spin", 2e-4);
  EXPECT_EQ(scene.left_creepages->longitudinal, 1e-3);
  EXPECT_EQ(scene.left_creepages->lateral, 0.0);
  EXPECT_EQ(scene.right_creepages->spin, 2e-4);
  EXPECT_EQ(std::get<double>(key_value(scene, "creepage.spin")), 2e-4);
  scene.left_creepages->spin = 0.0; // differ now
  EXPECT_TRUE(std::holds_alternative<std::monostate>(key_value(scene, "creepage.spin")));
  set_text(scene, "creepage.lateral", "none");
  EXPECT_FALSE(scene.left_creepages || scene.right_creepages);
}

/// CONTACT's frame has x forward, y right, z down, and its first body is the rail.
Scene scene_of_case(const nlohmann::json& input, const nlohmann::json& patch) {
  Scene scene;
  const std::string folder = std::string(WRCONTACT_REFERENCE_DIR) + '/';
  scene.wheel = folder + input.at("wheel").get<std::string>();
  scene.rail = folder + input.at("rail").get<std::string>();
  scene.track.cant = input.at("cant_rad");
  scene.track.gauge = input.at("gauge_mm");
  scene.track.gauge_height = input.at("gauge_height_mm");
  scene.wheelset.radius = input.at("nominal_radius_mm");
  scene.wheelset.back_to_back = input.at("flange_back_distance_mm");
  const double poisson = input.at("nu");
  scene.wheel_material =
      scene.rail_material = {2.0 * input.at("G_MPa").get<double>() * (1.0 + poisson), poisson};
  scene.lateral = -input.at("y_ws_mm").get<double>();
  scene.yaw = -input.at("yaw_rad").get<double>();
  scene.roll = input.at("roll_rad").get<double>();
  scene.normal_load = patch.at("Fn_N").get<double>();
  scene.left_friction = scene.right_friction = input.at("mu");
  const Creepages creepages{-patch.at("cksi").get<double>(), patch.at("ceta").get<double>(),
                            patch.at("cphi_per_mm").get<double>()};
  const bool left = input.at("side") == "left";
  scene.side = left ? SideChoice::left : SideChoice::right;
  (left ? scene.left_creepages : scene.right_creepages) = creepages;
  scene.accuracy_of = AccuracyOf::forces;
  return scene;
}

// Cases with one patch. CONTACT's elements of 0.2 mm leave 0.3 % of mu N as a rule, up to 1.2 %.
TEST(CreepForces, WheelsOfCreepCases) {
  std::ifstream file(std::string(WRCONTACT_REFERENCE_DIR) + "/creep_cases.json");
  if (!file) {
    GTEST_SKIP() << "no creep_cases.json in " << WRCONTACT_REFERENCE_DIR;
  }
  const nlohmann::json cases = nlohmann::json::parse(file).at("cases");
  double squares = 0.0;
  int compared = 0;
  for (const auto& entry : cases) {
    if (entry.at("kind") != "wheel_rail" || entry.at("input").at("material_digit") == 3 ||
        entry.at("input").at("discretisation_digit") != 2) {
      continue;
    }
    const nlohmann::json& patches = entry.at("grids").back().at("patches");
    if (patches.size() != 1) {
      continue;
    }
    SCOPED_TRACE(entry.at("id").get<std::string>());
    const nlohmann::json& patch = patches[0];
    const Scene scene = scene_of_case(entry.at("input"), patch);
    const SceneResult result = solve_scene(scene);
    const CreepResult& creep = creep_of(result.left ? result.left : result.right);
    const double whole = entry.at("input").at("mu").get<double>() * patch.at("Fn_N").get<double>();
    const double x = (creep.longitudinal_force + patch.at("Fx_N").get<double>()) / whole;
    const double y = (creep.lateral_force - patch.at("Fs_N").get<double>()) / whole;
    EXPECT_LE(std::abs(x), 0.012);
    EXPECT_LE(std::abs(y), 0.012);
    squares += x * x + y * y;
    ++compared;
  }
  ASSERT_GE(compared, 20);
  EXPECT_LE(std::sqrt(squares / (2.0 * compared)), 0.003);
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
TEST(CreepForces, CreepagesOfCreepCasesFollowFromTheMotion) {
  std::ifstream file(std::string(WRCONTACT_REFERENCE_DIR) + "/creep_cases.json");
  if (!file) {
    GTEST_SKIP() << "no creep_cases.json in " << WRCONTACT_REFERENCE_DIR;
  }
  const nlohmann::json cases = nlohmann::json::parse(file).at("cases");
  int compared = 0;
  for (const auto& entry : cases) {
    // Slip element by element (3) is not three creepages, and a pitch rate may be what is sought.
    if (entry.at("kind") != "wheel_rail" || entry.at("input").at("discretisation_digit") != 2 ||
        entry.at("input").at("vpitch_rad_s").is_null()) {
      continue;
    }
    SCOPED_TRACE(entry.at("id").get<std::string>());
    const auto& input = entry.at("input");
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
      const double height = place.z - body.z;
      const ContactFrame frame = tangent_frame(place, angle);
      const double approach = patch.at("approach_mm");
      const RigidSlip slip = rigid_slip(motion, pose, height, 460.0, frame, approach);
      EXPECT_NEAR(slip.reference_speed, 1e3 * patch.at("V_ref_m_s").get<double>(), 0.05);
      EXPECT_NEAR(slip.creepages.longitudinal, -patch.at("cksi").get<double>(), 2e-6);
      EXPECT_NEAR(slip.creepages.lateral, left * patch.at("ceta").get<double>(), 1e-6);
      EXPECT_NEAR(slip.creepages.spin, left * patch.at("cphi_per_mm").get<double>(), 2e-9);
      ++compared;
    }
  }
  EXPECT_GE(compared, 25);
}

/// In curves to the left and to the right, and backwards.
TEST(CreepForces, MotionOfMirrorImagesAndBackwards) {
  Scene scene = scene_at(2.0, moderate, 1e-2);
  scene.left_creepages.reset();
  scene.right_creepages.reset();
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
TEST(CreepForces, ACentredWheelsetRollsFreely) {
  Scene scene = scene_at(0.0, {}, 1e-2);
  scene.left_creepages.reset();
  scene.right_creepages.reset();
  scene.motion = Motion{.speed = 3e4};
  const SceneResult result = solve_scene(scene);
  EXPECT_EQ(creep_of(result.left).longitudinal_force, creep_of(result.right).longitudinal_force);
  EXPECT_EQ(creep_of(result.left).lateral_force, -creep_of(result.right).lateral_force);
}

// From 100 m/s to standstill and back, with a skid: finite, and continuous where it stands.
TEST(CreepForces, AnySpeedIsPermitted) {
  Scene scene = scene_at(1.0, {}, 1e-2);
  scene.left_creepages.reset();
  scene.right_creepages.reset();
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

// No accuracy takes memory without bound; what is not reached is told.
TEST(CreepForces, GridsAreBounded) {
  Scene scene = scene_at(0.0, {}, 1e-5);
  scene.side = SideChoice::left;
  const SceneResult result = solve_scene(scene);
  const CreepResult& creep = creep_of(result.left);
  EXPECT_LE(creep.grid.longitudinal_count, 400U);
  EXPECT_GT(creep.error_estimate, 1e-5);
  EXPECT_NE(result.left->warnings.back().find("creep forces: accuracy 1e-05 not reached"),
            std::string::npos);
}

double number(SceneResult& result, const std::string& name) {
  return number_value(result, name, Convention{}).value();
}

// Rolling along straight track at a given pitch rate the wheels' material moves along the track at
// the patches, so that normal forces do no work.
TEST(CreepForces, PowerOfTheWheelsetIsThatOfFriction) {
  Scene scene = scene_at(2.0, {}, 1e-2);
  scene.left_creepages.reset();
  scene.right_creepages.reset();
  const double pitch = 1.001 * 2e4 / 460.0;
  scene.roll = 0.0;
  scene.motion = Motion{.speed = 2e4, .pitch = pitch};
  SceneResult result = solve_scene(scene);
  double friction = 0.0;
  for (const std::string side : {"left", "right"}) {
    friction += number(result, side + ".patches.0.friction_power");
    ASSERT_EQ((side == "left" ? result.left : result.right)->patches.size(), 1U);
  }
  const double power =
      number(result, "wheelset.force.x") * 2e4 + number(result, "wheelset.moment.y") * pitch;
  EXPECT_GT(friction, 0.0);
  EXPECT_NEAR(power, -friction, 1e-3 * friction);
}

TEST(CreepForces, TotalsOfACentredWheelset) {
  Scene scene = scene_at(0.0, {}, 1e-2);
  scene.left_creepages.reset();
  scene.right_creepages.reset();
  scene.motion = Motion{.speed = 2e4};
  SceneResult result = solve_scene(scene);
  const double load = 160000.0;
  EXPECT_NEAR(number(result, "wheelset.force.z"), load, 1e-3 * load); // creep forces rise, too
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
} // namespace wrc::test
