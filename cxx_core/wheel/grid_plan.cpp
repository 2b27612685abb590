#include "wheel/grid_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "patches/constants.hpp"
#include "wheel/constants.hpp"

namespace wrc {
namespace {

/// Both in one plane; the weights of both count.
ContactPatch joined(const ContactPatch& one, const ContactPatch& other) {
  ContactPatch both = one.deepest >= other.deepest ? one : other;
  const auto mean = [&](double of_one, double of_other) {
    return (one.weight * of_one + other.weight * of_other) / (one.weight + other.weight);
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
  both.weight = one.weight + other.weight;
  both.contact_first = first.contact_first;
  both.angle_first = first.angle_first;
  both.contact_last = last.contact_last;
  both.angle_last = last.angle_last;
  return both;
}

/// In the vertical convention the patches near the main one are one: they have the same plane.
ContactPatches in_one_plane(const ContactPatches& found, std::optional<double>& left_out_s) {
  const ContactPatch main = found.patches[found.main];
  ContactPatch all = main;
  for (const ContactPatch& patch : found.patches) {
    const double apart = std::max(patch.y_first - main.y_last, main.y_first - patch.y_last);
    if (apart > one_grid_distance ||
        std::abs(patch.angle_unturned - main.angle_unturned) > same_plane_angle) {
      left_out_s = patch.deepest_s;
    } else if (patch.deepest_y != main.deepest_y) {
      all = joined(all, patch);
    }
  }
  all.limit_first = -std::numeric_limits<double>::infinity();
  all.limit_last = std::numeric_limits<double>::infinity();
  return {{all}, {}, 0};
}

/// Which patches interact, and where they lie in their mean plane; none if none do.
void set_interaction(GridSolution& solution, const ContactPatches& found, Interaction which) {
  PatchInteraction interaction;
  bool any = false;
  double across = 0.0;
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    Patch& patch = solution.patches[k];
    const Vector3 origin = patch.frame.origin;
    if (k > 0) {
      const Vector3 step = origin - solution.patches[k - 1].frame.origin;
      across += std::hypot(step.y, step.z);
    }
    interaction.places.push_back({across, origin.x});
    for (std::size_t l = 0; l < solution.patches.size(); ++l) {
      const double weight = found.coupling_weight(k, l, which);
      interaction.coupling_weight.push_back(weight);
      if (k != l) {
        any = any || weight > 0.0;
        patch.coupling_weight = std::max(patch.coupling_weight, weight);
      }
    }
  }
  if (any) {
    solution.interaction = std::move(interaction);
  }
}

PlaneArea potential_area(const Patch& patch, const RailSurface& rail) {
  const PlaneArea area = area_of(patch.penetration, rail, patch.frame).widened(penetration_margin);
  return within_limits(area, patch.penetration, rail, patch.frame);
}

} // namespace

const PatchElements& GridChoice::nearest(const ContactPatch& penetration) const {
  return *std::ranges::min_element(elements_, {}, [&](const PatchElements& one) {
    return std::abs(one.mean_y - penetration.mean_y);
  });
}

Grid GridChoice::grid_of(const ContactPatch& penetration, const PlaneArea& area) const {
  if (elements_.empty()) {
    return grid_over(area, counts_.lateral, counts_.longitudinal);
  }
  const PatchElements& elements = nearest(penetration);
  return grid_with_sizes(area, elements.lateral_step, elements.longitudinal_step, elements.middle);
}

GridChoice GridChoice::coarser(double times) const {
  GridChoice result = *this;
  for (PatchElements& elements : result.elements_) {
    elements.lateral_step *= times;
    elements.longitudinal_step *= times;
  }
  return result;
}

int affordable_iterations(double elements, double limit) {
  const double work = most_work * std::max(1.0, limit / default_element_limit);
  return static_cast<int>(std::clamp(work / std::max(1.0, elements), 1.0, most_work));
}

GridSolution plan_patches(const RailSurface& rail, const SideEquilibrium& equilibrium,
                          const WheelRequest& request, double depth) {
  GridSolution solution;
  solution.elements = request.elements;
  solution.depth = depth;
  ContactPatches found = find_contact_patches(equilibrium.scan, depth, request.joining_distance);
  if (request.gap == GapConvention::vertical) {
    found = in_one_plane(found, solution.left_out_s);
  }
  for (const ContactPatch& penetration : found.patches) {
    Patch& patch = solution.patches.emplace_back();
    patch.penetration = penetration;
    // Through the weighted mean point on the rail.
    const Vector3 origin{penetration.mean_x, penetration.mean_y,
                         rail.graph().at_lateral(penetration.mean_y).height};
    patch.frame = request.gap == GapConvention::tangent
                      ? tangent_frame(origin, penetration.angle)
                      : vertical_frame(origin, Rotation(equilibrium.pose));
  }
  solution.main = found.main;
  set_interaction(solution, found, request.interaction);
  solution.links = std::move(found.links);
  return solution;
}

std::vector<ExpectedContact> expected_contacts(const GridSolution& patches, const RailSurface& rail,
                                               const ContactScan& scan) {
  const auto samples = locus_samples(scan, patches.depth);
  std::vector<ExpectedContact> contacts;
  for (const Patch& patch : patches.patches) {
    contacts.push_back(
        expected_contact(patch.penetration, patch.frame, potential_area(patch, rail), samples));
  }
  return contacts;
}

double set_grids(GridSolution& solution, const RailSurface& rail, const GridChoice& grids,
                 double limit) {
  std::vector<PlaneArea> areas;
  for (const Patch& patch : solution.patches) {
    areas.push_back(potential_area(patch, rail));
  }
  const auto count_of = [&](const GridChoice& choice) {
    double count = 0.0;
    for (std::size_t k = 0; k < areas.size(); ++k) {
      count += static_cast<double>(
          choice.grid_of(solution.patches[k].penetration, areas[k]).element_count());
    }
    return count;
  };
  const double wanted = count_of(grids);
  GridChoice choice = grids;
  double count = wanted;
  for (int round = 0; grids.by_size() && count > limit && round < coarsening_rounds; ++round) {
    choice = choice.coarser(std::max(std::sqrt(count / limit), least_coarsening));
    count = count_of(choice);
  }
  for (std::size_t k = 0; k < areas.size(); ++k) {
    solution.patches[k].grid = choice.grid_of(solution.patches[k].penetration, areas[k]);
  }
  return wanted;
}

} // namespace wrc
