#include "wrc_tradeoff/measure.hpp"

#include <algorithm>

#include "support/stopwatch.hpp"
#include "wrc_tradeoff/reports.hpp"

namespace tradeoff {
namespace {

/// Slow ways are timed less often: no more once that much time is spent.
constexpr double budget_ms = 40.0;
/// Grids by hand: elements across; half as many along, and tolerances that leave the grid's error.
constexpr std::array rows_by_hand{12.0, 16.0,  24.0,  32.0,  48.0, 64.0,
                                  96.0, 128.0, 192.0, 256.0, 384.0};
constexpr double hand_tolerance = 1e-4;

void set_way(driver::Scene& scene, const Way& way) {
  if (way.label == "grid") {
    scene.set("solve.grid", std::vector<double>{way.grid[0], way.grid[1]});
    scene.set("solve.tolerance", hand_tolerance);
  } else if (way.label == "hertz" || way.label == "kik-piotrowski") {
    scene.set("solve.model", way.label);
  } else {
    scene.set("solve.accuracy", way.accuracy);
    scene.set("solve.accuracy_of", way.label == "forces" ? "forces" : "pressures");
    scene.set("solve.precision", way.label == "double" ? "double" : "mixed");
  }
}

class Measurer {
public:
  Measurer(const Case& made, const MeasureOptions& options) : options_(options) {
    result_.scene = made;
  }

  Measured measure() {
    find_truth();
    for (const Way& way : ways_of(options_.labels)) {
      result_.runs.push_back(run(way));
    }
    return std::move(result_);
  }

private:
  std::array<Figures, 2> solve_on_grid(double share) {
    driver::Scene scene;
    result_.scene.settings.apply(scene);
    scene.set("solve.grid", std::vector<double>{share * truth_grid[0], share * truth_grid[1]});
    scene.set("solve.tolerance", 1e-8);
    scene.set("solve.precision", "double");
    driver::Solver solver;
    solver.solve(scene);
    for (std::size_t side = 0; side < 2; ++side) {
      result_.patches[side] = scene.count_of(std::string(driver::side_names[side]) + ".patches");
    }
    return {figures_of(scene, "left"), figures_of(scene, "right")};
  }

  void find_truth() {
    const auto coarser = solve_on_grid(0.5);
    truth_ = solve_on_grid(1.0);
    for (std::size_t side = 0; side < 2; ++side) {
      result_.truth_pmax[side] = truth_[side].pmax;
      result_.truth_uncertainty[side] = error_of(coarser[side], truth_[side]);
    }
  }

  Run run(const Way& way) {
    driver::Scene scene;
    result_.scene.settings.apply(scene);
    set_way(scene, way);
    Run made;
    made.way = way;
    solver_.solve(scene); // plans
    std::vector<double> times;
    for (double spent = 0.0;
         times.empty() || (spent < budget_ms && std::ssize(times) < options_.repeats);) {
      driver::Stopwatch watch;
      solver_.solve(scene);
      times.push_back(watch.lap());
      spent += times.back();
    }
    made.time_ms = median(times);
    made.errors = {error_of(scene, "left", truth_[0]), error_of(scene, "right", truth_[1])};
    return made;
  }

  MeasureOptions options_;
  driver::Solver solver_;
  std::array<Figures, 2> truth_{};
  Measured result_;
};

} // namespace

std::vector<Way> ways_of(const std::vector<std::string>& labels) {
  std::vector<Way> ways;
  for (const std::string& label : labels) {
    if (label == "grid") {
      for (const double rows : rows_by_hand) {
        ways.push_back({label, 0.0, {rows, 0.5 * rows}});
      }
    } else if (label == "hertz" || label == "kik-piotrowski") {
      ways.push_back({label, 0.0, {}});
    } else {
      for (const double accuracy : accuracies) {
        ways.push_back({label, accuracy, {}});
      }
    }
  }
  return ways;
}

Measured measure(const Case& scene, const MeasureOptions& options) {
  try {
    return Measurer(scene, options).measure();
  } catch (const wrcontact::Error& failure) {
    Measured failed;
    failed.scene = scene;
    failed.failure = failure.what();
    return failed;
  }
}

} // namespace tradeoff
