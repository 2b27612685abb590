#include "results/contact_damage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "damage/constants.hpp"
#include "mechanics/cascade.hpp"
#include "records/wheel_result.hpp"
#include "remesh/constants.hpp"
#include "remesh/undeformed_distance.hpp"
#include "results/constants.hpp"

namespace wrc {
namespace {

bool has_tractions(const PatchResult& patch) {
  return patch.creep && !patch.creep->traction_x.empty();
}

/// Tractions on the elements of normal contact: their ratio to the pressures of their own, coarser
/// grid, times the pressures here.
std::vector<double> on_elements_of_pressure(const PatchResult& patch,
                                            std::span<const double> traction, double sign) {
  const CreepResult& creep = *patch.creep;
  std::vector<double> pressure;
  std::vector<double> result;
  interpolate(creep.grid, creep.pressure, patch.grid, pressure);
  interpolate(creep.grid, traction, patch.grid, result);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] *= pressure[i] > 0.0 ? sign * patch.pressure[i] / pressure[i] : 0.0;
  }
  return result;
}

Wear wear_of_patch(const PatchResult& patch, const DamageRequest& request) {
  const CreepResult& creep = *patch.creep;
  return wear_of({creep.grid, creep.pressure, creep.traction_x, creep.traction_y, creep.slip_x,
                  creep.slip_y, creep.friction, creep.slip_speed, creep.power_per_speed},
                 request.law);
}

/// Where the rows of one of a patch's grids lie, through its centre of pressure.
RowPlaces places_of_rows(const WheelDetails& wheel, const PatchResult& patch, const Grid& grid) {
  RowPlaces places;
  const PosedPair pair = wheel.pair();
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const SurfacePlace surface =
        surfaces_at(pair, patch.frame, patch.contact.centroid_longitudinal, grid.lateral(row));
    double t_rail = 0.0;
    double v_rail = 0.0;
    wheel.rail->to_profile_frame(surface.rail.y, surface.rail.z, t_rail, v_rail);
    places.s_wheel.push_back(surface.wheel_lateral);
    places.t_rail.push_back(t_rail);
  }
  return places;
}

bool has_groove(const PatchResult& patch, const DamageRequest& request) {
  return request.groove && patch.parts.empty() && !patch.pressure.empty();
}

/// Normals of a row are inclined to that of its patch, along which distances are longer.
std::array<std::vector<double>, 2> groove_of(const PatchResult& patch) {
  std::array<std::vector<double>, 2> depth = patch.groove.depth;
  for (std::vector<double>& of_body : depth) {
    of_body.resize(patch.grid.lateral_count, 0.0);
    for (std::size_t row = 0; row < patch.row_scales.size(); ++row) {
      of_body[row] *= std::pow(patch.row_scales[row], 1.0 / scale_by_inclination);
    }
  }
  return depth;
}

/// Takes back what follows from the largest pressure, which an end of a body leaves without a
/// bound.
void take_back_peaks(ContactDamage& damage) {
  damage.stress.reset();
  if (damage.wear) {
    damage.wear->depth.reset();
  }
  if (damage.fatigue) {
    damage.fatigue->pressure_ratio.reset();
    damage.fatigue->surface_index.reset();
  }
}

/// `pressure_error`: relative.
ContactDamage damage_of(const PatchResult& patch, const DamageRequest& request,
                        double pressure_error) {
  ContactDamage damage;
  if (request.stress && !patch.pressure.empty() && !patch.is_unbounded) {
    damage.stress = stresses_below(patch, request).greatest();
    damage.stress->error_estimate += pressure_error;
  }
  if (request.wear && patch.creep) {
    const CreepResult& creep = *patch.creep;
    WearTotals& wear = damage.wear.emplace();
    wear.tgamma = -(creep.longitudinal_force * creep.creepages.longitudinal +
                    creep.lateral_force * creep.creepages.lateral);
    wear.tgamma_with_spin = creep.power_per_speed;
    if (has_tractions(patch)) {
      const Wear found = wear_of_patch(patch, request);
      wear.volume = found.volume;
      wear.depth = *std::max_element(found.depth.begin(), found.depth.end());
    }
  }
  if (has_groove(patch, request)) {
    const auto [wheel, rail] = groove_of(patch);
    double& deepest = damage.groove_depth.emplace(0.0);
    for (std::size_t row = 0; row < wheel.size(); ++row) {
      deepest = std::max(deepest, wheel[row] + rail[row]);
    }
  }
  if (request.fatigue && patch.creep && patch.normal_force > 0.0) {
    const CreepResult& creep = *patch.creep;
    Fatigue& fatigue = damage.fatigue.emplace();
    fatigue.friction =
        std::hypot(creep.longitudinal_force, creep.lateral_force) / norm(patch.force);
    // The limits, and the index, are those of elastic pressures.
    const double pressure = patch.elastic_peak.value_or(patch.pmax);
    fatigue.pressure_ratio = pressure / request.shear_yield;
    fatigue.limits = shakedown_limits(std::min(fatigue.friction, map_friction));
    fatigue.surface_index = surface_fatigue_index(fatigue.friction, pressure, request.shear_yield);
    fatigue.rail_damage = rail_damage(creep.power_per_speed);
  }
  return damage;
}

/// The worst, and what is worn together.
void add(ContactDamage& whole, const ContactDamage& part) {
  if (part.stress && (!whole.stress || part.stress->von_mises > whole.stress->von_mises)) {
    whole.stress = part.stress;
  }
  if (part.wear) {
    WearTotals& wear = whole.wear ? *whole.wear : whole.wear.emplace();
    wear.tgamma += part.wear->tgamma;
    wear.tgamma_with_spin += part.wear->tgamma_with_spin;
    if (part.wear->volume) {
      wear.volume = wear.volume.value_or(0.0) + *part.wear->volume;
      wear.depth = std::max(wear.depth.value_or(0.0), *part.wear->depth);
    }
  }
  if (part.groove_depth) {
    whole.groove_depth = std::max(whole.groove_depth.value_or(0.0), *part.groove_depth);
  }
  if (part.fatigue &&
      (!whole.fatigue || part.fatigue->surface_index > whole.fatigue->surface_index)) {
    whole.fatigue = part.fatigue;
  }
}

} // namespace

SubsurfaceStress stresses_below(const PatchResult& patch, const DamageRequest& request) {
  if (!has_tractions(patch)) {
    return {{patch.grid, patch.pressure, {}, {}}, request.poisson};
  }
  const CreepResult& creep = *patch.creep;
  const double sign = request.of_wheel ? 1.0 : -1.0;
  std::vector<double> x;
  std::vector<double> y;
  if (creep.pressure_change > 0.0) {
    for (const auto& [from, to] :
         {std::pair{&creep.traction_x, &x}, std::pair{&creep.traction_y, &y}}) {
      std::transform(from->begin(), from->end(), std::back_inserter(*to),
                     [&](double value) { return sign * value; });
    }
    return {{creep.grid, creep.pressure, x, y}, request.poisson};
  }
  x = on_elements_of_pressure(patch, creep.traction_x, sign);
  y = on_elements_of_pressure(patch, creep.traction_y, sign);
  return {{patch.grid, patch.pressure, x, y}, request.poisson};
}

void find_damage(WheelResult& wheel, const DamageRequest& request) {
  wheel.details.damage = request;
  wheel.damage.emplace();
  const double pressure_error =
      wheel.error_estimate.value_or(std::numeric_limits<double>::quiet_NaN());
  for (PatchResult& patch : wheel.patches) {
    if (patch.parts.empty()) {
      patch.damage = damage_of(patch, request, pressure_error);
    } else {
      patch.damage.emplace();
    }
    for (PatchResult& part : patch.parts) {
      part.damage = damage_of(part, request, pressure_error);
      add(*patch.damage, *part.damage);
      if (part.is_unbounded) {
        take_back_peaks(*part.damage);
      }
    }
    add(*wheel.damage, *patch.damage);
    if (patch.is_unbounded) {
      take_back_peaks(*patch.damage);
    }
  }
  if (wheel.is_unbounded) {
    take_back_peaks(*wheel.damage);
  }
}

StressSection stress_section(const WheelDetails& wheel, const PatchResult& patch) {
  if (!patch.damage || !patch.damage->stress || !patch.parts.empty()) {
    return {};
  }
  const DamageRequest& request = wheel.damage;
  const Grid& grid = patch.grid;
  // Around the contact: of the patch's own grid the part under pressure.
  const double length = std::max(patch.semi_axis_longitudinal, 0.5 * grid.longitudinal_step);
  const double width = std::max(patch.semi_axis_lateral, 0.5 * grid.lateral_step);
  const double middle =
      request.section_across ? patch.contact.centroid_lateral : patch.contact.centroid_longitudinal;
  const double half = section_half_length * (request.section_across ? width : length);
  std::vector<double> places(section_places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = middle + half * (2.0 * static_cast<double>(i) / (section_places - 1.0) - 1.0);
  }
  std::vector<double> depths(section_depths);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    depths[i] = section_depth * std::min(length, width) * (static_cast<double>(i) + 0.5) /
                static_cast<double>(section_depths);
  }
  const SubsurfaceStress stress = stresses_below(patch, request);
  const GreatestStress& greatest = *patch.damage->stress;
  return request.section_across ? stress.across(places, greatest.x, depths)
                                : stress.along(places, greatest.y, depths);
}

Wear patch_wear(const WheelDetails& wheel, const PatchResult& patch) {
  if (!wheel.damage.wear || !patch.parts.empty() || !has_tractions(patch)) {
    return {};
  }
  return wear_of_patch(patch, wheel.damage);
}

RowPlaces wear_places(const WheelDetails& wheel, const PatchResult& patch) {
  return wheel.damage.wear && patch.parts.empty() && has_tractions(patch)
             ? places_of_rows(wheel, patch, patch.creep->grid)
             : RowPlaces();
}

std::array<std::vector<double>, 2> patch_groove(const WheelDetails& wheel,
                                                const PatchResult& patch) {
  return has_groove(patch, wheel.damage) ? groove_of(patch) : std::array<std::vector<double>, 2>();
}

RowPlaces groove_places(const WheelDetails& wheel, const PatchResult& patch) {
  return has_groove(patch, wheel.damage) ? places_of_rows(wheel, patch, patch.grid) : RowPlaces();
}

} // namespace wrc
