#include "creep/creep_on_patch.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "creep/creep_rates.hpp"
#include "rolling/fastsim.hpp"

namespace wrc {
namespace {

/// FASTSIM strip by strip; its derivatives are differences.
RollingSolution solve_by_strips(const PatchTask& task, const RollingProblem& problem,
                                RollingSolver& solver) {
  const Flexibilities flexibilities = flexibilities_of(problem, solver);
  RollingSolution solution = solve_with_fastsim(problem, flexibilities);
  if (task.request.derivatives) {
    const std::array<double, 12> by_creepage = difference_by_creepage(
        task.patch, task.request, task.motion, problem.creepages, [&](const Creepages& creepages) {
          RollingProblem other = problem;
          other.creepages = creepages;
          const RollingSolution found = solve_with_fastsim(other, flexibilities);
          return std::array{found.longitudinal_force, found.lateral_force, found.spin_moment,
                            found.weighted_force};
        });
    std::copy_n(by_creepage.begin(), 9, solution.by_creepage.begin());
    std::copy_n(by_creepage.begin() + 9, 3, solution.weighted_by_creepage.begin());
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
