// Surfaces are kept while they are used, and never for another profile or track.
#include "scene/surface_cache.hpp"

#include <string>

#include <gtest/gtest.h>

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

/// The one used last stays, the one not used for longest goes.
TEST(RecentSurfaces, KeepsRecentlyUsedSurfaces) {
  RecentSurfaces<WheelSurface, WheelsetDimensions> recent;
  int made = 0;
  const auto get = [&](double radius) {
    SurfaceSource<WheelsetDimensions> source;
    source.profile.name = "S1002";
    source.dimensions.radius = radius;
    recent.get(source, [&] {
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
