// Wheel/rail scenes on a given grid: the whole way from profiles to pressures.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "support/normal.hpp"
#include "support/scene.hpp"
#include "wrc_benchmark/problem.hpp"
#include "wrc_benchmark/timing.hpp"

namespace benchmark {
namespace {

/// pmax is compared with a grid this much finer in both directions.
constexpr std::int64_t refinement = 3;
constexpr double finer_tolerance = 1e-6;

class SceneCase : public Problem {
public:
  SceneCase(std::string case_name, const GridSize& grid, int wheels)
      : case_name_(std::move(case_name)), grid_(grid), wheels_(wheels) {}

  Times solve_cold(const Settings& settings) override {
    handles_.erase(settings.method);
    Stopwatch watch;
    Handles& handles = handles_[settings.method];
    prepare(handles.scene, grid_, settings);
    return solve(handles, watch);
  }

  Times solve_warm(const Settings& settings) override {
    Stopwatch watch;
    return solve(handles_.at(settings.method), watch);
  }

  Quality judge(const std::string& method) override {
    const driver::Scene& scene = handles_.at(method).scene;
    Quality quality;
    for (const std::string& side : scene.sides()) {
      quality.fill = std::max(quality.fill, scene.number(side + ".fill"));
      quality.iterations = std::max(quality.iterations, scene.number(side + ".iterations"));
      quality.error_p = std::max(quality.error_p, error_p(scene, side));
    }
    return quality;
  }

  std::optional<double> error_pmax(const std::string& method) override {
    const driver::Scene& scene = handles_.at(method).scene;
    if (finer_pmax_.empty()) {
      driver::Scene finer;
      prepare(finer, {refinement * grid_.lateral, refinement * grid_.longitudinal},
              {"default", finer_tolerance});
      finer.solve();
      for (const std::string& side : finer.sides()) {
        finer_pmax_[side] = finer.number(side + ".pmax");
      }
    }
    double error = 0.0;
    for (const auto& [side, pmax] : finer_pmax_) {
      error = std::max(error, std::abs(scene.number(side + ".pmax") / pmax - 1.0));
    }
    return error;
  }

  [[nodiscard]] int wheels() const override { return wheels_; }

private:
  struct Handles {
    driver::Scene scene;
    driver::Solver solver;
  };

  void prepare(driver::Scene& scene, const GridSize& grid, const Settings& settings) const {
    if (case_name_ == "manchester-5") {
      scene.set("track.rail", "UIC60-Manchester");
      scene.set("pose.lateral", 5.0);
      scene.set("pose.roll", 0.0);
    }
    scene.set("solve.side", wheels_ == 1 ? "left" : "both");
    scene.set("solve.grid", std::vector<double>{static_cast<double>(grid.lateral),
                                                static_cast<double>(grid.longitudinal)});
    scene.set("solve.solver", settings.method);
    scene.set("solve.elements", std::string("constant")); // the same problem for all methods
    scene.set("solve.tolerance", settings.tolerance);
  }

  /// Whatever takes time beside the three stages is set-up, from the start of the watch.
  static Times solve(Handles& handles, Stopwatch& watch) {
    const driver::Scene& scene = handles.scene;
    const bool converged = handles.solver.solve(handles.scene);
    Times times;
    times.total = watch.lap();
    times.geometry = scene.number("time_ms.geometry");
    times.remesh = scene.number("time_ms.remesh");
    times.mechanics = scene.number("time_ms.mechanics");
    times.setup = std::max(0.0, times.total - times.geometry - times.remesh - times.mechanics);
    if (!converged) {
      std::cerr << "wrc_benchmark: a solution has not converged\n";
    }
    return times;
  }

  /// Against the very distances of this solution, solved by themselves.
  [[nodiscard]] double error_p(const driver::Scene& scene, const std::string& side) const {
    driver::Normal reference;
    reference.set_grid(grid_.lateral, grid_.longitudinal, scene.number(side + ".element_size.0"),
                       scene.number(side + ".element_size.1"));
    reference.set_distance(scene.field(side + ".undeformed_distance"));
    reference.set("normal_load", scene.number(side + ".normal_force"));
    reference.set("tolerance", reference_tolerance(grid_));
    reference.set("precision", "double");
    reference.set("elements", "constant");
    reference.solve();
    return largest_error(scene.field(side + ".pressure"), reference.field("pressure"));
  }

  std::string case_name_;
  GridSize grid_;
  int wheels_;
  std::map<std::string, Handles> handles_;
  std::map<std::string, double> finer_pmax_;
};

} // namespace

const std::vector<CaseDescription>& scene_cases() {
  static const std::vector<CaseDescription> all{
      {"table1", "scene: S1002 on 60E1, centred, 80 kN; one wheel, then both"},
      {"manchester-5", "scene: S1002 on the Manchester UIC60, y = 5 mm without roll, left wheel"}};
  return all;
}

std::unique_ptr<Problem> make_scene_problem(const std::string& case_name, const GridSize& grid,
                                            int wheels) {
  return std::make_unique<SceneCase>(case_name, grid, wheels);
}

} // namespace benchmark
