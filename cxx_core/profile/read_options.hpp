/// How a profile file is read: options, and bounds on what is read.
///
/// Units mm. Thread rule: plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "profile/profile.hpp"

namespace wrc {

enum class ProfileFormat { columns, simpack, miniprof, slices };

/// Where a wheel's file has lateral 0.
enum class WheelOrigin { by_file, tape, flange_back };

/// In place of a wavelength (a name, not a tuning constant).
inline constexpr double automatic_smoothing = -1.0;

/// Where the points of a file are put.
struct ProfilePlacement {
  /// Of a wheel; `tape` leaves lateral and heights as they are.
  WheelOrigin origin = WheelOrigin::by_file;
  double lateral_shift = 0.0; ///< of a wheel, mm, to the taping line, instead of `origin`; 0: none
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

/// Bounds on what is read.
struct ReadLimits {
  static constexpr std::size_t file_bytes = std::size_t{64} << 20;
  static constexpr std::size_t line_bytes = 4096;
  static constexpr std::size_t min_points = 5;
  static constexpr std::size_t max_points = 200000;
  static constexpr double min_length = 5.0;        ///< mm, total chord length
  static constexpr double max_length = 500.0;      ///< mm
  static constexpr double max_coordinate = 1e5;    ///< mm
  static constexpr double min_tape_offset = 20.0;  ///< mm
  static constexpr double max_tape_offset = 120.0; ///< mm
  static constexpr double max_rotation = 0.5;      ///< rad
};

/// Bounds on lists of slices.
struct SliceLimits {
  static constexpr std::size_t max_slices = 4999; ///< as in CONTACT
  static constexpr std::size_t max_features = 200;
  static constexpr std::size_t max_sheets = 1000;
  static constexpr std::size_t sheet_bytes = std::size_t{400} << 20;    ///< of all sheets
  static constexpr std::size_t file_bytes = 4 * ReadLimits::file_bytes; ///< of all slices
  static constexpr std::size_t max_points = 2000000;                    ///< of all slices
  static constexpr double max_place = 1e9;                              ///< mm
};

} // namespace wrc
