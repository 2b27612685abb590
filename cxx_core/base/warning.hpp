/// What is found odd in an input or a solution that is given all the same.
///
/// Each warning belongs to one class of the list below; its text has the numbers. Programs
/// distinguish warnings by the names of these classes, and docs/warnings.md shows how each output
/// of the library reports them. A new class needs its name here and a scene in
/// tests/warnings/classes.py. Thread rule: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wrc {

enum class WarningClass : std::uint8_t {
  profile_dimensions, ///< of no wheel or rail: units?
  profile_origin,     ///< counted from elsewhere
  profile_flange,     ///< a wheel without one
  profile_signs,      ///< upside down, or left to right
  profile_tilt,       ///< of a wheel's faces, or against a built-in wheel
  profile_gap,        ///< a hole where wheel and rail touch
  profile_step,       ///< two scans that do not meet
  profile_overlap,    ///< two points at one lateral position
  profile_outliers,
  profile_noise,
  profile_swing,    ///< of the curve through the points
  profile_end,      ///< contact there
  flange_tip,       ///< first touch
  chamfer,          ///< first touch
  no_contact,       ///< at the height prescribed
  no_load,          ///< one so small that it is treated as none
  not_converged,    ///< pressures
  not_settled,      ///< depth, planes or extent of the contact
  rounding,         ///< of positions
  accuracy,         ///< not reached
  element_limit,    ///< of solve.element_limit: the accuracy needs more
  ridge,            ///< of a profile, under the pressures
  grid_edge,        ///< contact reaches it
  patch_turn,       ///< of the rail within a patch
  vertical_angle,   ///< vertical distances at a contact angle
  patch_left_out,   ///< with vertical distances
  close_patches,    ///< almost touch
  model_validity,   ///< of an approximate model
  no_interaction,   ///< of patches, or a part of it is not known
  pressure,         ///< beyond what steel carries
  first_pressing,   ///< steel yields
  creep_accuracy,   ///< not reached
  steady_forces,    ///< where they change along the path
  unlike_materials, ///< of wheel and rail, in creep forces
  torque_exceeded,  ///< friction cannot hold it
  torque_ambiguous, ///< held at two pitch rates
  unused_key,       ///< set, but without effect beside others
  implausible_input ///< a load, motion or inclination that wheels do not have: units?
};

/// Names of the classes, in their order.
inline constexpr std::array<std::string_view, 38> warning_class_names{
    "profile_dimensions", "profile_origin",
    "profile_flange",     "profile_signs",
    "profile_tilt",       "profile_gap",
    "profile_step",       "profile_overlap",
    "profile_outliers",   "profile_noise",
    "profile_swing",      "profile_end",
    "flange_tip",         "chamfer",
    "no_contact",         "no_load",
    "not_converged",      "not_settled",
    "rounding",           "accuracy",
    "element_limit",      "ridge",
    "grid_edge",          "patch_turn",
    "vertical_angle",     "patch_left_out",
    "close_patches",      "model_validity",
    "no_interaction",     "pressure",
    "first_pressing",     "creep_accuracy",
    "steady_forces",      "unlike_materials",
    "torque_exceeded",    "torque_ambiguous",
    "unused_key",         "implausible_input"};
static_assert(static_cast<std::size_t>(WarningClass::implausible_input) + 1 ==
              warning_class_names.size());

constexpr std::string_view name_of(WarningClass kind) {
  return warning_class_names[static_cast<std::size_t>(kind)];
}

struct Warning {
  WarningClass kind;
  std::string text;
  /// Estimated error over the accuracy, of classes that report an error; infinite: not known.
  std::optional<double> excess{};

  bool operator==(const Warning&) const = default;
};

using Warnings = std::vector<Warning>;

} // namespace wrc
