#include "wrc_tradeoff/reports.hpp"

#include <algorithm>
#include <iomanip>

#include <nlohmann/json.hpp>

#include "wrc_tradeoff/statistics.hpp"

namespace tradeoff {
namespace {

using nlohmann::json;

constexpr std::size_t printed_misses = 40;

json json_of(const WheelError& error) {
  json made{{"pmax", error.pmax},
            {"approach", error.approach},
            {"area", error.area},
            {"normal_force", error.normal_force}};
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

} // namespace

void print_summary(const std::vector<Measured>& all, std::ostream& out) {
  const auto failed = std::count_if(
      all.begin(), all.end(), [](const Measured& measured) { return !measured.failure.empty(); });
  out << all.size() << " scenes, " << failed << " of them without a solution\n";
  for (const Measured& measured : all) {
    if (!measured.failure.empty()) {
      out << "  " << measured.scene.text() << ": " << measured.failure << '\n';
    }
  }
  out << std::setprecision(3)
      << "\nErrors of pmax and approach, the larger one; both wheels, cold and warm\n"
         "way      asked    wheels   met %    median      95 %      99 %     worst   estimate"
         "\n                                                                        bounds %"
         "  over error  warm ms  cold ms\n";
  for (const AskedRow& row : asked_rows(all)) {
    out << std::left << std::setw(8) << row.label << std::right << std::setw(7) << row.asked
        << std::setw(9) << row.samples << std::setw(8) << 100.0 * row.met << std::setw(10)
        << row.median_error << std::setw(10) << row.error_95 << std::setw(10) << row.error_99
        << std::setw(10) << row.worst << std::setw(9) << 100.0 * row.bounded << std::setw(11)
        << row.median_estimate << std::setw(10) << row.median_warm_ms << std::setw(9)
        << row.median_cold_ms << '\n';
  }
  out << "\nModels by validity: errors in %\n"
         "model           validity        wheels  pmax median  95 %  worst  approach median  95 % "
         " both < 10 %  warm ms\n";
  for (const ModelRow& row : model_rows(all)) {
    out << std::left << std::setw(16) << row.label << std::setw(5) << row.validity_from << "to "
        << std::setw(6) << row.validity_to << std::right << std::setw(8) << row.samples
        << std::setw(12) << 100.0 * row.median_pmax << std::setw(8) << 100.0 * row.pmax_95
        << std::setw(7) << 100.0 * row.worst_pmax << std::setw(12) << 100.0 * row.median_approach
        << std::setw(9) << 100.0 * row.approach_95 << std::setw(12) << 100.0 * row.within_10
        << std::setw(10) << row.median_warm_ms << '\n';
  }
  out << "\nTime of auto over that of the best grid by hand, warm\n"
         "asked    scenes  median   90 %  within 1.5 times %\n";
  for (const HandRow& row : hand_rows(all)) {
    out << std::left << std::setw(8) << row.asked << std::right << std::setw(7) << row.scenes
        << std::setw(8) << row.median_ratio << std::setw(7) << row.ratio_90 << std::setw(10)
        << 100.0 * row.within << '\n';
  }
  const std::vector<Miss> missed = misses(all);
  out << "\n" << missed.size() << " misses, worst first\n";
  for (std::size_t i = 0; i < std::min(printed_misses, missed.size()); ++i) {
    const Miss& miss = missed[i];
    out << "  " << miss.label << ' ' << miss.state << " asked " << miss.asked << ": pmax "
        << miss.pmax << ", approach " << miss.approach << ", estimate " << miss.estimate
        << ", truth good to " << miss.truth_uncertainty << "; " << miss.side << ", " << miss.scene
        << (miss.warnings.empty() ? "" : " [" + miss.warnings + ']') << '\n';
  }
}

void print_csv(const std::vector<Measured>& all, std::ostream& out) {
  out << std::setprecision(9)
      << "scene,group,side,lateral,yaw,load,way,asked,grid_lateral,grid_longitudinal,state,"
         "time_ms,error_pmax,error_approach,error_area,error_normal_force,estimate,validity,"
         "patches,truth_pmax,truth_uncertainty\n";
  for (const Measured& measured : all) {
    for (const Run& run : measured.runs) {
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t side = i % 2;
        const bool cold = i < 2;
        const WheelError& error = cold ? run.cold[side] : run.warm[side];
        out << measured.scene.name << ',' << measured.scene.group << ','
            << (side == 0 ? "left" : "right") << ','
            << measured.scene.number_or("pose.lateral", 0.0) << ','
            << measured.scene.number_or("pose.yaw", 0.0) << ','
            << measured.scene.number_or("load.vertical", 80000.0) << ',' << run.way.label << ','
            << run.way.accuracy << ',' << run.way.grid[0] << ',' << run.way.grid[1] << ','
            << (cold ? "cold," : "warm,") << (cold ? run.cold_ms : run.warm_ms) << ',' << error.pmax
            << ',' << error.approach << ',' << error.area << ',' << error.normal_force << ',';
        if (error.estimate) {
          out << *error.estimate;
        }
        out << ',';
        if (error.validity) {
          out << *error.validity;
        }
        out << ',' << measured.patches[side] << ',' << measured.truth_pmax[side] << ','
            << measured.truth_uncertainty[side] << '\n';
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
                              {"worst", row.worst},
                              {"estimate_bounds", row.bounded},
                              {"estimate_over_error", row.median_estimate},
                              {"misses_told", row.told},
                              {"warm_ms", row.median_warm_ms},
                              {"cold_ms", row.median_cold_ms}});
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
               {"keys", measured.scene.text()}};
    if (!measured.failure.empty()) {
      scene["failure"] = measured.failure;
    } else {
      scene["truth"] = {{"pmax", measured.truth_pmax},
                        {"uncertainty", measured.truth_uncertainty},
                        {"patches", measured.patches}};
    }
    for (const Run& run : measured.runs) {
      scene["runs"].push_back({{"way", run.way.label},
                               {"accuracy", run.way.accuracy},
                               {"grid", run.way.grid},
                               {"cold_ms", run.cold_ms},
                               {"warm_ms", run.warm_ms},
                               {"cold", {json_of(run.cold[0]), json_of(run.cold[1])}},
                               {"warm", {json_of(run.warm[0]), json_of(run.warm[1])}}});
    }
    whole["scenes"].push_back(std::move(scene));
  }
  out << whole.dump(1) << '\n';
}

} // namespace tradeoff
