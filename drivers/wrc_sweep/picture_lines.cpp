#include <algorithm>
#include <cmath>

#include "support/gnuplot.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

struct DrawnLine {
  std::string title;
  std::size_t colour = 0;
  std::size_t mark = 0;
  std::string data;
  std::string spoiled; ///< of these points, those that are not to be used
};

std::string data_of(const std::vector<double>& x, double x_factor, const std::vector<double>& y,
                    double y_factor) {
  std::string text;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string value = text_of(y_factor * y[i]);
    text += text_of(x_factor * x[i]) + ' ' + (value.empty() ? "NaN" : value) + '\n';
  }
  return text;
}

std::string joined(const std::string& one, const std::string& other) {
  return one.empty() || other.empty() ? one + other : one + ", " + other;
}

std::vector<DrawnLine> lines_of(const PictureRequest& picture, const PictureData& data,
                                const PanelRequest& panel, std::vector<double>& values,
                                Range& range, bool& are_whole) {
  std::vector<DrawnLine> lines;
  const std::vector<double> x = places_of(picture, data);
  const std::vector<SeriesEntry> series = series_of(picture, data);
  for (std::size_t group = 0; group < series.size(); ++group) {
    const Values& where = series[group].where;
    for (std::size_t i = 0; i < panel.lines.size(); ++i) {
      const auto y = line_of(picture, data, where, panel.lines[i].result);
      std::vector<double> own;
      for (const double value : y) {
        own.push_back(panel.y_factor * value);
        are_whole = are_whole && (std::isnan(value) ||
                                  std::rint(panel.y_factor * value) == panel.y_factor * value);
      }
      values.insert(values.end(), own.begin(), own.end());
      range.include(range_of_most(own));
      const auto spoiled = spoiled_places_of(picture, data, where, panel.lines[i].result);
      std::vector<double> y_spoiled;
      for (const double place : spoiled) {
        y_spoiled.push_back(
            y[static_cast<std::size_t>(std::find(x.begin(), x.end(), place) - x.begin())]);
      }
      lines.push_back({joined(series[group].title, panel.lines[i].title),
                       picture.series.empty() ? i : group, i,
                       data_of(x, picture.x_factor, y, panel.y_factor),
                       data_of(spoiled, picture.x_factor, y_spoiled, panel.y_factor)});
    }
  }
  return lines;
}

/// The axis of the values: if there are few whole ones only, such as numbers of patches, without
/// ticks between them.
std::string y_axis(const Range& range, bool are_whole) {
  constexpr double most_ticks = 10.0;
  const bool by_one = are_whole && !range.empty() && range.length() <= most_ticks;
  return range.command("y") + (by_one ? "set ytics 1\n" : "set ytics autofreq\n");
}

} // namespace

void draw_lines(const PictureRequest& picture, const PictureData& data,
                const std::filesystem::path& path) {
  constexpr int width = 860;
  constexpr int panel_height = 420;
  constexpr int title_height = 50;
  const auto count = static_cast<int>(picture.panels.size());
  const int height = title_height + panel_height * count;
  const std::size_t groups = series_of(picture, data).size();
  std::size_t most_lines = 0; // of a panel
  for (const PanelRequest& panel : picture.panels) {
    most_lines = std::max(most_lines, groups * panel.lines.size());
  }
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(picture.panels.size(), 1, picture.title);
  gnuplot.script() << line_style(most_lines) << "set xlabel "
                   << gnuplot_text(picture.x_label, Markup::subscripts) << '\n'
                   << warning_note(data, "hollow");
  constexpr std::size_t most_large = 60; // marks in a line
  const std::string mark_size = places_of(picture, data).size() > most_large ? "0.4" : "0.9";
  for (const PanelRequest& panel : picture.panels) {
    std::vector<double> values;
    bool are_whole = true;
    std::vector<std::string> items;
    Range range;
    const std::vector<DrawnLine> lines = lines_of(picture, data, panel, values, range, are_whole);
    for (const DrawnLine& line : lines) {
      constexpr std::size_t marks = 4;
      items.push_back(
          gnuplot.block(line.data) + (panel.is_joined ? " with linespoints" : " with points") +
          " lw 2 ps " + mark_size + " pt " + std::to_string(5 + 2 * (line.mark % marks)) +
          (panel.is_joined ? " dt " + std::to_string(1 + line.mark % marks) : "") + " lc rgb '" +
          line_colour(line.colour, picture.series.empty() ? most_lines : groups) + "' title " +
          gnuplot_text(line.title, Markup::subscripts));
    }
    for (const DrawnLine& line : lines) {
      if (!line.spoiled.empty()) { // hollow
        items.push_back(gnuplot.block(line.spoiled) + " with points pt 7 ps " +
                        (mark_size == "0.9" ? "0.45" : "0.2") + " lc rgb 'white' notitle");
      }
    }
    gnuplot.script() << "set ylabel "
                     << gnuplot_text(panel.y_label + beyond_note(values, range), Markup::subscripts)
                     << '\n'
                     << y_axis(range, are_whole);
    gnuplot.plot(items);
    gnuplot.script() << end_of_warning_note();
  }
  gnuplot.draw(path, width + legend_width(most_lines), height);
}

} // namespace driver
