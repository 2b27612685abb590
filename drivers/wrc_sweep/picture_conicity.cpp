// Rolling radius difference and contact angle difference over the lateral position, and equivalent
// conicity over the amplitude.
#include <algorithm>
#include <cmath>

#include "support/csv_table.hpp"
#include "support/gnuplot.hpp"
#include "support/output_file.hpp"
#include "wrc_sweep/conicity.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

struct Curve {
  std::string name;  ///< in the table
  std::string title; ///< in the picture
  std::vector<double> lateral;
  std::vector<double> radius;
  std::vector<double> angle; ///< tan of the left contact angle minus tan of the right one
  std::vector<double> amplitude;
  std::vector<double> conicity;         ///< NaN where there is none
  std::vector<std::string> no_conicity; ///< why
};

/// The curve of one value of the series.
Curve curve_of(const PictureRequest& picture, const PictureData& data, const Values& where) {
  Curve curve;
  PictureRequest ascending = picture;
  std::vector<double>& lateral = ascending.x_values;
  lateral = places_of(picture, data);
  std::sort(lateral.begin(), lateral.end());
  lateral.erase(std::unique(lateral.begin(), lateral.end()), lateral.end());
  const auto line = [&](const char* name) { return line_of(ascending, data, where, name); };
  const std::vector<double> radius = line("rolling_radius_difference");
  // Both angles are turns about x; the right contact angle counts the other way round.
  const std::vector<double> left = line("left.rigid_contact.angle");
  const std::vector<double> right = line("right.rigid_contact.angle");
  for (std::size_t i = 0; i < lateral.size(); ++i) {
    if (!std::isnan(radius[i])) {
      curve.lateral.push_back(lateral[i]);
      curve.radius.push_back(radius[i]);
      curve.angle.push_back(std::tan(left[i]) + std::tan(right[i]));
    }
  }
  const RadiusDifference samples{lateral, radius};
  constexpr double step = 0.25;
  constexpr double most = 12.0;
  for (double amplitude = 2.0 * step; amplitude <= most; amplitude += step) {
    const EquivalentConicity conicity = equivalent_conicity(samples, amplitude);
    curve.amplitude.push_back(amplitude);
    curve.conicity.push_back(conicity.value);
    curve.no_conicity.push_back(conicity.reason);
  }
  return curve;
}

std::vector<Curve> curves_of(const PictureRequest& picture, const PictureData& data) {
  if (picture.series.empty()) {
    return {curve_of(picture, data, picture.where)};
  }
  std::vector<Curve> curves;
  for (const Value& value : data.values_of(picture.series)) {
    Values where = picture.where;
    where.insert_or_assign(picture.series, value);
    Curve& curve = curves.emplace_back(curve_of(picture, data, where));
    curve.name = series_name(picture, value);
    curve.title = series_title(picture, value);
  }
  return curves;
}

void write_table(const std::vector<Curve>& curves, const std::filesystem::path& path) {
  OutputFile file(path);
  CsvLine(file.stream()).add(words("series amplitude equivalent_conicity message"));
  for (const Curve& curve : curves) {
    for (std::size_t i = 0; i < curve.amplitude.size(); ++i) {
      CsvLine(file.stream()) << curve.name << text_of(curve.amplitude[i])
                             << text_of(curve.conicity[i]) << curve.no_conicity[i];
    }
  }
  file.commit();
}

} // namespace

void draw_conicity(const PictureRequest& picture, const PictureData& data,
                   const std::filesystem::path& path, const std::filesystem::path& table) {
  const std::vector<Curve> curves = curves_of(picture, data);
  write_table(curves, table);
  struct Panel {
    const char* x_label;
    const char* y_label;
    std::vector<double> Curve::*x;
    std::vector<double> Curve::*y;
  };
  const Panel panels[] = {
      {"lateral displacement, mm (to the left)", "rolling radius difference, left - right, mm",
       &Curve::lateral, &Curve::radius},
      {"lateral displacement, mm (to the left)", "contact angle difference, tan(left) - tan(right)",
       &Curve::lateral, &Curve::angle},
      {"amplitude, mm", "equivalent conicity", &Curve::amplitude, &Curve::conicity}};
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(3, 1, picture.title);
  gnuplot.script() << line_style(curves.size()) << warning_note(data);
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
    gnuplot.script() << end_of_warning_note();
  }
  gnuplot.draw(path, 860 + legend_width(curves.size()), 1200);
}

} // namespace driver
