/// The spread of results by the noise of profiles.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "measured/constants.hpp"
#include "measured/noise_removal.hpp"
#include "measured/noisy_points.hpp"
#include "measured/readers.hpp"
#include "profile/standard_profiles.hpp"
#include "scene/noise_spread.hpp"
#include "scene/noisy_scene.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::noise_spread_test {
namespace {

Profile noisy_wheel(const Noise& noise, double smoothing) {
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  options.smoothing_wavelength = smoothing;
  return profile_through(noisy_points(standard_profile("S1002").curve, noise), "noisy", options)
      .profile;
}

Scene scene_with(const Profile& wheel) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = wheel.name;
  scene.left.wheel.given = scene.right.wheel.given = std::make_shared<const Profile>(wheel);
  scene.accuracy = 1e-2;
  return scene;
}

double number(SceneResult& result, const char* name) {
  return number_value(result, name).value_or(std::nan(""));
}

constexpr double true_pmax = 898.0; ///< of S1002 on 60E1, MPa

TEST(NoiseSpread, HoldsTheTruth) {
  for (const Noise& noise : {Noise{0.005, 0.25, 0.0, 1}, Noise{0.02, 0.25, 0.0, 2},
                             Noise{0.02, 0.1, 0.0, 3}, Noise{0.02, 1.0, 0.0, 4}}) {
    SceneResult result = solve_scene(scene_with(noisy_wheel(noise, automatic_smoothing)));
    const double spread = number(result, "left.spread.pmax");
    EXPECT_NEAR(number(result, "left.pmax"), true_pmax, spread) << noise.spacing;
    EXPECT_LT(spread, 0.7 * true_pmax) << noise.spacing;
    EXPECT_GT(number(result, "left.spread.area"), 0.0) << noise.spacing;
    EXPECT_EQ(number(result, "right.spread.pmax"), spread) << noise.spacing;
  }
}

/// Less noise, less spread; without smoothing pressures are wrong, which the spread says.
TEST(NoiseSpread, FollowsTheNoise) {
  SceneResult rough =
      solve_scene(scene_with(noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing)));
  SceneResult fine =
      solve_scene(scene_with(noisy_wheel({0.002, 0.25, 0.0, 1}, automatic_smoothing)));
  EXPECT_LT(number(fine, "left.spread.pmax"), 0.7 * number(rough, "left.spread.pmax"));
  SceneResult none = solve_scene(scene_with(noisy_wheel({0.02, 0.25, 0.0, 1}, 0.0)));
  EXPECT_GT(number(none, "left.pmax"), 5.0 * true_pmax);
  EXPECT_NEAR(number(none, "left.pmax"), true_pmax, number(none, "left.spread.pmax"));
}

/// Noise that an instrument has filtered looks like waves of the steel.
TEST(NoiseSpread, HoldsTheTruthOfFilteredNoise) {
  for (const double cutoff : {0.8, 2.5})
    for (const double deviation : {0.01, 0.02}) {
      Noise noise{deviation, 0.25, 0.0, 3};
      noise.cutoff = cutoff;
      SceneResult result = solve_scene(scene_with(noisy_wheel(noise, automatic_smoothing)));
      EXPECT_NEAR(number(result, "left.pmax"), true_pmax, number(result, "left.spread.pmax"))
          << cutoff << ' ' << deviation;
    }
}

/// Where nothing tells noise from waves, what smoothing would change is uncertain.
TEST(NoiseSpread, HoldsTheTruthOfWavesThatMayBeNoise) {
  for (const double width : {0.5, 1.0}) {
    Noise noise{0.015, 0.25, 0.0, 2};
    noise.width = width;
    SceneResult result = solve_scene(scene_with(noisy_wheel(noise, automatic_smoothing)));
    EXPECT_NEAR(number(result, "left.pmax"), true_pmax, number(result, "left.spread.pmax"))
        << width;
  }
}

/// Points with four decimals are not smoothed, but what their digits leave open is said.
TEST(NoiseSpread, HoldsTheTruthOfFourDecimals) {
  Scene scene;
  scene.lateral = -0.5;
  scene.accuracy = 1e-2;
  SceneResult truth = solve_scene(scene);
  Noise digits{0.0, 0.25};
  digits.digit = 1e-4;
  scene = scene_with(noisy_wheel(digits, automatic_smoothing));
  scene.lateral = -0.5;
  SceneResult result = solve_scene(scene);
  const double pmax = number(truth, "left.pmax");
  EXPECT_NEAR(number(result, "left.pmax"), pmax, number(result, "left.spread.pmax"));
  EXPECT_LT(number(result, "left.spread.pmax"), 0.15 * pmax);
}

/// A wavelength that is too short leaves a spread that holds the truth.
TEST(NoiseSpread, CountsASmoothingThatIsTooShort) {
  SceneResult result = solve_scene(scene_with(noisy_wheel({0.02, 0.25, 0.0, 1}, 3.0)));
  EXPECT_GT(number(result, "left.pmax"), 1.3 * true_pmax);
  EXPECT_NEAR(number(result, "left.pmax"), true_pmax, number(result, "left.spread.pmax"));
}

TEST(NoiseSpread, IsNothingOfExactProfiles) {
  SceneResult result = solve_scene(Scene());
  const std::vector<std::string> names = number_names(result);
  for (const char* name :
       {"left.spread.pmax", "right.spread.area", "spread.rolling_radius_difference"}) {
    EXPECT_EQ(number(result, name), 0.0) << name;
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(NoiseSpread, RollingRadiiHaveOne) {
  Scene scene = scene_with(noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing));
  scene.lateral = 3.0;
  SceneResult result = solve_scene(scene);
  const double spread = number(result, "spread.rolling_radius_difference");
  Scene exact;
  exact.lateral = 3.0;
  SceneResult truth = solve_scene(exact);
  EXPECT_GT(spread, 0.0);
  EXPECT_LT(spread, 0.5);
  EXPECT_NEAR(number(result, "rolling_radius_difference"),
              number(truth, "rolling_radius_difference"), spread);
}

/// At y = 0 the same wheel on both sides leaves nothing uncertain; two wheels that were measured
/// apart do, by the root of two times what one leaves.
TEST(NoiseSpread, WheelsOfDifferentFilesVaryIndependently) {
  const Profile first = noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing);
  const Profile second = noisy_wheel({0.02, 0.25, 0.0, 2}, automatic_smoothing);
  Scene scene = scene_with(first);
  SceneResult same = solve_scene(scene);
  EXPECT_LT(number(same, "spread.rolling_radius_difference"), 1e-9);
  scene.right.wheel.given = std::make_shared<const Profile>(second);
  SceneResult apart = solve_scene(scene);
  EXPECT_GT(number(apart, "spread.rolling_radius_difference"), 0.05);
}

Deferred<ProfileDoubt> known(const ProfileDoubt& doubt) {
  return Deferred<ProfileDoubt>([doubt] { return doubt; });
}

TEST(NoiseSpread, OfTooFewLinesThereIsNone) {
  Profile wheel = noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing);
  for (const std::size_t count : {6U, 7U}) {
    wheel.doubt =
        known(ProfileDoubt{wheel.curve, std::vector<Curve>(count, wheel.curve), {}, false});
    SceneResult result = solve_scene(scene_with(wheel));
    EXPECT_EQ(std::isnan(number(result, "left.spread.pmax")), count < 7U);
  }
}

/// Points that are too far apart to tell noise leave open how far off results are.
TEST(NoiseSpread, OfPointsFarApartIsNotKnown) {
  for (const double wavelength : {automatic_smoothing, 0.0}) {
    const Profile wheel = noisy_wheel({0.02, 3.0, 0.0, 1}, wavelength);
    SceneResult result = solve_scene(scene_with(wheel));
    for (const char* name : {"left.spread.pmax", "left.spread.grade", "left.smoothed_0mm.pmax"})
      EXPECT_TRUE(std::isnan(number(result, name))) << wavelength << ' ' << name;
  }
}

/// Grid, tolerance and solver of the scene are for its own solution: 15 more on a grid of 1024 x
/// 1024 would take a gigabyte.
TEST(NoiseSpread, IgnoresTheGridOfTheScene) {
  Scene scene = scene_with(noisy_wheel({0.005, 0.25, 0.0, 1}, automatic_smoothing));
  SceneResult plain = solve_scene(scene);
  scene.grid = {{48, 32}};
  scene.tolerance = 1e-2;
  scene.solver = SolverChoice::paper;
  SceneResult prescribed = solve_scene(scene);
  EXPECT_NE(number(plain, "left.pmax"), number(prescribed, "left.pmax"));
  for (const char* name : {"left.spread.pmax", "left.spread.area", "left.smoothed_5mm.pmax"})
    EXPECT_EQ(number(plain, name), number(prescribed, name)) << name;
}

/// What smoothing does to the results, whatever the profile itself was smoothed with.
TEST(NoiseSpread, ResultsDependOnTheWavelength) {
  const Noise noise{0.02, 0.25, 0.0, 1};
  SceneResult result = solve_scene(scene_with(noisy_wheel(noise, automatic_smoothing)));
  double before = HUGE_VAL;
  for (const double wavelength : smoothed_waves) {
    const std::string name = "left.smoothed_" + std::to_string(static_cast<int>(wavelength));
    SceneResult direct = solve_scene(scene_with(noisy_wheel(noise, wavelength)));
    const double pmax = number(result, (name + "mm.pmax").c_str());
    EXPECT_EQ(pmax, number(direct, "left.pmax")) << name;
    EXPECT_EQ(number(result, (name + "mm.area").c_str()), number(direct, "left.area")) << name;
    EXPECT_LT(pmax, before) << name;
    before = pmax;
  }
  EXPECT_GT(number(result, "left.smoothed_0mm.pmax"), 5.0 * true_pmax);
  const std::vector<std::string> names = number_names(result);
  EXPECT_EQ(std::ranges::count(names, "right.smoothed_15mm.area"), 1);
}

TEST(NoiseSpread, ExactProfilesAreNotSmoothed) {
  SceneResult result = solve_scene(Scene());
  EXPECT_FALSE(number_value(result, "left.smoothed_3mm.pmax"));
  EXPECT_TRUE(std::ranges::none_of(number_names(result), [](const std::string& name) {
    return name.find("smoothed_") != std::string::npos;
  }));
}

/// Up to 10 % is fine, beyond 20 % a result is not to be used.
TEST(NoiseSpread, HasAGrade) {
  SceneResult exact = solve_scene(Scene());
  EXPECT_EQ(number(exact, "left.spread.grade"), 0.0);
  for (const auto& [deviation, grade] : {std::pair(0.0002, 0.0), {0.02, 1.0}, {0.05, 2.0}}) {
    SceneResult result =
        solve_scene(scene_with(noisy_wheel({deviation, 0.1, 0.0, 1}, automatic_smoothing)));
    const double share = number(result, "left.spread.pmax") / number(result, "left.pmax");
    EXPECT_EQ(number(result, "left.spread.grade"), grade) << share;
    EXPECT_EQ(share < 0.1, grade == 0.0) << share;
    EXPECT_EQ(share > 0.2, grade == 2.0) << share;
  }
}

/// Ten likely curves that are all the profile itself leave nothing uncertain.
TEST(NoiseSpread, IsNothingIfAllLikelyCurvesAreTheSame) {
  Profile wheel = noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing);
  wheel.doubt =
      known(ProfileDoubt{wheel.curve, std::vector<Curve>(likely_lines, wheel.curve), {}, false});
  SceneResult result = solve_scene(scene_with(wheel));
  EXPECT_EQ(number(result, "left.spread.pmax"), 0.0);
}

/// A load of all forces needs the creep forces of each likely curve; else they are left out.
TEST(NoiseSpread, WorksWithCreepForces) {
  Scene scene = scene_with(noisy_wheel({0.005, 0.25, 0.0, 1}, automatic_smoothing));
  scene.left.creepages = scene.right.creepages = Creepages{1e-3, 0.0, 0.0};
  SceneResult with = solve_scene(scene);
  scene.left.creepages = scene.right.creepages = std::nullopt;
  SceneResult without = solve_scene(scene);
  const double spread = number(without, "left.spread.pmax");
  EXPECT_NEAR(number(with, "left.spread.pmax"), spread, 0.1 * spread); // grids differ
}

} // namespace
} // namespace wrc::test::noise_spread_test
