/// What a table says of a wheel beside its forces, and how a solution has it.
///
/// The flange lobe is what lies where wheel and rail meet at more than `flange_lobe_angle`; the
/// tread lobe is the rest. Angles are positive on the flange, of both wheels. Units mm, N, rad.
/// Thread rule: pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "keys/convention.hpp"
#include "records/wheel_result.hpp"

namespace wrc {

struct OutputKey {
  const char* name;
  Dimension dimension;
  bool is_flag = false; ///< 0 or 1
};
/// In the order of all arrays of outputs; names of results of a wheel where there is one.
inline constexpr std::array<OutputKey, 8> wheel_outputs{
    {{"wear_number", dimensions::force},
     {"centroid.t_rail", dimensions::length},
     {"centroid.s_wheel", dimensions::length},
     {"centroid.angle", dimensions::pure},
     {"centroid.rolling_radius", dimensions::length},
     {"normal_force.tread", dimensions::force},
     {"normal_force.flange", dimensions::force},
     {"on_flange_tip", dimensions::pure, true}}};
constexpr std::size_t output_count = wheel_outputs.size();
using WheelOutputs = std::array<double, output_count>;

/// The numbers that depend on the place alone: in a table a spline each, of a wheel in contact.
enum class PlacePart : std::size_t {
  rail_place,   ///< t of the centre of pressure
  wheel_place,  ///< s likewise
  angle,        ///< of the rail there
  radius,       ///< rolling radius there
  flange_share, ///< of the normal force
  tip,          ///< 1 on the flange tip, else 0
  chamfer,      ///< likewise
  none
};
constexpr std::size_t place_part_count = 8; // not a tuning constant
static_assert(place_part_count == static_cast<std::size_t>(PlacePart::none) + 1);

std::array<double, place_part_count> place_parts_of(const WheelResult& wheel);

/// One after the other, with commas.
std::string names_of_outputs();
/// From numbers of the place, the sum of the normal forces and the frictional work.
WheelOutputs outputs_of(const std::array<double, place_part_count>& place, double normal_force,
                        double wear_number);
/// Of a solution with creep forces from a motion, which has the rows; zeros without contact.
WheelOutputs outputs_of(const WheelResult& wheel);

} // namespace wrc
