#include "wrc_tradeoff/measure.hpp"

#include <algorithm>

#include "support/statistics.hpp"
#include "support/stopwatch.hpp"

namespace tradeoff {
namespace {

/// Slow ways are timed less often: no more once that much time is spent.
constexpr double budget_ms = 40.0;
/// Prescribed grids: elements across; half the number along, and tolerances below the grid's error.
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
  }
}

class Measurer {
public:
  Measurer(const Case& made, const MeasureOptions& options) : options_(options) {
    result_.scene = made;
    settings_.resize(options.position ? 2 : 1, made.settings);
    if (options.position) {
      prescribe_position();
    }
  }

  Measured measure() {
    find_truth();
    for (const Way& way : ways_of(options_.labels)) {
      result_.runs.push_back(run(way));
    }
    return std::move(result_);
  }

private:
  /// Where the load presses each wheel, which becomes a scene of its own: depths differ.
  void prescribe_position() {
    driver::Scene loaded;
    settings_.front().apply(loaded);
    solver_.solve(loaded);
    for (std::size_t i = 0; i < settings_.size(); ++i) {
      const std::string side = driver::side_names[i];
      settings_[i].texts.emplace_back("solve.side", side);
      settings_[i].set("pose.roll", loaded.number("roll"));
      settings_[i].set("pose.vertical",
                       loaded.number(side + ".vertical") - loaded.number(side + ".depth"));
    }
  }

  template <class Set> std::vector<driver::Scene> scenes_with(Set set) const {
    std::vector<driver::Scene> scenes(settings_.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      settings_[i].apply(scenes[i]);
      set(scenes[i]);
    }
    return scenes;
  }
  static void solve(driver::Solver& solver, std::vector<driver::Scene>& scenes) {
    for (driver::Scene& scene : scenes) {
      solver.solve(scene);
    }
  }
  static const driver::Scene& scene_of(const std::vector<driver::Scene>& scenes, std::size_t side) {
    return scenes[std::min(side, scenes.size() - 1)];
  }

  std::array<Figures, 2> solve_on_grid(double share) {
    std::vector<driver::Scene> scenes = scenes_with([share](driver::Scene& scene) {
      scene.set("solve.grid", std::vector<double>{share * truth_grid[0], share * truth_grid[1]});
      scene.set("solve.tolerance", 1e-8);
    });
    driver::Solver solver;
    solver.set("precision", "double");
    solve(solver, scenes);
    std::array<Figures, 2> figures;
    for (std::size_t side = 0; side < 2; ++side) {
      const driver::Scene& scene = scene_of(scenes, side);
      result_.patches[side] = scene.count_of(std::string(driver::side_names[side]) + ".patches");
      figures[side] = figures_of(scene, driver::side_names[side]);
    }
    return figures;
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
    std::vector<driver::Scene> scenes =
        scenes_with([&way](driver::Scene& scene) { set_way(scene, way); });
    Run made;
    made.way = way;
    solver_.set("precision", way.label == "double" ? "double" : "mixed");
    solve(solver_, scenes); // plans
    std::vector<double> times;
    for (double spent = 0.0;
         times.empty() || (spent < budget_ms && std::ssize(times) < options_.repeats);) {
      driver::Stopwatch watch;
      solve(solver_, scenes);
      times.push_back(watch.lap());
      spent += times.back();
    }
    made.time_ms = driver::median(times);
    for (std::size_t side = 0; side < 2; ++side) {
      made.errors[side] = error_of(scene_of(scenes, side), driver::side_names[side], truth_[side]);
      if (way.accuracy > 0.0) {
        made.errors[side].area_share = area_in_accuracies(way.accuracy);
      }
    }
    return made;
  }

  MeasureOptions options_;
  driver::Solver solver_;
  std::vector<driver::Settings> settings_; ///< of both wheels, or one for each
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
