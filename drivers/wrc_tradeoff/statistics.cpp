#include "wrc_tradeoff/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {
namespace {

/// Calls `take(measured, run, wheel index, cold or warm error)` for each wheel of a way.
template <class Take>
void for_each_wheel(const std::vector<Measured>& all, const std::string& label, double accuracy,
                    Take take) {
  for (const Measured& measured : all) {
    for (const Run& run : measured.runs) {
      if (run.way.label == label && run.way.accuracy == accuracy) {
        for (std::size_t side = 0; side < 2; ++side) {
          take(measured, run, side, run.cold[side], true);
          take(measured, run, side, run.warm[side], false);
        }
      }
    }
  }
}

double share(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

} // namespace

std::vector<AskedRow> asked_rows(const std::vector<Measured>& all) {
  std::vector<AskedRow> rows;
  for (const char* label : {"auto", "double"}) {
    for (const double asked : accuracies) {
      std::vector<double> errors;
      std::vector<double> ratios;
      std::vector<double> warm;
      std::vector<double> cold;
      double met = 0.0;
      double bounded = 0.0;
      double told = 0.0;
      for_each_wheel(all, label, asked,
                     [&](const Measured&, const Run& run, std::size_t side, const WheelError& error,
                         bool is_cold) {
                       const double both = error.controlled();
                       errors.push_back(both);
                       met += both <= asked ? 1.0 : 0.0;
                       const double estimate = error.estimate.value_or(0.0);
                       bounded += estimate >= both ? 1.0 : 0.0;
                       ratios.push_back(estimate / both);
                       told += both > asked && estimate > asked ? 1.0 : 0.0;
                       if (is_cold && side == 0) {
                         warm.push_back(run.warm_ms);
                         cold.push_back(run.cold_ms);
                       }
                     });
      const auto count = static_cast<double>(errors.size());
      rows.push_back({label, asked, static_cast<int>(errors.size()), share(met, count),
                      median(errors), quantile(errors, 0.95), quantile(errors, 0.99),
                      quantile(errors, 1.0), share(bounded, count), median(ratios),
                      share(told, count - met), median(warm), median(cold)});
    }
  }
  return rows;
}

std::vector<Miss> misses(const std::vector<Measured>& all) {
  std::vector<Miss> list;
  for (const char* label : {"auto", "double"}) {
    for (const double asked : accuracies) {
      for_each_wheel(all, label, asked,
                     [&](const Measured& measured, const Run&, std::size_t side,
                         const WheelError& error, bool is_cold) {
                       if (error.controlled() > asked) {
                         list.push_back({measured.scene.text(), measured.scene.group,
                                         side == 0 ? "left" : "right", is_cold ? "cold" : "warm",
                                         label, error.warnings, asked, error.pmax, error.approach,
                                         error.estimate.value_or(0.0),
                                         measured.truth_uncertainty[side]});
                       }
                     });
    }
  }
  std::stable_sort(list.begin(), list.end(), [](const Miss& one, const Miss& other) {
    return std::max(one.pmax, one.approach) / one.asked >
           std::max(other.pmax, other.approach) / other.asked;
  });
  return list;
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
      for_each_wheel(
          all, label, 0.0,
          [&](const Measured&, const Run& run, std::size_t, const WheelError& error, bool is_cold) {
            const double validity = error.validity.value_or(0.0);
            if (is_cold && validity >= row.validity_from && validity < row.validity_to) {
              pmax.push_back(error.pmax);
              approach.push_back(error.approach);
              times.push_back(run.warm_ms);
              within += error.controlled() <= 0.1 ? 1.0 : 0.0;
            }
          });
      row.samples = static_cast<int>(pmax.size());
      row.median_pmax = median(pmax);
      row.pmax_95 = quantile(pmax, 0.95);
      row.worst_pmax = quantile(pmax, 1.0);
      row.median_approach = median(approach);
      row.approach_95 = quantile(approach, 0.95);
      row.within_10 = share(within, static_cast<double>(pmax.size()));
      row.median_warm_ms = median(times);
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
        const double error = std::max(run.warm[0].controlled(), run.warm[1].controlled());
        if (run.way.label == "grid" && error <= asked) {
          best = std::min(best, run.warm_ms);
        }
        if (run.way.label == "auto" && run.way.accuracy == asked) {
          automatic = run.warm_ms;
        }
      }
      if (std::isfinite(best)) {
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
