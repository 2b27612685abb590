#include "derivatives/patch_rates.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "derivatives/gap_rates.hpp"
#include "mechanics/yielding.hpp"
#include "remesh/constants.hpp"
#include "remesh/met_distance.hpp"
#include "remesh/rail_normals.hpp"
#include "remesh/row_scales.hpp"

namespace wrc {
namespace {

using Fields = std::vector<std::vector<double>>;

std::vector<std::span<const double>> spans_of(const Fields& fields) {
  return {fields.begin(), fields.end()};
}

/// Calls `visit` with row, column and index of each element under pressure.
template <class Visit> void for_each_loaded(const LoadedPatch& patch, Visit visit) {
  const std::size_t columns = patch.grid.longitudinal_count;
  for (std::size_t element = 0; element < patch.pressure.size(); ++element) {
    if (patch.pressure[element] > 0.0) {
      visit(element / columns, element % columns, element);
    }
  }
}

/// Change of a field from element to element, per mm; across those at which it is `known`.
template <class Known>
double slope_at(std::span<const double> field, std::size_t element, std::size_t place,
                std::size_t count, std::size_t stride, double step, const Known& known) {
  const std::size_t behind = place > 0 && known(element - stride) ? element - stride : element;
  const std::size_t ahead =
      place + 1 < count && known(element + stride) ? element + stride : element;
  const std::size_t steps = (ahead - behind) / stride;
  return steps > 0 ? (field[ahead] - field[behind]) / (step * static_cast<double>(steps)) : 0.0;
}

/// Adds the motion of elements to the rates of a patch's gaps: their undeformed distance changes
/// with their position, the displacement at them with their size.
void add_motion_of_elements(const LoadedPatch& patch, const ByMotion<ElementMotion>& motions,
                            const ContactStiffness::Displacements& displacements,
                            Fields& gap_rates) {
  const Grid& grid = patch.grid;
  const std::span<const double> distance = patch.undeformed_distance;
  const auto known = [distance](std::size_t element) { return is_met(distance[element]); };
  for (std::size_t element = 0; element < distance.size(); ++element) {
    if (!(patch.pressure[element] > 0.0)) {
      continue;
    }
    const std::size_t column = element % grid.longitudinal_count;
    const std::size_t row = element / grid.longitudinal_count;
    const double along = slope_at(distance, element, column, grid.longitudinal_count, 1,
                                  grid.longitudinal_step, known);
    const double across = slope_at(distance, element, row, grid.lateral_count,
                                   grid.longitudinal_count, grid.lateral_step, known);
    for (std::size_t motion = 0; motion < motion_count; ++motion) {
      const ElementMotion& of = motions[motion];
      gap_rates[motion][element] +=
          (of.along + of.longitudinal_growth * grid.longitudinal(column)) * along +
          (of.across + of.lateral_growth * grid.lateral(row)) * across +
          of.longitudinal_growth * displacements.displacement[element] +
          (of.lateral_growth - of.longitudinal_growth) * displacements.by_lateral_step[element];
      if (!displacements.by_place.empty()) {
        gap_rates[motion][element] += of.across * displacements.by_place[element] +
                                      of.lateral_growth * displacements.by_spread[element];
      }
    }
  }
}

/// A plane that turns measures distances along another direction: those between the points P_w and
/// P_r of a ray from the plane change with its angle by -d/ds (P_w^2 - P_r^2)/2.
void add_turning_plane(const LoadedPatch& patch, const RailNormals& rail, Fields& gap_rates) {
  const Grid& grid = patch.grid;
  std::vector<double> squares;
  for (std::size_t element = 0; element < patch.undeformed_distance.size(); ++element) {
    const double height = dot(rail.arm(element / grid.longitudinal_count, 0), patch.frame.normal);
    const double distance = patch.undeformed_distance[element];
    squares.push_back(distance * (height + 0.5 * distance));
  }
  for_each_loaded(patch, [&](std::size_t row, std::size_t /*column*/, std::size_t element) {
    if (squares.empty()) {
      return;
    }
    const double slope = slope_at(
        squares, element, row, grid.lateral_count, grid.longitudinal_count, grid.lateral_step,
        [&](std::size_t i) { return is_met(patch.undeformed_distance[i]); });
    for (std::size_t motion = 0; motion < motion_count; ++motion) {
      gap_rates[motion][element] -= patch.angle_rates[motion] * slope;
    }
  });
}

/// How the force of moving elements of a plane that turns changes, and its moment about the frame's
/// origin.
ContactForce rate_of_force(const LoadedPatch& patch, const RailNormals& rail,
                           std::span<const double> pressure_rate, const ElementMotion& motion,
                           double angle_rate) {
  const Grid& grid = patch.grid;
  const double growth = motion.longitudinal_growth + motion.lateral_growth;
  ContactForce rate;
  for_each_loaded(patch, [&](std::size_t row, std::size_t column, std::size_t element) {
    const double p = patch.pressure[element];
    const Vector3& direction = rail.direction(row, column);
    const Vector3 arm = rail.arm(row, column);
    const double across = motion.across + motion.lateral_growth * grid.lateral(row);
    // A row that moves along a curve turns, too.
    const double turning =
        patch.frame.curve ? across * patch.frame.curve->curvature(grid.lateral(row)) : angle_rate;
    const double height =
        patch.frame.curve ? rail.height(row, column) : dot(arm, patch.frame.normal);
    const RailNormals::Rates moved = rail.rates(
        row, column, motion.along + motion.longitudinal_growth * grid.longitudinal(column),
        across - turning * height);
    const double turned = turning * dot(direction, rail.row(row).lateral);
    const Vector3 force =
        (pressure_rate[element] + (growth + turned) * p) * direction + p * moved.direction;
    rate.force = rate.force + force;
    rate.moment = rate.moment + cross(arm, force) + p * cross(moved.arm, direction);
  });
  return {grid.element_area() * rate.force, grid.element_area() * rate.moment};
}

double rate_of_sum(const LoadedPatch& patch, std::span<const double> pressure_rate,
                   const ElementMotion& motion) {
  double rate = 0.0;
  for_each_loaded(patch, [&](std::size_t /*row*/, std::size_t /*column*/, std::size_t element) {
    rate += pressure_rate[element] +
            (motion.longitudinal_growth + motion.lateral_growth) * patch.pressure[element];
  });
  return patch.grid.element_area() * rate;
}

/// Elements that follow the centre of pressure and the root mean square distances from it, from
/// rates of pressures of elements that move otherwise.
ElementMotion following(const LoadedPatch& patch, std::span<const double> pressure_rate,
                        const ElementMotion& motion) {
  double force = 0.0;
  double force_rate = 0.0;
  std::array<double, 2> first{}, first_rate{}, second{}, second_rate{};
  for_each_loaded(patch, [&](std::size_t row, std::size_t column, std::size_t element) {
    const double p = patch.pressure[element];
    const double rate = pressure_rate[element];
    const std::array<double, 2> places{patch.grid.longitudinal(column), patch.grid.lateral(row)};
    force += p;
    force_rate += rate;
    for (std::size_t i = 0; i < 2; ++i) {
      const double place = places[i];
      first[i] += p * place;
      first_rate[i] += rate * place;
      second[i] += p * place * place;
      second_rate[i] += rate * place * place;
    }
  });
  std::array<double, 2> centre_rate{}, growth{};
  std::array<double, 2> centre{};
  for (std::size_t i = 0; i < 2; ++i) {
    centre[i] = first[i] / force;
    centre_rate[i] = (first_rate[i] - centre[i] * force_rate) / force;
    const double square = second[i] / force - centre[i] * centre[i];
    const double square_rate = (second_rate[i] - second[i] / force * force_rate) / force -
                               2.0 * centre[i] * centre_rate[i];
    growth[i] = square > 0.0 ? 0.5 * square_rate / square : 0.0;
  }
  // Rates of the pressures over fixed elements; the elements' own motion is added.
  return {motion.along + centre_rate[0] - growth[0] * centre[0],
          motion.across + centre_rate[1] - growth[1] * centre[1],
          motion.longitudinal_growth + growth[0], motion.lateral_growth + growth[1]};
}

/// How the scales of a patch's rows (remesh/row_scales.hpp) change as its plane turns and as
/// elements move over wheel and rail, which both take them along.
class ScaleRates {
public:
  ScaleRates(const LoadedPatch& patch, const RailNormals& rail,
             std::span<const RigidMotion> motions, const Vector3& centre)
      : patch_(patch) {
    const Vector3 arm = patch.frame.origin - centre;
    for (std::size_t motion = 0; motion < motion_count; ++motion) {
      const RigidMotion& of_wheel = motions[motion];
      across_[motion] =
          dot(of_wheel.translation + cross(of_wheel.rotation, arm), patch.frame.lateral);
    }
    const std::size_t rows = patch.row_scales.size();
    for (std::size_t row = 0; row < rows; ++row) {
      by_place_.push_back(slope_at(patch.row_scales, row, row, rows, 1, patch.grid.lateral_step,
                                   [](std::size_t) { return true; }));
      by_turn_.push_back(scale_by_inclination * patch.row_scales[row] * rail.inclination(row));
    }
  }

  /// Rate of the scale of a row.
  [[nodiscard]] double of(std::size_t row, std::size_t motion,
                          const ElementMotion& elements) const {
    return by_turn_[row] * patch_.angle_rates[motion] +
           by_place_[row] * (elements.across + elements.lateral_growth * patch_.grid.lateral(row) -
                             0.5 * across_[motion]);
  }

  /// From the rates of distances to those that the solver sees.
  void scale_distances(std::size_t motion, const ElementMotion& elements,
                       std::vector<double>& rates) const {
    change(rates, patch_.undeformed_distance, [&](std::size_t row, double rate, double distance) {
      return patch_.row_scales[row] * rate + of(row, motion, elements) * distance;
    });
  }
  /// From the rates of the solver's pressures to those of the patch's.
  void scale_pressures(std::size_t motion, const ElementMotion& elements,
                       std::vector<double>& rates) const {
    change(rates, patch_.pressure, [&](std::size_t row, double rate, double pressure) {
      return patch_.row_scales[row] * rate +
             of(row, motion, elements) / patch_.row_scales[row] * pressure;
    });
  }

private:
  template <class Change>
  void change(std::vector<double>& rates, std::span<const double> field,
              const Change& changed) const {
    if (patch_.row_scales.empty() || field.empty()) {
      return;
    }
    for (std::size_t i = 0; i < rates.size(); ++i) {
      rates[i] = changed(i / patch_.grid.longitudinal_count, rates[i], field[i]);
    }
  }

  const LoadedPatch& patch_;
  ByMotion<double> across_; ///< of the wheel, in the plane
  std::vector<double> by_place_;
  std::vector<double> by_turn_;
};

/// Rates of all pressures: first of elements that stay or go along the rail with the contact, then
/// of elements that follow it.
class RateSolver {
public:
  RateSolver(std::span<const LoadedPatch> patches, const SensitivityRequest& request,
             ContactStiffness& solver, const std::vector<Fields>& gap_rates,
             std::span<const ScaleRates> scales)
      : patches_(patches), tolerance_(request.tolerance), solver_(solver), gap_rates_(gap_rates),
        scales_(scales), elements_(patches.size()), pressures_(patches.size()) {
    follows_ = request.influence == nullptr || patches.size() == 1;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      for (std::size_t motion = 0; motion < motion_count; ++motion) {
        elements_[k][motion].along = patches[k].along_rates[motion];
      }
      displacements_.push_back(displacements_of(k));
      follows_ = follows_ && !patches[k].undeformed_distance.empty();
      if (patches[k].grid_motion) {
        elements_[k] = *patches[k].grid_motion;
      }
    }
  }

  void solve(WheelSensitivity& result) {
    solve_once(result);
    const auto moves_otherwise = [](const LoadedPatch& patch) {
      return patch.grid_motion.has_value();
    };
    if (follows_ && !std::ranges::all_of(patches_, moves_otherwise)) {
      for (std::size_t k = 0; k < patches_.size(); ++k) {
        if (moves_otherwise(patches_[k])) {
          continue;
        }
        for (std::size_t motion = 0; motion < motion_count; ++motion) {
          elements_[k][motion] =
              following(patches_[k], pressures_[k][motion], elements_[k][motion]);
        }
      }
      solve_once(result);
    }
  }

  [[nodiscard]] ContactForce of_force(std::size_t patch, std::size_t motion,
                                      const RailNormals& rail) const {
    return rate_of_force(patches_[patch], rail, pressures_[patch][motion], elements_[patch][motion],
                         patches_[patch].angle_rates[motion]);
  }
  [[nodiscard]] double of_sum(std::size_t patch, std::size_t motion) const {
    return rate_of_sum(patches_[patch], pressures_[patch][motion], elements_[patch][motion]);
  }
  [[nodiscard]] const ByMotion<ElementMotion>& elements(std::size_t patch) const {
    return elements_[patch];
  }
  ByMotion<std::vector<double>> pressures(std::size_t patch) {
    return std::move(pressures_[patch]);
  }

private:
  [[nodiscard]] ContactStiffness::Displacements displacements_of(std::size_t k) const {
    const LoadedPatch& patch = patches_[k];
    auto found =
        solver_.displacements_of(k, over_scales(patch.grid, patch.row_scales, patch.pressure));
    found.displacement = over_scales(patch.grid, patch.row_scales, found.displacement);
    found.by_lateral_step = over_scales(patch.grid, patch.row_scales, found.by_lateral_step);
    return found;
  }

  void solve_once(WheelSensitivity& result) {
    std::vector<Fields> gaps = gap_rates_;
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      add_motion_of_elements(patches_[k], elements_[k], displacements_[k], gaps[k]);
    }
    for (std::size_t motion = 0; motion < motion_count; ++motion) {
      Fields closing(patches_.size());
      for (std::size_t k = 0; k < patches_.size(); ++k) {
        closing[k] = gaps[k][motion];
        scales_[k].scale_distances(motion, elements_[k][motion], closing[k]);
        std::ranges::transform(closing[k], closing[k].begin(), std::negate<>());
      }
      Fields pressure;
      const StiffnessOutcome outcome = solver_.solve(spans_of(closing), pressure, tolerance_);
      result.iterations += outcome.iterations;
      if (outcome.stop_reason != StopReason::tolerance_met) {
        result.stop_reason = outcome.stop_reason;
      }
      for (std::size_t k = 0; k < patches_.size(); ++k) {
        scales_[k].scale_pressures(motion, elements_[k][motion], pressure[k]);
        pressures_[k][motion] = std::move(pressure[k]);
      }
    }
  }

  std::span<const LoadedPatch> patches_;
  double tolerance_;
  ContactStiffness& solver_;
  const std::vector<Fields>& gap_rates_; ///< by patch and motion, of elements that stay
  std::span<const ScaleRates> scales_;
  std::vector<ByMotion<ElementMotion>> elements_;
  std::vector<ByMotion<std::vector<double>>> pressures_;
  std::vector<ContactStiffness::Displacements> displacements_;
  bool follows_ = true;
};

/// What the pressures displace more at each other counts as a change of the gaps; of steel that
/// yields also what its excess displaces, times its slope.
void add_influence_rates(std::span<const LoadedPatch> patches, const SensitivityRequest& request,
                         std::vector<Fields>& gap_rates) {
  const ByMotion<PatchInfluence*>& changes = request.influence_rates;
  bool any = false;
  for (std::size_t motion = 0; motion < motion_count; ++motion) {
    any = any || changes[motion] != nullptr;
  }
  if (!any) {
    return;
  }
  std::vector<Fields> displacing(1 + request.yielding.size());
  std::vector<YieldTerms> terms;
  for (const LoadedPatch& patch : patches) {
    displacing[0].push_back(over_scales(patch.grid, patch.row_scales, patch.pressure));
    terms.emplace_back(patch.grid, displacing[0].back(), patch.row_scales, request.yielding);
    for (std::size_t b = 0; b < request.yielding.size(); ++b) {
      displacing[b + 1].push_back(terms.back().excess[b]);
    }
  }
  Fields displacement(patches.size());
  for (std::size_t motion = 0; motion < motion_count; ++motion) {
    for (std::size_t b = 0; changes[motion] != nullptr && b < displacing.size(); ++b) {
      for (std::size_t k = 0; k < patches.size(); ++k) {
        displacement[k].assign(patches[k].pressure.size(), 0.0);
      }
      changes[motion]->add(displacing[b], displacement);
      for (std::size_t k = 0; k < patches.size(); ++k) {
        std::vector<double>& rates = gap_rates[k][motion];
        const std::vector<double> added =
            over_scales(patches[k].grid, patches[k].row_scales, displacement[k]);
        for (std::size_t i = 0; i < rates.size(); ++i) {
          rates[i] += b == 0 ? added[i] : terms[k].slope[b - 1][i] * added[i];
        }
      }
    }
  }
}

} // namespace

ForceRates operator+(const ForceRates& a, const ForceRates& b) {
  return by_motion([&](std::size_t motion) { return a[motion] + b[motion]; });
}

WheelSensitivity compute_patch_rates(const PosedPair& pair, std::span<const LoadedPatch> patches,
                                     const SensitivityRequest& request, ContactStiffness& solver) {
  std::vector<SolvedPatch> solved;
  std::vector<std::vector<double>> angles;
  for (const LoadedPatch& patch : patches) {
    angles.push_back(row_angles(patch.frame, patch.grid));
  }
  for (std::size_t k = 0; k < patches.size(); ++k) {
    solved.push_back(
        {patches[k].grid, patches[k].pressure, request.elements, angles[k], patches[k].row_scales});
  }
  solver.set_contact(solved, request.combined_modulus, request.influence, request.yielding);

  const auto motions = all_motions(pair.pose.yaw);
  const Vector3 centre{0.0, pair.pose.lateral, pair.vertical};
  std::vector<Fields> gap_rates(patches.size());
  std::vector<RailNormals> rails;
  std::vector<ScaleRates> scales;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    compute_gap_rates(pair, patches[k].frame, patches[k].grid, patches[k].pressure, motions,
                      gap_rates[k]);
    const RailNormals& rail = rails.emplace_back(pair.rail, patches[k].frame, patches[k].grid);
    if (!patches[k].frame.curve) {
      add_turning_plane(patches[k], rail, gap_rates[k]);
    }
    scales.emplace_back(patches[k], rail, motions, centre);
  }
  add_influence_rates(patches, request, gap_rates);
  WheelSensitivity result;
  RateSolver rates(patches, request, solver, gap_rates, scales);
  rates.solve(result);

  for (std::size_t k = 0; k < patches.size(); ++k) {
    const LoadedPatch& patch = patches[k];
    const RailNormals& rail = rails[k];
    const Vector3 arm = patch.frame.origin - centre;
    const auto about_centre = [&](const ContactForce& about_origin) {
      return WheelForce{about_origin.force, about_origin.moment + cross(arm, about_origin.force)};
    };
    const WheelForce force = about_centre(rail.force(patch.pressure));
    result.force = result.force + force;
    PatchSensitivity sensitivity;
    sensitivity.normal_force = force_of(patch.grid, patch.pressure);
    const auto rated = [&](std::size_t motion) {
      WheelForce rate = about_centre(rates.of_force(k, motion, rail));
      rate.moment = rate.moment - cross(motions[motion].translation, force.force);
      return rate;
    };
    sensitivity.force_rates = by_motion(rated);
    sensitivity.normal_force_rates =
        by_motion([&](std::size_t motion) { return rates.of_sum(k, motion); });
    sensitivity.elements = rates.elements(k);
    sensitivity.pressure_rates = rates.pressures(k);
    result.force_rates = result.force_rates + sensitivity.force_rates;
    result.patches.push_back(std::move(sensitivity));
  }
  return result;
}

void make_symmetric(ForceRates& rates, const WheelForce& force, const Pose& pose) {
  const Vector3 roll_axis = roll_motion(pose.yaw).rotation;
  const Vector3 roll_axis_by_yaw{-roll_axis.y, roll_axis.x, 0.0};
  const Vector3 up{0.0, 0.0, 1.0};
  std::array<std::array<double, motion_count>, motion_count> along{};
  for (std::size_t j = 0; j < motion_count; ++j) {
    along[0][j] = rates[j].force.y;
    along[1][j] = rates[j].force.z;
    along[2][j] = dot(rates[j].moment, roll_axis);
    along[3][j] = rates[j].moment.z;
  }
  along[2][3] += dot(force.moment, roll_axis_by_yaw);
  // Of each pair, the motion that presses the wheel less into the rail is kept: height, then
  // lateral position and yaw with the height following the load, at last the roll.
  constexpr std::size_t height = 1;
  constexpr std::array<int, motion_count> order{1, 0, 3, 2};
  const double stiffness = along[height][height];
  const auto symmetric = [&](std::size_t i, std::size_t j) {
    const auto [column, row] = order[i] < order[j] ? std::pair(i, j) : std::pair(j, i);
    if (column == height || stiffness == 0.0) {
      return along[row][column];
    }
    const double at_load =
        along[row][column] - along[row][height] * along[height][column] / stiffness;
    return at_load + along[row][height] * along[column][height] / stiffness;
  };
  for (std::size_t j = 0; j < motion_count; ++j) {
    const auto change = [&](std::size_t i) { return symmetric(i, j) - along[i][j]; };
    rates[j].force.y += change(0);
    rates[j].force.z += change(1);
    // Not about the axle, about which a surface of revolution takes no moment.
    rates[j].moment = rates[j].moment + change(2) * roll_axis +
                      change(3) * (up - std::tan(pose.roll) * roll_axis_by_yaw);
  }
}

std::optional<CondensedRates> condense_at_vertical_load(const ForceRates& rates) {
  const double stiffness = rates.vertical.force.z;
  if (stiffness == 0.0) {
    return std::nullopt;
  }
  const auto condensed = [&](const WheelForce& by_motion) {
    const double vertical = -by_motion.force.z / stiffness;
    CondensedRates::Motion motion{vertical, by_motion + vertical * rates.vertical};
    motion.wheel.force.z = 0.0;
    return motion;
  };
  return CondensedRates{condensed(rates.lateral), condensed(rates.roll), condensed(rates.yaw)};
}

} // namespace wrc
