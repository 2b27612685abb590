/// Contacts that the end of a body which varies cuts off.
///
/// A part of a rail ends along the track at its first and last slice, a part of a wheel around the
/// circumference, and both have sides. A patch is cut where an element under pressure is next to a
/// ray that misses a body, or along to one beyond the end of a part whose distance is larger by
/// more than the approach: another part lies below. Pressures at such an edge are unbounded, as
/// under a rigid punch; those of elements grow as the elements shrink.
/// Units mm and rad; frame of the side, left-hand (geometry/frames.hpp). Not covered: bodies that
/// are prismatic along the track, of which the first touch is looked at. Thread rule: pure
/// functions.
#pragma once

#include <optional>
#include <span>

#include "base/warning.hpp"
#include "records/wheel_result.hpp"

namespace wrc {

struct ContactCut {
  bool is_along = false; ///< the end of a part, not its side
  Warning warning;
};

/// Of the patches of a wheel the first cut along, else the first across; none where none is cut.
std::optional<ContactCut> find_cut(std::span<const PatchResult> patches, const WheelSurface& wheel,
                                   const RailSurface& rail);

} // namespace wrc
