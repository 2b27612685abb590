#include "creep/creep_on_patch.hpp"

namespace wrc {

CreepForces forces_on_patch(const PatchTask& task, RollingSolver& solver, CreepResult& creep) {
  CreepProblem problem(task, solver.plans(), creep);
  if (task.request.derivatives) {
    problem.request_rates();
  }
  return problem.take(solver.solve(problem.rolling()), creep);
}

} // namespace wrc
