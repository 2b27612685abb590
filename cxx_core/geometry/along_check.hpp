/// Checks a varying surface for swings between its slices.
///
/// A cubic spline along swings beside steps and kinks: between two slices the surface is then above
/// both of them, or below both. A crest between two slices is above both as well; with second
/// differences c, c' of the heights at both slices, the parabola of the smaller one explains
/// min(|c|, |c'|) h^2 / 8 of it over the distance h, if they have one sign. The rest is a swing.
/// Slopes beyond 1:5 are steeper than the search for contacts looks for (varying_search.hpp).
/// Heights are compared along lines of constant lateral place, at all slices and at quarters of the
/// intervals between knots; both counted normal to the section, heights z_x / sqrt(1 + z_y^2).
/// Cost: 10 us a place. Units mm, places mm or rad. Not covered: sections steeper than 2:1,
/// overhangs, lines within 0.1 mm of an edge, harmonics of wheels. Thread rule: pure functions.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "geometry/sliced_sheets.hpp"

namespace wrc {

/// The farthest from both slices, or the highest rise of a steep place.
struct AlongFault {
  double size = 0.0;          ///< mm, of a swing > 0: above both slices
  double place = 0.0;         ///< where it is largest
  double length = 0.0;        ///< of a rise, mm
  std::size_t slice = 0;      ///< the one before it, from 1
  std::size_t slice_next = 0; ///< the one after it
  std::size_t intervals = 0;  ///< of swings, those beyond the limit
};

struct AlongCheck {
  AlongFault swing;
  AlongFault rise;
};

AlongCheck check_along(const SlicedProfile& profile, std::span<const SurfaceSheet> sheets,
                       const AlongUnit& unit = {});

/// Of swings and rises beyond the limits.
Warnings warnings_of(const AlongCheck& check, ProfileKind kind);
/// A line of a report: how far the surface is above or below both slices at most.
std::string swing_text(const AlongCheck& check);

} // namespace wrc
