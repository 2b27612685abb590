/// Where the patches of a wheel are solved: planes and grids at a depth.
///
/// The planes are those of the patches of penetration (patches/contact_patches.hpp). A grid spans a
/// patch's penetration with a little room, within its lateral limits: contact cannot leave the
/// penetration, whose ends the scan knows by parabolas between its nodes. In the vertical
/// convention all patches near the main one share one plane and grid. Units mm and rad; left-hand
/// frame of the side. Thread rule: a pure function.
#pragma once

#include <functional>
#include <vector>

#include "accuracy/grid_solution.hpp"
#include "accuracy/resolution.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "wheel/wheel_request.hpp"

namespace wrc {

/// The grid of a patch over its potential contact area.
using GridChoice = std::function<Grid(const ContactPatch& penetration, const PlaneArea& area)>;

/// As many elements in each.
GridChoice grids_with_counts(const ElementCounts& counts);

/// Elements of the sizes of the nearest of these.
GridChoice grids_with_elements(std::vector<PatchElements> elements);

/// `depth` > 0: vertical, from the first touch. Nothing is sampled or solved yet.
GridSolution plan_grids(const RailSurface& rail, const SideEquilibrium& equilibrium,
                        const WheelRequest& request, double depth, const GridChoice& grid_of);

} // namespace wrc
