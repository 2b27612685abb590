#include "wrc_extremes/measure.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/scene.hpp"
#include "wrc_extremes/dense_solution.hpp"
#include "wrc_extremes/own_residuals.hpp"

namespace extremes {
namespace {

constexpr double dense_grid[] = {32.0, 16.0};
/// Relative error to which a scene must balance its load.
constexpr double permitted_imbalance = 1e-9;
/// Residuals may exceed the tolerance of pressures by their own rounding: gaps are differences of
/// distance, approach and displacement.
constexpr double gap_rounding = 4e-16;
/// Sums over some thousand elements, and coefficients that two programs round differently.
constexpr double summation_rounding = 1e-12;

double relative(double value, double truth) {
  return std::abs(value / truth - 1.0);
}

wrcontact::NormalContact prepared(const NormalCase& one) {
  wrcontact::NormalContact normal;
  const GapProblem& problem = one.problem;
  normal.set_grid(static_cast<std::int64_t>(problem.rows),
                  static_cast<std::int64_t>(problem.columns), problem.lateral_step,
                  problem.longitudinal_step);
  normal.set_distance(problem.distance);
  normal.set("combined_modulus", problem.combined_modulus);
  if (problem.approach) {
    normal.set("approach", *problem.approach);
  } else {
    normal.set("normal_load", problem.normal_load);
  }
  normal.set("tolerance", one.tolerance);
  return normal;
}

/// Error of pressures against elimination in long double; none if that does not settle.
std::optional<double> dense_error(const GapProblem& problem, const std::vector<double>& pressure) {
  if (problem.count() > most_dense_elements) {
    return {};
  }
  const auto exact = DenseSolver<long double>(problem).solve(pressure);
  if (!exact.settled) {
    return {};
  }
  long double largest = 0.0L;
  long double difference = 0.0L;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    largest = std::max(largest, exact.pressure[i]);
    difference =
        std::max(difference, std::abs(static_cast<long double>(pressure[i]) - exact.pressure[i]));
  }
  return static_cast<double>(largest > 0.0L ? difference / largest : difference);
}

/// What rounding alone leaves of the gaps, relative to the largest displacement.
double rounding_of_gaps(double approach, double largest_displacement) {
  return gap_rounding * std::abs(approach) / largest_displacement + summation_rounding;
}

bool all_finite(const Row& row) {
  for (const auto& value : {row.pmax, row.approach, row.load_balance, row.overlap,
                            row.complementarity, row.pressure_error, row.error}) {
    if (value && !std::isfinite(*value)) {
      return false;
    }
  }
  return true;
}

double combined_modulus(const wrcontact::Scene& scene) {
  double compliance = 0.0;
  for (const std::string body : {"material.wheel", "material.rail"}) {
    const double poisson = scene.get_number(body + ".poisson");
    compliance += (1.0 - poisson * poisson) / scene.get_number(body + ".youngs_modulus");
  }
  return 1.0 / compliance;
}

/// A patch as a gap of its own.
struct PatchGap {
  GapProblem problem;
  std::vector<double> pressure;
};

PatchGap patch_gap(const wrcontact::Scene& scene, int patch) {
  const std::string name = "left.patches." + std::to_string(patch) + '.';
  PatchGap gap;
  gap.problem.rows = static_cast<std::size_t>(scene.number(name + "grid.lateral"));
  gap.problem.columns = static_cast<std::size_t>(scene.number(name + "grid.longitudinal"));
  gap.problem.lateral_step = scene.number(name + "element_size.lateral");
  gap.problem.longitudinal_step = scene.number(name + "element_size.longitudinal");
  gap.problem.combined_modulus = combined_modulus(scene);
  // The half-space has the distances times the scales of rows, and the pressures over them.
  const std::vector<double> scale = scene.field(name + "row_scale");
  gap.problem.distance = scene.field(name + "undeformed_distance");
  gap.pressure = scene.field(name + "pressure");
  for (std::size_t i = 0; i < scale.size(); ++i) {
    gap.problem.distance[i] *= scale[i];
    gap.pressure[i] /= scale[i];
    gap.problem.normal_load +=
        gap.pressure[i] * gap.problem.lateral_step * gap.problem.longitudinal_step;
  }
  return gap;
}

/// Residuals of all patches, the worst; those that interact, parts of one among them, are not gaps
/// of their own.
void judge_patches(const wrcontact::Scene& scene, int count, Row& row, std::uint64_t seed) {
  double overlap = 0.0;
  double complementarity = 0.0;
  for (int k = 0; k < count; ++k) {
    const std::string name = "left.patches." + std::to_string(k);
    if (scene.number(name + ".coupling_weight") > 0.0 || scene.has_number(name + ".parts.0.pmax")) {
      overlap = std::max(overlap, -scene.number("left.residuals.least_gap"));
      complementarity = std::max(complementarity, scene.number("left.residuals.complementarity"));
      continue;
    }
    const PatchGap gap = patch_gap(scene, k);
    const OwnResiduals own =
        judge_pressures(gap.problem, gap.pressure, {}, gap.problem.normal_load, seed);
    overlap = std::max({overlap, own.overlap, own.tension});
    complementarity = std::max(complementarity, own.complementarity);
  }
  row.overlap = overlap;
  row.complementarity = complementarity;
}

void compare_with_finer(const SceneSetup& setup, const SceneOptions& options, Row& row) {
  wrcontact::Scene finer;
  finer.set("solve.side", "left");
  setup(finer);
  if (options.finer_grid.empty()) {
    finer.set("solve.accuracy", options.finer);
  } else {
    finer.set("solve.grid", options.finer_grid);
  }
  finer.solve();
  row.truth = "finer";
  row.error = relative(*row.approach, finer.number("left.depth"));
  if (row.pmax) {
    row.error = std::max(*row.error, relative(*row.pmax, finer.number("left.pmax")));
  }
}

void compare_with_dense(const SceneSetup& setup, Row& row) {
  wrcontact::Scene coarse;
  coarse.set("solve.side", "left");
  setup(coarse);
  coarse.set("solve.grid", std::vector<double>{dense_grid[0], dense_grid[1]});
  coarse.set("solve.tolerance", tolerance_floor);
  coarse.solve();
  for (int k = 0; k < coarse.count_of("left.patches"); ++k) {
    if (coarse.number("left.patches." + std::to_string(k) + ".coupling_weight") > 0.0) {
      continue;
    }
    const PatchGap gap = patch_gap(coarse, k);
    const auto error = dense_error(gap.problem, gap.pressure);
    if (error) {
      row.pressure_error = std::max(row.pressure_error.value_or(0.0), *error);
    }
  }
}

} // namespace

void measure(const Measurement& measurement, Row& row, std::uint64_t seed) {
  try {
    measurement(row, seed);
  } catch (const wrcontact::Error& error) {
    row.status = wrc_status_name(error.status());
    row.message = error.what();
    const bool explained = row.message.size() > row.status.size() &&
                           error.status() != WRC_INTERNAL && error.status() != WRC_OUT_OF_MEMORY;
    row.verdict = explained ? Verdict::refused : Verdict::wrong;
  }
}

NormalAnswer solve_normal(const NormalCase& one) {
  wrcontact::NormalContact normal = prepared(one);
  normal.solve();
  return {normal.field("pressure"), normal.number("approach"), normal.number("pmax")};
}

void measure_normal(const NormalCase& one, Row& row, std::uint64_t seed) {
  row.asked = one.tolerance;
  wrcontact::NormalContact normal = prepared(one);
  const bool converged = normal.solve();
  row.status = wrc_status_name(converged ? WRC_OK : WRC_NOT_CONVERGED);
  row.message = converged ? "" : "stopped by " + normal.text("stop_reason");
  row.pmax = normal.number("pmax");
  row.approach = normal.number("approach");
  row.fill = normal.number("fill");
  const GapProblem& problem = one.problem;
  const std::vector<double> pressure = normal.field("pressure");
  const double load = problem.approach ? normal.number("normal_force") : problem.normal_load;
  const OwnResiduals own = judge_pressures(problem, pressure, *row.approach, load, seed);
  row.load_balance = own.load_balance;
  if (*row.fill == 0.0) {
    row.verdict = own.load_balance == 0.0 ? Verdict::none : Verdict::wrong;
    return;
  }
  row.overlap = std::max(own.overlap, own.tension);
  row.complementarity = own.complementarity;
  row.pressure_error = dense_error(problem, pressure);
  const auto displacement = normal.field("displacement");
  const double largest = *std::max_element(displacement.begin(), displacement.end());
  const double permitted = std::max(one.tolerance, rounding_of_gaps(*row.approach, largest));
  if (!all_finite(row) || *row.load_balance > summation_rounding || *row.overlap > permitted ||
      *row.complementarity > permitted) {
    row.verdict = Verdict::wrong;
  } else if (!converged) {
    row.verdict = Verdict::warned;
  } else {
    row.verdict =
        row.pressure_error.value_or(0.0) <= one.tolerance ? Verdict::held : Verdict::faded;
  }
}

void measure_scene(const SceneSetup& setup, Row& row, std::uint64_t seed,
                   const SceneOptions& options) {
  wrcontact::Scene scene;
  scene.set("solve.side", "left");
  setup(scene);
  row.asked = scene.get_number("solve.accuracy");
  const bool converged = scene.solve();
  row.status = wrc_status_name(converged ? WRC_OK : WRC_NOT_CONVERGED);
  const std::vector<std::string> warnings = driver::texts_of(scene, "left.warnings");
  for (const std::string& warning : warnings) {
    row.message += (row.message.empty() ? "" : "; ") + warning;
  }
  row.pmax = scene.number("left.pmax");
  if (std::isnan(*row.pmax) && row.message.find("pressures have no bound") != std::string::npos) {
    row.pmax.reset(); // as documented (docs/warnings.md, profile_end)
  }
  row.approach = scene.number("left.depth");
  const int count = scene.count_of("left.patches");
  if (count == 0) {
    double load = 1.0;
    const bool asked_for =
        wrc_scene_get_number(scene.handle(), "load.left", &load) == WRC_OK && load == 0.0;
    row.verdict = *row.pmax == 0.0 && scene.number("left.normal_force") == 0.0 &&
                          (asked_for || !warnings.empty())
                      ? Verdict::none
                      : Verdict::wrong;
    return;
  }
  row.fill = scene.number("left.fill");
  double height = 0.0;
  const bool prescribed = wrc_scene_get_number(scene.handle(), "pose.vertical", &height) == WRC_OK;
  row.load_balance =
      prescribed ? 0.0
                 : relative(scene.number("left.vertical_force"), scene.get_number("load.left"));
  judge_patches(scene, count, row, seed);
  if (options.finer > 0.0 || !options.finer_grid.empty()) {
    compare_with_finer(setup, options, row);
  }
  if (options.with_dense) {
    compare_with_dense(setup, row);
  }
  const double permitted = row.asked;
  if (!options.finer_grid.empty() && scene.has_number("left.discretisation_error")) {
    row.asked = scene.number("left.discretisation_error");
  }
  const bool leaves_residual = std::max(*row.overlap, *row.complementarity) > permitted;
  if (!all_finite(row) || *row.load_balance > permitted_imbalance ||
      (leaves_residual && row.message.find("almost touch") == std::string::npos)) {
    row.verdict = Verdict::wrong;
  } else if (!converged || !warnings.empty()) {
    row.verdict = Verdict::warned;
  } else {
    row.verdict = row.error.value_or(0.0) <= row.asked ? Verdict::held : Verdict::faded;
  }
}

} // namespace extremes
