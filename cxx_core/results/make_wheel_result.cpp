#include "results/make_wheel_result.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "accuracy/peak_section.hpp"
#include "base/error.hpp"
#include "geometry/first_touch.hpp"
#include "geometry/side_frame.hpp"
#include "models/hertz.hpp"
#include "results/combined_contact.hpp"
#include "results/constants.hpp"
#include "results/cut_contact.hpp"

namespace wrc {
namespace {

ContactPoint point_of(const ContactCandidate& candidate, const WheelSurface& wheel,
                      const RailSurface& rail, double vertical, const SideFrame& side) {
  ContactPoint point;
  const Vector3 position = candidate.wheel.position;
  const double rail_z = position.z - candidate.distance;
  point.x = position.x;
  point.y = side.mirrored_lateral(position.y);
  point.z = rail_z;
  point.angle = side.mirrored_lateral(candidate.rail_angle);
  point.s_wheel = candidate.wheel.lateral;
  point.w_wheel = candidate.wheel.height;
  point.wheel_angle = candidate.wheel.wheel_angle;
  rail.to_profile_frame(position.y, rail_z, point.t_rail, point.v_rail);
  point.rolling_radius = wheel.radius() + candidate.wheel.height;
  point.distance = candidate.distance + vertical;
  return point;
}

Vector3 position_of(const ContactPoint& point) {
  return {point.x, point.y, point.z};
}

PatchResult patch_of(Patch solved, const PosedPair& pair, double combined_modulus,
                     const SideFrame& side) {
  PatchResult result;
  Patch& patch = result;
  patch = std::move(solved);
  const PressureRegion& contact = patch.contact;
  result.pmax = contact.peak_pressure;
  result.pmax_element = contact.largest_element_pressure;
  result.plane_angle = side.mirrored_lateral(patch.frame.angle());
  result.reference = point_on(pair, patch.frame, 0.0, 0.0, side);
  result.centroid =
      point_on(pair, patch.frame, contact.centroid_longitudinal, contact.centroid_lateral, side);
  const Vector3 force = patch.contact_force.force;
  result.force = side.mirrored(force);
  result.angle =
      norm(force) > 0.0 ? std::atan2(-result.force.y, result.force.z) : result.plane_angle;
  const Vector3 arm = patch.frame.origin - side.mirrored(position_of(result.reference));
  result.moment = side.mirrored_moment(patch.contact_force.moment + cross(arm, force));
  result.semi_axis_longitudinal = contact.semi_axis_longitudinal;
  result.semi_axis_lateral = contact.semi_axis_lateral;
  if (contact.semi_axis_longitudinal > 0.0 && contact.semi_axis_lateral > 0.0) {
    const HertzBodies bodies =
        equivalent_hertz_bodies(contact.semi_axis_longitudinal, contact.semi_axis_lateral,
                                combined_modulus, patch.normal_force);
    result.radius_longitudinal = bodies.longitudinal_radius;
    result.radius_lateral = bodies.lateral_radius;
  }
  result.fill =
      static_cast<double>(contact.element_count) / static_cast<double>(patch.grid.element_count());
  result.lobes = patch.penetration.lobes;
  return result;
}

/// The patches of one plane.
PatchResult contact_of(std::span<Patch> patches, const PosedPair& pair, double combined_modulus,
                       const SideFrame& side) {
  if (patches.size() == 1) {
    return patch_of(std::move(patches.front()), pair, combined_modulus, side);
  }
  PatchResult result = patch_of(combined(patches, pair.rail), pair, combined_modulus, side);
  double under_pressure = 0.0;
  result.lobes = 0;
  for (Patch& patch : patches) {
    const PatchResult& part =
        result.parts.emplace_back(patch_of(std::move(patch), pair, combined_modulus, side));
    result.lobes += part.lobes;
    under_pressure +=
        part.fill * static_cast<double>(part.grid.element_count()) * part.grid.element_area();
  }
  result.fill = under_pressure /
                (static_cast<double>(result.grid.element_count()) * result.grid.element_area());
  return result;
}

/// The largest coupling weight of a run of patches to any other.
double weight_outside(const PatchInteraction& interaction, std::size_t first, std::size_t last) {
  const std::size_t count = interaction.places.size();
  double coupling_weight = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    for (std::size_t l = 0; l < count; ++l) {
      if (l < first || l >= last) {
        coupling_weight = std::max(coupling_weight, interaction.coupling_weight[k * count + l]);
      }
    }
  }
  return coupling_weight;
}

/// Force-weighted mean.
ContactPoint mean_point(const std::vector<PatchResult>& patches, double normal_force) {
  ContactPoint mean;
  for (const PatchResult& patch : patches) {
    const double weight = norm(patch.force) / normal_force;
    const ContactPoint& point = patch.centroid;
    mean.x += weight * point.x;
    mean.y += weight * point.y;
    mean.z += weight * point.z;
    mean.angle += weight * point.angle;
    mean.s_wheel += weight * point.s_wheel;
    mean.w_wheel += weight * point.w_wheel;
    mean.wheel_angle += weight * point.wheel_angle;
    mean.t_rail += weight * point.t_rail;
    mean.v_rail += weight * point.v_rail;
    mean.rolling_radius += weight * point.rolling_radius;
  }
  return mean;
}

/// The edge of a cut contact is an error of its own, whose warning takes the place of that of the
/// accuracy. `force_error`: of elements, without that of the largest pressure, which is not given.
void note_cut(const WheelSurface& wheel, const RailSurface& rail, double force_error,
              WheelResult& result) {
  const std::optional<ContactCut> cut = mark_cuts(result.patches, wheel, rail);
  if (!cut) {
    return;
  }
  result.meets_part_end =
      result.meets_part_end || !WheelAndRail{wheel, rail}.is_prismatic_along(along_track);
  if (result.validity) { // pressures of an approximate model have a bound
    for (PatchResult& patch : result.patches) {
      patch.is_unbounded = false;
    }
    result.warnings.push_back({WarningClass::profile_end,
                               "contact reaches " + cut->where + ", which the model leaves out"});
    return;
  }
  result.is_unbounded = result.is_cut = true;
  std::string estimate;
  if (result.error_estimate) {
    result.discretisation_error = std::hypot(force_error, cut->error);
    result.error_estimate = std::hypot(*result.discretisation_error, *result.model_error);
    estimate =
        ", depth and place with an estimated error of " + short_text_of(*result.error_estimate);
    std::erase_if(result.warnings,
                  [](const Warning& warning) { return warning.kind == WarningClass::accuracy; });
  }
  result.warnings.push_back(
      {WarningClass::profile_end,
       "contact reaches " + cut->where +
           ": pressures have no bound there, so pmax and what follows from it are not given" +
           estimate + ", and forces jump by about 1 % of the load as the contact passes"});
}

/// The largest pressure that a patch, or one of its parts, may have.
double bound_of(const PatchResult& patch) {
  double bound = patch.pmax + patch.peak_error;
  for (const PatchResult& part : patch.parts) {
    bound = std::max(bound, bound_of(part));
  }
  return bound;
}

/// The patch, or its part, of which this is largest.
const PatchResult& largest_of(std::span<const PatchResult> patches) {
  const PatchResult& largest = *std::ranges::max_element(patches, {}, bound_of);
  return largest.parts.empty() ? largest : largest_of(largest.parts);
}

void mark_largest(std::span<PatchResult> patches) {
  if (!patches.empty()) {
    PatchResult& largest = *std::ranges::max_element(patches, {}, bound_of);
    largest.is_unbounded = true;
    mark_largest(largest.parts);
  }
}

/// Where elements resolve less than half of the largest pressure, as where two edges meet, or where
/// it is that of a sharp kink, it grows with every element: the warnings of the accuracy and of the
/// kink say that it is not given.
void note_unresolved(WheelResult& result) {
  if (result.is_unbounded || result.patches.empty()) {
    return;
  }
  const PatchResult& largest = largest_of(result.patches);
  const double with_twice_the_elements =
      std::numbers::ln2 * growth_at_ridge(largest.ridge, result.details.request.combined_modulus);
  if (!(result.discretisation_error.value_or(0.0) > unresolved_peak) &&
      (largest.elastic_peak || !(with_twice_the_elements > unbounded_growth * largest.pmax))) {
    return;
  }
  result.is_unbounded = true;
  mark_largest(result.patches);
  const auto of_accuracy = [](const Warning& warning) {
    return warning.kind == WarningClass::accuracy || warning.kind == WarningClass::ridge;
  };
  auto why = std::ranges::find_if(result.warnings, of_accuracy);
  if (why == result.warnings.end()) { // with an accuracy of forces, which meet it
    why = result.warnings.insert(why,
                                 {WarningClass::ridge, "a profile has a kink inside the contact"});
  }
  why->text += "; pressures have no bound, or none that these elements show, so pmax and what "
               "follows from it are not given";
}

} // namespace

ContactPoint point_on(const PosedPair& pair, const ContactFrame& frame, double longitudinal,
                      double lateral, const SideFrame& side) {
  SurfacePlace surface = surfaces_at(pair, frame, longitudinal, lateral);
  if (!surface.on_rail) { // between the two ends of a gap: on the plane
    surface.rail = frame.to_track(longitudinal, lateral, 0.0);
    surface.rail_angle = frame.angle();
  }
  ContactPoint point;
  point.x = surface.rail.x;
  point.y = side.mirrored_lateral(surface.rail.y);
  point.z = surface.rail.z;
  point.angle = side.mirrored_lateral(surface.rail_angle);
  point.s_wheel = surface.wheel_lateral;
  point.w_wheel = surface.wheel_height;
  const Vector3 body =
      Rotation(pair.pose).to_body(surface.wheel - Vector3{0.0, pair.pose.lateral, pair.vertical});
  point.wheel_angle = std::atan2(body.x, -body.z);
  point.rolling_radius = pair.wheel.radius() + surface.wheel_height;
  pair.rail.to_profile_frame(surface.rail.y, surface.rail.z, point.t_rail, point.v_rail);
  return point;
}

WheelResult make_wheel_result(WheelSolution solution,
                              const std::shared_ptr<const WheelSurface>& wheel,
                              const std::shared_ptr<const RailSurface>& rail,
                              const SideEquilibrium& equilibrium, double mirror) {
  const SideFrame side(mirror);
  WheelResult result;
  result.vertical = equilibrium.vertical;
  const auto& candidates = equilibrium.scan.candidates;
  result.rigid_contact = point_of(candidates.front(), *wheel, *rail, equilibrium.vertical, side);
  for (std::size_t i = 1; i < equilibrium.near_count; ++i) {
    result.near_contacts.push_back(
        point_of(candidates[i], *wheel, *rail, equilibrium.vertical, side));
  }
  result.meets_part_end = candidates.front().at_part_end;
  if (candidates.front().at_profile_end) {
    result.warnings.push_back({WarningClass::profile_end,
                               "contact at the end of a profile, or where the rail turns upright"});
  }
  std::ranges::move(solution.warnings, std::back_inserter(result.warnings));
  if (std::optional<Warning> odd = warning_of_touch(*wheel, candidates.front())) {
    result.warnings.push_back(std::move(*odd));
  }
  result.details = {mirror,
                    equilibrium.pose,
                    solution.vertical,
                    solution.request,
                    std::move(solution.interaction),
                    solution.load,
                    {},
                    {},
                    wheel,
                    rail};
  result.iterations = solution.iterations;
  result.convolutions = solution.convolutions;
  result.solutions = solution.solutions;
  result.angle = result.rigid_contact.angle;
  result.solved = solution.solved;
  if (!solution.in_contact) {
    return result;
  }
  result.pmax = solution.peak_pressure;
  result.depth = solution.depth;
  result.discretisation_error = solution.discretisation_error;
  result.model_error = solution.model_error;
  result.error_estimate = solution.error_estimate();
  result.validity = solution.validity;
  result.stop_reason = solution.stop_reason;
  const PosedPair pair{*wheel, *rail, equilibrium.pose, solution.vertical};
  for (auto first = solution.patches.begin(); first != solution.patches.end();) {
    const auto last = std::find_if(first, solution.patches.end(), [first](const auto& patch) {
      return patch.plane != first->plane;
    });
    PatchResult& made = result.patches.emplace_back(
        contact_of({first, last}, pair, solution.request.combined_modulus, side));
    if (result.details.interaction) {
      const auto index_of = [&solution](auto patch) {
        return static_cast<std::size_t>(patch - solution.patches.begin());
      };
      made.coupling_weight =
          weight_outside(*result.details.interaction, index_of(first), index_of(last));
    }
    first = last;
    result.pmax_element = std::max(result.pmax_element, made.pmax_element);
    result.normal_force += norm(made.force);
    result.force = result.force + made.force;
    const Vector3 arm = position_of(made.reference) - position_of(result.patches.front().reference);
    result.moment = result.moment + made.moment + cross(arm, made.force);
  }
  result.angle = result.patches.front().angle;
  result.approach = result.patches.front().approach;
  note_cut(*wheel, *rail, solution.force_error, result);
  if (!solution.request.grid) { // else the elements are the caller's
    note_unresolved(result);
  }
  if (result.solved) {
    result.centroid = mean_point(result.patches, result.normal_force);
  }
  return result;
}

} // namespace wrc
