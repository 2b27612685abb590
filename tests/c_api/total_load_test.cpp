/// Loads given as what all contact forces of a wheel carry, creep forces included.
#include <algorithm>
#include <array>
#include <cmath>

#include "all_results.hpp"

namespace total_load_test {
namespace {

/// As stated (docs/vehicle.md, docs/creep.md): of the load, at accuracies from 1e-4 on.
constexpr double total_tolerance = 1e-6;

ScenePointer moving_scene(double lateral, double yaw) {
  ScenePointer scene = make_scene();
  set(scene.get(), {{"pose.lateral", lateral},
                    {"pose.yaw", yaw},
                    {"motion.speed", 2e4},
                    {"motion.lateral", 30.0},
                    {"solve.accuracy", 1e-2}});
  return scene;
}

double relative(wrc_scene* scene, const char* name, double load) {
  return number_of(scene, name) / load - 1.0;
}

void expect_totals(wrc_scene* scene, double left, double right, const std::string& where) {
  EXPECT_LE(std::abs(relative(scene, "left.vertical_force", left)), total_tolerance) << where;
  EXPECT_LE(std::abs(relative(scene, "right.vertical_force", right)), total_tolerance) << where;
}

TEST(TotalLoad, IsCarriedByPressuresAndCreepForces) {
  double largest_difference = 0.0;
  for (const double lateral : {0.0, 3.0, 6.3, -6.3}) {
    for (const double yaw : {-3e-3, 3e-3}) {
      for (const char* pitch : {"rolling", "free"}) {
        const ScenePointer scene = moving_scene(lateral, yaw);
        solve(scene.get(), {{"load.both", 80e3}, {"load.of", "total"}, {"motion.pitch", pitch}});
        const std::string where =
            std::to_string(lateral) + " mm, " + std::to_string(yaw) + ", " + pitch;
        expect_totals(scene.get(), 80e3, 80e3, where);
        largest_difference = std::max(
            largest_difference, std::abs(relative(scene.get(), "left.pressure_force.z", 80e3)));
        // Three or four solutions of two or more each.
        EXPECT_LE(number_of(scene.get(), "left.solutions"), 40.0) << where;
      }
    }
  }
  EXPECT_GT(largest_difference, 0.1);
}

TEST(TotalLoad, HoldsInFullSlidingAndByWheel) {
  const ScenePointer scene = moving_scene(6.3, 5e-3);
  solve(scene.get(),
        {{"motion.pitch", 100.0}, {"load.left", 60e3}, {"load.right", 90e3}, {"load.of", "total"}});
  expect_totals(scene.get(), 60e3, 90e3, "both");
  EXPECT_EQ(number_of(scene.get(), "left.patches.0.adhesion_area"), 0.0);
  solve(scene.get(), {{"load.right", 70e3}});
  expect_totals(scene.get(), 60e3, 70e3, "one of them later");
  solve(scene.get(), {{"motion.pitch", "free"}, {"motion.torque", 2e6}});
  expect_totals(scene.get(), 60e3, 70e3, "coupled");
}

TEST(TotalLoad, HoldsWithEveryModelAndWithDerivatives) {
  for (const char* creep : {"full", "fastsim", "polach", "linear", "none"}) {
    for (const char* model : {"half-space", "hertz"}) {
      for (const char* derivatives : {"no", "yes"}) {
        const ScenePointer scene = moving_scene(3.0, 2e-3);
        solve(scene.get(), {{"load.both", 50e3},
                            {"load.of", "total"},
                            {"solve.creep", creep},
                            {"solve.model", model},
                            {"solve.derivatives", derivatives}});
        expect_totals(scene.get(), 50e3, 50e3, std::string(creep) + ' ' + model);
      }
    }
  }
}

TEST(TotalLoad, IsThatOfPressuresWithoutCreepForces) {
  const ScenePointer total = make_small_scene();
  const ScenePointer pressures = make_small_scene();
  solve(total.get(), {{"pose.lateral", 5.0}, {"load.both", 60e3}, {"load.of", "total"}});
  solve(pressures.get(), {{"pose.lateral", 5.0}, {"load.both", 60e3}});
  expect_same_bits(total.get(), pressures.get(), "no creep forces");
}

/// What the pressures carry then, given as their load, is the same scene.
TEST(TotalLoad, EqualsPrescribingThePressureLoadFound) {
  const ScenePointer total = moving_scene(6.3, 3e-3);
  solve(total.get(), {{"load.both", 80e3}, {"load.of", "total"}});
  const ScenePointer pressures = moving_scene(6.3, 3e-3);
  solve(pressures.get(), {{"load.left", number_of(total.get(), "left.pressure_force.z")},
                          {"load.right", number_of(total.get(), "right.pressure_force.z")}});
  for (const char* name : {"left.total.force.x", "left.total.force.y", "left.total.force.z",
                           "left.pmax", "right.total.force.y", "right.depth"}) {
    const double value = number_of(total.get(), name);
    EXPECT_NEAR(value, number_of(pressures.get(), name), 2e-6 * std::max(std::abs(value), 8e4))
        << name;
  }
}

/// Between steps of the lateral position forces of pressures follow their slope but for what the
/// totals are met within. Creep forces jump by up to 3e-5 of the load under any load.
TEST(TotalLoad, GivesForcesWithoutJumps) {
  const SolverPointer solver = make_solver();
  const ScenePointer scene = moving_scene(0.0, 1e-3);
  set(scene.get(), {{"load.both", 80e3}, {"load.of", "total"}, {"solve.accuracy_of", "forces"}});
  constexpr double step = 1e-4;
  std::vector<double> forces;
  for (int i = 0; i < 40; ++i) {
    set(scene.get(), {{"pose.lateral", 2.0 + step * i}});
    ASSERT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
    forces.push_back(number_of(scene.get(), "left.pressure_force.y"));
  }
  for (std::size_t i = 1; i + 1 < forces.size(); ++i) {
    EXPECT_LE(std::abs(forces[i + 1] - 2.0 * forces[i] + forces[i - 1]), total_tolerance * 80e3)
        << i;
  }
}

TEST(TotalLoad, DoesNotDependOnWhatWasSolvedBeforeOrOnThreads) {
  const SolverPointer solver = make_solver();
  for (const char* pitch : {"rolling", "free"}) {
    const auto scene_of = [pitch](double threads) {
      ScenePointer scene = moving_scene(6.3, 2e-3);
      set(scene.get(), {{"load.both", 80e3},
                        {"load.of", "total"},
                        {"motion.pitch", pitch},
                        {"solve.threads", threads}});
      return scene;
    };
    const ScenePointer alone = scene_of(1.0);
    solve(alone.get());
    for (const double threads : {1.0, 2.0}) {
      const ScenePointer used = scene_of(threads);
      ASSERT_EQ(wrc_solver_solve(solver.get(), used.get()), WRC_OK);
      expect_same_bits(used.get(), alone.get(), pitch);
    }
  }
}

/// The wheel on its flange, pulled upwards along it by friction that carries more than itself.
TEST(TotalLoad, IsRefusedIfNoLoadGivesIt) {
  const ScenePointer scene = make_scene();
  const double steep = 8.0;
  set(scene.get(), {{"pose.lateral", steep},
                    {"solve.accuracy", 1e-2},
                    {"friction.coefficient", 2.0},
                    {"creepage.lateral", 0.5},
                    {"load.left", 80e3},
                    {"load.of", "total"}});
  expect_error(scene.get(), wrc_scene_solve(scene.get()), WRC_INVALID_ARGUMENT, "load.left",
               "80000", "no load on the normal pressures gives this total");
}

/// As such a load on the pressures is: nothing is pressed together, and a warning says so.
TEST(TotalLoad, IsTreatedAsZeroIfTooSmall) {
  for (const char* pitch : {"rolling", "free"}) {
    const ScenePointer scene = moving_scene(3.0, 1e-3);
    solve(scene.get(), {{"load.both", 1e-12}, {"load.of", "total"}, {"motion.pitch", pitch}});
    EXPECT_EQ(number_of(scene.get(), "left.patch_count"), 0.0) << pitch;
    EXPECT_EQ(number_of(scene.get(), "warning_count"), 3.0)
        << pitch << ": also that it is so small";
    const char* kind = nullptr;
    ASSERT_EQ(wrc_scene_text(scene.get(), "warning_classes.1", &kind), WRC_OK) << pitch;
    EXPECT_STREQ(kind, "no_load") << pitch;
    solve(scene.get(), {{"load.left", 80e3}, {"load.of", "total"}});
    EXPECT_LE(std::abs(relative(scene.get(), "left.vertical_force", 80e3)), total_tolerance)
        << pitch;
    EXPECT_EQ(number_of(scene.get(), "right.patch_count"), 0.0) << pitch;
  }
}

TEST(TotalLoad, IsChosenForBothWheels) {
  const ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  const char* text = nullptr;
  ASSERT_EQ(wrc_scene_get_text(s, "load.of", &text), WRC_OK);
  EXPECT_STREQ(text, "pressures");
  set(s, {{"load.of", "total"}, {"load.left", 5e4}});
  double load = 0.0;
  EXPECT_EQ(wrc_scene_get_number(s, "load.right", &load), WRC_OK);
  EXPECT_EQ(load, 80e3);
  expect_error(s, wrc_scene_get_number(s, "load.both", &load), WRC_INVALID_ARGUMENT, "load.both",
               "has no single value");
  expect_error(s, wrc_scene_set_number(s, "load.left", -1.0), WRC_INVALID_ARGUMENT, "load.left",
               "between 0 and 1e12 N");
  expect_error(s, wrc_scene_set_text(s, "load.of", "everything"), WRC_INVALID_ARGUMENT, "load.of",
               "total");
}

/// Approximate models carry it like the half-space, on each wheel its own.
TEST(TotalLoad, OfTheNormalIsMetByEveryModel) {
  for (const char* model : {"half-space", "hertz", "kik-piotrowski"}) {
    const ScenePointer scene = make_scene();
    solve(scene.get(), {{"solve.model", model},
                        {"pose.lateral", 3.0},
                        {"load.of", "normal"},
                        {"load.left", 50e3},
                        {"load.right", 60e3}});
    EXPECT_NEAR(number_of(scene.get(), "left.normal_force"), 50e3, 1e-4 * 50e3) << model;
    EXPECT_NEAR(number_of(scene.get(), "right.normal_force"), 60e3, 1e-4 * 60e3) << model;
    EXPECT_LT(number_of(scene.get(), "left.residuals.load_balance"), 1e-6) << model;
  }
}

/// The position is prescribed then: loads are results.
TEST(TotalLoad, DoesNotMatterWithThePositionPrescribed) {
  const ScenePointer total = moving_scene(1.0, 1e-3);
  const ScenePointer other = moving_scene(1.0, 1e-3);
  const ScenePointer plain = moving_scene(1.0, 1e-3);
  solve(total.get(), {{"pose.vertical", 459.9}, {"load.both", 60e3}, {"load.of", "total"}});
  solve(other.get(), {{"pose.vertical", 459.9}, {"load.both", 50e3}, {"load.of", "total"}});
  solve(plain.get(), {{"pose.vertical", 459.9}});
  expect_same_bits(total.get(), other.get(), "position");
  for (const char* name : {"left.total.force.y", "left.vertical_force", "right.pmax"}) {
    EXPECT_EQ(number_of(total.get(), name), number_of(plain.get(), name)) << name;
  }
  EXPECT_STREQ(wrc_scene_warning(total.get(), 0), "load.both is not used: pose.vertical is set");
}

} // namespace
} // namespace total_load_test
