#include "patches/depth_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "patches/contact_patches.hpp"

namespace wrc {
namespace {

/// Where penetration exceeds 0.45 of the deepest, half lengths are sqrt(0.55) of the largest ones.
constexpr double virtual_penetration_share = 0.55;
/// Narrower contacts are taken for lines of this axis ratio.
constexpr double min_axis_ratio = 1e-4;
/// The depth to a load is a start for coarse solutions. One per cent would be near enough, but
/// where the search ends would show in forces, of a load found to 1e-4 by 2e-6 of it. Depths
/// outside the limits, mm, are not searched.
constexpr double depth_accuracy = 1e-6;
constexpr double first_depth = 0.05;
constexpr double min_searched_depth = 1e-300;
constexpr double max_depth_factor = 1e4;
constexpr int depth_iterations = 400;

/// Normal load of a patch by Hertz's law.
double load_of(const ContactPatch& patch, double combined_modulus) {
  const double cosine = std::cos(patch.angle);
  const double half_width = 0.5 * (patch.contact_last - patch.contact_first) / cosine;
  const double half_length = std::sqrt(virtual_penetration_share) * patch.half_length;
  const double longer = std::max(half_width, half_length);
  const double ratio = std::max(std::min(half_width, half_length) / longer, min_axis_ratio);
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

double estimate_depth(const ContactScan& scan, double combined_modulus, double load_asked,
                      LoadDirection direction) {
  // The load grows about with the power 1.5 of the depth: steps by that power until the load is
  // bracketed, then regula falsi (Illinois) in logarithms. The load may jump.
  struct Tried {
    double depth;
    double excess; ///< logarithm of the load over the one asked for
  };
  std::optional<Tried> low;
  std::optional<Tried> high;
  bool was_low = false;
  double depth = first_depth;
  for (int iteration = 1; iteration <= depth_iterations; ++iteration) {
    const double load = estimate_load(scan, combined_modulus, depth, direction);
    const double excess = std::log(load / load_asked);
    if (std::abs(excess) <= depth_accuracy) {
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
      if (ratio <= 1.0 + depth_accuracy) {
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
