#include <algorithm>
#include <cmath>

#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/statistics.hpp"
#include "support/text_table.hpp"
#include "wrc_tradeoff/creep.hpp"

namespace tradeoff {
namespace {

using driver::general;
using driver::json;
using driver::quantile;

constexpr std::size_t printed_creep_misses = 10;

bool is_full(const CreepWay& way) {
  return std::string(way.model) == "full";
}

/// Calls `take(measured, run, wheel index, patch index, error)` for each patch of a way.
template <class Take>
void for_each_patch(const std::vector<CreepMeasured>& all, std::size_t way, Take take) {
  for (const CreepMeasured& measured : all) {
    for (std::size_t side = 0; side < 2 && measured.failure.empty(); ++side) {
      const auto& patches = measured.runs[way].wheels[side].patches;
      for (std::size_t i = 0; i < patches.size(); ++i) {
        take(measured, measured.runs[way], side, i, patches[i]);
      }
    }
  }
}

CreepRow row_of(const std::vector<CreepMeasured>& all, std::size_t index) {
  const CreepWay& way = creep_ways[index];
  CreepRow row;
  row.model = way.model;
  row.accuracy = way.accuracy;
  std::array<std::vector<double>, 3> errors;
  std::vector<double> ratios;
  double met = 0.0;
  double bounded = 0.0;
  for_each_patch(all, index, [&](const auto&, const auto&, auto, auto, const CreepError& error) {
    for (std::size_t k = 0; k < errors.size(); ++k) {
      errors[k].push_back(std::abs(error.values[k]));
      row.rms[k] += error.values[k] * error.values[k];
    }
    const double largest = error.largest();
    const double estimate = error.estimate.value_or(0.0);
    ratios.push_back(estimate / largest);
    met += largest <= way.accuracy ? 1.0 : 0.0;
    bounded += estimate >= largest ? 1.0 : 0.0;
  });
  const auto count = static_cast<double>(ratios.size());
  row.patches = static_cast<int>(ratios.size());
  for (std::size_t k = 0; k < errors.size(); ++k) {
    row.rms[k] = std::sqrt(row.rms[k] / count);
    row.error_99[k] = quantile(errors[k], 0.99);
    row.worst[k] = quantile(errors[k], 1.0);
  }
  std::vector<double> times;
  for (const CreepMeasured& measured : all) {
    if (measured.failure.empty()) {
      times.push_back(measured.runs[index].time_us);
      for (const CreepWheel& wheel : measured.runs[index].wheels) {
        row.left_out += wheel.comparable ? 0 : 1;
      }
    }
  }
  row.median_us = driver::median(times);
  if (is_full(way)) {
    row.met = met / count;
    row.bounded = bounded / count;
    row.median_estimate = driver::median(ratios);
  }
  return row;
}

/// In %, those of Fx, Fy, Mz.
std::string percent(const std::array<double, 3>& errors) {
  std::string text;
  for (const double error : errors) {
    text += (text.empty() ? "" : ", ") + general(100.0 * error, error < 0.1 ? 2 : 3);
  }
  return text;
}

std::string percent(const std::optional<double>& share) {
  return share ? driver::fixed(100.0 * *share, 1) : "-";
}

/// Missed accuracies of the full theory, worst first, each with options of wrc_case that replay it.
void print_creep_misses(const std::vector<CreepMeasured>& all, std::ostream& out) {
  struct CreepMiss {
    double ratio = 0.0;
    std::string text;
  };
  std::vector<CreepMiss> misses;
  for (std::size_t way = 0; way < creep_ways.size(); ++way) {
    const double asked = creep_ways[way].accuracy;
    if (!is_full(creep_ways[way])) {
      continue;
    }
    for_each_patch(
        all, way,
        [&](const CreepMeasured& measured, const auto&, std::size_t side, std::size_t i,
            const CreepError& error) {
          if (error.largest() > asked) {
            misses.push_back(
                {error.largest() / asked,
                 "requested " + general(asked) + ": error " + general(error.largest(), 3) +
                     ", estimate " + general(error.estimate.value_or(0.0), 3) + "; " +
                     driver::side_names[side] + ", patch " + std::to_string(i) + ", " +
                     measured.settings.options() + " --set solve.accuracy=" + general(asked) +
                     " --set solve.accuracy_of=forces"});
          }
        });
  }
  std::stable_sort(misses.begin(), misses.end(),
                   [](const CreepMiss& a, const CreepMiss& b) { return a.ratio > b.ratio; });
  out << '\n' << misses.size() << " accuracies missed by the full theory, worst first\n";
  for (std::size_t i = 0; i < std::min(printed_creep_misses, misses.size()); ++i) {
    out << "  " << misses[i].text << '\n';
  }
}

} // namespace

std::vector<CreepRow> creep_rows(const std::vector<CreepMeasured>& all) {
  std::vector<CreepRow> rows;
  for (std::size_t i = 0; i < creep_ways.size(); ++i) {
    rows.push_back(row_of(all, i));
  }
  return rows;
}

void print_creep_summary(const std::vector<CreepMeasured>& all, std::ostream& out) {
  out << all.size() << " scenes, "
      << std::count_if(all.begin(), all.end(),
                       [](const CreepMeasured& measured) { return !measured.failure.empty(); })
      << " without a solution\n";
  for (const CreepMeasured& measured : all) {
    if (!measured.failure.empty()) {
      out << "  " << measured.settings.options() << ": " << measured.failure << '\n';
    }
  }
  driver::TextTable table("lr");
  table.add({"solve.creep", "accuracy", "patches", "left out", "rms", "99 %", "worst", "us",
             "met %", "estimate", ""});
  table.add({"", "", "", "wheels", "", "", "", "", "", "bounds %", "over error"});
  for (const CreepRow& row : creep_rows(all)) {
    table.add({row.model, general(row.accuracy), std::to_string(row.patches),
               std::to_string(row.left_out), percent(row.rms), percent(row.error_99),
               percent(row.worst), general(row.median_us, 3), percent(row.met),
               percent(row.bounded), row.median_estimate ? general(*row.median_estimate, 2) : "-"});
  }
  out << "\nErrors of Fx, Fy in % of mu N, of Mz in % of mu N c, against the full theory at "
      << general(creep_truth_accuracy) << "; time of the creep forces per patch\n";
  table.print(out);
  print_creep_misses(all, out);
}

json creep_json_of(const std::vector<CreepMeasured>& all) {
  json whole;
  for (const CreepRow& row : creep_rows(all)) {
    json one{{"creep", row.model},       {"accuracy", row.accuracy}, {"patches", row.patches},
             {"left_out", row.left_out}, {"rms", row.rms},           {"error_99", row.error_99},
             {"worst", row.worst},       {"us", row.median_us}};
    driver::add_if(one, "met", row.met);
    driver::add_if(one, "estimate_bounds", row.bounded);
    driver::add_if(one, "estimate_over_error", row.median_estimate);
    whole["creep"].push_back(std::move(one));
  }
  for (const CreepMeasured& measured : all) {
    json scene{{"options", measured.settings.options()}};
    driver::add_if(scene, "failure", measured.failure);
    whole["scenes"].push_back(std::move(scene));
  }
  return whole;
}

} // namespace tradeoff
