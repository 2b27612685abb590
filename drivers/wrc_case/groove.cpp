// Profiles with the groove that passes over steel that yields have left.
#include <algorithm>

#include "reports/patches.hpp"
#include "reports/worn_profile.hpp"
#include "support/scene_file.hpp"
#include "wrc_case/reports.hpp"

namespace driver {
namespace {

constexpr double spacing = 0.05; // of points along the curve, mm: grooves are 3 to 20 mm wide

WornProfile profile_to_groove(const Scene& scene, bool wheel) {
  const std::string side = scene.get_text("solve.side");
  const std::string key = wheel ? "wheelset." + side + ".wheel" : "track." + side + ".rail";
  return {load_profile(scene, wheel ? WRC_WHEEL : WRC_RAIL, scene.get_text(key)), spacing};
}

} // namespace

void require_one_profile(const Scene& scene, bool wheel) {
  (void)profile_to_groove(scene, wheel);
}

void write_grooved_profile(const Scene& scene, bool wheel, const std::filesystem::path& path) {
  const std::string side = scene.get_text("solve.side");
  std::vector<WornProfile::Groove> grooves;
  double deepest = 0.0;
  for (const PatchName& patch : parts_with(scene, patches_of(scene, side), groove_result)) {
    grooves.push_back(
        {scene.field(patch.prefix + (wheel ? "groove_s_wheel" : "groove_t_rail")),
         scene.field(patch.prefix + (wheel ? "groove_depth_wheel" : "groove_depth_rail"))});
    for (const double depth : grooves.back().depth) {
      deepest = std::max(deepest, depth);
    }
  }
  if (!(deepest > 0.0)) {
    throw Failure((wheel ? "--grooved-wheel " : "--grooved-rail ") + path.string() +
                  ": no groove: this body does not yield on the " + side + " side");
  }
  WornProfile profile = profile_to_groove(scene, wheel);
  profile.take_off(grooves);
  profile.profile().write(path.string(), spacing);
}

} // namespace driver
