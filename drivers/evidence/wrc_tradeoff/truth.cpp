#include "wrc_tradeoff/truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/numbers.hpp"
#include "support/statistics.hpp"
#include "support/text_table.hpp"
#include "wrc_tradeoff/creep.hpp"
#include "wrcontact.hpp"

namespace tradeoff {
namespace {

using driver::general;
using nlohmann::json;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr double coarser_truth = 4.0;
constexpr double truth_elements = 3e5; ///< at most; of the coarser truth as much fewer
constexpr std::size_t printed_wheels = 20;

/// Creep forces of all patches of a wheel.
struct CreepFigures {
  std::array<double, 3> force{}; ///< track frame
  double along = 0.0;            ///< sum of the forces along the rail, and ...
  double across = 0.0;           ///< ... across it in the patches' planes
  double spin_moment = 0.0;      ///< about the reference
  std::array<double, 3> reference{};
  double plane_angle = 0.0;
  double bound = 0.0;     ///< sum of mu N
  double mean_axis = 0.0; ///< c
};

struct WheelFigures {
  Figures normal;
  CreepFigures creep;
};

Figures pressure_figures(const driver::Scene& scene, const std::string& side) {
  Figures figures = figures_of(scene, side);
  constexpr std::array axes{"x", "y", "z"};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    figures.force[i] = scene.number(side + ".pressure_force." + axes[i]);
    figures.moment[i] = scene.number(side + ".pressure_moment." + axes[i]);
  }
  return figures;
}

CreepFigures creep_figures(const driver::Scene& scene, const std::string& side,
                           const Figures& normal) {
  CreepFigures creep;
  constexpr std::array axes{"x", "y", "z"};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    creep.force[i] = scene.number(side + ".total.force." + axes[i]) - normal.force[i];
    creep.reference[i] = normal.reference[i];
  }
  creep.plane_angle = scene.number(side + ".patches.0.plane_angle");
  creep.mean_axis = std::sqrt(normal.semi_axis_along * normal.semi_axis_across);
  for (int i = 0; i < scene.count_of(side + ".patches"); ++i) {
    const std::string patch = side + ".patches." + std::to_string(i) + '.';
    const double along = scene.number(patch + "creep_force.longitudinal");
    const double across = scene.number(patch + "creep_force.lateral");
    creep.along += along;
    creep.across += across;
    creep.bound += scene.number(patch + "friction") * scene.number(patch + "normal_force");
    const double apart_along = scene.number(patch + 'x') - creep.reference[0];
    const double apart_across =
        std::cos(creep.plane_angle) * (scene.number(patch + 'y') - creep.reference[1]) +
        std::sin(creep.plane_angle) * (scene.number(patch + 'z') - creep.reference[2]);
    creep.spin_moment +=
        scene.number(patch + "spin_moment") + apart_along * across - apart_across * along;
  }
  return creep;
}

JudgedErrors errors_of(const WheelFigures& found, const WheelFigures& truth, bool has_creep) {
  const WheelError error = error_of(found.normal, truth.normal);
  JudgedErrors errors{std::max({error.of(Quantity::depth), error.of(Quantity::normal_force)}),
                      error.of(Quantity::lateral_force),
                      std::max({error.of(Quantity::moment), error.of(Quantity::centre_lateral),
                                error.of(Quantity::centre_longitudinal)}),
                      error.of(Quantity::pmax),
                      absent,
                      absent};
  if (!has_creep) {
    return errors;
  }
  const CreepFigures& one = found.creep;
  const CreepFigures& other = truth.creep;
  double squares = 0.0;
  for (std::size_t i = 0; i < one.force.size(); ++i) {
    squares += (one.force[i] - other.force[i]) * (one.force[i] - other.force[i]);
  }
  const double apart_along = one.reference[0] - other.reference[0];
  const double apart_across =
      std::cos(other.plane_angle) * (one.reference[1] - other.reference[1]) +
      std::sin(other.plane_angle) * (one.reference[2] - other.reference[2]);
  const double moment = one.spin_moment + apart_along * one.across - apart_across * one.along;
  errors[first_of_creep] = std::sqrt(squares) / other.bound;
  errors[first_of_creep + 1] =
      std::abs(moment - other.spin_moment) / (other.bound * other.mean_axis);
  return errors;
}

/// Calls take(number) for each in turn.
template <class Wheel, class Take> void for_each_number(Wheel& wheel, Take take) {
  auto& normal = wheel.normal;
  auto& creep = wheel.creep;
  for (auto* number :
       {&normal.pmax, &normal.depth, &normal.area, &normal.normal_force, &normal.semi_axis_along,
        &normal.semi_axis_across, &creep.along, &creep.across, &creep.spin_moment,
        &creep.plane_angle, &creep.bound, &creep.mean_axis}) {
    take(*number);
  }
  for (auto* vector : {&normal.force, &normal.centre, &normal.reference, &normal.moment,
                       &creep.force, &creep.reference}) {
    std::for_each(vector->begin(), vector->end(), take);
  }
}

json json_of(const WheelFigures& wheel) {
  json numbers = json::array();
  for_each_number(wheel, [&numbers](double number) { numbers.push_back(number); });
  return numbers;
}

WheelFigures wheel_of(const json& numbers) {
  WheelFigures wheel;
  auto next = numbers.begin();
  for_each_number(wheel, [&next](double& number) {
    number = next->is_null() ? absent : next->get<double>();
    ++next;
  });
  return wheel;
}

bool has_creep(const Case& scene) {
  return scene.group != "wheels";
}

std::vector<std::string> sides_of(const Case& scene) {
  return scene.group == "flats" || scene.group == "crossings"
             ? std::vector<std::string>{"left"}
             : std::vector<std::string>{"left", "right"};
}

/// What an accuracy is of, with contact along planes or curves.
struct TruthWay {
  const char* label;
  const char* accuracy_of;
  const char* curved;
};
constexpr std::array truth_ways{TruthWay{"forces", "forces", "no"},
                                TruthWay{"pressures", "pressures", "no"},
                                TruthWay{"forces, along curves", "forces", "yes"}};
constexpr TruthWay truth_way{"", "pressures", "yes"};

/// `elements`: at most; 0: the default limit.
driver::Scene solved(const Case& scene, driver::Solver& solver, double accuracy,
                     const TruthWay& way, bool creep, double elements = 0.0) {
  driver::Scene made;
  scene.settings.apply(made);
  made.set("solve.accuracy", accuracy);
  made.set("solve.accuracy_of", way.accuracy_of);
  made.set("solve.curved", way.curved);
  made.set("solve.creep", creep ? "auto" : "none");
  if (elements > 0.0) {
    made.set("solve.element_limit", elements);
  }
  solver.solve(made);
  return made;
}

/// Of each side.
std::vector<WheelFigures> find_truth(const Case& scene, double times) {
  driver::Solver solver;
  std::vector<WheelFigures> wheels;
  const driver::Scene normal =
      solved(scene, solver, times * curved_accuracy, truth_way, false, truth_elements / times);
  for (const std::string& side : sides_of(scene)) {
    wheels.push_back({pressure_figures(normal, side), {}});
  }
  if (has_creep(scene)) {
    const driver::Scene creep = solved(scene, solver, times * creep_truth_accuracy, truth_way, true,
                                       truth_elements / times);
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      const std::string side = sides_of(scene)[i];
      wheels[i].creep = creep_figures(creep, side, pressure_figures(creep, side));
    }
  }
  return wheels;
}

/// The largest of its creep forces, as far as patches bear them.
double creep_estimate(const driver::Scene& scene, const std::string& side) {
  double error = 0.0;
  double force = 0.0;
  for (int i = 0; i < scene.count_of(side + ".patches"); ++i) {
    const std::string patch = side + ".patches." + std::to_string(i) + '.';
    const double normal = scene.number(patch + "normal_force");
    error += normal * scene.number(patch + "creep_error_estimate");
    force += normal;
  }
  return error / force;
}

/// All that is counted of a result, or of any of a wheel.
struct Counts {
  std::size_t judged = 0, uncertain = 0, missed = 0, above = 0, silent = 0;
  double worst = 0.0;
  std::vector<double> ratios; ///< of estimates to errors

  void add(const Counts& other) {
    judged += other.judged;
    uncertain += other.uncertain;
    missed += other.missed;
    above += other.above;
    silent += other.silent;
  }
};

bool is_of_pressures(const Judged& run) {
  return run.accuracy_of == "pressures";
}

/// Of a result of one wheel.
Counts count(const Judged& run, std::size_t quantity) {
  Counts counts;
  const double error = run.errors[quantity];
  if (std::isnan(error) || (quantity == judged_pmax && !is_of_pressures(run))) {
    return counts;
  }
  const double estimate = run.estimate[quantity >= first_of_creep ? 1 : 0];
  if (run.uncertainty[quantity] > 0.5 * std::min(run.accuracy, std::max(estimate, error))) {
    counts.uncertain = 1;
    return counts;
  }
  counts.judged = 1;
  counts.missed = error > run.accuracy ? 1 : 0;
  counts.above = error > estimate ? 1 : 0;
  counts.silent = error > run.accuracy && estimate <= run.accuracy && run.warnings.empty() ? 1 : 0;
  counts.worst = error;
  counts.ratios = {estimate / error};
  return counts;
}

/// Of any result of a wheel.
Counts count_any(const Judged& run) {
  Counts any;
  for (std::size_t quantity = 0; quantity < judged_names.size(); ++quantity) {
    any.add(count(run, quantity));
  }
  return {std::min<std::size_t>(any.judged, 1),
          0,
          std::min<std::size_t>(any.missed, 1),
          std::min<std::size_t>(any.above, 1),
          std::min<std::size_t>(any.silent, 1),
          0.0,
          {}};
}

struct Row {
  std::string kind, accuracy_of, result;
  double accuracy = 0.0;
  Counts counts;
};

std::vector<Row> rows_of(const std::vector<TruthMeasured>& all) {
  std::vector<Row> rows;
  const auto row_of = [&rows](const std::string& kind, const Judged& run,
                              const std::string& result) -> Counts& {
    for (Row& row : rows) {
      if (row.kind == kind && row.accuracy_of == run.accuracy_of && row.accuracy == run.accuracy &&
          row.result == result) {
        return row.counts;
      }
    }
    return rows.emplace_back(Row{kind, run.accuracy_of, result, run.accuracy, {}}).counts;
  };
  for (const TruthMeasured& measured : all) {
    for (const Judged& run : measured.runs) {
      for (std::size_t quantity = 0; quantity < judged_names.size(); ++quantity) {
        const Counts one = count(run, quantity);
        if (one.judged + one.uncertain > 0) {
          Counts& counts = row_of(measured.scene.group, run, judged_names[quantity]);
          counts.add(one);
          counts.worst = std::max(counts.worst, one.worst);
          counts.ratios.insert(counts.ratios.end(), one.ratios.begin(), one.ratios.end());
        }
      }
      row_of(measured.scene.group, run, "any").add(count_any(run));
    }
  }
  return rows;
}

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0
             ? "-"
             : driver::fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) +
                   " %";
}

/// Silent misses and errors above their estimates, the farthest first, with options of wrc_case
/// that replay them.
void print_worst(const std::vector<TruthMeasured>& all, std::ostream& out) {
  std::vector<std::pair<double, std::string>> lines;
  for (const TruthMeasured& measured : all) {
    for (const Judged& run : measured.runs) {
      for (std::size_t quantity = 0; quantity < judged_names.size(); ++quantity) {
        const Counts one = count(run, quantity);
        if (one.silent + one.above > 0) {
          const double estimate = run.estimate[quantity >= first_of_creep ? 1 : 0];
          lines.emplace_back(run.errors[quantity] / std::min(estimate, run.accuracy),
                             measured.scene.name + ": " + judged_names[quantity] + " of " +
                                 run.accuracy_of + " at " + general(run.accuracy) + ", error " +
                                 general(run.errors[quantity], 3) + ", estimate " +
                                 general(estimate, 3) + "; " + measured.scene.settings.options() +
                                 "; " + run.warnings);
        }
      }
    }
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const auto& one, const auto& other) { return one.first > other.first; });
  out << '\n' << lines.size() << " errors above their estimate, worst first\n";
  for (std::size_t i = 0; i < std::min(printed_wheels, lines.size()); ++i) {
    out << "  " << lines[i].second << '\n';
  }
}

} // namespace

TruthFile::TruthFile(const std::string& path) {
  if (path.empty()) {
    return;
  }
  std::ifstream old(path);
  for (std::string line; std::getline(old, line);) {
    const json entry = json::parse(line, nullptr, false); // a run that was killed cuts the last one
    if (entry.is_object()) {
      known_[entry.at("options")] = entry.at("truth");
    }
  }
  file_.open(path, std::ios::app);
  file_ << std::endl;
}

std::optional<json> TruthFile::find(const std::string& options) const {
  const auto found = known_.find(options);
  return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void TruthFile::add(const std::string& options, const json& truth) {
  const std::scoped_lock lock(mutex_);
  if (file_.is_open()) {
    file_ << json{{"options", options}, {"truth", truth}}.dump() << std::endl;
  }
}

TruthMeasured measure_truth(const Case& scene, TruthFile& truths) {
  TruthMeasured measured;
  measured.scene = scene;
  try {
    const std::string options = scene.settings.options();
    std::optional<json> truth = truths.find(options);
    if (!truth) {
      truth = json::array();
      for (const double times : {1.0, coarser_truth}) {
        json wheels = json::array();
        for (const WheelFigures& wheel : find_truth(scene, times)) {
          wheels.push_back(json_of(wheel));
        }
        truth->push_back(wheels);
      }
      truths.add(options, *truth);
    }
    driver::Solver solver;
    for (const TruthWay& way : truth_ways) {
      for (const double accuracy : judged_accuracies) {
        const driver::Scene found = solved(scene, solver, accuracy, way, has_creep(scene));
        for (std::size_t i = 0; i < sides_of(scene).size(); ++i) {
          const std::string side = sides_of(scene)[i];
          const WheelFigures fine = wheel_of(truth->at(0).at(i));
          Judged run{way.label, accuracy, {}, {}, {}, {}};
          WheelFigures wheel{pressure_figures(found, side), {}};
          run.estimate[0] = found.number(side + ".error_estimate");
          if (has_creep(scene)) {
            wheel.creep = creep_figures(found, side, wheel.normal);
            run.estimate[1] = creep_estimate(found, side);
          }
          run.errors = errors_of(wheel, fine, has_creep(scene));
          run.uncertainty = errors_of(wheel_of(truth->at(1).at(i)), fine, has_creep(scene));
          if (found.number(side + ".grade") > WRC_FINE) {
            for (const std::string& warning : driver::texts_of(found, side + ".warnings")) {
              run.warnings += (run.warnings.empty() ? "" : "; ") + warning;
            }
          }
          measured.runs.push_back(run);
        }
      }
    }
  } catch (const wrcontact::Error& failure) {
    measured.failure = failure.what();
    measured.runs.clear();
  }
  return measured;
}

void print_truth_summary(const std::vector<TruthMeasured>& all, std::ostream& out) {
  out << "| scenes | accuracy | of | result | judged | missed | worst | above the estimate | "
         "silent | estimate / error |\n|---|---|---|---|---|---|---|---|---|---|\n";
  std::vector<Row> rows = rows_of(all);
  for (const Row& row : rows) {
    const Counts& counts = row.counts;
    out << "| " << row.kind << " | " << general(row.accuracy) << " | " << row.accuracy_of << " | "
        << row.result << " | " << counts.judged
        << (counts.uncertain > 0 ? " (" + std::to_string(counts.uncertain) + " not)" : "") << " | "
        << share(counts.missed, counts.judged) << " | "
        << (counts.ratios.empty() ? "" : driver::power(counts.worst, 1)) << " | "
        << share(counts.above, counts.judged) << " | " << share(counts.silent, counts.judged)
        << " | " << (counts.ratios.empty() ? "" : general(driver::median(counts.ratios), 2))
        << " |\n";
  }
  for (const TruthMeasured& measured : all) {
    if (!measured.failure.empty()) {
      out << measured.scene.name << ": " << measured.scene.settings.options() << ": "
          << measured.failure << '\n';
    }
  }
  print_worst(all, out);
}

json truth_json_of(const std::vector<TruthMeasured>& all) {
  json rows = json::array();
  for (const Row& row : rows_of(all)) {
    rows.push_back({{"scenes", row.kind},
                    {"accuracy", row.accuracy},
                    {"accuracy_of", row.accuracy_of},
                    {"result", row.result},
                    {"judged", row.counts.judged},
                    {"uncertain", row.counts.uncertain},
                    {"missed", row.counts.missed},
                    {"worst", row.counts.worst},
                    {"above_estimate", row.counts.above},
                    {"silent", row.counts.silent}});
  }
  json scenes = json::array();
  for (const TruthMeasured& measured : all) {
    json runs = json::array();
    for (const Judged& run : measured.runs) {
      runs.push_back({{"accuracy", run.accuracy},
                      {"accuracy_of", run.accuracy_of},
                      {"errors", run.errors},
                      {"uncertainty", run.uncertainty},
                      {"estimates", run.estimate},
                      {"warnings", run.warnings}});
    }
    scenes.push_back({{"name", measured.scene.name},
                      {"options", measured.scene.settings.options()},
                      {"failure", measured.failure},
                      {"runs", runs}});
  }
  return {{"results", judged_names}, {"rows", rows}, {"scenes", scenes}};
}

} // namespace tradeoff
