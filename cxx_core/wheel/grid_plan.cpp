#include "wheel/grid_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "accuracy/model_error.hpp"
#include "base/error.hpp"
#include "patches/constants.hpp"
#include "remesh/bend_along.hpp"
#include "remesh/mean_curve.hpp"
#include "remesh/undeformed_distance.hpp"
#include "wheel/constants.hpp"
#include "wheel/wheel_warnings.hpp"

namespace wrc {
namespace {

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

/// Of each patch, the largest weight of its interactions with others.
void set_largest_weights(const PatchInteraction& interaction, std::span<Patch> patches) {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    patches[k].coupling_weight = 0.0;
    for (std::size_t l = 0; l < patches.size(); ++l) {
      if (l != k) {
        patches[k].coupling_weight = std::max(patches[k].coupling_weight,
                                              interaction.coupling_weight[k * patches.size() + l]);
      }
    }
  }
}

/// Which patches interact, and where they lie in their mean plane; none if none do.
void set_interaction(GridSolution& solution, const ContactPatches& found, Interaction which) {
  PatchInteraction interaction;
  double across = 0.0;
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    const Vector3 origin = solution.patches[k].frame.origin;
    if (k > 0) {
      const Vector3 step = origin - solution.patches[k - 1].frame.origin;
      across += std::hypot(step.y, step.z);
    }
    interaction.places.push_back({across, origin.x});
    for (std::size_t l = 0; l < solution.patches.size(); ++l) {
      interaction.coupling_weight.push_back(found.coupling_weight(k, l, which));
    }
  }
  set_largest_weights(interaction, solution.patches);
  if (std::ranges::any_of(solution.patches,
                          [](const Patch& patch) { return patch.coupling_weight > 0.0; })) {
    solution.interaction = std::move(interaction);
  }
}

PlaneArea potential_area(const Patch& patch, const RailSurface& rail) {
  const PlaneArea area = area_of(patch.penetration, rail, patch.frame).widened(penetration_margin);
  return within_limits(area, patch.penetration, rail, patch.frame);
}

/// Patches interact over the arc between them, and by the cosine of the angle between them, as the
/// rows of one patch do.
void lay_along_arcs(PatchInteraction& interaction, std::span<Patch> patches, Interaction which) {
  double across = 0.0;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const ContactFrame& frame = patches[k].frame;
    if (k > 0) {
      const Vector3 step = frame.origin - patches[k - 1].frame.origin;
      const double half =
          0.5 * (angle_of_reference(frame) - angle_of_reference(patches[k - 1].frame));
      const double over_chord = half != 0.0 ? half / std::sin(half) : 1.0;
      across += over_chord * std::hypot(step.y, step.z);
    }
    interaction.places[k].lateral = across;
    for (std::size_t l = 0; l < patches.size(); ++l) {
      const double angle = angle_of_reference(frame) - angle_of_reference(patches[l].frame);
      double& weight = interaction.coupling_weight[k * patches.size() + l];
      weight = (which == Interaction::all ? 1.0 : weight) * std::max(0.0, std::cos(angle));
    }
  }
  set_largest_weights(interaction, patches);
}

/// Of each patch, how much of its curve is taken. It follows the deviation of the rail's angle from
/// the plane's, weighted with the penetration, so that a lobe that is born counts for nothing at
/// first. Patches that are close count in proportion to their links, so that they have the same
/// deviation when they become one.
std::vector<double> curve_shares(const GridSolution& solution, const WheelRequest& request) {
  const std::vector<Patch>& patches = solution.patches;
  std::vector<double> shares;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    double weights = 0.0;
    double squares = 0.0;
    const auto count = [&](const ContactPatch& penetration, double close) {
      const double apart = penetration.angle_unturned - patches[k].frame.angle();
      weights += close * penetration.weight;
      squares += close * penetration.weight *
                 (penetration.deviation * penetration.deviation + apart * apart);
    };
    count(patches[k].penetration, 1.0);
    double close = 1.0;
    for (std::size_t l = k; l > 0; --l) {
      close *= solution.links[l - 1];
      count(patches[l - 1].penetration, close);
    }
    close = 1.0;
    for (std::size_t l = k + 1; l < patches.size(); ++l) {
      close *= solution.links[l - 1];
      count(patches[l].penetration, close);
    }
    shares.push_back(request.curved == CurvedChoice::yes
                         ? 1.0
                         : curve_share(turn_over_deviation * std::sqrt(squares / weights),
                                       request.accuracy, request.accuracy_of,
                                       request.position_is_prescribed()));
  }
  return shares;
}

/// The plane of patches that share one, from the mean of their origins, as that of one patch that
/// they join to: a part of the curve's heights depends on where heights count from.
ContactFrame common_frame(std::span<const Patch> patches, const RailSurface& rail) {
  if (patches.size() == 1) {
    return patches.front().frame;
  }
  double weights = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (const Patch& patch : patches) {
    weights += patch.penetration.weight;
    x += patch.penetration.weight * patch.penetration.mean_x;
    y += patch.penetration.weight * patch.penetration.mean_y;
  }
  return patches.front().frame.seen_from(
      {x / weights, y / weights, height_near(rail, x / weights, y / weights)});
}

/// A stretch of the plane as one of the rows.
PlaneArea along_rows(PlaneArea area, const ContactFrame& frame) {
  if (frame.curve) {
    area.lateral_first = frame.curve->arc_over(area.lateral_first);
    area.lateral_last = frame.curve->arc_over(area.lateral_last);
  }
  return area;
}

/// Where a fraction of the plane's width lies in the width of the rows: the same place, so that
/// rows do not move with the ends of the area.
double share_along_rows(double share, const PlaneArea& area, const ContactFrame& frame) {
  if (!frame.curve) {
    return share;
  }
  const PlaneArea rows = along_rows(area, frame);
  const double place = frame.curve->arc_over(area.lateral_first + share * area.width());
  return (place - rows.lateral_first) / rows.width();
}

} // namespace

const PatchElements& GridChoice::nearest(const ContactPatch& penetration) const {
  return *std::ranges::min_element(elements_, {}, [&](const PatchElements& one) {
    return std::hypot(one.mean_x - penetration.mean_x, one.mean_y - penetration.mean_y);
  });
}

Grid GridChoice::grid_of(const Patch& patch, const PlaneArea& area) const {
  const PlaneArea rows = along_rows(area, patch.frame);
  if (elements_.empty()) {
    return grid_over(rows, counts_.lateral, counts_.longitudinal);
  }
  const PatchElements& elements = nearest(patch.penetration);
  return grid_with_sizes(rows, elements.lateral_step, elements.longitudinal_step,
                         share_along_rows(elements.middle, area, patch.frame));
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
  ContactPatches found = find_contact_patches(equilibrium.scans(), depth, request);
  if (request.gap == GapConvention::vertical) {
    found = in_one_plane(found, solution.left_out_s);
  }
  for (const ContactPatch& penetration : found.patches) {
    Patch& patch = solution.patches.emplace_back();
    patch.penetration = penetration;
    // Through the weighted mean point on the rail.
    const Vector3 origin{penetration.mean_x, penetration.mean_y,
                         height_near(rail, penetration.mean_x, penetration.mean_y)};
    patch.frame = request.gap == GapConvention::tangent
                      ? tangent_frame(origin, penetration.angle, penetration.rise)
                      : vertical_frame(origin, Rotation(equilibrium.pose));
  }
  solution.main = found.main;
  set_interaction(solution, found, request.interaction);
  solution.links = std::move(found.links);
  return solution;
}

void set_bends(GridSolution& patches, const PosedPair& pair) {
  if (WheelAndRail{pair.wheel, pair.rail}.is_prismatic_along(along_track)) {
    return;
  }
  const WheelSurface round = pair.wheel.as_round();
  const RailSurface prism = pair.rail.as_prism();
  const PosedPair plain{round, prism, pair.pose, pair.vertical};
  for (Patch& patch : patches.patches) {
    const Grid grid = grid_over(potential_area(patch, pair.rail), bend_rows, bend_columns);
    patch.bend = bend_along(grid, sample_undeformed_distance(pair, patch.frame, grid),
                            sample_undeformed_distance(plain, patch.frame, grid));
  }
}

std::vector<ExpectedContact> expected_contacts(const GridSolution& patches, const RailSurface& rail,
                                               const SideEquilibrium& equilibrium) {
  const std::vector<const ContactScan*> scans = equilibrium.scans();
  std::vector<std::vector<patch_finding::LocusSample<double>>> samples;
  for (const ContactScan* scan : scans) {
    const double depth = patches.depth - behind(*scan, *scans.front());
    samples.emplace_back();
    if (depth > 0.0) {
      samples.back() = locus_samples(*scan, depth);
    }
  }
  std::vector<ExpectedContact> contacts;
  for (const Patch& patch : patches.patches) {
    contacts.push_back(expected_contact(patch.penetration, patch.frame, potential_area(patch, rail),
                                        samples[patch.penetration.scan]));
    contacts.back().bend = patch.bend;
  }
  return contacts;
}

void set_curves(GridSolution& solution, const PosedPair& pair, const WheelRequest& request) {
  std::vector<Patch>& patches = solution.patches;
  const std::vector<double> shares = curve_shares(solution, request);
  for (std::size_t first = 0, last = 0; first < patches.size(); first = last) {
    last = first + 1;
    while (last < patches.size() && patches[last].penetration.shares_plane_with_previous) {
      ++last;
    }
    const ContactFrame frame = common_frame({patches.begin() + static_cast<std::ptrdiff_t>(first),
                                             patches.begin() + static_cast<std::ptrdiff_t>(last)},
                                            pair.rail);
    PlaneArea all = PlaneArea::empty();
    for (std::size_t k = first; k < last; ++k) {
      PlaneArea area = potential_area(patches[k], pair.rail);
      const double apart = dot(patches[k].frame.origin - frame.origin, frame.lateral);
      area.lateral_first += apart;
      area.lateral_last += apart;
      all.include(area);
    }
    const double share = *std::max_element(shares.begin() + static_cast<std::ptrdiff_t>(first),
                                           shares.begin() + static_cast<std::ptrdiff_t>(last));
    const MeanCurve found = mean_curve(pair, frame, all.lateral_first, all.lateral_last, share);
    if (!found.refusal.empty() && request.curved == CurvedChoice::yes) {
      throw_invalid_argument("solve.curved", "\"yes\"",
                             found.refusal + "; it must be \"no\" or \"auto\" here");
    }
    ContactFrame curved = frame;
    curved.curve = found.curve;
    for (std::size_t k = first; k < last; ++k) {
      patches[k].frame = curved.seen_from(patches[k].frame.origin);
    }
  }
  if (solution.interaction) {
    lay_along_arcs(*solution.interaction, patches, request.interaction);
  }
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
      count += static_cast<double>(choice.grid_of(solution.patches[k], areas[k]).element_count());
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
    solution.patches[k].grid = choice.grid_of(solution.patches[k], areas[k]);
  }
  return wanted;
}

bool outgrows_grid(const GridSolution& solution) {
  return std::ranges::any_of(solution.patches, [](const Patch& patch) {
    return patch.contact.touches_edge.any() && !reaches_neighbour(patch);
  });
}

} // namespace wrc
