#include "derivatives/steady_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "creep/creep_forces.hpp"
#include "creep/rolling_frame.hpp"
#include "derivatives/constants.hpp"
#include "derivatives/force_jacobian.hpp"
#include "derivatives/rail_jacobian.hpp"
#include "records/wheel_result.hpp"

namespace wrc {
namespace {

using State = std::array<double, state_count>;
/// Longitudinal and lateral, left-hand frame.
using Force = std::array<double, 2>;

/// Rates of positions and velocities, of the wheel against its rail, left-hand frame of the side.
State state_rates(const WheelDetails& details, const WheelRates& rates) {
  const WheelsetMotion& wheelset = *details.motion;
  const Motion& motion = wheelset.motion;
  const RailDisplacement& rail = wheelset.rail_velocity;
  const RailDisplacement& slope = wheelset.rail_slope;
  State state{motion.lateral, motion.vertical, motion.roll, motion.yaw};
  std::copy(motion.acceleration.begin(), motion.acceleration.end(), state.begin() + position_count);
  const auto opposite = opposite_motions(details);
  const std::array<double, 3> of_rail{rail.lateral + motion.speed * slope.lateral,
                                      rail.height + motion.speed * slope.height,
                                      rail.roll + motion.speed * slope.roll};
  for (std::size_t motion_of_rail = 0; motion_of_rail < of_rail.size(); ++motion_of_rail) {
    for (std::size_t i = 0; i < state_count; ++i) {
      state[i] += of_rail[motion_of_rail] * opposite[motion_of_rail][i];
    }
  }
  if (details.load) { // the height follows
    double& vertical = state[static_cast<std::size_t>(StateVariable::vertical)];
    vertical = 0.0;
    if (const auto& at_load = rates.at_load) {
      const auto rate = [&state](StateVariable position) {
        return state[static_cast<std::size_t>(position)];
      };
      vertical = details.mirror * (at_load->lateral.vertical * rate(StateVariable::lateral) +
                                   at_load->roll.vertical * rate(StateVariable::roll) +
                                   at_load->yaw.vertical * rate(StateVariable::yaw));
    }
  }
  return state;
}

Force force_of(const CreepResult& creep, double mirror) {
  return {creep.longitudinal_force, mirror * creep.lateral_force};
}

/// The force of the patch at the same place a little behind; none of one that was not there yet.
Force force_behind(const PatchResult& patch, const WheelResult& behind) {
  Force force{};
  double nearest = patch.semi_axis_lateral;
  for (const PatchResult* other : solved_patches(behind)) {
    const double apart = std::hypot(other->frame.origin.y - patch.frame.origin.y,
                                    other->frame.origin.z - patch.frame.origin.z);
    if (other->creep && apart <= nearest) {
      nearest = apart;
      force = force_of(*other->creep, behind.details.mirror);
    }
  }
  return force;
}

void find_steady_error(PatchResult& patch, const std::array<RatedByState, 4>& forces,
                       const WheelDetails& details, const State& rates,
                       const std::optional<WheelBehind>& behind) {
  Force along_path{};
  if (behind) {
    const Force now = force_of(*patch.creep, details.mirror);
    const Force before = force_behind(patch, behind->wheel);
    for (std::size_t i = 0; i < now.size(); ++i) {
      along_path[i] = (now[i] - before[i]) / behind->distance;
    }
  }
  const double speed = std::abs(details.motion->motion.speed);
  Force by_velocities{};
  for (std::size_t i = 0; i < along_path.size(); ++i) {
    for (std::size_t k = 0; k < state_count; ++k) {
      const double change = forces[i].rates[k] * rates[k] / speed;
      along_path[i] += change;
      by_velocities[i] += k < position_count ? 0.0 : change;
    }
  }
  patch.creep->steady_error = steady_error(
      2.0 * patch.semi_axis_longitudinal, std::hypot(along_path[0], along_path[1]),
      std::hypot(by_velocities[0], by_velocities[1]), patch.creep->friction * patch.normal_force);
}

/// Whether creep forces are those of steady rolling, of a wheel that is known to roll: not at
/// standstill.
bool is_steady(const WheelResult& wheel) {
  if (!wheel.details.motion || !(std::abs(wheel.details.motion->motion.speed) >
                                 wheel.details.motion->motion.standstill_speed)) {
    return false;
  }
  return std::ranges::all_of(solved_patches(wheel), [](const PatchResult* patch) {
    return !(patch->normal_force > 0.0) ||
           (patch->creep && patch->creep->derivatives && patch->creep->displacement_x.empty());
  });
}

/// By the shares of the load; what carries none does not count.
template <class Patches> std::optional<double> mean_of(const Patches& patches) {
  double sum = 0.0;
  double force = 0.0;
  for (const PatchResult& patch : patches) {
    if (patch.normal_force > 0.0) {
      if (!patch.creep || !patch.creep->steady_error) {
        return std::nullopt;
      }
      sum += patch.normal_force * *patch.creep->steady_error;
      force += patch.normal_force;
    }
  }
  return force > 0.0 ? std::optional(sum / force) : std::nullopt;
}

} // namespace

double steady_error(double contact_length, double rate, double by_velocities, double bound) {
  if (!(bound > 0.0)) {
    return 0.0;
  }
  const double per_rate = steady_error_by_rate * contact_length / bound;
  return std::max(std::min(per_rate * rate, most_steady_error),
                  std::min(per_rate * by_velocities, most_difference));
}

void find_steady_errors(WheelResult& wheel, const WheelRates& rates,
                        const std::optional<WheelBehind>& behind) {
  if (!is_steady(wheel)) {
    return;
  }
  const State of_state = state_rates(wheel.details, rates);
  std::size_t index = 0; // as solved_patches
  const auto find = [&](PatchResult& patch) {
    const std::size_t of_rates = index++;
    if (patch.creep && patch.creep->derivatives) {
      find_steady_error(patch, rated_creep_forces(wheel, patch, rates.patches[of_rates]),
                        wheel.details, of_state, behind);
    }
  };
  for (PatchResult& patch : wheel.patches) {
    if (patch.parts.empty()) {
      find(patch);
      continue;
    }
    std::ranges::for_each(patch.parts, find);
    if (patch.creep) {
      patch.creep->steady_error = mean_of(patch.parts);
    }
  }
}

std::optional<double> steady_error_of(const WheelResult& wheel) {
  return mean_of(wheel.patches);
}

void warn_of_steady_forces(WheelResult& wheel, double accuracy) {
  const std::optional<double> error = steady_error_of(wheel);
  if (!error) {
    return;
  }
  const double of_elements = error_of_creep_forces(wheel);
  const double excess = std::hypot(*error, of_elements) / accuracy;
  for (Warning& warning : wheel.warnings) {
    if (warning.kind == WarningClass::creep_accuracy) {
      warning.excess = excess;
    }
  }
  if (*error > accuracy || (excess > 1.0 && !(of_elements > accuracy))) {
    wheel.warnings.push_back({WarningClass::steady_forces,
                              "creep forces change within a few contact lengths of the path: "
                              "estimated error of steady rolling " +
                                  short_text_of(*error) +
                                  " of friction times load, with that of elements more than "
                                  "solve.accuracy = " +
                                  text_of(accuracy),
                              excess});
  }
}

} // namespace wrc
