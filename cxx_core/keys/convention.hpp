/// The units and frame in which a scene's numbers are given and returned.
///
/// Inside, everything is in mm, N, MPa, rad in the track frame of geometry/frames.hpp (x forward,
/// y left, z up). Outside it may be m, N, Pa, rad, and the frame turned by half a turn about x
/// (x forward, y right, z down), common in vehicle codes: lateral and vertical components of
/// vectors, and of rotations and moments, then change their sign. Angles about x (roll, contact
/// angle) stay, and so does all that is measured along a profile or along a normal.
/// Powers of ten are exact, so that both ways agree to the last rounding.
/// Thread rule: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace wrc {

enum class Units { mm, si };
enum class TrackFrame { left_up, right_down };

struct Convention {
  Units units = Units::mm;
  TrackFrame frame = TrackFrame::left_up;
  bool operator==(const Convention&) const = default;
};

enum class Quantity : std::uint8_t {
  number, ///< the same in all units: counts, ratios, angles, forces, forces per angle, ms
  length,
  area,
  stress,
  moment,   ///< force times length
  stiffness ///< force or angle per length
};

/// What a number is: its quantity, whether it changes its sign with the frame, and the unit in mm,
/// N, MPa.
struct Dimension {
  Quantity quantity = Quantity::number;
  bool turns = false;
  std::string_view unit = "1";
};

/// What keys and results are.
namespace dimensions {
inline constexpr Dimension pure{Quantity::number, false};
inline constexpr Dimension turning{Quantity::number, true};
inline constexpr Dimension angle{Quantity::number, false, "rad"};
inline constexpr Dimension turning_angle{Quantity::number, true, "rad"};
inline constexpr Dimension rate{Quantity::number, false, "rad/s"};
inline constexpr Dimension force{Quantity::number, false, "N"};
inline constexpr Dimension turning_force{Quantity::number, true, "N"};
inline constexpr Dimension force_by_angle{Quantity::number, false, "N/rad"};
inline constexpr Dimension turning_force_by_angle{Quantity::number, true, "N/rad"};
inline constexpr Dimension milliseconds{Quantity::number, false, "ms"};
inline constexpr Dimension length{Quantity::length, false, "mm"};
inline constexpr Dimension turning_length{Quantity::length, true, "mm"};
inline constexpr Dimension turning_length_by_angle{Quantity::length, true, "mm/rad"};
inline constexpr Dimension speed{Quantity::length, false, "mm/s"};
inline constexpr Dimension turning_speed{Quantity::length, true, "mm/s"};
inline constexpr Dimension turning_rate{Quantity::number, true, "rad/s"};
inline constexpr Dimension surface{Quantity::area, false, "mm2"};
inline constexpr Dimension stress{Quantity::stress, false, "MPa"};
inline constexpr Dimension moment{Quantity::moment, false, "N mm"};
inline constexpr Dimension turning_moment{Quantity::moment, true, "N mm"};
inline constexpr Dimension power{Quantity::moment, false, "N mm/s"};
inline constexpr Dimension turning_curvature{Quantity::stiffness, true, "1/mm"};
inline constexpr Dimension stiffness{Quantity::stiffness, false, "N/mm"};
} // namespace dimensions

/// mm, N, MPa per m, N, Pa: inside = outside * scale_of(quantity) / shrink_of(quantity).
constexpr double scale_of(Quantity quantity) {
  switch (quantity) {
  case Quantity::length:
  case Quantity::moment:
    return 1e3;
  case Quantity::area:
    return 1e6;
  default:
    return 1.0;
  }
}

constexpr double shrink_of(Quantity quantity) {
  switch (quantity) {
  case Quantity::stress:
    return 1e6;
  case Quantity::stiffness:
    return 1e3;
  default:
    return 1.0;
  }
}

constexpr double flip_sign(double value, const Convention& convention, const Dimension& dimension) {
  return dimension.turns && convention.frame == TrackFrame::right_down ? 0.0 - value : value;
}

/// From inside to the caller, who gets no zero of negative sign.
constexpr double to_caller(double value, const Convention& convention, const Dimension& dimension) {
  const double in_units = convention.units == Units::si
                              ? value / scale_of(dimension.quantity) * shrink_of(dimension.quantity)
                              : value;
  return flip_sign(in_units, convention, dimension) + 0.0;
}

/// From the caller to inside.
constexpr double from_caller(double value, const Convention& convention,
                             const Dimension& dimension) {
  const double in_units = convention.units == Units::si
                              ? value * scale_of(dimension.quantity) / shrink_of(dimension.quantity)
                              : value;
  return flip_sign(in_units, convention, dimension);
}

/// "N mm/s", in SI units "N m/s": without the prefixes.
inline std::string unit_in(Units units, std::string_view unit) {
  std::string text(unit);
  if (units == Units::si) {
    for (const std::string_view prefixed : {"mm", "MPa"}) {
      for (std::size_t at = text.find(prefixed); at != std::string::npos;
           at = text.find(prefixed)) {
        text.erase(at, 1);
      }
    }
  }
  return text;
}

/// An amount as the caller has it, with its unit: "1.435 m".
inline std::string amount_text(double value, Units units, const Dimension& dimension) {
  const std::string text = text_of(to_caller(value, {units, TrackFrame::left_up}, dimension));
  return dimension.unit == "1" ? text : text + ' ' + unit_in(units, dimension.unit);
}

constexpr std::string_view name_of(Units units) {
  return units == Units::si ? "m, N, Pa, rad" : "mm, N, MPa, rad";
}

constexpr std::string_view name_of(TrackFrame frame) {
  return frame == TrackFrame::right_down ? "x forward, y right, z down" : "x forward, y left, z up";
}

} // namespace wrc
