/// Constants of behaviour of this room: pressures between elements and up to the edge.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// Fraction of an element's p^2 above which the next one outwards in its row counts in full, so
/// that the element is no longer the end of the row.
/// origin: derived: p^2 is linear in the distance from the edge, and the next element is wholly in
/// contact when the edge is two elements away from this one's centre.
inline constexpr double end_share = 0.5;

/// Fraction of p^2 of its largest neighbour above which an element counts as having entered the
/// contact; the same for neighbours across the rows.
/// origin: measured (wrc_tradeoff --creep 500): 0.05 meets the accuracy as often; larger values
/// mistake valleys between lobes for edges.
inline constexpr double entering_share = 0.1;

/// How much farther out than by the pressures of the outermost elements contact ends, in elements.
/// origin: measured (contact_area_test): areas of ellipses solved with n smooth elements across are
/// too small by 0.05/n without it, with constant ones by 0.1/n; with it by 0.01/n and 0.03/n.
inline constexpr double edge_beyond_pressures = 0.025;

/// V W^2/N of an elliptic contact of width W: contact_scale.hpp.
/// origin: derived: its rows have forces of 1 - (2 y/W)^2.
inline constexpr double variation_of_ellipse = 24.0;

/// Rows of a contact over which its second differences extend.
/// origin: measured (wrc_tradeoff): the number on coarse grids, whose scale predicts the error
/// best.
inline constexpr std::size_t rows_of_differences = 8;

/// Variance of an even pressure about the element's middle, in squared elements.
/// origin: derived: the integral of x^2 over one element.
inline constexpr double variance_of_element = 1.0 / 12.0;

/// Two crests of the rows' forces are one lobe if the valley between is no deeper below the lesser
/// one than this fraction of it, ...
/// origin: reasoned: as for lobes of penetration (steep_joined_below): rough profiles have many.
inline constexpr double one_lobe_depth = 0.1;

/// ... and two that share nothing if it is deeper than this.
/// origin: reasoned: at half of the lesser crest there are two contacts to see; nearer to the other
/// limit, lobes would exchange their forces within fewer micrometres.
inline constexpr double own_lobe_depth = 0.5;

/// Halvings of the interval in which p^2 of an end is found.
/// origin: derived: 2^-30 of it is left.
inline constexpr int row_end_halvings = 30;

} // namespace wrc
