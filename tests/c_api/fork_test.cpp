/// fork() while other threads use the library: the child can use it too.
#include <atomic>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "owned_handles.hpp"

namespace {

double solved(wrc_solver* solver, double lateral) {
  const ScenePointer scene = make_small_scene();
  double pmax = -1.0;
  if (wrc_scene_set_number(scene.get(), "pose.lateral", lateral) != WRC_OK ||
      wrc_solver_solve(solver, scene.get()) != WRC_OK ||
      wrc_scene_number(scene.get(), "left.pmax", &pmax) != WRC_OK) {
    return -1.0;
  }
  return pmax;
}

class Fork : public WithFolder {};

TEST_F(Fork, ChildrenSolveWhileThreadsOfTheParentSolve) {
  constexpr int children = 60;
  constexpr unsigned patience = 60; // seconds, on a busy machine
  std::atomic<bool> ended{false};
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&, i] {
      const std::string wisdom = path("wisdom." + std::to_string(i));
      while (!ended) { // mostly in the tables of handles, and under the planner's lock
        const NormalPointer normal = make_normal();
        for (int j = 0; j < 50; ++j) {
          const ScenePointer scene = make_scene();
        }
        EXPECT_EQ(wrc_save_wisdom(wisdom.c_str()), WRC_OK);
      }
    });
  }
  int failed = 0;
  for (int i = 0; i < children; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      alarm(patience); // ends a child that waits for a thread it does not have
      wrc_solver* solver = nullptr;
      const bool good = wrc_solver_create(&solver) == WRC_OK && solved(solver, 3.0) > 0.0 &&
                        wrc_save_wisdom(path("child").c_str()) == WRC_OK;
      wrc_solver_destroy(solver);
      _exit(good ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    failed += status == 0 ? 0 : 1;
    if (failed > 0) {
      break;
    }
  }
  ended = true;
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(failed, 0);
}

TEST_F(Fork, AHandleInUseByAThreadMissingInTheChildIsBusy) {
  const ScenePointer scene = make_scene();
  set(scene.get(), {{"solve.accuracy", 1e-4}});
  std::atomic<bool> ended{false};
  std::thread thread([&] {
    while (!ended) {
      EXPECT_EQ(wrc_scene_solve(scene.get()), WRC_OK);
    }
  });
  bool busy = false;
  for (int i = 0; i < 100 && !busy; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      double pmax = 0.0;
      _exit(wrc_scene_number(scene.get(), "left.pmax", &pmax) == WRC_BUSY ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    busy = status == 0;
  }
  ended = true;
  thread.join();
  EXPECT_TRUE(busy);
}

} // namespace
