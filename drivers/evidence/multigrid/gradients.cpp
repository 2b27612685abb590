/// Projected, preconditioned conjugate gradients: p = max(0, p + alpha v), v = z + beta v of Polak
/// & Ribiere, z the periodic inverse of the residual on contact, as mechanics/projected_cg.hpp for
/// one patch and a prescribed load. Products may be of any kind. Units mm (problems.hpp).
#include <algorithm>
#include <cmath>

#include "multigrid/methods.hpp"

namespace multigrid {
namespace {

/// origin: bound: ends what does not converge.
constexpr int most_iterations = 500;

std::vector<double> iterate(const Problem& problem, GridTools& tools, std::vector<double> start,
                            double tolerance, Answer& answer) {
  ContactState state(problem, tools, std::move(start), answer);
  std::vector<double> direction(state.q.size());
  std::vector<double> response(state.q.size());
  std::vector<double> last_residual(state.q.size());
  double last_product = 0.0;
  for (answer.iterations = 0;; ++answer.iterations) {
    state.form_residual();
    answer.estimate = state.estimate();
    if (answer.estimate <= tolerance || answer.iterations == most_iterations) {
      return state.finish();
    }
    const double product = dot(state.z, state.r);
    const double beta = last_product > 0.0
                            ? std::max(0.0, (product - dot(state.z, last_residual)) / last_product)
                            : 0.0;
    for (std::size_t i = 0; i < direction.size(); ++i) {
      direction[i] = state.z[i] + beta * direction[i];
    }
    keep_load(direction, state.contact);
    last_product = product;
    last_residual = state.r;
    double work = dot(state.r, direction);
    if (!(work > 0.0)) { // uphill: the residual itself
      direction = state.r;
      keep_load(direction, state.contact);
      work = dot(state.r, direction);
      last_product = 0.0;
    }
    state.apply(direction, response);
    state.move(direction, response, work / dot(direction, response));
  }
}

} // namespace

Answer solve_by_gradients(const Problem& problem, std::vector<GridTools>& tools, double tolerance) {
  const std::vector<Problem> problems = coarsened(problem);
  Answer answer;
  eliminate(problems.back(), *tools.back().table, {}, answer);
  for (std::size_t k = problems.size() - 1; k-- > 0;) {
    answer.products = 0;
    answer.q =
        iterate(problems[k], tools[k], refined(problems[k + 1], answer.q, problems[k]),
                stop_share * (k > 0 ? std::max(tolerance, coarse_tolerance) : tolerance), answer);
  }
  return answer;
}

} // namespace multigrid
