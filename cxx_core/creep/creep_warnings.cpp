// What to warn of in creep forces that were found.
#include <algorithm>

#include "accuracy/element_limit.hpp"
#include "base/error.hpp"
#include "creep/creep_elements.hpp"
#include "creep/creep_forces.hpp"
#include "records/wheel_result.hpp"

namespace wrc {
namespace {

void warn_of_unlike_bodies(WheelResult& wheel, const CreepRequest& request) {
  if (request.material.difference_parameter == 0.0 || wheel.patches.empty()) {
    return;
  }
  if (!on_own_pressures(request)) {
    wheel.warnings.push_back(
        {WarningClass::unlike_materials,
         "creep forces of unlike materials: this model leaves out that pressures and tractions "
         "change each other; solve.creep = full includes it"});
    return;
  }
  double change = 0.0;
  for (const PatchResult* patch : solved_patches(wheel)) {
    change = std::max(change, patch->creep->pressure_change);
  }
  if (change > request.accuracy) {
    wheel.warnings.push_back({WarningClass::unlike_materials,
                              "creep forces of unlike materials: tractions change pressures by " +
                                  short_text_of(change) +
                                  " on average, which the results of normal contact do not include",
                              change / request.accuracy});
  }
}

} // namespace

double error_of_creep_forces(const WheelResult& wheel) {
  double error = 0.0;
  double force = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    if (patch.creep) {
      error += patch.normal_force * patch.creep->error_estimate.value_or(0.0);
      force += patch.normal_force;
    }
  }
  return force > 0.0 ? error / force : 0.0;
}

void warn_of_creep_forces(WheelResult& wheel, const CreepRequest& request) {
  double wanted = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    wanted += patch.creep->elements_wanted;
  }
  if (wanted > request.element_limit) {
    wheel.warnings.push_back({WarningClass::element_limit,
                              "creep forces: " + text_of_limit(wanted, request.element_limit)});
  }
  const double excess = error_of_creep_forces(wheel) / request.accuracy;
  for (std::size_t i = 0; excess > 1.0 && i < wheel.patches.size(); ++i) {
    const PatchResult& patch = wheel.patches[i];
    if (patch.creep->error_estimate.value_or(0.0) > request.accuracy) {
      wheel.warnings.push_back({WarningClass::creep_accuracy,
                                of_patch(wheel, i) + "creep forces: accuracy " +
                                    text_of(request.accuracy) + " not reached: estimated error " +
                                    short_text_of(*patch.creep->error_estimate),
                                excess});
    }
  }
  warn_of_unlike_bodies(wheel, request);
}

} // namespace wrc
