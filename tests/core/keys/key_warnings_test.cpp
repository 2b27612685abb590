/// Keys that were set and have no effect beside others are warned of, in whatever order.
#include "keys/key_warnings.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "keys/scene_file.hpp"
#include "keys/scene_keys.hpp"
#include "scene/solve_scene.hpp"
#include "scene/vehicle_step.hpp"

namespace wrc::test::key_warnings_test {
namespace {

using Value = std::variant<double, std::string, std::vector<double>>;
using Settings = std::vector<std::pair<std::string, Value>>;

void set(Scene& scene, const std::string& key, const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    set_number(scene, key, *number);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    set_text(scene, key, *text);
  } else {
    set_numbers(scene, key, std::get<std::vector<double>>(value));
  }
}

Scene scene_with(const Settings& settings) {
  Scene scene;
  for (const auto& [key, value] : settings) {
    set(scene, key, value);
  }
  return scene;
}

std::vector<std::string> told(const Scene& scene, WarningClass kind = WarningClass::unused_key) {
  Warnings all;
  const KeyWarnings unused(scene);
  unused.append_to(all);
  EXPECT_EQ(unused.count(), all.size());
  std::vector<std::string> texts;
  for (const Warning& warning : all) {
    EXPECT_EQ(warning.kind, kind);
    texts.push_back(warning.text);
  }
  return texts;
}

using Texts = std::vector<std::string>;
const std::vector<double> creepages{0.001, 0.0, 0.0};

TEST(KeyWarnings, APrescribedHeightNeedsNoLoad) {
  EXPECT_EQ(told(scene_with({{"pose.vertical", 459.8}, {"load.both", 7e4}, {"load.of", "total"}})),
            (Texts{"load.both is not used: pose.vertical is set",
                   "load.of is not used: pose.vertical is set"}));
  EXPECT_EQ(told(scene_with({{"load.both", 7e4}, {"load.left", 6e4}, {"pose.vertical", 459.8}})),
            (Texts{"load.both is not used: pose.vertical is set",
                   "load.left is not used: pose.vertical is set"}));
}

TEST(KeyWarnings, CreepagesTakeThePlaceOfTheMotion) {
  EXPECT_EQ(told(scene_with({{"motion.speed", 2e4},
                             {"motion.pitch", "free"},
                             {"motion.torque", 1e7},
                             {"creepage.left", creepages}})),
            (Texts{"motion.pitch is not used: creepage.left is set",
                   "motion.torque is not used: creepage.left is set"}));
  EXPECT_EQ(told(scene_with({{"motion.speed", 2e4}, {"motion.torque", 1e7}})),
            Texts{"motion.torque is not used: motion.pitch is not \"free\""});
}

TEST(KeyWarnings, WearNeedsCreepForces) {
  const Texts expected{"solve.results: no wear or fatigue without creep forces, which keys of "
                       "creepage.* or motion.* "
                       "request"};
  EXPECT_EQ(told(scene_with({{"solve.results", "wear"}})), expected);
  EXPECT_EQ(told(scene_with({{"solve.results", "stress fatigue"}})), expected);
  EXPECT_EQ(
      told(scene_with(
          {{"solve.results", "wear"}, {"creepage.left", creepages}, {"solve.creep", "none"}})),
      Texts{"solve.results: no wear or fatigue without creep forces, which solve.creep = \"none\" "
            "leaves out"});
  EXPECT_EQ(told(scene_with({{"solve.results", "stress"}})), Texts{});
  EXPECT_EQ(told(scene_with({{"solve.results", "wear"}, {"creepage.left", creepages}})), Texts{});
}

TEST(KeyWarnings, KalkerCoefficientsNeedPressures) {
  EXPECT_EQ(told(scene_with({{"solve.results", "kalker"}, {"solve.until", "remesh"}})),
            Texts{"solve.results: no Kalker coefficients without pressures, which solve.until = "
                  "\"mechanics\" computes"});
  EXPECT_EQ(told(scene_with({{"solve.results", "kalker"}, {"solve.creep", "none"}})), Texts{});
}

TEST(KeyWarnings, FrictionAndGrid) {
  const std::vector<double> places{-20.0, 0.1, 20.0, 0.4};
  const std::vector<double> grid{32.0, 32.0};
  EXPECT_EQ(told(scene_with({{"friction.coefficient", 0.2}, {"friction.places", places}})),
            Texts{"friction.coefficient is not used: friction.places is set"});
  EXPECT_EQ(told(scene_with({{"friction.places", places}, {"friction.coefficient", 0.2}})),
            Texts{"friction.places is not used: friction.coefficient is set"});
  EXPECT_EQ(told(scene_with({{"friction.coefficient", 0.2}, {"friction.left_places", places}})),
            Texts{})
      << "the right wheel has the coefficient";
  EXPECT_EQ(told(scene_with({{"friction.coefficient", 0.2},
                             {"friction.left_places", places},
                             {"friction.right_places", places}})),
            Texts{"friction.coefficient is not used: friction.left_places is set"});
  EXPECT_EQ(told(scene_with({{"solve.grid", grid}, {"solve.accuracy", 1e-3}})),
            Texts{"solve.grid is not used: solve.accuracy is set"})
      << "also by the default";
  EXPECT_EQ(told(scene_with({{"solve.grid", grid}, {"solve.accuracy", 0.01}})),
            Texts{"solve.grid is not used: solve.accuracy is set"});
}

TEST(KeyWarnings, WhatOnlyVaryingBodiesHave) {
  EXPECT_EQ(told(scene_with({{"friction.decay", 0.01}})),
            Texts{"friction.decay is not used: friction.limit_ratio is 1"});
  EXPECT_EQ(told(scene_with({{"friction.limit_ratio", 0.4}})),
            Texts{"friction.limit_ratio is not used: friction.decay is 0"});
  EXPECT_EQ(told(scene_with({{"friction.limit_ratio", 0.4}, {"friction.decay", 0.01}})), Texts{});

  EXPECT_EQ(told(scene_with({{"pose.longitudinal", 100.0}, {"pose.pitch", 0.1}})),
            (Texts{"pose.longitudinal is not used: no rail varies along the track",
                   "pose.pitch is not used: no wheel varies around its axle"}));
  const std::vector<double> flat{3.0, 0.1, 0.0};
  EXPECT_EQ(told(scene_with({{"pose.pitch", 0.1}, {"wheelset.harmonics", flat}})), Texts{});
  EXPECT_EQ(told(scene_with({{"pose.longitudinal", 1.0}, {"track.rail", "crossing.slcs"}})),
            Texts{});
}

TEST(KeyWarnings, WhatAgreesOrIsUnsetIsNoneOfThem) {
  EXPECT_EQ(told(Scene()), Texts{});
  EXPECT_EQ(told(scene_with({{"load.both", 7e4}, {"load.left", 6e4}, {"pose.lateral", 3.0}})),
            Texts{});
  EXPECT_EQ(
      told(scene_with(
          {{"load.both", 7e4}, {"load.of", "total"}, {"load.left", 6e4}, {"load.of", "total"}})),
      Texts{});
  EXPECT_EQ(
      told(scene_with({{"load.both", 7e4}, {"pose.vertical", 459.8}, {"pose.vertical", "solve"}})),
      Texts{});
  const std::vector<double> none(6, 0.0); // as a saved scene has it
  EXPECT_EQ(told(scene_with({{"creepage.left", creepages}, {"motion.acceleration", none}})),
            Texts{});
  EXPECT_EQ(told(scene_with({{"creepage.left", creepages}, {"motion.speed", 2e4}})), Texts{})
      << "the speed is that of the frictional power";
}

TEST(KeyWarnings, AreWarningsOfAResultButNotOfAStep) {
  Scene scene = scene_with({{"load.both", 7e4},
                            {"motion.pitch", "free"},
                            {"motion.torque", 1e6},
                            {"solve.accuracy", 0.1}});
  VehicleState state;
  state.position = {0.0, 0.0, 459.9, 0.0, 0.0, 0.0};
  state.velocity = {2e4, 0.0, 0.0, 0.0, 43.0, 0.0};
  EXPECT_EQ(told(scene_at(scene, state)), Texts{}) << "a step has its own position and motion";

  set_number(scene, "pose.vertical", 459.9);
  SceneResult result = solve_scene(scene);
  const Warnings all = all_warnings(result);
  ASSERT_GE(all.size(), 1U);
  EXPECT_EQ(all.front().text, "load.both is not used: pose.vertical is set");
  EXPECT_EQ(number_value(result, "warning_count"), static_cast<double>(all.size()));
}

/// Values whose units are likely to be others; the last one of each is not warned of.
TEST(KeyWarnings, LoadsSpeedsAndInclinationsThatNoWheelHas) {
  constexpr WarningClass kind = WarningClass::implausible_input;
  const auto begin = [](const Texts& texts) {
    Texts beginnings;
    for (const std::string& text : texts) {
      beginnings.push_back(text.substr(0, text.find(' ')));
    }
    return beginnings;
  };
  const auto named = [&](const Settings& settings) {
    return begin(told(scene_with(settings), kind));
  };
  EXPECT_EQ(named({{"load.both", 80.0}}), Texts{"load.both"});
  EXPECT_EQ(named({{"load.both", 7e4}, {"load.left", 80.0}}), Texts{"load.left"});
  EXPECT_EQ(named({{"load.both", 7e4}, {"load.right", 999.0}}), Texts{"load.right"});
  EXPECT_EQ(named({{"load.left", 6e4}, {"load.right", 0.0}}), Texts{});
  EXPECT_EQ(named({{"load.both", 1000.0}}), Texts{});

  EXPECT_EQ(named({{"convention.units", "SI"}, {"motion.standstill_speed", 100.0}}),
            Texts{"motion.standstill_speed"});
  EXPECT_EQ(named({{"motion.speed", -1e3}, {"motion.standstill_speed", 101.0}}),
            Texts{"motion.standstill_speed"});
  EXPECT_EQ(named({{"motion.speed", 999.0}, {"motion.standstill_speed", 1000.0}}), Texts{});
  EXPECT_EQ(named({{"motion.speed", -1e3}, {"motion.standstill_speed", 100.0}}), Texts{});

  EXPECT_EQ(named({{"track.inclination", 0.1}}), Texts{"track.inclination"});
  EXPECT_EQ(named({{"track.inclination", -0.067}}), Texts{"track.inclination"});
  EXPECT_EQ(named({{"track.inclination", "1:15"}}), Texts{});

  VehicleState state;
  state.position = {0.0, 0.0, 459.9, 0.0, 0.0, 0.0};
  Scene light = scene_with({{"load.both", 80.0}});
  EXPECT_EQ(told(scene_at(light, state), kind), Texts{}) << "a step has no loads";
}

/// What a scene file holds of defaults sets nothing when it is read, and nothing is lost in it.
TEST(KeyWarnings, ASceneFileKeepsWhatHasNoEffect) {
  EXPECT_EQ(told(scene_with({{"load.both", 8e4},
                             {"motion.torque", 0.0},
                             {"load.of", "pressures"},
                             {"creepage.left", creepages}})),
            Texts{});
  const Scene sides =
      scene_with({{"load.both", 5e4}, {"load.left", 6e4}, {"pose.vertical", 459.7}});
  EXPECT_NE(scene_text(sides).find("\nleft = 60000.0\nright = 50000.0\n"), std::string::npos);
  EXPECT_NE(scene_text(scene_with({{"load.both", 8e4}, {"load.of", "normal"}}))
                .find("\nof = \"normal\"\n"),
            std::string::npos);
}

} // namespace
} // namespace wrc::test::key_warnings_test
