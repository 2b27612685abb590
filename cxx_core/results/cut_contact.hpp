/// Contacts that the end of a body cuts off.
///
/// A part of a rail ends along the track at its first and last slice, a part of a wheel around the
/// circumference, and both have sides; so has a profile that is the same all along. A patch is cut
/// where an element under pressure is next to a ray that misses a body, or along to one beyond the
/// end of a part whose distance is larger by more than the approach: another part lies below.
/// Pressures at such an edge are unbounded, as under a rigid punch; those of elements grow as the
/// elements shrink. The edge is known to half an element, and so are depth and place.
/// Units mm and rad; frame of the side, left-hand (geometry/frames.hpp). Thread rule: pure
/// functions, except for the flags that are set.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "records/wheel_result.hpp"

namespace wrc {

struct ContactCut {
  bool is_along = false; ///< the end of a part, not its side
  std::string where;     ///< "an end of the rail at 100 mm"
  double error = 0.0;    ///< estimated: of the depth, and of the place over the contact's semi-axis
};

/// Sets PatchResult::is_unbounded of all patches of a wheel that are, and of their parts. Returns
/// the first cut along, else the first across, with the largest error of all; none where none is
/// cut.
std::optional<ContactCut> mark_cuts(std::span<PatchResult> patches, const WheelSurface& wheel,
                                    const RailSurface& rail);

} // namespace wrc
