#include "reports/drawn_sides.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/refined_map.hpp"

namespace driver {
namespace {

/// How much of a gap between neighbours is left out of the picture: as much as makes it as wide as
/// all patches together, if it is more than twice that.
double left_out(double gap, double widths) {
  return gap > 2.0 * widths ? gap - widths : 0.0;
}

/// Developed: the distances between the references of neighbours one after the other, from that of
/// the patch with the largest force. Then long gaps are shortened.
void develop(DrawnSide& side) {
  std::vector<DrawnPatch>& patches = side.patches;
  std::sort(patches.begin(), patches.end(),
            [](const DrawnPatch& one, const DrawnPatch& other) { return one.y < other.y; });
  double widths = 0.0;
  for (const DrawnPatch& patch : patches) {
    widths += patch.lateral.empty() ? 0.0 : patch.lateral.length();
  }
  for (std::size_t i = 1; i < patches.size(); ++i) {
    const DrawnPatch& before = patches[i - 1];
    DrawnPatch& patch = patches[i];
    const double distance = std::hypot(patch.y - before.y, patch.z - before.z);
    patch.developed = before.developed + distance;
    patch.across = before.across + distance;
    if (before.lateral.empty() || patch.lateral.empty()) {
      continue;
    }
    const double end = before.across + before.lateral.greatest;
    const double gap = patch.across + patch.lateral.least - end;
    if (const double out = left_out(gap, widths); out > 0.0) {
      patch.across -= out;
      side.gaps.push_back({end + 0.5 * (gap - out), out});
    }
  }
  const auto main = std::find_if(patches.begin(), patches.end(),
                                 [](const DrawnPatch& patch) { return patch.name.index == 0; });
  const double across = main == patches.end() ? 0.0 : main->across;
  const double developed = main == patches.end() ? 0.0 : main->developed;
  for (DrawnPatch& patch : patches) {
    patch.across -= across;
    patch.developed -= developed;
    side.across.include(patch.across + patch.lateral.least);
    side.across.include(patch.across + patch.lateral.greatest);
    side.along.include(patch.longitudinal.least);
    side.along.include(patch.longitudinal.greatest);
  }
  for (ShortenedGap& gap : side.gaps) {
    gap.middle -= across;
  }
}

/// Lines of lateral (from the reference of the patch), x and value, an empty one after each row.
void write_map(std::ostream& out, const DrawnPatch& patch, std::size_t columns,
               const std::vector<double>& x, const std::vector<double>& y,
               const std::vector<double>& z, const std::vector<double>& values) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    out << patch.in_plane(y[i], z[i]) << ' ' << x[i] << ' ' << std::max(values[i], 0.0) << '\n'
        << ((i + 1) % columns == 0 ? "\n" : "");
  }
}

/// The pressures of a patch over lateral (from its reference) and x, as a block of data.
void write_pressure(Gnuplot& gnuplot, const Scene& scene, DrawnPatch& patch) {
  const std::string& prefix = patch.name.prefix;
  const auto x = scene.field(prefix + "x");
  const auto y = scene.field(prefix + "y");
  const auto z = scene.field(prefix + "z");
  const auto pressure = scene.field(prefix + "pressure");
  const double half_width = 0.5 * scene.number(prefix + "element_size.lateral");
  const double half_length = 0.5 * scene.number(prefix + "element_size.longitudinal");
  const auto length = static_cast<std::size_t>(scene.number(prefix + "grid.longitudinal"));
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (pressure[i] > 0.0) {
      const double lateral = patch.in_plane(y[i], z[i]);
      patch.lateral.include(lateral - half_width);
      patch.lateral.include(lateral + half_width);
      patch.longitudinal.include(x[i] - half_length);
      patch.longitudinal.include(x[i] + half_length);
    }
  }
  patch.has_contours =
      length > 1 && x.size() > length && *std::max_element(pressure.begin(), pressure.end()) > 0.0;
  std::ostringstream data;
  data.precision(9);
  if (patch.has_contours) {
    const RefinedMap map(x.size() / length, length);
    write_map(data, patch, map.columns(), map.linear(x), map.linear(y), map.linear(z),
              map.pressure(pressure));
  } else {
    write_map(data, patch, length, x, y, z, pressure);
  }
  patch.block = gnuplot.block(data.str());
}

/// The tractions of a patch, or of its parts, over lateral (from its reference) and x.
void write_tractions(Gnuplot& gnuplot, const Scene& scene, DrawnPatch& patch) {
  for (const PatchName& one : parts_with(scene, {patch.name}, creep_result)) {
    const auto field = [&](const char* name) { return scene.field(one.prefix + name); };
    const auto x = field("creep_x");
    const auto y = field("creep_y");
    const auto z = field("creep_z");
    const auto pressure = field("creep_pressure");
    const auto along = field("traction_x");
    const auto across = field("traction_y");
    const double friction = scene.number(one.prefix + "friction");
    const double half_width = 0.5 * scene.number(one.prefix + "creep_element_size.lateral");
    const double half_length = 0.5 * scene.number(one.prefix + "creep_element_size.longitudinal");
    const auto columns =
        static_cast<std::size_t>(scene.number(one.prefix + "creep_grid.longitudinal"));
    const auto rows = static_cast<std::size_t>(scene.number(one.prefix + "creep_grid.lateral"));
    constexpr std::size_t most_arrows = 14; // along and across
    const std::size_t row_step = (rows + most_arrows - 1) / most_arrows;
    const std::size_t column_step = (columns + most_arrows - 1) / most_arrows;
    std::ostringstream areas;
    std::ostringstream arrows;
    areas.precision(9);
    arrows.precision(9);
    std::vector<double> slips(x.size(), 0.5); // 1 slips, 0 adheres
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!(pressure[i] > 0.0)) {
        continue;
      }
      const double lateral = patch.in_plane(y[i], z[i]);
      const double traction = std::hypot(along[i], across[i]);
      constexpr double on_bound = 1.0 - 1e-6;
      slips[i] = traction >= on_bound * friction * pressure[i] ? 1.0 : 0.0;
      patch.largest_traction = std::max(patch.largest_traction, traction);
      if ((i / columns) % row_step == row_step / 2 &&
          (i % columns) % column_step == column_step / 2) {
        arrows << lateral << ' ' << x[i] << ' ' << across[i] << ' ' << along[i] << '\n';
      }
    }
    patch.arrow_step = std::max({patch.arrow_step, 2.0 * half_width * static_cast<double>(row_step),
                                 2.0 * half_length * static_cast<double>(column_step)});
    if (rows > 1 && columns > 1) {
      const RefinedMap map(rows, columns);
      const auto fine_x = map.linear(x);
      const auto fine_y = map.linear(y);
      const auto fine_z = map.linear(z);
      const auto fine_pressure = map.pressure(pressure);
      const auto fine_slips = map.linear(slips);
      const std::string slip = components_of(colour::slip);
      const std::string adhesion = components_of(colour::adhesion);
      for (std::size_t i = 0; i < fine_x.size(); ++i) {
        areas << patch.in_plane(fine_y[i], fine_z[i]) << ' ' << fine_x[i] << ' '
              << (fine_slips[i] >= 0.5 ? slip : adhesion)
              << (fine_pressure[i] > 0.0 ? " 255\n" : " 0\n");
      }
      patch.areas.push_back(gnuplot.block(areas.str()));
    }
    patch.arrows.push_back(gnuplot.block(arrows.str()));
  }
}

} // namespace

double DrawnPatch::in_plane(double of_y, double of_z) const {
  return (of_y - y) * std::cos(plane_angle) + (of_z - z) * std::sin(plane_angle);
}

DrawnSide write_side(Gnuplot& gnuplot, const Scene& scene, const std::string& name,
                     bool has_pressures) {
  const auto outline = [&](const std::string& body) {
    return gnuplot.block(scene.field(name + '.' + body + "_y"),
                         scene.field(name + '.' + body + "_z"));
  };
  DrawnSide side;
  side.name = name;
  side.rail = outline("rail");
  side.wheel = outline("wheel");
  if (!has_pressures) {
    return side;
  }
  for (const PatchName& patch : patches_of(scene, name)) {
    const auto number = [&](const char* value) { return scene.number(patch.prefix + value); };
    DrawnPatch& drawn = side.patches.emplace_back();
    drawn.name = patch;
    drawn.y = number("y");
    drawn.z = number("z");
    drawn.plane_angle = number("plane_angle");
    drawn.centroid_x = number("centroid.x");
    drawn.centroid_y = number("centroid.y");
    drawn.centroid_z = number("centroid.z");
    drawn.force = number("normal_force");
    drawn.force_angle = number("angle");
    write_pressure(gnuplot, scene, drawn);
    write_tractions(gnuplot, scene, drawn);
    const double pmax = scene.number(name + ".pmax");
    drawn.has_contours = drawn.has_contours && pmax > 0.0; // none where an end cuts the contact
    if (drawn.has_contours) {
      gnuplot.script() << contour_lines(drawn.block, pmax);
    }
  }
  develop(side);
  return side;
}

} // namespace driver
