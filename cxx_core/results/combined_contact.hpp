/// Several patches that share a plane, as one contact.
///
/// Patches whose penetrations are close turn into one plane (patches/contact_patches.hpp), but are
/// solved on grids of their own, each as fine as it needs. Together: the plane goes through the
/// mean position of penetration of all; forces add up, the centre of pressure is that of all, the
/// semi-axes are those of the Hertzian ellipse with the second moments of all pressures; pmax and
/// approach are the largest.
///
/// Fields of the whole are means over the elements of a grid that spans all parts: those of the
/// part with the largest pressure, or larger ones where that would need more than sixteen times the
/// elements of all parts. Forces stay.
///
/// Units mm, N, MPa; left-hand frame of the side. Thread rule: pure functions.
#pragma once

#include <span>
#include <vector>

#include "records/wheel_result.hpp"

namespace wrc {

/// The whole, without fields and position of penetration. `parts`: at least one, largest normal
/// force first, in parallel planes.
Patch combined(std::span<const Patch> parts, const RailSurface& rail);

/// Displacement of a patch without parts, mm.
std::vector<double> displacement_of(const PatchResult& patch, const WheelDetails& side);
/// The scale of each element's row (remesh/row_scales.hpp); 1 of a patch with parts.
std::vector<double> scales_of_elements(const PatchResult& patch);

/// Pressures and undeformed distances of a patch that has parts, on its grid: MPa, mm.
std::vector<double> combined_pressure(const PatchResult& whole);
std::vector<double> combined_distance(const PatchResult& whole, const WheelDetails& side);
/// At the elements next to a part: the displacement by this part, and that by the other parts,
/// reduced by the coupling weight.
std::vector<double> combined_displacement(const PatchResult& whole, const WheelDetails& side);

} // namespace wrc
