// step_costs: steps of a run over irregular track, for callgrind; used by count_costs.py.
#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/scene.hpp"
#include "support/scene_file.hpp"
#include "support/service_run.hpp"

namespace {

constexpr double wheel_radius = 460.0; // mm, the default
constexpr int first_index = 13;        // of the run, and how far steps are apart on it
constexpr int indices_apart = 253;

} // namespace

// By these names callgrind finds what is counted.
extern "C" {
[[gnu::noinline]] bool counted_step(driver::Solver& solver, driver::Scene& scene,
                                    const std::array<double, 6>& position,
                                    const std::array<double, 6>& velocity, bool derivatives) {
  wrcontact::Step step;
  return solver.step(scene, position, velocity, step, derivatives);
}
[[gnu::noinline]] bool counted_solution(driver::Solver& solver, driver::Scene& scene) {
  return solver.solve(scene);
}
}

int main(int argc, char** argv) {
  driver::Program app(
      "step_costs",
      "Takes steps of a wheelset over irregular track: S1002 on 60E1, both wheels, accuracy of "
      "forces.\ncount_costs.py counts their instructions.");
  int steps = 8;
  bool loaded = false;
  bool derivatives = false;
  double along = 0.0;
  double pitch = 0.0;
  std::vector<std::string> assignments;
  app.add("--steps", steps, "number of steps");
  app.flag("--loaded", loaded, "under loads, with the roll solved, instead of at positions");
  app.flag("--derivatives", derivatives, "with derivatives, at positions");
  app.add("--along", along, "position along the track, mm");
  app.add("--pitch", pitch, "pitch angle, rad");
  app.add("--set", assignments, "keys of the scene, as in wrc_case");
  return app.run(argc, argv, [&] {
    driver::Scene scene;
    scene.set("solve.accuracy_of", "forces");
    scene.set("solve.accuracy", 1e-2);
    scene.set("pose.longitudinal", along);
    scene.set("pose.pitch", pitch);
    driver::apply_assignments(scene, assignments);
    driver::Solver solver;
    std::vector<std::array<double, 6>> positions;
    for (int i = 0; i < steps; ++i) { // also reads profiles and makes plans
      const driver::ServiceStep step = driver::service_step(first_index + indices_apart * i);
      driver::set_pose(step, scene);
      solver.solve(scene);
      double depth = std::numeric_limits<double>::infinity();
      for (const std::string& side : driver::sides_of(scene)) {
        depth = std::min(depth, scene.number(side + ".depth"));
      }
      positions.push_back({along, step.lateral, scene.number("vertical") - depth,
                           scene.number("roll"), pitch, step.yaw});
    }
    for (int i = 0; i < steps; ++i) {
      const driver::ServiceStep step = driver::service_step(first_index + indices_apart * i);
      driver::set_pose(step, scene);
      const bool converged =
          loaded ? counted_solution(solver, scene)
                 : counted_step(solver, scene, positions[static_cast<std::size_t>(i)],
                                {step.speed, step.lateral_velocity, 0.0, 0.0,
                                 step.speed / wheel_radius, step.yaw_velocity},
                                derivatives);
      if (!converged) {
        std::cerr << "step_costs: step " << i << " has not converged\n";
      }
    }
    return 0;
  });
}
