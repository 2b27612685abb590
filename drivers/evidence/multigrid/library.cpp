/// The library's solver on these problems, and its products and operations (methods.hpp).
#include <algorithm>

#include "mechanics/cascade.hpp"
#include "mechanics/constants.hpp"
#include "multigrid/methods.hpp"

namespace multigrid {

Answer solve_by_library(const Problem& problem, wrc::NormalSolver& solver, double tolerance) {
  wrc::PatchGap patch;
  wrc::NormalSolution solution = solver.solve(library_problem(problem, patch, tolerance));
  Answer answer;
  answer.q = std::move(solution.patches.front().pressure);
  for (double& value : answer.q) {
    value /= problem.pressure_unit();
  }
  answer.iterations = solution.iterations;
  answer.products = solution.convolutions;
  answer.estimate = solution.pressure_error;
  return answer;
}

void count_library(const Problem& problem, wrc::NormalSolver& solver, double tolerance,
                   Answer& answer) {
  wrc::ElementBox box;
  const wrc::LevelSize size{problem.rows(), problem.columns()};
  wrc::find_pressure_box(size, answer.q, wrc::box_margin, box);
  if (wrc::can_coarsen(size)) {
    const Problem coarse = coarser(problem);
    const double coarse_tolerance_given =
        std::max(wrc::coarse_level_tolerance / wrc::stop_share, tolerance);
    Answer before = solve_by_library(coarse, solver, coarse_tolerance_given);
    answer.products -= before.products;
    answer.iterations -= before.iterations;
    count_library(coarse, solver, coarse_tolerance_given, before);
    answer.operations = before.operations;
  }
  answer.operations += answer.products * FftProduct::exact_operations(box.rows(), box.columns()) +
                       answer.iterations * fft_operations(box.rows(), box.columns(), box.rows()) +
                       (answer.iterations + 1) * 20.0 * static_cast<double>(box.count());
}

} // namespace multigrid
