/// Bounds on profiles that are read or written, and on lists of slices.
///
/// Units mm. Thread rule: constants.
#pragma once

#include <cstddef>

#include "profile/limits.hpp"

namespace wrc {

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
