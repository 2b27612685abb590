/// One value for each motion of the wheelset.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace wrc {

constexpr std::size_t motion_count = 4; // not a tuning constant

template <typename Value> struct ByMotion {
  Value lateral{};  ///< y grows
  Value vertical{}; ///< z grows
  Value roll{};     ///< turning about the wheelset's centre
  Value yaw{};

  /// In this order.
  Value& operator[](std::size_t motion) {
    return *std::array<Value*, motion_count>{&lateral, &vertical, &roll, &yaw}[motion];
  }
  const Value& operator[](std::size_t motion) const {
    return *std::array<const Value*, motion_count>{&lateral, &vertical, &roll, &yaw}[motion];
  }
};

/// From a function of the motion's number.
template <class Function> auto by_motion(const Function& value_of) {
  using Value = std::invoke_result_t<Function, std::size_t>;
  return ByMotion<std::decay_t<Value>>{value_of(0), value_of(1), value_of(2), value_of(3)};
}

} // namespace wrc
