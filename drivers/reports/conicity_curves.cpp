#include "reports/conicity_curves.hpp"

#include <algorithm>
#include <cmath>

#include "reports/conicity.hpp"
#include "support/gnuplot.hpp"
#include "support/numbers.hpp"
#include "support/scene.hpp"

namespace driver {
namespace {

constexpr double amplitude_step = 0.25;
constexpr double least_amplitude = 0.5;
constexpr double most_amplitude = 12.0;
constexpr auto standard_index =
    static_cast<std::size_t>((standard_amplitude - least_amplitude) / amplitude_step);

} // namespace

double ConicityCurve::standard() const {
  return conicity[standard_index];
}

std::string ConicityCurve::in_words(const std::string& shown) const {
  const std::string at = " at an amplitude of " + general(standard_amplitude) + " mm";
  return one_line(shown) + (shown.empty() ? "" : ": ") +
         (std::isnan(standard())
              ? "no equivalent conicity" + at + ": " + no_conicity[standard_index]
              : "equivalent conicity " + fixed(standard(), 4) + at);
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
      for (std::size_t k = 0; k < (curves[i].*panel.y).size(); ++k) {
        const double value = (curves[i].*panel.y)[k];
        if (!std::isnan(value)) {
          x.push_back((curves[i].*panel.x)[k]);
          y.push_back(value);
          range.include(value);
        }
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
