/// How wide and how long a contact is to the elements that are to resolve it.
///
/// Across the rail, by its crests: a sum over rows of height h has an error of at most h^2/8 times
/// the total variation V of the slope of its summands, here the force per width, so that rows over
/// those of an ellipse of the same force N go with
///   sqrt(24 N / V),
/// which is the width of that ellipse: its rows have forces of 1 - (2 y/W)^2. Two lobes side by
/// side, each half as wide as both together, count as half as wide.
/// Along it, by its lines: five times the variance of the pressures about the middle of their row
/// is the squared semi-axis of an ellipse (Hertz).
/// Lines that are staggered, as in a contact with yaw, are shorter than the contact. Across the
/// rail it is narrower by the same ratio, as an oblique ellipse is on the lines through it in both
/// directions, compared with its extents.
///
/// Both are continuous functions of the rows. Units mm. Thread rule: a pure function. Not
/// known here: crests narrower than a row.
#pragma once

#include <span>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

struct ContactScale {
  double across = 0.0;
  double along = 0.0;
};

/// What a row of elements bears.
struct ContactRow {
  double force = 0.0;
  double middle = 0.0;   ///< of it, along the rail
  double variance = 0.0; ///< about that
};

/// Rows of one height; second differences reach over `span` of them.
ContactScale contact_scale(std::span<const ContactRow> rows, double height, std::size_t span);

/// `pressure`: of the grid's elements, not negative, some of them positive.
std::vector<ContactRow> contact_rows(const Grid& grid, std::span<const double> pressure);
/// Of these rows.
ContactScale contact_scale(std::span<const ContactRow> rows, double height);
ContactScale contact_scale(const Grid& grid, std::span<const double> pressure);

} // namespace wrc
