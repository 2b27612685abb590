// What tractions have displaced after a step of time, for the next one.
#include <algorithm>
#include <cmath>
#include <vector>

#include "rolling/constants.hpp"
#include "rolling/scaled_tractions.hpp"

namespace wrc {

void ScaledTractions::displace(std::span<const double> traction, std::span<const double> bound,
                               std::span<const double> edge, LinePlans& plans,
                               RollingSolution& solution) const {
  const Grid& grid = problem_.grid;
  const std::size_t count = bound.size();
  const double unit = bound_ / problem_.shear_modulus;
  ConvolutionWorkspace<double> workspace;
  const auto convolved = [&](const DifferenceWeights& weights) {
    std::vector<double> out(2 * count);
    convolution<double>(box_.shape.columns, weights, plans)
        .apply(traction.data(), traction.data() + count, out.data(), out.data() + count, workspace);
    return out;
  };
  std::vector<double> displaced = convolved({0.0, 1.0, 0.0, 0.0});
  for (double& displacement : displaced) {
    displacement *= unit * grid.longitudinal_step;
  }
  RollingProblem steady = problem_;
  steady.step_length = 0.0;
  const std::vector<double> along = convolved(difference_of(steady).weights);
  for (std::size_t i = 0; i < count; ++i) {
    const double g = bound[i];
    if (!(std::hypot(traction[i], traction[count + i]) < g * (1.0 - off_bound))) {
      continue;
    }
    const std::size_t at = element(i / box_.shape.columns, i % box_.shape.columns);
    const double x = grid.longitudinal(at % grid.longitudinal_count);
    const double y = grid.lateral(at / grid.longitudinal_count);
    const Creepages& w = problem_.creepages;
    const auto make_up_for = [&](std::size_t component, double rigid) {
      const std::size_t k = component * count + i;
      const double rate = step_rate(problem_);
      const double slip = rigid + displaced[k] / problem_.step_length +
                          unit * (problem_.rolling_share * along[k] + rate * edge[k] * traction[k]);
      displaced[k] -= slip * grid.longitudinal_step / rate;
    };
    const auto given = [&](std::span<const double> slip) { return slip.empty() ? 0.0 : slip[at]; };
    make_up_for(0, w.longitudinal - w.spin * y + given(problem_.slip_x));
    make_up_for(1, w.lateral + w.spin * x + given(problem_.slip_y));
  }
  solution.displacement_x.resize(grid.element_count());
  solution.displacement_y.resize(grid.element_count());
  for (std::size_t at = 0; at < grid.element_count(); ++at) { // beyond the contact as at its edge
    const auto within = [](std::size_t index, std::size_t first, std::size_t size) {
      return std::clamp(index, first, first + size - 1) - first;
    };
    const std::size_t row =
        box_.shape.rows - 1 -
        within(at % grid.longitudinal_count, box_.first_longitudinal, box_.shape.rows);
    const std::size_t column =
        within(at / grid.longitudinal_count, box_.first_lateral, box_.shape.columns);
    solution.displacement_x[at] = displaced[row * box_.shape.columns + column];
    solution.displacement_y[at] = displaced[count + row * box_.shape.columns + column];
  }
}

} // namespace wrc
