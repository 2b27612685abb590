#include "patches/depth_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/root_bracket.hpp"
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
  const double ratio = std::max(std::min(half_width, half_length) / longer, min_axis_ratio);
  const double modulus = std::sqrt(1.0 - ratio * ratio);
  return 2.0 / 3.0 * std::numbers::pi * combined_modulus * longer * patch.deepest * cosine /
         std::comp_ellint_1(modulus);
}

/// Depth of a ball with the wheel's curvature on a plane (Hertz, 1882). `load`: over the modulus,
/// mm^2.
double depth_of_ball(double curvature, double load) {
  return std::cbrt(9.0 / 16.0 * curvature) * std::pow(std::cbrt(load), 2);
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
  // The load grows with a power of the depth of about 1.5: steps by the power seen last until the
  // load is bracketed, then within the bracket, in logarithms. The load may jump.
  const auto excess_at = [&](double depth) {
    const double excess =
        std::log(estimate_load(scan, combined_modulus, depth, direction) / load_sought);
    return std::abs(excess) <= estimated_depth_accuracy ? 0.0 : excess;
  };
  // Not so small that the load there is nothing.
  double depth = std::clamp(
      depth_of_ball(scan.candidates.front().wheel.normal_curvature, load_sought / combined_modulus),
      std::sqrt(min_searched_depth), max_depth);
  double excess = excess_at(depth);
  double power = load_power;
  for (int step = 1; step <= depth_iterations && excess != 0.0; ++step) {
    const double next = depth * std::exp(-excess / power);
    if (next >= max_depth || next <= min_searched_depth) {
      return std::clamp(next, min_searched_depth, max_depth);
    }
    const double next_excess = excess_at(next);
    // Also where the two depths are the same number.
    power = std::max(min_load_power, (next_excess - excess) / std::log(next / depth));
    if (std::abs(excess * next_excess) <= settled_excesses) {
      return next * std::exp(-next_excess / power);
    }
    if (excess * next_excess < 0.0) {
      RootBracket bracket({std::log(depth), excess}, {std::log(next), next_excess},
                          RootBracket::End::other);
      bracket.narrow(estimated_depth_accuracy,
                     [&](double logarithm) { return excess_at(std::exp(logarithm)); });
      return std::exp(bracket.middle());
    }
    depth = next;
    excess = next_excess;
  }
  return depth;
}

} // namespace wrc
