#include "wrc_case/reports.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"

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

/// At most this number of bytes and three points, whole letters of UTF-8.
std::string shortened(const std::string& text, std::size_t length) {
  if (text.size() <= length) {
    return text;
  }
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
    --length;
  }
  return text.substr(0, length) + "...";
}

/// Warnings as lines of text at the lower end of the picture, and the room for them.
struct WarningNote {
  WarningNote(std::vector<std::string> warnings, std::size_t columns) {
    constexpr std::size_t most_lines = 6;
    constexpr std::size_t letters = 100; // in the width of a column
    const std::size_t count = warnings.size();
    if (count > most_lines) {
      warnings.resize(most_lines - 1);
      warnings.push_back("and " + std::to_string(count - warnings.size()) + " more warnings");
    }
    lines = static_cast<int>(warnings.size());
    int from_below = lines;
    for (const std::string& warning : warnings) {
      --from_below;
      labels += "set label " + std::to_string(first_label + from_below) + ' ' +
                gnuplot_text(shortened(one_line(warning), letters * columns)) +
                " at screen 0.006,character " + general(0.8 + line_height * from_below) +
                " left font ',9' tc rgb '#b00000' front\n";
    }
  }
  /// Before the first plot of the last row.
  [[nodiscard]] std::string begin() const {
    return lines == 0 ? "" : labels + "set bmargin " + general(4.3 + line_height * lines) + '\n';
  }
  /// Behind that plot: others would draw the text again.
  [[nodiscard]] std::string end() const {
    std::string commands;
    for (int i = 0; i < lines; ++i) {
      commands += "unset label " + std::to_string(first_label + i) + '\n';
    }
    return commands;
  }
  /// Pixels.
  [[nodiscard]] int height() const { return 18 * lines; }

  static constexpr double line_height = 1.1; ///< in letters
  static constexpr int first_label = 9000;   ///< of numbers that no other label has
  int lines = 0;
  std::string labels;
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

  std::vector<std::string> areas;  ///< blocks: x, y, half sizes and colour of the elements
  std::vector<std::string> arrows; ///< blocks: x, y, traction to the left and forward
  double largest_traction = 0.0;
  double arrow_step = 0.0; ///< between arrows, mm

  std::string block;         ///< of data
  bool has_contours = false; ///< lines of equal pressure; none on a grid of one row or column
  [[nodiscard]] std::string contours() const { return block + "_contours"; }
  [[nodiscard]] std::string label() const {
    return force_text(force) + ", " + fixed(1e3 * angle, 1) + " mrad";
  }
};

struct DrawnSide {
  std::string name;
  std::string rail; ///< blocks of data
  std::string wheel;
  std::vector<DrawnPatch> patches; ///< from right to left
  Range across;                    ///< of all contacts, developed
  Range along;
};

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
void write_pressure(Gnuplot& gnuplot, const Scene& scene, DrawnPatch& patch) {
  const std::string& prefix = patch.name.prefix;
  const auto x = scene.field(prefix + "x");
  const auto y = scene.field(prefix + "y");
  const auto z = scene.field(prefix + "z");
  const auto pressure = scene.field(prefix + "pressure");
  const double half_width = 0.5 * scene.number(prefix + "element_size.lateral");
  const double half_length = 0.5 * scene.number(prefix + "element_size.longitudinal");
  const auto length = static_cast<std::size_t>(scene.number(prefix + "grid.longitudinal"));
  std::ostringstream data;
  data.precision(9);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double lateral =
        (y[i] - patch.y) * std::cos(patch.angle) + (z[i] - patch.z) * std::sin(patch.angle);
    data << lateral << ' ' << x[i] << ' ';
    if (pressure[i] > 0.0) {
      data << pressure[i] << '\n';
      patch.lateral.include(lateral - half_width);
      patch.lateral.include(lateral + half_width);
      patch.longitudinal.include(x[i] - half_length);
      patch.longitudinal.include(x[i] + half_length);
    } else {
      data << "NaN\n";
    }
    data << ((i + 1) % length == 0 ? "\n" : "");
  }
  patch.block = gnuplot.block(data.str());
  patch.has_contours =
      length > 1 && x.size() > length && *std::max_element(pressure.begin(), pressure.end()) > 0.0;
}

constexpr const char* adhesion_colour = "0xcfe2f3";
constexpr const char* slip_colour = "0xf6c7b6";

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
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!(pressure[i] > 0.0)) {
        continue;
      }
      const double lateral =
          (y[i] - patch.y) * std::cos(patch.angle) + (z[i] - patch.z) * std::sin(patch.angle);
      const double traction = std::hypot(along[i], across[i]);
      constexpr double on_bound = 1.0 - 1e-6;
      const bool slips = traction >= on_bound * friction * pressure[i];
      patch.largest_traction = std::max(patch.largest_traction, traction);
      areas << lateral << ' ' << x[i] << ' ' << half_width << ' ' << half_length << ' '
            << (slips ? slip_colour : adhesion_colour) << '\n';
      if ((i / columns) % row_step == row_step / 2 &&
          (i % columns) % column_step == column_step / 2) {
        arrows << lateral << ' ' << x[i] << ' ' << across[i] << ' ' << along[i] << '\n';
      }
    }
    patch.arrow_step = std::max({patch.arrow_step, 2.0 * half_width * static_cast<double>(row_step),
                                 2.0 * half_length * static_cast<double>(column_step)});
    patch.areas.push_back(gnuplot.block(areas.str()));
    patch.arrows.push_back(gnuplot.block(arrows.str()));
  }
}

/// Lines at fifths of the largest pressure of the side, as a block of data.
void write_contours(std::ostream& out, const DrawnPatch& patch, double largest) {
  out << "set contour base\nunset surface\nset cntrparam levels discrete ";
  for (int fifth = 1; fifth < 5; ++fifth) {
    out << (fifth > 1 ? "," : "") << 0.2 * fifth * largest;
  }
  out << "\nset table " << patch.contours() << "\nsplot " << patch.block
      << " using 1:2:3 with lines\nunset table\nunset contour\nset surface\n";
}

DrawnSide write_side(Gnuplot& gnuplot, const Scene& scene, const std::string& name) {
  const auto outline = [&](const std::string& body) {
    return gnuplot.block(scene.field(name + '.' + body + "_y"),
                         scene.field(name + '.' + body + "_z"));
  };
  DrawnSide side;
  side.name = name;
  side.rail = outline("rail");
  side.wheel = outline("wheel");
  for (const PatchName& patch : patches_of(scene, name)) {
    const auto number = [&](const char* value) { return scene.number(patch.prefix + value); };
    DrawnPatch& drawn = side.patches.emplace_back();
    drawn.name = patch;
    drawn.y = number("y");
    drawn.z = number("z");
    drawn.angle = number("plane_angle");
    drawn.force = number("normal_force");
    write_pressure(gnuplot, scene, drawn);
    write_tractions(gnuplot, scene, drawn);
    if (drawn.has_contours) {
      write_contours(gnuplot.script(), drawn, scene.number(name + ".pmax"));
    }
  }
  develop(side);
  return side;
}

/// Profiles, the planes of the patches and the forces on the wheel along their normals.
void plot_outlines(Gnuplot& gnuplot, const Scene& scene, const DrawnSide& side) {
  const double y = scene.number(side.name + ".rigid_contact.y");
  const double z = scene.number(side.name + ".rigid_contact.z");
  constexpr double half_width = 45.0;
  constexpr double below = 26.0;
  constexpr double above = 34.0;
  constexpr double half_plane = 9.0;     // mm, drawn
  constexpr double longest_arrow = 20.0; // mm, of the largest force of this wheel
  constexpr double shortest_arrow = 3.0;
  std::ostream& out = gnuplot.script();
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
  std::vector<DrawnPatch> by_force = side.patches;
  std::sort(by_force.begin(), by_force.end(), [](const DrawnPatch& one, const DrawnPatch& other) {
    return one.name.index < other.name.index;
  });
  std::vector<std::string> items{side.rail + " with filledcurves y=" + general(z - 2.0 * below, 9) +
                                     " fs solid fc rgb '#f3ebe3' notitle",
                                 side.wheel +
                                     " with filledcurves y=" + general(z + 2.0 * above, 9) +
                                     " fs solid fc rgb '#e9eff8' notitle",
                                 side.rail + " with lines lw 2 lc rgb '#8b5a2b' title 'rail'",
                                 side.wheel + " with lines lw 2 lc rgb '#1f4e9e' title 'wheel'"};
  for (const DrawnPatch& patch : by_force) {
    const double dy = half_plane * std::cos(patch.angle);
    const double dz = half_plane * std::sin(patch.angle);
    items.push_back(gnuplot.block({patch.y - dy, patch.y + dy}, {patch.z - dz, patch.z + dz}) +
                    " with lines lw 3 lc rgb '" + colour_of(patch.name.index) + "' title 'patch " +
                    std::to_string(patch.name.index) + ": " + patch.label() + '\'');
  }
  items.push_back(gnuplot.block({y}, {z}) +
                  " with points pt 6 ps 1.2 lw 2 lc rgb 'black' title 'first touch'");
  gnuplot.plot(items);
  out << "unset arrow\n";
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
void plot_pressure(Gnuplot& gnuplot, const Scene& scene, const DrawnSide& side,
                   const PressureAxes& axes) {
  std::ostream& out = gnuplot.script();
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
  std::vector<std::string> items;
  std::vector<double> centres;
  std::vector<double> along;
  for (const DrawnPatch& patch : side.patches) {
    const std::string shifted = " using ($1+(" + general(patch.across, 9) + ")):2";
    items.push_back(patch.block + shifted + ":3 with image");
    if (patch.has_contours) {
      items.push_back(patch.contours() + shifted + " with lines lc rgb '#404040' lw 0.8");
    }
    const auto centroid = [&](const char* name) {
      return scene.number(patch.name.prefix + "centroid." + name);
    };
    centres.push_back(patch.across + (centroid("y") - patch.y) * std::cos(patch.angle) +
                      (centroid("z") - patch.z) * std::sin(patch.angle));
    along.push_back(centroid("x"));
  }
  items.push_back(gnuplot.block(centres, along) + " with points pt 2 ps 1 lw 1.5 lc rgb 'black'");
  gnuplot.plot(items);
  out << "unset label\n";
}

/// The tractions of all patches of a side as arrows, on areas of slip and adhesion.
void plot_tractions(Gnuplot& gnuplot, const Scene& scene, const DrawnSide& side,
                    const PressureAxes& axes) {
  std::ostream& out = gnuplot.script();
  double largest = 0.0;
  double step = 0.0;
  for (const DrawnPatch& patch : side.patches) {
    largest = std::max(largest, patch.largest_traction);
    step = std::max(step, patch.arrow_step);
  }
  out << "set xrange [" << side.across.middle() + 0.5 * axes.width << ':'
      << side.across.middle() - 0.5 * axes.width << "]\nset yrange ["
      << side.along.middle() - 0.5 * axes.length << ':' << side.along.middle() + 0.5 * axes.length
      << "]\nset size ratio -1\n";
  if (!(largest > 0.0)) {
    out << "set title '" << side.name << " wheel: no tractions'\nplot NaN notitle\n";
    return;
  }
  double along = 0.0;
  double across = 0.0;
  for (const DrawnPatch& patch : side.patches) {
    const auto number = [&](const char* name) { return scene.number(patch.name.prefix + name); };
    if (!patch.areas.empty()) {
      along += number("creep_force.longitudinal");
      across += number("creep_force.lateral");
    }
  }
  out << "set title 'tractions on the wheel: " << fixed(1e-3 * along, 2) << " kN forward, "
      << fixed(1e-3 * across, 2) << " kN to the left, at most " << fixed(largest, 0)
      << " MPa'\nset xlabel 'along the planes of the patches, mm (to the left)'\n"
      << "set ylabel 'track x, mm (forward)'\nset key top right opaque width 1\n";
  std::vector<std::string> items;
  for (const DrawnPatch& patch : side.patches) {
    const std::string place = "($1+(" + general(patch.across, 9) + ")):2";
    for (const std::string& block : patch.areas) {
      items.push_back(block + " using " + place +
                      ":3:4:5 with boxxyerror fs solid noborder lc rgb variable notitle");
    }
  }
  // Arrows of neighbours touch where the traction is largest.
  const double scale = 1.2 * step / largest;
  for (const DrawnPatch& patch : side.patches) {
    const std::string place = "($1+(" + general(patch.across, 9) + ")):2";
    for (const std::string& block : patch.arrows) {
      items.push_back(block + " using " + place + ":(" + general(scale, 9) + "*$3):(" +
                      general(scale, 9) +
                      "*$4) with vectors head size screen 0.004,20 lc rgb '#303030' lw 1 notitle");
    }
  }
  items.push_back(std::string("NaN with boxes fs solid lc rgb ") + adhesion_colour +
                  " title 'adhesion'");
  items.push_back(std::string("NaN with boxes fs solid lc rgb ") + slip_colour + " title 'slip'");
  gnuplot.plot(items);
}

} // namespace

void draw_scene(const Scene& scene, const std::filesystem::path& path,
                const std::vector<std::string>& warnings) {
  Gnuplot gnuplot;
  const bool has_pressures = scene.get_text("solve.until") == "mechanics";
  std::vector<DrawnSide> sides;
  PressureAxes axes;
  for (const std::string& name : sides_of(scene)) {
    DrawnSide& side = sides.emplace_back(write_side(gnuplot, scene, name));
    if (!has_pressures) {
      side.patches.clear();
    }
    axes.include(side);
  }
  gnuplot.script() << "set grid lc rgb '#dddddd'\nset tics out nomirror\n" << pressure_palette;
  const bool has_tractions = std::any_of(sides.begin(), sides.end(), [](const DrawnSide& side) {
    return std::any_of(side.patches.begin(), side.patches.end(),
                       [](const DrawnPatch& patch) { return !patch.areas.empty(); });
  });
  const bool has_stresses = std::any_of(sides.begin(), sides.end(), [&](const DrawnSide& side) {
    return !parts_with(scene, patches_of(scene, side.name), stress_result).empty();
  });
  const std::size_t rows =
      1U + (has_pressures ? 1U : 0U) + (has_tractions ? 1U : 0U) + (has_stresses ? 1U : 0U);
  gnuplot.begin_multiplot(rows, sides.size());
  const WarningNote note(warnings, std::max<std::size_t>(sides.size(), 1));
  std::size_t row = 0;
  const auto plot_row = [&](const auto& plot_side) {
    ++row;
    bool noted = row < rows;
    for (const DrawnSide& side : sides) {
      gnuplot.script() << (noted ? "" : note.begin());
      plot_side(side);
      gnuplot.script() << (noted ? "" : note.end());
      noted = true;
    }
  };
  plot_row([&](const DrawnSide& side) { plot_outlines(gnuplot, scene, side); });
  if (has_pressures) {
    plot_row([&](const DrawnSide& side) { plot_pressure(gnuplot, scene, side, axes); });
  }
  if (has_tractions) {
    plot_row([&](const DrawnSide& side) { plot_tractions(gnuplot, scene, side, axes); });
  }
  if (has_stresses) {
    plot_row([&](const DrawnSide& side) { plot_stress(gnuplot, scene, side.name); });
  }
  const int columns = std::max(static_cast<int>(sides.size()), 1);
  gnuplot.draw(path, 650 * columns, 450 * static_cast<int>(rows) + note.height());
}

} // namespace driver
