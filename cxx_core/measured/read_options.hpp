/// How a profile file is read.
///
/// Units mm. Thread rule: plain values.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "measured/constants.hpp"
#include "profile/constants.hpp"
#include "profile/profile.hpp"

namespace wrc {

/// Where a wheel's file has lateral 0.
enum class WheelOrigin { by_file, tape, flange_back };

/// In place of a wavelength (a name, not a tuning constant).
inline constexpr double automatic_smoothing = -1.0;

/// Where the points of a file are put.
struct ProfilePlacement {
  /// Of a wheel; `tape` leaves lateral and heights as they are.
  WheelOrigin origin = WheelOrigin::by_file;
  std::optional<double> lateral_shift; ///< of a wheel, mm, to the taping line, instead of `origin`
  /// rad, anticlockwise in (lateral, height) about the taping line or the rail's origin; if set,
  /// replaces the search for a tilt (tilt.hpp).
  std::optional<double> rotation;
  /// A built-in name or file of the same kind; the points are moved and turned to lie on it where
  /// they are not worn (alignment.hpp). Empty: they are not.
  std::string align_to;

  bool operator==(const ProfilePlacement&) const = default;
};

struct ReadOptions : ProfilePlacement {
  std::optional<ProfileKind> kind; ///< wins over what the file says
  /// Mirroring in addition to that of the format; if set, replaces the check of the shape.
  std::optional<bool> mirror_lateral;
  std::optional<bool> mirror_height;
  std::optional<double> scale; ///< mm per unit of the file; if not set, units may be guessed
  /// mm, waves of this length are halved; 0: no smoothing; automatic_smoothing: as the noise of the
  /// points requires. If not set: the same, which strict mode then refuses where there is noise.
  std::optional<double> smoothing_wavelength;
  /// mm; points closer to the one before are dropped, since the rounding of their digits would
  /// dominate the curvature.
  double least_point_distance = 0.01;
  bool strict = false;               ///< corrections that are guesses, and warnings, are errors
  std::optional<double> tape_offset; ///< flange back to taping line, mm; else by the file, or 70
  /// Number of a profile in a slices file (.slcs, .slcw) or a project file of MiniProf, from 1;
  /// 0: the only one, several are refused with a list.
  int slice = 0;
};

} // namespace wrc
