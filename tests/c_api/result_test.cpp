/// Results through the C interface: names, fields, and every way in which solving can fail.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "all_results.hpp"
#include "owned_handles.hpp"

namespace result_test {
namespace {

/// Sums over a few hundred elements.
constexpr double rounding = 1e-10;

TEST(Results, AreAbsentBeforeSolving) {
  const ScenePointer scene = make_scene();
  double value = 7.0;
  const char* text = "kept";
  std::int64_t count = 5;
  EXPECT_EQ(wrc_scene_number(scene.get(), "roll", &value), WRC_NO_RESULT);
  EXPECT_EQ(wrc_scene_text(scene.get(), "model", &text), WRC_NO_RESULT);
  EXPECT_EQ(wrc_scene_field(scene.get(), "left.x", nullptr, 0, &count), WRC_NO_RESULT);
  EXPECT_STRNE(wrc_scene_error(scene.get()), "");
  EXPECT_EQ(value, 7.0);
  EXPECT_STREQ(text, "kept");
  EXPECT_EQ(count, 5);
  EXPECT_EQ(wrc_scene_number_count(scene.get()), 0);
  EXPECT_EQ(wrc_scene_number_name(scene.get(), 0), nullptr);
  EXPECT_EQ(wrc_scene_text_count(scene.get()), 0);
  EXPECT_EQ(wrc_scene_text_name(scene.get(), 0), nullptr);
}

TEST(Results, EveryNameHasAValueAndOccursOnce) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s);
  std::set<std::string> names;
  for (std::int64_t i = 0; i < wrc_scene_number_count(s); ++i) {
    const char* name = wrc_scene_number_name(s, i);
    ASSERT_NE(name, nullptr);
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(std::isfinite(number_of(s, name))) << name;
  }
  for (std::int64_t i = 0; i < wrc_scene_text_count(s); ++i) {
    const char* name = wrc_scene_text_name(s, i);
    const char* value = nullptr;
    ASSERT_NE(name, nullptr);
    EXPECT_TRUE(names.insert(name).second) << name;
    ASSERT_EQ(wrc_scene_text(s, name, &value), WRC_OK);
    EXPECT_NE(value, nullptr);
  }
  EXPECT_EQ(wrc_scene_number_name(s, -1), nullptr);
  EXPECT_EQ(wrc_scene_number_name(s, wrc_scene_number_count(s)), nullptr);
  EXPECT_EQ(wrc_scene_text_name(s, -1), nullptr);
  EXPECT_EQ(wrc_scene_text_name(s, wrc_scene_text_count(s)), nullptr);
  for (const char* name :
       {"roll", "vertical", "model", "units", "left.stop_reason", "right.stop_reason",
        "left.rigid_contact.s_wheel", "left.patches.0.semi_axes.longitudinal", "time_ms.total"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

/// The approximate models have no sensitivities and no Jacobian.
TEST(Results, EveryNameOfAModelWithDerivativesHasAValue) {
  for (const char* model : {"hertz", "kik-piotrowski", "half-space"}) {
    const ScenePointer scene = make_small_scene();
    wrc_scene* s = scene.get();
    set(s, {{"solve.model", model}, {"solve.derivatives", "yes"}, {"motion.speed", 2e4}});
    solve(s);
    for (std::int64_t i = 0; i < wrc_scene_number_count(s); ++i) {
      double value = NAN;
      EXPECT_EQ(wrc_scene_number(s, wrc_scene_number_name(s, i), &value), WRC_OK)
          << model << ": " << wrc_scene_error(s);
    }
  }
}

TEST(Results, UnknownNamesAreRefused) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"solve.side", "left"}});
  double value = 7.0;
  const char* text = "kept";
  std::int64_t count = 5;
  expect_error(s, wrc_scene_number(s, "left.pmaximum", &value), WRC_UNKNOWN_NAME, "left.pmaximum");
  EXPECT_EQ(wrc_scene_number(s, "right.pmax", &value), WRC_UNKNOWN_NAME);
  EXPECT_EQ(wrc_scene_text(s, "left.pmax", &text), WRC_UNKNOWN_NAME);
  for (const char* name : {"left.force", "right.pressure", "middle.x", "pressure", "", "left."}) {
    EXPECT_EQ(wrc_scene_field(s, name, nullptr, 0, &count), WRC_UNKNOWN_NAME) << name;
  }
  EXPECT_EQ(value, 7.0);
  EXPECT_STREQ(text, "kept");
  EXPECT_EQ(count, 5);
}

TEST(Results, FieldsAgreeWithGridAndForces) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"pose.lateral", 3.0}});
  for (const std::string side : {"left", "right"}) {
    const auto number = [&](const char* name) { return number_of(s, (side + name).c_str()); };
    ASSERT_EQ(number(".grid.lateral"), 24.0);
    ASSERT_EQ(number(".grid.longitudinal"), 20.0);
    for (const char* name :
         {".x", ".y", ".z", ".undeformed_distance", ".pressure", ".displacement"}) {
      EXPECT_EQ(field_of(s, side + name).size(), 24U * 20U) << side << name;
    }
    // The longitudinal index is fastest: x steps from value to value, y stays within a row.
    const auto x = field_of(s, side + ".x");
    const auto y = field_of(s, side + ".y");
    EXPECT_NEAR(x[1] - x[0], number(".element_size.longitudinal"), rounding);
    EXPECT_NEAR(y[19], y[0], rounding);
    const auto pressure = field_of(s, side + ".pressure");
    const double force = std::accumulate(pressure.begin(), pressure.end(), 0.0) *
                         number(".element_size.lateral") * number(".element_size.longitudinal");
    // Up to the spread of the rail's normals under the pressures.
    EXPECT_NEAR(force, number(".normal_force"), 1e-4 * force);
    for (const char* body : {".rail", ".wheel"}) {
      EXPECT_GT(field_of(s, side + body + "_y").size(), 10U);
      EXPECT_EQ(field_of(s, side + body + "_y").size(), field_of(s, side + body + "_z").size());
    }
  }
}

TEST(Results, LoadAlongTheNormalIsThatOfTheMainPatch) {
  // Along its own force its share of the load is 1, whatever rounding makes of it.
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  set(s, {{"load.both", 50000.0}, {"load.of", "normal"}});
  for (int i = -60; i <= 60; ++i) {
    solve(s, {{"pose.lateral", 0.1 * i}});
    // Forces of other patches count with their share along that normal.
    const double force = number_of(s, "left.normal_force");
    const double first = number_of(s, "left.patches.0.normal_force");
    if (force == first) {
      EXPECT_NEAR(force, 50000.0, rounding * 50000.0) << 0.1 * i;
    } else {
      EXPECT_GT(force, 50000.0) << 0.1 * i;
    }
  }
}

TEST(Results, AnArrayThatIsTooSmallIsNotWrittenAndTheLengthReturned) {
  const ScenePointer scene = make_small_scene();
  solve(scene.get());
  std::vector<double> values(24 * 20, -1.0);
  std::int64_t count = 0;
  const auto length = static_cast<std::int64_t>(values.size());
  EXPECT_EQ(wrc_scene_field(scene.get(), "left.pressure", values.data(), length - 1, &count),
            WRC_TOO_SMALL);
  EXPECT_EQ(count, length);
  EXPECT_EQ(values, std::vector<double>(values.size(), -1.0));
  EXPECT_TRUE(contains(wrc_scene_error(scene.get()), "capacity = 479"));
  EXPECT_EQ(wrc_scene_field(scene.get(), "left.pressure", values.data(), length, &count), WRC_OK);
  EXPECT_NE(values, std::vector<double>(values.size(), -1.0));
}

/// A failure to solve must leave the results of the last success.
void expect_failure_keeps_results(wrc_scene* scene, wrc_status expected) {
  const double before = number_of(scene, "left.pmax");
  const std::int64_t count = wrc_scene_number_count(scene);
  EXPECT_EQ(wrc_scene_solve(scene), expected);
  EXPECT_STRNE(wrc_scene_error(scene), "");
  EXPECT_EQ(number_of(scene, "left.pmax"), before);
  EXPECT_EQ(wrc_scene_number_count(scene), count);
  EXPECT_EQ(field_of(scene, "left.pressure").size(), 480U);
}

class Solving : public WithFolder {};

TEST_F(Solving, NoContactWhenTheWheelIsOffTheRail) {
  const ScenePointer scene = make_small_scene();
  solve(scene.get());
  set(scene.get(), {{"pose.lateral", 100.0}});
  expect_failure_keeps_results(scene.get(), WRC_NO_CONTACT);
}

TEST_F(Solving, AnUnknownProfileIsReportedWithTheBuiltInOnes) {
  const ScenePointer scene = make_small_scene();
  solve(scene.get());
  set(scene.get(), {{"track.rail", "60E7"}});
  expect_error(scene.get(), wrc_scene_solve(scene.get()), WRC_UNKNOWN_NAME, "track.rail = \"60E7\"",
               "60E1");
  expect_failure_keeps_results(scene.get(), WRC_UNKNOWN_NAME);
  set(scene.get(), {{"track.rail", "S1002"}});
  expect_error(scene.get(), wrc_scene_solve(scene.get()), WRC_UNKNOWN_NAME,
               "track.rail = \"S1002\"", "S1002 is a built-in wheel");
}

TEST_F(Solving, AMalformedProfileFileIsReportedWithItsLine) {
  const ScenePointer scene = make_small_scene();
  solve(scene.get());
  const std::string file = write("bad.txt", "0 0\n1 x\n");
  set(scene.get(), {{"wheelset.wheel", file.c_str()}});
  expect_failure_keeps_results(scene.get(), WRC_FILE_MALFORMED);
  expect_error(scene.get(), wrc_scene_solve(scene.get()), WRC_FILE_MALFORMED, "bad.txt:2");
}

TEST_F(Solving, SmoothingOfABuiltInProfileIsRefused) {
  const ScenePointer scene = make_small_scene();
  solve(scene.get());
  set(scene.get(), {{"track.rail", "60E1; smoothing = 3"}});
  expect_failure_keeps_results(scene.get(), WRC_INVALID_ARGUMENT);
}

TEST_F(Solving, NotConvergedComesWithUsableResults) {
  // Rounding of the displacements on this grid is above the least tolerance that may be asked.
  constexpr double usable = 1e-9;
  const ScenePointer converged = make_scene();
  const ScenePointer scene = make_scene();
  const double grid[] = {256.0, 128.0};
  for (wrc_scene* s : {converged.get(), scene.get()}) {
    ASSERT_EQ(wrc_scene_set_numbers(s, "solve.grid", grid, 2), WRC_OK);
    set(s, {{"solve.method", "paper"}});
  }
  set(converged.get(), {{"solve.tolerance", 1e-10}});
  set(scene.get(), {{"solve.tolerance", 1e-13}});
  solve(converged.get());
  expect_error(scene.get(), wrc_scene_solve(scene.get()), WRC_NOT_CONVERGED, "stop_reason");
  const char* reason = nullptr;
  EXPECT_EQ(wrc_scene_text(scene.get(), "left.stop_reason", &reason), WRC_OK);
  EXPECT_STREQ(reason, "stagnation");
  EXPECT_EQ(wrc_scene_text(converged.get(), "left.stop_reason", &reason), WRC_OK);
  EXPECT_STREQ(reason, "tolerance_met");
  const double pmax = number_of(converged.get(), "left.pmax");
  EXPECT_NEAR(number_of(scene.get(), "left.pmax"), pmax, usable * pmax);
}

TEST_F(Solving, NoLoadAndNoTouchAreResults) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"load.both", 0.0}});
  const char* warning = nullptr;
  EXPECT_EQ(wrc_scene_text(s, "left.warnings.0", &warning), WRC_UNKNOWN_NAME);
  EXPECT_EQ(number_of(s, "left.pmax"), 0.0);
  std::int64_t count = -1;
  EXPECT_EQ(wrc_scene_field(s, "left.pressure", nullptr, 0, &count), WRC_OK);
  EXPECT_EQ(count, 0);
  solve(s, {{"pose.vertical", 500.0}});
  EXPECT_EQ(number_of(s, "right.normal_force"), 0.0);
}

// Kalker's coefficients come with their word alone, change no other result, and are the same on the
// other wheel of the mirror image.
TEST_F(Solving, KalkersCoefficientsComeOnRequest) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"pose.lateral", 3.0}});
  const double pmax = number_of(s, "left.pmax");
  double value = 0.0;
  EXPECT_EQ(wrc_scene_number(s, "left.patches.0.kalker.c11", &value), WRC_UNKNOWN_NAME);
  ASSERT_EQ(wrc_scene_set_text(s, "solve.results", "kalker"), WRC_OK);
  solve(s, {{"pose.lateral", 3.0}});
  EXPECT_EQ(number_of(s, "left.pmax"), pmax);
  const ScenePointer mirrored = make_small_scene();
  ASSERT_EQ(wrc_scene_set_text(mirrored.get(), "solve.results", "stress, kalker"), WRC_OK);
  solve(mirrored.get(), {{"pose.lateral", -3.0}});
  for (const std::string name : {"c11", "c22", "c23", "c33"}) {
    const double here = number_of(s, ("left.patches.0.kalker." + name).c_str());
    EXPECT_GT(here, 0.3) << name;
    EXPECT_NEAR(number_of(mirrored.get(), ("right.patches.0.kalker." + name).c_str()), here,
                1e-6 * here);
  }
}

} // namespace
} // namespace result_test
