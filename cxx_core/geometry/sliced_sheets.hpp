/// The connected surfaces of a profile that varies: where parts begin and end along the track.
///
/// Features cut each slice into parts. A part is there in slices that have the features on both of
/// its sides; a sheet is the largest rectangle of neighbouring parts that are there in the same run
/// of neighbouring slices, from the first to the last of them. Sheets that share a feature meet
/// along it at each slice; between slices their splines along differ, most of all near the begin
/// of the shorter one. A part in a single slice has no extent along and no sheet.
/// Not covered: a part of a wheel that goes on from the last slice to the first, which becomes two.
/// Without features (fewer than two) a profile is one sheet, and places at the same share of the
/// lengths of slices correspond; slice_matching.hpp finds features where that is wrong.
/// Units mm, along mm or rad. Thread rule: no state.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/surface_sheet.hpp"
#include "profile/sliced_profile.hpp"

namespace wrc {

/// Parts and slices by their first and last index, from 0.
struct SheetExtent {
  std::size_t first_part = 0;
  std::size_t last_part = 0;
  std::size_t first_slice = 0;
  std::size_t last_slice = 0;
};

/// All sheets, by their parts, then slices; a wheel's list of one slice has one too.
std::vector<SheetExtent> sheet_extents(const SlicedProfile& profile);

/// Smoothing length along in the unit of places: that given, else 0 of a list through its slices,
/// and of a smoothed one four times the median distance of slices.
double smoothing_length_of(const SlicedProfile& profile, std::optional<double> given);

/// In what unit messages give lengths along.
struct AlongUnit {
  std::string_view name = "mm";
  double of_place = 1.0; ///< units in that of the places: the radius for mm around a wheel
};

/// The sheets; `period` 0 or that of a wheel, which closes sheets through all slices. Throws
/// Error(invalid_argument) as SurfaceSheet does, and for a profile without a sheet.
std::vector<SurfaceSheet> sheets_of(const SlicedProfile& profile, double smoothing_length,
                                    double period, const AlongUnit& unit = {});

} // namespace wrc
