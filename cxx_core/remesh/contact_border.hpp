/// The border of a contact on its grid, and whether a body ends there.
///
/// A body ends in a contact where an element under pressure is beside one whose ray misses wheel or
/// rail. Units mm, MPa. Thread rule: pure functions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

/// An element under pressure, and one beside it without, or whose ray misses a body.
struct BorderPair {
  std::size_t inside = 0;
  std::size_t outside = 0;
  bool is_along = false; ///< in the same row
  bool ends = false;     ///< a body does
};

/// In the order of the elements under pressure. `distance`: undeformed ones, from which approaches
/// may have been subtracted.
std::vector<BorderPair> contact_border(const Grid& grid, std::span<const double> pressure,
                                       std::span<const double> distance);

bool body_ends_in_contact(const Grid& grid, std::span<const double> pressure,
                          std::span<const double> distance);

} // namespace wrc
