/// How creep forces and the slip that they follow from are computed, as it is requested.
///
/// Thread rule: plain values.
#pragma once

namespace wrc {

/// How creep forces are computed: the ladder of docs/creep.md. Closed formulas and FASTSIM
/// stand on the Hertzian ellipse with the patch's second moments of pressure; the full theory on
/// its own pressures.
enum class CreepModel { none, linear, shen_hedrick_elkins, polach, fastsim, full };

/// Slip of each element at its position along its tangent; at its position along the plane's axes
/// (b = 0 of creep/rigid_slip.hpp), as CONTACT's D = 3; or of three creepages at the reference, as
/// CONTACT's D = 2.
enum class SlipVariation { by_element, plane_axes, planar };

/// Whose height slip is taken at.
enum class SlipSurface { wheel, mean };

struct SlipChoice {
  SlipVariation variation = SlipVariation::by_element;
  SlipSurface surface = SlipSurface::wheel;
};

} // namespace wrc
