/// Contact that a solution has left out, because its areas do not reach there.
///
/// Contact can be missing where the bodies penetrate beyond an area. Every sample of the scan there
/// is checked with the displacement that the pressures of its patch cause at its place, and those
/// of the patches that it feels. Units mm, N, MPa; left-hand frame of the side. Thread rule: a pure
/// function.
#pragma once

#include "scene/side_plan.hpp"

namespace wrc {

/// Enlarges the areas of the plan that the trial was made from so that they hold the contact left
/// out, as far as the patches' territories go; false if there is none.
bool add_missed_contact(const WheelSurface& wheel, const RailSurface& rail,
                        const SideEquilibrium& equilibrium, const SidePlanner& planner,
                        double combined_modulus, Elements elements, const Trial& trial,
                        SidePlan& plan);

} // namespace wrc
