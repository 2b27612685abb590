#include "creep/creep_of_unlike_bodies.hpp"

#include <utility>
#include <vector>

#include "mechanics/cascade.hpp"
#include "rolling/unlike_bodies.hpp"

namespace wrc {

CreepForces forces_of_unlike_bodies(const PatchTask& task, RollingSolver& solver,
                                    CreepResult& creep) {
  CreepProblem plain(task, solver.plans(), creep);
  if (task.request.derivatives) {
    plain.request_rates();
  }
  RollingProblem problem = plain.rolling();
  problem.difference_parameter = task.request.material.difference_parameter;
  const RollingFrame& frame = task.motion.frame;
  std::vector<double> distance;
  interpolate(task.patch.grid, task.patch.undeformed_distance, creep.grid, distance);
  distance = frame.turned_numbers(std::move(distance));
  UnlikeSolution both =
      solve_unlike(problem, distance, task.request.combined_modulus, problem.tolerance, solver);
  creep.pressure_change = both.pressure_change;
  creep.pressure = frame.turned_numbers(std::move(both.pressure));
  return plain.take(std::move(both.rolling), creep);
}

} // namespace wrc
