#include "wrc_tradeoff/practical.hpp"

#include <algorithm>
#include <cmath>

#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/statistics.hpp"
#include "wrcontact.hpp"

namespace tradeoff {
namespace {

using driver::general;
using driver::json;

constexpr std::array<double, 2> first_truth{144.0, 60.0};
constexpr double truth_tolerance = 1e-6;
constexpr int most_truths = 4;
/// Grids that agree within this are fine enough.
constexpr double enough = 2e-4;
constexpr std::size_t printed_wheels = 12;

std::array<PracticalWheel, 2> find_truth(const Case& scene, driver::Solver& solver) {
  std::array<PracticalWheel, 2> wheels;
  double times = 1.0;
  for (int i = 0; i < most_truths; ++i, times *= 2.0) {
    driver::Scene fine;
    scene.settings.apply(fine);
    fine.set("solve.grid", std::vector<double>{times * first_truth[0], times * first_truth[1]});
    fine.set("solve.tolerance", truth_tolerance);
    solver.solve(fine);
    bool agree = i > 0;
    for (std::size_t side = 0; side < 2; ++side) {
      PracticalWheel& wheel = wheels[side];
      const double pmax = fine.number(std::string(driver::side_names[side]) + ".pmax");
      wheel.uncertainty = std::abs(wheel.truth / pmax - 1.0);
      wheel.truth = pmax;
      agree = agree && wheel.uncertainty <= enough;
    }
    if (agree) {
      break;
    }
  }
  return wheels;
}

/// Whether the reference is accurate to half of the bound on the error.
bool is_judged(const PracticalWheel& wheel) {
  return wheel.uncertainty <= 0.5 * std::min(wheel.estimate, practical_accuracy);
}

struct Counts {
  std::size_t wheels = 0;
  std::size_t uncertain = 0;
  std::size_t missed = 0;
  std::size_t silent = 0;
  std::size_t beyond_estimate = 0;
  std::vector<double> errors;
  std::vector<double> ratios; ///< of estimates to errors
};

Counts count(const std::vector<PracticalMeasured>& all) {
  Counts counts;
  for (const PracticalMeasured& measured : all) {
    for (std::size_t side = 0; side < 2 && measured.failure.empty(); ++side) {
      const PracticalWheel& wheel = measured.wheels[side];
      ++counts.wheels;
      if (!is_judged(wheel)) {
        ++counts.uncertain;
        continue;
      }
      counts.missed += wheel.misses() ? 1 : 0;
      counts.silent += wheel.misses_silently() ? 1 : 0;
      counts.beyond_estimate += wheel.exceeds_estimate() ? 1 : 0;
      counts.errors.push_back(wheel.error);
      counts.ratios.push_back(wheel.estimate / wheel.error);
    }
  }
  return counts;
}

std::string share_of(std::size_t part, std::size_t whole) {
  return std::to_string(part) + " (" +
         driver::fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 2) + " %)";
}

/// The farthest beyond their estimates or the accuracy first, with options of wrc_case that replay
/// them.
void print_worst(const std::vector<PracticalMeasured>& all, std::ostream& out) {
  struct Line {
    double ratio = 0.0;
    std::string text;
  };
  std::vector<Line> lines;
  for (const PracticalMeasured& measured : all) {
    for (std::size_t side = 0; side < 2 && measured.failure.empty(); ++side) {
      const PracticalWheel& wheel = measured.wheels[side];
      if (is_judged(wheel) && (wheel.exceeds_estimate() || wheel.misses_silently())) {
        lines.push_back({wheel.error / std::min(wheel.estimate, practical_accuracy),
                         "error " + general(wheel.error, 3) + ", estimate " +
                             general(wheel.estimate, 3) + ", reference accurate to " +
                             general(wheel.uncertainty, 2) + "; " + driver::side_names[side] +
                             ", " + measured.scene.settings.options() +
                             (wheel.warnings.empty() ? std::string() : "; " + wheel.warnings)});
      }
    }
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& one, const Line& other) { return one.ratio > other.ratio; });
  out << '\n' << lines.size() << " errors above their estimate, worst first\n";
  for (std::size_t i = 0; i < std::min(printed_wheels, lines.size()); ++i) {
    out << "  " << lines[i].text << '\n';
  }
}

} // namespace

std::vector<Case> make_practical(std::size_t count) {
  constexpr std::uint64_t seed = 20261127;
  const std::vector<std::string> wheels = wrcontact::standard_profile_names(WRC_WHEEL);
  const std::vector<std::string> rails = wrcontact::standard_profile_names(WRC_RAIL);
  constexpr std::array cants{1.0 / 40.0, 1.0 / 20.0, 0.0};
  driver::Draw draw(seed);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < count; ++i) {
    Case& made = cases.emplace_back();
    made.group = "practical";
    made.name = "practical-" + std::to_string(i);
    const std::string& wheel = draw.one_of(wheels);
    made.settings = driver::make_pair(wheel, draw.one_of(rails));
    made.settings.set("wheelset.radius",
                      made.settings.number_or("wheelset.radius", 460.0) * draw.between(0.9, 1.0));
    made.settings.set("track.cant", std::atan(draw.one_of(cants)));
    made.settings.set("pose.lateral", draw.between(-8.0, 8.0));
    const double yaw = draw.between(-0.01, 0.01);
    made.settings.set("pose.yaw", draw.chance(0.5) ? yaw : 0.0);
    made.settings.set("load.vertical", draw.between_by_ratio(20e3, 150e3));
  }
  return cases;
}

PracticalMeasured measure_practical(const Case& scene) {
  PracticalMeasured measured;
  measured.scene = scene;
  try {
    driver::Solver solver;
    measured.wheels = find_truth(scene, solver);
    driver::Scene found;
    scene.settings.apply(found);
    found.set("solve.accuracy", practical_accuracy);
    solver.solve(found);
    for (std::size_t side = 0; side < 2; ++side) {
      const std::string name = driver::side_names[side];
      PracticalWheel& wheel = measured.wheels[side];
      wheel.error = std::abs(found.number(name + ".pmax") / wheel.truth - 1.0);
      wheel.estimate = found.number(name + ".error_estimate");
      for (const std::string& warning : driver::texts_of(found, name + ".warnings")) {
        wheel.warnings += (wheel.warnings.empty() ? "" : "; ") + warning;
      }
    }
  } catch (const wrcontact::Error& failure) {
    measured.failure = failure.what();
  }
  return measured;
}

void print_practical_summary(const std::vector<PracticalMeasured>& all, std::ostream& out) {
  const Counts counts = count(all);
  const std::size_t judged = counts.errors.size();
  out << counts.wheels << " wheels, " << counts.uncertain << " without a converged reference\n"
      << "error of pmax at accuracy " << general(practical_accuracy) << ": median "
      << general(driver::median(counts.errors), 2) << ", 99 % "
      << general(driver::quantile(counts.errors, 0.99), 2) << ", worst "
      << general(driver::quantile(counts.errors, 1.0), 2) << "; estimate over error "
      << general(driver::median(counts.ratios), 2) << '\n'
      << "accuracy missed: " << share_of(counts.missed, judged) << '\n'
      << "missed without a warning: " << share_of(counts.silent, judged) << '\n'
      << "error above its estimate: " << share_of(counts.beyond_estimate, judged) << '\n';
  for (const PracticalMeasured& measured : all) {
    if (!measured.failure.empty()) {
      out << "  " << measured.scene.settings.options() << ": " << measured.failure << '\n';
    }
  }
  print_worst(all, out);
}

json practical_json_of(const std::vector<PracticalMeasured>& all) {
  const Counts counts = count(all);
  json scenes = json::array();
  for (const PracticalMeasured& measured : all) {
    json wheels = json::array();
    for (const PracticalWheel& wheel : measured.wheels) {
      wheels.push_back({{"pmax", wheel.truth},
                        {"uncertainty", wheel.uncertainty},
                        {"error", wheel.error},
                        {"estimate", wheel.estimate},
                        {"warnings", wheel.warnings}});
    }
    scenes.push_back({{"options", measured.scene.settings.options()},
                      {"failure", measured.failure},
                      {"wheels", wheels}});
  }
  return {{"practical",
           {{"wheels", counts.wheels},
            {"uncertain", counts.uncertain},
            {"missed", counts.missed},
            {"missed_without_warning", counts.silent},
            {"above_estimate", counts.beyond_estimate}}},
          {"scenes", scenes}};
}

} // namespace tradeoff
