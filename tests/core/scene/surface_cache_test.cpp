// Surfaces are kept while they are used, and never for another profile or track.
#include "scene/surface_cache.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "profile/profile.hpp"
#include "support/errors.hpp"

namespace wrc::test::surface_cache_test {
namespace {

TEST(SurfaceCache, EqualScenesShareSurfaces) {
  SurfaceCache cache;
  Scene scene;
  const SceneSurfaces one = cache.get(scene);
  scene.lateral = 5.0;
  scene.left.load = 1e5;
  const SceneSurfaces other = cache.get(scene);
  EXPECT_EQ(one.left.wheel, other.left.wheel);
  EXPECT_EQ(one.left.rail, other.left.rail);
  EXPECT_EQ(one.left.wheel, one.right.wheel) << "both wheels alike";
  scene.left.radius = 459.0;
  const SceneSurfaces third = cache.get(scene);
  EXPECT_NE(third.left.wheel, one.left.wheel);
  EXPECT_EQ(third.left.wheel->radius(), 459.0);
  EXPECT_EQ(third.right.wheel, one.right.wheel);
}

TEST(SurfaceCache, RailsAreDisplacedFromTheirNominalPosition) {
  SurfaceCache cache;
  Scene scene;
  const double before = cache.get(scene).left.rail->origin_y();
  scene.left.displacement.lateral = 2.0;
  EXPECT_NEAR(cache.get(scene).left.rail->origin_y(), before + 2.0, 1e-12);
  EXPECT_NEAR(cache.get(scene).left.rail->origin_y(), before + 2.0, 1e-12) << "not once more";
  scene.left.displacement = {};
  EXPECT_EQ(cache.get(scene).left.rail->origin_y(), before);
}

TEST(SurfaceCache, UnknownNamesAreRefusedWithTheirKey) {
  SurfaceCache cache;
  Scene scene;
  scene.left.wheel.name = "no-such-profile";
  expect_error(
      ErrorCode::unknown_name, [&] { cache.get(scene); }, "wheel", "no-such-profile", "S1002");
}

/// With its height above that of S1002.
void write_wheel(const std::filesystem::path& path, double above) {
  std::ofstream file(path);
  file.precision(10);
  const Curve curve = standard_profile("S1002").curve;
  for (double arc = 0.0; arc < curve.length(); arc += 0.5) {
    const CurvePoint at = curve.at(arc);
    file << at.lateral << ' ' << at.height + above << '\n';
  }
}

class Folder {
public:
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::filesystem::path path = std::filesystem::temp_directory_path() /
                               ("wrcontact_surface_cache_" + std::to_string(getpid()));
};

/// A study of nine measured wheels reads each once.
TEST(SurfaceCache, ReadsEachOfManyFilesOnce) {
  const Folder folder;
  SurfaceCache cache;
  Scene scene;
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 9; ++i) {
      const std::string name = folder.path / (std::to_string(i) + ".wheel");
      if (round == 0) {
        write_wheel(name, 0.01 * i);
      }
      scene.left.wheel.name = scene.right.wheel.name = name;
      EXPECT_EQ(cache.get(scene).profile_milliseconds > 0.0, round == 0) << i;
    }
  }
}

TEST(SurfaceCache, OfOneSceneReadsAFileAgainWhenItHasChanged) {
  const Folder folder;
  SurfaceCache cache(SurfaceCache::For::one_scene);
  Scene scene;
  const std::string name = folder.path / "a.wheel";
  scene.left.wheel.name = scene.right.wheel.name = name;
  write_wheel(name, 0.0);
  EXPECT_GT(cache.get(scene).profile_milliseconds, 0.0);
  const SceneSurfaces kept = cache.get(scene);
  EXPECT_EQ(kept.profile_milliseconds, 0.0);
  write_wheel(name, 0.25);
  std::filesystem::last_write_time(name, std::filesystem::file_time_type::clock::now() +
                                             std::chrono::seconds(1)); // of coarse clocks
  const SceneSurfaces changed = cache.get(scene);
  EXPECT_GT(changed.profile_milliseconds, 0.0);
  EXPECT_NE(changed.left.wheel, kept.left.wheel);
}

/// As copies that keep their time, and links that point elsewhere from now on.
TEST(SurfaceCache, OfOneSceneReadsAnotherFileOfTheSameNameSizeAndTime) {
  const Folder folder;
  SurfaceCache cache(SurfaceCache::For::one_scene);
  Scene scene;
  const std::filesystem::path name = folder.path / "a.wheel";
  const std::filesystem::path other = folder.path / "b.wheel";
  scene.left.wheel.name = scene.right.wheel.name = name.string();
  write_wheel(name, 0.25);
  std::filesystem::copy_file(name, other);
  std::fstream(other) << "-6"; // -60 instead of -70 mm
  std::filesystem::last_write_time(other, std::filesystem::last_write_time(name));
  (void)cache.get(scene);
  std::filesystem::rename(other, name);
  EXPECT_GT(cache.get(scene).profile_milliseconds, 0.0);
}

/// The one used last stays, the one not used for longest goes.
TEST(RecentSurfaces, KeepsRecentlyUsedSurfaces) {
  RecentSurfaces<WheelSurface, WheelsetDimensions> recent(8);
  int made = 0;
  const auto get = [&](double radius) {
    SurfaceSource<WheelsetDimensions> source;
    source.profile.name = "S1002";
    source.dimensions.radius = radius;
    recent.get(source, {}, [&] {
      ++made;
      return RecentSurfaces<WheelSurface, WheelsetDimensions>::Entry{source, {}, {}, {}, {}};
    });
  };
  for (int i = 0; i < 8; ++i) {
    get(400.0 + i);
  }
  EXPECT_EQ(made, 8);
  get(400.0); // still there, and used again
  EXPECT_EQ(made, 8);
  get(500.0); // 401 goes
  EXPECT_EQ(made, 9);
  get(400.0);
  EXPECT_EQ(made, 9);
  get(401.0);
  EXPECT_EQ(made, 10);
}

} // namespace
} // namespace wrc::test::surface_cache_test
