/// Slip where it happens, in scenes: against CONTACT's D = 2 and D = 3, against sums over sliding
/// lobes, along small steps.
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "creep/kinematics.hpp"
#include "creep/total_force.hpp"
#include "keys/scene_keys.hpp"
#include "remesh/undeformed_distance.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::slip_by_element_test {
namespace {

/// Normal force, longitudinal and lateral creep force of a wheel, N.
struct Forces {
  double normal, longitudinal, lateral;
};

/// S1002 on the Manchester UIC60, right wheel, 80 kN vertically of all forces together, 20 m/s,
/// pitch rate 1.001 V/r, mu 0.3, G 82000 MPa, nu 0.28; our frame.
/// Source: CONTACT rev 2707 (github eve70a/CONTACT, Apache-2.0), elements of 0.2 mm where the yaw
/// is 0 and |y| is above 3 mm, 0.4 mm else.
struct Case {
  double lateral, yaw, roll;
  Forces planar;     ///< three creepages at the reference, D = 2
  Forces by_element; ///< rigid slip on the surfaces, D = 3
  double limit;      ///< of the differences between the two, over mu N
};

constexpr double on_treads = 5e-3;
constexpr double on_two_lobes = 1.5e-2;
constexpr std::array cases{
    Case{0.0, 0.0, 0.0, {79970.0, 13300.8, -2255.7}, {79973.1, 14352.9, -2168.3}, on_treads},
    Case{-3.0, 0.0, 0.0, {79900.6, 19747.2, -4728.2}, {79910.3, 19821.1, -4621.5}, on_treads},
    Case{-5.0, 0.0, 0.0, {80415.5, 23156.3, -4286.8}, {80487.2, 23338.8, -3864.2}, on_two_lobes},
    Case{-5.0, -0.012, 0.0, {77531.1, 8008.3, -21688.0}, {77563.7, 8445.6, -21486.8}, on_two_lobes},
    Case{-6.0, 0.0, 0.0, {84297.8, 23856.2, -4171.7}, {84331.9, 23881.4, -4084.8}, on_treads},
    Case{-6.5, 0.0, 0.0, {91275.6, 25646.3, -3732.9}, {91368.6, 25713.9, -3581.6}, on_treads},
    Case{-6.5, -0.005, 2e-4, {83561.4, 20794.0, -12640.3}, {83637.6, 20902.3, -12494.3}, on_treads},
    Case{-8.0, 0.0, 0.0, {213529.5, 57396.5, -3513.4}, {213890.8, 57494.4, -3371.6}, on_treads}};

constexpr double friction = 0.3;

Scene scene_of(const Case& one) {
  Scene scene;
  scene.side = SideChoice::right;
  scene.left.rail.name = scene.right.rail.name = "UIC60-Manchester";
  scene.wheel_material = scene.rail_material = {2.0 * 82000.0 * 1.28, 0.28};
  scene.right.friction.coefficient = friction;
  scene.lateral = one.lateral;
  scene.yaw = one.yaw;
  scene.roll = one.roll;
  scene.accuracy = 1e-3;
  scene.accuracy_of = AccuracyOf::forces;
  scene.load_of = LoadOf::normal;
  scene.left.load = scene.right.load = one.by_element.normal;
  scene.motion = Motion{.speed = 2e4, .pitch = 1.001 * 2e4 / 460.0};
  return scene;
}

const CreepResult& creep_of(const SceneResult& result) {
  return result.right.value().patches.at(0).creep.value();
}

// CONTACT's D = 3 takes the slip of an element at its place on the undeformed wheel, along the axes
// of the plane (m_wr_rigslip.f90, wr_rigslip_wrsurf). Its elements are equal in both, so that their
// errors cancel in the difference.
TEST(SlipByElement, ChangesForcesAsInContact) {
  for (const Case& one : cases) {
    Scene scene = scene_of(one);
    scene.slip.variation = SlipVariation::planar;
    const CreepResult planar = creep_of(solve_scene(scene));
    scene.slip.variation = SlipVariation::plane_axes;
    const CreepResult by_element = creep_of(solve_scene(scene));
    const double whole = friction * one.by_element.normal;
    const double share = one.by_element.normal / one.planar.normal; // equal loads
    EXPECT_NEAR((by_element.longitudinal_force - planar.longitudinal_force) / whole,
                (one.by_element.longitudinal - share * one.planar.longitudinal) / whole, one.limit)
        << one.lateral << ' ' << one.yaw;
    EXPECT_NEAR((by_element.lateral_force - planar.lateral_force) / whole,
                (one.by_element.lateral - share * one.planar.lateral) / whole, one.limit)
        << one.lateral << ' ' << one.yaw;
    // Slip by element itself, with the errors of CONTACT's elements.
    EXPECT_NEAR(by_element.longitudinal_force / whole, one.by_element.longitudinal / whole, 0.012);
    EXPECT_NEAR(by_element.lateral_force / whole, one.by_element.lateral / whole, 5e-3);
  }
}

// On a tread three creepages that fit the slip give nearly all of it.
TEST(SlipByElement, IsNearlyThatOfFittedCreepagesOnATread) {
  Scene scene = scene_of(cases[0]);
  const CreepResult by_element = creep_of(solve_scene(scene));
  EXPECT_GT(by_element.slip_variation, 1e-5);
  EXPECT_LT(by_element.slip_variation, 3e-4);
  scene.right.creepages = by_element.creepages;
  const CreepResult fitted = creep_of(solve_scene(scene));
  const double whole = friction * cases[0].by_element.normal;
  EXPECT_EQ(fitted.slip_variation, 0.0);
  EXPECT_NEAR(fitted.longitudinal_force, by_element.longitudinal_force, 1e-2 * whole);
  EXPECT_NEAR(fitted.lateral_force, by_element.lateral_force, 1e-2 * whole);
}

/// Two lobes 10 mm apart in one plane, all of them sliding.
Scene sliding_lobes() {
  Scene scene = scene_of(cases[3]);
  scene.roll = -3.554e-4;
  scene.load_of = LoadOf::normal;
  scene.left.load = scene.right.load = 9545.0;
  scene.motion = Motion{.speed = 2e3, .pitch = 4.335};
  return scene;
}

/// From velocities of places on the undeformed wheel, along tangents by differences of the mean
/// surface: a sum over the pressures of a patch.
struct SlidingSum {
  double longitudinal = 0.0;
  double lateral = 0.0; ///< left-hand frame
};

SlidingSum sliding_sum(const WheelResult& wheel, const PatchResult& patch) {
  const WheelDetails& details = wheel.details;
  const PosedPair pair{*details.wheel, *details.rail, details.pose, wheel.vertical - wheel.depth};
  const Motion& motion = details.motion->motion;
  const Vector3 centre{0.0, details.pose.lateral, pair.vertical};
  const Vector3 axle = Rotation(details.pose).to_track({0.0, 1.0, 0.0});
  const CreepResult& creep = *patch.creep;
  SlidingSum sum;
  for (std::size_t j = 0; j < creep.grid.lateral_count; ++j) {
    const double y = creep.grid.lateral(j);
    const auto middle = [&](double lateral) {
      const SurfacePlace place = surfaces_at(pair, patch.frame, 0.0, lateral);
      return 0.5 * (place.rail + place.wheel);
    };
    constexpr double apart = 1e-3;
    const Vector3 secant = middle(y + apart) - middle(y - apart);
    const Vector3 across = (1.0 / std::sqrt(dot(secant, secant) - secant.x * secant.x)) *
                           Vector3{0.0, secant.y, secant.z};
    const Vector3 wheel_place = surfaces_at(pair, patch.frame, 0.0, y).wheel;
    for (std::size_t i = 0; i < creep.grid.longitudinal_count; ++i) {
      const double p = creep.pressure[j * creep.grid.longitudinal_count + i];
      const Vector3 place = wheel_place + Vector3{creep.grid.longitudinal(i), 0.0, 0.0} - centre;
      const Vector3 velocity = Vector3{motion.speed, 0.0, 0.0} + cross(*motion.pitch * axle, place);
      const double along = velocity.x;
      const double sideways = dot(velocity, across);
      const double bound =
          creep.friction * p * creep.grid.element_area() / std::hypot(along, sideways);
      sum.longitudinal -= bound * along;
      sum.lateral -= bound * sideways;
    }
  }
  return sum;
}

// In full sliding tractions are mu p against the slip of each element: the forces of each lobe need
// no solver of tractions.
TEST(SlipByElement, EachLobeSlidesWithItsOwnSlip) {
  Scene scene = sliding_lobes();
  scene.right.friction.coefficient = 0.03; // tractions displace by 2 % of the slip at most
  const SceneResult result = solve_scene(scene);
  const WheelResult& wheel = result.right.value();
  const PatchResult& patch = wheel.patches.at(0);
  ASSERT_EQ(patch.parts.size(), 2U);
  EXPECT_EQ(patch.creep->adhesion_area, 0.0);
  for (const PatchResult& part : patch.parts) {
    const SlidingSum sum = sliding_sum(wheel, part);
    const double whole = 0.03 * part.normal_force;
    EXPECT_NEAR(part.creep->longitudinal_force, sum.longitudinal, 2e-3 * whole);
    EXPECT_NEAR(-part.creep->lateral_force, sum.lateral, 2e-3 * whole);
  }
}

// What one plane for both lobes takes from them (docs/evidence/validation.md): with three
// creepages along it the lesser lobe slides by other numbers than its own radius says.
TEST(SlipByElement, DiffersFromAPlaneForTwoLobes) {
  Scene scene = sliding_lobes();
  const CreepResult by_element = creep_of(solve_scene(scene));
  EXPECT_GT(by_element.slip_variation, 5e-5);
  scene.slip.variation = SlipVariation::planar; // each lobe at its own reference
  const SceneResult lobes = solve_scene(scene);
  const CreepResult by_lobe = creep_of(lobes);
  const WheelResult& wheel = lobes.right.value();
  const PatchResult& whole = wheel.patches.at(0);
  const Creepages at_reference =
      rigid_slip(wheel.details.motion.value(), whole.frame, whole.approach, 0.0).creepages;
  scene.right.creepages = {at_reference.longitudinal, -at_reference.lateral, -at_reference.spin};
  const CreepResult in_one_plane = creep_of(solve_scene(scene));
  EXPECT_NEAR(by_lobe.longitudinal_force, by_element.longitudinal_force, 5.0);
  EXPECT_NEAR(by_lobe.spin_moment, by_element.spin_moment, 20.0);
  EXPECT_LT(std::abs(in_one_plane.longitudinal_force),
            std::abs(by_element.longitudinal_force) - 40.0);
  EXPECT_LT(in_one_plane.spin_moment, by_element.spin_moment - 400.0);
}

// All contact forces do the work of friction, with the slip of each element, also where the wheel
// moves along its normals.
TEST(SlipByElement, TotalForcesDoTheWorkOfFriction) {
  for (const double lateral : {0.0, -5.0}) {
    Scene scene = scene_of(cases[0]);
    scene.lateral = lateral;
    const auto power = [&](double vertical) {
      scene.motion->vertical = vertical;
      const SceneResult result = solve_scene(scene);
      const WheelResult& wheel = result.right.value();
      const WheelForce total = total_force(wheel);
      WheelForce normal;
      for (const PatchResult& patch : wheel.patches) {
        const Vector3 centre{0.0, -wheel.details.pose.lateral, wheel.vertical - wheel.depth};
        const Vector3 place{patch.reference.x, patch.reference.y, patch.reference.z};
        normal.force = normal.force + patch.force;
        normal.moment = normal.moment + patch.moment + cross(place - centre, patch.force);
      }
      const Motion& motion = *scene.motion;
      const Vector3 axle = {0.0, std::cos(*scene.roll), std::sin(*scene.roll)};
      const Vector3 tangential = total.force - normal.force;
      const double work = tangential.x * motion.speed + tangential.z * motion.vertical +
                          *motion.pitch * dot(total.moment - normal.moment, axle);
      double friction_power = 0.0;
      for (const PatchResult& patch : wheel.patches) {
        const CreepResult& creep = *patch.creep;
        friction_power += creep.friction_power - creep.slip_speed * creep.power_of_pressures;
      }
      EXPECT_NEAR(work, -friction_power, 1e-4 * friction_power) << lateral << ' ' << vertical;
    };
    power(0.0);
    power(30.0);
  }
}

// Steps of 0.1 um over lobes that join and part: forces follow a line but for a small share of the
// accuracy, as they do with creepages.
TEST(SlipByElement, IsAContinuousFunctionOfTheScene) {
  SceneSolver solver;
  for (const double lateral : {-4.62, -5.0, -6.0}) {
    Scene scene = scene_of(cases[0]);
    scene.accuracy = 1e-2;
    scene.load_of = LoadOf::pressures;
    scene.right.load = 8e4;
    std::vector<double> forces;
    for (int step = 0; step < 40; ++step) {
      scene.lateral = lateral + 1e-4 * step;
      forces.push_back(creep_of(solver.solve(scene)).lateral_force);
    }
    for (std::size_t i = 1; i + 1 < forces.size(); ++i) {
      const double bend = forces[i + 1] - 2.0 * forces[i] + forces[i - 1];
      EXPECT_LE(std::abs(bend), 0.1 * 1e-2 * friction * 8e4) << lateral << " step " << i;
    }
  }
}

// Given creepages are three numbers in the plane of a patch: where slip would be taken from changes
// nothing, also not the directions of forces, but that pressures make inclined rows slip.
TEST(SlipByElement, LeavesGivenCreepagesInThePlane) {
  Scene scene;
  scene.side = SideChoice::left;
  scene.lateral = 6.3; // two lobes, whose tangents differ
  scene.left.creepages = Creepages{0.002, -0.003, -0.0003};
  const auto force_of = [&](SlipVariation variation, SlipSurface surface) {
    scene.slip = {variation, surface};
    return total_force(*solve_scene(scene).left);
  };
  const WheelForce planar = force_of(SlipVariation::planar, SlipSurface::wheel);
  EXPECT_GT(std::abs(planar.force.y), 1e3);
  const WheelForce by_element = force_of(SlipVariation::by_element, SlipSurface::wheel);
  EXPECT_NEAR(by_element.force.y, planar.force.y, 1e-2 * norm(planar.force));
  for (const auto& [variation, surface, same] :
       {std::tuple{SlipVariation::by_element, SlipSurface::mean, by_element},
        std::tuple{SlipVariation::plane_axes, SlipSurface::wheel, planar}}) {
    const WheelForce found = force_of(variation, surface);
    SCOPED_TRACE(static_cast<int>(variation));
    EXPECT_EQ(found.force.x, same.force.x);
    EXPECT_EQ(found.force.y, same.force.y);
    EXPECT_EQ(found.force.z, same.force.z);
    EXPECT_EQ(found.moment.x, same.moment.x);
    EXPECT_EQ(found.moment.y, same.moment.y);
    EXPECT_EQ(found.moment.z, same.moment.z);
  }
}

TEST(SlipByElement, IsAChoiceOfTheScene) {
  Scene scene = scene_of(cases[1]);
  const double of_wheel = creep_of(solve_scene(scene)).creepages.longitudinal;
  scene.slip.surface = SlipSurface::mean;
  const SceneResult result = solve_scene(scene);
  // Half the approach nearer to the axle.
  const double closer = 0.5 * result.right->patches[0].approach / 460.0;
  EXPECT_NEAR(creep_of(result).creepages.longitudinal - of_wheel, closer, 0.5 * closer);
  scene.slip.variation = SlipVariation::planar;
  EXPECT_EQ(creep_of(solve_scene(scene)).slip_variation, 0.0);
}

} // namespace
} // namespace wrc::test::slip_by_element_test
