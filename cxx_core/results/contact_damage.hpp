/// What contact does to the steel, patch by patch, as far as it is requested.
///
/// Wear comes from the pressures and tractions of the creep grid, stresses from the pressures of
/// the patch and tractions in proportion. Stresses are those of one body: the rail, on which
/// tractions act the other way round, or the wheel. Wear needs tractions by element (model full),
/// fatigue creep forces of any kind.
///
/// Depths are positive into the body. Units mm, N, MPa. Thread rule: pure functions of the results.
///
/// Not known here: what patches of one wheel add to each other's stresses.
#pragma once

#include <array>
#include <vector>

#include "damage/subsurface_stress.hpp"
#include "damage/wear.hpp"
#include "records/damage_result.hpp"

namespace wrc {

struct PatchResult;
struct WheelDetails;
struct WheelResult;

/// Fills in ContactDamage of the wheel and its patches.
void find_damage(WheelResult& wheel, const DamageRequest& request);

/// Stresses below a patch or a part of one, under its pressures and, where it has them, its
/// tractions: their ratios to the pressures of their coarser grid, on the elements of normal
/// contact. Pressures that tractions change are those of the tractions' grid.
SubsurfaceStress stresses_below(const PatchResult& patch, const DamageRequest& request);

/// Stresses in a plane through the point of the greatest one, track frame turned into the patch's
/// plane; empty if they were not requested.
StressSection stress_section(const WheelDetails& wheel, const PatchResult& patch);
/// Wear by element of the creep grid and by its rows; empty if it was not requested.
Wear patch_wear(const WheelDetails& wheel, const PatchResult& patch);
/// Where rows lie on the profiles: s of the wheel, t of the rail.
struct RowPlaces {
  std::vector<double> s_wheel;
  std::vector<double> t_rail;
};
RowPlaces wear_places(const WheelDetails& wheel, const PatchResult& patch);

/// The groove that passes have left, by rows of the patch and along their normals: of the wheel, of
/// the rail; empty if it was not requested, 0 where steel does not yield.
std::array<std::vector<double>, 2> patch_groove(const WheelDetails& wheel,
                                                const PatchResult& patch);
RowPlaces groove_places(const WheelDetails& wheel, const PatchResult& patch);

} // namespace wrc
