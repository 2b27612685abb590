#include "wheel/grid_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc {
namespace {

/// In the vertical convention all that lies within these limits of the main patch shares its grid.
constexpr double same_plane_angle = 0.2;
constexpr double same_plane_distance = 20.0; // mm
/// Room around a patch's penetration, as a share of it: the scan knows its ends by parabolas
/// between nodes only.
constexpr double penetration_margin = 0.05;

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
  both.angle_unturned = both.angle = mean(one.angle_unturned, other.angle_unturned);
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
void GridPlanner::join_in_one_plane(GridPlan& plan) const {
  const ContactPatch main = plan.found.patches[plan.found.main];
  ContactPatch all = main;
  for (const ContactPatch& patch : plan.found.patches) {
    const double apart = std::max(patch.y_first - main.y_last, main.y_first - patch.y_last);
    if (apart > same_plane_distance ||
        std::abs(patch.angle_unturned - main.angle_unturned) > same_plane_angle) {
      plan.left_out_s = patch.deepest_s;
    } else if (patch.deepest_y != main.deepest_y) {
      all = joined(all, patch);
    }
  }
  all.limit_first = -std::numeric_limits<double>::infinity();
  all.limit_last = std::numeric_limits<double>::infinity();
  plan.found = {{all}, {}, 0};
}

/// The plane of a patch: through its weighted mean place on the rail.
ContactFrame GridPlanner::frame_of(const ContactPatch& patch) const {
  const Vector3 origin{patch.mean_x, patch.mean_y, rail_.graph().at_lateral(patch.mean_y).height};
  return gap_ == GapConvention::tangent ? tangent_frame(origin, patch.angle)
                                        : vertical_frame(origin, Rotation(equilibrium_.pose));
}

GridPlan GridPlanner::plan(double depth) const {
  GridPlan plan;
  plan.depth = depth;
  plan.found = find_contact_patches(equilibrium_.scan, depth, joining_distance_);
  if (gap_ == GapConvention::vertical) {
    join_in_one_plane(plan);
  }
  for (const ContactPatch& patch : plan.found.patches) {
    const ContactFrame frame = frame_of(patch);
    const PlaneArea area = area_of(patch, rail_, frame).widened(penetration_margin);
    plan.patches.push_back({patch, frame, within_limits(area, patch, rail_, frame)});
  }
  return plan;
}

} // namespace wrc
