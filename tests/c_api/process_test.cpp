/// What concerns the whole process: the planner's lock, wisdom.
#include "all_results.hpp"
#include "owned_handles.hpp"

namespace process_test {
namespace {

struct CountingLock {
  int locked = 0;
  int unlocked = 0;
  static void lock(void* context) { ++static_cast<CountingLock*>(context)->locked; }
  static void unlock(void* context) { ++static_cast<CountingLock*>(context)->unlocked; }
};

TEST(PlannerLock, OfTheHostIsHeldDuringPlanning) {
  CountingLock counts;
  EXPECT_EQ(wrc_set_planner_lock(CountingLock::lock, nullptr, &counts), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_set_planner_lock(nullptr, CountingLock::unlock, &counts), WRC_INVALID_ARGUMENT);
  plan_length(1900); // longer than those of other tests in this process
  EXPECT_EQ(counts.locked, 0);
  ASSERT_EQ(wrc_set_planner_lock(CountingLock::lock, CountingLock::unlock, &counts), WRC_OK);
  plan_length(2300);
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
  const int locked = counts.locked;
  EXPECT_GT(locked, 0);
  EXPECT_EQ(counts.unlocked, locked);
  plan_length(2900);
  EXPECT_EQ(counts.locked, locked);
}

TEST(PlannerLock, IsNotTakenByANewSceneNorBySolutionsOfASolver) {
  CountingLock counts;
  ASSERT_EQ(wrc_set_planner_lock(CountingLock::lock, CountingLock::unlock, &counts), WRC_OK);
  const ScenePointer scene = make_small_scene();
  EXPECT_EQ(counts.locked, 0) << "a scene plans when it is solved";
  const SolverPointer solver = make_solver();
  counts.locked = 0;
  EXPECT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
  set(scene.get(), {{"solve.grid", std::vector{300.0, 90.0}}});
  EXPECT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
  EXPECT_EQ(counts.locked, 0) << "a solver has planned all lines";
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
}

class Wisdom : public WithFolder {};

TEST_F(Wisdom, IsSavedAndLoaded) {
  EXPECT_EQ(wrc_save_wisdom(path("wisdom").c_str()), WRC_OK);
  EXPECT_TRUE(std::filesystem::exists(path("wisdom")));
  EXPECT_EQ(wrc_load_wisdom(path("wisdom").c_str()), WRC_OK);
}

TEST_F(Wisdom, FailuresHaveAStatus) {
  EXPECT_EQ(wrc_load_wisdom(nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_save_wisdom(nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_load_wisdom(path("absent").c_str()), WRC_FILE_UNREADABLE);
  EXPECT_EQ(wrc_save_wisdom(path("absent/wisdom").c_str()), WRC_FILE_UNREADABLE);
  EXPECT_EQ(wrc_load_wisdom(write("text", "not wisdom").c_str()), WRC_FILE_MALFORMED);
}

} // namespace
} // namespace process_test
