/// What the format readers hand to the common part. Internal to the readers.
///
/// Points are in the signs that the format defines, turned to the frame of profile.hpp as far as
/// the format defines them; units mm if the format defines units. Thread rule: no state.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "profile/profile.hpp"
#include "profile/reader_lines.hpp"
#include "profile/segments.hpp"

namespace wrc::reading {

struct RawProfile {
  std::vector<Position> points;
  std::optional<ProfileKind> kind;    ///< as the content says
  std::string title;                  ///< as the content says, may be empty
  bool lateral_towards_gauge = false; ///< the format counts lateral positive to the gauge side
  bool rail_height_down = false;      ///< the format counts a rail's height positive downwards
  bool wheel_height_up = false;       ///< the format counts a wheel's height upwards in the track
};

RawProfile read_columns(std::string_view text, Log& log);
RawProfile read_simpack(std::string_view text, Log& log);
RawProfile read_miniprof(std::string_view text, Log& log);

/// Adds a point; refuses more than the largest number.
void add_point(RawProfile& raw, const Position& point, std::size_t line, const Log& log);
/// Drops points closer than `least` to the one kept before. Returns how many.
std::size_t drop_close_points(std::vector<Position>& points, double least);

} // namespace wrc::reading
