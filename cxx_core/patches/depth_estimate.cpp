#include "patches/depth_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/root_bracket.hpp"
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
constexpr int depth_steps = 400;

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
  // bracketed, then within the bracket, in logarithms. The load may jump.
  const auto excess_at = [&](double depth) {
    const double excess =
        std::log(estimate_load(scan, combined_modulus, depth, direction) / load_asked);
    return std::abs(excess) <= depth_accuracy ? 0.0 : excess;
  };
  double depth = first_depth;
  double excess = excess_at(depth);
  for (int step = 1; step <= depth_steps && excess != 0.0; ++step) {
    const double factor = std::exp(-excess / 1.5);
    const double next = depth * std::clamp(factor, 1.0 / max_depth_factor, max_depth_factor);
    if (next >= max_depth || next <= min_searched_depth) {
      return std::clamp(next, min_searched_depth, max_depth);
    }
    const double next_excess = excess_at(next);
    if (excess * next_excess < 0.0) {
      RootBracket bracket({std::log(depth), excess}, {std::log(next), next_excess},
                          RootBracket::End::other);
      bracket.narrow(depth_accuracy,
                     [&](double logarithm) { return excess_at(std::exp(logarithm)); });
      return std::exp(bracket.middle());
    }
    depth = next;
    excess = next_excess;
  }
  return depth;
}

} // namespace wrc
