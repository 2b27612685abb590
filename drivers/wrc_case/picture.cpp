#include "wrc_case/picture.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "support/gnuplot.hpp"

namespace driver {
namespace {

std::string rounded(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

void write_outline(std::ostream& out, const std::string& block, const std::vector<double>& y,
                   const std::vector<double>& z) {
  out << '$' << block << " << EOD\n";
  for (std::size_t i = 0; i < y.size(); ++i) {
    out << y[i] << ' ' << z[i] << '\n';
  }
  out << "EOD\n";
}

/// Pressure over the distances across and along the patch, from its largest patch's centre.
void write_pressure(std::ostream& out, const Scene& scene, const std::string& side) {
  const auto x = scene.field(side + ".x");
  const auto y = scene.field(side + ".y");
  const auto pressure = scene.field(side + ".pressure");
  const double cosine = std::cos(scene.number(side + ".angle"));
  const double centre_x = scene.number_or(side + ".patches.0.x", 0.0);
  const double centre_y = scene.number_or(side + ".patches.0.y", 0.0);
  const auto length = static_cast<std::size_t>(scene.number(side + ".grid.1"));
  out << '$' << side << "_pressure << EOD\n";
  for (std::size_t i = 0; i < x.size(); ++i) {
    out << (y[i] - centre_y) / cosine << ' ' << x[i] - centre_x << ' ';
    if (pressure[i] > 0.0) {
      out << pressure[i] << '\n';
    } else {
      out << "NaN\n";
    }
    if ((i + 1) % length == 0) {
      out << '\n';
    }
  }
  out << "EOD\n";
}

void plot_outlines(std::ostream& out, const Scene& scene, const std::string& side) {
  const double y = scene.number(side + ".rigid_contact.y");
  const double z = scene.number(side + ".rigid_contact.z");
  constexpr double half_width = 45.0;
  out << "set title '" << side << " wheel: angle "
      << rounded(1e3 * scene.number(side + ".angle"), 1) << " mrad, s_{wheel} "
      << rounded(scene.number(side + ".rigid_contact.s_wheel"), 2) << " mm'\n"
      << "set xlabel 'track y, mm (to the left)'\nset ylabel 'track z, mm'\n"
      << "set size ratio -1\nset xrange [" << y + half_width << ':' << y - half_width
      << "]\nset yrange [" << z - 30.0 << ':' << z + 25.0 << "]\n"
      << "plot $" << side << "_rail with lines lw 2 lc rgb '#8b4513' title 'rail', $" << side
      << "_wheel with lines lw 2 lc rgb '#1f4e9e' title 'wheel', '-' with points pt 7 ps 0.8 lc "
         "rgb '#d00000' title 'rigid contact'\n"
      << y << ' ' << z << "\nEOF\n";
}

void plot_pressure(std::ostream& out, const Scene& scene, const std::string& side) {
  if (scene.count_of(side + ".patches") == 0) {
    out << "set title '" << side << " wheel: no contact'\nset xrange [-1:1]\nset yrange [-1:1]\n"
        << "plot NaN notitle\n";
    return;
  }
  out << "set title 'p_{max} " << rounded(scene.number(side + ".pmax"), 0) << " MPa, area "
      << rounded(scene.number(side + ".area"), 1) << " mm^2, force "
      << rounded(1e-3 * scene.number(side + ".normal_force"), 2) << " kN'\n"
      << "set xlabel 'across the patch, mm (to the left)'\n"
      << "set ylabel 'along the rail, mm (forward)'\nset cblabel 'pressure, MPa'\n"
      << "set size ratio -1\nset xrange [*:*] reverse\nset yrange [*:*] noreverse\n"
      << "set cbrange [0:" << scene.number(side + ".pmax") << "]\n"
      << "plot $" << side << "_pressure using 1:2:3 with image notitle\n";
}

} // namespace

void draw_scene(const Scene& scene, const std::filesystem::path& path) {
  Gnuplot gnuplot;
  std::ostream& out = gnuplot.script();
  const auto sides = scene.sides();
  for (const std::string& side : sides) {
    write_outline(out, side + "_rail", scene.field(side + ".rail_y"),
                  scene.field(side + ".rail_z"));
    write_outline(out, side + "_wheel", scene.field(side + ".wheel_y"),
                  scene.field(side + ".wheel_z"));
    if (scene.count_of(side + ".patches") > 0) {
      write_pressure(out, scene, side);
    }
  }
  out << "set grid lc rgb '#dddddd'\nset key top right\n"
         "set palette defined (0 '#e8f0ff', 0.25 '#6fa8dc', 0.5 '#3d85c6', 0.7 '#f1c232', 0.85 "
         "'#e69138', 1 '#990000')\nset tics out nomirror\n"
      << "set multiplot layout 2," << sides.size() << "\n";
  for (const std::string& side : sides) {
    plot_outlines(out, scene, side);
  }
  for (const std::string& side : sides) {
    plot_pressure(out, scene, side);
  }
  out << "unset multiplot\n";
  const int columns = std::max(static_cast<int>(sides.size()), 1);
  gnuplot.draw(path, 650 * columns, 900);
}

} // namespace driver
