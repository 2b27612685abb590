#include "derivatives/wheel_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "creep/rolling_frame.hpp"
#include "derivatives/constants.hpp"
#include "derivatives/gap_rates.hpp"
#include "derivatives/patch_rates.hpp"
#include "derivatives/plane_rates.hpp"
#include "geometry/contact_search.hpp"
#include "mechanics/coupled_influence.hpp"
#include "patches/constants.hpp"
#include "remesh/contact_border.hpp"
#include "remesh/met_distance.hpp"

namespace wrc {
namespace {

/// The planes at the depth found, beside which they were planned. Where they do not move along the
/// contact locus of a round wheel on a prismatic rail they stay, with one rate of 0 for all.
struct Planes {
  MovingPatches moving;
  std::vector<std::size_t> index; ///< of each patch of the result

  [[nodiscard]] bool stay() const { return moving.found.patches.empty(); }
};

Planes find_planes(const WheelResult& side, std::span<const PatchResult* const> patches) {
  const WheelDetails& details = side.details;
  if (!details.pair().is_prismatic_along(along_track)) {
    Planes planes;
    planes.moving.rates.resize(1);
    planes.index.assign(patches.size(), 0);
    return planes;
  }
  const double depth = side.vertical - details.vertical;
  const ContactScan scan = search_contacts(*details.wheel, *details.rail, details.pose, depth);
  Planes planes;
  planes.moving = find_moving_patches(*details.wheel, *details.rail, details.pose, scan, depth,
                                      details.request);
  const auto& found = planes.moving.found.patches;
  for (const PatchResult* patch : patches) {
    const auto apart = [patch](const ContactPatch& place) {
      return std::abs(place.mean_y - patch->frame.origin.y);
    };
    const auto nearest = std::ranges::min_element(found, {}, apart);
    planes.index.push_back(static_cast<std::size_t>(nearest - found.begin()));
  }
  return planes;
}

/// Whether any weight is below 1: it changes as planes turn or patches move.
bool is_changing(const WheelDetails& details, const Planes& planes) {
  const PatchInteraction& interaction = *details.interaction;
  return !planes.stay() &&
         std::any_of(interaction.coupling_weight.begin(), interaction.coupling_weight.end(),
                     [](double coupling_weight) { return coupling_weight < 1.0; });
}

/// The influence with the rates of coupling weight instead; left empty where the influence does not
/// change.
void make_changing_influence(std::span<const SolvedPatch> solved, const WheelDetails& details,
                             const Planes& planes, std::size_t motion,
                             std::optional<CoupledInfluence>& change) {
  PatchInteraction interaction = *details.interaction;
  const std::size_t count = solved.size();
  bool any = false;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t l = 0; l < count; ++l) {
      double& rate = interaction.coupling_weight[k * count + l];
      rate = planes.moving.coupling_weight_rate(planes.index[k], planes.index[l],
                                                details.request.interaction)[motion];
      any = any || rate != 0.0;
    }
  }
  if (any) {
    change.emplace(solved, interaction, details.request.combined_modulus);
  }
}

ByMotion<Vector3> reference_rates(const ContactFrame& frame, const PlaneRates& plane,
                                  const RailSurface& rail) {
  const double slope = graph_near(rail, frame.origin.x, frame.origin.y).by_lateral;
  return by_motion([&](std::size_t motion) {
    const double by_y = plane.mean_y[motion];
    return plane.mean_x[motion] * frame.longitudinal + Vector3{0.0, by_y, slope * by_y};
  });
}

/// Motion of a grid over the rectangle around a penetration: its edges move with the ends.
ElementMotion motion_of_grid(const PatchResult& patch, const ContactPatch& penetration,
                             const PlaneRates& rates, const RailSurface& rail, std::size_t motion) {
  const Grid& grid = patch.grid;
  const auto follow = [](double middle, double apart, double first_rate, double last_rate,
                         double& translation, double& growth) {
    growth = (last_rate - first_rate) / apart;
    translation = 0.5 * (first_rate + last_rate) - growth * middle;
  };
  const auto middle = [](double first, double step, std::size_t count) {
    return first + 0.5 * step * static_cast<double>(count - 1);
  };
  const auto across = [&](double y, const ByMotion<double>& rate) {
    const ContactFrame& frame = patch.frame;
    const GraphPoint point = graph_near(rail, frame.origin.x, y);
    const double over_plane = rate[motion] * (frame.lateral.y + frame.lateral.z * point.by_lateral);
    if (!frame.curve) {
      return over_plane;
    }
    const double place = frame.lateral_of(Vector3{0.0, y, point.height} - frame.origin);
    return over_plane / frame.curve->at(place).cosine;
  };
  ElementMotion result;
  follow(middle(grid.longitudinal_first, grid.longitudinal_step, grid.longitudinal_count),
         penetration.x_last - penetration.x_first, rates.x_first[motion], rates.x_last[motion],
         result.along, result.longitudinal_growth);
  follow(middle(grid.lateral_first, grid.lateral_step, grid.lateral_count),
         grid.lateral_step * static_cast<double>(grid.lateral_count) /
             (1.0 + 2.0 * penetration_margin),
         across(penetration.y_first, rates.y_first), across(penetration.y_last, rates.y_last),
         result.across, result.lateral_growth);
  return result;
}

/// Known where the grid has the contact for itself, and where elements stay since a part of a body
/// ends in the contact: its end stays as well.
std::optional<ByMotion<ElementMotion>>
motion_of_grid(const PatchResult& patch, const Planes& planes, const WheelDetails& details) {
  const MovingPatches& moving = planes.moving;
  if (planes.stay()) {
    return body_ends_in_contact(patch.grid, patch.pressure, patch.undeformed_distance)
               ? std::optional(ByMotion<ElementMotion>{})
               : std::nullopt;
  }
  if (moving.found.patches.size() > 1 || details.request.gap != GapConvention::tangent) {
    return std::nullopt;
  }
  return by_motion([&](std::size_t motion) {
    return motion_of_grid(patch, moving.found.patches[0], moving.rates[0], *details.rail, motion);
  });
}

/// At the vertex of the parabolas through the least distance and its neighbours, as Patch::overlap.
ByMotion<double> least_gap_rates(const PosedPair& pair, const Patch& patch) {
  const std::vector<double>& distance = patch.undeformed_distance;
  const std::size_t columns = patch.grid.longitudinal_count;
  const auto least = static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) -
                                              distance.begin());
  struct Neighbours {
    std::size_t before, after;
    double to_vertex; // in elements
  };
  std::vector<double> wanted(distance.size(), 0.0);
  wanted[least] = 1.0;
  std::vector<Neighbours> neighbours;
  const auto add = [&](std::size_t place, std::size_t count, std::size_t stride) {
    if (place == 0 || place + 1 == count) {
      return;
    }
    const std::size_t before = least - stride;
    const std::size_t after = least + stride;
    if (!is_met(distance[before]) || !is_met(distance[after])) {
      return;
    }
    const double curvature = distance[before] - 2.0 * distance[least] + distance[after];
    if (curvature > 0.0) {
      wanted[before] = wanted[after] = 1.0;
      neighbours.push_back({before, after, 0.5 * (distance[before] - distance[after]) / curvature});
    }
  };
  add(least % columns, columns, 1);
  add(least / columns, patch.grid.lateral_count, columns);
  const auto motions = all_motions(pair.pose.yaw);
  std::vector<std::vector<double>> rates;
  compute_gap_rates(pair, patch.frame, patch.grid, wanted, motions, rates);
  return by_motion([&](std::size_t motion) {
    const std::vector<double>& rate = rates[motion];
    double result = rate[least];
    for (const Neighbours& of : neighbours) {
      result += 0.5 * of.to_vertex * (rate[of.after] - rate[of.before]);
    }
    return result;
  });
}

/// Planes of vertical gaps turn with the wheelset; curves stay.
ByMotion<double> angle_rates_of(const ContactFrame& frame, const PlaneRates& plane,
                                GapConvention gap) {
  if (frame.curve) {
    return {};
  }
  return gap == GapConvention::vertical ? ByMotion<double>{0.0, 0.0, 1.0, 0.0} : plane.angle;
}

WheelRates compute_rates(const WheelResult& side) {
  const WheelDetails& details = side.details;
  const std::vector<const PatchResult*> patches = solved_patches(side);
  const Planes planes = find_planes(side, patches);
  std::vector<LoadedPatch> loaded;
  std::vector<ByMotion<Vector3>> references;
  std::vector<SolvedPatch> solved;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const PatchResult& patch = *patches[k];
    const ByMotion<Vector3>& reference = references.emplace_back(
        reference_rates(patch.frame, planes.moving.rates[planes.index[k]], *details.rail));
    loaded.push_back(
        {patch.frame, patch.grid, patch.pressure,
         angle_rates_of(patch.frame, planes.moving.rates[planes.index[k]], details.request.gap),
         by_motion(
             [&](std::size_t motion) { return dot(reference[motion], patch.frame.longitudinal); }),
         patch.undeformed_distance, patch.row_scales, motion_of_grid(patch, planes, details)});
    solved.push_back({patch.grid, patch.pressure, details.request.elements});
  }
  SensitivityRequest request;
  request.combined_modulus = details.request.combined_modulus;
  request.elements = details.request.elements;
  request.yielding = yielding_of(*patches.front(), details);
  request.tolerance = sensitivity_tolerance;
  std::optional<CoupledInfluence> influence;
  if (details.interaction) {
    influence.emplace(solved, *details.interaction, details.request.combined_modulus);
    request.influence = &*influence;
  }
  ByMotion<std::optional<CoupledInfluence>> changes;
  if (details.interaction && is_changing(details, planes)) {
    request.influence_rates = by_motion([&](std::size_t motion) -> PatchInfluence* {
      make_changing_influence(solved, details, planes, motion, changes[motion]);
      return changes[motion] ? &*changes[motion] : nullptr;
    });
  }
  InfluenceCache cache;
  ContactStiffness stiffness(cache);
  const PosedPair pair = details.pair();
  WheelSensitivity found = compute_patch_rates(pair, loaded, request, stiffness);
  if (planes.stay()) { // the reference goes with the elements
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const ContactFrame& plane = loaded[k].frame;
      references[k] = by_motion([&](std::size_t motion) {
        const ElementMotion& elements = found.patches[k].elements[motion];
        return elements.along * plane.longitudinal + elements.across * plane.lateral;
      });
    }
  }
  const RollingFrame frame(details.mirror);
  WheelRates result;
  result.by_pressures = frame.mirrored(found.force_rates);
  if (!details.interaction || !is_changing(details, planes)) {
    make_symmetric(found.force_rates, found.force, details.pose);
  }
  result.force = frame.mirrored(found.force_rates);
  result.at_load = condense_at_vertical_load(result.force);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    PatchSensitivity& patch = found.patches[k];
    result.patches.push_back({patch.normal_force_rates, patch.elements,
                              std::move(patch.pressure_rates), loaded[k].angle_rates, references[k],
                              least_gap_rates(pair, *patches[k])});
  }
  return result;
}

bool is_finite(const ForceRates& rates) {
  const auto finite = [](const Vector3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
  };
  const std::array all{rates.lateral, rates.vertical, rates.roll, rates.yaw};
  return std::ranges::all_of(
      all, [&](const WheelForce& rate) { return finite(rate.force) && finite(rate.moment); });
}

} // namespace

std::optional<WheelRates> wheel_rates_of(const WheelResult& side) {
  if (is_pressed_again(side)) {
    return std::nullopt; // the groove moves with the profiles, which have none
  }
  // Above the first touch, where a solution that fails may end, no planes are found.
  if (side.patches.empty() || !side.solved || side.validity || !(side.depth > 0.0)) {
    return std::nullopt;
  }
  WheelRates rates = compute_rates(side);
  return is_finite(rates.force) ? std::optional(std::move(rates)) : std::nullopt;
}

} // namespace wrc
