#include "reports/profile_picture.hpp"

#include <algorithm>
#include <cmath>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"

namespace driver {
namespace {

/// Pixels. Both panels share their left and right edges, so that curvature is drawn below its
/// position.
constexpr double plot_width = 900.0;
constexpr double left_margin = 80.0;
constexpr double right_margin = 30.0;
constexpr double top_margin = 50.0;
constexpr double between = 80.0;
/// Space of the key above the lower panel, between the two, where it covers no curve.
constexpr double key_above = 25.0;
constexpr double curvature_height = 240.0;
constexpr double bottom_margin = 60.0;
/// Room around the profile, relative to its width.
constexpr double room = 0.04;
/// A narrow profile is drawn smaller rather than higher than this, pixels.
constexpr double greatest_height = 1400.0;
/// A kink below this is rounding of a drawing's numbers, rad.
constexpr double least_marked_kink = 1e-3;

std::string block_of(Gnuplot& gnuplot, const std::vector<ProfilePoint>& points) {
  std::ostringstream data;
  data.precision(9);
  for (const ProfilePoint& point : points) {
    data << point.lateral << ' ' << point.height << ' ' << point.curvature << '\n';
  }
  return gnuplot.block(data.str());
}

std::string block_of(Gnuplot& gnuplot, const wrcontact::Profile::Points& points) {
  std::ostringstream data;
  data.precision(9);
  for (std::size_t i = 0; i < points.lateral.size(); ++i) {
    data << points.lateral[i] << ' ' << points.height[i] << '\n';
  }
  return gnuplot.block(data.str());
}

/// The points that were read, and those that cleaning removed; none of a built-in profile.
void add_points(Gnuplot& gnuplot, const Profile& profile, std::vector<std::string>& shapes) {
  const auto add = [&](std::int32_t which, const std::string& style, const std::string& title) {
    const auto points = profile.points(which);
    if (!points.lateral.empty()) {
      shapes.push_back(block_of(gnuplot, points) + " using 1:2 with points " + style + " title '" +
                       std::to_string(points.lateral.size()) + ' ' + title + "'");
    }
  };
  add(WRC_POINTS_READ, std::string("pt 7 ps 0.6 lc rgb '") + colour::quiet + '\'', "points read");
  add(WRC_POINTS_DROPPED, std::string("pt 2 ps 1.2 lw 2 lc rgb '") + colour::marked + '\'',
      "points cut or removed");
}

/// The range that holds nearly all curvature: the spikes of a noisy file would flatten the rest.
std::pair<double, double> curvature_range(const std::vector<ProfilePoint>& points) {
  std::vector<double> values;
  for (const ProfilePoint& point : points) {
    values.push_back(point.curvature);
  }
  std::sort(values.begin(), values.end());
  const std::size_t aside = values.size() / 200;
  const double low = std::min(values[aside], 0.0);
  const double high = std::max(values[values.size() - 1 - aside], 0.0);
  const double margin = std::max(0.08 * (high - low), 1e-5);
  return {low - margin, high + margin};
}

/// Lateral position of points along a profile and their distance to another one.
std::string distance_block(Gnuplot& gnuplot, const Profile& profile, const Profile& other) {
  constexpr double spacing = 0.25; // mm
  const std::vector<ProfilePoint> points = equal_points(profile, spacing);
  const std::vector<double> distances = distances_to(other, points);
  std::vector<double> lateral;
  std::vector<double> known;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isnan(distances[i])) {
      lateral.push_back(points[i].lateral);
      known.push_back(distances[i]);
    }
  }
  return gnuplot.block(lateral, known);
}

std::string dimension_text(const Measures& measures) {
  std::string text;
  for (const Dimension& dimension : measures.dimensions) {
    if (dimension.value && dimension.key != "slope") {
      text += (text.empty() ? "" : ",  ") + dimension.label + ' ' +
              fixed(*dimension.value, dimension.unit.empty() ? 4 : 2) +
              (dimension.unit.empty() ? "" : ' ' + dimension.unit);
    }
  }
  return text;
}

} // namespace

void draw_profile(const Profile& profile, const Measures& measures, const Profile* other,
                  const std::filesystem::path& path) {
  const double margin = room * (measures.greatest_lateral - measures.least_lateral);
  double width = measures.greatest_lateral - measures.least_lateral + 2.0 * margin;
  const double height = measures.greatest_height - measures.least_height + 2.0 * margin;
  // At one scale for both directions.
  width = std::max(width, height * plot_width / greatest_height);
  const double middle = 0.5 * (measures.least_lateral + measures.greatest_lateral);
  const double profile_height = height * plot_width / width;
  const double total_width = left_margin + plot_width + right_margin;
  const double total_height =
      top_margin + profile_height + between + curvature_height + bottom_margin;

  Gnuplot gnuplot;
  const auto points = piece_points(profile);
  const std::string block = block_of(gnuplot, points);
  const auto titled = [](const Profile& shown) {
    return " title " + gnuplot_text(shown.text("name"));
  };
  const std::string line = kind_name(profile) == std::string("rail") ? colour::rail : colour::wheel;
  std::vector<std::string> shapes;
  std::vector<std::string> lower;
  if (other != nullptr) {
    const std::string beneath = block_of(gnuplot, piece_points(*other));
    shapes.push_back(beneath + " using 1:2 with lines lw 1.5 lc rgb '" + colour::quiet + '\'' +
                     titled(*other));
  }
  add_points(gnuplot, profile, shapes); // beneath the curve, which they would hide
  shapes.push_back(block + " using 1:2 with lines lw 1.5 lc rgb '" + line + '\'' + titled(profile));
  lower.push_back((other != nullptr ? distance_block(gnuplot, profile, *other) + " using 1:2"
                                    : block + " using 1:3") +
                  " with lines lw 1.5 lc rgb '" + line + "' notitle");
  const Checks& checks = measures.checks;
  if (checks.smallest_radius > 0.0) {
    shapes.push_back(block_of(gnuplot, {checks.radius_at}) +
                     " using 1:2 with points pt 6 ps 1.4 lw 2 lc rgb '" + colour::marked +
                     "' title 'smallest radius " + fixed(checks.smallest_radius, 2) + " mm'");
  }
  if (checks.largest_kink > least_marked_kink) {
    shapes.push_back(block_of(gnuplot, {checks.kink_at}) +
                     " using 1:2 with points pt 8 ps 1.4 lw 2 lc rgb '" + line_colour(2) +
                     "' title 'largest kink " + fixed(1e3 * checks.largest_kink, 1) + " mrad'");
  }
  std::ostream& out = gnuplot.script();
  out << "set border 3\nset xrange [" << middle - 0.5 * width << ':' << middle + 0.5 * width
      << "]\n"
      << "set lmargin at screen " << left_margin / total_width << "\nset rmargin at screen "
      << (left_margin + plot_width) / total_width << "\nset multiplot\n"
      << "set tmargin at screen " << 1.0 - top_margin / total_height << "\nset bmargin at screen "
      << 1.0 - (top_margin + profile_height) / total_height << "\nset title "
      << gnuplot_text(profile.text("name") + " (" + kind_name(profile) + ")   " +
                      dimension_text(measures))
      << "\nset ylabel 'height, mm'\nset yrange [" << measures.least_height - margin << ':'
      << measures.greatest_height + margin << "]\n"
      << "set key horizontal center maxrows 1 at screen "
      << (left_margin + 0.5 * plot_width) / total_width << ", screen "
      << (bottom_margin + curvature_height + key_above) / total_height << '\n';
  gnuplot.plot(shapes);
  out << "set title\nset tmargin at screen " << (bottom_margin + curvature_height) / total_height
      << "\nset bmargin at screen " << bottom_margin / total_height
      << "\nset xlabel 'lateral, mm (to the field side)'\nset xzeroaxis lc rgb '" << colour::quiet
      << "'\n";
  if (other != nullptr) {
    out << "set ylabel " << gnuplot_text("normal distance to " + other->text("name") + ", mm")
        << "\nset yrange [*:*]\n";
  } else {
    const auto [low, high] = curvature_range(points);
    out << "set ylabel 'curvature, 1/mm'\nset yrange [" << low << ':' << high << "]\n";
  }
  gnuplot.plot(lower);
  out << "unset multiplot\n";
  gnuplot.draw(path, static_cast<int>(std::lround(total_width)),
               static_cast<int>(std::lround(total_height)));
}

} // namespace driver
