// Profiles with the groove that passes over steel that yields have left.
#include "reports/patches.hpp"
#include "reports/worn_profile.hpp"
#include "support/scene_file.hpp"
#include "wrc_case/reports.hpp"

namespace driver {
namespace {

constexpr double spacing = 0.05; // of points along the curve, mm: grooves are 3 to 20 mm wide

} // namespace

void write_grooved_profile(const Scene& scene, bool wheel, const std::filesystem::path& path) {
  const std::string side = sides_of(scene).at(0);
  const std::string key = wheel ? "wheelset." + side + ".wheel" : "track." + side + ".rail";
  std::vector<WornProfile::Groove> grooves;
  for (const PatchName& patch : parts_with(scene, patches_of(scene, side), groove_result)) {
    grooves.push_back(
        {scene.field(patch.prefix + (wheel ? "groove_s_wheel" : "groove_t_rail")),
         scene.field(patch.prefix + (wheel ? "groove_depth_wheel" : "groove_depth_rail"))});
  }
  WornProfile profile(load_profile(scene, wheel ? WRC_WHEEL : WRC_RAIL, scene.get_text(key)),
                      spacing);
  profile.take_off(grooves);
  profile.profile().write(path.string(), spacing);
}

} // namespace driver
