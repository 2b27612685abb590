#include "scene/vehicle_step.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scene/model_choice.hpp"
#include "scene/number_tables.hpp"
#include "scene/scene_keys.hpp"
#include "wheel/force_jacobian.hpp"

namespace wrc {
namespace {

using namespace dimensions;

/// Of the columns of a Jacobian, those of positions and velocities; none: nothing depends on it.
using Columns = std::array<std::optional<StateVariable>, 6>;
constexpr Columns position_columns{
    std::nullopt,        StateVariable::lateral, StateVariable::vertical,
    StateVariable::roll, std::nullopt,           StateVariable::yaw};
constexpr Columns velocity_columns{
    StateVariable::speed,     StateVariable::lateral_velocity, StateVariable::vertical_velocity,
    StateVariable::roll_rate, StateVariable::pitch_rate,       StateVariable::yaw_rate};

std::array<SixNumbers, 6> derivatives_of(const ForceJacobian& jacobian, const Columns& columns,
                                         const Convention& convention) {
  std::array<SixNumbers, 6> by{};
  for (std::size_t column = 0; column < columns.size(); ++column) {
    for (std::size_t row = 0; columns[column] && row < 6; ++row) {
      const auto variable = static_cast<std::size_t>(*columns[column]);
      const Dimension dimension = number_tables::rate_of(number_tables::jacobian_rows[row],
                                                         number_tables::jacobian_columns[variable]);
      by[column][row] = to_caller(jacobian[row][variable], convention, dimension);
    }
  }
  return by;
}

WheelForces forces_of(WheelResult& wheel, const Convention& convention, bool derivatives) {
  WheelForces result;
  result.state = wheel.state.value_or(0);
  const TotalForce total = wheel.total.value_or(TotalForce{});
  result.force = {to_caller(total.force.x, convention, pure),
                  to_caller(total.force.y, convention, turning_force),
                  to_caller(total.force.z, convention, turning_force),
                  to_caller(total.moment.x, convention, moment),
                  to_caller(total.moment.y, convention, turning_moment),
                  to_caller(total.moment.z, convention, turning_moment)};
  if (const ForceJacobian* jacobian = derivatives ? jacobian_of(wheel) : nullptr) {
    result.by_position = derivatives_of(*jacobian, position_columns, convention);
    result.by_velocity = derivatives_of(*jacobian, velocity_columns, convention);
  }
  return result;
}

PatchSummary summary_of(const PatchResult& patch, const Convention& convention, bool right) {
  const auto told = [&convention](double value, const Dimension& dimension) {
    return to_caller(value, convention, dimension);
  };
  const CreepResult creep = patch.creep ? *patch.creep : CreepResult{};
  const double side = right ? -1.0 : 1.0;
  PatchSummary summary;
  summary.wheel = right ? 1.0 : 0.0;
  summary.x = told(patch.reference.x, length);
  summary.y = told(patch.reference.y, turning_length);
  summary.z = told(patch.reference.z, turning_length);
  summary.normal_x = told(patch.frame.normal.x, pure);
  summary.normal_y = told(side * patch.frame.normal.y, turning_force);
  summary.normal_z = told(patch.frame.normal.z, turning_force);
  summary.contact_angle = told(patch.angle, pure);
  summary.rolling_radius = told(patch.reference.rolling_radius, length);
  summary.s_wheel = told(patch.reference.s_wheel, length);
  summary.normal_force = norm(patch.force);
  summary.longitudinal_creep_force = told(creep.longitudinal_force, force);
  summary.lateral_creep_force = told(creep.lateral_force, turning_force);
  summary.spin_moment = told(creep.spin_moment, turning_moment);
  summary.longitudinal_creepage = told(creep.creepages.longitudinal, pure);
  summary.lateral_creepage = told(creep.creepages.lateral, turning);
  summary.spin_creepage = told(creep.creepages.spin, turning_curvature);
  summary.longitudinal_semi_axis = told(patch.semi_axis_longitudinal, length);
  summary.lateral_semi_axis = told(patch.semi_axis_lateral, length);
  summary.approach = told(patch.approach, length);
  summary.largest_pressure = told(patch.pmax, stress);
  summary.friction_power = told(creep.friction_power, moment);
  summary.pmax = summary.largest_pressure;
  summary.semi_axes_longitudinal = summary.longitudinal_semi_axis;
  summary.semi_axes_lateral = summary.lateral_semi_axis;
  summary.creep_force_longitudinal = summary.longitudinal_creep_force;
  summary.creep_force_lateral = summary.lateral_creep_force;
  summary.creepage_longitudinal = summary.longitudinal_creepage;
  summary.creepage_lateral = summary.lateral_creepage;
  summary.creepage_spin = summary.spin_creepage;
  summary.angle = summary.contact_angle;
  summary.longitudinal_force = told(patch.total_force.x, force);
  summary.lateral_force = told(patch.total_force.y, turning_force);
  summary.vertical_force = told(patch.total_force.z, turning_force);
  summary.pressure_force_x = told(patch.force.x, force);
  summary.pressure_force_y = told(patch.force.y, turning_force);
  summary.pressure_force_z = told(patch.force.z, turning_force);
  summary.coupling_weight = patch.coupling_weight;
  return summary;
}

} // namespace

Scene scene_at(const Scene& scene, const VehicleState& state) {
  if (scene.until != Module::mechanics) {
    throw_invalid_argument("solve.until", scene.until == Module::geometry ? "geometry" : "remesh",
                           "allowed in a step is \"mechanics\"");
  }
  if (const ModelChoice model = choose_model(scene); state.derivatives && model.approximate) {
    throw_invalid_argument("solve.model", model.name,
                           "allowed in a step with derivatives are \"auto\" and \"half-space\"");
  }
  Scene posed = scene;
  const SixNumbers& q = state.position;
  const SixNumbers& v = state.velocity;
  for (const auto& [key, value] : {std::pair("pose.lateral", q[1]),
                                   {"pose.vertical", q[2]},
                                   {"pose.roll", q[3]},
                                   {"pose.yaw", q[5]},
                                   {"motion.speed", v[0]},
                                   {"motion.lateral", v[1]},
                                   {"motion.vertical", v[2]},
                                   {"motion.roll", v[3]},
                                   {"motion.pitch", v[4]},
                                   {"motion.yaw", v[5]}}) {
    set_number(posed, key, value);
  }
  if (state.rails) {
    const std::span<const double> rails(*state.rails);
    set_numbers(posed, "track.left.displacement", rails.first(3));
    set_numbers(posed, "track.right.displacement", rails.last(3));
  }
  posed.derivatives = state.derivatives;
  return posed;
}

std::array<WheelForces, 2> wheel_forces(SceneResult& result, const Convention& convention,
                                        bool derivatives) {
  std::array<WheelForces, 2> forces;
  if (result.left) {
    forces[0] = forces_of(*result.left, convention, derivatives);
  }
  if (result.right) {
    forces[1] = forces_of(*result.right, convention, derivatives);
  }
  return forces;
}

namespace {

struct FoundPatch {
  const WheelResult* wheel;
  const PatchResult* patch;
};

/// In the order of patch_summaries.
std::vector<FoundPatch> ordered_patches(const SceneResult& result) {
  std::vector<FoundPatch> found;
  for (const std::optional<WheelResult>* wheel : {&result.left, &result.right}) {
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    if (*wheel) {
      for (const PatchResult& patch : (*wheel)->patches) {
        found.push_back({&**wheel, &patch});
      }
    }
    std::sort(found.begin() + first, found.end(), [](const auto& one, const auto& other) {
      return one.patch->reference.s_wheel < other.patch->reference.s_wheel;
    });
  }
  return found;
}

} // namespace

std::vector<PatchSummary> patch_summaries(const SceneResult& result, const Convention& convention) {
  std::vector<PatchSummary> summaries;
  for (const FoundPatch& found : ordered_patches(result)) {
    summaries.push_back(summary_of(*found.patch, convention, found.wheel->details.mirror < 0.0));
  }
  return summaries;
}

PatchCreep creep_of(const Scene& scene, const SceneResult& result, std::size_t index,
                    const std::array<double, 3>& creepages, bool derivatives, SceneSolver& solver) {
  const std::vector<FoundPatch> patches = ordered_patches(result);
  if (index >= patches.size()) {
    throw_invalid_argument("patch (counted from 0)", static_cast<double>(index),
                           "the result has " + std::to_string(patches.size()));
  }
  const Convention& convention = scene.convention;
  const auto& columns = number_tables::creep_columns;
  std::array<double, 3> inside{};
  constexpr std::array<Dimension, 3> of_creepages{pure, turning, turning_curvature};
  for (std::size_t i = 0; i < inside.size(); ++i) {
    inside[i] = from_caller(creepages[i], convention, of_creepages[i]);
    if (!(std::abs(inside[i]) <= max_creepage)) {
      throw_invalid_argument("creepages[" + std::to_string(i) + ']', creepages[i],
                             "each is -10 to 10 (spin 1/mm)");
    }
  }
  const FoundPatch& found = patches[index];
  const CreepResult creep = solver.solve_creep(scene, *found.wheel, *found.patch,
                                               {inside[0], inside[1], inside[2]}, derivatives);
  PatchCreep told;
  told.forces = {to_caller(creep.longitudinal_force, convention, pure),
                 to_caller(creep.lateral_force, convention, turning_force),
                 to_caller(creep.spin_moment, convention, turning_moment)};
  for (std::size_t i = 0; creep.derivatives && i < told.by_creepage.size(); ++i) {
    told.by_creepage[i] =
        to_caller(creep.derivatives->by_creepage[i], convention,
                  number_tables::rate_of(number_tables::creep_rows[i / 3], columns[i % 3]));
  }
  return told;
}

} // namespace wrc
