#include "table/contact_table.hpp"

#include <algorithm>
#include <utility>

#include "results/wheel_state.hpp"
#include "table/constants.hpp"

namespace wrc {
namespace {

using Rated = WithRates<table_rate_count>;

/// From 0 to 1 with two continuous derivatives, over the distances before the flange.
template <class Real> Real alignment(const Real& lateral, double flange) {
  const double begin = flange - alignment_begins;
  const double end = flange - alignment_ends;
  if (value_of(lateral) <= begin) {
    return Real(0.0);
  }
  if (value_of(lateral) >= end) {
    return Real(1.0);
  }
  const Real t = (lateral - Real(begin)) / Real(end - begin);
  return t * t * t * (Real(10.0) + t * (Real(6.0) * t - Real(15.0)));
}

template <class Real>
Real shift_of(const ContactTable& table, const Real& roll, const Real& square) {
  using Spline = TensorSpline<2, 1>;
  Spline::Values found;
  table.shift.evaluate({value_of(roll), value_of(square)}, found);
  return part_of(found, 0, std::array<Real, 2>{roll, square});
}

/// Numbers that do or do not carry rates, by the columns.
template <class Real> struct Columns {
  Real variable(double value, std::size_t) const { return value; }
};
template <> struct Columns<Rated> {
  [[nodiscard]] Rated variable(double value, std::size_t column) const {
    return Rated::variable(value, column);
  }
};

/// What velocities and forces are turned by: the rail's roll.
template <class Real> struct Turn {
  Real sine, cosine;
  [[nodiscard]] VectorOf<Real> into_rail(const VectorOf<Real>& v) const {
    return {v.x, cosine * v.y + sine * v.z, cosine * v.z - sine * v.y};
  }
  [[nodiscard]] VectorOf<Real> out_of_rail(const VectorOf<Real>& v) const {
    // Added, not subtracted: GCC 12 fuses the pair otherwise, without derivatives only.
    const Real minus = -sine;
    return {v.x, cosine * v.y + minus * v.z, sine * v.y + cosine * v.z};
  }
};

/// A wheelset against the rail, in the rail's frame.
template <class Real> struct Against {
  Turn<Real> turn;
  VectorOf<Real> centre, axle;
  VectorOf<Real> velocity, turning, rolling; ///< against the rail; `rolling`: of the pitch rate
  Real speed;                                ///< V
  Real curvature;
};

template <class Real>
WRC_VECTOR_BODY Against<Real> against_rail(const ContactTable& table, const TableState& s) {
  using std::cos, std::sin;
  using Vector = VectorOf<Real>;
  const Columns<Real> columns;
  const Real zero(0.0);
  const Real y = columns.variable(s.position[1], 0);
  const Real z = columns.variable(s.position[2], 1);
  const Real roll = columns.variable(s.position[3], 2);
  const Real yaw = columns.variable(s.position[5], 3);
  std::array<Real, 6> v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    v[i] = columns.variable(s.velocity[i], 4 + i);
  }
  const Real rail_roll = columns.variable(s.rail[2], 12);
  const Vector origin{zero, columns.variable(s.rail[0], 10) + Real(table.rail_y),
                      columns.variable(s.rail[1], 11) + Real(table.rail_z)};
  const Vector rail_velocity{zero, columns.variable(s.rail_velocity[0], 13),
                             columns.variable(s.rail_velocity[1], 14)};
  const Vector rail_turning{columns.variable(s.rail_velocity[2], 15), zero, zero};
  const Real kappa(s.curvature);

  Against<Real> result;
  result.turn = {sin(rail_roll), cos(rail_roll)};
  const Vector place{zero, y, z};
  const Vector from_origin = place - origin;
  result.centre =
      result.turn.into_rail(from_origin) + Vector{zero, Real(table.rail_y), Real(table.rail_z)};
  const Real cos_yaw = cos(yaw);
  const Real sin_yaw = sin(yaw);
  const Real cos_roll = cos(roll);
  const Vector axle{-(sin_yaw * cos_roll), cos_yaw * cos_roll, sin(roll)};
  result.axle = result.turn.into_rail(axle);
  result.speed = v[0];
  result.curvature = kappa;
  const Vector rolling = v[4] * axle;
  const Vector turning =
      rolling + v[3] * Vector{cos_yaw, sin_yaw, zero} + Vector{zero, zero, v[5] + kappa * v[0]};
  const Vector velocity = Vector{v[0] * (Real(1.0) - kappa * y), v[1], v[2]} - rail_velocity -
                          cross(rail_turning, from_origin);
  result.rolling = result.turn.into_rail(rolling);
  result.turning = result.turn.into_rail(turning - rail_turning);
  result.velocity = result.turn.into_rail(velocity);
  return result;
}

/// Where that is in the table.
template <class Real> struct PlaceInTable { Real aligned_lateral, roll, yaw, square, depth; };

template <class Real>
WRC_VECTOR_BODY PlaceInTable<Real> place_of(const ContactTable& table,
                                            const Against<Real>& wheelset) {
  using std::atan2, std::sqrt, std::exp;
  const VectorOf<Real>& axle = wheelset.axle;
  const Real cosine = sqrt(axle.x * axle.x + axle.y * axle.y);
  PlaceInTable<Real> place;
  place.roll = atan2(axle.z, cosine);
  place.yaw = atan2(-axle.x, axle.y);
  place.square = place.yaw * place.yaw;
  const Real line(table.taping_line);
  const Real radius(table.radius);
  const Real lateral = wheelset.centre.y + line * (cosine - Real(1.0)) + radius * axle.z;
  const Real height = wheelset.centre.z + line * axle.z - radius * cosine;
  place.aligned_lateral =
      lateral - shift_of(table, place.roll, place.square) * alignment(lateral, table.flange);
  using Spline = TensorSpline<3, 2>;
  Spline::Values found;
  table.touch.evaluate(
      {value_of(place.aligned_lateral), value_of(place.roll), value_of(place.square)}, found);
  const std::array<Real, 3> at{place.aligned_lateral, place.roll, place.square};
  place.depth = (part_of(found, 0, at) - height) * exp(-part_of(found, 1, at));
  return place;
}

void put(double number, std::size_t row, TableContact& to) {
  to.force[row] = number;
}
void put(const Rated& number, std::size_t row, TableContact& to) {
  to.force[row] = number.value;
  to.rates[row] = number.rates;
}

double weight_of(const ErrorMap::Weight& weight, const PlaceInTable<double>&) {
  return weight.value;
}
Rated weight_of(const ErrorMap::Weight& weight, const PlaceInTable<Rated>& place) {
  Rated result(weight.value);
  for (std::size_t i = 0; i < table_rate_count; ++i) {
    result.rates[i] =
        weight.slope[0] * place.aligned_lateral.rates[i] + weight.slope[1] * place.depth.rates[i];
  }
  return result;
}

/// Share of the table: 1 inside, falling to 0 over the last part of each range.
template <class Real>
WRC_VECTOR_BODY Real share_before_border(const TableRanges& ranges,
                                         const PlaceInTable<Real>& place) {
  Real result(1.0);
  const auto fall = [&result](const Real& value, double limit) {
    if (std::abs(value_of(value)) <= (1.0 - border_share) * limit) {
      return;
    }
    if (std::abs(value_of(value)) >= limit) {
      result = Real(0.0);
      return;
    }
    const double scale = (value_of(value) < 0.0 ? -1.0 : 1.0) / (limit * border_share);
    const Real t = Real(scale) * value - Real((1.0 - border_share) / border_share);
    result = result * (Real(1.0) - t * t * (Real(3.0) - Real(2.0) * t));
  };
  fall(place.aligned_lateral, ranges.lateral);
  fall(place.roll, ranges.roll);
  fall(place.yaw, ranges.yaw);
  if (value_of(place.depth) > 0.0) {
    fall(place.depth, 1.0);
  }
  return result;
}

void put_weight(double weight, TableContact& to) {
  to.weight = weight;
}
void put_weight(const Rated& weight, TableContact& to) {
  to.weight = weight.value;
  to.weight_rates = weight.rates;
}

/// Forces, of parts that are read from the table.
template <class Real, class Part>
WRC_VECTOR_BODY void add_up(const ContactTable& table, const Against<Real>& wheelset,
                            const PlaceInTable<Real>& place, double friction, const Part& part,
                            TableContact& to) {
  using std::sqrt, std::sin, std::cos;
  using Vector = VectorOf<Real>;
  const Real zero(0.0);
  const Real p = part(TablePart::load);
  const Real root = sqrt(p);
  const Real load = p * root;
  const Real yaw = place.yaw;
  Vector force{part(TablePart::longitudinal) * yaw, part(TablePart::lateral), Real(1.0)};
  Vector moment{part(TablePart::moment_x), part(TablePart::moment_y) * yaw,
                part(TablePart::moment_z) * yaw};
  force = load * force;
  moment = load * moment;

  const Vector arm{part(TablePart::arm_x) * yaw, part(TablePart::arm_y), part(TablePart::arm_z)};
  const Real angle = part(TablePart::angle);
  const Vector across{zero, cos(angle), sin(angle)};
  const Vector spin{zero, part(TablePart::spin_by_pitch), part(TablePart::spin_by_yaw)};
  const Real reference_speed =
      Real(0.5) * (wheelset.speed * (Real(1.0) - wheelset.curvature * (wheelset.centre.y + arm.y)) -
                   cross(wheelset.rolling, arm).x);
  const double slowest = table.standstill_speed;
  const Real slip_speed = sqrt(reference_speed * reference_speed + Real(slowest * slowest));
  double power = 0.0; // of friction over the speed
  const Real bound = Real(friction) * part(TablePart::normal) * load;
  if (friction >= least_table_friction) {
    const Vector velocity = wheelset.velocity + cross(wheelset.turning, arm);
    const Real share = Real(1.0) / (slip_speed * bound);
    const Real xi = share * velocity.x;
    const Real eta = share * dot(velocity, across);
    const Real phi = share * dot(wheelset.turning, spin);
    const Real direction(value_of(reference_speed) < 0.0 ? -1.0 : 1.0);
    // Rolling backwards is half a turn about the normal.
    const Real fx =
        p * part(TablePart::longitudinal_law) * xi + load * part(TablePart::cross_law) * phi;
    const Real fy = p * part(TablePart::lateral_law) * eta;
    const Real fp = load * part(TablePart::spin_law) * phi;
    const std::array<Real, 3> creep =
        table.law.forces(direction * fx, direction * fy, fp, part(TablePart::log_ratio));
    const Vector tangential = bound * (direction * creep[0] * Vector{Real(1.0), zero, zero} +
                                       direction * creep[1] * across);
    const Real spin_moment = bound * (creep[2] * (part(TablePart::size) * root));
    force = force + tangential;
    moment = moment + cross(arm, tangential) + spin_moment * spin;
    for (const auto& [force_of_slip, slip] :
         {std::pair(value_of(tangential.x), value_of(velocity.x)),
          std::pair(value_of(tangential.y), value_of(velocity.y)),
          std::pair(value_of(tangential.z), value_of(velocity.z)),
          std::pair(value_of(spin_moment), value_of(dot(wheelset.turning, spin)))}) {
      power -= force_of_slip * slip / value_of(slip_speed);
    }
  }
  to.normal_force = value_of(part(TablePart::normal)) * value_of(load);
  to.wear_number = power;
  to.load = std::max(to.load, value_of(load));
  force = wheelset.turn.out_of_rail(force);
  moment = wheelset.turn.out_of_rail(moment);
  const std::array<const Real*, 6> rows{&force.x,  &force.y,  &force.z,
                                        &moment.x, &moment.y, &moment.z};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    put(*rows[i], i, to);
  }
}

template <class Real>
WRC_VECTOR_BODY void find_contact(const ContactTable& table, const TableState& state,
                                  TableContact& to) {
  const Against<Real> wheelset = against_rail<Real>(table, state);
  const PlaceInTable<Real> place = place_of(table, wheelset);
  to.lateral = value_of(place.aligned_lateral);
  to.roll = value_of(place.roll);
  to.yaw = value_of(place.yaw);
  to.depth = value_of(place.depth);
  const TableRanges& ranges = table.ranges;
  to.inside = std::abs(to.lateral) <= ranges.lateral && std::abs(to.roll) <= ranges.roll &&
              std::abs(to.yaw) <= ranges.yaw && to.depth <= largest_depth;
  if (!to.inside) {
    return;
  }
  to.load = least_load_share * table.ranges.load;
  using Spline = TensorSpline<4, table_part_count, float>;
  Spline::Values found;
  table.contact.evaluate({to.lateral, to.roll, value_of(place.square), to.depth}, found);
  to.lifted = !(found.value[static_cast<std::size_t>(TablePart::load)] > 0.0);
  if (!to.lifted) {
    const std::array<Real, 4> at{place.aligned_lateral, place.roll, place.square, place.depth};
    add_up<Real>(
        table, wheelset, place, state.friction,
        [&](TablePart part) { return part_of(found, static_cast<std::size_t>(part), at); }, to);
  }
  const ErrorMap::Place in_map{to.lateral, to.depth};
  to.errors = table.errors.at(in_map, 0, first_of_outputs);
  const double by_friction = error_by_friction(state.friction);
  to.errors[bound_of_force] *= by_friction;
  to.errors[likely_of_force] *= by_friction;
  if (to.depth > -lift_margin) {
    Real of_table = share_before_border(ranges, place);
    if (table.tolerance > 0.0) {
      const auto weight = table.errors.weight_at(in_map, table.tolerance / by_friction);
      of_table = of_table * (Real(1.0) - weight_of(weight, place));
    }
    put_weight(Real(1.0) - of_table, to);
  }
}

WRC_VECTOR_CLONES void find_forces(const ContactTable& table, const TableState& state,
                                   TableContact& to) {
  find_contact<double>(table, state, to);
}

WRC_VECTOR_CLONES void find_rates(const ContactTable& table, const TableState& state,
                                  TableContact& to) {
  find_contact<Rated>(table, state, to);
}

} // namespace

std::size_t ContactTable::bytes() const {
  return sizeof(float) * (contact.coefficients().size() + places.coefficients().size() +
                          law.spline().coefficients().size()) +
         sizeof(double) * (touch.coefficients().size() + shift.coefficients().size()) +
         sizeof(ErrorMap::Errors) * errors.vertices().size();
}

TableContact contact_in_table(const ContactTable& table, const TableState& state,
                              bool derivatives) {
  TableContact result;
  (derivatives ? find_rates : find_forces)(table, state, result);
  return result;
}

double error_by_friction(double friction) {
  return (std::max(friction, least_friction_of_errors) + friction_without_errors) /
         (friction_of_errors + friction_without_errors);
}

double output_scale(const TableContact& contact, const WheelOutputs& outputs, std::size_t output) {
  constexpr std::size_t wear = 0;
  constexpr std::size_t tread = 5;
  constexpr std::size_t flange = 6;
  return output == wear                        ? std::max(outputs[wear], least_wear_number)
         : output == tread || output == flange ? contact.load
                                               : 1.0;
}

WheelOutputs outputs_in_table(const ContactTable& table, const TableContact& contact, int& flags) {
  const auto found = table.places.values(
      {contact.lateral, contact.roll, contact.yaw * contact.yaw, contact.depth});
  const auto is = [&found](PlacePart part) { return found[static_cast<std::size_t>(part)] > 0.5; };
  flags |= is(PlacePart::tip) ? on_flange_tip : 0;
  flags |= is(PlacePart::chamfer) ? on_chamfer : 0;
  return outputs_of(found, contact.normal_force, contact.wear_number);
}

double aligned(const ContactTable& table, double lateral, double roll, double yaw) {
  return lateral - shift_of(table, roll, yaw * yaw) * alignment(lateral, table.flange);
}

double share_of_fit(const ContactTable& table, double aligned_lateral) {
  return table.flange > 0.0 ? 1.0 - alignment(aligned_lateral, table.flange) : 1.0;
}

double from_aligned(const ContactTable& table, double aligned_lateral, double roll, double yaw) {
  const double shift = shift_of(table, roll, yaw * yaw);
  const double reach = std::abs(shift) + 1e-9;
  double low = aligned_lateral - reach;
  double high = aligned_lateral + reach;
  while (true) { // halved down to neighbouring numbers
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) {
      return middle;
    }
    (middle - shift * alignment(middle, table.flange) < aligned_lateral ? low : high) = middle;
  }
}

TablePose pose_of_taping_point(const ContactTable& table, double lateral, double height,
                               double roll) {
  const double cosine = std::cos(roll);
  const double sine = std::sin(roll);
  return {lateral - table.taping_line * (cosine - 1.0) - table.radius * sine,
          height - table.taping_line * sine + table.radius * cosine};
}

} // namespace wrc
