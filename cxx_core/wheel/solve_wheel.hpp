/// One wheel on its rail: from the contact search to pressures.
///
/// Joins remesh and mechanics for one side:
///  1. the depth to which the wheel sinks is estimated from the virtual penetration (with the load
///     prescribed);
///  2. the patches of penetration at that depth (patches/contact_patches.hpp), each with a plane,
///     an area and a grid of its own, are solved together (mechanics/normal_contact.hpp) on few
///     elements: this coarse solution finds the depth;
///  3. planes, grids and undeformed distance at the depth found, and the final solution on the
///     elements that the accuracy needs (accuracy/resolution.hpp);
///  4. with accuracy of pressures, the largest one from a finer section
///     (accuracy/peak_section.hpp).
/// Nothing is kept from one solution to the next, so the result depends on the scene alone. Grids
/// span the penetration, which contact cannot leave. The shared unknown is the vertical approach,
/// the load is the vertical one, and both count at each element with w, by how much its distance
/// grows as the wheel is lifted (remesh/rail_normals.hpp): a step in depth is right to first order,
/// planes and grids go with the wheel. Forces are sums over elements with the same directions, so
/// they are derivatives of an energy, and the direction of a plane has only a second-order effect.
/// With `curved` the rows of a patch lie along the mean curve of both bodies in place of its plane
/// (remesh/mean_curve.hpp), with distances, shares and forces along its normals.
/// Exceptions cost another solution each: loads that the rail's turn under the same pressures
/// changes by more than the iteration may leave; with pressures, a patch just born whose contact
/// outgrows its penetration, and a crest that the section has not resolved. `solutions` counts them
/// all. With `normal_load` the load is that along the force of the patches in the main plane, or
/// along the gap with vertical distances; the vertical load is taken from how the forces of the
/// solution before lie. Patches that are close turn their planes towards each other and interact in
/// part (contact_patches.hpp), so that nothing jumps when they become one contact or are joined on
/// one grid; patches that are far apart do not interact unless `interaction` is set. A side may
/// also stop after the geometry (no patches), or after the remesh: the patches of penetration at
/// the depth estimated or prescribed, their grids and undeformed distances. Units mm, N, MPa, rad;
/// left-hand frame of the side (geometry/frames.hpp). Thread rule: a solver serves one thread at a
/// time; otherwise a pure function. Not known here: friction; forces between the wheels.
#pragma once

#include "geometry/wheelset_equilibrium.hpp"
#include "mechanics/normal_solver.hpp"
#include "records/wheel_request.hpp"
#include "records/wheel_solution.hpp"

namespace wrc {

WheelSolution solve_wheel(const WheelSurface& wheel, const RailSurface& rail,
                          const SideEquilibrium& equilibrium, const WheelRequest& request,
                          NormalSolver& solver);

} // namespace wrc
