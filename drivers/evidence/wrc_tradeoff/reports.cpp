#include "wrc_tradeoff/reports.hpp"

#include <algorithm>

#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/text_table.hpp"

namespace tradeoff {
namespace {

using driver::general;
using driver::json;
using driver::TextTable;

constexpr std::size_t printed_misses = 40;

json json_of(const WheelError& error) {
  json made;
  for (std::size_t i = 0; i < quantity_names.size(); ++i) {
    made[quantity_names[i]] = error.values[i];
  }
  driver::add_if(made, "estimate", error.estimate);
  driver::add_if(made, "validity", error.validity);
  driver::add_if(made, "warnings", error.warnings);
  return made;
}

/// A row of numbers with three digits behind its first cells.
std::vector<std::string> row_of(std::vector<std::string> cells, const std::vector<double>& values) {
  for (const double value : values) {
    cells.push_back(general(value, 3));
  }
  return cells;
}

void print_requested(const std::vector<Measured>& all, std::ostream& out) {
  TextTable table("lr");
  table.add({"accuracy of", "requested", "wheels", "reference", "met %", "median", "95 %", "99 %",
             "worst/", "estimate", "estimate/", "misses", "ms"});
  table.add(
      {"", "", "", "uncertain", "", "", "", "", "requested", "bounds %", "error", "warned %", ""});
  for (const AskedRow& row : asked_rows(all)) {
    table.add(row_of({row.label},
                     {row.asked, double(row.samples), double(row.left_out), 100.0 * row.met,
                      row.median_error, row.error_95, row.error_99, row.worst, 100.0 * row.bounded,
                      row.median_estimate, 100.0 * row.reported, row.median_ms}));
  }
  out << "\nLargest error of the results that the accuracy covers; times for both wheels\n";
  table.print(out);
}

void print_quantities(const std::vector<Measured>& all, std::ostream& out) {
  TextTable table("lr");
  std::vector<std::string> head{"accuracy of", "requested"};
  for (std::size_t i = 0; i < quantity_names.size(); ++i) {
    head.push_back(name_of(static_cast<Quantity>(i)));
  }
  table.add(head);
  for (const AskedRow& row : asked_rows(all)) {
    std::vector<double> values{row.asked};
    for (std::size_t i = 0; i < quantity_names.size(); ++i) {
      values.push_back(counted_95(all, row, static_cast<Quantity>(i)));
    }
    table.add(row_of({row.label}, values));
  }
  out << "\n95th percentile of the error, by quantity\n";
  table.print(out);
}

void print_models(const std::vector<Measured>& all, std::ostream& out) {
  TextTable table("llr");
  table.add({"model", "validity", "wheels", "pmax median", "95 %", "worst", "approach median",
             "95 %", "both < 10 %", "ms"});
  for (const ModelRow& row : model_rows(all)) {
    table.add(
        row_of({row.label, general(row.validity_from, 3) + " to " + general(row.validity_to, 3)},
               {double(row.samples), 100.0 * row.median_pmax, 100.0 * row.pmax_95,
                100.0 * row.worst_pmax, 100.0 * row.median_approach, 100.0 * row.approach_95,
                100.0 * row.within_10, row.median_ms}));
  }
  out << "\nModels by validity: errors in %\n";
  table.print(out);
}

void print_hands(const std::vector<Measured>& all, std::ostream& out) {
  TextTable table("r");
  table.add({"requested", "scenes", "median", "90 %", "within 1.5 times %"});
  for (const HandRow& row : hand_rows(all)) {
    table.add(row_of(
        {}, {row.asked, double(row.scenes), row.median_ratio, row.ratio_90, 100.0 * row.within}));
  }
  out << "\nTime of an accuracy of pressures over that of the best prescribed grid\n";
  table.print(out);
}

void print_misses(const std::vector<Measured>& all, std::ostream& out) {
  const std::vector<Miss> missed = misses(all);
  out << "\n" << missed.size() << " missed accuracies, worst first\n";
  for (std::size_t i = 0; i < std::min(printed_misses, missed.size()); ++i) {
    const Miss& miss = missed[i];
    out << "  " << miss.label << ", requested " << miss.asked << ": " << miss.quantity << ' '
        << miss.error << ", estimate " << miss.estimate << ", reference accurate to "
        << miss.truth_uncertainty << "; " << miss.side << ", " << miss.options
        << " --set solve.accuracy=" << miss.asked
        << " --set solve.accuracy_of=" << (miss.label == "forces" ? "forces" : "pressures")
        << (miss.label == "double" ? " (in double precision)" : "")
        << (miss.warnings.empty() ? "" : " [" + miss.warnings + ']') << '\n';
  }
}

bool has(const std::vector<Measured>& all, const std::string& label) {
  return std::any_of(all.begin(), all.end(), [&label](const Measured& measured) {
    return std::any_of(measured.runs.begin(), measured.runs.end(),
                       [&label](const Run& run) { return run.way.label == label; });
  });
}

} // namespace

void print_summary(const std::vector<Measured>& all, std::ostream& out) {
  const auto failed = std::count_if(
      all.begin(), all.end(), [](const Measured& measured) { return !measured.failure.empty(); });
  out << all.size() << " scenes, " << failed << " without a solution\n";
  for (const Measured& measured : all) {
    if (!measured.failure.empty()) {
      out << "  " << measured.scene.settings.options() << ": " << measured.failure << '\n';
    }
  }
  out.precision(3);
  print_requested(all, out);
  print_quantities(all, out);
  if (has(all, "hertz")) {
    print_models(all, out);
  }
  if (has(all, "grid") && has(all, "pressures")) {
    print_hands(all, out);
  }
  print_misses(all, out);
}

json json_of(const std::vector<Measured>& all) {
  json whole;
  for (const AskedRow& row : asked_rows(all)) {
    whole["asked"].push_back({{"way", row.label},
                              {"asked", row.asked},
                              {"wheels", row.samples},
                              {"truth_uncertain", row.left_out},
                              {"met", row.met},
                              {"median_error", row.median_error},
                              {"error_95", row.error_95},
                              {"error_99", row.error_99},
                              {"worst_over_asked", row.worst},
                              {"estimate_bounds", row.bounded},
                              {"estimate_over_error", row.median_estimate},
                              {"misses_reported", row.reported},
                              {"ms", row.median_ms}});
  }
  for (const HandRow& row : hand_rows(all)) {
    whole["against_grids"].push_back({{"asked", row.asked},
                                      {"scenes", row.scenes},
                                      {"median_ratio", row.median_ratio},
                                      {"ratio_90", row.ratio_90},
                                      {"within_1.5", row.within}});
  }
  for (const Measured& measured : all) {
    json scene{{"name", measured.scene.name},
               {"group", measured.scene.group},
               {"options", measured.scene.settings.options()}};
    driver::add_if(scene, "failure", measured.failure);
    if (measured.failure.empty()) {
      scene["truth"] = {
          {"pmax", measured.truth_pmax},
          {"uncertainty",
           {json_of(measured.truth_uncertainty[0]), json_of(measured.truth_uncertainty[1])}},
          {"patches", measured.patches}};
    }
    for (const Run& run : measured.runs) {
      scene["runs"].push_back({{"way", run.way.label},
                               {"accuracy", run.way.accuracy},
                               {"grid", run.way.grid},
                               {"ms", run.time_ms},
                               {"errors", {json_of(run.errors[0]), json_of(run.errors[1])}}});
    }
    whole["scenes"].push_back(std::move(scene));
  }
  return whole;
}

} // namespace tradeoff
