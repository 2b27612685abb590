/// The solver handle: bit for bit the results of scenes by themselves, whatever was solved before.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "all_results.hpp"

namespace solver_test {
namespace {

TEST(SolverHandle, RefusesNull) {
  EXPECT_EQ(wrc_solver_create(nullptr), WRC_INVALID_ARGUMENT);
  wrc_solver_destroy(nullptr);
  const ScenePointer scene = make_small_scene();
  EXPECT_EQ(wrc_solver_solve(nullptr, scene.get()), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_solver_clear(nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_solver_error(nullptr), "NULL"));
  EXPECT_EQ(wrc_scene_number_count(scene.get()), 0);

  const SolverPointer solver = make_solver();
  EXPECT_STREQ(wrc_solver_error(solver.get()), "");
  EXPECT_EQ(wrc_solver_solve(solver.get(), nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_solver_error(solver.get()), "scene = NULL"));
  EXPECT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
  EXPECT_STREQ(wrc_solver_error(solver.get()), "");
}

TEST(SolverHandle, MayBeClearedAndDestroyedUnused) {
  const SolverPointer solver = make_solver();
  EXPECT_EQ(wrc_solver_clear(solver.get()), WRC_OK);
}

TEST(SolverHandle, HasOptionsThatChangeNoResultByMoreThanItsTolerance) {
  const SolverPointer solver = make_solver();
  wrc_solver* s = solver.get();
  const auto expect_told = [s](const char* key, const char* value, wrc_status status,
                               const std::string& text) {
    EXPECT_EQ(wrc_solver_set_text(s, key, value), status) << key;
    EXPECT_TRUE(contains(wrc_solver_error(s), text)) << wrc_solver_error(s);
  };
  EXPECT_EQ(wrc_solver_set_text(nullptr, "planner", "measure"), WRC_INVALID_ARGUMENT);
  expect_told(nullptr, "measure", WRC_INVALID_ARGUMENT, "key = NULL");
  expect_told("planner", nullptr, WRC_INVALID_ARGUMENT, "value = NULL");
  expect_told("threads", "2", WRC_UNKNOWN_NAME, "there are planner, precision");
  expect_told("precision", "single", WRC_INVALID_ARGUMENT,
              "precision = \"single\": must be \"mixed\" or \"double\"");
  const auto pmax = [s] {
    const ScenePointer scene = make_scene();
    EXPECT_EQ(wrc_solver_solve(s, scene.get()), WRC_OK);
    return number_of(scene.get(), "left.pmax");
  };
  const double mixed = pmax();
  ASSERT_EQ(wrc_solver_set_text(s, "Precision", "double"), WRC_OK);
  const double in_double = pmax();
  EXPECT_NE(in_double, mixed);
  EXPECT_NEAR(in_double, mixed, 1e-4 * mixed);
  ASSERT_EQ(wrc_solver_clear(s), WRC_OK);
  EXPECT_EQ(pmax(), in_double); // options stay
  ASSERT_EQ(wrc_solver_set_text(s, "precision", "mixed"), WRC_OK);
  EXPECT_EQ(pmax(), mixed);
  ASSERT_EQ(wrc_solver_set_text(s, "planner", "measure"), WRC_OK);
  EXPECT_NEAR(pmax(), mixed, 1e-4 * mixed);
}

struct Step {
  double lateral = 0.0; ///< mm
  double yaw = 0.0;     ///< rad
  double load = 80e3;   ///< N
};

ScenePointer make_scene_at(const Step& step, double accuracy) {
  ScenePointer scene = make_scene();
  set(scene.get(), {{"solve.accuracy", accuracy},
                    {"pose.lateral", step.lateral},
                    {"pose.yaw", step.yaw},
                    {"load.both", step.load}});
  return scene;
}

/// The scene through the solver and another handle of it by itself.
void expect_the_same(wrc_solver* solver, wrc_scene* scene, wrc_scene* alone,
                     const std::string& where) {
  SCOPED_TRACE(where);
  ASSERT_EQ(wrc_solver_solve(solver, scene), WRC_OK) << wrc_scene_error(scene);
  solve(alone);
  expect_same_bits(scene, alone, where);
}

void expect_the_same(wrc_solver* solver, const Step& step, double accuracy,
                     const std::string& where) {
  const ScenePointer scene = make_scene_at(step, accuracy);
  const ScenePointer alone = make_scene_at(step, accuracy);
  expect_the_same(solver, scene.get(), alone.get(), where);
}

constexpr std::array accuracies{1e-2, 1e-3};

TEST(Solver, EqualsAFreshSceneInAHuntingMotion) {
  constexpr int steps = 24;
  constexpr double amplitude = 5.0;
  for (const double accuracy : accuracies) {
    const SolverPointer solver = make_solver();
    for (int i = 0; i <= steps; ++i) {
      const double phase = 2.0 * std::numbers::pi * i / steps;
      const Step step{amplitude * std::sin(phase), 0.004 * std::cos(phase),
                      80e3 * (1.0 + 0.2 * std::sin(3.0 * phase))};
      expect_the_same(solver.get(), step, accuracy, "step " + std::to_string(i));
    }
  }
}

/// Found by random scenes: on a steep contact each sampling at another depth moved the area of four
/// rows outwards, until contact was lost.
TEST(Solver, SettlesOnFewRowsOfASteepContact) {
  const SolverPointer solver = make_solver();
  const auto solve_at = [&solver](double lateral, double share) {
    ScenePointer scene = make_scene();
    for (const auto& [key, text] :
         {std::pair{"wheelset.wheel", "LM"}, std::pair{"track.rail", "50E6"}}) {
      set(scene.get(), {{key, text}});
    }
    for (const auto& [key, value] :
         {std::pair{"track.inclination", 0.049958395721942765},
          std::pair{"material.wheel.youngs_modulus", 422325.3394000648},
          std::pair{"material.wheel.poisson", 0.04495665503644064},
          std::pair{"material.rail.youngs_modulus", 935182.9543814091},
          std::pair{"material.rail.poisson", 0.3620161031547651},
          std::pair{"pose.yaw", -0.02700864159079197}, std::pair{"pose.lateral", lateral},
          std::pair{"load.left", share * 38.66016290526467},
          std::pair{"load.right", share * 53895.89315811987},
          std::pair{"solve.tolerance", 0.009228579474895734}}) {
      set(scene.get(), {{key, value}});
    }
    set(scene.get(), {{"solve.grid", std::vector{4.0, 58.0}}});
    return wrc_solver_solve(solver.get(), scene.get());
  };
  constexpr double lateral = -7.516088928447349;
  EXPECT_EQ(solve_at(0.97 * lateral + 0.1, 0.9), WRC_OK);
  EXPECT_EQ(solve_at(lateral, 1.0), WRC_OK);
}

TEST(Solver, EqualsAFreshSceneOnTheFlangeAndBack) {
  for (const double accuracy : accuracies) {
    const SolverPointer solver = make_solver();
    for (const double lateral : {4.0, 4.0, 8.0, 8.0, 4.0, -8.0, 8.0, 0.0}) {
      expect_the_same(solver.get(), Step{lateral}, accuracy, "lateral " + std::to_string(lateral));
    }
  }
}

TEST(Solver, ContinuesAfterAStepThatDidNotConverge) {
  // Two patches about to join at an accuracy that is hardly within reach: depth and coupling chase
  // each other, and the number of patches changes from step to step.
  SolverPointer solver = make_solver();
  for (const double load : {23474.0, 24200.0, 24926.0, 24200.0}) {
    ScenePointer scene = make_scene();
    set(scene.get(), {{"track.rail", "UIC60-Manchester"},
                      {"solve.side", "left"},
                      {"pose.lateral", 5.0},
                      {"solve.accuracy", 3e-5},
                      {"load.both", load}});
    ASSERT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK) << load;
    EXPECT_NEAR(number_of(scene.get(), "left.vertical_force"), load, 1e-6 * load);
    EXPECT_GT(number_of(scene.get(), "left.pmax"), 1900.0);
    EXPECT_LT(number_of(scene.get(), "left.pmax"), 2200.0);
  }
}

TEST(Solver, EqualsAFreshSceneAfterChangesOfLoad) {
  for (const double accuracy : accuracies) {
    const SolverPointer solver = make_solver();
    for (const double load : {80e3, 8e3, 80e3, 800e3, 80e3, 8e3, 800e3, 0.8}) {
      expect_the_same(solver.get(), Step{1.0, 0.002, load}, accuracy,
                      "load " + std::to_string(load));
    }
  }
}

TEST(Solver, EqualsAFreshSceneAfterChangesOfProfilesAndYaw) {
  constexpr double accuracy = 1e-3;
  const SolverPointer solver = make_solver();
  for (const double yaw : {0.0, 0.02, -0.05}) {
    for (const auto& [wheel, rail] :
         {std::pair{"S1002", "60E1"}, std::pair{"LMA", "60E1"}, std::pair{"LMA", "CHN60"},
          std::pair{"S1002", "54E1"}, std::pair{"S1002", "60E1"}}) {
      const ScenePointer scene = make_scene_at({2.0, yaw}, accuracy);
      const ScenePointer alone = make_scene_at({2.0, yaw}, accuracy);
      for (wrc_scene* each : {scene.get(), alone.get()}) {
        set(each, {{"wheelset.wheel", wheel}, {"track.rail", rail}});
      }
      expect_the_same(solver.get(), scene.get(), alone.get(),
                      std::string(wheel) + " on " + rail + ", yaw " + std::to_string(yaw));
    }
  }
}

TEST(Solver, EqualsAFreshSceneAtPrescribedHeightsAndWithoutContact) {
  constexpr double accuracy = 1e-3;
  const SolverPointer solver = make_solver();
  const ScenePointer first = make_scene_at({2.0}, accuracy);
  ASSERT_EQ(wrc_solver_solve(solver.get(), first.get()), WRC_OK);
  const double touch =
      std::min(number_of(first.get(), "left.vertical"), number_of(first.get(), "right.vertical"));
  for (const double depth : {0.05, 0.1, -1.0, 0.02, 0.0, 0.3}) {
    const ScenePointer scene = make_scene_at({2.0}, accuracy);
    const ScenePointer alone = make_scene_at({2.0}, accuracy);
    for (wrc_scene* each : {scene.get(), alone.get()}) {
      set(each, {{"pose.vertical", touch - depth}});
    }
    expect_the_same(solver.get(), scene.get(), alone.get(), "depth " + std::to_string(depth));
    EXPECT_EQ(number_of(scene.get(), "left.pmax") > 0.0, depth > 0.0);
    expect_the_same(solver.get(), Step{2.0}, accuracy,
                    "loaded after depth " + std::to_string(depth));
  }
}

TEST(Solver, EqualsAFreshSceneWithoutLoad) {
  constexpr double accuracy = 1e-3;
  const SolverPointer solver = make_solver();
  for (const double load : {80e3, 0.0, 80e3}) {
    const ScenePointer scene = make_scene_at({1.0, 0.0, load}, accuracy);
    const ScenePointer alone = make_scene_at({1.0, 0.0, load}, accuracy);
    expect_the_same(solver.get(), scene.get(), alone.get(), "load " + std::to_string(load));
    EXPECT_EQ(number_of(scene.get(), "right.pmax") > 0.0, load > 0.0);
  }
}

TEST(Solver, EqualsAFreshSceneWithOrWithoutClearing) {
  for (const bool clears : {false, true}) {
    const SolverPointer solver = make_solver();
    for (int i = 0; i < 12; ++i) {
      const ScenePointer other = make_varied_scene(i + 5);
      ASSERT_EQ(wrc_solver_solve(solver.get(), other.get()), WRC_OK);
      if (clears) {
        ASSERT_EQ(wrc_solver_clear(solver.get()), WRC_OK);
      }
      const ScenePointer scene = make_varied_scene(i);
      const ScenePointer alone = make_varied_scene(i);
      expect_the_same(solver.get(), scene.get(), alone.get(), "scene " + std::to_string(i));
    }
  }
}

/// Makes a scene unsolvable; what it failed with.
struct Failure {
  const char* key;
  const char* text; ///< or a number
  double number;
  wrc_status status;
};
constexpr std::array<Failure, 2> failures{{
    {"wheelset.wheel", "no such wheel", 0.0, WRC_UNKNOWN_NAME},
    {"pose.lateral", nullptr, 90.0, WRC_NO_CONTACT},
}};

void spoil(wrc_scene* scene, const Failure& failure) {
  if (failure.text != nullptr) {
    ASSERT_EQ(wrc_scene_set_text(scene, failure.key, failure.text), WRC_OK);
  } else {
    ASSERT_EQ(wrc_scene_set_number(scene, failure.key, failure.number), WRC_OK);
  }
}

TEST(Solver, StaysUsableAfterAFailure) {
  for (const Failure& failure : failures) {
    SCOPED_TRACE(failure.key);
    const SolverPointer solver = make_solver();
    const ScenePointer scene = make_scene_at({1.0}, 1e-2);
    wrc_scene* s = scene.get();
    ASSERT_EQ(wrc_solver_solve(solver.get(), s), WRC_OK);
    const AllResults before(s);
    spoil(s, failure);
    // The solver is also to make others than it has kept.
    EXPECT_EQ(wrc_solver_set_text(solver.get(), "precision", "double"), WRC_OK);
    EXPECT_EQ(wrc_solver_solve(solver.get(), s), failure.status);
    EXPECT_STRNE(wrc_scene_error(s), "");
    EXPECT_EQ(AllResults(s).difference_to(before), "");
    EXPECT_EQ(wrc_solver_set_text(solver.get(), "precision", "mixed"), WRC_OK);

    const ScenePointer next = make_scene_at({1.2}, 1e-2);
    const ScenePointer alone = make_scene_at({1.2}, 1e-2);
    expect_the_same(solver.get(), next.get(), alone.get(), "after a failure");

    // The scene that failed is solved as soon as it can be.
    set(s, {{"wheelset.wheel", "S1002"}, {"pose.lateral", 1.0}});
    ASSERT_EQ(wrc_solver_solve(solver.get(), s), WRC_OK);
    EXPECT_STREQ(wrc_scene_error(s), "");
    EXPECT_EQ(AllResults(s).difference_to(before), "");
  }
}

class SolverFiles : public WithFolder {};

TEST_F(SolverFiles, AreReadAgainOnceForgotten) {
  const ProfilePointer profile = make_profile();
  ASSERT_EQ(wrc_profile_load_standard(profile.get(), "60E1"), WRC_OK);
  ASSERT_EQ(wrc_profile_write(profile.get(), path("rail.prr").c_str(), 0.1), WRC_OK);
  const SolverPointer solver = make_solver();
  const ScenePointer scene = make_scene_at({1.0}, 1e-2);
  set(scene.get(), {{"track.rail", path("rail.prr").c_str()}});
  ASSERT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK) << wrc_scene_error(scene.get());
  const AllResults before(scene.get());
  std::filesystem::remove(path("rail.prr"));
  ASSERT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
  EXPECT_EQ(AllResults(scene.get()).difference_to(before), "");
  ASSERT_EQ(wrc_solver_clear(solver.get()), WRC_OK);
  EXPECT_NE(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
  EXPECT_EQ(AllResults(scene.get()).difference_to(before), "");
}

/// A scene by itself reads a file again when it has changed, not at every solution.
TEST_F(SolverFiles, AreReadOnceByAScene) {
  const ProfilePointer profile = make_profile();
  ASSERT_EQ(wrc_profile_load_standard(profile.get(), "60E1"), WRC_OK);
  ASSERT_EQ(wrc_profile_write(profile.get(), path("rail.prr").c_str(), 0.1), WRC_OK);
  const ScenePointer scene = make_scene_at({1.0}, 1e-2);
  set(scene.get(), {{"track.rail", path("rail.prr").c_str()}});
  ASSERT_EQ(wrc_scene_solve(scene.get()), WRC_OK) << wrc_scene_error(scene.get());
  EXPECT_GT(number_of(scene.get(), "time_ms.profile"), 0.0);
  ASSERT_EQ(wrc_scene_solve(scene.get()), WRC_OK);
  EXPECT_EQ(number_of(scene.get(), "time_ms.profile"), 0.0);
}

} // namespace
} // namespace solver_test
