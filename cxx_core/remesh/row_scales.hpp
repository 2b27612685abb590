/// How rows of elements whose surface is inclined to the plane of their patch are softer than
/// others.
///
/// A plane measures distances h along its own normal, and an element of it stands for a longer
/// piece of an inclined surface. Take Hertz's contact of bodies that are inclined by beta: in the
/// plane distances and the approach are longer by 1/cos(beta), curvatures across by 1/cos^3(beta).
/// Its pressures, its force (p dA f, remesh/rail_normals.hpp) and its energy are those of the
/// bodies if what pressures displace is
///   u = S K S p,  S = diag(c^(-3/4)),  c = cos(beta) of each row,
/// exact for bodies as round along the rail as across it (K the half-space; with u = K p all are
/// too large by cos^(-3/2)). Wheel and rail are inclined alike, except for the gap between them:
///   1/c^2 = 1 + max(tan(beta_wheel) tan(beta_rail), 0),
/// which an edge of one of them does not spoil. Where they are inclined to opposite sides, as on
/// flanges, the plane is midway between both, and c is 1. Forces take no notice of how S changes as
/// rail and wheel move along each other. Solvers see h/S, p S and K: the same problem in other
/// variables.
/// Units: none. Thread rule: pure functions.
/// Along a curve beta is the inclination to its rows. To the mean curve (mean_curve.hpp) both
/// bodies are inclined to opposite sides, so c is 1. Not known here: distances along the wheelset's
/// axis (vertical convention), whose rows stay as they are.
#pragma once

#include <span>
#include <vector>

#include "base/grid.hpp"
#include "remesh/rail_normals.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

/// c^(3/4) of each row, 1/S; empty with the vertical convention.
std::vector<double> row_scales(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
                               const RailNormals& rail);

/// A field of the grid, or an empty one, times its rows' scales; as it is, if there are none.
std::vector<double> times_scales(const Grid& grid, std::span<const double> scales,
                                 std::span<const double> field);
/// Divided by them.
std::vector<double> over_scales(const Grid& grid, std::span<const double> scales,
                                std::span<const double> field);

} // namespace wrc
