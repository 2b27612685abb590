/// Every allocation of a call fails once: the status is WRC_OUT_OF_MEMORY, nothing escapes, and the
/// handle is as it was. Memory is refused by this program's own operator new.
#include <cstdio>
#include <vector>

#include "failing_allocator.hpp"
#include "owned_handles.hpp"
#include "wrcontact.hpp"

namespace {

/// The status of a call when its n-th allocation fails.
template <class Call> wrc_status with_allocations(long count, Call&& call) {
  allocations_left = count;
  const wrc_status status = call();
  allocations_left = -1;
  return status;
}

/// Each allocation of a call fails once, until it succeeds; `check` is called after each failure.
/// Returns how many have failed.
template <class Call, class Check> long fail_each(Call call, Check check) {
  long count = 0;
  wrc_status status = with_allocations(count, call);
  for (; status == WRC_OUT_OF_MEMORY; status = with_allocations(++count, call)) {
    check();
  }
  EXPECT_EQ(status, WRC_OK) << "allocation " << count;
  return count;
}

TEST(OutOfMemory, NoHandleIsMade) {
  wrc_scene* scene = nullptr;
  EXPECT_EQ(with_allocations(0, [&] { return wrc_scene_create(&scene); }), WRC_OUT_OF_MEMORY);
  EXPECT_EQ(scene, nullptr);
  wrc_normal* normal = nullptr;
  EXPECT_EQ(with_allocations(0, [&] { return wrc_normal_create(&normal); }), WRC_OUT_OF_MEMORY);
  EXPECT_EQ(normal, nullptr);
  // The object of a rolling contact has parts of its own.
  wrc_rolling* rolling = nullptr;
  EXPECT_GT(
      fail_each([&] { return wrc_rolling_create(&rolling); }, [&] { EXPECT_EQ(rolling, nullptr); }),
      2);
  wrc_rolling_destroy(rolling);
  wrc_profile* profile = nullptr;
  EXPECT_EQ(with_allocations(0, [&] { return wrc_profile_create(&profile); }), WRC_OUT_OF_MEMORY);
  EXPECT_EQ(profile, nullptr);
}

TEST(OutOfMemory, ATextStaysUnchanged) {
  const ScenePointer scene = make_small_scene();
  const std::string long_name(200, 'x');
  EXPECT_EQ(
      with_allocations(
          0, [&] { return wrc_scene_set_text(scene.get(), "track.rail", long_name.c_str()); }),
      WRC_OUT_OF_MEMORY);
  EXPECT_EQ(wrc_scene_solve(scene.get()), WRC_OK) << "the rail has changed";
}

TEST(OutOfMemory, AProfileKeepsItsData) {
  const ProfilePointer profile = make_profile();
  ASSERT_EQ(wrc_profile_load_standard(profile.get(), "S1002"), WRC_OK);
  const auto kind = [&] {
    std::int32_t value = -1;
    EXPECT_EQ(wrc_profile_kind(profile.get(), &value), WRC_OK);
    return value;
  };
  EXPECT_GT(fail_each([&] { return wrc_profile_load_standard(profile.get(), "60E1"); },
                      [&] { EXPECT_EQ(kind(), WRC_WHEEL); }),
            0)
      << "no allocation has failed";
  EXPECT_EQ(kind(), WRC_RAIL);
}

TEST(OutOfMemory, ASceneKeepsItsResultsWhicheverAllocationFails) {
  const ScenePointer scene = make_small_scene();
  ASSERT_EQ(wrc_scene_set_text(scene.get(), "solve.side", "left"), WRC_OK);
  ASSERT_EQ(wrc_scene_solve(scene.get()), WRC_OK);
  const double before = number_of(scene.get(), "left.pmax");
  ASSERT_EQ(wrc_scene_set_number(scene.get(), "load.both", 90000.0), WRC_OK);
  const long failures = fail_each([&] { return wrc_scene_solve(scene.get()); },
                                  [&] { EXPECT_EQ(number_of(scene.get(), "left.pmax"), before); });
  EXPECT_GT(failures, 100);
  EXPECT_NE(number_of(scene.get(), "left.pmax"), before);
  std::printf("%ld allocations of a solution failed, one after the other\n", failures);
}

TEST(OutOfMemory, NumbersByIdNeedNoMemoryAndAFailureKeepsTheArray) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  ASSERT_EQ(wrc_scene_solve(s), WRC_OK);
  std::int32_t lateral = 0;
  std::int32_t ids[4] = {};
  const char* const names[] = {"left.pmax", "roll", "left.residuals.least_gap", "left.area"};
  ASSERT_EQ(wrc_scene_key_id(s, "pose.lateral", &lateral), WRC_OK);
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(wrc_scene_number_id(s, names[i], &ids[i]), WRC_OK);
  }
  double values[4] = {};
  ASSERT_EQ(wrc_scene_numbers_by_id(s, ids, values, 2), WRC_OK);
  const double pmax = values[0];
  const double two = 2.0;
  EXPECT_EQ(with_allocations(0, [&] { return wrc_scene_set_numbers_by_id(s, &lateral, &two, 1); }),
            WRC_OK);
  EXPECT_EQ(with_allocations(0, [&] { return wrc_scene_numbers_by_id(s, ids, values, 2); }),
            WRC_OK);
  values[0] = -1.0;
  EXPECT_GT(fail_each([&] { return wrc_scene_numbers_by_id(s, ids, values, 4); },
                      [&] { EXPECT_EQ(values[0], -1.0); }),
            2);
  EXPECT_EQ(values[0], pmax);
  EXPECT_GT(values[3], 0.0);
}

TEST(OutOfMemory, ASolverIsUsableAfterAnyFailure) {
  wrc_solver* failing = nullptr;
  ASSERT_EQ(wrc_solver_create(&failing), WRC_OK);
  const ScenePointer scene = make_small_scene();
  ASSERT_EQ(wrc_scene_set_text(scene.get(), "solve.side", "left"), WRC_OK);
  ASSERT_EQ(wrc_solver_solve(failing, scene.get()), WRC_OK);
  ASSERT_EQ(wrc_scene_set_number(scene.get(), "pose.lateral", 1.0), WRC_OK);
  fail_each([&] { return wrc_solver_solve(failing, scene.get()); }, [] {});
  const ScenePointer alone = make_small_scene();
  ASSERT_EQ(wrc_scene_set_text(alone.get(), "solve.side", "left"), WRC_OK);
  ASSERT_EQ(wrc_scene_set_number(alone.get(), "pose.lateral", 1.0), WRC_OK);
  ASSERT_EQ(wrc_scene_solve(alone.get()), WRC_OK);
  EXPECT_EQ(number_of(scene.get(), "left.pmax"), number_of(alone.get(), "left.pmax"));
  wrc_solver_destroy(failing);
}

TEST(OutOfMemory, ANormalContactKeepsItsResults) {
  constexpr int side = 40;
  std::vector<double> gap;
  for (int i = 0; i < side * side; ++i) {
    const int x = i % side - side / 2;
    const int y = i / side - side / 2;
    gap.push_back(1e-4 * (x * x + y * y));
  }
  const auto prepare = [&](wrc_normal* normal, double load) {
    ASSERT_EQ(wrc_normal_set_grid(normal, side, side, 0.1, 0.1), WRC_OK);
    ASSERT_EQ(wrc_normal_set_distance(normal, gap.data(), side * side), WRC_OK);
    ASSERT_EQ(wrc_normal_set_number(normal, "normal_load", load), WRC_OK);
  };
  const auto pmax_of = [](wrc_normal* normal) {
    double value = -1.0;
    EXPECT_EQ(wrc_normal_number(normal, "pmax", &value), WRC_OK);
    return value;
  };
  const NormalPointer untouched = make_normal();
  prepare(untouched.get(), 900.0);
  ASSERT_EQ(wrc_normal_solve(untouched.get()), WRC_OK);

  const NormalPointer normal = make_normal();
  prepare(normal.get(), 500.0);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
  const double before = pmax_of(normal.get());
  ASSERT_EQ(wrc_normal_set_text(normal.get(), "precision", "double"), WRC_OK);
  ASSERT_EQ(wrc_normal_set_text(normal.get(), "precision", "mixed"), WRC_OK); // a new solver
  EXPECT_EQ(with_allocations(
                0, [&] { return wrc_normal_set_distance(normal.get(), gap.data() + 1, side); }),
            WRC_OUT_OF_MEMORY);
  ASSERT_EQ(wrc_normal_set_number(normal.get(), "normal_load", 900.0), WRC_OK);
  EXPECT_GT(fail_each([&] { return wrc_normal_solve(normal.get()); },
                      [&] { EXPECT_EQ(pmax_of(normal.get()), before); }),
            10);
  EXPECT_EQ(pmax_of(normal.get()), pmax_of(untouched.get())) << "failures have left traces";
}

TEST(OutOfMemory, ARollingContactKeepsItsResults) {
  constexpr int side = 40;
  const std::vector<double> pressure(side * side, 1000.0);
  const auto prepare = [&](wrcontact::RollingContact& contact, double creepage) {
    contact.set_grid(side, side, 0.1, 0.1);
    contact.set_pressure(pressure);
    contact.set("contact", "transient");
    contact.set("longitudinal_creepage", creepage);
  };
  wrcontact::RollingContact untouched;
  prepare(untouched, -0.002);
  ASSERT_TRUE(untouched.solve());

  wrcontact::RollingContact contact;
  prepare(contact, -0.001);
  contact.set("poisson", 0.3); // nothing that is kept serves below
  ASSERT_TRUE(contact.solve());
  contact.set("poisson", 0.28);
  wrc_rolling* rolling = contact.handle();
  const double before = contact.number("creep_force.longitudinal");
  EXPECT_EQ(with_allocations(
                0, [&] { return wrc_rolling_set_pressure(rolling, pressure.data() + 1, side); }),
            WRC_OUT_OF_MEMORY);
  for (const long count : {0L, 1L}) {
    EXPECT_EQ(with_allocations(count,
                               [&] {
                                 return wrc_rolling_set_previous(rolling, pressure.data(),
                                                                 pressure.data(), side * side);
                               }),
              WRC_OUT_OF_MEMORY);
    EXPECT_EQ(with_allocations(count,
                               [&] {
                                 return wrc_rolling_set_slip(rolling, pressure.data(),
                                                             pressure.data(), side * side);
                               }),
              WRC_OUT_OF_MEMORY);
    EXPECT_EQ(with_allocations(count, [&] { return wrc_rolling_advance(rolling); }),
              WRC_OUT_OF_MEMORY);
  }
  contact.set("longitudinal_creepage", -0.002);
  EXPECT_GT(fail_each([&] { return wrc_rolling_solve(rolling); },
                      [&] { EXPECT_EQ(contact.number("creep_force.longitudinal"), before); }),
            10);
  EXPECT_EQ(contact.number("creep_force.longitudinal"),
            untouched.number("creep_force.longitudinal"))
      << "failures have left traces";
}

} // namespace
