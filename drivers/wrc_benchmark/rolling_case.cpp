#include "wrc_benchmark/rolling_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/text_table.hpp"
#include "wrc_benchmark/yardstick.hpp"
#include "wrcontact.hpp"

namespace benchmark {
namespace {

constexpr double load = 80000.0;
constexpr double friction = 0.3;
constexpr double shear_modulus = 82000.0;
constexpr double mean_axis = 5.0; ///< sqrt(a b), mm

struct Ellipse {
  double a = 0.0; ///< along
  double b = 0.0;
  double poisson = 0.0;
  std::array<double, 3> creepages{};
};

std::vector<Ellipse> draw_ellipses(int count) {
  std::mt19937_64 generator(11);
  const auto uniform = [&generator](double low, double high) {
    return low + (high - low) * static_cast<double>(generator() >> 11U) * 0x1p-53;
  };
  const auto log_uniform = [&uniform](double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  };
  // Creepage for which the linear theory transmits all of the friction, in order of magnitude.
  constexpr double saturation = friction * load / (4.0 * shear_modulus * mean_axis * mean_axis);
  std::vector<Ellipse> ellipses;
  for (int i = 0; i < count; ++i) {
    const double root = std::sqrt(log_uniform(0.2, 5.0));
    const double size = saturation * log_uniform(0.1, 10.0);
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    ellipses.push_back(
        {mean_axis * root,
         mean_axis / root,
         uniform(0.2, 0.35),
         {size * std::cos(angle), size * std::sin(angle), size * uniform(-1.5, 1.5) / mean_axis}});
  }
  return ellipses;
}

/// Sets grid, pressures (Hertz's at the centres, scaled to the load) and creepages.
void set_up(wrcontact::RollingContact& rolling, const Ellipse& ellipse, const RollingRow& row) {
  const double step_x = 2.0 * ellipse.a / static_cast<double>(row.along);
  const double step_y = 2.0 * ellipse.b / static_cast<double>(row.across);
  std::vector<double> pressure;
  double sum = 0.0;
  for (std::int64_t j = 0; j < row.across; ++j) {
    for (std::int64_t i = 0; i < row.along; ++i) {
      const double x = (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(row.along) - 1.0;
      const double y = (2.0 * static_cast<double>(j) + 1.0) / static_cast<double>(row.across) - 1.0;
      pressure.push_back(std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
      sum += pressure.back() * step_x * step_y;
    }
  }
  for (double& p : pressure) {
    p *= load / sum;
  }
  rolling.set_grid(row.across, row.along, step_y, step_x);
  rolling.set_pressure(pressure);
  rolling.set("poisson", ellipse.poisson);
  rolling.set("tolerance", row.tolerance);
  rolling.set("longitudinal_creepage", ellipse.creepages[0]);
  rolling.set("lateral_creepage", ellipse.creepages[1]);
  rolling.set("spin_creepage", ellipse.creepages[2]);
}

wrcontact::RollingContact new_contact() {
  wrcontact::RollingContact rolling;
  rolling.set("friction", friction);
  rolling.set("shear_modulus", shear_modulus);
  return rolling;
}

using Forces = std::array<double, 3>;

Forces forces_of(const wrcontact::RollingContact& rolling) {
  return {rolling.number("creep_force.longitudinal") / (friction * load),
          rolling.number("creep_force.lateral") / (friction * load),
          rolling.number("spin_moment") / (friction * load * mean_axis)};
}

/// A paraboloid that penetrates twice the area of its contact, on the elements that a scene takes
/// at this accuracy.
double measure_normal(double accuracy, int repeat) {
  const bool coarse = accuracy > 3e-3;
  const std::int64_t rows = coarse ? 22 : 48;
  const std::int64_t columns = coarse ? 10 : 22;
  const double half = mean_axis * std::numbers::sqrt2;
  const double step_y = 2.0 * half / static_cast<double>(rows);
  const double step_x = 2.0 * half / static_cast<double>(columns);
  constexpr double combined_modulus = 115000.0;
  // Hertz: a^3 = 3 N R/(4 E*).
  const double radius = 4.0 * combined_modulus * std::pow(mean_axis, 3) / (3.0 * load);
  std::vector<double> distance;
  for (std::int64_t j = 0; j < rows; ++j) {
    for (std::int64_t i = 0; i < columns; ++i) {
      const double y = (static_cast<double>(j) + 0.5) * step_y - half;
      const double x = (static_cast<double>(i) + 0.5) * step_x - half;
      distance.push_back((x * x + y * y) / (2.0 * radius));
    }
  }
  wrcontact::NormalContact normal;
  normal.set_grid(rows, columns, step_y, step_x);
  normal.set_distance(distance);
  normal.set("combined_modulus", combined_modulus);
  normal.set("normal_load", load);
  normal.set("tolerance", 0.2 * accuracy);
  std::vector<double> times;
  for (int i = 0; i <= repeat; ++i) {
    ProcessorStopwatch watch;
    normal.solve();
    if (i > 0) { // the first one makes plans
      times.push_back(watch.lap());
    }
  }
  return median(times);
}

RollingRow measure_row(RollingRow row, const std::vector<Ellipse>& ellipses,
                       const std::vector<Forces>& truths, int repeat) {
  wrcontact::RollingContact rolling = new_contact();
  Yardstick yardstick{GridSize()};
  std::vector<double> warm;
  std::vector<double> new_ratio;
  double squares = 0.0;
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    if (i % 10 == 0) {
      yardstick.sample();
    }
    set_up(rolling, ellipses[i], row);
    ProcessorStopwatch watch;
    const bool converged = rolling.solve();
    if (i > 0) { // the first one makes plans
      new_ratio.push_back(watch.lap());
    }
    row.failures += converged ? 0 : 1;
    row.convolutions += rolling.number("convolutions") / static_cast<double>(ellipses.size());
    const Forces forces = forces_of(rolling);
    double error = 0.0;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      error = std::max(error, std::abs(forces.at(k) - truths[i].at(k)));
    }
    squares += error * error;
    row.error_max = std::max(row.error_max, error);
    rolling.set("poisson", ellipses[i].poisson); // the same again: nothing is kept but what is set
    ProcessorStopwatch again;
    rolling.solve();
    warm.push_back(again.lap());
  }
  row.error_rms = std::sqrt(squares / static_cast<double>(ellipses.size()));
  row.warm_ms = median(warm);
  row.new_ratio_ms = median(new_ratio);
  row.normal_ms = measure_normal(row.tolerance, repeat);
  row.fft_pair_ms = yardstick.milliseconds();
  row.cases = static_cast<int>(ellipses.size());
  return row;
}

} // namespace

std::vector<RollingRow> measure_rolling(int repeat) {
  const std::vector<Ellipse> ellipses = draw_ellipses(40);
  RollingRow finest;
  finest.along = 192;
  finest.across = 144;
  finest.tolerance = 1e-4;
  std::vector<Forces> truths;
  wrcontact::RollingContact rolling = new_contact();
  for (const Ellipse& ellipse : ellipses) {
    set_up(rolling, ellipse, finest);
    rolling.solve();
    truths.push_back(forces_of(rolling));
  }
  std::vector<RollingRow> rows;
  for (std::int64_t along = 8; along <= 256; along *= 2) {
    for (const double tolerance : {1e-2, 1e-3}) {
      RollingRow row;
      row.along = along;
      row.across = along / 2;
      row.tolerance = tolerance;
      rows.push_back(measure_row(row, ellipses, truths, repeat));
      std::cerr << "wrc_benchmark: rolling, " << along << 'x' << along / 2 << ", "
                << driver::power(tolerance, 0) << ": " << driver::fixed(rows.back().warm_ms, 3)
                << " ms\n";
    }
  }
  return rows;
}

driver::json json_of(const RollingRow& row) {
  return {{"case", "rolling"},
          {"model", "full"},
          {"grid", {row.across, row.along}},
          {"tolerance", row.tolerance},
          {"error_rms", row.error_rms},
          {"error_max", row.error_max},
          {"convolutions", row.convolutions},
          {"warm_ms", row.warm_ms},
          {"new_ratio_ms", row.new_ratio_ms},
          {"normal_ms", row.normal_ms},
          {"over_normal", row.warm_ms / row.normal_ms},
          {"fft_pair_ms", row.fft_pair_ms},
          {"pairs", row.pairs()},
          {"cases", row.cases},
          {"failures", row.failures}};
}

void print_rolling(const std::vector<RollingRow>& rows) {
  if (rows.empty()) {
    return;
  }
  using driver::fixed;
  using driver::power;
  driver::TextTable table("llr");
  table.add({"case", "along x across", "toler.", "error rms", "worst", "convol.", "warm us",
             "new ratio", "normal us", "over it", "pairs", "failed"});
  for (const RollingRow& row : rows) {
    table.add({"rolling", std::to_string(row.along) + 'x' + std::to_string(row.across),
               power(row.tolerance, 0), power(row.error_rms, 1), power(row.error_max, 1),
               fixed(row.convolutions, 1), fixed(1e3 * row.warm_ms, 0),
               fixed(1e3 * row.new_ratio_ms, 0), fixed(1e3 * row.normal_ms, 0),
               fixed(row.warm_ms / row.normal_ms, 2), fixed(row.pairs(), 2),
               std::to_string(row.failures)});
  }
  table.print(std::cout);
  std::cout
      << "\n  " << rows.front().cases
      << " ellipses, a/b 0.2 to 5, 0.1 to 10 times the creepage of saturation, spin included; the "
         "grid is the rectangle\n  around the ellipse. error: of Fx and Fy over mu N and of Mz "
         "over "
         "mu N sqrt(a b), the largest of the three, against\n  192x144 elements solved to 1e-4. "
         "warm: elements as before. new ratio: of sides, with influence coefficients and\n  "
         "transforms planned again. normal: the normal contact of such a patch at 1e-2 or 1e-3. "
         "pairs: "
         "warm over one transform\n  of twice 256x128 and back. Processor times, medians.\n\n";
}

} // namespace benchmark
