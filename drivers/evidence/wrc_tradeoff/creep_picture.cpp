#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"
#include "wrc_tradeoff/creep.hpp"

namespace tradeoff {
namespace {

/// Models that an accuracy makes better: joined by a line, marks are labelled by the accuracy.
constexpr std::array joined_models{"full"};

/// Their number if there is none.
std::size_t series_of(const CreepRow& row) {
  return static_cast<std::size_t>(std::find(joined_models.begin(), joined_models.end(), row.model) -
                                  joined_models.begin());
}

/// Where the label of a mark is: beside other marks at about the same position.
const char* label_place(const CreepRow& row) {
  return row.model == "full"      ? "right offset -0.8,-0.6"
         : row.model == "fastsim" ? "left offset 1,-0.3"
         : row.model == "polach"  ? "right offset -1,-0.3"
                                  : "right offset -1,0.2";
}

/// rms errors over time, with a line up to what 99 % are below.
void draw_half(driver::Gnuplot& plot, const std::vector<CreepRow>& rows, const std::string& title,
               double (*error)(const std::array<double, 3>&)) {
  std::vector<std::string> items;
  const auto colour = [](std::size_t index) {
    return std::string(" lc rgb '") + driver::line_colour(index) + '\'';
  };
  for (std::size_t i = 0; i < joined_models.size(); ++i) {
    std::ostringstream steps;
    for (const CreepRow& row : rows) {
      if (series_of(row) == i) {
        steps << row.median_us << ' ' << error(row.rms) << '\n';
      }
    }
    items.push_back(plot.block(steps.str()) + " with linespoints pt 7 ps 1.1 dt 2" + colour(i) +
                    " title '" + joined_models[i] + ", by accuracy'");
  }
  for (const CreepRow& row : rows) {
    std::ostringstream point;
    point << row.median_us << ' ' << error(row.rms) << ' ' << error(row.error_99) << " \""
          << (series_of(row) < joined_models.size() ? driver::general(row.accuracy) : row.model)
          << "\"\n";
    const std::string data = plot.block(point.str());
    items.push_back(data + " using 1:2:2:3 with yerrorbars pt 7 ps 1.1 lw 1.5" +
                    colour(series_of(row)) + " notitle");
    items.push_back(data + " using 1:2:4 with labels " + label_place(row) + " notitle");
  }
  plot.script() << "set title '" << title << "'\n";
  plot.plot(items);
}

} // namespace

void draw_creep(const std::vector<CreepMeasured>& all, const std::filesystem::path& folder) {
  const std::vector<CreepRow> rows = creep_rows(all);
  driver::Gnuplot plot;
  plot.begin_multiplot(1, 2);
  plot.script() << "set logscale xy\nset xrange [0.01:*]\nset xlabel 'median time per patch, us'\n"
                   "set ylabel 'error: rms to 99th percentile'\nset format '10^{%T}'\n";
  draw_half(plot, rows, "Fx and Fy, over mu N",
            [](const std::array<double, 3>& errors) { return std::max(errors[0], errors[1]); });
  draw_half(plot, rows, "Mz, over mu N c",
            [](const std::array<double, 3>& errors) { return errors[2]; });
  plot.draw(folder / "tradeoff_creep.png", 1400, 600);
}

} // namespace tradeoff
