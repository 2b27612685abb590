#include "table/table_step.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/reductions.hpp"
#include "results/wheel_state.hpp"
#include "table/constants.hpp"
#include "table/table_nodes.hpp"
#include "table/table_text.hpp"

namespace wrc {
namespace {

using namespace dimensions;

struct Input {
  const char* name;
  double limit; ///< inside, that of the key of the same meaning
  Dimension dimension;
};
/// Not a tuning constant: permitted ranges.
constexpr std::array<Input, 6> positions{{{"x", 1e300, length},
                                          {"y", 1e4, turning_length},
                                          {"z", 2e4, turning_length},
                                          {"roll", 0.2, angle},
                                          {"pitch angle", 1e300, angle},
                                          {"yaw", 0.2, turning_angle}}};
constexpr std::array<Input, 6> velocities{{{"speed", 1e6, length},
                                           {"lateral velocity", 1e6, turning_length},
                                           {"vertical velocity", 1e6, turning_length},
                                           {"roll rate", 1e3, angle},
                                           {"pitch rate", 1e5, angle},
                                           {"yaw rate", 1e3, turning_angle}}};
constexpr std::array<Input, 3> displacements{
    {{"lateral displacement of a rail", 1e4, turning_length},
     {"vertical displacement of a rail", 1e4, turning_length},
     {"roll of a rail", 0.2, angle}}};
constexpr std::array<Input, 3> rail_rates{{{"lateral velocity of a rail", 1e6, turning_length},
                                           {"vertical velocity of a rail", 1e6, turning_length},
                                           {"roll rate of a rail", 1e3, angle}}};

double number_of(double given, const Input& input, const Convention& convention) {
  const double inside = from_caller(given, convention, input.dimension);
  if (!(std::abs(inside) <= input.limit)) {
    const Dimension amount{input.dimension.quantity};
    throw_invalid_argument(input.name, given,
                           "must be at most " + amount_text(input.limit, convention.units, amount) +
                               (convention.units == Units::si ? " (m, s, rad)" : " (mm, s, rad)") +
                               " to both sides");
  }
  return inside;
}

template <std::size_t count>
std::array<double, count> numbers_of(const double* given, const std::array<Input, count>& inputs,
                                     const Convention& convention) {
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = number_of(given[i], inputs[i], convention);
  }
  return numbers;
}

/// Seen in the mirror y -> -y: of positions, velocities, rails. Not a tuning constant.
constexpr std::array<double, 6> signs_of_six{1.0, -1.0, 1.0, -1.0, 1.0, -1.0};
constexpr std::array<double, 3> signs_of_rail{-1.0, 1.0, -1.0};
constexpr std::array<double, table_rate_count> signs_of_columns{
    -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0};

template <std::size_t count>
void turn(std::array<double, count>& numbers, const std::array<double, count>& signs) {
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] *= signs[i];
  }
}

/// A wheel's state in its left-hand frame.
TableState state_of_wheel(const ContactTable& table, const VehicleState& state, bool right,
                          const Convention& convention) {
  TableState result;
  result.position = numbers_of(state.position.data(), positions, convention);
  if (state.velocity) {
    result.velocity = numbers_of(state.velocity->data(), velocities, convention);
  }
  const std::size_t first = right ? 3 : 0;
  if (state.rails) {
    result.rail = numbers_of(state.rails->data() + first, displacements, convention);
  }
  if (state.rail_velocities) {
    result.rail_velocity =
        numbers_of(state.rail_velocities->data() + first, rail_rates, convention);
  }
  result.curvature =
      number_of(state.curvature.value_or(0.0), {"curvature", 1e-3, turning_curvature}, convention);
  result.friction = state.friction ? (*state.friction)[right ? 1 : 0] : table.friction;
  if (!(result.friction >= 0.0 && result.friction <= 10.0)) {
    throw_invalid_argument("friction", result.friction, "must be between 0 and 10");
  }
  if (right) {
    turn(result.position, signs_of_six);
    turn(result.velocity, signs_of_six);
    turn(result.rail, signs_of_rail);
    turn(result.rail_velocity, signs_of_rail);
    result.curvature = -result.curvature;
  }
  return result;
}

/// Back in the track frame.
void turn_contact(TableContact& contact) {
  turn(contact.force, signs_of_six);
  turn(contact.weight_rates, signs_of_columns);
  for (std::size_t row = 0; row < contact.rates.size(); ++row) {
    for (std::size_t column = 0; column < table_rate_count; ++column) {
      contact.rates[row][column] *= signs_of_six[row] * signs_of_columns[column];
    }
  }
}

[[noreturn]] void refuse_place(const ContactTable& table, const TableContact& contact, bool right,
                               Units units) {
  const std::string wheel = right ? "right wheel: " : "left wheel: ";
  const TableRanges& ranges = table.ranges;
  const auto refuse = [&](const char* name, double value, double limit,
                          const Dimension& dimension) {
    throw_invalid_argument(wheel + name, amount_text(value, units, dimension),
                           "the table reaches from " + amount_text(-limit, units, dimension) +
                               " to " + amount_text(limit, units, dimension));
  };
  if (!(std::abs(contact.roll) <= ranges.roll)) {
    refuse("roll against the rail", contact.roll, ranges.roll, angle);
  }
  if (!(std::abs(contact.yaw) <= ranges.yaw)) {
    refuse("yaw against the rail", contact.yaw, ranges.yaw, angle);
  }
  if (!(std::abs(contact.lateral) <= ranges.lateral)) {
    refuse("lateral position against the rail, positive towards the flange", contact.lateral,
           ranges.lateral, length);
  }
  const auto newtons = [&](double depth) {
    return text_of(std::round(ranges.load * std::pow(depth, 1.5))) + " N";
  };
  throw_invalid_argument(wheel + "load, after Hertz", newtons(contact.depth),
                         "the table reaches to " + newtons(1.0) + ", and goes on to " +
                             newtons(largest_depth) + "; the wheelset may be too low");
}

/// The share of the exact solution in a wheel's forces.
double share_of(const TableContact& contact) {
  return contact.inside ? contact.weight : 1.0;
}

[[noreturn]] void refuse_pair(const ContactTable& table, const std::string& found) {
  throw_invalid_argument("scene", found,
                         "the table is of " + table.identity.wheel + " on " + table.identity.rail);
}

/// As far as it can be seen before it is solved.
void check_scene(const ContactTable& table, const Scene& scene) {
  check_scene_of_table(scene);
  const TableIdentity identity = identity_of_table(scene);
  if (identity.wheel != table.identity.wheel || identity.rail != table.identity.rail) {
    refuse_pair(table, identity.wheel + " on " + identity.rail);
  }
  for (std::size_t i = 0; i < identity_keys.size(); ++i) {
    if (identity.numbers[i] == table.identity.numbers[i]) {
      continue;
    }
    const auto told = [&](const TableIdentity& of) {
      return text_of_key(of, i, scene.convention.units);
    };
    throw_invalid_argument(identity_keys[i].name, told(identity),
                           "the table was made with " + told(table.identity));
  }
  if (scene.has_creepages() || scene.creep.value_or(CreepModel::full) != CreepModel::full) {
    throw_invalid_argument("scene", "creepages of its own, or solve.creep",
                           "the exact solution takes the full theory at the step's velocities");
  }
}

/// Profiles of the same name may differ.
void check_profiles(const ContactTable& table, const SceneWheel& wheel) {
  if (checksum_of_profiles(*wheel.details.wheel, *wheel.details.rail) != table.identity.profiles) {
    refuse_pair(table, "profiles of these names whose curves are others than the table's");
  }
}

/// Adds the share of the exact solution to forces and derivatives of a wheel.
void blend(SceneWheel& exact, bool derivatives, TableContact& contact) {
  const double share = share_of(contact);
  const WheelForce total = exact.total.value_or(WheelForce{});
  const std::array<double, 6> forces{total.force.x,  total.force.y,  total.force.z,
                                     total.moment.x, total.moment.y, total.moment.z};
  if (derivatives) {
    const ForceJacobian* jacobian = exact.jacobian();
    RailJacobian by_rail{};
    if (jacobian != nullptr) {
      by_rail = rail_jacobian_of(exact, *jacobian);
    }
    for (std::size_t row = 0; row < forces.size(); ++row) {
      for (std::size_t column = 0; column < table_rate_count; ++column) {
        const double rate = jacobian == nullptr    ? 0.0
                            : column < state_count ? (*jacobian)[row][column]
                                                   : by_rail[row][column - state_count];
        contact.rates[row][column] =
            (1.0 - share) * contact.rates[row][column] + share * rate +
            (forces[row] - contact.force[row]) * contact.weight_rates[column];
      }
    }
  }
  for (std::size_t row = 0; row < forces.size(); ++row) {
    contact.force[row] = (1.0 - share) * contact.force[row] + share * forces[row];
  }
}

WheelForces forces_of(const TableContact& contact, bool derivatives, const Convention& convention) {
  const auto& f = contact.force;
  const WheelForce total{{f[0], f[1], f[2]}, {f[3], f[4], f[5]}};
  if (!derivatives) {
    return forces_to_caller(total, nullptr, nullptr, convention);
  }
  ForceJacobian jacobian;
  RailJacobian by_rail;
  for (std::size_t row = 0; row < f.size(); ++row) {
    for (std::size_t column = 0; column < table_rate_count; ++column) {
      (column < state_count ? jacobian[row][column] : by_rail[row][column - state_count]) =
          contact.rates[row][column];
    }
  }
  return forces_to_caller(total, &jacobian, &by_rail, convention);
}

/// Outputs, blended as the forces; returns flags that the table knows.
int put_outputs(const ContactTable& table, const TableContact& contact, const SceneWheel* exact,
                const Convention& convention, WheelOutputs& outputs, WheelOutputs& errors) {
  const double share = exact != nullptr ? share_of(contact) : 0.0;
  int flags = 0;
  if (contact.inside && !contact.lifted && share < 1.0) {
    outputs = outputs_in_table(table, contact, flags);
    const ErrorMap::Errors of_outputs =
        table.errors.at({contact.lateral, contact.depth}, first_of_outputs);
    for (std::size_t i = 0; i < output_count; ++i) {
      errors[i] =
          (1.0 - share) * of_outputs[first_of_outputs + i] * output_scale(contact, outputs, i);
    }
  }
  if (exact != nullptr) {
    const WheelOutputs found = outputs_of(*exact);
    for (std::size_t i = 0; i < output_count; ++i) {
      outputs[i] = wheel_outputs[i].is_flag ? (share > 0.5 ? found[i] : outputs[i])
                                            : (1.0 - share) * outputs[i] + share * found[i];
    }
  }
  for (std::size_t i = 0; i < output_count; ++i) {
    outputs[i] = to_caller(outputs[i], convention, wheel_outputs[i].dimension);
    errors[i] = to_caller(errors[i], convention, wheel_outputs[i].dimension);
  }
  return flags;
}

} // namespace

std::array<TableContact, 2> contacts_in_table(const ContactTable& table, const VehicleState& state,
                                              const Convention& convention) {
  std::array<TableContact, 2> contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    contacts[i] = contact_in_table(table, state_of_wheel(table, state, i == 1, convention),
                                   state.derivatives);
  }
  turn_contact(contacts[1]);
  return contacts;
}

TableStep step_in_table(const ContactTable& table, const VehicleState& state,
                        const ExactAnswer* exact, bool places) {
  if (state.history) {
    throw_invalid_argument("history", "given", "a table has no steps of time");
  }
  if (exact != nullptr) {
    check_scene(table, exact->scene);
  }
  const Convention& convention = exact != nullptr ? exact->scene.convention : table.convention;
  std::array<TableContact, 2> contacts = contacts_in_table(table, state, convention);
  std::array<bool, 2> asks{};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const bool right = i == 1;
    if (!contacts[i].inside && exact == nullptr) {
      refuse_place(table, contacts[i], right, convention.units);
    }
    asks[i] = exact != nullptr && share_of(contacts[i]) > 0.0;
    double all = sum_of(contacts[i].force.data(), contacts[i].force.size()) +
                 sum_of(contacts[i].errors.data(), contacts[i].errors.size()) +
                 contacts[i].normal_force + contacts[i].wear_number;
    for (const auto& row : contacts[i].rates) {
      all += sum_of(row.data(), row.size());
    }
    if (!std::isfinite(all)) {
      throw Error(ErrorCode::file_malformed,
                  "the table's numbers give no finite force, derivative or error");
    }
  }
  SceneResult result;
  if (asks[0] || asks[1]) {
    VehicleState whole = state;
    whole.velocity = state.velocity.value_or(SixNumbers{});
    whole.rails = state.rails.value_or(SixNumbers{});
    whole.rail_velocities = state.rail_velocities.value_or(SixNumbers{});
    whole.curvature = state.curvature.value_or(0.0);
    whole.friction = state.friction.value_or(std::array{table.friction, table.friction});
    Scene scene = scene_at(exact->scene, whole);
    scene.standstill_speed = table.standstill_speed;
    scene.side = asks[0] && asks[1] ? SideChoice::both
                 : asks[0]          ? SideChoice::left
                                    : SideChoice::right;
    result = exact->solver.solve(scene);
  }
  TableStep step;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::optional<SceneWheel>& wheel = i == 0 ? result.left : result.right;
    int flags = contacts[i].lifted ? lifted : 0;
    flags |= contacts[i].inside && contacts[i].depth > 1.0 && !(asks[i] && wheel) ? beyond_load : 0;
    if (asks[i] && wheel) {
      check_profiles(table, *wheel);
      step.converged = step.converged && wheel->stop_reason == StopReason::tolerance_met;
      blend(*wheel, state.derivatives, contacts[i]);
      const int seen = wheel->state.value_or(0);
      const bool flies = share_of(contacts[i]) == 1.0 || contacts[i].lifted;
      flags = (flies ? seen : seen & ~lifted) | exact_solution;
    }
    step.wheels[i] = forces_of(contacts[i], state.derivatives, convention);
    if (places) {
      flags |= put_outputs(table, contacts[i], asks[i] && wheel ? &*wheel : nullptr, convention,
                           step.outputs[i], step.output_errors[i]);
    }
    step.wheels[i].state = flags;
    const double of_table = asks[i] ? std::max(0.0, 1.0 - share_of(contacts[i])) : 1.0;
    for (std::size_t kind = 0; kind < step.errors[i].size(); ++kind) {
      step.errors[i][kind] = of_table * contacts[i].errors[kind];
    }
  }
  return step;
}

} // namespace wrc
