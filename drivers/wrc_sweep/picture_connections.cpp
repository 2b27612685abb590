// Contact-point connection lines: wheel and rail of the centred wheelset drawn apart, and the
// points that touch joined by a line for each lateral position.
#include <algorithm>
#include <array>
#include <cmath>

#include "support/gnuplot.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

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
  // A wheel point of profile coordinates s, w, in its position on the centred wheelset.
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

/// `has_legend`: one for all sides.
void plot_side(Gnuplot& gnuplot, const PictureRequest& picture, const PictureData& data,
               const Scene& centred, const std::string& side, bool has_legend) {
  constexpr double raised = 30.0; // mm, the wheel above its true position
  const std::vector<double> wheel_y = centred.field(side + ".wheel_y");
  std::vector<double> wheel_z = centred.field(side + ".wheel_z");
  for (double& z : wheel_z) {
    z += raised;
  }
  const std::string rail =
      gnuplot.block(centred.field(side + ".rail_y"), centred.field(side + ".rail_z"));
  const std::string wheel = gnuplot.block(wheel_y, wheel_z);
  const std::vector<Connection> all = connections_of(picture, data, centred, side);
  std::string lines;
  std::string labels;
  std::string leaders; // from the wheel to its label
  // Labels above the wheel: each as low as it meets no other.
  constexpr double room = 4.5;       // mm along a row
  constexpr double row_height = 2.6; // mm
  std::vector<std::array<double, 2>> placed;
  for (const Connection& line : all) {
    const std::string at_wheel = general(line.wheel_y, 9) + ' ' + general(line.wheel_z + raised, 9);
    lines += general(line.rail_y, 9) + ' ' + general(line.rail_z, 9) + '\n' + at_wheel + "\n\n";
    double height = line.wheel_z + raised + 0.5 * row_height;
    const auto meets = [&](const auto& other) {
      constexpr double rounding = 1e-6; // mm
      return std::abs(line.wheel_y - other[0]) < room &&
             std::abs(height - other[1]) < row_height - rounding;
    };
    for (auto other = placed.begin();
         (other = std::find_if(placed.begin(), placed.end(), meets)) != placed.end();) {
      height = (*other)[1] + row_height;
    }
    placed.push_back({line.wheel_y, height});
    const std::string label = general(line.wheel_y, 9) + ' ' + general(height, 9);
    leaders += at_wheel + '\n' + label + "\n\n";
    labels += label + ' ' + text_of(line.lateral) + '\n';
  }
  const double y = side == "left" ? 750.0 : -750.0;
  const auto [low, high] = std::minmax_element(wheel_y.begin(), wheel_y.end());
  const double middle = all.empty() ? y : 0.5 * (*low + *high);
  constexpr double half_width = 55.0;
  gnuplot.script() << "set title '" << side
                   << " wheel, seen in driving direction; the wheel is drawn " << raised
                   << " mm above its place'\nset xlabel 'track y, mm (to the left)'\n"
                   << "set ylabel 'track z, mm'\nset xrange [" << middle + half_width << ':'
                   << middle - half_width << "]\nset yrange [-25:60]\nset size ratio -1\n";
  const auto title = [has_legend](const char* text) {
    return " title '" + std::string(has_legend ? text : "") + '\'';
  };
  gnuplot.plot(
      {gnuplot.block(lines) + " with lines lw 1.5 lc rgb '" + colour::marked + '\'' +
           title("points that touch"),
       rail + " with lines lw 2 lc rgb '" + colour::rail + '\'' + title("rail"),
       wheel + " with lines lw 2 lc rgb '" + colour::wheel + '\'' + title("wheel"),
       gnuplot.block(leaders) + " with lines lw 0.5 lc rgb '" + colour::quiet + "' title ''",
       gnuplot.block(labels) + " using 1:2:3 with labels offset 0,0.4 font ',8' title ''"});
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
  centred.set("load.both", 0.0); // the geometry alone
  centred.solve();
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(1, picture.sides.size(), picture.title);
  gnuplot.script() << "set key at screen 0.5,0.95 center top horizontal maxrows 1\nset tmargin 4\n"
                   << warning_note(data);
  for (const std::string& side : picture.sides) {
    plot_side(gnuplot, picture, data, centred, side, side == picture.sides.front());
    gnuplot.script() << end_of_warning_note();
  }
  gnuplot.draw(path, 720 * static_cast<int>(picture.sides.size()), 680);
}

} // namespace driver
