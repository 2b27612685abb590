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

TEST(OutOfMemory, NoHandleIsMade) {
  wrc_scene* scene = nullptr;
  EXPECT_EQ(with_allocations(0, [&] { return wrc_scene_create(&scene); }), WRC_OUT_OF_MEMORY);
  EXPECT_EQ(scene, nullptr);
  wrc_normal* normal = nullptr;
  EXPECT_EQ(with_allocations(0, [&] { return wrc_normal_create(&normal); }), WRC_OUT_OF_MEMORY);
  EXPECT_EQ(normal, nullptr);
  // The object of a rolling contact has parts of its own.
  wrc_rolling* rolling = nullptr;
  long count = 0;
  while (with_allocations(count, [&] { return wrc_rolling_create(&rolling); }) != WRC_OK) {
    EXPECT_EQ(rolling, nullptr);
    ++count;
  }
  EXPECT_GT(count, 2);
  wrc_rolling_destroy(rolling);
  wrc_profile* profile = nullptr;
  EXPECT_EQ(with_allocations(0, [&] { return wrc_profile_create(&profile); }), WRC_OUT_OF_MEMORY);
  EXPECT_EQ(profile, nullptr);
}

TEST(OutOfMemory, ATextIsNotSet) {
  const ScenePointer scene = make_small_scene();
  const std::string long_name(200, 'x');
  EXPECT_EQ(
      with_allocations(
          0, [&] { return wrc_scene_set_text(scene.get(), "track.rail", long_name.c_str()); }),
      WRC_OUT_OF_MEMORY);
  EXPECT_EQ(wrc_scene_solve(scene.get()), WRC_OK) << "the rail has changed";
}

TEST(OutOfMemory, AProfileKeepsWhatItHeld) {
  const ProfilePointer profile = make_profile();
  ASSERT_EQ(wrc_profile_load_standard(profile.get(), "S1002"), WRC_OK);
  wrc_status status = WRC_OUT_OF_MEMORY;
  long count = 0;
  for (; status == WRC_OUT_OF_MEMORY; ++count) {
    status =
        with_allocations(count, [&] { return wrc_profile_load_standard(profile.get(), "60E1"); });
    std::int32_t kind = WRC_RAIL;
    ASSERT_EQ(wrc_profile_kind(profile.get(), &kind), WRC_OK);
    EXPECT_EQ(kind, status == WRC_OK ? WRC_RAIL : WRC_WHEEL);
  }
  EXPECT_EQ(status, WRC_OK);
  EXPECT_GT(count, 1) << "no allocation has failed";
}

TEST(OutOfMemory, ASceneKeepsItsResultsWhicheverAllocationFails) {
  const ScenePointer scene = make_small_scene();
  ASSERT_EQ(wrc_scene_set_text(scene.get(), "solve.side", "left"), WRC_OK);
  ASSERT_EQ(wrc_scene_solve(scene.get()), WRC_OK);
  const double before = number_of(scene.get(), "left.pmax");
  ASSERT_EQ(wrc_scene_set_number(scene.get(), "load.vertical", 90000.0), WRC_OK);
  wrc_status status = WRC_OUT_OF_MEMORY;
  long failures = 0;
  for (long count = 0; status != WRC_OK; ++count) {
    status = with_allocations(count, [&] { return wrc_scene_solve(scene.get()); });
    if (status != WRC_OK) {
      ASSERT_EQ(status, WRC_OUT_OF_MEMORY) << wrc_scene_error(scene.get());
      ASSERT_EQ(number_of(scene.get(), "left.pmax"), before) << count;
      ++failures;
    }
  }
  EXPECT_GT(failures, 100);
  EXPECT_NE(number_of(scene.get(), "left.pmax"), before);
  std::printf("%ld allocations of a solution failed, one after the other\n", failures);
}

TEST(OutOfMemory, NumbersByIdTakeNoneAndStayIfOneCannotBeComputed) {
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
  wrc_status status = WRC_OUT_OF_MEMORY;
  long failures = 0;
  for (long count = 0; status != WRC_OK; ++count) {
    values[0] = -1.0;
    status = with_allocations(count, [&] { return wrc_scene_numbers_by_id(s, ids, values, 4); });
    if (status != WRC_OK) {
      ASSERT_EQ(status, WRC_OUT_OF_MEMORY) << wrc_scene_error(s);
      ASSERT_EQ(values[0], -1.0) << count;
      ++failures;
    }
  }
  EXPECT_GT(failures, 2);
  EXPECT_EQ(values[0], pmax);
  EXPECT_GT(values[3], 0.0);
}

TEST(OutOfMemory, ASolverThatFailsAnywhereStartsAnew) {
  wrc_solver* failing = nullptr;
  ASSERT_EQ(wrc_solver_create(&failing), WRC_OK);
  const ScenePointer scene = make_small_scene();
  ASSERT_EQ(wrc_scene_set_text(scene.get(), "solve.side", "left"), WRC_OK);
  ASSERT_EQ(wrc_solver_solve(failing, scene.get()), WRC_OK);
  ASSERT_EQ(wrc_scene_set_number(scene.get(), "pose.lateral", 1.0), WRC_OK);
  wrc_status status = WRC_OUT_OF_MEMORY;
  for (long count = 0; status != WRC_OK; ++count) {
    status = with_allocations(count, [&] { return wrc_solver_solve(failing, scene.get()); });
    ASSERT_TRUE(status == WRC_OK || status == WRC_OUT_OF_MEMORY) << status;
  }
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
  wrc_status status = WRC_OUT_OF_MEMORY;
  long failures = 0;
  for (long count = 0; status != WRC_OK; ++count) {
    status = with_allocations(count, [&] { return wrc_normal_solve(normal.get()); });
    if (status != WRC_OK) {
      ASSERT_EQ(status, WRC_OUT_OF_MEMORY) << wrc_normal_error(normal.get());
      ASSERT_EQ(pmax_of(normal.get()), before) << count;
      ++failures;
    }
  }
  EXPECT_GT(failures, 10);
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
  const double before = contact.number("longitudinal_force");
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
    EXPECT_EQ(with_allocations(count, [&] { return wrc_rolling_advance(rolling); }),
              WRC_OUT_OF_MEMORY);
  }
  contact.set("longitudinal_creepage", -0.002);
  wrc_status status = WRC_OUT_OF_MEMORY;
  long failures = 0;
  for (long count = 0; status != WRC_OK; ++count) {
    status = with_allocations(count, [&] { return wrc_rolling_solve(rolling); });
    if (status != WRC_OK) {
      ASSERT_EQ(status, WRC_OUT_OF_MEMORY) << wrc_rolling_error(rolling);
      ASSERT_EQ(contact.number("longitudinal_force"), before) << count;
      ++failures;
    }
  }
  EXPECT_GT(failures, 10);
  EXPECT_EQ(contact.number("longitudinal_force"), untouched.number("longitudinal_force"))
      << "failures have left traces";
}

} // namespace
