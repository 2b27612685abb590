/// Solves tangential contact (rolling_problem.hpp) and checks its solutions.
///
/// Thread rule: one RollingSolver serves one thread at a time. Same input, same bits, whatever was
/// solved before.
#pragma once

#include <memory>
#include <span>

#include "half_space/influence_cache.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// Throws Error(invalid_argument) for a problem outside its permitted ranges; names the argument.
void check_problem(const RollingProblem& problem);

TangentialResiduals compute_residuals(const RollingProblem& problem,
                                      std::span<const double> traction_x,
                                      std::span<const double> traction_y, LinePlans& plans);

/// Keeps buffers, coefficients and spectra from one solution to the next.
class RollingSolver {
public:
  RollingSolver() : RollingSolver(std::make_shared<LinePlans>()) {}
  explicit RollingSolver(std::shared_ptr<LinePlans> plans);
  ~RollingSolver();
  RollingSolver(RollingSolver&&) noexcept;
  RollingSolver& operator=(RollingSolver&&) noexcept;

  /// Throws Error(invalid_argument) like check_problem.
  RollingSolution solve(const RollingProblem& problem);
  /// Of all lengths used so far.
  [[nodiscard]] LinePlans& plans();

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace wrc
