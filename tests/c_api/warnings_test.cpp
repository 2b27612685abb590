/// All warnings of a scene by one function, whoever has solved it.
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "wrcontact.hpp"

namespace warnings_test {
namespace {

/// S1002 with a hole of 13 mm under the contact.
wrcontact::Profile holed() {
  wrcontact::Profile whole;
  whole.load_standard("S1002");
  std::vector<double> lateral;
  std::vector<double> height;
  for (double arc = 0.0; arc < whole.length(); arc += 0.5) {
    const auto at = whole.at(arc);
    if (at.lateral < -5.0 || at.lateral > 8.0) {
      lateral.push_back(at.lateral);
      height.push_back(at.height);
    }
  }
  wrcontact::Profile profile;
  profile.set_points("holed", WRC_WHEEL, lateral, height);
  return profile;
}

wrcontact::Scene warned_scene() {
  wrcontact::Scene scene;
  scene.set("wheelset.wheel", holed());
  scene.set("solve.accuracy", 0.1);
  scene.set("pose.lateral", 6.5);
  return scene;
}

/// Of the profile, and of a pressure.
void expect_both(const wrcontact::Scene& scene) {
  const std::vector<std::string> warnings = scene.warnings();
  ASSERT_GE(warnings.size(), 2U);
  EXPECT_TRUE(warnings[0].starts_with("wheel profile holed: gap of 13.")) << warnings[0];
  EXPECT_TRUE(warnings[1].starts_with("left: the largest pressure, 6")) << warnings[1];
  EXPECT_EQ(scene.number("warning_count"), static_cast<double>(warnings.size()));
  EXPECT_EQ(scene.number("left.warning_count"), 1.0);
  EXPECT_EQ(scene.text("warnings.0"), warnings[0]);
  EXPECT_EQ(scene.text("warning_classes.0"), "profile_gap");
  EXPECT_EQ("left: " + scene.text("left.warnings.0"), warnings[1]);
  EXPECT_EQ(scene.count_of("corrections"), 0);
}

TEST(Warnings, IncludeThoseOfProfilesGivenByTheProgram) {
  wrcontact::Scene scene = warned_scene();
  EXPECT_TRUE(scene.warnings().empty()) << "not solved yet";
  EXPECT_TRUE(scene.solve());
  expect_both(scene);
  EXPECT_EQ(wrc_scene_warning(scene.handle(), -1), nullptr);
  EXPECT_EQ(wrc_scene_warning(nullptr, 0), nullptr);
  EXPECT_THROW(scene.set("pose.lateral", std::nan("")), wrcontact::Error);
  expect_both(scene);
  scene.set("wheelset.wheel", "S1002");
  scene.set("pose.lateral", 0.0);
  EXPECT_TRUE(scene.solve());
  EXPECT_TRUE(scene.warnings().empty()) << scene.warnings()[0];
}

/// The texts of one class.
std::vector<std::string> of_class(const std::string& name, const wrcontact::Scene& scene) {
  std::vector<std::string> found;
  const std::vector<std::string> all = scene.warnings();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (scene.text("warning_classes." + std::to_string(i)) == name) {
      found.push_back(all[i]);
    }
  }
  return found;
}

std::vector<std::string> implausible(double longitudinal, double lateral, double spin) {
  wrcontact::Scene scene;
  scene.set("solve.accuracy", 0.1);
  scene.set("creepage.left", {longitudinal, lateral, spin});
  scene.solve();
  return of_class("implausible_input", scene);
}

/// One per mille typed as 1, spin in 1/m.
TEST(Warnings, OfCreepagesThatNoWheelHasThatRolls) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(implausible(-1.0, 0.0, 0.0),
            Texts{"left: longitudinal creepage -1: a wheel that rolls has at most 0.2; 0.001 is "
                  "one per mille"});
  EXPECT_EQ(implausible(0.0, 0.21, 0.1).size(), 2U);
  EXPECT_EQ(implausible(0.2, -0.2, 0.0065), Texts{});
}

/// A pitch rate in another unit than the speed; not of a wheelset that starts.
TEST(Warnings, OfMotionsByWhichWheelsSlide) {
  wrcontact::Scene scene;
  scene.set("solve.accuracy", 0.1);
  for (const auto& [speed, pitch, count] :
       {std::tuple(2e4, 2e4 / 460.0, 0U), {2e4, 1.5 * 2e4 / 460.0, 2U}, {500.0, 0.0, 0U}}) {
    scene.set("motion.speed", speed);
    scene.set("motion.pitch", pitch);
    scene.solve();
    EXPECT_EQ(of_class("implausible_input", scene).size(), count) << speed << ", " << pitch;
  }
}

TEST(Warnings, OfALinearLawBeyondFriction) {
  wrcontact::Scene scene;
  scene.set("solve.accuracy", 0.1);
  scene.set("solve.side", "left");
  scene.set("solve.creep", "linear");
  for (const auto& [creepage, count] : {std::pair(1e-4, 0U), {1e-2, 1U}}) {
    scene.set("creepage.longitudinal", creepage);
    scene.solve();
    EXPECT_EQ(of_class("model_validity", scene).size(), count) << creepage;
  }
}

TEST(Warnings, AreReturnedByEveryCallThatSolves) {
  wrcontact::Solver solver;
  wrcontact::Scene scene = warned_scene();
  for (int repeated = 0; repeated < 2; ++repeated) {
    EXPECT_TRUE(solver.solve(scene));
    expect_both(scene);
  }
  wrcontact::Scene other = warned_scene();
  wrc_scene* handles[] = {scene.handle(), other.handle()};
  EXPECT_EQ(wrc_solve_batch(handles, 2, 2, nullptr), WRC_OK);
  expect_both(scene);
  expect_both(other);
  const double position[] = {
      0.0, 6.5, scene.number("vertical") - scene.number("left.depth"), scene.number("roll"),
      0.0, 0.0};
  const double velocity[] = {2e4, 0.0, 0.0, 0.0, 2e4 / 460.0, 0.0};
  double force[12];
  EXPECT_EQ(wrc_solver_step(solver.handle(), other.handle(), position, velocity, nullptr, force,
                            nullptr, nullptr, nullptr),
            WRC_OK);
  expect_both(other);
  const std::vector<std::int32_t> ids{other.number_id("warning_count"),
                                      other.number_id("left.warning_count")};
  std::vector<double> values(2);
  other.numbers_by_id(ids, values);
  EXPECT_EQ(values[0], static_cast<double>(other.warnings().size()));
  EXPECT_EQ(values[1], 1.0);
}

/// Two edges that meet: pressures grow with every element, forces do not.
TEST(Warnings, SayWhyALargestPressureIsNotGiven) {
  wrcontact::Scene scene;
  scene.set("wheelset.wheel", "LMA");
  scene.set("track.rail", "56E1");
  for (const auto& [key, value] : {std::pair("track.gauge", 1429.2967018813915),
                                   {"track.gauge_height", 14.230625790084702},
                                   {"wheelset.back_to_back", 1349.6},
                                   {"wheelset.radius", 3384.74},
                                   {"load.left", 8528.0},
                                   {"load.right", 8528.0},
                                   {"pose.lateral", 0.88923749059052071},
                                   {"pose.yaw", 0.051238238117801788},
                                   {"solve.accuracy", 0.0185}}) {
    scene.set(key, value);
  }
  scene.solve();
  EXPECT_GT(scene.number("right.discretisation_error"), 0.5);
  EXPECT_TRUE(std::isnan(scene.number("right.pmax")));
  EXPECT_TRUE(std::isnan(scene.number("right.patches.0.pmax_element")));
  EXPECT_EQ(scene.number("right.grade"), WRC_DO_NOT_USE);
  std::string all;
  for (const std::string& text : scene.warnings()) {
    all += text;
  }
  EXPECT_NE(all.find("so pmax and what follows from it are not given"), std::string::npos) << all;
  EXPECT_NEAR(scene.number("right.normal_force"), 8687.0, 10.0);
  EXPECT_TRUE(std::isfinite(scene.number("left.pmax")));
  scene.set("solve.grid", std::vector<double>{40.0, 60.0}); // the caller's elements
  scene.solve();
  EXPECT_TRUE(std::isfinite(scene.number("right.pmax")));
}

/// Of several patches it is the largest one that is not given.
TEST(Warnings, SayWhyALargestPressureOfSeveralPatchesIsNotGiven) {
  wrcontact::Scene scene;
  scene.set("wheelset.wheel", "LM");
  scene.set("track.rail", "60E1");
  scene.set("load.of", "normal");
  scene.set("solve.curved", "yes");
  for (const auto& [key, value] : {std::pair("wheelset.radius", 3244.2003860423983),
                                   {"load.both", 101040.38916235813},
                                   {"pose.lateral", -0.3526833287677868},
                                   {"pose.roll", 0.0022847309585290482},
                                   {"pose.yaw", 0.07118519370089799},
                                   {"solve.accuracy", 0.09}}) {
    scene.set(key, value);
  }
  scene.solve();
  EXPECT_GT(scene.number("right.discretisation_error"), 0.5);
  EXPECT_TRUE(std::isnan(scene.number("right.pmax")));
  int given = 0;
  int count = 0;
  for (; scene.has_number("right.patches." + std::to_string(count) + ".pmax"); ++count) {
    given +=
        std::isfinite(scene.number("right.patches." + std::to_string(count) + ".pmax")) ? 1 : 0;
  }
  EXPECT_GE(count, 2);
  EXPECT_EQ(given, count - 1);
}

/// On a chamfer's edge of 0.66 rad pressures grow with every element, though the estimate is 0.3.
TEST(Warnings, SayWhyALargestPressureOnAKinkIsNotGiven) {
  wrcontact::Scene scene;
  scene.set("wheelset.wheel", "LM");
  scene.set("track.rail", "54E3");
  scene.set("solve.side", "right");
  for (const auto& [key, value] : {std::pair("wheelset.radius", 4194.423631053407),
                                   {"load.left", 258921.76},
                                   {"load.right", 258921.76},
                                   {"track.inclination", 0.0},
                                   {"pose.lateral", 2.0258510051756531},
                                   {"pose.yaw", 0.031358373577849263},
                                   {"solve.accuracy", 1e-2}}) {
    scene.set(key, value);
  }
  for (const char* of : {"pressures", "forces"}) {
    scene.set("solve.accuracy_of", of);
    scene.solve();
    EXPECT_LT(scene.number("right.discretisation_error"), 0.5) << of;
    EXPECT_TRUE(std::isnan(scene.number("right.pmax"))) << of;
    std::string all;
    for (const std::string& text : scene.warnings()) {
      all += text;
    }
    EXPECT_NE(all.find("so pmax and what follows from it are not given"), std::string::npos) << all;
  }
}

} // namespace
} // namespace warnings_test
