/// Contact forces of a wheel from a table, with their derivatives and their error.
///
/// Normal contact is a spline of four variables: u', the lateral position of the wheel's taping
/// point moved along with the start of the flange; the rail's roll against the wheelset; the square
/// of the yaw; and s, the depth below a smooth first touch over the depth at the largest load.
/// Creep forces are those of an ellipse with the patch's linear forces (creep_law.hpp), at the
/// creepages that fit the slip of all patches, weighted with pressures. Contact that depends on
/// nothing else is taken in the rail's frame, so rails may move and turn. With p = Fz^(2/3)
/// continued below 0 above first touch and cut there, forces and first derivatives are continuous
/// where a wheel lifts.
///
/// Left-hand frame of the side; the right wheel is the mirror image, to the last bit. Units mm, s,
/// N, rad. Thread rule: plain values; `contact_in_table` is pure and allocates nothing.
///
/// Not known here: friction that falls with slip or depends on the position; flags of flange,
/// chamfer and yield; what turns the tractions of one lobe out of the direction of the mean slip.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/value_with_rates.hpp"
#include "geometry/frames.hpp"
#include "keys/convention.hpp"
#include "records/motion.hpp"
#include "table/creep_law.hpp"
#include "table/error_map.hpp"
#include "table/tensor_spline.hpp"
#include "table/wheel_outputs.hpp"

namespace wrc {

/// The parts of the spline of contact.
enum class TablePart : std::size_t {
  load,             ///< p = Fz^(2/3)
  lateral,          ///< Fy over Fz
  longitudinal,     ///< Fx over Fz and yaw
  moment_x,         ///< of the pressures about the wheelset's centre, over Fz
  moment_y,         ///< likewise, and over yaw
  moment_z,         ///< likewise
  normal,           ///< sum of the patches' forces over Fz
  arm_x,            ///< from the centre to the point whose velocity makes creepages, over yaw
  arm_y,            ///< likewise
  arm_z,            ///< likewise
  angle,            ///< of the plane of the lateral creepage
  spin_by_pitch,    ///< spin over the turning about y
  spin_by_yaw,      ///< spin over the turning about z
  longitudinal_law, ///< linear force of a unit xi over p
  lateral_law,      ///< of a unit eta over p
  spin_law,         ///< lateral force of a unit spin over p^(3/2)
  cross_law,        ///< longitudinal force of a unit spin over p^(3/2)
  log_ratio,        ///< ln(a/b)
  size,             ///< (a b)^(1/2) over p^(1/2)
  none
};
constexpr std::size_t table_part_count = 20; // not a tuning constant
static_assert(table_part_count == static_cast<std::size_t>(TablePart::none) + 1);

/// What a table is of. Lengths mm, moduli MPa.
struct TableIdentity {
  std::string wheel, rail; ///< names of the profiles
  /// Radius, back to back, taping line, gauge, its height, inclination, E and nu of wheel and rail,
  /// the method, and the joining distance of patches (identity_keys).
  std::array<double, 12> numbers{};
  std::uint64_t profiles = 0; ///< checksum of the curves
  bool operator==(const TableIdentity&) const = default;
};

/// Keys of `numbers`.
struct IdentityKey {
  const char* name;
  Dimension dimension;
};
inline constexpr std::array<IdentityKey, 12> identity_keys{
    {{"wheelset.radius", dimensions::length},
     {"wheelset.back_to_back", dimensions::length},
     {"wheelset.tape_offset", dimensions::length},
     {"track.gauge", dimensions::length},
     {"track.gauge_height", dimensions::length},
     {"track.inclination", dimensions::angle},
     {"material.wheel.youngs_modulus", dimensions::stress},
     {"material.wheel.poisson", dimensions::pure},
     {"material.rail.youngs_modulus", dimensions::stress},
     {"material.rail.poisson", dimensions::pure},
     {"solve.method", dimensions::pure},
     {"solve.joining_distance", dimensions::length}}};

/// What a file names as its variables; a table of others is no table of this library.
inline constexpr const char* axes_of_tables =
    "lateral, roll, yaw^2, depth; velocities and friction by a law of creep forces";

/// How far a table reaches: from minus each to each, and loads up to the largest.
struct TableRanges {
  double lateral = 10.0;
  double roll = 0.010;
  double yaw = 0.020;
  double load = 150000.0;
};

/// What held-out random states say of a table: errors of the force over the load of the wheel, or
/// over half the largest load if that is more.
struct TableErrors {
  std::uint64_t states = 0;
  std::uint64_t beyond = 0; ///< those that err by more than the error returned with them
  double median = 0.0;
  double percentile_99 = 0.0;
  double worst = 0.0;
  std::uint64_t map_states = 0;    ///< from which the map was made, and ...
  double factor = 1.0;             ///< ... by which its bound was multiplied
  std::uint64_t beyond_likely = 0; ///< of `states`, those beyond the likely error
  double likely_factor = 1.0;      ///< by which that was multiplied
  double derivatives_median = 0.0; ///< of the map's likely errors of derivatives

  /// Fraction of all states that err by more, at most, with 95 % certainty: the bound of a Poisson
  /// distribution's mean, to 3 %.
  [[nodiscard]] double beyond_at_most() const {
    const auto count = static_cast<double>(beyond);
    return (count + 1.645 * std::sqrt(count + 1.0) + 1.5) / static_cast<double>(states);
  }
};

struct ContactTable {
  TableIdentity identity;
  std::string version;   ///< of the library that made it
  Convention convention; ///< of positions and forces outside
  TableRanges ranges;
  double taping_line = 0.0; ///< of the wheel, from the wheelset's centre
  double radius = 0.0;
  double rail_y = 0.0; ///< origin of the rail's profile, where it is not displaced
  double rail_z = 0.0;
  double friction = 0.3; ///< unless a state says otherwise
  double standstill_speed = 1.0;
  /// Where the flange begins, at rest; the shift of it by roll and yaw^2.
  double flange = 0.0;
  TensorSpline<2, 1> shift;
  /// First touch and the logarithm of the depth at the largest load, by u', roll, yaw^2.
  TensorSpline<3, 2> touch;
  TensorSpline<4, table_part_count, float> contact; ///< by u', roll, yaw^2, s
  TensorSpline<4, place_part_count, float> places;  ///< likewise: of the outputs
  CreepLaw law;
  ErrorMap errors; ///< by u', s; of forces at `friction_of_errors`
  TableErrors measured;
  double tolerance = 0.0; ///< beyond which the exact solution is asked; 0: never

  [[nodiscard]] std::size_t bytes() const;
};

/// Positions and velocities as in VehicleState; those of the rail as RailDisplacement.
struct TableState {
  std::array<double, 6> position{};
  std::array<double, 6> velocity{};
  std::array<double, 3> rail{};
  std::array<double, 3> rail_velocity{};
  double curvature = 0.0;
  double friction = 0.3;
};

/// The columns of derivatives: lateral, vertical, roll, yaw, the six velocities, the rail's three
/// and their three rates.
constexpr std::size_t table_rate_count = 16; // not a tuning constant

struct TableContact {
  std::array<double, 6> force{}; ///< and moment about the wheelset's centre
  std::array<std::array<double, table_rate_count>, 6> rates{};
  bool lifted = false;
  double lateral = 0.0; ///< u', by which it is in the table or not, and the others
  double roll = 0.0;
  double yaw = 0.0;
  double depth = 0.0; ///< s
  bool inside = true;
  ErrorMap::Errors
      errors{};      ///< at this friction: of the force over the load as in TableErrors, ...
  double load = 0.0; ///< ... the load, or part of the largest if that is more
  double normal_force = 0.0; ///< sum of the patches'
  double wear_number = 0.0;  ///< frictional work over the distance
  double weight = 0.0;       ///< of the exact solution, with its derivatives ...
  std::array<double, table_rate_count> weight_rates{}; ///< ... by the columns
};

TableContact contact_in_table(const ContactTable& table, const TableState& state, bool derivatives);

/// What forces err by at a friction, over what they do at that of the map.
double error_by_friction(double friction);
/// What the error of an output is over.
double output_scale(const TableContact& contact, const WheelOutputs& outputs, std::size_t output);
/// What a wheel has beside its forces, where its contact was found and is not lifted; adds its
/// flags.
WheelOutputs outputs_in_table(const ContactTable& table, const TableContact& contact, int& flags);

/// From u to u', and back.
double aligned(const ContactTable& table, double lateral, double roll, double yaw);
/// Share of the fit to slopes of the full theory at u': 1 on the tread, 0 where u' follows the
/// flange.
double share_of_fit(const ContactTable& table, double aligned_lateral);
double from_aligned(const ContactTable& table, double aligned_lateral, double roll, double yaw);
/// The pose of the wheelset at u, the height w of the taping point, and this roll.
struct TablePose {
  double lateral, vertical;
};
TablePose pose_of_taping_point(const ContactTable& table, double lateral, double height,
                               double roll);

} // namespace wrc
