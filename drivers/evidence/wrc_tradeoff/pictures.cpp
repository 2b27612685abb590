#include "wrc_tradeoff/reports.hpp"

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"

namespace tradeoff {
namespace {

constexpr double least_shown = 1e-7;
constexpr std::array labels{"forces", "pressures", "double", "grid", "hertz", "kik-piotrowski"};
constexpr std::array meanings{"forces", "pressures"};

/// Points of several kinds on one plot; kinds without points are left out, which gnuplot would
/// refuse.
class Series {
public:
  /// First what stands before them, such as lines of a formula.
  Series(driver::Gnuplot& gnuplot, std::vector<std::string> items = {})
      : gnuplot_(gnuplot), items_(std::move(items)) {}
  void add(const std::ostringstream& points, const std::string& style, const std::string& title) {
    if (!points.view().empty()) {
      items_.push_back(gnuplot_.block(points.str()) + ' ' + style + " title '" + title + '\'');
    }
  }
  void plot() const { gnuplot_.plot(items_); }

private:
  driver::Gnuplot& gnuplot_;
  std::vector<std::string> items_;
};

using ErrorOf = std::function<double(const WheelError&)>;

/// Times of all scenes and errors of all wheels of a way.
struct Cloud {
  std::vector<double> times;
  std::vector<double> errors;
};

Cloud cloud_of(const std::vector<Measured>& all, const Way& way, const ErrorOf& error_of) {
  Cloud cloud;
  for (const Measured& measured : all) {
    for (const Run& run : measured.runs) {
      if (run.way.label == way.label && run.way.accuracy == way.accuracy &&
          run.way.grid == way.grid) {
        cloud.times.push_back(run.time_ms);
        for (const WheelError& error : run.errors) {
          cloud.errors.push_back(std::max(error_of(error), least_shown));
        }
      }
    }
  }
  return cloud;
}

void draw_work_precision(const std::vector<Measured>& all, const std::filesystem::path& path) {
  driver::Gnuplot plot;
  auto& script = plot.script();
  plot.begin_multiplot(1, 3);
  script << "set logscale xy\nset xlabel 'median time, both "
            "wheels, ms'\nset format y '10^{%T}'\nset key bottom left\n";
  const std::pair<const char*, ErrorOf> quantities[] = {
      {"pmax", [](const WheelError& error) { return error.of(Quantity::pmax); }},
      {"approach", [](const WheelError& error) { return error.of(Quantity::depth); }},
      {"area", [](const WheelError& error) { return error.of(Quantity::area); }}};
  for (const auto& [quantity, error_of] : quantities) {
    script << "set title '" << quantity
           << "'\nset ylabel 'relative error: median to 95th percentile'\n";
    Series series(plot);
    for (const char* label : labels) {
      std::ostringstream points;
      for (const Way& way : ways_of({label})) {
        const Cloud cloud = cloud_of(all, way, error_of);
        if (!cloud.times.empty()) {
          const double middle = median(cloud.errors);
          points << median(cloud.times) << ' ' << middle << ' ' << middle << ' '
                 << quantile(cloud.errors, 0.95) << '\n';
        }
      }
      series.add(points, "using 1:2:3:4 with yerrorlines pt 7 ps 0.6", label);
    }
    series.plot();
  }
  plot.draw(path, 1500, 500);
}

/// One half of a picture for each meaning of an accuracy.
void begin_halves(driver::Gnuplot& plot, const std::string& across, const std::string& ranges) {
  plot.begin_multiplot(1, 2);
  plot.script() << "set logscale xy\nset xlabel '" << across
                << "'\nset ylabel 'largest error'\nset format '10^{%T}'\nset key bottom right\n"
                << ranges;
}

bool has(const std::vector<AskedRow>& rows, const std::string& label) {
  return std::any_of(rows.begin(), rows.end(),
                     [&label](const AskedRow& row) { return row.label == label; });
}

void draw_asked(const std::vector<Measured>& all, const std::filesystem::path& path) {
  driver::Gnuplot plot;
  auto& script = plot.script();
  begin_halves(plot, "requested accuracy", "set xrange [2e-4:2e-1]\n");
  const std::pair<const char*, std::function<double(const AskedRow&)>> lines[] = {
      {"worst", [](const AskedRow& row) { return row.worst * row.asked; }},
      {"99 %", [](const AskedRow& row) { return row.error_99; }},
      {"95 %", [](const AskedRow& row) { return row.error_95; }},
      {"median", [](const AskedRow& row) { return row.median_error; }}};
  const std::vector<AskedRow> rows = asked_rows(all);
  for (const char* label : meanings) {
    Series series(plot, {"x with lines dt 2 lc 'black' title 'as requested'",
                         "3*x with lines dt 3 lc 'black' title 'three times'"});
    for (const auto& [title, value] : lines) {
      std::ostringstream points;
      for (const AskedRow& row : rows) {
        if (row.label == label) {
          points << row.asked << ' ' << value(row) << '\n';
        }
      }
      series.add(points, "with linespoints pt 7", title);
    }
    if (has(rows, label)) {
      script << "set title 'accuracy of " << label << "'\n";
      series.plot();
    }
  }
  plot.draw(path, 1300, 600);
}

/// Estimates and errors of one way at one accuracy.
void add_estimates(const std::vector<Measured>& all, const std::string& label, double asked,
                   std::ostream& points) {
  for (const Measured& measured : all) {
    for (const Run& run : measured.runs) {
      if (run.way.label != label || run.way.accuracy != asked) {
        continue;
      }
      for (const WheelError& error : run.errors) {
        if (error.estimate) {
          points << *error.estimate << ' ' << std::max(error.controlled(label), least_shown)
                 << '\n';
        }
      }
    }
  }
}

void draw_estimate(const std::vector<Measured>& all, const std::filesystem::path& path) {
  driver::Gnuplot plot;
  auto& script = plot.script();
  begin_halves(plot, "estimated error", "set xrange [1e-5:1]\nset yrange [1e-7:1]\n");
  const std::vector<AskedRow> rows = asked_rows(all);
  for (const char* label : meanings) {
    Series series(plot, {"x with lines lc 'black' title 'as estimated'",
                         "x/10 with lines dt 2 lc 'black' title 'a tenth'"});
    for (const double asked : accuracies) {
      std::ostringstream points;
      add_estimates(all, label, asked, points);
      series.add(points, "with points pt 7 ps 0.3", "requested " + driver::general(asked));
    }
    if (has(rows, label)) {
      script << "set title 'accuracy of " << label << "'\n";
      series.plot();
    }
  }
  plot.draw(path, 1300, 600);
}

/// Whether a model meets 10 % of pmax and approach of a wheel.
bool is_enough(const Measured& measured, const std::string& model, std::size_t side) {
  return std::any_of(measured.runs.begin(), measured.runs.end(), [&](const Run& run) {
    return run.way.label == model && is_within(run.errors[side], 0.1);
  });
}

void draw_models(const std::vector<Measured>& all, const std::filesystem::path& path) {
  driver::Gnuplot plot;
  auto& script = plot.script();
  plot.begin_multiplot(1, 2);
  script << "set logscale y\nset xlabel 'validity'\nset ylabel "
            "'error of pmax'\nset format y '10^{%T}'\nset key bottom left\nset xrange "
            "[-0.02:1.02]\nset title 'errors of models'\n";
  Series errors(plot);
  for (const char* label : {"hertz", "kik-piotrowski"}) {
    std::ostringstream points;
    for (const Measured& measured : all) {
      for (const Run& run : measured.runs) {
        if (run.way.label != label) {
          continue;
        }
        for (const WheelError& error : run.errors) {
          points << error.validity.value_or(0.0) << ' '
                 << std::max(error.of(Quantity::pmax), least_shown) << '\n';
        }
      }
    }
    errors.add(points, "with points pt 7 ps 0.4", label);
  }
  errors.plot();
  script << "set xlabel 'displacement towards the flange, mm'\nset ylabel 'load per wheel, N'\n"
            "set format y '10^{%T}'\nset xrange [*:*]\nset key outside top center horizontal\n"
            "set title 'cheapest model within 10 % of pmax and approach'\n";
  std::ostringstream hertz;
  std::ostringstream quick;
  std::ostringstream half_space;
  for (const Measured& measured : all) {
    for (std::size_t side = 0; side < 2 && measured.failure.empty(); ++side) {
      auto& points = is_enough(measured, "hertz", side)            ? hertz
                     : is_enough(measured, "kik-piotrowski", side) ? quick
                                                                   : half_space;
      // Seen from the left wheel: the right one moves the other way.
      points << (side == 0 ? 1.0 : -1.0) * measured.scene.settings.number_or("pose.lateral", 0.0)
             << ' ' << load_of(measured.scene.settings, side) << '\n';
    }
  }
  Series winners(plot);
  winners.add(hertz, "with points pt 7 ps 0.6", "hertz");
  winners.add(quick, "with points pt 7 ps 0.6", "kik-piotrowski only");
  winners.add(half_space, "with points pt 7 ps 0.6", "half-space only");
  winners.plot();
  plot.draw(path, 1300, 550);
}

} // namespace

void draw_pictures(const std::vector<Measured>& all, const std::filesystem::path& folder,
                   bool with_models) {
  draw_work_precision(all, folder / "tradeoff_work_precision.png");
  draw_asked(all, folder / "tradeoff_asked.png");
  draw_estimate(all, folder / "tradeoff_estimate.png");
  if (with_models) {
    draw_models(all, folder / "tradeoff_models.png");
  }
}

} // namespace tradeoff
