#include "reports/smoothing.hpp"

#include <cmath>
#include <limits>
#include <tuple>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"

namespace driver {
namespace {

double value_of(const Scene& scene, const std::string& name) {
  return scene.number_or(name, std::numeric_limits<double>::quiet_NaN());
}

} // namespace

std::vector<std::vector<std::string>> smoothing_rows(const Scene& scene) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& side : sides_of(scene)) {
    if (!scene.has_number(side + ".smoothed_0mm.area")) {
      return {};
    }
    if (rows.empty()) {
      rows.push_back({"Profiles smoothed, mm", "", "as solved", "0", "3", "5", "8", "15"});
    }
    for (const auto& [name, unit, decimals] :
         {std::tuple("pmax", "MPa", 1), std::tuple("area", "mm2", 2)}) {
      std::vector<std::string> row{"  " + side + ' ' + name, unit};
      for (const char* group : {".", ".smoothed_0mm.", ".smoothed_3mm.", ".smoothed_5mm.",
                                ".smoothed_8mm.", ".smoothed_15mm."}) {
        const double value = value_of(scene, side + group + name);
        row.push_back(std::isnan(value) ? "-" : fixed(value, decimals));
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<Warning> spread_warnings(const Scene& scene) {
  std::vector<Warning> warnings;
  for (const std::string& side : sides_of(scene)) {
    const auto share = [&](const char* name) {
      return value_of(scene, side + ".spread." + name) / value_of(scene, side + '.' + name);
    };
    const double pmax = share("pmax");
    const double area = share("area");
    if (std::isnan(area) && scene.has_number(side + ".smoothed_0mm.area")) {
      warnings.push_back({side +
                              ": how far noise moves pmax and area is not known: the points of a "
                              "profile are too far apart",
                          WRC_FINE});
    }
    if (std::fmax(pmax, area) > scene.get_number("solve.accuracy")) {
      std::string text;
      for (const auto& [name, value] : {std::pair("pmax", pmax), std::pair("area", area)}) {
        if (!std::isnan(value)) {
          text += (text.empty() ? "" : ", ") + std::string(name) + " by " + fixed(1e2 * value, 1) +
                  " %";
        }
      }
      warnings.push_back({side + ": uncertain by noise or short waves of the profiles: " + text,
                          static_cast<std::int32_t>(scene.number(side + ".spread.grade"))});
    }
  }
  return warnings;
}

void draw_smoothing(const Scene& scene, const std::filesystem::path& path) {
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(1, 1);
  Range range;
  std::vector<std::string> items;
  for (const std::string& side : sides_of(scene)) {
    std::vector<double> x;
    std::vector<double> y;
    for (const int wavelength : {0, 3, 5, 8, 15}) {
      const double value = scene.number_or(
          side + ".smoothed_" + std::to_string(wavelength) + "mm.pmax", std::nan(""));
      if (!std::isnan(value)) {
        x.push_back(wavelength);
        y.push_back(value);
        range.include(value);
      }
    }
    if (!x.empty()) {
      items.push_back(gnuplot.block(x, y) + " with linespoints lw 2 pt 5 lc rgb '" +
                      line_colour(items.size()) + "' title '" + side + " wheel'");
    }
  }
  gnuplot.script() << "set xlabel 'smoothing wavelength, mm (waves of this length are halved)'\n"
                   << "set ylabel 'largest pressure, MPa'\n"
                   << range.command("y");
  gnuplot.plot(items);
  gnuplot.draw(path, 860, 380);
}

} // namespace driver
