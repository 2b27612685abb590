#include "patches/depth_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "patches/constants.hpp"
#include "patches/contact_patches.hpp"

namespace wrc {
namespace {

/// Normal load of a patch by Hertz's law.
double load_of(const ContactPatch& patch, double combined_modulus) {
  const double cosine = std::cos(patch.angle);
  const double half_width = 0.5 * (patch.contact_last - patch.contact_first) / cosine;
  const double half_length = std::sqrt((1.0 - outside_contact_share)) * patch.half_length;
  const double longer = std::max(half_width, half_length);
  const double ratio =
      std::max(std::min(half_width, half_length) / longer, min_estimated_axis_ratio);
  const double modulus = std::sqrt(1.0 - ratio * ratio);
  return 2.0 / 3.0 * std::numbers::pi * combined_modulus * longer * patch.deepest * cosine /
         std::comp_ellint_1(modulus);
}

} // namespace

double estimate_load(const ContactScan& scan, double combined_modulus, double depth,
                     LoadDirection direction) {
  const ContactPatches found = find_contact_patches(scan, depth);
  const double along = direction == LoadDirection::vertical ? 0.0 : found.patches[found.main].angle;
  double load = 0.0;
  for (const ContactPatch& patch : found.patches) {
    load += std::cos(patch.angle - along) * load_of(patch, combined_modulus);
  }
  return load;
}

double estimate_depth(const ContactScan& scan, double combined_modulus, double load_sought,
                      LoadDirection direction) {
  // The load grows about with the power 1.5 of the depth: steps by that power until the load is
  // bracketed, then regula falsi (Illinois) in logarithms. The load may jump.
  struct Tried {
    double depth;
    double excess; ///< logarithm of the load over the one sought
  };
  std::optional<Tried> low;
  std::optional<Tried> high;
  bool was_low = false;
  double depth = first_searched_depth;
  for (int iteration = 1; iteration <= depth_iterations; ++iteration) {
    const double load = estimate_load(scan, combined_modulus, depth, direction);
    const double excess = std::log(load / load_sought);
    if (std::abs(excess) <= estimated_depth_accuracy) {
      break;
    }
    const bool is_low = excess < 0.0;
    (is_low ? low : high) = Tried{depth, excess};
    if (!low || !high) {
      depth *= std::clamp(std::exp(-excess / 1.5), 1.0 / max_depth_factor, max_depth_factor);
      if (depth >= max_depth && low) {
        return max_depth;
      }
      if (depth <= min_searched_depth) {
        return min_searched_depth;
      }
    } else {
      const double ratio = high->depth / low->depth;
      if (ratio <= 1.0 + estimated_depth_accuracy) {
        return std::sqrt(low->depth * high->depth);
      }
      if (iteration > 2 && is_low == was_low) {
        (is_low ? high : low)->excess *= 0.5;
      }
      depth = low->depth * std::pow(ratio, low->excess / (low->excess - high->excess));
    }
    was_low = is_low;
  }
  return depth;
}

} // namespace wrc
