// Cases computed by an independent boundary element program (CONTACT), tangent convention.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/scene_keys.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test {
namespace {

/// Asked of pmax and approach in calm cases: one patch, contact angle below 0.15 rad.
constexpr double calm_tolerance = 0.01;
constexpr double calm_angle = 0.15;

Scene scene_of(const nlohmann::json& entry) {
  Scene scene;
  scene.rail = entry.at("rail");
  scene.wheel = entry.at("wheel");
  set_text(scene, "track.cant", entry.at("cant").get<std::string>());
  scene.track.gauge = entry.at("gauge_mm");
  scene.track.gauge_height = entry.at("gauge_height_mm");
  scene.wheelset.back_to_back = entry.at("back_to_back_mm");
  scene.wheelset.tape_offset = entry.at("tape_offset_mm");
  scene.wheelset.radius = entry.at("wheel_radius_mm");
  scene.wheel_material =
      scene.rail_material = {entry.at("youngs_modulus_MPa"), entry.at("poisson")};
  scene.side = entry.at("side") == "left" ? SideChoice::left : SideChoice::right;
  scene.lateral = entry.at("lateral_mm");
  scene.yaw = entry.at("yaw_rad");
  scene.roll = entry.at("roll_rad").get<double>();
  scene.left_load = scene.right_load = entry.at("vertical_load_N");
  return scene;
}

TEST(ContactCases, CalmOnesAgree) {
  std::ifstream file(std::string(WRCONTACT_REFERENCE_DIR) + "/contact_cases.json");
  if (!file) {
    GTEST_SKIP() << "no contact_cases.json in " << WRCONTACT_REFERENCE_DIR;
  }
  const nlohmann::json reference = nlohmann::json::parse(file);
  int compared = 0;
  for (const auto& entry : reference.at("cases")) {
    const auto& patches = entry.at("patches");
    const double angle = patches.at(0).at("contact_angle_rad");
    if (patches.size() != 1 || std::abs(angle) >= calm_angle) {
      continue;
    }
    SCOPED_TRACE(entry.at("id").get<std::string>());
    const SceneResult result = solve_scene(scene_of(entry));
    const SideResult& side = result.left ? *result.left : *result.right;
    const double pmax = patches.at(0).at("pmax_MPa");
    const double approach = patches.at(0).at("approach_mm");
    EXPECT_NEAR(side.pmax_element, pmax, calm_tolerance * pmax);
    EXPECT_NEAR(side.approach, approach, calm_tolerance * approach);
    EXPECT_NEAR(side.vertical_force, entry.at("total_vertical_force_N").get<double>(),
                1e-6 * side.vertical_force);
    EXPECT_EQ(side.patches.size(), 1u);
    // On the right wheel the rail pushes to the left: positive in both conventions.
    const double lateral = entry.at("total_lateral_force_N_right_positive");
    EXPECT_GT(side.lateral_force * lateral, 0.0);
    EXPECT_NEAR(side.patches.at(0).centre.s_wheel, patches.at(0).at("s_wheel_mm").get<double>(),
                0.5);
    ++compared;
  }
  EXPECT_EQ(compared, 19);
}

} // namespace
} // namespace wrc::test
