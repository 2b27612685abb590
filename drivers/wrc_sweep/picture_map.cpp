// Results over two keys as colours, each in a panel with its own scale and with contour lines.
#include "support/gnuplot.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

/// Rows of values, positions along x first: gnuplot's nonuniform matrix.
std::string matrix_of(const PictureRequest& picture, const PictureData& data,
                      const PanelRequest& panel, std::vector<double>& values) {
  const std::vector<double> x = places_of(picture, data);
  const std::vector<double> y = data.numbers_of(picture.series.front());
  std::string text = text_of(static_cast<double>(x.size()));
  for (const double place : x) {
    text += ' ' + text_of(picture.x_factor * place);
  }
  for (const double place : y) {
    text += '\n' + text_of(picture.series_factor * place);
    Values where = picture.where;
    where.insert_or_assign(picture.series.front(), place);
    for (const double value : line_of(picture, data, where, panel.lines.front().result)) {
      values.push_back(panel.y_factor * value);
      const std::string shown = text_of(values.back());
      text += ' ' + (shown.empty() ? "NaN" : shown);
    }
  }
  return text + '\n';
}

/// Positions of scenes that are not to be used: x, y and the height 0.
std::string spoiled_of(const PictureRequest& picture, const PictureData& data,
                       const PanelRequest& panel) {
  std::string text;
  for (const double place : data.numbers_of(picture.series.front())) {
    Values where = picture.where;
    where.insert_or_assign(picture.series.front(), place);
    for (const double x : spoiled_places_of(picture, data, where, panel.lines.front().result)) {
      text += text_of(picture.x_factor * x) + ' ' + text_of(picture.series_factor * place) + " 0\n";
    }
  }
  return text;
}

/// The scale of colours, with contour lines at its tenths.
std::string colour_range(const Range& range) {
  if (range.empty() || range.length() <= 0.0) {
    return "set autoscale cb\nset cntrparam levels auto 8\n";
  }
  const std::string limits = text_of(range.least) + ':' + text_of(range.greatest);
  return "set cbrange [" + limits + "]\nset cntrparam levels incremental " + text_of(range.least) +
         ',' + text_of(0.125 * range.length()) + ',' + text_of(range.greatest) + '\n';
}

} // namespace

void draw_map(const PictureRequest& picture, const PictureData& data,
              const std::filesystem::path& path) {
  constexpr int width = 620;
  constexpr int height = 440;
  constexpr int title_height = 50;
  const std::size_t columns = std::min<std::size_t>(picture.panels.size(), 2);
  const std::size_t rows = (picture.panels.size() + columns - 1) / columns;
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(rows, columns, picture.title);
  // About 200 steps of colours each way.
  const auto finer = [](std::size_t places) { return std::to_string(1 + 200 / places); };
  gnuplot.script() << "set pm3d interpolate " << finer(places_of(picture, data).size()) << ','
                   << finer(data.numbers_of(picture.series.front()).size()) << '\n';
  gnuplot.script() << map_palette
                   << "set view map\nset contour base\n"
                      "set cntrparam cubicspline points 8\n"
                      "set cntrlabel onecolor\nunset key\nset lmargin 13\nset xlabel "
                   << gnuplot_text(picture.x_label, Markup::subscripts) << "\nset ylabel "
                   << gnuplot_text(series_label(picture), Markup::subscripts) << '\n'
                   << warning_note(data, "by crosses");
  for (const PanelRequest& panel : picture.panels) {
    std::vector<double> values;
    const std::string block = gnuplot.block(matrix_of(picture, data, panel, values));
    const Range range = range_of_most(values);
    const std::string spoiled = spoiled_of(picture, data, panel);
    const std::string marks =
        spoiled.empty() ? ""
                        : ", " + gnuplot.block(spoiled) +
                              " using 1:2:3 with points pt 2 ps 0.7 lc rgb 'black' nocontour";
    gnuplot.script() << "set title "
                     << gnuplot_text(panel.y_label + beyond_note(values, range), Markup::subscripts)
                     << '\n'
                     << colour_range(range) << "splot " << block
                     << " nonuniform matrix with pm3d nocontour, " << block
                     << " nonuniform matrix with lines lw 0.8 lc rgb '" << colour::contour
                     << "' nosurface" << marks << '\n'
                     << end_of_warning_note();
  }
  gnuplot.draw(path, width * static_cast<int>(columns),
               title_height + height * static_cast<int>(rows));
}

} // namespace driver
