#include "wrc_tradeoff/measure.hpp"

#include <chrono>
#include <cmath>

#include "wrc_tradeoff/statistics.hpp"

namespace tradeoff {
namespace {

constexpr std::array side_names{"left", "right"};
constexpr double warm_step = 0.01; // mm
/// Slow ways are timed in fewer steps: no more once that much time is spent.
constexpr double budget_ms = 40.0;
constexpr int least_steps = 2;
/// Grids by hand: elements across; half as many along, and tolerances that leave the grid's error.
constexpr std::array rows_by_hand{12.0, 16.0,  24.0,  32.0,  48.0, 64.0,
                                  96.0, 128.0, 192.0, 256.0, 384.0};
constexpr double hand_tolerance = 1e-4;

struct Figures {
  double pmax, approach, area, normal_force;
};

Figures figures_of(const driver::Scene& scene, const std::string& side) {
  return {scene.number(side + ".pmax"), scene.number(side + ".depth"), scene.number(side + ".area"),
          scene.number(side + ".normal_force")};
}

double relative(double value, double truth) {
  return std::abs(value / truth - 1.0);
}

WheelError error_of(const driver::Scene& scene, const std::string& side, const Figures& truth) {
  const Figures found = figures_of(scene, side);
  WheelError error;
  error.pmax = relative(found.pmax, truth.pmax);
  error.approach = relative(found.approach, truth.approach);
  error.area = relative(found.area, truth.area);
  error.normal_force = relative(found.normal_force, truth.normal_force);
  for (auto [name, value] :
       {std::pair{".error_estimate", &error.estimate}, std::pair{".validity", &error.validity}}) {
    if (scene.has_number(side + name)) {
      *value = scene.number(side + name);
    }
  }
  const int warnings = scene.count_of(side + ".warnings");
  for (int i = 0; i < warnings; ++i) {
    error.warnings += (i > 0 ? "; " : "") + scene.text(side + ".warnings." + std::to_string(i));
  }
  return error;
}

void set_way(driver::Scene& scene, const Way& way) {
  if (way.label == "grid") {
    scene.set("solve.grid", std::vector<double>{way.grid[0], way.grid[1]});
    scene.set("solve.tolerance", hand_tolerance);
  } else if (way.label == "hertz" || way.label == "kik-piotrowski") {
    scene.set("solve.model", way.label);
  } else {
    scene.set("solve.accuracy", way.accuracy);
    scene.set("solve.precision", std::string(way.label == "double" ? "double" : "mixed"));
  }
}

class Measurer {
public:
  Measurer(const Case& made, const MeasureOptions& options) : options_(options) {
    result_.scene = made;
  }

  Measured measure() {
    find_truth();
    for (const Way& way : all_ways(options_.with_grids)) {
      result_.runs.push_back(run(way));
    }
    return std::move(result_);
  }

private:
  std::array<Figures, 2> solve_on_grid(double share) {
    driver::Scene scene;
    result_.scene.apply(scene);
    scene.set("solve.grid", std::vector<double>{share * truth_grid[0], share * truth_grid[1]});
    scene.set("solve.tolerance", 1e-8);
    scene.set("solve.precision", std::string("double"));
    driver::Solver solver;
    solver.solve(scene);
    for (std::size_t side = 0; side < 2; ++side) {
      result_.patches[side] = scene.count_of(std::string(side_names[side]) + ".patches");
    }
    return {figures_of(scene, "left"), figures_of(scene, "right")};
  }

  void find_truth() {
    const auto coarser = solve_on_grid(0.5);
    truth_ = solve_on_grid(1.0);
    for (std::size_t side = 0; side < 2; ++side) {
      result_.truth_pmax[side] = truth_[side].pmax;
      result_.truth_uncertainty[side] =
          std::max(relative(coarser[side].pmax, truth_[side].pmax),
                   relative(coarser[side].approach, truth_[side].approach));
    }
  }

  std::array<WheelError, 2> errors_of(const driver::Scene& scene) const {
    return {error_of(scene, "left", truth_[0]), error_of(scene, "right", truth_[1])};
  }

  Run run(const Way& way) {
    driver::Scene scene;
    result_.scene.apply(scene);
    set_way(scene, way);
    const double lateral = result_.scene.number_or("pose.lateral", 0.0);
    Run made;
    made.way = way;
    const auto solve = [&](double at) {
      scene.set("pose.lateral", at);
      const auto start = std::chrono::steady_clock::now();
      solver_.solve(scene);
      return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    solve(lateral); // plans
    solver_.forget_positions();
    made.cold_ms = solve(lateral);
    made.cold = errors_of(scene);
    std::vector<double> times;
    double spent = 0.0;
    for (int i = 0; i < options_.warm_steps && (i < least_steps || spent < budget_ms); ++i) {
      spent += solve(lateral + warm_step);
      times.push_back(solve(lateral));
      spent += times.back();
    }
    made.warm_ms = median(times);
    made.warm = errors_of(scene);
    return made;
  }

  MeasureOptions options_;
  driver::Solver solver_;
  std::array<Figures, 2> truth_{};
  Measured result_;
};

} // namespace

std::vector<Way> all_ways(bool with_grids) {
  std::vector<Way> ways;
  for (const char* label : {"auto", "double"}) {
    for (const double accuracy : accuracies) {
      ways.push_back({label, accuracy, {}});
    }
  }
  for (const char* model : {"hertz", "kik-piotrowski"}) {
    ways.push_back({model, 0.0, {}});
  }
  if (with_grids) {
    for (const double rows : rows_by_hand) {
      ways.push_back({"grid", 0.0, {rows, 0.5 * rows}});
    }
  }
  return ways;
}

Measured measure(const Case& scene, const MeasureOptions& options) {
  try {
    return Measurer(scene, options).measure();
  } catch (const driver::Failure& failure) {
    Measured failed;
    failed.scene = scene;
    failed.failure = failure.what();
    return failed;
  }
}

} // namespace tradeoff
