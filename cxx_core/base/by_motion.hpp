/// One value for each motion of the wheelset.
#pragma once

namespace wrc {

template <typename Value> struct ByMotion {
  Value lateral{};  ///< y grows
  Value vertical{}; ///< z grows
  Value roll{};     ///< turning about the wheelset's centre
  Value yaw{};
};

} // namespace wrc
