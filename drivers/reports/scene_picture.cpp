#include "reports/scene_picture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "reports/drawn_sides.hpp"
#include "reports/patches.hpp"
#include "reports/stress_picture.hpp"
#include "reports/warning_summary.hpp"
#include "support/gnuplot.hpp"
#include "support/numbers.hpp"

namespace driver {
namespace {

/// Of a patch.
std::string colour_of(int index) {
  return index == 0 ? colour::marked : line_colour(static_cast<std::size_t>(index) + 1);
}

/// With three digits, in N or kN.
std::string force_text(double newtons) {
  const bool thousands = newtons >= 1000.0;
  const double value = thousands ? 1e-3 * newtons : newtons;
  const int decimals = value < 10.0 ? 2 : value < 100.0 ? 1 : 0;
  return fixed(value, decimals) + (thousands ? " kN" : " N");
}

std::string angle_text(double radians) {
  return fixed(1e3 * radians, 1) + " mrad";
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
  WarningNote(const std::vector<Warning>& of_scene, std::size_t columns) {
    std::vector<std::string> warnings = lines_of(of_scene);
    const bool loud = grade_of(of_scene) == WRC_DO_NOT_USE;
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
                " left tc rgb '" + (loud ? colour::marked : colour::note) + "' front\n";
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

/// What the outlines show: the surroundings of the first touch, and all patches.
struct OutlineFrame {
  OutlineFrame(double touch_y, double touch_z, const DrawnSide& side) {
    constexpr double beside = 45.0; // mm around the first touch
    constexpr double below = 26.0;
    constexpr double above = 34.0;
    constexpr double room = 15.0; // mm around the reference of a patch
    for (const double sign : {-1.0, 1.0}) {
      y.include(touch_y + sign * beside);
      for (const DrawnPatch& patch : side.patches) {
        y.include(patch.y + sign * room);
        z.include(patch.z + sign * room);
      }
    }
    z.include(touch_z - below);
    z.include(touch_z + above);
    // As high as its panel, with the room on top, where arrows and legend are.
    z.greatest = std::max(z.greatest, z.least + y.length() * (below + above) / (2.0 * beside));
    scale = y.length() / (2.0 * beside);
  }
  Range y;
  Range z;
  double scale = 1.0; ///< of lengths to those of a frame without distant patches
};

/// Profiles, the planes of the patches and the forces on the wheel, from their centroids. `first`:
/// the legend names the lines, too. It is on the field side: forces lean to
/// the other one.
void plot_outlines(Gnuplot& gnuplot, const Scene& scene, const DrawnSide& side, bool first) {
  const double y = scene.number(side.name + ".rigid_contact.y");
  const double z = scene.number(side.name + ".rigid_contact.z");
  const OutlineFrame frame(y, z, side);
  const double half_plane = 9.0 * frame.scale;     // mm, drawn
  const double longest_arrow = 14.0 * frame.scale; // mm, of the largest force of this wheel
  const double shortest_arrow = 3.0 * frame.scale;
  std::ostream& out = gnuplot.script();
  out << "set title '" << side.name << " wheel, seen in driving direction'\n"
      << "set xlabel 'track y, mm (to the left)'\nset ylabel 'track z, mm'\n"
      << "set size ratio -1\nset key top " << (side.name == "left" ? "left" : "right")
      << " Left reverse samplen 2 opaque width -2\n"
      << "set xrange [" << frame.y.greatest << ':' << frame.y.least << "]\nset yrange ["
      << frame.z.least << ':' << frame.z.greatest << "]\n";
  double largest = 0.0;
  for (const DrawnPatch& patch : side.patches) {
    largest = std::max(largest, patch.force);
  }
  for (const DrawnPatch& patch : side.patches) {
    const double length = std::max(longest_arrow * patch.force / largest, shortest_arrow);
    out << "set arrow from " << patch.centroid_y << ',' << patch.centroid_z << " rto "
        << -length * std::sin(patch.force_angle) << ',' << length * std::cos(patch.force_angle)
        << " front lw 2 lc rgb '" << colour_of(patch.name.index)
        << "' head filled size screen 0.012,18\n";
  }
  std::vector<DrawnPatch> by_force = side.patches;
  std::sort(by_force.begin(), by_force.end(), [](const DrawnPatch& one, const DrawnPatch& other) {
    return one.name.index < other.name.index;
  });
  const auto title = [first](const char* text) {
    return " title '" + std::string(first ? text : "") + '\'';
  };
  std::vector<std::string> items{
      side.rail + " with filledcurves y=" + general(frame.z.least - frame.z.length(), 9) +
          " fs solid fc rgb '" + colour::rail_body + "' notitle",
      side.wheel + " with filledcurves y=" + general(frame.z.greatest + frame.z.length(), 9) +
          " fs solid fc rgb '" + colour::wheel_body + "' notitle",
      side.rail + " with lines lw 2 lc rgb '" + colour::rail + '\'' + title("rail"),
      side.wheel + " with lines lw 2 lc rgb '" + colour::wheel + '\'' + title("wheel")};
  for (const DrawnPatch& patch : by_force) {
    const double dy = half_plane * std::cos(patch.plane_angle);
    const double dz = half_plane * std::sin(patch.plane_angle);
    items.push_back(gnuplot.block({patch.y - dy, patch.y + dy}, {patch.z - dz, patch.z + dz}) +
                    " with lines lw 3 lc rgb '" + colour_of(patch.name.index) + "' title 'patch " +
                    std::to_string(patch.name.index) + ": " + force_text(patch.force) + ", " +
                    angle_text(patch.force_angle) + '\'');
  }
  items.push_back(gnuplot.block({y}, {z}) + " with points pt 6 ps 1.2 lw 2 lc rgb 'black'" +
                  title("first touch"));
  gnuplot.plot(items);
  out << "unset arrow\n";
}

/// The axes of pressures and tractions, mm: the same scale for all sides taken in.
class PatchAxes {
public:
  /// A panel beside another, with room for the labels around its patches.
  PatchAxes() = default;
  /// The only panel of a row, without labels.
  static PatchAxes of_row() {
    PatchAxes axes;
    axes.width_to_length_ = 3.4;
    axes.share_along_ = 0.85;
    return axes;
  }

  void include(const DrawnSide& side) {
    width_ = std::max({width_, side.across.length() / share_across_,
                       side.along.length() / share_along_ * width_to_length_});
  }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double length() const { return width_ / width_to_length_; }

private:
  double width_ = 0.0;
  double width_to_length_ = 1.5;
  double share_across_ = 0.78; ///< of the patches in the width
  double share_along_ = 0.62;
};

/// A distance between ticks, at least the given one: 1, 2 or 5 times a power of ten.
double tick_distance(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

/// The lateral axis of a side. Where gaps are shortened, its ticks are those of the patches beside
/// them; two lines and the length left out mark the gap.
void write_axes(std::ostream& out, const DrawnSide& side, const PatchAxes& axes) {
  const double right = side.across.middle() - 0.5 * axes.width();
  const double left = side.across.middle() + 0.5 * axes.width();
  out << "set size ratio -1\nset xrange [" << left << ':' << right << "]\nset yrange ["
      << side.along.middle() - 0.5 * axes.length() << ':'
      << side.along.middle() + 0.5 * axes.length()
      << "]\nset xlabel 'along the planes of the patches, mm (to the left)'\n"
      << "set ylabel 'track x, mm (forward)'\n";
  if (side.gaps.empty()) {
    return;
  }
  constexpr double most_ticks = 10.0;
  const double step = tick_distance(axes.width() / most_ticks);
  const double half_break = 0.012 * axes.width();
  std::string ticks; // + 0.0: no -0
  double begin = right;
  for (std::size_t i = 0; i <= side.gaps.size(); ++i) {
    const bool last = i == side.gaps.size();
    const double end = last ? left : side.gaps[i].middle - 2.0 * half_break;
    // Patches between two shortened gaps have the same shift.
    const auto patch = std::find_if(side.patches.begin(), side.patches.end(),
                                    [begin](const DrawnPatch& one) { return one.across > begin; });
    if (patch != side.patches.end()) {
      const double shift = patch->developed - patch->across;
      for (double tick = std::ceil((begin + shift) / step); tick * step <= end + shift; ++tick) {
        ticks += (ticks.empty() ? "'" : ",'") + general(tick * step + 0.0) + "' " +
                 general(tick * step - shift, 9);
      }
    }
    if (!last) {
      const double middle = side.gaps[i].middle;
      for (const double sign : {-1.0, 1.0}) {
        const double place = middle + sign * half_break;
        out << "set arrow from " << place << ", graph 0 to " << place
            << ", graph 1 nohead dt 2 lw 1.5 lc rgb '" << colour::quiet << "'\n";
      }
      out << "set label '" << fixed(side.gaps[i].left_out, 0) << " mm left out' at "
          << middle + 3.0 * half_break << ", graph 0.5 center rotate by 90 tc rgb '" << colour::note
          << "'\n";
      begin = middle + 2.0 * half_break;
    }
  }
  out << "set xtics (" << ticks << ")\n";
}

/// Before the axes of the next side.
void end_axes(std::ostream& out) {
  out << "unset label\nunset arrow\nset xtics autofreq\n";
}

/// The pressures of all patches of a side over the developed lateral coordinate.
void plot_pressure(Gnuplot& gnuplot, const Scene& scene, const DrawnSide& side,
                   const PatchAxes& axes) {
  std::ostream& out = gnuplot.script();
  if (side.patches.empty()) {
    out << "set title '" << side.name << " wheel: no contact'\nset xrange [-1:1]\n"
        << "set yrange [-1:1]\nplot NaN notitle\n";
    return;
  }
  const auto value = [&](const char* name) { return scene.number(side.name + '.' + name); };
  const double pmax =
      value("pmax"); // not-a-number where an end of a body leaves it without a bound
  const bool is_bounded = std::isfinite(pmax);
  const double elastic = value("pmax_elastic"); // more than pmax where steel yields
  out << "set title 'p_{max} " << (is_bounded ? fixed(pmax, 0) + " MPa" : "without bound")
      << (elastic > pmax ? " (elastic " + fixed(elastic, 0) + ")" : std::string()) << ", area "
      << fixed(value("area"), 1) << " mm^2, vertical " << force_text(value("vertical_force"))
      << "'\nset cblabel 'pressure, MPa' offset 1\nset key off\nset cbrange [0:"
      << (is_bounded ? general(pmax) : "*") << "]\n";
  write_axes(out, side, axes);
  // Labels of neighbours stand above and below in turn.
  bool above = true;
  for (const DrawnPatch& patch : side.patches) {
    const double end = above ? patch.longitudinal.greatest : patch.longitudinal.least;
    out << "set label \"patch " << patch.name.index << "\\n"
        << force_text(patch.force) << "\\n"
        << angle_text(patch.force_angle) << "\" at " << patch.across + patch.lateral.middle() << ','
        << end << " center offset 0," << (above ? 2.9 : -1.1) << " tc rgb '"
        << colour_of(patch.name.index) << "' front\n";
    above = !above;
  }
  std::vector<std::string> items;
  for (const DrawnPatch& patch : side.patches) {
    const std::string shifted = " using ($1+(" + general(patch.across, 9) + ")):2";
    items.push_back(patch.block + shifted + ":($3 > 0 ? $3 : NaN) with image");
    if (patch.has_contours) {
      items.push_back(patch.contours() + shifted + " with lines lw 0.8 lc rgb '" + colour::contour +
                      '\'');
    }
  }
  gnuplot.plot(items);
  end_axes(out);
}

/// Lengths of the arrows of tractions, the same for all sides taken in.
class ArrowScale {
public:
  void include(const DrawnSide& side) {
    for (const DrawnPatch& patch : side.patches) {
      largest_ = std::max(largest_, patch.largest_traction);
      step_ = std::max(step_, patch.arrow_step);
    }
  }
  /// mm for each MPa: arrows of neighbours touch where the traction is largest.
  [[nodiscard]] double length() const { return 1.2 * step_ / largest_; }
  /// A round traction that the legend shows, MPa.
  [[nodiscard]] double shown() const { return tick_distance(0.4 * largest_); }

private:
  double largest_ = 0.0;
  double step_ = 0.0;
};

/// The tractions of all patches of a side as arrows, on areas of slip and adhesion.
void plot_tractions(Gnuplot& gnuplot, const Scene& scene, const DrawnSide& side,
                    const PatchAxes& axes, const ArrowScale& arrows) {
  std::ostream& out = gnuplot.script();
  double largest = 0.0;
  for (const DrawnPatch& patch : side.patches) {
    largest = std::max(largest, patch.largest_traction);
  }
  write_axes(out, side, axes);
  const double begin = side.across.middle() + 0.46 * axes.width();
  const double end = begin - arrows.length() * arrows.shown();
  const double height = side.along.middle() + 0.43 * axes.length();
  constexpr double between = 0.015; // of the width, between arrow and text
  out << "set arrow from " << begin << ',' << height << " to " << end << ',' << height
      << " head size screen 0.004,20 lc rgb '" << colour::arrow << "' lw 1 front\nset label '"
      << general(arrows.shown()) << " MPa' at " << end - between * axes.width() << ',' << height
      << " left front\n";
  double along = 0.0;
  double across = 0.0;
  for (const DrawnPatch& patch : side.patches) {
    const auto number = [&](const char* name) { return scene.number(patch.name.prefix + name); };
    if (!patch.areas.empty()) {
      along += number("creep_force.longitudinal");
      across += number("creep_force.lateral");
    }
  }
  out << "set title 'tractions on the " << side.name << " wheel: " << fixed(1e-3 * along, 2)
      << " kN forward, " << fixed(1e-3 * across, 2) << " kN to the left, at most "
      << fixed(largest, 0) << " MPa'\nset key top right opaque width 1\n";
  std::vector<std::string> items;
  for (const DrawnPatch& patch : side.patches) {
    const std::string place = "($1+(" + general(patch.across, 9) + ")):2";
    for (const std::string& block : patch.areas) {
      items.push_back(block + " using " + place + ":3:4:5:6 with rgbalpha notitle");
    }
  }
  const double scale = arrows.length();
  for (const DrawnPatch& patch : side.patches) {
    const std::string place = "($1+(" + general(patch.across, 9) + ")):2";
    for (const std::string& block : patch.arrows) {
      items.push_back(block + " using " + place + ":(" + general(scale, 9) + "*$3):(" +
                      general(scale, 9) + "*$4) with vectors head size screen 0.004,20 lc rgb '" +
                      colour::arrow + "' lw 1 notitle");
    }
  }
  for (const auto& [name, of] : {std::pair{"adhesion", colour::adhesion}, {"slip", colour::slip}}) {
    items.push_back(std::string("NaN with boxes fs solid lc rgb '") + of + "' title '" + name +
                    '\'');
  }
  gnuplot.plot(items);
  end_axes(out);
}

/// Panels beside each other: of the sides that have something to show.
struct PanelRow {
  PanelRow(const std::vector<DrawnSide>& all, const std::function<bool(const DrawnSide&)>& has,
           std::function<void(const DrawnSide&, bool alone)> plot_side)
      : plot(std::move(plot_side)) {
    for (const DrawnSide& side : all) {
      if (has(side)) {
        sides.push_back(&side);
      }
    }
  }
  std::vector<const DrawnSide*> sides;
  std::function<void(const DrawnSide&, bool alone)> plot; ///< whether alone in its row
};

} // namespace

void draw_scene(const Scene& scene, const std::filesystem::path& path,
                const std::vector<Warning>& warnings) {
  Gnuplot gnuplot;
  const bool has_pressures = scene.get_text("solve.until") == "mechanics";
  std::vector<DrawnSide> sides;
  PatchAxes axes;
  ArrowScale arrows;
  for (const std::string& name : sides_of(scene)) {
    sides.push_back(write_side(gnuplot, scene, name, has_pressures));
    axes.include(sides.back());
    arrows.include(sides.back());
  }
  std::vector<PanelRow> rows;
  rows.emplace_back(
      sides, [](const DrawnSide&) { return true; },
      [&](const DrawnSide& side, bool) {
        plot_outlines(gnuplot, scene, side, side.name == sides.front().name);
      });
  rows.emplace_back(
      sides, [&](const DrawnSide&) { return has_pressures; },
      [&](const DrawnSide& side, bool) { plot_pressure(gnuplot, scene, side, axes); });
  rows.emplace_back(
      sides,
      [](const DrawnSide& side) {
        return std::any_of(side.patches.begin(), side.patches.end(),
                           [](const DrawnPatch& patch) { return patch.largest_traction > 0.0; });
      },
      [&](const DrawnSide& side, bool alone) {
        PatchAxes own = PatchAxes::of_row();
        own.include(side);
        plot_tractions(gnuplot, scene, side, alone ? own : axes, arrows);
      });
  rows.emplace_back(
      sides,
      [&](const DrawnSide& side) {
        return !parts_with(scene, patches_of(scene, side.name), stress_result).empty();
      },
      [&](const DrawnSide& side, bool) { plot_stress(gnuplot, scene, side.name); });
  std::erase_if(rows, [](const PanelRow& row) { return row.sides.empty(); });
  // The same margins in all rows: panels stand below each other.
  gnuplot.script() << map_palette
                   << "set colorbox user origin graph 1.03, graph 0 size graph 0.05, graph 1\nset "
                      "lmargin 9\nset rmargin "
                   << colour_box_margin << '\n';
  // The panels of a single wheel stand side by side.
  const bool beside = sides.size() == 1 && rows.size() > 1;
  const std::size_t columns = beside ? 2 : std::max<std::size_t>(sides.size(), 1);
  const std::size_t lines =
      beside ? (rows.size() + 1) / columns : std::max<std::size_t>(rows.size(), 1);
  gnuplot.begin_multiplot(lines, columns);
  const WarningNote note(warnings, columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const PanelRow& row = rows[i];
    const bool alone = row.sides.size() < sides.size();
    bool noted = i != (lines - 1) * (beside ? columns : 1);
    for (const DrawnSide* side : row.sides) {
      if (alone) { // on the whole row
        gnuplot.script() << "set size 1," << 1.0 / static_cast<double>(rows.size())
                         << "\nset origin 0,"
                         << 1.0 - static_cast<double>(i + 1) / static_cast<double>(rows.size())
                         << '\n';
      }
      gnuplot.script() << (noted ? "" : note.begin());
      row.plot(*side, alone);
      gnuplot.script() << (noted ? "" : note.end());
      noted = true;
    }
    gnuplot.script() << (alone ? "set multiplot next\n" : "");
  }
  gnuplot.draw(path, 650 * static_cast<int>(columns),
               450 * static_cast<int>(lines) + note.height());
}

} // namespace driver
