#include "reports/conicity_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "reports/conicity.hpp"
#include "support/gnuplot.hpp"
#include "support/numbers.hpp"

namespace driver {
namespace {

constexpr double amplitude_step = 0.25;
constexpr double least_amplitude = 0.5;
constexpr double most_amplitude = 12.0;
constexpr std::size_t index_of(double amplitude) {
  return static_cast<std::size_t>((amplitude - least_amplitude) / amplitude_step);
}
constexpr std::size_t standard_index = index_of(standard_amplitude);

/// Distance of positions that spreads are computed at, mm, at most. Origin: measured (S1002 with
/// noise of 0.01 mm): at amplitudes up to 3 mm spreads are those of 0.05 mm; larger ones are not
/// where the difference of radii jumps between two positions.
constexpr double spread_step = 0.25;
} // namespace

double ConicityCurve::standard() const {
  return conicity[standard_index];
}

double ConicityCurve::standard_spread() const {
  return spread.empty() ? std::numeric_limits<double>::quiet_NaN() : spread[standard_index];
}

double ConicityCurve::nonlinearity() const {
  return 0.5 * (conicity[index_of(4.0)] - conicity[index_of(2.0)]);
}

std::string ConicityCurve::in_words(const std::string& shown) const {
  const std::string at = " at an amplitude of " + general(standard_amplitude) + " mm";
  const std::string subject = one_line(shown) + (shown.empty() ? "" : ": ");
  if (std::isnan(standard())) {
    return subject + "no equivalent conicity" + at + ": " + no_conicity[standard_index];
  }
  std::string text = subject + "equivalent conicity " + fixed(standard(), 4);
  if (standard_spread() > 0.0) {
    text += " +- " + fixed(standard_spread(), 4);
  }
  text += at;
  return std::isnan(nonlinearity())
             ? text
             : text + ", nonlinearity parameter " + fixed(nonlinearity(), 4) + " per mm";
}

ConicityCurve conicity_curve(const std::vector<double>& lateral, const std::vector<double>& radius,
                             const std::vector<double>& left_angle,
                             const std::vector<double>& right_angle) {
  ConicityCurve curve;
  // Both angles are turns about x; the right contact angle counts the other way round.
  for (std::size_t i = 0; i < lateral.size(); ++i) {
    if (!std::isnan(radius[i])) {
      curve.lateral.push_back(lateral[i]);
      curve.radius.push_back(radius[i]);
      curve.angle.push_back(std::tan(left_angle[i]) + std::tan(right_angle[i]));
    }
  }
  const RadiusDifference samples{lateral, radius};
  for (double amplitude = least_amplitude; amplitude <= most_amplitude;
       amplitude += amplitude_step) {
    const EquivalentConicity conicity = equivalent_conicity(samples, amplitude);
    curve.amplitude.push_back(amplitude);
    curve.conicity.push_back(conicity.value);
    curve.no_conicity.push_back(conicity.reason);
  }
  return curve;
}

void add_spread(ConicityCurve& curve, Scene scene, const std::string& key) {
  curve.spread.assign(curve.amplitude.size(), 0.0);
  if (curve.lateral.empty()) {
    return;
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  RadiusDifference centre;
  std::vector<RadiusDifference> likely;
  std::vector<RadiusDifference> smoothed;
  scene.set("solve.until", "geometry");
  Solver solver; // reads profiles once
  const double first = curve.lateral.front();
  const double range = curve.lateral.back() - first;
  const int steps = std::max(1, static_cast<int>(std::ceil(range / spread_step - 1e-9)));
  for (int i = 0; i <= steps; ++i) {
    const double lateral = first + range * i / steps;
    std::vector<double> likely_here;
    std::vector<double> smoothed_here;
    double here = none;
    try {
      scene.set(key, lateral);
      solver.solve(scene);
      likely_here = scene.field("spread.likely_radius_differences");
      smoothed_here = scene.field("spread.smoothed_radius_differences");
      here = scene.number("rolling_radius_difference");
    } catch (const std::exception&) { // off the rail: there is none
    }
    if (!std::isnan(here) && likely_here.empty()) { // built in, or points too far apart to tell
      const double known = scene.number_or("spread.rolling_radius_difference", none);
      curve.spread.assign(curve.amplitude.size(), known);
      return;
    }
    const auto add = [&](std::vector<RadiusDifference>& lines, const std::vector<double>& values) {
      lines.resize(std::max(lines.size(), values.size()));
      for (std::size_t k = 0; k < values.size(); ++k) {
        lines[k].lateral.push_back(lateral);
        lines[k].difference.push_back(values[k]);
      }
    };
    add(likely, likely_here);
    add(smoothed, smoothed_here);
    if (!std::isnan(here)) {
      centre.lateral.push_back(lateral);
      centre.difference.push_back(here);
    }
  }
  for (std::size_t i = 0; i < curve.spread.size(); ++i) {
    curve.spread[i] = conicity_spread(centre, likely, smoothed, curve.amplitude[i]);
  }
}

void draw_conicity_curves(const std::vector<ConicityCurve>& curves, const std::string& title,
                          const std::filesystem::path& path, const std::string& note,
                          const std::string& end_of_note) {
  struct Panel {
    const char* x_label;
    const char* y_label;
    std::vector<double> ConicityCurve::*x;
    std::vector<double> ConicityCurve::*y;
  };
  const Panel panels[] = {
      {"lateral displacement, mm (to the left)", "rolling radius difference, left - right, mm",
       &ConicityCurve::lateral, &ConicityCurve::radius},
      {"lateral displacement, mm (to the left)", "contact angle difference, tan(left) - tan(right)",
       &ConicityCurve::lateral, &ConicityCurve::angle},
      {"amplitude, mm", "equivalent conicity", &ConicityCurve::amplitude,
       &ConicityCurve::conicity}};
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(3, 1, title);
  gnuplot.script() << line_style(curves.size()) << note;
  for (const Panel& panel : panels) {
    Range range;
    std::vector<std::string> items;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      std::vector<double> x;
      std::vector<double> y;
      std::ostringstream band; // of the spread
      for (std::size_t k = 0; k < (curves[i].*panel.y).size(); ++k) {
        const double value = (curves[i].*panel.y)[k];
        if (!std::isnan(value)) {
          if (panel.y == &ConicityCurve::conicity && k < curves[i].spread.size() &&
              curves[i].spread[k] > 0.0) {
            band << (curves[i].*panel.x)[k] << ' ' << value - curves[i].spread[k] << ' '
                 << value + curves[i].spread[k] << '\n';
            range.include(value + curves[i].spread[k]);
            range.include(value - curves[i].spread[k]);
          }
          x.push_back((curves[i].*panel.x)[k]);
          y.push_back(value);
          range.include(value);
        }
      }
      if (!band.str().empty()) {
        items.push_back(gnuplot.block(band.str()) +
                        " with filledcurves fs transparent solid 0.2 lc rgb '" +
                        line_colour(i, curves.size()) + "' notitle");
      }
      if (!y.empty()) {
        items.push_back(gnuplot.block(x, y) + " with lines lw 2 dt " + std::to_string(i + 1) +
                        " lc rgb '" + line_colour(i, curves.size()) + "' title " +
                        gnuplot_text(curves[i].title, Markup::subscripts));
      }
    }
    gnuplot.script() << "set xlabel '" << panel.x_label << "'\nset ylabel '" << panel.y_label
                     << "'\n"
                     << range.command("y");
    gnuplot.plot(items);
    gnuplot.script() << end_of_note;
  }
  gnuplot.draw(path, 860 + legend_width(curves.size()), 1200);
}

} // namespace driver
