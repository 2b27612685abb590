/// The default solver of the normal contact problem, for one patch or several that share their
/// approach: fast at every size, robust at the extremes.
///
///  1. the problem without dimensions, pressures of the order of 1;
///  2. a cascade of grids for each patch (cascade.hpp), all patches solved together by projected CG
///     (projected_cg.hpp) on the least rectangle around each one's contact, started from the
///     coarser grids' pressures;
///  3. on the finest grids a check of every element outside the rectangles, whatever the
///     tolerance: overlap there enlarges the rectangle and the iteration goes on.
/// `tolerance` bounds the largest error of p relative to the largest p, against the exact solution
/// on the same grid; it holds by measurement (docs/accuracy.md), not by proof.
/// Units mm, N, MPa (mechanics/normal_contact.hpp). Thread rule: one object serves one thread at a
/// time; different objects are independent.
#pragma once

#include <memory>

#include "half_space/influence_cache.hpp"
#include "mechanics/normal_contact.hpp"

namespace wrc {

class NormalSolver {
public:
  explicit NormalSolver(PlannerRigor rigor = PlannerRigor::estimate,
                        Precision precision = Precision::mixed);
  /// Shares transforms of lines with others that have the same ones.
  explicit NormalSolver(std::shared_ptr<LinePlans> plans, Precision precision = Precision::mixed);
  ~NormalSolver();
  NormalSolver(NormalSolver&&) noexcept;
  NormalSolver& operator=(NormalSolver&&) noexcept;

  /// Throws Error(invalid_argument) on sizes, values or tolerances outside their range. What is
  /// kept from earlier calls (plans, tables, memory) changes no bit of the answer.
  NormalSolution solve(const NormalProblem& problem);

  /// The problem with bodies that yield (mechanics/yielding.hpp), from pressures near the answer;
  /// without any from the elastic solution.
  NormalSolution solve_yielding(const NormalProblem& problem);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace wrc
