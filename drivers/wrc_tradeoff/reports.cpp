#include "wrc_tradeoff/reports.hpp"

#include <algorithm>
#include <iomanip>

#include <nlohmann/json.hpp>

#include "wrc_tradeoff/statistics.hpp"

namespace tradeoff {
namespace {

using nlohmann::json;

constexpr std::size_t printed_misses = 40;
constexpr std::array side_names{"left", "right"};

json json_of(const WheelError& error) {
  json made;
  for (std::size_t i = 0; i < quantity_names.size(); ++i) {
    made[quantity_names[i]] = error.values[i];
  }
  if (error.estimate) {
    made["estimate"] = *error.estimate;
  }
  if (error.validity) {
    made["validity"] = *error.validity;
  }
  if (!error.warnings.empty()) {
    made["warnings"] = error.warnings;
  }
  return made;
}

void print_asked(const std::vector<Measured>& all, std::ostream& out) {
  out << "\nLargest error of what the accuracy is of; both wheels\n"
         "accuracy of  asked    wheels   met %    median      95 %      99 %   worst/  estimate"
         "            misses   misses\n                                                       "
         "                asked  bounds %  over error   told %  doubtful       ms\n";
  for (const AskedRow& row : asked_rows(all)) {
    out << std::left << std::setw(11) << row.label << std::right << std::setw(7) << row.asked
        << std::setw(10) << row.samples << std::setw(8) << 100.0 * row.met << std::setw(10)
        << row.median_error << std::setw(10) << row.error_95 << std::setw(10) << row.error_99
        << std::setw(9) << row.worst << std::setw(10) << 100.0 * row.bounded << std::setw(12)
        << row.median_estimate << std::setw(9) << 100.0 * row.told << std::setw(10) << row.doubtful
        << std::setw(9) << row.median_ms << '\n';
  }
}

void print_quantities(const std::vector<Measured>& all, std::ostream& out) {
  out << "\nError that 95 of 100 wheels are below, by quantity\naccuracy of  asked";
  for (std::size_t i = 0; i < quantity_names.size(); ++i) {
    out << "  " << std::setw(8) << name_of(static_cast<Quantity>(i));
  }
  out << '\n';
  for (const AskedRow& row : asked_rows(all)) {
    out << std::left << std::setw(11) << row.label << std::right << std::setw(7) << row.asked;
    for (std::size_t i = 0; i < quantity_names.size(); ++i) {
      const auto quantity = static_cast<Quantity>(i);
      out << std::setw(static_cast<int>(std::max<std::size_t>(name_of(quantity).size(), 8)) + 2)
          << counted_95(all, row, quantity);
    }
    out << '\n';
  }
}

void print_models(const std::vector<Measured>& all, std::ostream& out) {
  out << "\nModels by validity: errors in %\n"
         "model           validity        wheels  pmax median  95 %  worst  approach median  95 % "
         " both < 10 %       ms\n";
  for (const ModelRow& row : model_rows(all)) {
    out << std::left << std::setw(16) << row.label << std::setw(5) << row.validity_from << "to "
        << std::setw(6) << row.validity_to << std::right << std::setw(8) << row.samples
        << std::setw(12) << 100.0 * row.median_pmax << std::setw(8) << 100.0 * row.pmax_95
        << std::setw(7) << 100.0 * row.worst_pmax << std::setw(12) << 100.0 * row.median_approach
        << std::setw(9) << 100.0 * row.approach_95 << std::setw(12) << 100.0 * row.within_10
        << std::setw(10) << row.median_ms << '\n';
  }
}

void print_hands(const std::vector<Measured>& all, std::ostream& out) {
  out << "\nTime of an accuracy of pressures over that of the best grid by hand\n"
         "asked    scenes  median   90 %  within 1.5 times %\n";
  for (const HandRow& row : hand_rows(all)) {
    out << std::left << std::setw(8) << row.asked << std::right << std::setw(7) << row.scenes
        << std::setw(8) << row.median_ratio << std::setw(7) << row.ratio_90 << std::setw(10)
        << 100.0 * row.within << '\n';
  }
}

void print_misses(const std::vector<Measured>& all, std::ostream& out) {
  const std::vector<Miss> missed = misses(all);
  out << "\n" << missed.size() << " misses, worst first\n";
  for (std::size_t i = 0; i < std::min(printed_misses, missed.size()); ++i) {
    const Miss& miss = missed[i];
    out << "  " << miss.label << ", asked " << miss.asked << ": " << miss.quantity << ' '
        << miss.error << ", estimate " << miss.estimate << ", truth good to "
        << miss.truth_uncertainty << "; " << miss.side << ", " << miss.options
        << " --set solve.accuracy=" << miss.asked
        << " --set solve.accuracy_of=" << (miss.label == "forces" ? "forces" : "pressures")
        << (miss.label == "double" ? " --set solve.precision=double" : "")
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
  out << all.size() << " scenes, " << failed << " of them without a solution\n";
  for (const Measured& measured : all) {
    if (!measured.failure.empty()) {
      out << "  " << measured.scene.settings.options() << ": " << measured.failure << '\n';
    }
  }
  out << std::setprecision(3);
  print_asked(all, out);
  print_quantities(all, out);
  if (has(all, "hertz")) {
    print_models(all, out);
  }
  if (has(all, "grid") && has(all, "pressures")) {
    print_hands(all, out);
  }
  print_misses(all, out);
}

void print_csv(const std::vector<Measured>& all, std::ostream& out) {
  out << std::setprecision(9)
      << "scene,group,side,lateral,yaw,load,way,asked,grid_lateral,grid_longitudinal,time_ms";
  for (const char* name : quantity_names) {
    out << ",error_" << name;
  }
  out << ",estimate,validity,patches,truth_pmax,truth_uncertainty_forces,"
         "truth_uncertainty_pressures\n";
  for (const Measured& measured : all) {
    const driver::Settings& scene = measured.scene.settings;
    for (const Run& run : measured.runs) {
      for (std::size_t side = 0; side < 2; ++side) {
        const WheelError& error = run.errors[side];
        out << measured.scene.name << ',' << measured.scene.group << ',' << side_names[side] << ','
            << scene.number_or("pose.lateral", 0.0) << ',' << scene.number_or("pose.yaw", 0.0)
            << ',' << load_of(scene, side) << ',' << run.way.label << ',' << run.way.accuracy << ','
            << run.way.grid[0] << ',' << run.way.grid[1] << ',' << run.time_ms;
        for (const double value : error.values) {
          out << ',' << value;
        }
        out << ',';
        if (error.estimate) {
          out << *error.estimate;
        }
        out << ',';
        if (error.validity) {
          out << *error.validity;
        }
        out << ',' << measured.patches[side] << ',' << measured.truth_pmax[side] << ','
            << measured.truth_uncertainty[side].controlled("forces") << ','
            << measured.truth_uncertainty[side].controlled("pressures") << '\n';
      }
    }
  }
}

void print_json(const std::vector<Measured>& all, std::ostream& out) {
  json whole;
  for (const AskedRow& row : asked_rows(all)) {
    whole["asked"].push_back({{"way", row.label},
                              {"asked", row.asked},
                              {"wheels", row.samples},
                              {"met", row.met},
                              {"median_error", row.median_error},
                              {"error_95", row.error_95},
                              {"error_99", row.error_99},
                              {"worst_over_asked", row.worst},
                              {"estimate_bounds", row.bounded},
                              {"estimate_over_error", row.median_estimate},
                              {"misses_told", row.told},
                              {"misses_doubtful", row.doubtful},
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
    if (!measured.failure.empty()) {
      scene["failure"] = measured.failure;
    } else {
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
  out << whole.dump(1) << '\n';
}

} // namespace tradeoff
