#include "scene/vehicle_step.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "derivatives/rail_jacobian.hpp"
#include "keys/key_warnings.hpp"
#include "keys/scene_keys.hpp"
#include "scene/constants.hpp"
#include "scene/model_choice.hpp"
#include "scene/number_tables.hpp"
#include "scene/patch_summary.hpp"
#include "scene/solve_scene.hpp"

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

/// The wheelset's columns whose dimensions the rail's have.
constexpr std::array rail_columns{StateVariable::lateral, StateVariable::vertical,
                                  StateVariable::roll};
constexpr std::array rail_rate_columns{StateVariable::lateral_velocity,
                                       StateVariable::vertical_velocity, StateVariable::roll_rate};

double entry_to_caller(double value, std::size_t row, StateVariable column,
                       const Convention& convention) {
  return to_caller(
      value, convention,
      number_tables::rate_of(number_tables::jacobian_rows[row],
                             number_tables::jacobian_columns[static_cast<std::size_t>(column)]));
}

/// `first`: the first of the rail's columns.
std::array<SixNumbers, 3> derivatives_of(const RailJacobian& jacobian, std::size_t first,
                                         const std::array<StateVariable, 3>& columns,
                                         const Convention& convention) {
  std::array<SixNumbers, 3> by{};
  for (std::size_t column = 0; column < columns.size(); ++column) {
    for (std::size_t row = 0; row < 6; ++row) {
      by[column][row] =
          entry_to_caller(jacobian[row][first + column], row, columns[column], convention);
    }
  }
  return by;
}

std::array<SixNumbers, 6> derivatives_of(const ForceJacobian& jacobian, const Columns& columns,
                                         const Convention& convention) {
  std::array<SixNumbers, 6> by{};
  for (std::size_t column = 0; column < columns.size(); ++column) {
    for (std::size_t row = 0; columns[column] && row < 6; ++row) {
      by[column][row] = entry_to_caller(jacobian[row][static_cast<std::size_t>(*columns[column])],
                                        row, *columns[column], convention);
    }
  }
  return by;
}

WheelForces forces_of(SceneWheel& wheel, const Convention& convention, bool derivatives) {
  const WheelForce total = wheel.total.value_or(WheelForce{});
  WheelForces result;
  if (const ForceJacobian* jacobian = derivatives ? wheel.jacobian() : nullptr) {
    const RailJacobian by_rail = rail_jacobian_of(wheel, *jacobian);
    result = forces_to_caller(total, jacobian, &by_rail, convention);
  } else {
    result = forces_to_caller(total, nullptr, nullptr, convention);
  }
  result.state = wheel.state.value_or(0);
  return result;
}

} // namespace

WheelForces forces_to_caller(const WheelForce& total, const ForceJacobian* jacobian,
                             const RailJacobian* by_rail, const Convention& convention) {
  WheelForces result;
  result.force = {to_caller(total.force.x, convention, pure),
                  to_caller(total.force.y, convention, turning_force),
                  to_caller(total.force.z, convention, turning_force),
                  to_caller(total.moment.x, convention, moment),
                  to_caller(total.moment.y, convention, turning_moment),
                  to_caller(total.moment.z, convention, turning_moment)};
  if (jacobian != nullptr) {
    result.by_position = derivatives_of(*jacobian, position_columns, convention);
    result.by_velocity = derivatives_of(*jacobian, velocity_columns, convention);
  }
  if (by_rail != nullptr) {
    result.by_rail = derivatives_of(*by_rail, 0, rail_columns, convention);
    result.by_rail_velocity = derivatives_of(*by_rail, 3, rail_rate_columns, convention);
  }
  return result;
}

namespace {

/// Throws unless a step of time can be solved.
void check_history(const Scene& scene, double time_step) {
  if (!(time_step >= least_time_step && time_step <= most_time_step)) {
    throw_invalid_argument("time_step", time_step, "must be between 1e-9 and 1e9 s with a history");
  }
  if (scene.creep.value_or(CreepModel::full) != CreepModel::full) {
    throw_invalid_argument("solve.creep", "an approximate model",
                           "must be \"auto\" or \"full\" with a history");
  }
  if (scene.has_creepages()) {
    throw_invalid_argument("creepages", "given", "with a history they follow from the motion");
  }
  if (scene.pitch_is_free) {
    throw_invalid_argument("motion.pitch", "free", "must be a number with a history");
  }
  if (!is_prismatic(scene)) {
    throw_invalid_argument(
        "history", "given",
        "must be none where a rail or a wheel varies: creep forces are those of steady rolling");
  }
  for (const SceneSide* side : {&scene.left, &scene.right}) {
    if (const double difference = shear_constants_of(scene, *side).difference_parameter;
        difference != 0.0) { // 0 where it has no effect
      throw_invalid_argument("history", "wheel and rail of unlike materials",
                             "the difference parameter of the materials must be 0, not " +
                                 short_text_of(difference));
    }
  }
}

} // namespace

Scene scene_at(const Scene& scene, const VehicleState& state) {
  if (scene.until != Module::mechanics) {
    throw_invalid_argument("solve.until", scene.until == Module::geometry ? "geometry" : "remesh",
                           "must be \"mechanics\" in a step");
  }
  if (const ModelChoice model = choose_model(scene); state.derivatives && model.approximate) {
    throw_invalid_argument("solve.model", model.name,
                           "must be \"auto\" or \"half-space\" in a step with derivatives");
  }
  if (state.derivatives && scene.passes > 1 && !yielding_bodies_of(scene).empty()) {
    throw_invalid_argument("solve.passes", scene.passes,
                           "must be 1 in a step with derivatives of steel that yields, and in an "
                           "equilibrium, which needs them");
  }
  Scene posed = scene;
  const auto set_six = [&posed](const SixNumbers& values, const std::array<const char*, 6>& keys) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (keys[i] != nullptr) {
        set_number(posed, keys[i], values[i]);
      }
    }
  };
  set_six(state.position,
          {nullptr, "pose.lateral", "pose.vertical", "pose.roll", nullptr, "pose.yaw"});
  if (!is_prismatic(posed)) {
    set_number(posed, "pose.longitudinal", state.position[0]);
    set_number(posed, "pose.pitch", state.position[4]);
  }
  if (state.velocity) {
    set_six(*state.velocity, {"motion.speed", "motion.lateral", "motion.vertical", "motion.roll",
                              "motion.pitch", "motion.yaw"});
  }
  const auto set_rails = [&posed](const std::optional<SixNumbers>& values, std::string_view left,
                                  std::string_view right) {
    if (values) {
      const std::span<const double> numbers(*values);
      set_numbers(posed, left, numbers.first(3));
      set_numbers(posed, right, numbers.last(3));
    }
  };
  set_rails(state.rails, "track.left.displacement", "track.right.displacement");
  set_rails(state.rail_velocities, "track.left.velocity", "track.right.velocity");
  if (state.curvature) {
    set_number(posed, "motion.curvature", *state.curvature);
  }
  if (state.friction) {
    set_number(posed, "friction.left", (*state.friction)[0]);
    set_number(posed, "friction.right", (*state.friction)[1]);
  }
  posed.given = scene.given & ~keys_overruled_by_steps();
  posed.derivatives = state.derivatives;
  if (state.history) {
    check_history(posed, state.time_step);
    posed.history = state.history;
    posed.time_step = state.time_step;
  } else if (state.time_step != 0.0) {
    throw_invalid_argument("time_step", state.time_step, "must be 0 without a history");
  }
  return posed;
}

std::shared_ptr<const ContactHistory> history_after(const SceneResult& result) {
  ContactHistory history;
  for (std::size_t i = 0; i < history.wheels.size(); ++i) {
    if (const auto& wheel = i == 0 ? result.left : result.right) {
      history.wheels[i] = history_of(*wheel);
    }
  }
  return std::make_shared<const ContactHistory>(std::move(history));
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

void add_varying_columns(const Scene& posed, SceneSolver& solver,
                         std::array<WheelForces, 2>& forces) {
  struct Column {
    bool is_constant;
    double Scene::*place;
    std::size_t index; ///< of positions
    double step;
    double step_of_caller;
  };
  const double along = to_caller(track_difference_step, posed.convention, length);
  const double turn = track_difference_step / posed.nominal_radius();
  for (const Column& column :
       {Column{has_prismatic_rails(posed), &Scene::along, 0, track_difference_step, along},
        Column{has_round_wheels(posed), &Scene::pitch, 4, turn, turn}}) {
    if (column.is_constant) {
      continue;
    }
    Scene moved = posed;
    moved.derivatives = false;
    std::array<std::array<WheelForces, 2>, 2> found{forces, forces}; // behind and ahead
    double steps = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      moved.*column.place = posed.*column.place + (i == 0 ? -column.step : column.step);
      try {
        SceneResult result = solver.solve(moved);
        found[i] = wheel_forces(result, posed.convention, false);
        steps += 1.0;
      } catch (const Error& error) {
        if (error.code() != ErrorCode::no_contact) { // beyond the last slice: from one side
          throw;
        }
      }
    }
    for (std::size_t wheel = 0; wheel < forces.size(); ++wheel) {
      for (std::size_t row = 0; row < 6; ++row) {
        forces[wheel].by_position[column.index][row] =
            steps > 0.0 ? (found[1][wheel].force[row] - found[0][wheel].force[row]) /
                              (steps * column.step_of_caller)
                        : 0.0;
      }
    }
  }
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
                             "must be between -10 and 10 (spin 1/mm)");
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
