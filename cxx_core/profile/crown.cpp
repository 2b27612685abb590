#include "profile/crown.hpp"

#include <algorithm>
#include <cmath>

#include "profile/constants.hpp"

namespace wrc {

std::size_t crown_among(std::span<const double> heights) {
  const auto highest = std::max_element(heights.begin(), heights.end());
  auto lowest = highest;
  auto head = heights.end(); // the highest place behind the groove
  for (auto at = highest; at != heights.end(); ++at) {
    if (head != heights.end()) {
      head = *at > *head ? at : head;
    } else if (*at < *lowest) {
      lowest = at;
    } else if (*at > *lowest + least_groove) {
      head = at;
    }
  }
  // What is higher than a head at height 0; below one, planks and clips are no head.
  const bool is_guarded = head != heights.end() && *highest - *head > least_guard_height &&
                          std::abs(*head) < std::abs(*highest);
  return static_cast<std::size_t>((is_guarded ? head : highest) - heights.begin());
}

} // namespace wrc
