#include "wheel/creep_elements.hpp"

#include "wheel/constants.hpp"
#include "wheel/wheel_result.hpp"

namespace wrc {

bool on_own_pressures(const CreepRequest& request) {
  return request.model == CreepModel::full || request.model == CreepModel::fastsim_strips;
}

bool unlike_bodies(const CreepRequest& request) {
  return request.model == CreepModel::full && request.material.difference_parameter != 0.0;
}

namespace {

CreepGrid grid_within(const PatchResult& patch, const SmoothPressure& pressure,
                      const CreepRequest& request, double limit) {
  const PatchPressures pressures{patch.grid, patch.pressure, pressure};
  if (!unlike_bodies(request)) {
    return creep_grid(pressures, request.accuracy, limit);
  }
  // Counted by what they cost beside those of like bodies; returned is how many times as many.
  const auto extend = [&](CreepGrid& chosen) {
    const double inner = static_cast<double>(chosen.grid.element_count());
    chosen.grid = extended_to(chosen.grid, patch.grid);
    return cost_of_unlike_bodies * static_cast<double>(chosen.grid.element_count()) / inner;
  };
  CreepGrid chosen = creep_grid(pressures, request.accuracy, limit);
  const double times = extend(chosen);
  const double wanted = times * chosen.wanted;
  if (wanted > limit) {
    chosen = creep_grid(pressures, request.accuracy, limit / times);
    extend(chosen);
  }
  chosen.wanted = wanted;
  return chosen;
}

} // namespace

CreepGrid grid_of_patch(const PatchResult& patch, const SmoothPressure& pressure,
                        const CreepRequest& request) {
  const CreepGrid chosen = grid_within(patch, pressure, request, request.element_limit);
  const double share = request.element_share.value_or(1.0);
  return share < 1.0 ? grid_within(patch, pressure, request, share * chosen.wanted) : chosen;
}

double share_of_elements(const WheelResult& wheel, const CreepRequest& request) {
  const std::vector<const PatchResult*> patches = solved_patches(wheel);
  if (!on_own_pressures(request) || patches.size() < 2) {
    return 1.0;
  }
  double wanted = 0.0;
  for (const PatchResult* patch : patches) {
    if (patch->normal_force > 0.0) {
      const SmoothPressure pressure(patch->grid, patch->pressure);
      wanted += grid_within(*patch, pressure, request, request.element_limit).wanted;
    }
  }
  return wanted > request.element_limit ? request.element_limit / wanted : 1.0;
}

} // namespace wrc
