/// What the format readers hand to the common part. Internal to the readers.
///
/// Points are in the signs and units of the file; the flags say what the format defines of them.
/// Thread rule: no state.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measured/reader_lines.hpp"
#include "profile/profile.hpp"

namespace wrc::reading {

/// How sure the signs of the points are.
enum class Signs {
  silent, ///< the format says nothing: the shape decides
  usual,  ///< files of this format have them so, but do not say so: the shape may overrule
  stated, ///< the format defines them
};

struct RawProfile {
  std::vector<Position> points;
  std::vector<std::size_t> lines{};   ///< in which the points stand; other length: not known
  std::vector<Position> dropped{};    ///< points that were removed, in the same frame
  std::optional<ProfileKind> kind;    ///< as the content says
  std::string title;                  ///< as the content says, may be empty
  Signs signs = Signs::silent;        ///< of the points, once turned as the next three say
  bool lateral_towards_gauge = false; ///< a rail's lateral is positive to the gauge side
  /// A rail's height is positive downwards; if the shape shows that it is not, the rail was turned
  /// by half a turn and both signs are wrong.
  bool rail_height_down = false;
  bool columns_are_named = false;       ///< which is lateral and which height
  bool unit_is_stated = false;          ///< points are in mm
  bool counts_from_flange_back = false; ///< wheels of this format have lateral 0 there
  std::optional<double> tape_offset;    ///< flange back to taping line, as the file says, mm
};

RawProfile read_columns(std::string_view text, Log& log);
RawProfile read_simpack(std::string_view text, Log& log);
/// `choice` is the number of a profile in a project file, from 1; 0: the only one.
RawProfile read_miniprof(std::string_view text, int choice, Log& log);

/// Adds a point; refuses more than the largest number.
void add_point(RawProfile& raw, const Position& point, std::size_t line, const Log& log);
/// Says how many rows have no number in place of lateral or height.
void note_gaps(const LineCount& gaps, Log& log);
/// Changes all points, the dropped ones too.
template <class Change> void change_points(RawProfile& raw, const Change& change) {
  for (std::vector<Position>* points : {&raw.points, &raw.dropped}) {
    for (Position& point : *points) {
      point = change(point);
    }
  }
}
/// Multiplies their coordinates.
void scale_points(RawProfile& raw, double lateral, double height);

} // namespace wrc::reading
