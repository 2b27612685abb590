/// Many threads: batches of scenes, handles of several threads, the host's planner lock.
#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include "all_results.hpp"
#include "host_transform.hpp"
#include "owned_handles.hpp"
#include "wrcontact.hpp"

namespace {

constexpr int scene_count = 64;

std::vector<ScenePointer> make_varied_scenes() {
  std::vector<ScenePointer> scenes;
  for (int i = 0; i < scene_count; ++i) {
    scenes.push_back(make_varied_scene(i));
  }
  return scenes;
}

std::vector<wrc_scene*> handles_of(const std::vector<ScenePointer>& scenes) {
  std::vector<wrc_scene*> handles;
  for (const ScenePointer& scene : scenes) {
    handles.push_back(scene.get());
  }
  return handles;
}

/// The varied scenes, each solved by itself.
const std::vector<AllResults>& single_results() {
  static const std::vector<AllResults> results = [] {
    std::vector<AllResults> list;
    for (const ScenePointer& scene : make_varied_scenes()) {
      solve(scene.get());
      list.emplace_back(scene.get());
    }
    return list;
  }();
  return results;
}

TEST(Batch, EqualsSingleSolutionsBitForBit) {
  for (const std::int32_t threads : {1, 2, 3, 7}) {
    const std::vector<ScenePointer> scenes = make_varied_scenes();
    const std::vector<wrc_scene*> handles = handles_of(scenes);
    std::vector<wrc_status> statuses(handles.size(), -1);
    EXPECT_EQ(wrc_solve_batch(handles.data(), scene_count, threads, statuses.data()), WRC_OK);
    for (std::size_t i = 0; i < handles.size(); ++i) {
      EXPECT_EQ(statuses[i], WRC_OK);
      EXPECT_EQ(AllResults(handles[i]).difference_to(single_results()[i]), "")
          << "scene " << i << ", threads " << threads;
    }
  }
}

TEST(Batch, ABadSceneDoesNotAffectOthers) {
  constexpr std::size_t unknown = 4;
  constexpr std::size_t off_the_rail = 11;
  for (const std::int32_t threads : {1, 2}) {
    const std::vector<ScenePointer> scenes = make_varied_scenes();
    const std::vector<wrc_scene*> handles = handles_of(scenes);
    set(handles[unknown], {{"track.rail", "no such rail"}});
    set(handles[off_the_rail], {{"pose.lateral", 90.0}});
    std::vector<wrc_status> statuses(handles.size(), -1);
    EXPECT_EQ(wrc_solve_batch(handles.data(), scene_count, threads, statuses.data()),
              WRC_UNKNOWN_NAME);
    for (std::size_t i = 0; i < handles.size(); ++i) {
      if (i == unknown || i == off_the_rail) {
        EXPECT_EQ(statuses[i], i == unknown ? WRC_UNKNOWN_NAME : WRC_NO_CONTACT);
        EXPECT_STRNE(wrc_scene_error(handles[i]), "");
        EXPECT_EQ(wrc_scene_number_count(handles[i]), 0);
      } else {
        EXPECT_EQ(statuses[i], WRC_OK);
        EXPECT_EQ(AllResults(handles[i]).difference_to(single_results()[i]), "") << "scene " << i;
      }
    }
    EXPECT_EQ(wrc_solve_batch(handles.data(), scene_count, threads, nullptr), WRC_UNKNOWN_NAME);
  }
}

TEST(Batch, RefusesInvalidArguments) {
  const ScenePointer one = make_small_scene();
  const ScenePointer other = make_small_scene();
  const std::array<wrc_scene*, 3> twice{one.get(), other.get(), one.get()};
  const std::array<wrc_scene*, 2> null{one.get(), nullptr};
  const std::array<wrc_scene*, 2> good{one.get(), other.get()};
  std::array<wrc_status, 3> statuses{-1, -1, -1};
  EXPECT_EQ(wrc_solve_batch(twice.data(), 3, 2, statuses.data()), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_solve_batch(null.data(), 2, 2, statuses.data()), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_solve_batch(nullptr, 2, 2, statuses.data()), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_solve_batch(good.data(), -1, 2, statuses.data()), WRC_INVALID_ARGUMENT);
  for (const std::int32_t threads : {-1, 0, 1025}) {
    EXPECT_EQ(wrc_solve_batch(good.data(), 2, threads, statuses.data()), WRC_INVALID_ARGUMENT);
  }
  EXPECT_EQ(wrc_scene_number_count(one.get()), 0);
  EXPECT_EQ(std::count(statuses.begin(), statuses.end(), WRC_INVALID_ARGUMENT), 3);
  EXPECT_EQ(wrc_solve_batch(nullptr, 0, 2, nullptr), WRC_OK);
  EXPECT_EQ(wrc_solve_batch(good.data(), 0, 2, statuses.data()), WRC_OK);
  EXPECT_EQ(wrc_scene_number_count(one.get()), 0);
  EXPECT_EQ(wrc_solve_batch(good.data(), 2, 1024, statuses.data()), WRC_OK);
  EXPECT_EQ(statuses[1], WRC_OK);
}

TEST(Threads, WithSeparateSolversEqualASerialRunBitForBit) {
  constexpr int threads = 4;
  constexpr int steps = 12;
  // Warm solutions depend on what came before: the serial run has the same order.
  const auto run = [](int thread, std::vector<AllResults>& results) {
    const SolverPointer solver = make_solver();
    for (int i = 0; i < steps; ++i) {
      const ScenePointer scene = make_varied_scene(thread + 4 * (i / 3));
      set(scene.get(), {{"pose.lateral", 0.1 * i}});
      ASSERT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_OK);
      results.emplace_back(scene.get());
    }
  };
  std::array<std::vector<AllResults>, threads> serial;
  std::array<std::vector<AllResults>, threads> together;
  std::vector<std::thread> started;
  for (int i = 0; i < threads; ++i) {
    const auto place = static_cast<std::size_t>(i);
    run(i, serial[place]);
  }
  for (int i = 0; i < threads; ++i) {
    started.emplace_back(run, i, std::ref(together[static_cast<std::size_t>(i)]));
  }
  for (std::thread& thread : started) {
    thread.join();
  }
  for (std::size_t i = 0; i < threads; ++i) {
    ASSERT_EQ(serial[i].size(), together[i].size());
    for (std::size_t j = 0; j < serial[i].size(); ++j) {
      EXPECT_EQ(together[i][j].difference_to(serial[i][j]), "") << "thread " << i << ", step " << j;
    }
  }
}

/// A lock of the host that notices when two hold it at once.
class HostLock {
public:
  static void lock(void* context) { static_cast<HostLock*>(context)->enter(); }
  static void unlock(void* context) { static_cast<HostLock*>(context)->leave(); }

  void enter() {
    mutex_.lock();
    overlaps_ += inside_.exchange(true) ? 1 : 0;
    ++entered_;
  }
  void leave() {
    overlaps_ += inside_.exchange(false) ? 0 : 1;
    mutex_.unlock();
  }
  [[nodiscard]] int overlaps() const { return overlaps_; }
  [[nodiscard]] int entered() const { return entered_; }

private:
  std::mutex mutex_;
  std::atomic<bool> inside_{false};
  std::atomic<int> overlaps_{0};
  std::atomic<int> entered_{0};
};

class PlanningThreads : public WithFolder {};

TEST_F(PlanningThreads, PlanOnlyUnderTheHostsLock) {
  constexpr int planning_threads = 4;
  constexpr int rounds = 8;
  constexpr int host_sections = 200;
  HostLock lock;
  ASSERT_EQ(wrc_set_planner_lock(HostLock::lock, HostLock::unlock, &lock), WRC_OK);
  std::atomic<int> host_entered{0};
  const auto host_plans = [&] {
    for (int i = 0; i < host_sections; ++i) {
      lock.enter();
      ++host_entered;
      std::this_thread::yield();
      lock.leave();
      std::this_thread::yield();
    }
  };
  const auto library_plans = [this](int thread) {
    for (int round = 0; round < rounds; ++round) {
      // Longer than the lines of other tests in this process.
      plan_length(1000 + 64 * (rounds * thread + round));
      ASSERT_EQ(wrc_save_wisdom(path("wisdom" + std::to_string(thread)).c_str()), WRC_OK);
      const ScenePointer scene = make_small_scene();
      solve(scene.get(), {{"pose.lateral", 0.1 * round}});
    }
  };
  std::vector<std::thread> threads;
  threads.emplace_back(host_plans);
  threads.emplace_back(host_plans);
  for (int i = 0; i < planning_threads; ++i) {
    threads.emplace_back(library_plans, i);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
  EXPECT_EQ(lock.overlaps(), 0);
  EXPECT_EQ(host_entered, 2 * host_sections);
  // For wisdom in each round, and for lengths, many of which are rounded up to the same.
  EXPECT_GT(lock.entered() - host_entered, planning_threads * rounds);
}

/// A recursive lock that tells how often it was asked for.
struct RecursiveLock {
  std::recursive_mutex mutex;
  std::atomic<int> requests{0};
  static void lock(void* context) {
    auto* own = static_cast<RecursiveLock*>(context);
    ++own->requests;
    own->mutex.lock();
  }
  static void unlock(void* context) { static_cast<RecursiveLock*>(context)->mutex.unlock(); }
};

TEST(Threads, MayPlanWhileTheyHoldARecursiveLock) {
  RecursiveLock lock;
  ASSERT_EQ(wrc_set_planner_lock(RecursiveLock::lock, RecursiveLock::unlock, &lock), WRC_OK);
  const auto plan = [](std::int64_t length) { plan_length(length); };
  std::thread other;
  {
    const std::lock_guard<std::recursive_mutex> held(lock.mutex);
    other = std::thread(plan, 5000); // likewise
    while (lock.requests == 0) {
      std::this_thread::yield();
    }
    plan(7000); // the other thread is about to plan and waits; it may hold nothing we need
  }
  other.join();
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
}

/// The planner's lock is taken in the middle of a first solution with measured plans of a size:
/// that call waits there.
struct Gate {
  std::atomic<bool> reached{false};
  std::atomic<bool> open{false};

  static void wait(void* context) {
    auto* gate = static_cast<Gate*>(context);
    gate->reached = true;
    while (!gate->open) {
      std::this_thread::yield();
    }
  }
  static void pass(void* /*context*/) {}
};

SolverPointer make_measuring_solver() {
  SolverPointer solver = make_solver();
  EXPECT_EQ(wrc_solver_set_text(solver.get(), "planner", "measure"), WRC_OK);
  return solver;
}

TEST(Threads, AHandleInUseIsRefusedUntilItsCallEnds) {
  Gate gate;
  const ScenePointer scene = make_small_scene();
  const SolverPointer solver = make_measuring_solver();
  const SolverPointer other = make_solver();
  ASSERT_EQ(wrc_set_planner_lock(Gate::wait, Gate::pass, &gate), WRC_OK);
  wrc_status status = -1;
  std::thread solving([&] { status = wrc_solver_solve(solver.get(), scene.get()); });
  while (!gate.reached) {
    std::this_thread::yield();
  }
  double value = 0.0;
  EXPECT_EQ(wrc_scene_number(scene.get(), "roll", &value), WRC_BUSY);
  expect_error(scene.get(), wrc_scene_set_number(scene.get(), "pose.lateral", 1.0), WRC_BUSY,
               "in use");
  EXPECT_EQ(wrc_scene_number_count(scene.get()), 0);
  wrc_scene* scenes[] = {scene.get()};
  EXPECT_EQ(wrc_solve_batch(scenes, 1, 1, nullptr), WRC_BUSY);
  EXPECT_EQ(wrc_solver_solve(solver.get(), scene.get()), WRC_BUSY);
  EXPECT_EQ(wrc_solver_solve(other.get(), scene.get()), WRC_BUSY);
  gate.open = true;
  solving.join();
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
  EXPECT_EQ(status, WRC_OK);
  EXPECT_EQ(wrc_scene_number(scene.get(), "roll", &value), WRC_OK);
}

TEST(Threads, AHandleMayBeDestroyedDuringACall) {
  Gate gate;
  wrc_scene* scene = nullptr;
  ASSERT_EQ(wrc_scene_create(&scene), WRC_OK);
  set(scene, {{"solve.grid", std::vector{60.0, 50.0}}});
  const SolverPointer solver = make_measuring_solver();
  ASSERT_EQ(wrc_set_planner_lock(Gate::wait, Gate::pass, &gate), WRC_OK);
  wrc_status status = -1;
  std::thread solving([&] { status = wrc_solver_solve(solver.get(), scene); });
  while (!gate.reached) {
    std::this_thread::yield();
  }
  wrc_scene_destroy(scene);
  gate.open = true;
  solving.join();
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
  EXPECT_EQ(status, WRC_OK);
  EXPECT_EQ(wrc_scene_solve(scene), WRC_INVALID_ARGUMENT);
}

TEST(Threads, SolveWhileTheHostUsesFftw) {
  constexpr int threads = 4;
  constexpr int scenes_each = 4;
  std::recursive_mutex mutex;
  const auto lock = [](void* context) { static_cast<std::recursive_mutex*>(context)->lock(); };
  const auto unlock = [](void* context) { static_cast<std::recursive_mutex*>(context)->unlock(); };
  ASSERT_EQ(wrc_set_planner_lock(lock, unlock, &mutex), WRC_OK);
  std::array<double, threads> sums{};
  std::array<std::array<std::string, scenes_each>, threads> differences;
  std::vector<std::thread> started;
  for (std::size_t i = 0; i < threads; ++i) {
    started.emplace_back([&, i] {
      for (std::size_t k = 0; k < scenes_each; ++k) {
        sums[i] += sum_of_transform(mutex, 32 + 16 * i + k);
        const std::size_t index = threads * k + i;
        const ScenePointer scene = make_varied_scene(static_cast<int>(index));
        if (wrc_scene_solve(scene.get()) == WRC_OK) {
          differences[i][k] = AllResults(scene.get()).difference_to(single_results()[index]);
        } else {
          differences[i][k] = wrc_scene_error(scene.get());
        }
      }
    });
  }
  for (std::thread& thread : started) {
    thread.join();
  }
  ASSERT_EQ(wrc_set_planner_lock(nullptr, nullptr, nullptr), WRC_OK);
  for (std::size_t i = 0; i < threads; ++i) {
    EXPECT_EQ(sums[i], scenes_each) << "the host's own transforms";
    for (const std::string& difference : differences[i]) {
      EXPECT_EQ(difference, "");
    }
  }
}

TEST(Threads, WithSeparateRollingContactsGiveTheSameBits) {
  const auto solve = [](int side) {
    wrcontact::RollingContact contact;
    contact.set_grid(side, side, 0.2, 0.2);
    contact.set_pressure(std::vector<double>(
        static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 900.0));
    contact.set("longitudinal_creepage", -0.001);
    contact.set("spin_creepage", 0.0003);
    EXPECT_TRUE(contact.solve());
    return contact.field("traction_y");
  };
  constexpr std::array sides{16, 21, 33, 40};
  std::array<std::vector<double>, sides.size()> alone;
  std::array<std::vector<double>, sides.size()> together;
  std::transform(sides.begin(), sides.end(), alone.begin(), solve);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    threads.emplace_back([&, i] { together[i] = solve(sides[i]); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(together, alone);
}

} // namespace
