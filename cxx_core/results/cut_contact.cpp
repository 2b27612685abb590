#include "results/cut_contact.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "remesh/contact_border.hpp"

namespace wrc {
namespace {

constexpr const char* at_cut =
    ": pressures there are too large and do not converge, forces jump by about 1 % of the load "
    "as the contact passes";

/// The end of a part between two elements of a row; empty if none is there.
std::string end_between(const PatchResult& patch, const BorderPair& pair,
                        const WheelAndRail& bodies) {
  const Grid& grid = patch.grid;
  const std::size_t columns = grid.longitudinal_count;
  const double before = grid.longitudinal(std::min(pair.inside, pair.outside) % columns);
  const double after = grid.longitudinal(std::max(pair.inside, pair.outside) % columns);
  // The ray meets the surface within an element of where it crosses the plane.
  const double reach = 1.5 * (after - before);
  const double x =
      patch.frame.to_track(0.5 * (before + after), grid.lateral(pair.inside / columns), 0.0).x;
  if (const auto end = bodies.rail.nearest_end(x); end && end->distance <= reach) {
    return "the rail at " + short_text_of(end->place) + " mm";
  }
  if (const auto end = bodies.wheel.nearest_end(x); end && end->distance <= reach) {
    return "the wheel at " + short_text_of(end->place) + " rad";
  }
  return {};
}

std::optional<ContactCut> cut_of(const PatchResult& patch, const WheelAndRail& bodies) {
  const std::vector<double>& distance = patch.undeformed_distance;
  bool at_side = false;
  for (const BorderPair& pair : contact_border(patch.grid, patch.pressure, distance)) {
    if (!pair.is_along) {
      at_side = at_side || pair.ends;
    } else if (pair.ends || distance[pair.outside] - distance[pair.inside] > patch.approach) {
      if (const std::string where = end_between(patch, pair, bodies); !where.empty()) {
        return ContactCut{
            true, {WarningClass::profile_end, "contact reaches an end of " + where + at_cut}};
      }
    }
  }
  if (!at_side) {
    return std::nullopt;
  }
  return ContactCut{
      false,
      {WarningClass::profile_end, std::string("contact reaches the side of a part") + at_cut}};
}

} // namespace

std::optional<ContactCut> find_cut(std::span<const PatchResult> patches, const WheelSurface& wheel,
                                   const RailSurface& rail) {
  const WheelAndRail bodies{wheel, rail};
  if (bodies.is_prismatic_along(along_track)) {
    return std::nullopt;
  }
  std::optional<ContactCut> found;
  for (const PatchResult& patch : patches) {
    // Those of one plane are solved as parts.
    auto cut = patch.parts.empty() ? cut_of(patch, bodies) : find_cut(patch.parts, wheel, rail);
    if (cut && (!found || cut->is_along)) {
      found = std::move(cut);
      if (found->is_along) {
        return found;
      }
    }
  }
  return found;
}

} // namespace wrc
