/// Constants of behaviour of this room: pressures between elements and up to the edge.
///
/// Each with its origin: published (with author) or derived, bound, measured (with what measures
/// it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// Share of an element's p^2 from which on the next one outwards in its row counts in full, so that
/// the element itself does not stand for an end of the row any more.
/// origin: derived: p^2 is linear in the distance from the edge, and the next element is wholly in
/// contact when the edge is two elements away from this one's centre.
inline constexpr double end_share = 0.5;

/// Share of p^2 of its largest neighbour from which on an element counts as having entered the
/// contact, and neighbours across the rows as well.
/// origin: measured (wrc_tradeoff --creep 500): 0.05 meets the accuracy as often; above, valleys
/// between lobes are taken for edges.
inline constexpr double entering_share = 0.1;

/// How much farther out than by the pressures of the outermost elements contact ends, in elements.
/// origin: measured (contact_area_test): areas of ellipses solved with n smooth elements across are
/// too small by 0.05/n without it, with constant ones by 0.1/n; with it by 0.01/n and 0.03/n.
inline constexpr double edge_beyond_pressures = 0.025;

/// V W^2/N of an elliptic contact of width W: contact_scale.hpp.
/// origin: derived: its rows have forces of 1 - (2 y/W)^2.
inline constexpr double variation_of_ellipse = 24.0;

/// Rows of a contact in those that its second differences reach over.
/// origin: measured (wrc_tradeoff): as many as coarse grids have, whose scale tells the error best.
inline constexpr std::size_t rows_of_differences = 8;

/// Of an even pressure about the element's middle, in squared elements.
/// origin: derived.
inline constexpr double variance_of_element = 1.0 / 12.0;

} // namespace wrc
