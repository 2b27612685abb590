/// Cleaning of a profile's points, step by step; each step says what it did.
///
/// Closed outlines are opened, points that coincide with the previous one and single points far off
/// the line of their neighbours are removed, and what lies too deep for a running surface (web and
/// foot of a rail, the inside of a rim) is cut off the ends. What was removed is kept for pictures.
/// Units mm. Thread rule: no state.
#pragma once

#include "measured/reader_formats.hpp"

namespace wrc::reading {

/// Puts points in the order of a line, each the nearest one to that before, where this leaves out
/// most of the long ways between them: of scans one behind the other, and of an overhang sorted by
/// lateral.
void order_points(RawProfile& raw, Log& log);

/// Opens an outline whose end meets its begin: at its longest side, or that of a whole rail at its
/// foot. Refuses other closed outlines, whose running surface cannot be determined.
void open_outline(RawProfile& raw, std::optional<ProfileKind> kind, Log& log);

/// Removes points closer than `least` to the previous one, and single points off the line.
void remove_doubles(RawProfile& raw, double least, Log& log);
void remove_outliers(RawProfile& raw, Log& log);

/// Cuts what lies deep off both ends. Heights point up.
void cut_ends(RawProfile& raw, ProfileKind kind, Log& log);

} // namespace wrc::reading
