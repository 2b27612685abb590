#include "creep/creep_rates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "creep/constants.hpp"
#include "records/wheel_result.hpp"

namespace wrc {
namespace {

/// How a patch changes with one motion of the wheelset.
struct PatchRate {
  const std::vector<double>& pressure;
  double normal_force;
  ElementMotion elements; ///< about the reference
};

/// Elements under pressure keep some.
MovedPatch moved(const PatchResult& patch, const PatchRate& rate, double step) {
  constexpr double least_left = 0.5; // of an element's pressure; not a tuning constant
  const ElementMotion& motion = rate.elements;
  MovedPatch result{patch.pressure,
                    patch.normal_force + step * rate.normal_force,
                    {step * motion.along, step * motion.across, step * motion.longitudinal_growth,
                     step * motion.lateral_growth}};
  for (std::size_t i = 0; i < rate.pressure.size(); ++i) {
    double& p = result.pressure[i];
    p = std::max(p + step * rate.pressure[i], least_left * p);
  }
  return result;
}

/// By how much of itself the fastest part of a patch changes.
double fastest_of(const PatchResult& patch, const PatchRate& rate) {
  const ElementMotion& motion = rate.elements;
  double fastest =
      std::max({std::abs(motion.along) / patch.grid.longitudinal_step,
                std::abs(motion.across) / patch.grid.lateral_step,
                std::abs(motion.longitudinal_growth), std::abs(motion.lateral_growth)});
  for (const double of_element : rate.pressure) {
    fastest = std::max(fastest, std::abs(of_element) / patch.pmax_element);
  }
  return fastest;
}

PatchMove move_of(const PatchResult& patch, const std::vector<double>& pressure,
                  double normal_force, ElementMotion elements, const Vector3& reference,
                  double share) {
  elements.along -= dot(reference, patch.frame.longitudinal);
  elements.across -= dot(reference, patch.frame.lateral);
  const PatchRate rate{pressure, normal_force, elements};
  const double fastest = fastest_of(patch, rate);
  const double step = fastest > 0.0 ? share / fastest : 1.0;
  return {moved(patch, rate, step), moved(patch, rate, -step), 2.0 * step};
}

} // namespace

ByMotion<PatchMove> moves_of(const PatchResult& patch, const PatchRates& rates, double share) {
  return by_motion([&](std::size_t motion) {
    return move_of(patch, rates.pressure[motion], rates.normal_force[motion],
                   rates.elements[motion], rates.reference[motion], share);
  });
}

Grid moved_grid(Grid grid, const ElementMotion& motion) {
  const auto move = [](double& first, double& step, double translation, double growth) {
    first += translation + growth * first;
    step += growth * step;
  };
  move(grid.longitudinal_first, grid.longitudinal_step, motion.along, motion.longitudinal_growth);
  move(grid.lateral_first, grid.lateral_step, motion.across, motion.lateral_growth);
  return grid;
}

void complete(CreepDerivatives& derivatives, const CreepForces& forces, const Creepages& at,
              double friction, double normal_force) {
  const std::array<double, 3> values{forces.longitudinal, forces.lateral, forces.spin_moment};
  constexpr std::array<double, 3> growth{1.0, 1.0, 4.0 / 3.0};
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double* by = derivatives.by_creepage.data() + 3 * row;
    const double by_translation = by[0] * at.longitudinal + by[1] * at.lateral;
    derivatives.by_load[row] = (growth[row] * values[row] - by_translation / 3.0) / normal_force;
    derivatives.by_friction[row] =
        friction > 0.0
            ? (values[row] - by_translation - by[2] * at.spin - derivatives.by_slip[row]) / friction
            : 0.0;
  }
}

void add_derivatives(CreepDerivatives& whole, const CreepDerivatives& part, double weight,
                     double longitudinal, double lateral) {
  const std::array<std::array<double, 3>, 3> transfer{
      {{1.0, 0.0, -lateral}, {0.0, 1.0, longitudinal}, {0.0, 0.0, 1.0}}};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t inner = 0; inner < 3; ++inner) {
      const double arm = transfer[inner][row];
      whole.by_load[row] += weight * arm * part.by_load[inner];
      whole.by_friction[row] += arm * part.by_friction[inner];
      for (std::size_t column = 0; column < 3; ++column) {
        for (std::size_t k = 0; k < 3; ++k) {
          whole.by_creepage[3 * row + column] +=
              arm * part.by_creepage[3 * inner + k] * transfer[k][column];
        }
      }
    }
  }
}

ProblemRate rate_between(const RollingProblem& now, const Grid& grid, const ProblemFields& later,
                         double step) {
  ProblemRate rate;
  rate.longitudinal_first = (grid.longitudinal_first - now.grid.longitudinal_first) / step;
  rate.longitudinal_step = (grid.longitudinal_step - now.grid.longitudinal_step) / step;
  rate.lateral_first = (grid.lateral_first - now.grid.lateral_first) / step;
  rate.lateral_step = (grid.lateral_step - now.grid.lateral_step) / step;
  const auto by_step = [step](const std::vector<double>& after, std::span<const double> before) {
    std::vector<double> by;
    std::transform(after.begin(), after.end(), before.begin(), std::back_inserter(by),
                   [step](double one, double other) { return (one - other) / step; });
    return by;
  };
  rate.pressure = by_step(later.pressure, now.pressure);
  rate.covered = by_step(later.covered, now.covered);
  rate.slip_x = by_step(later.slip.x, now.slip_x);
  rate.slip_y = by_step(later.slip.y, now.slip_y);
  rate.weight_x = by_step(later.weights.x, now.weight_x);
  rate.weight_y = by_step(later.weights.y, now.weight_y);
  return rate;
}

} // namespace wrc
