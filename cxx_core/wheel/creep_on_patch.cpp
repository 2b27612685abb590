#include "wheel/creep_on_patch.hpp"

#include <utility>

#include "rolling/fastsim.hpp"
#include "wheel/creep_rates.hpp"

namespace wrc {
namespace {

/// FASTSIM strip by strip; its derivatives are differences.
RollingSolution solve_by_strips(const PatchTask& task, const RollingProblem& problem,
                                RollingSolver& solver) {
  const Flexibilities flexibilities = flexibilities_of(problem, solver);
  RollingSolution solution = solve_with_fastsim(problem, flexibilities);
  if (task.request.derivatives) {
    solution.by_creepage = difference_by_creepage(
        task.patch, task.request, task.motion, problem.creepages,
        [&](const Creepages& creepages) -> CreepForces {
          RollingProblem other = problem;
          other.creepages = creepages;
          const RollingSolution found = solve_with_fastsim(other, flexibilities);
          return {found.longitudinal_force, found.lateral_force, found.spin_moment};
        });
    for (const ProblemRate& rate : problem.rates) {
      solution.by_rate.push_back(difference_by_strips(problem, flexibilities, rate));
    }
  }
  return solution;
}

} // namespace

CreepForces forces_on_patch(const PatchTask& task, RollingSolver& solver, CreepResult& creep) {
  CreepProblem problem(task, creep);
  if (task.request.derivatives) {
    problem.request_rates();
  }
  return problem.take(task.request.model == CreepModel::full
                          ? solver.solve(problem.rolling())
                          : solve_by_strips(task, problem.rolling(), solver),
                      creep);
}

} // namespace wrc
