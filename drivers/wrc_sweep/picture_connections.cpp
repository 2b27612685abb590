// Contact-point connection lines: wheel and rail of the centred wheelset drawn apart, and the
// places that touch joined by a line for each lateral position.
#include <algorithm>
#include <cmath>

#include "support/gnuplot.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

struct Outline {
  std::vector<double> y;
  std::vector<double> z;
};

void write_outline(std::ostream& out, const std::string& block, const Outline& outline,
                   double raised) {
  out << block << " << EOD\n";
  for (std::size_t i = 0; i < outline.y.size(); ++i) {
    out << outline.y[i] << ' ' << outline.z[i] + raised << '\n';
  }
  out << "EOD\n";
}

/// One line from the rail to the wheel, with the lateral position as its label.
struct Connection {
  double lateral = 0.0;
  double rail_y = 0.0;
  double rail_z = 0.0;
  double wheel_y = 0.0;
  double wheel_z = 0.0;
};

std::vector<Connection> connections_of(const PictureRequest& picture, const PictureData& data,
                                       const Scene& centred, const std::string& side) {
  // A wheel point of profile coordinates s, w, at its place on the centred wheelset.
  const std::string prefix = side + ".rigid_contact.";
  const double outwards = side == "left" ? 1.0 : -1.0;
  const double taping_y =
      centred.number(prefix + "y") - outwards * centred.number(prefix + "s_wheel");
  const double taping_z = centred.number(prefix + "z") + centred.number(prefix + "w_wheel");
  std::vector<Connection> all;
  for (const double lateral : places_of(picture, data)) {
    Values where = picture.where;
    where.insert_or_assign(picture.x, lateral);
    const std::int64_t scene = data.find(where);
    if (scene < 0) {
      continue;
    }
    const Row row = data.row(scene);
    const auto number = [&](const char* name) { return data.number(row, prefix + name); };
    const Connection connection{lateral, number("y"), number("z"),
                                taping_y + outwards * number("s_wheel"),
                                taping_z - number("w_wheel")};
    if (!std::isnan(connection.wheel_y)) {
      all.push_back(connection);
    }
  }
  return all;
}

void plot_side(std::ostream& out, const PictureRequest& picture, const PictureData& data,
               const Scene& centred, const std::string& side) {
  constexpr double raised = 30.0; // mm, the wheel above its place
  const Outline rail{centred.field(side + ".rail_y"), centred.field(side + ".rail_z")};
  const Outline wheel{centred.field(side + ".wheel_y"), centred.field(side + ".wheel_z")};
  write_outline(out, "$rail_" + side, rail, 0.0);
  write_outline(out, "$wheel_" + side, wheel, raised);
  const std::vector<Connection> all = connections_of(picture, data, centred, side);
  out << "$lines_" << side << " << EOD\n";
  for (const Connection& line : all) {
    out << line.rail_y << ' ' << line.rail_z << '\n'
        << line.wheel_y << ' ' << line.wheel_z + raised << "\n\n";
  }
  out << "EOD\n$labels_" << side << " << EOD\n";
  // Labels where there is room for them along the wheel.
  constexpr double room = 4.5; // mm
  double last = 1e9;
  for (const Connection& line : all) {
    if (std::abs(line.wheel_y - last) >= room || line.lateral == 0.0) {
      out << line.wheel_y << ' ' << line.wheel_z + raised << ' ' << text_of(line.lateral) << '\n';
      last = line.wheel_y;
    }
  }
  out << "EOD\n";
  const double y = side == "left" ? 750.0 : -750.0;
  const auto [low, high] = std::minmax_element(wheel.y.begin(), wheel.y.end());
  const double middle = all.empty() ? y : 0.5 * (*low + *high);
  constexpr double half_width = 55.0;
  out << "set title '" << side << " wheel, seen in driving direction; the wheel is drawn " << raised
      << " mm above its place'\nset xlabel 'track y, mm (to the left)'\nset ylabel 'track z, mm'\n"
      << "set xrange [" << middle + half_width << ':' << middle - half_width
      << "]\nset yrange [-25:60]\nset size ratio -1\n"
      << "plot $lines_" << side
      << " with lines lw 1.5 lc rgb '#d55e00' title 'touch each other', $rail_" << side
      << " with lines lw 2 lc rgb '#8b5a2b' title 'rail', $wheel_" << side
      << " with lines lw 2 lc rgb '#1f4e9e' title 'wheel', $labels_" << side
      << " using 1:2:3 with labels offset 0,0.8 font ',8' title ''\n";
}

} // namespace

void draw_connections(const PictureRequest& picture, const PictureData& data,
                      const std::filesystem::path& path) {
  Scene centred;
  const Study& study = data.study();
  Values where = picture.where;
  where.insert_or_assign(picture.x, data.values_of(picture.x).front());
  const std::int64_t first = data.find(where);
  study.apply(std::max<std::int64_t>(first, 0), centred);
  centred.set("pose.lateral", 0.0);
  centred.set("load.vertical", 0.0); // the geometry alone
  centred.solve();
  Gnuplot gnuplot;
  std::ostream& out = gnuplot.script();
  out << multiplot(1, picture.sides.size(), picture.title)
      << "set grid back lt 1 lw 1 lc rgb '#e4e4e4'\nset tics out nomirror\n"
      << "set key outside top center horizontal\n";
  for (const std::string& side : picture.sides) {
    plot_side(out, picture, data, centred, side);
  }
  out << "unset multiplot\n";
  gnuplot.draw(path, 720 * static_cast<int>(picture.sides.size()), 680);
}

} // namespace driver
