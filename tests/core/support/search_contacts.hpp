/// The contacts of a left wheel and a left rail at one pose.
#pragma once

#include "geometry/contact_search.hpp"

namespace wrc::test {

/// Throws Error(no_contact) if no part of the wheel is over the rail. `near_tolerance` as
/// contacts_of.
inline ContactScan search_contacts(const WheelSurface& wheel, const RailSurface& rail,
                                   const Pose& pose, double near_tolerance) {
  SideSearch search(wheel, rail);
  search.scan(pose);
  return contacts_of(search, near_tolerance);
}

} // namespace wrc::test
