/// The power that creep forces dissipate: of patches with parts and of unlike bodies.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "creep/creep_forces.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::creep_power_test {
namespace {

/// -F.w.
double product_of(const CreepResult& creep) {
  return -(creep.longitudinal_force * creep.creepages.longitudinal +
           creep.lateral_force * creep.creepages.lateral +
           creep.spin_moment * creep.creepages.spin);
}

/// What tractions do in the slip of their elements.
double work_of_elements(const CreepResult& creep) {
  double work = 0.0;
  for (std::size_t i = 0; i < creep.traction_x.size(); ++i) {
    work -= creep.traction_x[i] * creep.slip_x[i] + creep.traction_y[i] * creep.slip_y[i];
  }
  return creep.grid.element_area() * work;
}

/// Two patches in one plane, which roll on radii of their own.
Scene on_two_parts() {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "CHN60";
  scene.lateral = -4.576851748452517;
  scene.yaw = 0.002959786977713627;
  scene.left.load = scene.right.load = 23686.89556895026;
  scene.accuracy = 1e-2;
  scene.side = SideChoice::right;
  return scene;
}

TEST(CreepPower, OfPartsIsTheSumOfTheirs) {
  Scene scene = on_two_parts();
  scene.motion = Motion{.speed = 2e4, .lateral = -11.719058448460416};
  scene.slip.variation = SlipVariation::planar; // slip beyond creepages has a power of its own
  const SceneResult result = solve_scene(scene);
  const PatchResult& patch = result.right.value().patches.at(0);
  ASSERT_EQ(patch.parts.size(), 2U);
  double sum = 0.0;
  for (const PatchResult& part : patch.parts) {
    EXPECT_DOUBLE_EQ(part.creep->power_per_speed, product_of(*part.creep));
    sum += product_of(*part.creep);
  }
  EXPECT_DOUBLE_EQ(patch.creep->power_per_speed, sum);
  // Creepages of the whole are the parts' in the mean: without that -F.w is 3.2 % too small.
  EXPECT_NEAR(product_of(*patch.creep) / sum, 1.0, 0.01);
}

TEST(CreepPower, OfPartsWithGivenCreepagesIsThatOfTheWhole) {
  Scene scene = on_two_parts();
  scene.right.creepages = Creepages{-3e-3, -3.5e-3, 3e-4};
  const SceneResult result = solve_scene(scene);
  const PatchResult& patch = result.right.value().patches.at(0);
  ASSERT_EQ(patch.parts.size(), 2U);
  const CreepResult& creep = *patch.creep;
  EXPECT_NEAR(product_of(creep) / (creep.power_per_speed - creep.power_of_pressures), 1.0, 1e-9);
}

// A soft rail pulls the wheel along: -F.w is negative where the creepage is small.
TEST(CreepPower, OfUnlikeBodiesIsThatOfTheirSlip) {
  Scene scene;
  scene.rail_material = {70000.0, 0.33};
  scene.left.creepages = Creepages{2e-4, 0.0, 0.0};
  scene.lateral = 3.0;
  scene.side = SideChoice::left;
  scene.accuracy_of = AccuracyOf::forces;
  const SceneResult result = solve_scene(scene);
  const CreepResult& creep = *result.left.value().patches.at(0).creep;
  EXPECT_LT(product_of(creep), 0.0);
  EXPECT_GT(creep.power_per_speed, 0.0);
  EXPECT_NEAR(creep.power_per_speed / work_of_elements(creep), 1.0, 0.05);
}

TEST(CreepPower, OfUnlikeBodiesIsNeverNegative) {
  std::mt19937_64 engine(49);
  const auto between = [&engine](double least, double greatest) {
    return least + (greatest - least) * 0x1p-64 * static_cast<double>(engine());
  };
  SceneSolver solver;
  int against = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene;
    scene.side = SideChoice::left;
    scene.accuracy = 1e-2;
    scene.accuracy_of = AccuracyOf::forces;
    scene.lateral = between(-5.0, 5.0);
    scene.rail_material = {between(4e4, 2e5), between(0.2, 0.45)};
    scene.left.friction.coefficient = between(0.05, 0.6);
    const double size = std::pow(10.0, between(-5.0, -2.0));
    scene.left.creepages = Creepages{size * between(-1.0, 1.0), size * between(-1.0, 1.0),
                                     0.1 * size * between(-1.0, 1.0)};
    const SceneResult result = solver.solve(scene);
    for (const PatchResult& patch : result.left.value().patches) {
      EXPECT_GE(patch.creep->power_per_speed, 0.0) << i;
      EXPECT_GE(patch.creep->friction_power, 0.0) << i;
      against += product_of(*patch.creep) < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(against, 5);
}

/// His law has no moment of spin: where spin opposes the lateral creepage it would give power.
TEST(CreepPower, OfPolachsLawIsNeverNegative) {
  Scene scene;
  scene.side = SideChoice::left;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  scene.creep = CreepModel::polach;
  bool is_against = false;
  for (const double lateral : {1e-6, 1e-5, 1e-4}) {
    for (const double spin : {-1e-3, 1e-3}) {
      scene.left.creepages = Creepages{0.0, lateral, spin};
      const SceneResult result = solve_scene(scene);
      const CreepResult& creep = result.left.value().patches.front().creep.value();
      EXPECT_GE(creep.power_per_speed, 0.0);
      is_against = is_against || product_of(creep) < 0.0;
    }
  }
  EXPECT_TRUE(is_against) << "the law as it is";
}

} // namespace
} // namespace wrc::test::creep_power_test
