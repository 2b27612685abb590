/// Constants of behaviour of this room: pressures between elements and up to the edge.
///
/// Each with its origin: derived, source (with author), measured (with what measures it) or
/// reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

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

} // namespace wrc
