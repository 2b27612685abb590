/// How far off a sum over rows is about where a contact's force acts across the rail.
///
/// Near the edge of contact the force per width f is linear (Hertz), and the edge lies anywhere
/// between two rows. With the edge d rows beyond the last one the sum over rows of height h exceeds
/// the integral by
///   -h^2/2 B2(d) f',  B2(d) = d^2 - d + 1/6
/// (Euler and Maclaurin). d follows from the last two rows, whose forces would end within the next
/// one at least: where contact ends on a sharper arc, f falls faster. At equal edges both errors
/// are equal and no moment is left; a contact that is steeper on one side, or whose edges lie
/// differently in their rows, has one. Continuous where a row enters that f ends at.
///
/// Units mm. Thread rule: a pure function. Not known here: what a solution does with such errors
/// (accuracy/constants.hpp), kinks of f further in.
#pragma once

#include <span>

#include "pressure/contact_scale.hpp"

namespace wrc {

/// That of the middle of the rows' forces, over the semi-axis of the ellipse with their second
/// moment. 0 of a single row.
double edge_error(std::span<const ContactRow> rows);

} // namespace wrc
