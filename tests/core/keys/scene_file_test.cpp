#include "keys/scene_file.hpp"

#include <fstream>
#include <sstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "keys/scene_keys.hpp"
#include "measured/readers.hpp"

namespace wrc::test::scene_file_test {
namespace {

namespace fs = std::filesystem;

class SceneFile : public testing::Test {
protected:
  SceneFile() { fs::create_directories(folder_); }
  ~SceneFile() override { fs::remove_all(folder_); }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;

  [[nodiscard]] std::string written(const Scene& scene) const {
    write_scene(scene, folder_ / "scene.toml");
    std::ostringstream text;
    text << std::ifstream(folder_ / "scene.toml").rdbuf();
    return text.str();
  }

  /// Of the process: tests run side by side.
  fs::path folder_ =
      fs::path(testing::TempDir()) / ("wrcontact_scene_file_test_" + std::to_string(getpid()));
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(SceneFile, TablesInTheOrderOfTheKeysAndNumbersThatReadBack) {
  Scene scene;
  set_number(scene, "pose.lateral", 0.1 + 0.2);
  set_text(scene, "solve.model", "hertz");
  const std::array<double, 2> grid{32.0, 64.0};
  set_numbers(scene, "solve.grid", grid);
  const std::string text = written(scene);
  EXPECT_TRUE(contains(text, "\n[pose]\nlateral = 0.30000000000000004\n")) << text;
  EXPECT_TRUE(contains(text, "model = \"hertz\"\n"));
  EXPECT_TRUE(contains(text, "grid = [32.0, 64.0]\n"));
  EXPECT_TRUE(contains(text, "wheel = \"S1002\"\n"));
  EXPECT_LT(text.find("[track]"), text.find("[load]"));
}

TEST_F(SceneFile, NumbersInMillimetresWhateverTheConvention) {
  Scene scene;
  set_text(scene, "convention.units", "SI");
  set_text(scene, "convention.frame", "right-down");
  set_number(scene, "pose.lateral", 0.002);
  const std::string text = written(scene);
  EXPECT_TRUE(contains(text, "units = \"mm\"\n"));
  EXPECT_TRUE(contains(text, "lateral = -2.0\n")) << text;
}

TEST_F(SceneFile, LeavesOutRedundantKeys) {
  Scene scene;
  EXPECT_TRUE(contains(written(scene), "\n[load]\nboth = 80000.0\n"));
  set_number(scene, "load.left", 70000.0);
  EXPECT_TRUE(contains(written(scene), "\n[load]\nleft = 70000.0\n"));
}

TEST_F(SceneFile, ProfilesFromTheProgramAreSavedBesideIt) {
  const std::vector<Position> points{{-60.0, 10.0}, {-50.0, 28.0}, {-30.0, 8.0},
                                     {0.0, 0.0},    {30.0, -1.0},  {60.0, -2.0}};
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  const Profile profile = profile_through(points, "worn \"A\"", options).profile;
  Scene scene;
  set_profile(scene, "wheelset.wheel", profile);
  EXPECT_TRUE(contains(written(scene), "wheel = \"scene.wheel.txt; smoothing = 0; rotation = 0; "
                                       "origin = tape\"\n"));
  const ReadResult read = read_profile(folder_ / "scene.wheel.txt", options);
  EXPECT_EQ(read.profile.points, profile.points);
}

/// Its tilt was settled when it was read.
TEST_F(SceneFile, AGivenWheelKeepsItsTilt) {
  std::vector<Position> points;
  const Curve curve = standard_profile("S1002").curve.moved(0.02, 0.0, 0.0);
  for (double z = -20.0; z < 9.0; z += 0.5)
    points.push_back({-70.0 - 0.02 * z, z - 1.4});
  for (double arc = 0.5; arc < curve.length(); arc += 0.5)
    points.push_back({curve.at(arc).lateral, curve.at(arc).height});
  for (double z = -7.0; z > -32.0; z -= 0.5)
    points.push_back({65.2 - 0.02 * z, z + 1.3});
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  EXPECT_NE(profile_through(points, "turned", options).measured, points);
  options.rotation = 0.0;
  options.smoothing_wavelength = 0.0;
  Scene scene;
  scene.left.wheel.given =
      std::make_shared<const Profile>(profile_through(points, "tilted", options).profile);
  const std::string text = written(scene);
  EXPECT_TRUE(contains(text, "; smoothing = 0; rotation = 0; origin = tape\"\n")) << text;
}

/// Whatever places profiles from files in the scene.
TEST_F(SceneFile, AGivenWheelStaysWhereItIs) {
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  const std::vector<Position> points{{-60.0, 10.0}, {-50.0, 28.0}, {-30.0, 8.0},
                                     {0.0, 0.0},    {30.0, -1.0},  {60.0, -2.0}};
  Scene scene;
  set_profile(scene, "wheelset.wheel", profile_through(points, "worn", options).profile);
  scene.left.wheel.options.placement.lateral_shift = 2.0;
  const std::string text = written(scene);
  EXPECT_TRUE(contains(text, "; smoothing = 0; rotation = 0; origin = tape\"\n")) << text;
}

TEST_F(SceneFile, KeepsWavesOfTheRadius) {
  Scene scene;
  scene.left.wheel.harmonics = scene.right.wheel.harmonics = {{3, 0.1, 0.5}};
  EXPECT_TRUE(contains(written(scene), "harmonics = [3.0, 0.1, 0.5]\n")) << written(scene);
}

TEST_F(SceneFile, UnwritablePathIsAnError) {
  EXPECT_THROW(write_scene(Scene{}, folder_ / "none" / "scene.toml"), Error);
}

} // namespace
} // namespace wrc::test::scene_file_test
