// Cases computed by an independent boundary element program (CONTACT), tangent convention.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/scene_keys.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test {
namespace {

/// Asked of pmax and approach of every patch; or the change that a lateral shift of this size
/// makes.
constexpr double tolerance = 0.005;
constexpr double shift = 0.01; // mm
/// The contact reference, mm, and the plane's angle, rad. Both programs weigh places with the
/// square of the penetration; CONTACT's figures are rounded to 1e-4.
constexpr double place_tolerance = 0.3;
constexpr double angle_tolerance = 0.002;
/// By how much the least distance of element centres can lie above the least distance, mm.
double between_elements(const PatchResult& patch) {
  const auto least =
      std::min_element(patch.undeformed_distance.begin(), patch.undeformed_distance.end());
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(patch.grid.longitudinal_count);
  return ((least[row] - 2.0 * *least + least[-row]) + (least[1] - 2.0 * *least + least[-1])) / 8.0;
}

/// Of the forces of patches that share a load.
constexpr double share_tolerance = 0.01;
/// The built-in rail lies up to 4.4e-5 mm beside the points that CONTACT has read. That is a
/// fifteenth of the approach of the small patch in this case, which has to be computed from the
/// file itself.
constexpr const char* delicate_case = "extreme-160";

Scene scene_of(const nlohmann::json& entry) {
  Scene scene;
  scene.elements = Elements::constant; // as CONTACT has them
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

const SideResult& side_of(const SceneResult& result) {
  return result.left ? *result.left : *result.right;
}

/// The scene on elements of CONTACT's size.
SceneResult solve_on_elements(Scene scene, double element) {
  scene.grid.reset();
  scene.accuracy = 0.01;
  const SceneResult first = solve_scene(scene);
  const Grid& grid = side_of(first).patches.front().grid;
  const auto count = [element](std::size_t elements, double step) {
    return static_cast<std::size_t>(std::lround(static_cast<double>(elements) * step / element));
  };
  scene.grid = {{count(grid.lateral_count, grid.lateral_step),
                 count(grid.longitudinal_count, grid.longitudinal_step)}};
  return solve_scene(scene);
}

/// The reference's patches, largest force first.
std::vector<nlohmann::json> ordered_patches(const nlohmann::json& entry) {
  std::vector<nlohmann::json> patches = entry.at("patches");
  std::stable_sort(patches.begin(), patches.end(), [](const auto& one, const auto& other) {
    return one.at("normal_force_N").template get<double>() >
           other.at("normal_force_N").template get<double>();
  });
  return patches;
}

nlohmann::json reference_cases() {
  std::ifstream file(std::string(WRCONTACT_REFERENCE_DIR) + "/contact_cases.json");
  return file ? nlohmann::json::parse(file).at("cases") : nlohmann::json::array();
}

TEST(ContactCases, AllAgree) {
  const nlohmann::json cases = reference_cases();
  if (cases.empty()) {
    GTEST_SKIP() << "no contact_cases.json in " << WRCONTACT_REFERENCE_DIR;
  }
  EXPECT_EQ(cases.size(), 23u);
  for (const auto& entry : cases) {
    const std::string id = entry.at("id");
    SCOPED_TRACE(id);
    Scene scene = scene_of(entry);
    if (id == delicate_case) {
      scene.rail = std::string(WRCONTACT_REFERENCE_DIR) + "/MBench_UIC60_v3.prr";
      scene.track.cant = 0.0; // already in the points
    }
    const double element = entry.at("element_mm");
    const SceneResult result = solve_on_elements(scene, element);
    const SideResult& side = side_of(result);
    const auto patches = ordered_patches(entry);
    ASSERT_EQ(side.patches.size(), patches.size());
    EXPECT_NEAR(side.force.z, entry.at("total_vertical_force_N").get<double>(),
                1e-6 * side.force.z);
    // Changes made by a shift to either side.
    std::vector<double> pmax_change(patches.size());
    std::vector<double> approach_change(patches.size());
    for (const double sign : {-1.0, 1.0}) {
      Scene shifted = scene;
      shifted.lateral += sign * shift;
      const SceneResult other = solve_on_elements(shifted, element);
      for (std::size_t k = 0; k < std::min(patches.size(), side_of(other).patches.size()); ++k) {
        const PatchResult& patch = side_of(other).patches[k];
        pmax_change[k] = std::max(pmax_change[k], std::abs(patch.pmax - side.patches[k].pmax));
        approach_change[k] =
            std::max(approach_change[k], std::abs(patch.approach - side.patches[k].approach));
      }
    }
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const auto value = [&](const char* name) { return patches[k].at(name).get<double>(); };
      const PatchResult& patch = side.patches[k];
      const double pmax = value("pmax_MPa");
      const double approach = value("approach_mm");
      EXPECT_NEAR(patch.pmax_element, pmax, std::max(tolerance * pmax, pmax_change[k]));
      // CONTACT's approach is the least distance of its element centres: it may be less than ours.
      const double permitted = std::max(tolerance * approach, approach_change[k]);
      EXPECT_LE(patch.approach, approach + permitted + between_elements(patch));
      EXPECT_GE(patch.approach, approach - permitted);
      EXPECT_NEAR(patch.reference.y, value("y_track_mm"), place_tolerance);
      EXPECT_NEAR(patch.reference.z, value("z_track_mm"), place_tolerance);
      EXPECT_NEAR(patch.reference.s_wheel, value("s_wheel_mm"), place_tolerance);
      EXPECT_NEAR(patch.angle, value("contact_angle_rad"), angle_tolerance);
      EXPECT_NEAR(patch.normal_force, value("normal_force_N"),
                  share_tolerance * value("normal_force_N"));
      std::printf(
          "%-14s %zu pmax %8.2f %+.2f %% (shift %.2f %%) approach %+.2f %% (%.2f %%, "
          "between elements %.2f %%) angle %+.2f mrad y %+.3f z %+.3f s %+.3f x %+.3f N %+.2f %%\n",
          id.c_str(), k, pmax, 100.0 * (patch.pmax_element / pmax - 1.0),
          100.0 * pmax_change[k] / pmax, 100.0 * (patch.approach / approach - 1.0),
          100.0 * approach_change[k] / approach, 100.0 * between_elements(patch) / approach,
          1e3 * (patch.angle - value("contact_angle_rad")), patch.reference.y - value("y_track_mm"),
          patch.reference.z - value("z_track_mm"), patch.reference.s_wheel - value("s_wheel_mm"),
          patch.reference.x - value("x_track_mm"),
          100.0 * (patch.normal_force / value("normal_force_N") - 1.0));
    }
    // On the right wheel the rail pushes to the left: positive in both conventions.
    const double lateral = entry.at("total_lateral_force_N_right_positive");
    EXPECT_GT(side.force.y * lateral, 0.0);
  }
}

} // namespace
} // namespace wrc::test
