#include "results/cut_contact.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "remesh/contact_border.hpp"
#include "remesh/met_distance.hpp"
#include "results/constants.hpp"

namespace wrc {
namespace {

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

double error_of_edge(double step, double semi_axis) {
  return error_of_cut * step / std::max(semi_axis, 0.5 * step);
}

std::optional<ContactCut> cut_of(const PatchResult& patch, const WheelAndRail& bodies) {
  const std::vector<double>& distance = patch.undeformed_distance;
  const bool is_prismatic = bodies.is_prismatic_along(along_track);
  if (is_prismatic && std::ranges::all_of(distance, is_met)) {
    return std::nullopt;
  }
  bool at_side = false;
  for (const BorderPair& pair : contact_border(patch.grid, patch.pressure, distance)) {
    if (!pair.is_along) {
      at_side = at_side || pair.ends;
    } else if (pair.ends || distance[pair.outside] - distance[pair.inside] > patch.approach) {
      if (const std::string where = end_between(patch, pair, bodies); !where.empty()) {
        return ContactCut{
            true, "an end of " + where,
            error_of_edge(patch.grid.longitudinal_step, patch.semi_axis_longitudinal)};
      }
    }
  }
  if (!at_side) {
    return std::nullopt;
  }
  return ContactCut{false, is_prismatic ? "the end of a profile" : "the side of a part",
                    error_of_edge(patch.grid.lateral_step, patch.semi_axis_lateral)};
}

} // namespace

std::optional<ContactCut> mark_cuts(std::span<PatchResult> patches, const WheelSurface& wheel,
                                    const RailSurface& rail) {
  std::optional<ContactCut> found;
  double error = 0.0;
  for (PatchResult& patch : patches) {
    // Those of one plane are solved as parts.
    auto cut =
        patch.parts.empty() ? cut_of(patch, {wheel, rail}) : mark_cuts(patch.parts, wheel, rail);
    patch.is_unbounded = cut.has_value();
    if (cut) {
      error = std::max(error, cut->error);
      if (!found || (cut->is_along && !found->is_along)) {
        found = std::move(cut);
      }
      found->error = error;
    }
  }
  return found;
}

} // namespace wrc
