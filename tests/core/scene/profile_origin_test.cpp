/// Where a wheel's file has its origin, in scenes; first touch on a flange tip or a chamfer.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "keys/scene_keys.hpp"
#include "profile/writers.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::profile_origin_test {
namespace {

class ProfileOrigin : public ::testing::Test {
protected:
  ProfileOrigin()
      : path_(std::filesystem::path(::testing::TempDir()) /
              ("wrcontact_origin_" + std::to_string(getpid()) + ".wheel")) {}
  ~ProfileOrigin() override { std::filesystem::remove(path_); }

  /// S1002 with its lateral and height moved, in the scene's file for both wheels.
  [[nodiscard]] Scene scene_with(double lateral, double height) const {
    Profile profile = standard_profile("S1002");
    profile.curve = profile.curve.moved(0.0, lateral, height);
    write_profile(profile, path_, 0.25);
    Scene scene;
    scene.left.wheel.name = scene.right.wheel.name = path_.string();
    scene.until = Module::geometry;
    return scene;
  }

private:
  std::filesystem::path path_;
};

bool tells(const std::vector<std::string>& lines, const std::string& part) {
  for (const std::string& line : lines) {
    if (line.find(part) != std::string::npos) {
      return true;
    }
  }
  return false;
}

bool tells(const Warnings& warnings, const std::string& part) {
  return std::ranges::any_of(warnings, [&part](const Warning& warning) {
    return warning.text.find(part) != std::string::npos;
  });
}

/// Of points 0.25 mm apart, mm.
constexpr double spline_error = 1e-3;

TEST_F(ProfileOrigin, AWheelMeasuredFromItsFlangeBackIsShiftedToItsTapingLine) {
  Scene standard;
  standard.until = Module::geometry;
  const SceneResult expected = solve_scene(standard);
  for (const char* origin : {"auto", "flange-back"}) {
    Scene scene = scene_with(70.0, 5.0);
    set_text(scene, "wheelset.wheel", std::string("; origin = ") + origin);
    const SceneResult result = solve_scene(scene);
    EXPECT_NEAR(result.vertical, expected.vertical, spline_error) << origin;
    EXPECT_NEAR(result.left->rigid_contact.s_wheel, expected.left->rigid_contact.s_wheel, 0.05);
    EXPECT_TRUE(tells(result.corrections, "shifted by -70 mm to the taping line"));
    EXPECT_TRUE(result.left->warnings.empty());
  }
  Scene shifted = scene_with(31.0, 5.0);
  set_text(shifted, "wheelset.wheel", "; shift = -31");
  const SceneResult result = solve_scene(shifted);
  EXPECT_NEAR(result.vertical, expected.vertical, spline_error);
  EXPECT_TRUE(tells(result.corrections, "lateral shifted by -31 mm as requested"));
}

TEST_F(ProfileOrigin, TheDistanceIsThatOfTheWheelset) {
  Scene scene = scene_with(70.0, 0.0);
  set_number(scene, "wheelset.tape_offset", 66.0);
  EXPECT_TRUE(tells(solve_scene(scene).corrections, "shifted by -66 mm to the taping line"));
}

TEST_F(ProfileOrigin, AWrongOriginIsReportedByTheProfileAndTheFirstTouch) {
  Scene tip = scene_with(50.0, 0.0);
  set_text(tip, "wheelset.wheel", "; origin = tape");
  const SceneResult on_tip = solve_scene(tip);
  EXPECT_TRUE(tells(all_warnings(on_tip),
                    ".wheel: the flange back is at lateral -20.00 mm, expected -70.00"));
  EXPECT_TRUE(tells(on_tip.left->warnings, "first touch is on the flange tip, at s_wheel"));
  EXPECT_TRUE(tells(on_tip.right->warnings, "first touch is on the flange tip, at s_wheel"));
  Scene chamfer;
  chamfer.until = Module::geometry;
  chamfer.track.gauge = 1600.0; // the rails are 165 mm too far apart
  chamfer.roll = 0.0;
  EXPECT_TRUE(tells(solve_scene(chamfer).left->warnings, "first touch is on the wheel's chamfer"));
}

/// A tilt of one degree, 70 % in pmax: a warning, unless options of the wheel state what to do.
TEST_F(ProfileOrigin, AWheelIsTurnedOrAlignedByItsOptions) {
  Scene scene = scene_with(0.0, 0.0);
  Profile tilted = standard_profile("S1002");
  tilted.curve = tilted.curve.moved(0.017453, 0.0, 0.0);
  write_profile(tilted, scene.left.wheel.name, 0.25);
  scene.until = Module::mechanics;
  scene.side = SideChoice::left;
  scene.accuracy = 0.1;
  const SceneResult plain = solve_scene(scene);
  EXPECT_TRUE(tells(all_warnings(plain), "turned by -1.00 degrees"));
  EXPECT_GT(plain.left->pmax, 1300.0);
  set_text(scene, "wheelset.wheel", "; rotation = -0.017453");
  const SceneResult turned = solve_scene(scene);
  EXPECT_FALSE(tells(all_warnings(turned), "turned by"));
  EXPECT_NEAR(turned.left->pmax, 898.0, 30.0);
  set_text(scene, "wheelset.wheel", "; rotation = auto; align_to = S1002");
  const SceneResult aligned = solve_scene(scene);
  EXPECT_TRUE(tells(aligned.corrections, "aligned to S1002: turned by -1.0"));
  EXPECT_NEAR(aligned.left->pmax, turned.left->pmax, 10.0);
}

} // namespace
} // namespace wrc::test::profile_origin_test
