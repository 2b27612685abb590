#include "wrc_case/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"
#include "wrc_case/patches.hpp"

namespace driver {
namespace {

constexpr std::array colours{"#c00000", "#00802b", "#7030a0", "#c55a11"};

const char* colour_of(int index) {
  return colours[static_cast<std::size_t>(index) % colours.size()];
}

/// With three digits, in N or kN.
std::string force_text(double newtons) {
  const bool thousands = newtons >= 1000.0;
  const double value = thousands ? 1e-3 * newtons : newtons;
  const int decimals = value < 10.0 ? 2 : value < 100.0 ? 1 : 0;
  return fixed(value, decimals) + (thousands ? " kN" : " N");
}

/// From the least to the greatest value taken in.
struct Range {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();

  void include(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  [[nodiscard]] double middle() const { return 0.5 * (least + greatest); }
  [[nodiscard]] double length() const { return greatest - least; }
};

/// A patch as it is drawn.
struct DrawnPatch {
  PatchName name;
  double y = 0.0; ///< reference, track frame
  double z = 0.0;
  double angle = 0.0;
  double force = 0.0;
  double across = 0.0; ///< of the reference, developed, positive to the left
  Range lateral;       ///< of the contact, from the reference, positive to the left
  Range longitudinal;  ///< of the contact, track x

  [[nodiscard]] std::string block() const {
    return '$' + name.side + "_pressure_" + std::to_string(name.index);
  }
  /// Lines of equal pressure; none on a grid of one row or column.
  [[nodiscard]] std::string contours() const { return block() + "_contours"; }
  bool has_contours = false;
  [[nodiscard]] std::string label() const {
    return force_text(force) + ", " + fixed(1e3 * angle, 1) + " mrad";
  }
};

struct DrawnSide {
  std::string name;
  std::vector<DrawnPatch> patches; ///< from right to left
  Range across;                    ///< of all contacts, developed
  Range along;
};

void write_outline(std::ostream& out, const std::string& block, const std::vector<double>& y,
                   const std::vector<double>& z) {
  out << '$' << block << " << EOD\n";
  for (std::size_t i = 0; i < y.size(); ++i) {
    out << y[i] << ' ' << z[i] << '\n';
  }
  out << "EOD\n";
}

/// Developed: the distances between the references of neighbours one after the other, from that of
/// the patch with the largest force.
void develop(DrawnSide& side) {
  std::sort(side.patches.begin(), side.patches.end(),
            [](const DrawnPatch& one, const DrawnPatch& other) { return one.y < other.y; });
  for (std::size_t i = 1; i < side.patches.size(); ++i) {
    const DrawnPatch& before = side.patches[i - 1];
    DrawnPatch& patch = side.patches[i];
    patch.across = before.across + std::hypot(patch.y - before.y, patch.z - before.z);
  }
  const auto main = std::find_if(side.patches.begin(), side.patches.end(),
                                 [](const DrawnPatch& patch) { return patch.name.index == 0; });
  const double zero = main == side.patches.end() ? 0.0 : main->across;
  for (DrawnPatch& patch : side.patches) {
    patch.across -= zero;
    side.across.include(patch.across + patch.lateral.least);
    side.across.include(patch.across + patch.lateral.greatest);
    side.along.include(patch.longitudinal.least);
    side.along.include(patch.longitudinal.greatest);
  }
}

/// The pressures of a patch over lateral (from its reference) and x, as a block of data.
void write_pressure(std::ostream& out, const Scene& scene, DrawnPatch& patch) {
  const std::string& prefix = patch.name.prefix;
  const auto x = scene.field(prefix + "x");
  const auto y = scene.field(prefix + "y");
  const auto z = scene.field(prefix + "z");
  const auto pressure = scene.field(prefix + "pressure");
  const double cosine = std::cos(patch.angle);
  const double sine = std::sin(patch.angle);
  const double half_width = 0.5 * scene.number(prefix + "element_size.0");
  const double half_length = 0.5 * scene.number(prefix + "element_size.1");
  const auto length = static_cast<std::size_t>(scene.number(prefix + "grid.1"));
  out << patch.block() << " << EOD\n";
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double lateral = (y[i] - patch.y) * cosine + (z[i] - patch.z) * sine;
    out << lateral << ' ' << x[i] << ' ';
    if (pressure[i] > 0.0) {
      out << pressure[i] << '\n';
      patch.lateral.include(lateral - half_width);
      patch.lateral.include(lateral + half_width);
      patch.longitudinal.include(x[i] - half_length);
      patch.longitudinal.include(x[i] + half_length);
    } else {
      out << "NaN\n";
    }
    if ((i + 1) % length == 0) {
      out << '\n';
    }
  }
  out << "EOD\n";
  patch.has_contours =
      length > 1 && x.size() > length && *std::max_element(pressure.begin(), pressure.end()) > 0.0;
}

/// Lines at fifths of the largest pressure of the side, as a block of data.
void write_contours(std::ostream& out, const DrawnPatch& patch, double largest) {
  out << "set contour base\nunset surface\nset cntrparam levels discrete ";
  for (int fifth = 1; fifth < 5; ++fifth) {
    out << (fifth > 1 ? "," : "") << 0.2 * fifth * largest;
  }
  out << "\nset table " << patch.contours() << "\nsplot " << patch.block()
      << " using 1:2:3 with lines\nunset table\nunset contour\nset surface\n";
}

DrawnSide write_side(std::ostream& out, const Scene& scene, const std::string& name) {
  write_outline(out, name + "_rail", scene.field(name + ".rail_y"), scene.field(name + ".rail_z"));
  write_outline(out, name + "_wheel", scene.field(name + ".wheel_y"),
                scene.field(name + ".wheel_z"));
  DrawnSide side;
  side.name = name;
  for (const PatchName& patch : patches_of(scene, name)) {
    const auto number = [&](const char* value) { return scene.number(patch.prefix + value); };
    DrawnPatch& drawn = side.patches.emplace_back();
    drawn.name = patch;
    drawn.y = number("y");
    drawn.z = number("z");
    drawn.angle = number("angle");
    drawn.force = number("normal_force");
    write_pressure(out, scene, drawn);
    if (drawn.has_contours) {
      write_contours(out, drawn, scene.number(name + ".pmax"));
    }
  }
  develop(side);
  return side;
}

/// Profiles, the planes of the patches and the forces on the wheel along their normals.
void plot_outlines(std::ostream& out, const Scene& scene, const DrawnSide& side) {
  const double y = scene.number(side.name + ".rigid_contact.y");
  const double z = scene.number(side.name + ".rigid_contact.z");
  constexpr double half_width = 45.0;
  constexpr double below = 26.0;
  constexpr double above = 34.0;
  constexpr double half_plane = 9.0;     // mm, drawn
  constexpr double longest_arrow = 20.0; // mm, of the largest force of this wheel
  constexpr double shortest_arrow = 3.0;
  out << "set title '" << side.name << " wheel, seen in driving direction'\n"
      << "set xlabel 'track y, mm (to the left)'\nset ylabel 'track z, mm'\n"
      << "set size ratio -1\nset key top left Left reverse samplen 2 opaque width -2\n"
      << "set xrange [" << y + half_width << ':' << y - half_width << "]\nset yrange [" << z - below
      << ':' << z + above << "]\n";
  double largest = 0.0;
  for (const DrawnPatch& patch : side.patches) {
    largest = std::max(largest, patch.force);
  }
  for (const DrawnPatch& patch : side.patches) {
    const double length = std::max(longest_arrow * patch.force / largest, shortest_arrow);
    out << "set arrow from " << patch.y << ',' << patch.z << " rto "
        << -length * std::sin(patch.angle) << ',' << length * std::cos(patch.angle)
        << " front lw 2 lc rgb '" << colour_of(patch.name.index)
        << "' head filled size screen 0.012,18\n";
  }
  out << "plot $" << side.name << "_rail with filledcurves y=" << z - 2.0 * below
      << " fs solid fc rgb '#f3ebe3' notitle, $" << side.name
      << "_wheel with filledcurves y=" << z + 2.0 * above << " fs solid fc rgb '#e9eff8' notitle, $"
      << side.name << "_rail with lines lw 2 lc rgb '#8b5a2b' title 'rail', $" << side.name
      << "_wheel with lines lw 2 lc rgb '#1f4e9e' title 'wheel'";
  std::vector<DrawnPatch> by_force = side.patches;
  std::sort(by_force.begin(), by_force.end(), [](const DrawnPatch& one, const DrawnPatch& other) {
    return one.name.index < other.name.index;
  });
  for (const DrawnPatch& patch : by_force) {
    out << ", '-' with lines lw 3 lc rgb '" << colour_of(patch.name.index) << "' title 'patch "
        << patch.name.index << ": " << patch.label() << "'";
  }
  out << ", '-' with points pt 6 ps 1.2 lw 2 lc rgb 'black' title 'first touch'\n";
  for (const DrawnPatch& patch : by_force) {
    for (const double end : {-half_plane, half_plane}) {
      out << patch.y + end * std::cos(patch.angle) << ' ' << patch.z + end * std::sin(patch.angle)
          << '\n';
    }
    out << "EOF\n";
  }
  out << y << ' ' << z << "\nEOF\nunset arrow\n";
}

/// The axes of the pressures, mm: the same scale for both wheels.
struct PressureAxes {
  double width = 0.0;
  double length = 0.0;

  /// Takes in a side, with room for the labels around its patches.
  void include(const DrawnSide& side) {
    constexpr double share_across = 0.78;
    constexpr double share_along = 0.62;
    width = std::max({width, side.across.length() / share_across,
                      side.along.length() / share_along * width_to_length});
    length = width / width_to_length;
  }
  static constexpr double width_to_length = 1.35;
};

/// The pressures of all patches of a side over the developed lateral coordinate.
void plot_pressure(std::ostream& out, const Scene& scene, const DrawnSide& side,
                   const PressureAxes& axes) {
  if (side.patches.empty()) {
    out << "set title '" << side.name << " wheel: no contact'\nset xrange [-1:1]\n"
        << "set yrange [-1:1]\nplot NaN notitle\n";
    return;
  }
  const auto value = [&](const char* name) { return scene.number(side.name + '.' + name); };
  out << "set title 'p_{max} " << fixed(value("pmax"), 0) << " MPa, area "
      << fixed(value("area"), 1) << " mm^2, vertical " << force_text(value("vertical_force"))
      << "'\nset xlabel 'along the planes of the patches, mm (to the left)'\n"
      << "set ylabel 'track x, mm (forward)'\nset cblabel 'pressure, MPa' offset 1\n"
      << "set size ratio -1\nset key off\nset xrange [" << side.across.middle() + 0.5 * axes.width
      << ':' << side.across.middle() - 0.5 * axes.width << "]\nset yrange ["
      << side.along.middle() - 0.5 * axes.length << ':' << side.along.middle() + 0.5 * axes.length
      << "]\nset cbrange [0:" << value("pmax") << "]\n";
  // Labels of neighbours stand above and below in turn.
  bool above = true;
  for (const DrawnPatch& patch : side.patches) {
    const double end = above ? patch.longitudinal.greatest : patch.longitudinal.least;
    out << "set label \"patch " << patch.name.index << "\\n"
        << force_text(patch.force) << "\\n"
        << fixed(1e3 * patch.angle, 1) << " mrad\" at " << patch.across + patch.lateral.middle()
        << ',' << end << " center offset 0," << (above ? 2.9 : -1.1) << " tc rgb '"
        << colour_of(patch.name.index) << "' front\n";
    above = !above;
  }
  out << "plot ";
  for (const DrawnPatch& patch : side.patches) {
    out << patch.block() << " using ($1+(" << patch.across << ")):2:3 with image, ";
    if (patch.has_contours) {
      out << patch.contours() << " using ($1+(" << patch.across
          << ")):2 with lines lc rgb '#404040' lw 0.8, ";
    }
  }
  out << "'-' with points pt 2 ps 1 lw 1.5 lc rgb 'black'\n";
  for (const DrawnPatch& patch : side.patches) {
    const std::string& prefix = patch.name.prefix;
    const auto from_reference = [&](const char* centroid, double reference) {
      return scene.number(prefix + centroid) - reference;
    };
    out << patch.across + from_reference("centroid.y", patch.y) * std::cos(patch.angle) +
               from_reference("centroid.z", patch.z) * std::sin(patch.angle)
        << ' ' << scene.number(prefix + "centroid.x") << '\n';
  }
  out << "EOF\nunset label\n";
}

} // namespace

void draw_scene(const Scene& scene, const std::filesystem::path& path) {
  Gnuplot gnuplot;
  std::ostream& out = gnuplot.script();
  const bool has_pressures = scene.input_text("solve.until") == "mechanics";
  std::vector<DrawnSide> sides;
  PressureAxes axes;
  for (const std::string& name : scene.sides()) {
    DrawnSide& side = sides.emplace_back(write_side(out, scene, name));
    if (!has_pressures) {
      side.patches.clear();
    }
    axes.include(side);
  }
  out << "set grid lc rgb '#dddddd'\n"
         "set palette defined (0 '#e8f0ff', 0.25 '#6fa8dc', 0.5 '#3d85c6', 0.7 '#f1c232', 0.85 "
         "'#e69138', 1 '#990000')\nset tics out nomirror\n"
      << "set multiplot layout " << (has_pressures ? 2 : 1) << ',' << sides.size() << "\n";
  for (const DrawnSide& side : sides) {
    plot_outlines(out, scene, side);
  }
  if (has_pressures) {
    for (const DrawnSide& side : sides) {
      plot_pressure(out, scene, side, axes);
    }
  }
  out << "unset multiplot\n";
  const int columns = std::max(static_cast<int>(sides.size()), 1);
  gnuplot.draw(path, 650 * columns, has_pressures ? 900 : 450);
}

} // namespace driver
