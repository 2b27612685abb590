#include "scene/side_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc {
namespace {

/// Hertzian contact takes 1/sqrt(2) of the width of virtual penetration.
constexpr double contact_share = 0.7;
/// Room around the place where the last contact lay, in widths of virtual penetration.
constexpr double memory_margin = 0.05;
/// Columns stay as they are if their number differs by no more than this share from what is wanted.
constexpr double kept_columns = 0.2;
/// In the vertical convention all that lies within these limits of the main patch shares its grid.
constexpr double same_plane_angle = 0.2;
constexpr double same_plane_distance = 20.0; // mm
/// Room left around the contact found on a grid, in that grid's elements.
constexpr double margin_elements = 1.5;
/// Room around a patch's penetration, as a share of it.
constexpr double penetration_margin = 0.05;
/// An area narrower than this share of what it was has been left outside its territory.
constexpr double lost_share = 1e-3;

/// Both in one plane; the weights of both count.
ContactPatch joined(const ContactPatch& one, const ContactPatch& other) {
  ContactPatch both = one.deepest >= other.deepest ? one : other;
  const auto mean = [&](double of_one, double of_other) {
    return (one.share * of_one + other.share * of_other) / (one.share + other.share);
  };
  const ContactPatch& first = one.y_first <= other.y_first ? one : other;
  const ContactPatch& last = one.y_last >= other.y_last ? one : other;
  both.y_first = first.y_first;
  both.y_last = last.y_last;
  both.x_first = std::min(one.x_first, other.x_first);
  both.x_last = std::max(one.x_last, other.x_last);
  both.half_length = std::max(one.half_length, other.half_length);
  both.own_angle = both.angle = mean(one.own_angle, other.own_angle);
  both.mean_x = mean(one.mean_x, other.mean_x);
  both.mean_y = mean(one.mean_y, other.mean_y);
  both.mean_s = mean(one.mean_s, other.mean_s);
  both.share = one.share + other.share;
  both.contact_first = first.contact_first;
  both.angle_first = first.angle_first;
  both.contact_last = last.contact_last;
  both.angle_last = last.angle_last;
  return both;
}

} // namespace

/// In the vertical convention the patches near the main one are one: they have the same plane.
void SidePlanner::join_in_one_plane(SidePlan& plan) const {
  const ContactPatch main = plan.found.patches[plan.found.main];
  ContactPatch all = main;
  for (const ContactPatch& patch : plan.found.patches) {
    const double apart = std::max(patch.y_first - main.y_last, main.y_first - patch.y_last);
    if (apart > same_plane_distance ||
        std::abs(patch.own_angle - main.own_angle) > same_plane_angle) {
      plan.left_out_s = patch.deepest_s;
    } else if (patch.deepest_y != main.deepest_y) {
      all = joined(all, patch);
    }
  }
  all.territory_first = -std::numeric_limits<double>::infinity();
  all.territory_last = std::numeric_limits<double>::infinity();
  plan.found = {{all}, {}, 0};
}

/// The plane of a patch: through its weighted mean place on the rail.
ContactFrame SidePlanner::frame_of(const ContactPatch& patch) const {
  const Vector3 origin{patch.mean_x, patch.mean_y, rail_.graph().at_lateral(patch.mean_y).height};
  return gap_ == GapConvention::tangent ? tangent_frame(origin, patch.angle)
                                        : vertical_frame(origin, Rotation(equilibrium_.pose));
}

PlaneArea SidePlanner::carried_over(const PlaneArea& area, const ContactFrame& from,
                                    const ContactFrame& to) const {
  PlaneArea result = PlaneArea::empty();
  for (const double lateral : {area.lateral_first, area.lateral_last}) {
    for (const double longitudinal : {area.longitudinal_first, area.longitudinal_last}) {
      const Vector3 from_origin = from.to_track(longitudinal, lateral, 0.0) - to.origin;
      result.include(dot(from_origin, to.lateral), dot(from_origin, to.longitudinal));
    }
  }
  return result;
}

PlaneArea SidePlanner::limited(const PlaneArea& area, const PatchPlan& plan) const {
  const PlaneArea within = within_territory(area, plan.place, rail_, plan.frame);
  if (within.width() > lost_share * area.width()) {
    return within;
  }
  return within_territory(area_of(plan.place, rail_, plan.frame).widened(penetration_margin),
                          plan.place, rail_, plan.frame);
}

void SidePlanner::plan_penetration(PatchPlan& patch, const Resolution& resolution) const {
  const PlaneArea penetrated = area_of(patch.place, rail_, patch.frame);
  patch.area = limited(penetrated.widened(penetration_margin), patch);
  patch.mesh = {contact_share * penetrated.width() / resolution.lateral,
                contact_share * penetrated.length() / resolution.longitudinal,
                {}};
}

SidePlan SidePlanner::empty_plan(double depth) const {
  SidePlan plan;
  plan.depth = depth;
  plan.found = patches_at(depth);
  if (gap_ == GapConvention::vertical) {
    join_in_one_plane(plan);
  }
  for (const ContactPatch& patch : plan.found.patches) {
    PatchPlan& made = plan.patches.emplace_back();
    made.place = patch;
    made.frame = frame_of(patch);
  }
  return plan;
}

SidePlan SidePlanner::first_plan(double depth, const Resolution& resolution) const {
  SidePlan plan = empty_plan(depth);
  for (PatchPlan& patch : plan.patches) {
    plan_penetration(patch, resolution);
  }
  return plan;
}

SidePlan SidePlanner::remembered_plan(const SideMemory& memory, double depth) const {
  SidePlan plan = empty_plan(depth);
  for (std::size_t k = 0; k < plan.patches.size() && k < memory.patches.size(); ++k) {
    PatchPlan& patch = plan.patches[k];
    const SideMemory::Patch& last = memory.patches[k];
    const PlaneArea penetrated = area_of(patch.place, rail_, patch.frame);
    const double width = penetrated.width();
    const double length = penetrated.length();
    patch.mesh = {(last.lateral_last - last.lateral_first) * width / last.resolution.lateral,
                  (last.longitudinal_last - last.longitudinal_first) * length /
                      last.resolution.longitudinal,
                  {}};
    patch.area =
        limited({penetrated.lateral_first + (last.lateral_first - memory_margin) * width,
                 penetrated.lateral_first + (last.lateral_last + memory_margin) * width,
                 penetrated.longitudinal_first + (last.longitudinal_first - memory_margin) * length,
                 penetrated.longitudinal_first + (last.longitudinal_last + memory_margin) * length},
                patch);
  }
  return plan;
}

namespace {

/// A refinement close to a power of two is one: element aspect ratios then stay on their ladder.
double refinement_near(double ratio) {
  constexpr double close = 0.2; // octaves
  const double octaves = std::log2(ratio);
  return std::abs(octaves - std::round(octaves)) <= close ? std::exp2(std::round(octaves)) : ratio;
}

} // namespace

SidePlan SidePlanner::next_plan(const Trial& trial, double depth,
                                const std::vector<Resolution>& resolutions, double growth) const {
  SidePlan plan = empty_plan(depth);
  for (PatchPlan& patch : plan.patches) {
    const PatchTrial* last = trial.matching(patch.place);
    if (last == nullptr) {
      plan_penetration(patch, resolutions.front());
      continue;
    }
    const auto index = static_cast<std::size_t>(last - trial.patches.data());
    const auto area_around = [growth](const PatchTrial& found) {
      return found.touches_edge() ? found.grown(growth, 0.0) : found.contact_area(margin_elements);
    };
    PlaneArea area = carried_over(area_around(*last), last->frame, patch.frame);
    bool joined_others = false;
    for (const PatchTrial& other : trial.patches) {
      if (&other != last && !other.no_contact() && patch.place.holds(other.place)) {
        area.include(carried_over(area_around(other), other.frame, patch.frame));
        joined_others = true;
      }
    }
    patch.area = limited(area, patch);
    patch.mesh = last->mesh_across(resolutions[index]);
    const double columns = last->columns();
    if (!grid_is_given_ && !last->touches_edge() && !joined_others &&
        std::abs(resolutions[index].longitudinal - columns) <= kept_columns * columns) {
      // The same columns, so that what differs between both grids is due to the rows.
      const Grid& grid = last->grid;
      const double shift = last->frame.origin.x - patch.frame.origin.x;
      constexpr double rounding = 1e-6;
      patch.mesh.longitudinal_step = grid.longitudinal_step;
      patch.area.longitudinal_first =
          shift + grid.longitudinal_first - (0.5 - rounding) * grid.longitudinal_step;
      patch.area.longitudinal_last = shift + grid.longitudinal(grid.longitudinal_count - 1) +
                                     (0.5 - rounding) * grid.longitudinal_step;
      const double rows = resolutions[index].lateral / last->rows();
      patch.mesh.lateral_step = grid.lateral_step / refinement_near(rows);
    }
  }
  return plan;
}

} // namespace wrc
