/// The spread of results by the noise of profiles.
#include <cmath>
#include <memory>
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

/// Less noise, less spread; without smoothing pressures are wrong, and nothing is drawn.
TEST(NoiseSpread, FollowsTheNoise) {
  SceneResult rough =
      solve_scene(scene_with(noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing)));
  SceneResult fine =
      solve_scene(scene_with(noisy_wheel({0.002, 0.25, 0.0, 1}, automatic_smoothing)));
  EXPECT_LT(number(fine, "left.spread.pmax"), 0.7 * number(rough, "left.spread.pmax"));
  SceneResult none = solve_scene(scene_with(noisy_wheel({0.02, 0.25, 0.0, 1}, 0.0)));
  EXPECT_GT(number(none, "left.pmax"), 5.0 * true_pmax);
  EXPECT_TRUE(std::isnan(number(none, "left.spread.pmax")));
}

/// A wavelength that is too short leaves a spread that holds the truth.
TEST(NoiseSpread, CountsASmoothingThatIsTooShort) {
  SceneResult result = solve_scene(scene_with(noisy_wheel({0.02, 0.25, 0.0, 1}, 3.0)));
  EXPECT_GT(number(result, "left.pmax"), 1.3 * true_pmax);
  EXPECT_NEAR(number(result, "left.pmax"), true_pmax, number(result, "left.spread.pmax"));
}

TEST(NoiseSpread, ExactProfilesHaveNone) {
  SceneResult result = solve_scene(Scene());
  EXPECT_EQ(spread_of(result), nullptr);
  EXPECT_TRUE(std::isnan(number(result, "left.spread.pmax")));
  for (const std::string& name : number_names(result))
    EXPECT_EQ(name.find("spread"), std::string::npos);
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

TEST(NoiseSpread, OfTooFewLinesThereIsNone) {
  Profile wheel = noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing);
  for (const std::size_t count : {6U, 7U}) {
    wheel.likely = std::make_shared<const std::vector<Curve>>(count, wheel.curve);
    SceneResult result = solve_scene(scene_with(wheel));
    EXPECT_EQ(std::isnan(number(result, "left.spread.pmax")), count < 7U);
  }
}

/// Ten likely curves that are all the profile itself leave nothing uncertain.
TEST(NoiseSpread, IsNothingIfAllLikelyCurvesAreTheSame) {
  Profile wheel = noisy_wheel({0.02, 0.25, 0.0, 1}, automatic_smoothing);
  wheel.likely = std::make_shared<const std::vector<Curve>>(likely_lines, wheel.curve);
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
