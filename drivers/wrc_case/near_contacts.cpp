// Places that nearly touch before there is a load: what the load closes is reported as contact.
#include <algorithm>
#include <cmath>

#include "reports/patches.hpp"
#include "support/numbers.hpp"
#include "wrc_case/reports.hpp"

namespace driver {
namespace {

/// The patch that has pressure at a point of the rail, -1 if there is none.
int loaded_patch_at(const Scene& scene, const std::string& side, const std::string& point) {
  if (scene.get_text("solve.until") != "mechanics") {
    return -1;
  }
  const auto of_point = [&](const char* name) { return scene.number(point + name); };
  for (const PatchName& patch : patches_of(scene, side)) {
    const auto number = [&](const char* name) { return scene.number(patch.prefix + name); };
    const double cosine = std::cos(number("plane_angle"));
    const double sine = std::sin(number("plane_angle"));
    // Elements lie in the plane, the point on the rail: what is normal to the plane does not count.
    constexpr double rounding = 1e-9;
    const double half_width = (0.5 + rounding) * number("element_size.lateral");
    const double half_length = (0.5 + rounding) * number("element_size.longitudinal");
    const std::vector<double> x = scene.field(patch.prefix + "x");
    const std::vector<double> y = scene.field(patch.prefix + "y");
    const std::vector<double> z = scene.field(patch.prefix + "z");
    const std::vector<double> pressure = scene.field(patch.prefix + "pressure");
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double across = (y[i] - of_point("y")) * cosine + (z[i] - of_point("z")) * sine;
      if (pressure[i] > 0.0 && std::abs(across) <= half_width &&
          std::abs(x[i] - of_point("x")) <= half_length) {
        return patch.index;
      }
    }
  }
  return -1;
}

} // namespace

void print_near_contacts(const Scene& scene, std::ostream& out) {
  constexpr int most = 3; // further ones are of no use
  for (const std::string& side : sides_of(scene)) {
    const int count = scene.count_of(side + ".near_contacts");
    for (int i = 0; i < std::min(count, most); ++i) {
      const std::string prefix = side + ".near_contacts." + std::to_string(i) + '.';
      const int patch = loaded_patch_at(scene, side, prefix);
      out << (patch < 0 ? "Near contact, " : "Closed by the load, ") << side << ": "
          << fixed(scene.number(prefix + "distance"), 4) << " mm apart "
          << (patch < 0 ? "" : "at first touch ") << "at s_wheel "
          << fixed(scene.number(prefix + "s_wheel"), 2) << " mm, angle "
          << fixed(1e3 * scene.number(prefix + "angle"), 1) << " mrad"
          << (patch < 0 ? "" : "; part of patch " + std::to_string(patch)) << '\n';
    }
    if (count > most) {
      out << "Near contact, " << side << ": " << count - most << " more within "
          << general(scene.get_number("solve.near_tolerance"), 4) << " mm\n";
    }
  }
}

} // namespace driver
