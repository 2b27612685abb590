#include "wrc_tradeoff/reports.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {
namespace {

/// Whether a truth says anything of an accuracy: it must be good to half of that.
bool judges(WheelError uncertainty, const Way& way) {
  uncertainty.area_share = area_in_accuracies(way.accuracy);
  return way.accuracy == 0.0 || uncertainty.controlled(way.label) <= 0.5 * way.accuracy;
}

/// Calls `take(measured, run, wheel index, error)` for each wheel of a way with a converged
/// reference, and returns the number without one.
template <class Take>
int for_each_wheel(const std::vector<Measured>& all, const std::string& label, double accuracy,
                   Take take) {
  int left_out = 0;
  for (const Measured& measured : all) {
    for (const Run& run : measured.runs) {
      if (run.way.label != label || run.way.accuracy != accuracy) {
        continue;
      }
      for (std::size_t side = 0; side < 2; ++side) {
        if (judges(measured.truth_uncertainty[side], run.way)) {
          take(measured, run, side, run.errors[side]);
        } else {
          ++left_out;
        }
      }
    }
  }
  return left_out;
}

double share(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

AskedRow asked_row(const std::vector<Measured>& all, const std::string& label, double asked) {
  AskedRow row{label, asked};
  std::vector<double> errors;
  std::vector<double> ratios;
  std::vector<double> times;
  double met = 0.0;
  double bounded = 0.0;
  double reported = 0.0;
  row.left_out =
      for_each_wheel(all, label, asked,
                     [&](const Measured&, const Run& run, std::size_t, const WheelError& wheel) {
                       const double error = wheel.controlled(label);
                       const double estimate = wheel.estimate.value_or(0.0);
                       errors.push_back(error);
                       ratios.push_back(estimate / error);
                       times.push_back(run.time_ms);
                       bounded += estimate >= error ? 1.0 : 0.0;
                       met += error <= asked ? 1.0 : 0.0;
                       reported += error > asked && estimate > asked ? 1.0 : 0.0;
                     });
  const auto count = static_cast<double>(errors.size());
  row.samples = static_cast<int>(errors.size());
  row.met = share(met, count);
  row.median_error = median(errors);
  row.error_95 = quantile(errors, 0.95);
  row.error_99 = quantile(errors, 0.99);
  row.worst = quantile(errors, 1.0) / asked;
  row.bounded = share(bounded, count);
  row.median_estimate = median(ratios);
  row.reported = share(reported, count - met);
  row.median_ms = median(times);
  return row;
}

} // namespace

std::vector<AskedRow> asked_rows(const std::vector<Measured>& all) {
  std::vector<AskedRow> rows;
  for (const char* label : asked_labels) {
    for (const double asked : accuracies) {
      const AskedRow row = asked_row(all, label, asked);
      if (row.samples > 0) {
        rows.push_back(row);
      }
    }
  }
  return rows;
}

std::string name_of(Quantity quantity) {
  const std::string name = quantity_names[static_cast<std::size_t>(quantity)];
  return quantity == Quantity::area ? name + " / allowance" : name;
}

double counted_95(const std::vector<Measured>& all, const AskedRow& row, Quantity quantity) {
  std::vector<double> errors;
  for_each_wheel(all, row.label, row.asked,
                 [&](const Measured&, const Run&, std::size_t, const WheelError& wheel) {
                   errors.push_back(wheel.counted(quantity));
                 });
  return quantile(errors, 0.95);
}

std::vector<Miss> misses(const std::vector<Measured>& all) {
  std::vector<Miss> list;
  for (const AskedRow& row : asked_rows(all)) {
    for_each_wheel(
        all, row.label, row.asked,
        [&](const Measured& measured, const Run&, std::size_t side, const WheelError& wheel) {
          const Quantity worst = wheel.largest(row.label);
          if (wheel.counted(worst) > row.asked) {
            list.push_back({measured.scene.settings.options(), side == 0 ? "left" : "right",
                            row.label, name_of(worst), wheel.warnings, row.asked,
                            wheel.counted(worst), wheel.estimate.value_or(0.0),
                            measured.truth_uncertainty[side].counted(worst)});
          }
        });
  }
  std::stable_sort(list.begin(), list.end(), [](const Miss& one, const Miss& other) {
    return one.error / one.asked > other.error / other.asked;
  });
  return list;
}

bool is_within(const WheelError& error, double limit) {
  return std::max(error.of(Quantity::pmax), error.of(Quantity::depth)) <= limit;
}

std::vector<ModelRow> model_rows(const std::vector<Measured>& all) {
  constexpr std::array limits{0.0, 1e-9, 0.5, 0.7, 0.8, 0.9, 0.95, 1.01};
  std::vector<ModelRow> rows;
  for (const char* label : {"hertz", "kik-piotrowski"}) {
    for (std::size_t i = 0; i + 1 <= limits.size(); ++i) {
      // Last of all the whole range.
      const bool whole = i + 1 == limits.size();
      ModelRow row;
      row.label = label;
      row.validity_from = whole ? 0.0 : limits[i];
      row.validity_to = whole ? limits.back() : limits[i + 1];
      std::vector<double> pmax;
      std::vector<double> approach;
      std::vector<double> times;
      double within = 0.0;
      for_each_wheel(all, label, 0.0,
                     [&](const Measured&, const Run& run, std::size_t, const WheelError& error) {
                       const double validity = error.validity.value_or(0.0);
                       if (validity < row.validity_from || validity >= row.validity_to) {
                         return;
                       }
                       pmax.push_back(error.of(Quantity::pmax));
                       approach.push_back(error.of(Quantity::depth));
                       times.push_back(run.time_ms);
                       within += is_within(error, 0.1) ? 1.0 : 0.0;
                     });
      row.samples = static_cast<int>(pmax.size());
      row.median_pmax = median(pmax);
      row.pmax_95 = quantile(pmax, 0.95);
      row.worst_pmax = quantile(pmax, 1.0);
      row.median_approach = median(approach);
      row.approach_95 = quantile(approach, 0.95);
      row.within_10 = share(within, static_cast<double>(pmax.size()));
      row.median_ms = median(times);
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<HandRow> hand_rows(const std::vector<Measured>& all) {
  std::vector<HandRow> rows;
  for (const double asked : accuracies) {
    std::vector<double> ratios;
    double within = 0.0;
    for (const Measured& measured : all) {
      double best = std::numeric_limits<double>::infinity();
      double automatic = 0.0;
      for (const Run& run : measured.runs) {
        const double error =
            std::max(run.errors[0].controlled("pressures"), run.errors[1].controlled("pressures"));
        if (run.way.label == "grid" && error <= asked) {
          best = std::min(best, run.time_ms);
        }
        if (run.way.label == "pressures" && run.way.accuracy == asked) {
          automatic = run.time_ms;
        }
      }
      if (std::isfinite(best) && automatic > 0.0) {
        ratios.push_back(automatic / best);
        within += automatic <= 1.5 * best ? 1.0 : 0.0;
      }
    }
    rows.push_back({asked, static_cast<int>(ratios.size()), median(ratios), quantile(ratios, 0.9),
                    share(within, static_cast<double>(ratios.size()))});
  }
  return rows;
}

} // namespace tradeoff
