#include "scene/missed_contact.hpp"

#include <cmath>
#include <optional>

#include "mechanics/displacement_bound.hpp"
#include "mechanics/displacement_operator.hpp"
#include "remesh/undeformed_distance.hpp"

namespace wrc {
namespace {

/// Overlap beyond the area, in largest displacements, that counts as contact left out ...
constexpr double missed_overlap = 1e-4;
/// ... and the room given to it across, mm: the distance of the scan's nodes.
constexpr double missed_margin = 0.5;

/// What the pressures of the other patches displace at a place of one, as far as they are felt.
double displaced_by_others(const Trial& trial, std::size_t patch, double combined_modulus,
                           Elements elements, double longitudinal, double lateral) {
  if (!trial.interaction) {
    return 0.0;
  }
  const PatchInteraction& interaction = *trial.interaction;
  const std::size_t count = trial.patches.size();
  const PatchInteraction::Place& here = interaction.places[patch];
  double sum = 0.0;
  for (std::size_t l = 0; l < count; ++l) {
    const double closeness = interaction.closeness[patch * count + l];
    const PatchInteraction::Place& there = interaction.places[l];
    const PatchTrial& other = trial.patches[l];
    if (l != patch && closeness > 0.0 && !other.no_contact()) {
      sum += closeness * displacement_at(other.grid, other.pressure, combined_modulus,
                                         longitudinal + here.longitudinal - there.longitudinal,
                                         lateral + here.lateral - there.lateral, elements);
    }
  }
  return sum;
}

} // namespace

bool add_missed_contact(const WheelSurface& wheel, const RailSurface& rail,
                        const SideEquilibrium& equilibrium, const SidePlanner& planner,
                        double combined_modulus, Elements elements, const Trial& trial,
                        SidePlan& plan) {
  const PosedPair pair{wheel, rail, equilibrium.pose, equilibrium.vertical - trial.depth};
  bool missed = false;
  for (std::size_t k = 0; k < trial.patches.size(); ++k) {
    const PatchTrial& patch = trial.patches[k];
    std::optional<DisplacementBound> bound;
    double largest_displacement = 0.0;
    PlaneArea larger = patch.area;
    bool missed_here = false;
    for (const DistanceSample& sample : equilibrium.scan.samples) {
      const Vector3 wheel_place = sample.wheel.position;
      const double penetration = trial.depth - (sample.distance + equilibrium.vertical);
      if (penetration <= 0.0 || wheel_place.y < patch.place.y_first ||
          wheel_place.y > patch.place.y_last) {
        continue;
      }
      const Vector3 place = Vector3{wheel_place.x, wheel_place.y, wheel_place.z - sample.distance} -
                            patch.frame.origin;
      const double lateral = dot(place, patch.frame.lateral);
      const double longitudinal = dot(place, patch.frame.longitudinal);
      if (lateral >= patch.area.lateral_first && lateral <= patch.area.lateral_last &&
          longitudinal >= patch.area.longitudinal_first &&
          longitudinal <= patch.area.longitudinal_last) {
        continue;
      }
      const SurfacePlace surfaces = surfaces_at(pair, patch.frame, longitudinal, lateral);
      if (!surfaces.on_rail || !surfaces.on_wheel) {
        continue;
      }
      if (!bound) {
        bound.emplace(patch.grid, patch.pressure, combined_modulus);
        largest_displacement =
            bound->at(patch.contact.centroid_longitudinal, patch.contact.centroid_lateral);
      }
      const double overlap =
          patch.share * trial.approach - dot(surfaces.wheel - surfaces.rail, patch.frame.normal);
      const double limit = missed_overlap * largest_displacement;
      if (overlap - bound->at(longitudinal, lateral) <= limit ||
          overlap - bound->closer_at(longitudinal, lateral) <= limit) {
        continue;
      }
      const double displacement = displacement_at(patch.grid, patch.pressure, combined_modulus,
                                                  longitudinal, lateral, elements);
      if (overlap - displacement > limit &&
          overlap - displacement -
                  displaced_by_others(trial, k, combined_modulus, elements, longitudinal, lateral) >
              limit) {
        missed_here = true;
        const double half_length = std::sqrt(2.0 * penetration / sample.wheel.normal_curvature);
        larger.include({lateral - missed_margin, lateral + missed_margin,
                        longitudinal - half_length, longitudinal + half_length});
      }
    }
    if (missed_here) {
      const PlaneArea within = planner.limited(larger, plan.patches[k]);
      const bool grows = within.width() > plan.patches[k].area.width() ||
                         within.length() > plan.patches[k].area.length();
      plan.patches[k].area = within;
      missed = missed || grows;
    }
  }
  return missed;
}

} // namespace wrc
