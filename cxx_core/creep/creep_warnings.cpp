// What to warn of in creep forces that were found.
#include <algorithm>
#include <cmath>
#include <utility>

#include "accuracy/element_limit.hpp"
#include "base/error.hpp"
#include "creep/constants.hpp"
#include "creep/creep_elements.hpp"
#include "creep/creep_forces.hpp"
#include "records/wheel_result.hpp"
#include "rolling/constants.hpp"

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

/// Of creepages that no wheel has which rolls: given in other units, or by a motion with some.
void warn_of_creepages(WheelResult& wheel, const CreepRequest& request) {
  for (std::size_t i = 0; i < wheel.patches.size(); ++i) {
    const CreepResult& creep = *wheel.patches[i].creep;
    if (request.motion && (request.time_step > 0.0 || creep.slip_speed < slow_speed)) {
      continue; // near standstill wheels may slide
    }
    const double radius = wheel.rigid_contact.rolling_radius;
    const auto warn = [&](const std::string& text) {
      wheel.warnings.push_back({WarningClass::implausible_input, of_patch(wheel, i) + text});
    };
    for (const auto& [name, value] : {std::pair("longitudinal", creep.creepages.longitudinal),
                                      {"lateral", creep.creepages.lateral}}) {
      if (std::abs(value) > greatest_creepage) {
        warn(std::string(name) + " creepage " + short_text_of(value) + ": a wheel that rolls has " +
             "at most " + text_of(greatest_creepage) + "; 0.001 is one per mille");
      }
    }
    if (std::abs(creep.creepages.spin) * radius > greatest_spin) {
      warn("spin creepage " + short_text_of(creep.creepages.spin) +
           " 1/mm: a wheel that rolls has at most " + short_text_of(greatest_spin / radius) +
           " 1/mm, 3 over its radius");
    }
  }
}

/// Of the linear law, which knows no friction.
void warn_of_linear_law(WheelResult& wheel) {
  for (std::size_t i = 0; i < wheel.patches.size(); ++i) {
    const PatchResult& patch = wheel.patches[i];
    const double force = std::hypot(patch.creep->longitudinal_force, patch.creep->lateral_force);
    const double greatest = patch.creep->friction * patch.normal_force;
    if (force > greatest) {
      wheel.warnings.push_back({WarningClass::model_validity,
                                of_patch(wheel, i) + "solve.creep = linear: the creep force, " +
                                    short_text_of(force) + " N, is more than the " +
                                    short_text_of(greatest) + " N that friction transmits"});
    }
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
  warn_of_creepages(wheel, request);
  if (request.model == CreepModel::linear) {
    warn_of_linear_law(wheel);
  }
}

} // namespace wrc
