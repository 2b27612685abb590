#include <algorithm>
#include <cmath>

#include "support/statistics.hpp"
#include "wrc_tradeoff/creep.hpp"

namespace tradeoff {
namespace {

/// Slow ways are timed less often: no more once that much time is spent.
constexpr double creep_budget_ms = 40.0;
constexpr std::array creepage_keys{"creepage.longitudinal", "creepage.lateral", "creepage.spin"};

/// What is compared of a patch.
struct PatchForces {
  std::array<double, 3> values{}; ///< Fx, Fy, Mz
  double bound = 0.0;             ///< mu N
  double mean_axis = 0.0;         ///< c
  std::optional<double> estimate;
};

std::vector<PatchForces> forces_of(const driver::Scene& scene, const std::string& side) {
  std::vector<PatchForces> patches;
  for (int i = 0; i < scene.count_of(side + ".patches"); ++i) {
    const std::string patch = side + ".patches." + std::to_string(i) + '.';
    PatchForces forces;
    forces.values = {scene.number(patch + "creep_force.longitudinal"),
                     scene.number(patch + "creep_force.lateral"),
                     scene.number(patch + "spin_moment")};
    forces.bound = scene.get_number("friction.coefficient") * scene.number(patch + "normal_force");
    forces.mean_axis = std::sqrt(scene.number(patch + "semi_axes.longitudinal") *
                                 scene.number(patch + "semi_axes.lateral"));
    if (scene.has_number(patch + "creep_error_estimate")) {
      forces.estimate = scene.number(patch + "creep_error_estimate");
    }
    patches.push_back(forces);
  }
  return patches;
}

class CreepMeasurer {
public:
  CreepMeasurer(const CreepCase& one, int repeats) : repeats_(repeats) {
    result_.settings = one.scene.settings;
    if (one.size > 0.0) {
      find_creepages(one);
    }
  }

  CreepMeasured measure() {
    driver::Scene truth = prepared({"full", creep_truth_accuracy});
    truth.set("solve.grid", std::vector<double>{truth_grid[0], truth_grid[1]});
    solver_.solve(truth);
    for (std::size_t side = 0; side < 2; ++side) {
      truth_[side] = forces_of(truth, driver::side_names[side]);
    }
    for (const CreepWay& way : creep_ways) {
      result_.runs.push_back(run(way));
    }
    return std::move(result_);
  }

private:
  [[nodiscard]] driver::Scene prepared(const CreepWay& way) const {
    driver::Scene scene;
    result_.settings.apply(scene);
    scene.set("solve.creep", way.model);
    scene.set("solve.accuracy", way.accuracy);
    scene.set("solve.accuracy_of", "forces");
    return scene;
  }

  driver::Scene solve(const CreepWay& way) {
    driver::Scene scene = prepared(way);
    solver_.solve(scene);
    return scene;
  }

  /// The creepages whose linear forces on the left wheel's patch of the largest load are as drawn:
  /// from those of each creepage alone.
  void find_creepages(const CreepCase& one) {
    constexpr double small = 1e-6;
    std::array<double, 3> found{};
    for (std::size_t i = 0; i < creepage_keys.size(); ++i) {
      for (const char* key : creepage_keys) {
        result_.settings.set(key, key == creepage_keys[i] ? small : 0.0);
      }
      const auto patches = forces_of(solve({"linear", 1e-1}), "left");
      const PatchForces& most = *std::max_element(
          patches.begin(), patches.end(),
          [](const PatchForces& a, const PatchForces& b) { return a.bound < b.bound; });
      const double force = std::hypot(most.values[0], most.values[1]);
      found[i] = small * one.direction[i] * one.size * most.bound / force;
    }
    for (std::size_t i = 0; i < creepage_keys.size(); ++i) {
      result_.settings.set(creepage_keys[i], found[i]);
    }
  }

  CreepRun run(const CreepWay& way) {
    // The first solution makes plans; it is timed only if another one would take too long.
    driver::Scene scene = solve(way);
    double spent = scene.number("time_ms.total");
    std::vector<double> times;
    if (spent > creep_budget_ms) {
      times.push_back(scene.number("time_ms.rolling"));
    }
    while (times.empty() || (spent < creep_budget_ms && std::ssize(times) < repeats_)) {
      solver_.solve(scene);
      times.push_back(scene.number("time_ms.rolling"));
      spent += scene.number("time_ms.total");
    }
    CreepRun made;
    int patches = 0;
    for (std::size_t side = 0; side < 2; ++side) {
      const auto found = forces_of(scene, driver::side_names[side]);
      patches += static_cast<int>(found.size());
      made.wheels[side] = compare(found, truth_[side]);
    }
    made.time_us = 1e3 * driver::median(times) / patches;
    return made;
  }

  static CreepWheel compare(const std::vector<PatchForces>& found,
                            const std::vector<PatchForces>& truth) {
    CreepWheel wheel;
    wheel.comparable = found.size() == truth.size();
    for (std::size_t i = 0; wheel.comparable && i < truth.size(); ++i) {
      const std::array<double, 3> units{truth[i].bound, truth[i].bound,
                                        truth[i].bound * truth[i].mean_axis};
      CreepError error;
      for (std::size_t k = 0; k < units.size(); ++k) {
        error.values[k] = (found[i].values[k] - truth[i].values[k]) / units[k];
      }
      error.estimate = found[i].estimate;
      wheel.patches.push_back(error);
    }
    return wheel;
  }

  int repeats_;
  driver::Solver solver_;
  std::array<std::vector<PatchForces>, 2> truth_{};
  CreepMeasured result_;
};

} // namespace

double CreepError::largest() const {
  return std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
}

CreepMeasured measure_creep(const CreepCase& one, int repeats) {
  try {
    return CreepMeasurer(one, repeats).measure();
  } catch (const wrcontact::Error& failure) {
    CreepMeasured failed;
    failed.settings = one.scene.settings;
    failed.failure = failure.what();
    return failed;
  }
}

} // namespace tradeoff
