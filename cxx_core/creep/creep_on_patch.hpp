/// Creep forces of a patch on its own pressures by the full theory, with the slip of its elements.
///
/// Left-hand frame of the side. Units mm, N, MPa, rad. Thread rule: as the solver's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "creep/constants.hpp"
#include "creep/creep_problem.hpp"
#include "creep/patch_motion.hpp"
#include "records/wheel_result.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc {

/// Fills in what `creep` has of grid, fields, areas, derivatives, error and power.
CreepForces forces_on_patch(const PatchTask& task, RollingSolver& solver, CreepResult& creep);

/// Derivatives by creepages of the cheaper models, row by row: central differences over a small
/// fraction of the creepage at which a sphere's contact of this size slides. `forces` returns an
/// array of numbers.
template <class Forces>
auto difference_by_creepage(const PatchResult& patch, const CreepRequest& request,
                            const PatchMotion& motion, Creepages at, const Forces& forces) {
  constexpr std::size_t count = std::tuple_size_v<decltype(forces(at))>;
  const double size =
      std::max(patch.semi_axis_longitudinal * patch.semi_axis_lateral, patch.grid.element_area());
  // The linear law knows no friction, and has the same derivatives by any steps.
  const double friction = request.model == CreepModel::linear
                              ? std::max(motion.friction, least_linear_friction)
                              : motion.friction;
  const double translation =
      creep_difference_step * friction * patch.normal_force / (request.material.modulus * size);
  const std::array<Creepages, 3> steps{Creepages{translation, 0.0, 0.0},
                                       {0.0, translation, 0.0},
                                       {0.0, 0.0, translation / std::sqrt(size)}};
  const std::array<double, 3> lengths{translation, translation, translation / std::sqrt(size)};
  std::array<double, 3 * count> derivatives{};
  for (std::size_t i = 0; i < steps.size() && translation > 0.0; ++i) {
    const Creepages& step = steps[i];
    const std::array<double, count> ahead = forces(
        {at.longitudinal + step.longitudinal, at.lateral + step.lateral, at.spin + step.spin});
    const std::array<double, count> behind = forces(
        {at.longitudinal - step.longitudinal, at.lateral - step.lateral, at.spin - step.spin});
    const double scale = 0.5 / lengths[i];
    for (std::size_t row = 0; row < count; ++row) {
      derivatives[3 * row + i] = scale * (ahead[row] - behind[row]);
    }
  }
  return derivatives;
}

} // namespace wrc
