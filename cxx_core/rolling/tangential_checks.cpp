// What of a tangential problem is checked: its permitted ranges before it is solved, and how well
// an answer solves it, afterwards.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/reductions.hpp"
#include "half_space/traction_convolution.hpp"
#include "mechanics/normal_contact.hpp"
#include "rolling/constants.hpp"
#include "rolling/leading_edge.hpp"
#include "rolling/rolling_contact.hpp"
#include "rolling/scaled_tractions.hpp"
#include "rolling/traction_loops.hpp"

namespace wrc {

namespace {

void check_finite(const std::string& argument, double value) {
  if (!std::isfinite(value)) {
    throw_invalid_argument(argument, value, "must be finite");
  }
}

void check_angles_of_rows(const RollingProblem& problem) {
  if (!problem.angles.empty() && problem.angles.size() != problem.grid.lateral_count) {
    throw_invalid_argument("angles.size", static_cast<double>(problem.angles.size()),
                           "must be the grid's " + std::to_string(problem.grid.lateral_count) +
                               " rows, or 0");
  }
  if (!std::ranges::all_of(problem.angles, [](double angle) { return std::isfinite(angle); })) {
    throw_invalid_argument("angles", "not a number", "must be finite");
  }
}

} // namespace

void check_problem(const RollingProblem& problem) {
  check_grid(problem.grid);
  if (problem.pressure.size() != problem.grid.element_count()) {
    throw_invalid_argument("pressure.size", static_cast<double>(problem.pressure.size()),
                           "must be the grid's " + std::to_string(problem.grid.element_count()) +
                               " elements");
  }
  const auto wrong = std::find_if(problem.pressure.begin(), problem.pressure.end(),
                                  [](double p) { return !std::isfinite(p) || p < 0.0; });
  if (wrong != problem.pressure.end()) {
    throw_invalid_argument("pressure[" + std::to_string(wrong - problem.pressure.begin()) + "]",
                           *wrong, "must be finite and not negative");
  }
  if (!problem.covered.empty() && problem.covered.size() != problem.pressure.size()) {
    throw_invalid_argument("covered.size", static_cast<double>(problem.covered.size()),
                           "must be the number of pressures, or 0");
  }
  const auto no_share = std::find_if(problem.covered.begin(), problem.covered.end(),
                                     [](double share) { return !(share >= 0.0 && share <= 1.0); });
  if (no_share != problem.covered.end()) {
    throw_invalid_argument("covered[" + std::to_string(no_share - problem.covered.begin()) + "]",
                           *no_share, "must be between 0 and 1");
  }
  check_angles_of_rows(problem);
  if (!(problem.friction >= 0.0) || !std::isfinite(problem.friction)) {
    throw_invalid_argument("friction", problem.friction, "must be finite and not negative");
  }
  if (!(problem.shear_modulus > 0.0) || !std::isfinite(problem.shear_modulus)) {
    throw_invalid_argument("shear_modulus", problem.shear_modulus,
                           "must be finite and greater than 0");
  }
  if (!(problem.poisson >= 0.0 && problem.poisson <= 0.5)) {
    throw_invalid_argument("poisson", problem.poisson, "must be between 0 and 0.5");
  }
  if (!(std::abs(problem.difference_parameter) <= 0.5)) {
    throw_invalid_argument("difference_parameter", problem.difference_parameter,
                           "must be between -0.5 and 0.5");
  }
  if (problem.difference_parameter != 0.0 &&
      (problem.motion != TangentialMotion::rolling || problem.step_length > 0.0)) {
    throw_invalid_argument("difference_parameter", problem.difference_parameter,
                           "must be 0 unless the contact rolls steadily");
  }
  for (const auto& [name, values] :
       {std::pair{"previous_x", problem.previous_x}, std::pair{"previous_y", problem.previous_y},
        std::pair{"slip_x", problem.slip_x}, std::pair{"slip_y", problem.slip_y},
        std::pair{"weight_x", problem.weight_x}, std::pair{"weight_y", problem.weight_y}}) {
    const std::size_t in_x = (name[0] == 's'   ? problem.slip_x
                              : name[0] == 'w' ? problem.weight_x
                                               : problem.previous_x)
                                 .size();
    if (values.size() != in_x || (!values.empty() && values.size() != problem.pressure.size())) {
      throw_invalid_argument(std::string(name) + ".size", static_cast<double>(values.size()),
                             "must be the number of pressures, or 0 in both directions");
    }
    if (!values.empty() && !all_finite(values.data(), values.size())) {
      throw_invalid_argument(name, "a value that is not finite", "all must be finite");
    }
  }
  if (!(problem.step_length >= 0.0) || !std::isfinite(problem.step_length)) {
    throw_invalid_argument("step_length", problem.step_length, "must be finite and not negative");
  }
  if (!(problem.rolling_share >= 0.0 && problem.rolling_share <= 1.0)) {
    throw_invalid_argument("rolling_share", problem.rolling_share, "must be between 0 and 1");
  }
  check_finite("longitudinal_creepage", problem.creepages.longitudinal);
  check_finite("lateral_creepage", problem.creepages.lateral);
  check_finite("spin_creepage", problem.creepages.spin);
  if (!(problem.tolerance > 0.0 && problem.tolerance < 1.0)) {
    throw_invalid_argument("tolerance", problem.tolerance, "must be between 0 and 1");
  }
  if (problem.maximum_iterations < 1) {
    throw_invalid_argument("maximum_iterations", problem.maximum_iterations, "must be at least 1");
  }
}

namespace {

/// Compliances of the elements that strips begin with; `bound` and tractions become those that
/// stand for them (leading_edge.hpp).
std::vector<double> take_in_edges(const ScaledTractions& scaled, double poisson,
                                  std::vector<double>& bound, std::vector<double>& traction) {
  const TractionShape& shape = scaled.box().shape;
  const std::size_t count = bound.size();
  std::vector<double> edge(2 * count);
  if (!scaled.has_edges()) {
    return edge;
  }
  scaled.fill_covered(edge.data(), shape.columns);
  make_edges(bound.data(), edge.data(), shape, shape.columns, scaled.aspect(), poisson,
             scaled.difference().upstream);
  for (std::size_t i = 0; i < count; ++i) {
    if (bound[i] > 0.0) {
      const double share =
          scaled.mean_share(scaled.element(i / shape.columns, i % shape.columns), bound[i]);
      traction[i] /= share;
      traction[count + i] /= share;
    }
  }
  return edge;
}

} // namespace

TangentialResiduals compute_residuals(const RollingProblem& problem,
                                      std::span<const double> traction_x,
                                      std::span<const double> traction_y, LinePlans& plans) {
  check_problem(problem);
  TangentialResiduals residuals;
  const ScaledTractions scaled(problem, plans);
  if (scaled.empty()) {
    return residuals;
  }
  const TractionShape& shape = scaled.box().shape;
  const std::size_t pitch = shape.columns;
  const std::size_t count = shape.rows * pitch;
  const auto convolution = scaled.convolution<double>(pitch, scaled.difference().weights, plans);
  std::vector<double> bound(count);
  std::vector<double> rigid(2 * count);
  std::vector<double> q(2 * count);
  std::vector<double> s(2 * count);
  scaled.fill_bound(bound.data(), pitch);
  scaled.fill_rigid_slip(rigid.data(), shape, pitch, 0);
  scaled.read_tractions(traction_x, traction_y, q.data(), pitch);
  const std::vector<double> edge = take_in_edges(scaled, problem.poisson, bound, q);
  ConvolutionWorkspace<double> workspace;
  convolution.apply(q.data(), q.data() + count, s.data(), s.data() + count, workspace);
  for (std::size_t i = 0; i < 2 * count; ++i) {
    s[i] += rigid[i];
  }
  if (scaled.has_edges()) {
    add_edges(edge.data(), q.data(), s.data(), count);
  }
  const double step =
      natural_step_of(shape, convolution.self_influence(), scaled.difference().upstream);
  const ResidualSums sums =
      natural_residual(q.data(), s.data(), bound.data(), edge.data(), step, count);
  double whole_q = 0.0;
  double gap = 0.0;
  double rigid_power = 0.0;
  double adhesion = 0.0;
  double rigid_sum = 0.0;
  double angles = 0.0;
  double speeds = 0.0;
  std::size_t sticking = 0;
  std::size_t contacts = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double g = bound[i];
    if (!(g > 0.0)) {
      continue;
    }
    ++contacts;
    const double length = std::hypot(q[i], q[count + i]);
    const double speed = std::hypot(s[i], s[count + i]);
    const double rigid_speed = std::hypot(rigid[i], rigid[count + i]);
    const double along = q[i] * s[i] + q[count + i] * s[count + i];
    whole_q += length;
    gap += g * speed + along;
    rigid_power += g * rigid_speed;
    rigid_sum += rigid_speed;
    residuals.excess = std::max(residuals.excess, length / g - 1.0);
    if (length < g * (1.0 - 1e-6)) {
      adhesion += speed;
      ++sticking;
    } else if (speed > 0.0) {
      angles += speed * std::acos(std::clamp(-along / (length * speed), -1.0, 1.0));
      speeds += speed;
    }
  }
  residuals.natural = whole_q > 0.0 ? sums.change / whole_q : sums.ratio();
  residuals.complementarity = rigid_power > 0.0 ? gap / rigid_power : 0.0;
  residuals.adhesion_slip =
      sticking > 0 && rigid_sum > 0.0
          ? adhesion / static_cast<double>(sticking) / (rigid_sum / static_cast<double>(contacts))
          : 0.0;
  residuals.angle = speeds > 0.0 ? angles / speeds : 0.0;
  return residuals;
}

} // namespace wrc
