// Creep forces of a patch of unlike bodies, and the problem of a patch's creep forces.
#include "creep/creep_of_unlike_bodies.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "creep/creep_problem.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::creep_of_unlike_bodies_test {
namespace {

/// The left tread contact of the default scene.
class PatchOfScene : public testing::Test {
protected:
  PatchOfScene() {
    Scene scene;
    scene.side = SideChoice::left;
    result_ = solve_scene(scene);
    motion_.creepages = {1e-3, -5e-4, 1e-4};
    motion_.friction = 0.3;
    request_.model = CreepModel::full;
    request_.accuracy = 1e-2;
    request_.material.modulus = 82000.0;
    request_.material.poisson = 0.28;
    request_.combined_modulus = wheel().details.request.combined_modulus;
  }
  [[nodiscard]] const WheelResult& wheel() const { return *result_.left; }
  [[nodiscard]] const PatchResult& patch() const { return wheel().patches.front(); }
  [[nodiscard]] PatchTask task() const { return {wheel(), patch(), motion_, request_, nullptr}; }
  [[nodiscard]] static double load_of(const CreepResult& creep) {
    return creep.grid.element_area() *
           std::accumulate(creep.pressure.begin(), creep.pressure.end(), 0.0);
  }

  SceneResult result_;
  PatchMotion motion_;
  CreepRequest request_;
  RollingSolver solver_;
};

using CreepProblemOfPatch = PatchOfScene;

TEST_F(CreepProblemOfPatch, HasThePatchesLoadAndItsCreepagesInTheRollingFrame) {
  for (const bool backwards : {false, true}) {
    motion_.frame = RollingFrame(1.0, backwards);
    CreepResult creep;
    LinePlans plans;
    const CreepProblem problem(task(), plans, creep);
    EXPECT_NEAR(load_of(creep), patch().normal_force, 1e-9 * patch().normal_force);
    const double turn = backwards ? -1.0 : 1.0;
    EXPECT_EQ(problem.rolling().creepages.longitudinal, turn * motion_.creepages.longitudinal);
    EXPECT_EQ(problem.rolling().creepages.spin, motion_.creepages.spin);
    // Half a turn about the normal exchanges the first element and the last.
    ASSERT_EQ(problem.rolling().pressure.size(), creep.pressure.size());
    for (std::size_t i = 0; i < creep.pressure.size(); ++i) {
      EXPECT_EQ(problem.rolling().pressure[i],
                creep.pressure[backwards ? creep.pressure.size() - 1 - i : i]);
    }
  }
}

TEST_F(CreepProblemOfPatch, TurnsForcesBackIntoThePatchesFrame) {
  request_.slip.variation = SlipVariation::planar; // the wheel has no surface
  motion_.frame = RollingFrame(1.0, true);
  CreepResult creep;
  LinePlans plans;
  const CreepProblem problem(task(), plans, creep);
  RollingSolution solution;
  solution.longitudinal_force = 3.0;
  solution.lateral_force = -2.0;
  solution.spin_moment = 5.0;
  solution.slip_area = 7.0;
  const CreepForces forces = problem.take(solution, creep);
  EXPECT_EQ(forces.longitudinal, -3.0);
  EXPECT_EQ(forces.lateral, 2.0);
  EXPECT_EQ(forces.spin_moment, 5.0);
  EXPECT_EQ(creep.slip_area, 7.0);
}

using CreepOfUnlikeBodies = PatchOfScene;

/// Tractions of unlike bodies move pressures, and leave their sum.
TEST_F(CreepOfUnlikeBodies, PressuresKeepTheLoad) {
  double last_change = 0.0;
  for (const double difference : {0.05, 0.2}) {
    request_.material.difference_parameter = difference;
    CreepResult creep;
    const CreepForces forces = forces_of_unlike_bodies(task(), solver_, creep);
    EXPECT_NEAR(load_of(creep), patch().normal_force, 1e-6 * patch().normal_force);
    EXPECT_GT(creep.pressure_change, last_change) << "more with the difference of the bodies";
    EXPECT_LT(std::hypot(forces.longitudinal, forces.lateral), 0.3 * patch().normal_force * 1.001);
    EXPECT_LT(forces.longitudinal, 0.0) << "against the creepage";
    last_change = creep.pressure_change;
  }
}

} // namespace
} // namespace wrc::test::creep_of_unlike_bodies_test
