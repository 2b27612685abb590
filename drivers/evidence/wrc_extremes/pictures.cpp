#include "wrc_extremes/reports.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/gnuplot.hpp"

namespace extremes {
namespace {

/// Smaller values, and zeros, are drawn here.
constexpr double least_shown = 1e-18;
constexpr double greatest_shown = 10.0;

struct Shade {
  Verdict verdict;
  const char* colour;
};
constexpr Shade shades[] = {{Verdict::refused, "#c8c8c8"},
                            {Verdict::none, "#cfe2f3"},
                            {Verdict::warned, "#fff2b3"},
                            {Verdict::faded, "#f6b26b"},
                            {Verdict::wrong, "#e06666"}};

struct Line {
  const char* title;
  const char* style;
  std::optional<double> Row::*member;
};
constexpr Line lines[] = {
    {"overlap", "lt 1 pt 6", &Row::overlap},
    {"gap under pressure", "lt 5 pt 4", &Row::complementarity},
    {"load balance", "lt 6 pt 2", &Row::load_balance},
    {"pressures, against elimination in long double", "lt 3 pt 7", &Row::pressure_error},
    {"pmax, approach", "lt 2 pt 5", &Row::error}};

/// Where a point's part of the axis begins: half way to the one before.
double border(const std::vector<Row>& rows, std::size_t index, bool logarithmic) {
  const auto between = [logarithmic](double a, double b) {
    return logarithmic ? std::sqrt(a * b) : 0.5 * (a + b);
  };
  const auto beyond = [logarithmic](double at, double from) {
    return logarithmic ? at * std::sqrt(at / from) : at + 0.5 * (at - from);
  };
  if (rows.size() == 1) {
    const double at = rows.front().value;
    const double side = index == 0 ? -1.0 : 1.0;
    return logarithmic ? at * std::pow(3.0, side) : at + side;
  }
  if (index == 0) {
    return beyond(rows[0].value, rows[1].value);
  }
  if (index == rows.size()) {
    return beyond(rows[index - 1].value, rows[index - 2].value);
  }
  return between(rows[index - 1].value, rows[index].value);
}

/// The ticks of shapes, which have names instead of numbers.
void write_names(const std::vector<Row>& rows, std::ostream& script) {
  script << "set title ''\nset xtics rotate by 40 right nomirror (";
  const char* separator = "";
  for (const Row& row : rows) {
    script << separator << driver::gnuplot_text(row.setting) << ' ' << row.value;
    separator = ", ";
  }
  script << ")\n";
}

/// The rows with one verdict lie on its colour.
void write_shades(const std::vector<Row>& rows, const Quantity& quantity, std::ostream& script) {
  const double first = border(rows, 0, quantity.logarithmic);
  const double last = border(rows, rows.size(), quantity.logarithmic);
  script << "set xrange [" << std::min(first, last) << ':' << std::max(first, last) << "]\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const Shade& shade : shades) {
      if (shade.verdict == rows[i].verdict) {
        script << "set object rectangle from first " << border(rows, i, quantity.logarithmic)
               << ", graph 0 to first " << border(rows, i + 1, quantity.logarithmic)
               << ", graph 1 behind fillcolor rgb '" << shade.colour
               << "' fillstyle solid noborder\n";
      }
    }
  }
}

void draw_panel(std::vector<Row> rows, const Quantity& quantity, bool with_key,
                driver::Gnuplot& plot) {
  if (!quantity.shapes) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& one, const Row& other) { return one.value < other.value; });
  }
  std::ostream& script = plot.script();
  script << "unset object\nset title " << driver::gnuplot_text(rows.front().base) << '\n'
         << (with_key ? "set key bmargin center horizontal maxrows 3\nset bmargin 11\n"
                      : "unset key\n");
  if (quantity.shapes) {
    script << "set bmargin 20\n";
    write_names(rows, script);
  }
  write_shades(rows, quantity, script);
  std::vector<std::string> items{"NaN notitle"}; // gnuplot wants something to draw
  const std::string drawn = quantity.shapes ? " with points " : " with linespoints ";
  for (const Line& line : lines) {
    std::ostringstream points;
    bool any = false;
    for (const Row& row : rows) {
      if (const std::optional<double>& value = row.*line.member) {
        points << row.value << ' ' << std::clamp(*value, least_shown, greatest_shown);
        any = true;
      }
      points << '\n'; // without a value the line breaks
    }
    items.push_back((any ? plot.block(points.str()) : "keyentry") + drawn + line.style +
                    " title '" + line.title + '\'');
  }
  std::ostringstream requested;
  for (const Row& row : rows) {
    if (row.asked > 0.0 && row.pmax) {
      requested << row.value << ' ' << row.asked << '\n';
    }
  }
  if (!requested.view().empty()) {
    items.push_back(plot.block(requested.str()) +
                    (quantity.shapes ? " with points pt 1" : " with lines dashtype 2") +
                    " lc rgb 'black' title 'requested'");
  }
  for (const Shade& shade : shades) {
    items.push_back(std::string("keyentry with boxes fillstyle solid noborder fillcolor rgb '") +
                    shade.colour + "' title '" + name_of(shade.verdict) + '\'');
  }
  plot.plot(items);
}

} // namespace

void draw_pictures(const std::vector<Row>& rows, const std::filesystem::path& folder) {
  for (const Quantity& quantity : quantities()) {
    std::vector<std::vector<Row>> panels;
    for (const Row& row : rows) {
      if (row.quantity != quantity.name) {
        continue;
      }
      const auto panel = std::find_if(panels.begin(), panels.end(), [&](const auto& others) {
        return quantity.shapes || others.front().base == row.base;
      });
      (panel == panels.end() ? panels.emplace_back() : *panel).push_back(row);
    }
    if (panels.empty()) {
      continue;
    }
    driver::Gnuplot plot;
    auto& script = plot.script();
    script << "set grid front\nset logscale y\nset format y '10^{%T}'\nset yrange ["
           << least_shown / 3.0 << ':' << greatest_shown << "]\nset ylabel 'relative'\n"
           << "set datafile missing 'NaN'\n"
           << (quantity.logarithmic ? "set logscale x\nset format x '10^{%T}'\n" : "")
           << (quantity.shapes ? "set lmargin 26\n" : "") << "set multiplot layout "
           << panels.size() << ",1 title " << driver::gnuplot_text(quantity.title) << '\n';
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const bool last = i + 1 == panels.size();
      if (last) {
        script << "set xlabel " << driver::gnuplot_text(quantity.label) << '\n';
      }
      draw_panel(panels[i], quantity, last, plot);
    }
    script << "unset multiplot\n";
    const int panel_height = quantity.shapes ? 560 : 280;
    plot.draw(folder / ("extremes_" + quantity.name + ".png"), 900,
              120 + panel_height * static_cast<int>(panels.size()));
  }
}

} // namespace extremes
