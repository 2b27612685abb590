#include "support/gnuplot.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

struct DrawnLine {
  std::string title;
  std::size_t colour = 0;
  std::size_t mark = 0;
  std::string data;
};

std::string data_of(const std::vector<double>& x, double x_factor, const std::vector<double>& y,
                    double y_factor) {
  std::string text;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string value = text_of(y_factor * y[i]);
    text += text_of(x_factor * x[i]) + ' ' + (value.empty() ? "NaN" : value) + '\n';
  }
  return text + "EOD\n";
}

std::string joined(const std::string& one, const std::string& other) {
  return one.empty() || other.empty() ? one + other : one + ", " + other;
}

std::vector<DrawnLine> lines_of(const PictureRequest& picture, const PictureData& data,
                                const PanelRequest& panel, AxisRange& range) {
  std::vector<DrawnLine> lines;
  const std::vector<double> x = places_of(picture, data);
  const std::vector<Value> series =
      picture.series.empty() ? std::vector<Value>{} : data.values_of(picture.series);
  const std::size_t groups = std::max<std::size_t>(series.size(), 1);
  for (std::size_t group = 0; group < groups; ++group) {
    Values where = picture.where;
    std::string name;
    if (!series.empty()) {
      where.insert_or_assign(picture.series, series[group]);
      name = series_name(picture, series[group]);
    }
    for (std::size_t i = 0; i < panel.lines.size(); ++i) {
      const auto y = line_of(picture, data, where, panel.lines[i].result);
      for (const double value : y) {
        range.include(panel.y_factor * value);
      }
      lines.push_back({joined(name, panel.lines[i].title), series.empty() ? i : group, i,
                       data_of(x, picture.x_factor, y, panel.y_factor)});
    }
  }
  return lines;
}

} // namespace

void draw_lines(const PictureRequest& picture, const PictureData& data,
                const std::filesystem::path& path) {
  constexpr int width = 860;
  constexpr int panel_height = 420;
  constexpr int title_height = 50;
  const auto count = static_cast<int>(picture.panels.size());
  const int height = title_height + panel_height * count;
  Gnuplot gnuplot;
  std::ostream& out = gnuplot.script();
  out << multiplot(count, 1, picture.title) << line_style << "set xlabel '"
      << within_quotes(picture.x_label) << "'\n";
  for (std::size_t i = 0; i < picture.panels.size(); ++i) {
    const PanelRequest& panel = picture.panels[i];
    AxisRange range;
    const std::vector<DrawnLine> lines = lines_of(picture, data, panel, range);
    std::string plots;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      const std::string block = "$panel" + std::to_string(i) + '_' + std::to_string(j);
      out << block << " << EOD\n" << lines[j].data;
      constexpr std::size_t marks = 4;
      plots += (plots.empty() ? "plot " : ", ") + block + " with linespoints lw 2 ps 0.9 pt " +
               std::to_string(5 + 2 * (lines[j].mark % marks)) + " dt " +
               std::to_string(1 + lines[j].mark % marks) + " lc rgb '" +
               line_colour(lines[j].colour) + "' title '" + within_quotes(lines[j].title) + '\'';
    }
    out << "set ylabel '" << within_quotes(panel.y_label) << "'\n"
        << range.command("y") << plots << '\n';
  }
  out << "unset multiplot\n";
  gnuplot.draw(path, width, height);
}

} // namespace driver
