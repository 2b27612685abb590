/// How fine rows must be for crests that a coarse grid cannot see.
///
/// Where the relative curvature of the profiles exceeds that around it by k over a width w, a
/// half-space in plane strain, p(y) = -E*/(2 pi) int h''(eta) ln|y - eta| d eta (Johnson, Contact
/// Mechanics, 1985, section 2.7), answers with a crest of the order of E*/(2 pi) k w, times the
/// logarithm of its distance to the ends of contact. Rows much wider than w lose it. Curvatures are
/// those of the profiles themselves, averaged over widths from a twentieth of a millimetre to two
/// millimetres, against three times as much around; wheel and rail by their own lateral
/// coordinates, which roll and yaw shift by less than such a width. Units mm, MPa; left-hand frame
/// of the side. Thread rule: a pure function. Not known here: curvature along the rail.
#pragma once

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "scene/grid_solution.hpp"

namespace wrc {

/// Lateral step at which crests leave no more than an error of pmax, MPa; infinity if there are
/// none. Only where the coarse pressures of the patch and a crest may reach `highest`, MPa.
double row_step_for_crests(const PatchOnGrid& patch, const WheelSurface& wheel,
                           const RailSurface& rail, double combined_modulus, double highest,
                           double error);

} // namespace wrc
