#include "scene/vehicle_step.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scene/model_choice.hpp"
#include "scene/number_tables.hpp"
#include "scene/patch_summary.hpp"
#include "scene/scene_keys.hpp"

namespace wrc {
namespace {

using namespace dimensions;

/// The columns of a Jacobian that belong to positions and velocities; none: nothing depends on it.
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

WheelForces forces_of(SceneWheel& wheel, const Convention& convention, bool derivatives) {
  WheelForces result;
  result.state = wheel.state.value_or(0);
  const WheelForce total = wheel.total.value_or(WheelForce{});
  result.force = {to_caller(total.force.x, convention, pure),
                  to_caller(total.force.y, convention, turning_force),
                  to_caller(total.force.z, convention, turning_force),
                  to_caller(total.moment.x, convention, moment),
                  to_caller(total.moment.y, convention, turning_moment),
                  to_caller(total.moment.z, convention, turning_moment)};
  if (const ForceJacobian* jacobian = derivatives ? wheel.jacobian() : nullptr) {
    result.by_position = derivatives_of(*jacobian, position_columns, convention);
    result.by_velocity = derivatives_of(*jacobian, velocity_columns, convention);
  }
  return result;
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
  PatchCreep converted;
  converted.forces = {to_caller(creep.longitudinal_force, convention, pure),
                      to_caller(creep.lateral_force, convention, turning_force),
                      to_caller(creep.spin_moment, convention, turning_moment)};
  for (std::size_t i = 0; creep.derivatives && i < converted.by_creepage.size(); ++i) {
    converted.by_creepage[i] =
        to_caller(creep.derivatives->by_creepage[i], convention,
                  number_tables::rate_of(number_tables::creep_rows[i / 3], columns[i % 3]));
  }
  return converted;
}

} // namespace wrc
