/// Jacobians of contact forces against central differences of whole scenes.
///
/// They are those of fixed sets of elements, which follow the contact; how far they are off over
/// random scenes shows drivers/evidence/core/compare_jacobian.
#include "derivatives/force_jacobian.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "creep/rolling_frame.hpp"
#include "derivatives/wheel_rates.hpp"
#include "support/state_differences.hpp"

namespace wrc::test::force_jacobian_test {
namespace {

/// Of a column's largest entry: what elements leave that change between adhesion and slip, over 500
/// scenes below 1.06e-2 in 99 of 100 (compare_jacobian 500 1e-2), 1.2e-2 here.
constexpr double velocity_tolerance = 1.2e-2;
constexpr double position_tolerance = 8e-3;
/// On an ellipse, which has no elements: up to 3.2e-3 was seen.
constexpr double ellipse_tolerance = 5e-3;

struct Case {
  const char* name;
  double lateral;
  double yaw;
  CreepModel model = CreepModel::full;
  double speed = 2e4;
  double of_positions = position_tolerance;
  double of_velocities = velocity_tolerance;
  FrictionLaw friction{};
  CurvedChoice curved = CurvedChoice::no;
};

/// Halved at a slip of 60 mm/s, as creepages of 0.3 % have here.
const FrictionLaw falling{.coefficient = 0.4, .limit_ratio = 0.3, .decay = 0.02};
/// Lubricated flanges.
const FrictionLaw by_place{.places = {{-35.0, 0.1}, {-5.0, 0.4}, {40.0, 0.3}}};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

/// At the height at which the usual load is carried.
Scene scene_of(const Case& c) {
  Scene scene;
  scene.lateral = c.lateral;
  scene.yaw = c.yaw;
  scene.accuracy = 6e-4;
  scene.accuracy_of = AccuracyOf::forces;
  scene.creep = c.model;
  scene.curved = c.curved;
  scene.left.friction = scene.right.friction = c.friction;
  const SceneResult under_load = solve_scene(scene);
  scene.roll = under_load.roll;
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  scene.motion = Motion{.speed = c.speed,
                        .pitch = 1.0005 * c.speed / 460.0,
                        .lateral = 20.0,
                        .vertical = 1.0,
                        .roll = 0.005,
                        .yaw = 0.01};
  return scene;
}

class Jacobians : public testing::TestWithParam<Case> {};

TEST_P(Jacobians, AreThoseOfCentralDifferences) {
  Scene scene = scene_of(GetParam());
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  scene.derivatives = false;
  for (const auto side : {&SceneResult::left, &SceneResult::right}) {
    const ForceJacobian* jacobian = (here.*side)->jacobian();
    ASSERT_NE(jacobian, nullptr);
    Scene one = scene;
    one.side = side == &SceneResult::left ? SideChoice::left : SideChoice::right;
    for (std::size_t which = 0; which < state_count; ++which) {
      const double limit =
          which < position_count ? GetParam().of_positions : GetParam().of_velocities;
      double error = column_error(*jacobian, which, difference_by(one, which, side));
      // Elements that change between adhesion and slip, and what the iteration leaves, show in the
      // shorter difference, the curvature in the longer one. Where the number of elements changes
      // within both, forces jump there by a share of the accuracy; the shortest one leaves it out.
      for (const double times : {3.0, 0.25}) {
        if (error > limit) {
          error = column_error(*jacobian, which, difference_by(one, which, side, times));
        }
      }
      EXPECT_LE(error, limit) << which << (side == &SceneResult::left ? " left" : " right");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Jacobians,
    testing::Values(Case{"centred", 0.0, 0.0}, Case{"outwards", -2.0, 0.004},
                    Case{"flange_root", 5.0, 0.002}, Case{"flange", 6.5, 0.005},
                    Case{"backwards", -2.0, -0.001, CreepModel::full, -2e4},
                    Case{"linear", -2.0, 0.001, CreepModel::linear, 2e4, ellipse_tolerance},
                    Case{"polach", -2.0, 0.003, CreepModel::polach, 2e4, ellipse_tolerance},
                    Case{"fastsim", -2.0, 0.001, CreepModel::fastsim, 2e4, ellipse_tolerance},
                    Case{"friction_falls", -2.0, 0.004, CreepModel::polach, 2e4, ellipse_tolerance,
                         velocity_tolerance, falling},
                    Case{"friction_by_place", 3.0, 0.004, CreepModel::polach, 2e4,
                         ellipse_tolerance, velocity_tolerance, by_place},
                    Case{"curved_tread",
                         -2.0,
                         0.004,
                         CreepModel::full,
                         2e4,
                         position_tolerance,
                         velocity_tolerance,
                         {},
                         CurvedChoice::yes},
                    Case{"curved_flange_root",
                         5.0,
                         0.002,
                         CreepModel::full,
                         2e4,
                         position_tolerance,
                         velocity_tolerance,
                         {},
                         CurvedChoice::yes}),
    [](const testing::TestParamInfo<Case>& tested) { return tested.param.name; });

/// Slip by element changes the force along the normals of two lobes, with unlike bodies as well.
TEST(JacobianOfTwoLobes, IncludesVelocitiesAlongNormals) {
  Scene scene;
  scene.side = SideChoice::left;
  scene.lateral = 5.0;
  scene.accuracy = 1e-3;
  scene.accuracy_of = AccuracyOf::forces;
  scene.wheel_material = {70000.0, 0.33}; // aluminium
  const SceneResult under_load = solve_scene(scene);
  scene.roll = under_load.roll;
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  scene.motion = Motion{.speed = 2e4, .pitch = 43.5};
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  const ForceJacobian& jacobian = *here.left->jacobian();
  scene.derivatives = false;
  for (std::size_t which = position_count; which < state_count; ++which) {
    const ForceColumn difference = difference_by(scene, which, &SceneResult::left);
    // With creep forces both lobes are on one grid: elements of either change within a step.
    EXPECT_LE(column_error(jacobian, which, difference), 1.25 * velocity_tolerance) << which;
    EXPECT_NEAR(jacobian[2][which] / difference[2], 1.0, 2e-2) << which;
  }
}

/// What is linear in a centred wheelset: two lobes, 23 mm together, whose edges move along the
/// rail while the load stays.
TEST(JacobiansAtConstantLoad, IncludeTheMotionOfEdges) {
  Scene scene;
  scene.accuracy_of = AccuracyOf::forces;
  scene.accuracy = 3e-3;
  scene.roll = 0.0;
  scene.left.load = scene.right.load = 5.5e4;
  scene.motion = Motion{.speed = 4e4, .pitch = 4e4 / 460.0};
  const auto forwards = [&scene](double lateral) {
    Scene moved = scene;
    moved.lateral = lateral;
    return force_column(*solve_scene(moved).left)[0];
  };
  constexpr double step = 0.2; // forces leave their line by up to 4 N
  const double difference = (forwards(step) - forwards(-step)) / (2.0 * step);
  const SceneResult under_load = solve_scene(scene);
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  const ForceJacobian& jacobian = *here.left->jacobian();
  const double height = -jacobian[2][0] / jacobian[2][1];
  EXPECT_NEAR((jacobian[0][0] + height * jacobian[0][1]) / difference, 1.0, 0.1);
}

/// The wheel's flange root has just come down on the rail, 7 mm from the main lobe: it takes load
/// much faster, which must not stretch the main lobe's elements.
TEST(JacobiansOfLobes, StretchNoElements) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "54E1";
  scene.lateral = 4.027;
  scene.yaw = 0.00122;
  scene.left.load = scene.right.load = 4.9e4;
  scene.accuracy_of = AccuracyOf::forces;
  scene.accuracy = 1e-2;
  const SceneResult under_load = solve_scene(scene);
  scene.roll = under_load.roll;
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  scene.motion = Motion{.speed = 2e4, .pitch = 2e4 / 460.0};
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  EXPECT_EQ(here.left->patches[0].lobes, 2);
  scene.derivatives = false;
  constexpr std::size_t vertical = 1;
  EXPECT_LE(column_error(*here.left->jacobian(), vertical,
                         difference_by(scene, vertical, &SceneResult::left)),
            3e-2);
}

/// A contact that varies moves with yaw, and its creepages are those of where it is: held in place
/// the column is off by 0.34.
TEST(JacobiansOfAWheelThatVaries, ByYawFollowTheContact) {
  Scene scene;
  scene.left.wheel.harmonics = scene.right.wheel.harmonics = {{20, 0.05, 0.0}};
  scene.side = SideChoice::left;
  scene.lateral = 5.8;
  scene.yaw = 0.004;
  scene.pitch = 0.05;
  scene.roll = 0.0;
  scene.accuracy = 1e-3;
  scene.accuracy_of = AccuracyOf::forces;
  const SceneResult under_load = solve_scene(scene);
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  scene.motion = Motion{.speed = 2e4, .pitch = 2e4 / 460.0, .lateral = 20.0};
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  scene.derivatives = false;
  constexpr std::size_t yaw = 3;
  EXPECT_LE(
      column_error(*here.left->jacobian(), yaw, difference_by(scene, yaw, &SceneResult::left)),
      1e-2);
}

TEST(JacobiansOfMirrorImages, MirrorToTheLastBit) {
  Scene scene = scene_of({"", 2.0, 0.003});
  scene.derivatives = true;
  SceneResult one = solve_scene(scene);
  scene.lateral = -scene.lateral;
  scene.yaw = -scene.yaw;
  *scene.roll = -*scene.roll;
  scene.motion = mirrored(*scene.motion);
  SceneResult other = solve_scene(scene);
  const ForceJacobian& left = *one.left->jacobian();
  const ForceJacobian& right = *other.right->jacobian();
  for (std::size_t which = 0; which < state_count; ++which) {
    const bool turns = which == 1 || which == 4 || which == 6 || which == 8;
    for (std::size_t row = 0; row < 6; ++row) {
      EXPECT_EQ(left[row][which], (row % 2 == 0) == turns ? right[row][which] : -right[row][which])
          << row << ' ' << which;
    }
  }
}

TEST(JacobiansWithoutDerivatives, AreThoseOfNormalForcesOrAbsent) {
  Scene scene = scene_of({"", 1.0, 0.0});
  SceneResult with_creep = solve_scene(scene);
  EXPECT_EQ(with_creep.left->jacobian(), nullptr); // not requested
  scene.motion.reset();
  SceneResult without = solve_scene(scene);
  const ForceJacobian& jacobian = *without.left->jacobian();
  EXPECT_EQ(jacobian[2][1], wheel_rates_of(*without.left)->force.vertical.force.z);
  EXPECT_EQ(jacobian[0][static_cast<std::size_t>(StateVariable::speed)], 0.0);
  scene.vertical = 500.0;
  SceneResult apart = solve_scene(scene);
  EXPECT_EQ(apart.left->jacobian(), nullptr);
}

/// With creepages given, the positions change normal forces, planes and what scales with them.
TEST(JacobiansOfGivenCreepages, HoldTheCreepagesFixed) {
  Scene scene = scene_of({"", 1.0, 0.0});
  scene.motion.reset();
  scene.left.creepages = scene.right.creepages = Creepages{5e-4, -1e-3, 1e-4};
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  const ForceJacobian& jacobian = *here.left->jacobian();
  scene.motion = Motion{.speed = 1.0, .pitch = 1.0}; // has a place for each state, changes nothing
  for (std::size_t which = 0; which < 3; ++which) {  // the yaw changes next to nothing
    EXPECT_LE(column_error(jacobian, which, difference_by(scene, which, &SceneResult::left)),
              position_tolerance)
        << which;
  }
  for (std::size_t which = position_count; which < state_count; ++which) {
    EXPECT_EQ(jacobian[0][which], 0.0);
  }
}

} // namespace
} // namespace wrc::test::force_jacobian_test
