// Sections of stresses below the surface, as VTK.
#include <algorithm>
#include <array>
#include <cmath>

#include "reports/patches.hpp"
#include "wrc_case/reports.hpp"
#include "wrc_case/vtk_file.hpp"

namespace driver {

void write_stress_vtk(const Scene& scene, const std::filesystem::path& path) {
  constexpr std::array names{"von_mises", "shear", "xx", "yy", "zz", "xy", "xz", "yz"};
  VtkGrid grid;
  std::array<std::vector<double>, names.size()> values;
  const bool across = scene.get_text("stress.section") == "across";
  const double down = scene.get_text("stress.body") == "rail" ? -1.0 : 1.0;
  for (const PatchName& patch : parts_with(scene, all_patches(scene), stress_result)) {
    const auto number = [&](const char* name) { return scene.number(patch.prefix + name); };
    const std::vector<double> places = scene.field(patch.prefix + "stress_place");
    const std::vector<double> depths = scene.field(patch.prefix + "stress_depth");
    const auto columns = static_cast<std::size_t>(
        std::count(depths.begin(), depths.end(), depths.empty() ? 0.0 : depths.front()));
    const double mirror = patch.side == "left" ? 1.0 : -1.0;
    const double angle = number("plane_angle");
    const std::size_t offset = grid.points.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double x = across ? number("stress.along") : places[i];
      const double y = mirror * (across ? places[i] : number("stress.across"));
      const double z = down * depths[i];
      grid.points.push_back({number("x") + x,
                             number("y") + y * std::cos(angle) - z * std::sin(angle),
                             number("z") + y * std::sin(angle) + z * std::cos(angle)});
      if (i % columns + 1 < columns && i + columns < places.size()) {
        const std::size_t corner = offset + i;
        grid.quads.push_back({corner, corner + 1, corner + columns + 1, corner + columns});
      }
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::vector<double> field = scene.field(patch.prefix + "stress_" + names[k]);
      values[k].insert(values[k].end(), field.begin(), field.end());
    }
  }
  if (grid.points.empty()) {
    throw Failure(
        "--stress " + path.string() +
        ": there are no stresses: no wheel is in contact, or its pressures have no bound that the "
        "elements show");
  }
  VtkFile file(path,
               "wrcontact: x y z in mm (track frame), stresses in MPa in the patch's plane, z into "
               "the body",
               grid, "POINT_DATA");
  for (std::size_t k = 0; k < names.size(); ++k) {
    file.add(names[k], values[k]);
  }
  file.commit();
}

} // namespace driver
