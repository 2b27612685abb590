/// The C++ interface over the C one: what it returns, throws and moves.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "wrcontact.hpp"

namespace cpp_interface_test {
namespace {

/// The status of the error that a call throws; WRC_OK if it throws none.
template <class Call> wrc_status status_of(Call&& call) {
  try {
    call();
  } catch (const wrcontact::Error& error) {
    EXPECT_STRNE(error.what(), "");
    return error.status();
  }
  return WRC_OK;
}

TEST(CppInterface, ProfilesAreReadWrittenAndReadAgain) {
  wrcontact::Profile rail;
  rail.load_standard("60E1");
  EXPECT_EQ(rail.kind(), WRC_RAIL);
  EXPECT_EQ(rail.text("name"), "60E1");
  EXPECT_GT(rail.length(), 70.0);
  EXPECT_EQ(rail.nodes().back(), rail.length());
  const std::string path =
      testing::TempDir() + "cpp_interface_60E1_" + std::to_string(getpid()) + ".txt";
  rail.write(path, 0.5);
  wrcontact::Profile again;
  again.load_file(path);
  std::filesystem::remove(path);
  const wrcontact::Profile::Point top = rail.at(0.5 * rail.length());
  const wrcontact::Profile::Point read = again.at(0.5 * again.length());
  EXPECT_NEAR(read.height, top.height, 0.02);
  EXPECT_NEAR(std::hypot(read.lateral - top.lateral, read.height - top.height), 0.0, 0.5);
  EXPECT_EQ(again.points(WRC_POINTS_DROPPED).lateral.size(), 0U);
  EXPECT_GT(again.points(WRC_POINTS_READ).height.size(), 100U);
}

TEST(CppInterface, PointsMakeAProfileThatAScenePoses) {
  std::vector<double> lateral;
  std::vector<double> height;
  for (int i = -60; i <= 60; ++i) {
    lateral.push_back(0.5 * i);
    height.push_back(-0.25 * i * i / 600.0);
  }
  wrcontact::Profile crown;
  EXPECT_EQ(status_of([&] { crown.set_points("crown", WRC_RAIL, lateral, {}); }),
            WRC_INVALID_ARGUMENT);
  crown.set_points("crown", WRC_RAIL, lateral, height);
  EXPECT_EQ(crown.points(WRC_POINTS_READ).lateral, lateral);
  EXPECT_NEAR(std::abs(crown.at(0.5 * crown.length()).curvature), 1.0 / 300.0, 1e-5);
  EXPECT_TRUE(crown.corrections().empty());
  EXPECT_TRUE(crown.warnings().empty());
  wrcontact::Scene scene;
  scene.set("track.rail", crown);
  EXPECT_EQ(scene.get_text("track.rail"), "crown");
}

TEST(CppInterface, OwnersMoveTheirHandles) {
  wrcontact::Scene one;
  one.set("pose.lateral", 3);
  wrc_scene* const handle = one.handle();
  wrcontact::Scene other(std::move(one));
  EXPECT_EQ(other.handle(), handle);
  wrcontact::Scene third;
  third = std::move(other);
  EXPECT_EQ(third.handle(), handle);
  EXPECT_EQ(third.get_number("pose.lateral"), 3.0);
}

TEST(CppInterface, KeysAndNamesAreThoseOfTheLibrary) {
  const auto keys = wrcontact::scene_keys();
  ASSERT_EQ(static_cast<std::int64_t>(keys.size()), wrc_scene_key_count());
  EXPECT_NE(std::string(keys.front().meaning), "");
  EXPECT_GT(wrcontact::standard_profile_names(WRC_WHEEL).size(), 3U);
  std::vector<std::string> names;
  const wrcontact::Scene scene;
  for (std::int64_t i = 0; const char* name = wrc_result_name(i); ++i) {
    EXPECT_NO_THROW((void)scene.number_id(name)) << name;
    names.emplace_back(name);
  }
  for (const char* name : {"roll", "left.patches.0.kalker.c11", "right.jacobian.force.y.by.yaw"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  EXPECT_EQ(wrc_result_name(-1), nullptr);
}

TEST(CppInterface, RefusalsAreThrown) {
  wrcontact::Scene scene;
  EXPECT_EQ(status_of([&] { scene.set("pose.lateral", 1e9); }), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_of([&] { scene.set("pose.latral", 1.0); }), WRC_UNKNOWN_NAME);
  EXPECT_EQ(status_of([&] { scene.set("track.rail", std::string("60E1\0x", 6)); }),
            WRC_INVALID_ARGUMENT);
  EXPECT_EQ(status_of([&] { (void)scene.number("left.pmax"); }), WRC_NO_RESULT);
  EXPECT_EQ(scene.number_or("left.pmax", -1.0), -1.0);
  const std::vector<std::int32_t> ids{scene.key_id("pose.lateral")};
  EXPECT_EQ(status_of([&] { scene.set_numbers_by_id(ids, std::vector<double>{}); }),
            WRC_INVALID_ARGUMENT);
}

} // namespace
} // namespace cpp_interface_test
