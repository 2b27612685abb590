#include "creep/creep_elements.hpp"

#include <algorithm>

#include "creep/constants.hpp"
#include "records/wheel_result.hpp"

namespace wrc {

bool on_own_pressures(const CreepRequest& request) {
  return request.model == CreepModel::full;
}

bool unlike_bodies(const CreepRequest& request) {
  return on_own_pressures(request) && request.material.difference_parameter != 0.0;
}

namespace {

/// Elements count as often as they are solved.
CreepGrid grid_within(const PatchResult& patch, const SmoothPressure& pressure,
                      const CreepRequest& request, double limit) {
  const PatchPressures pressures{patch.grid, patch.pressure, pressure, patch.bend};
  double times = request.pitch_is_free ? cost_of_free_pitch : 1.0;
  const auto extend = [&](CreepGrid& chosen) { // returns the factor on their number
    const double inner = static_cast<double>(chosen.grid.element_count());
    chosen.grid = extended_to(chosen.grid, patch.grid);
    return static_cast<double>(chosen.grid.element_count()) / inner;
  };
  const bool unlike = unlike_bodies(request);
  CreepGrid chosen = creep_grid(pressures, request.accuracy, limit);
  if (unlike) {
    times *= cost_of_unlike_bodies * extend(chosen);
  }
  const double wanted = times * chosen.wanted;
  if (wanted > limit && times > 1.0) {
    chosen = creep_grid(pressures, request.accuracy, limit / times);
    if (unlike) {
      extend(chosen);
    }
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
      const SmoothPressure pressure(patch->grid, patch->pressure, patch->bend);
      wanted += grid_within(*patch, pressure, request, request.element_limit).wanted;
    }
  }
  return wanted > request.element_limit ? request.element_limit / wanted : 1.0;
}

CreepRequest with_elements(CreepRequest request, const WheelResult& wheel) {
  if (wheel.is_cut) {
    request.accuracy = std::max(
        request.accuracy, std::min(wheel.discretisation_error.value_or(0.0), coarsest_of_cut));
  }
  request.element_share = share_of_elements(wheel, request);
  return request;
}

} // namespace wrc
