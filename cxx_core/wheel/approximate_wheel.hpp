/// One wheel on its rail by an approximate model: Hertz, or Kik & Piotrowski.
///
/// The patches of penetration (patches/contact_patches.hpp) at the wheel's depth each get a model
/// of their own (models/patch_model.hpp); all have the same depth, so a load is distributed through
/// one vertical approach: sum of cos(angle) N(depth) = F. The depth is the root of that for the
/// patches found at a depth, and patches are found again until it stays. Lowering the wheel moves
/// no strip, so the slide of a sinking wheel along the tangent is in it. The result is that of a
/// half-space solution (records/wheel_solution.hpp) with figures from the model in closed form;
/// pressures are sampled at the element centres of a modest grid, or of the one given. Nothing is
/// kept between calls. Units mm, N, MPa, rad; left-hand frame of the side. Thread rule: a pure
/// function. Not known here: that patches displace each other; how far off the model is (validity
/// says whether its assumptions hold, docs/evidence/models.md what errors go with it).
#pragma once

#include "geometry/wheelset_equilibrium.hpp"
#include "records/wheel_request.hpp"
#include "records/wheel_solution.hpp"

namespace wrc {

enum class ApproximateModel { hertz, kik_piotrowski };

/// Throws Error(invalid_argument) for vertical distances, which models do not have.
WheelSolution solve_wheel_approximately(const WheelSurface& wheel, const RailSurface& rail,
                                        const SideEquilibrium& equilibrium,
                                        const WheelRequest& request, ApproximateModel model);

} // namespace wrc
