/// Handles that were destroyed, never were, or are of another kind; and the caller's floating-point
/// environment.
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "all_results.hpp"

namespace handles_test {
namespace {

template <class Handle> Handle* handle_of(std::uintptr_t number) {
  return reinterpret_cast<Handle*>(number);
}

TEST(Handles, MayBeDestroyedTwice) {
  wrc_scene* scene = nullptr;
  ASSERT_EQ(wrc_scene_create(&scene), WRC_OK);
  wrc_scene_destroy(scene);
  wrc_scene_destroy(scene);
  expect_error(scene, wrc_scene_solve(scene), WRC_INVALID_ARGUMENT, "destroyed");
  wrc_solver* solver = nullptr;
  ASSERT_EQ(wrc_solver_create(&solver), WRC_OK);
  wrc_solver_destroy(solver);
  wrc_solver_destroy(solver);
  EXPECT_EQ(wrc_solver_clear(solver), WRC_INVALID_ARGUMENT);
  wrc_profile* profile = nullptr;
  ASSERT_EQ(wrc_profile_create(&profile), WRC_OK);
  wrc_profile_destroy(profile);
  wrc_profile_destroy(profile);
  EXPECT_EQ(wrc_profile_load_standard(profile, "S1002"), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_profile_correction(profile, 0), nullptr);
  wrc_normal* normal = nullptr;
  ASSERT_EQ(wrc_normal_create(&normal), WRC_OK);
  wrc_normal_destroy(normal);
  wrc_normal_destroy(normal);
  EXPECT_EQ(wrc_normal_solve(normal), WRC_INVALID_ARGUMENT);
  wrc_rolling* rolling = nullptr;
  ASSERT_EQ(wrc_rolling_create(&rolling), WRC_OK);
  wrc_rolling_destroy(rolling);
  wrc_rolling_destroy(rolling);
  EXPECT_EQ(wrc_rolling_solve(rolling), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_rolling_error(rolling), "destroyed"));
}

TEST(Handles, AnyNumberIsRefused) {
  for (const std::uintptr_t number :
       {std::uintptr_t{1}, std::uintptr_t{7}, std::uintptr_t{0xDEADBEEF},
        std::numeric_limits<std::uintptr_t>::max()}) {
    EXPECT_EQ(wrc_scene_solve(handle_of<wrc_scene>(number)), WRC_INVALID_ARGUMENT);
    EXPECT_EQ(wrc_normal_solve(handle_of<wrc_normal>(number)), WRC_INVALID_ARGUMENT);
    EXPECT_EQ(wrc_rolling_solve(handle_of<wrc_rolling>(number)), WRC_INVALID_ARGUMENT);
    wrc_profile_destroy(handle_of<wrc_profile>(number));
    EXPECT_EQ(wrc_scene_number_count(handle_of<wrc_scene>(number)), 0);
  }
}

TEST(Handles, OneOfAnotherKindIsRefused) {
  const ScenePointer scene = make_small_scene();
  const SolverPointer solver = make_solver();
  auto* mistaken = reinterpret_cast<wrc_scene*>(solver.get());
  expect_error(mistaken, wrc_scene_solve(mistaken), WRC_INVALID_ARGUMENT, "another kind");
  wrc_scene_destroy(mistaken);
  EXPECT_EQ(wrc_solver_solve(solver.get(), mistaken), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_solver_error(solver.get()), "another kind"));
  EXPECT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
  wrc_scene* scenes[] = {scene.get(), mistaken};
  EXPECT_EQ(wrc_solve_batch(scenes, 2, 1, nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_scene_error(scene.get()), "scenes[1]: the handle has been destroyed"));
}

TEST(Handles, ABatchSaysWhichHandleItHasTwice) {
  const ScenePointer one = make_small_scene();
  const ScenePointer two = make_small_scene();
  wrc_scene* scenes[] = {one.get(), two.get(), one.get()};
  wrc_status statuses[] = {WRC_OK, WRC_OK, WRC_OK};
  EXPECT_EQ(wrc_solve_batch(scenes, 3, 1, statuses), WRC_INVALID_ARGUMENT);
  for (const wrc_status status : statuses) {
    EXPECT_EQ(status, WRC_INVALID_ARGUMENT);
  }
  EXPECT_TRUE(contains(wrc_scene_error(one.get()), "scenes[2]: the same handle as another one"));
  EXPECT_TRUE(contains(wrc_scene_error(two.get()), "scenes[2]"));

  const SolverPointer first = make_solver();
  const SolverPointer second = make_solver();
  wrc_solver* solvers[] = {first.get(), second.get()};
  wrc_history* history = nullptr;
  ASSERT_EQ(wrc_history_create(&history), WRC_OK);
  wrc_history* histories[] = {history, history};
  wrc_step_arguments arguments{};
  arguments.struct_size = sizeof arguments;
  arguments.time_step = 1e-3;
  arguments.histories = histories;
  const double numbers[12] = {};
  double forces[24];
  statuses[0] = statuses[1] = WRC_OK;
  EXPECT_EQ(
      wrc_step_batch_with(solvers, scenes, 2, 1, numbers, numbers, &arguments, forces, statuses),
      WRC_INVALID_ARGUMENT);
  EXPECT_EQ(statuses[0], WRC_INVALID_ARGUMENT);
  EXPECT_EQ(statuses[1], WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_scene_error(two.get()), "histories[1]: the same handle"));
  wrc_history_destroy(history);
}

TEST(Status, AnExceptionOfTheCallersOwnCodeIsAnInternalFault) {
  // A lock must not throw; if it does, the call ends with a status and the text.
  bool throws = true;
  const auto lock = [](void* context) {
    if (*static_cast<bool*>(context)) {
      throw std::runtime_error("a lock that throws");
    }
  };
  const ScenePointer scene = make_small_scene();
  const SolverPointer solver = make_solver();
  ASSERT_EQ(wrc_solver_set_text(solver.get(), "planner", "measure"), WRC_OK); // while it solves
  ASSERT_EQ(wrc_set_planner_lock(
                lock, [](void*) {}, &throws),
            WRC_OK);
  EXPECT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_INTERNAL);
  EXPECT_STREQ(wrc_scene_error(scene.get()), "a lock that throws");
  throws = false;
  solve(scene.get());
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
}

TEST(FloatingPoint, FlagsAndRoundingOfTheCallerAreKept) {
  const ScenePointer scene = make_small_scene();
  std::feclearexcept(FE_ALL_EXCEPT);
  std::feraiseexcept(FE_DIVBYZERO);
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  solve(scene.get());
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), FE_DIVBYZERO);
  std::fesetround(FE_TONEAREST);
  std::feclearexcept(FE_ALL_EXCEPT);
  const ScenePointer usual = make_small_scene();
  solve(usual.get());
  expect_same_bits(scene.get(), usual.get(), "rounding upward outside");
}

#if defined(__GLIBC__)
TEST(FloatingPoint, TrapsOfTheCallerDoNotFire) {
  const ScenePointer scene = make_scene();
  const SolverPointer solver = make_solver();
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW);
  wrc_scene* handles[] = {scene.get()};
  const wrc_status single = wrc_scene_solve(scene.get());
  const wrc_status kept = wrc_solver_solve(solver.get(), scene.get());
  const wrc_status batch = wrc_solve_batch(handles, 1, 2, nullptr);
  double value = 0.0;
  const wrc_status rates =
      wrc_scene_number(scene.get(), "left.sensitivities.pressure_force.z.vertical", &value);
  const int traps = fedisableexcept(FE_ALL_EXCEPT);
  EXPECT_EQ(traps, FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW);
  EXPECT_EQ(single, WRC_OK);
  EXPECT_EQ(kept, WRC_OK);
  EXPECT_EQ(batch, WRC_OK);
  EXPECT_EQ(rates, WRC_OK);
}
#endif

} // namespace
} // namespace handles_test
