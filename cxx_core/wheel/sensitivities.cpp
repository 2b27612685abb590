#include "wheel/sensitivities.hpp"

#include <algorithm>
#include <functional>

#include "remesh/gap_rates.hpp"

namespace wrc {
namespace {

constexpr std::size_t motion_count = 4; // not a tuning constant
using MotionValues = std::array<double, motion_count>;
using Fields = std::vector<std::vector<double>>;

/// Seen in the mirror y -> -y, of a motion that keeps its sign or changes it.
WheelForce mirrored_wheel(const WheelForce& a, double motion_sign) {
  return {{motion_sign * a.force.x, -motion_sign * a.force.y, motion_sign * a.force.z},
          {-motion_sign * a.moment.x, motion_sign * a.moment.y, -motion_sign * a.moment.z}};
}

double sum_of_products(std::span<const double> first, std::span<const double> second) {
  double sum = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    sum += first[i] * second[i];
  }
  return sum;
}

std::vector<std::span<const double>> spans_of(const Fields& fields) {
  return {fields.begin(), fields.end()};
}

/// What pressures are weighted with: for their force, and for its first moments in the plane.
constexpr std::size_t weight_count = 3; // not a tuning constant
using Weighted = std::array<double, weight_count>;

Weighted weights_at(const Grid& grid, std::size_t element) {
  return {1.0, grid.longitudinal(element % grid.longitudinal_count),
          grid.lateral(element / grid.longitudinal_count)};
}

Fields weight_fields(const Grid& grid) {
  Fields fields(weight_count, std::vector<double>(grid.element_count()));
  for (std::size_t element = 0; element < grid.element_count(); ++element) {
    const Weighted weights = weights_at(grid, element);
    for (std::size_t i = 0; i < weight_count; ++i) {
      fields[i][element] = weights[i];
    }
  }
  return fields;
}

/// Force and moments of a field of pressures.
Weighted weighted_sums(const Grid& grid, std::span<const double> pressure) {
  Weighted sums{};
  for (std::size_t element = 0; element < pressure.size(); ++element) {
    const Weighted weights = weights_at(grid, element);
    for (std::size_t i = 0; i < weight_count; ++i) {
      sums[i] += grid.element_area() * pressure[element] * weights[i];
    }
  }
  return sums;
}

/// Force and moment about a centre from those in the plane.
WheelForce about_centre(const ContactFrame& frame, const Vector3& centre, const Weighted& sums) {
  const Vector3 place =
      sums[0] * (frame.origin - centre) + sums[1] * frame.longitudinal + sums[2] * frame.lateral;
  return {sums[0] * frame.normal, cross(place, frame.normal)};
}

/// Rates of a patch's force and of its moments in the plane, by motion.
using WeightedRates = std::array<Weighted, motion_count>;

class RateSolver {
public:
  RateSolver(std::span<const LoadedPatch> patches, const SensitivityRequest& request,
             ContactStiffness& solver, const std::vector<Fields>& gap_rates)
      : patches_(patches), request_(request), solver_(solver), gap_rates_(gap_rates),
        rates_(patches.size()) {}

  std::vector<WeightedRates> solve(WheelSensitivity& result) {
    if (request_.influence != nullptr && patches_.size() > 1) {
      solve_by_motion(result);
    } else {
      solve_by_weight(result);
    }
    return std::move(rates_);
  }

private:
  Fields solve_for(const Fields& displacement, WheelSensitivity& result) {
    Fields pressure;
    const StiffnessOutcome outcome =
        solver_.solve(spans_of(displacement), pressure, request_.tolerance);
    result.iterations += outcome.iterations;
    if (outcome.stop_reason != StopReason::tolerance_met) {
      result.stop_reason = outcome.stop_reason;
    }
    return pressure;
  }

  /// Patches that do not interact: one solution gives the forces' rates by all motions, two more
  /// those of the moments.
  void solve_by_weight(WheelSensitivity& result) {
    std::vector<Fields> weights;
    for (const LoadedPatch& patch : patches_) {
      weights.push_back(weight_fields(patch.grid));
    }
    for (std::size_t i = 0; i < (request_.moments ? weight_count : 1); ++i) {
      Fields one;
      for (Fields& of_patch : weights) {
        one.push_back(std::move(of_patch[i]));
      }
      const Fields answer = solve_for(one, result);
      for (std::size_t k = 0; k < patches_.size(); ++k) {
        for (std::size_t motion = 0; motion < motion_count; ++motion) {
          rates_[k][motion][i] =
              -patches_[k].grid.element_area() * sum_of_products(answer[k], gap_rates_[k][motion]);
        }
      }
    }
  }

  /// Otherwise one solution for each motion gives the rates of all pressures.
  void solve_by_motion(WheelSensitivity& result) {
    for (std::size_t motion = 0; motion < motion_count; ++motion) {
      Fields change;
      for (const Fields& of_patch : gap_rates_) {
        change.push_back(of_patch[motion]);
      }
      const Fields pressure = solve_for(change, result);
      for (std::size_t k = 0; k < patches_.size(); ++k) {
        const Weighted sums = weighted_sums(patches_[k].grid, pressure[k]);
        std::transform(sums.begin(), sums.end(), rates_[k][motion].begin(), std::negate<>());
      }
    }
  }

  std::span<const LoadedPatch> patches_;
  const SensitivityRequest& request_;
  ContactStiffness& solver_;
  const std::vector<Fields>& gap_rates_; ///< by patch and motion
  std::vector<WeightedRates> rates_;
};

/// What the pressures displace more at each other counts as a change of the gaps.
void add_influence_rates(std::span<const LoadedPatch> patches, const SensitivityRequest& request,
                         std::vector<Fields>& gap_rates) {
  const ByMotion<PatchInfluence*>& rates = request.influence_rates;
  const std::array<PatchInfluence*, motion_count> changes{rates.lateral, rates.vertical, rates.roll,
                                                          rates.yaw};
  Fields pressure;
  Fields displacement(patches.size());
  for (std::size_t motion = 0; motion < motion_count; ++motion) {
    if (changes[motion] == nullptr) {
      continue;
    }
    for (std::size_t k = 0; k < patches.size(); ++k) {
      if (pressure.size() < patches.size()) {
        pressure.emplace_back(patches[k].pressure.begin(), patches[k].pressure.end());
      }
      displacement[k] = std::move(gap_rates[k][motion]);
    }
    changes[motion]->add(pressure, displacement);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      gap_rates[k][motion] = std::move(displacement[k]);
    }
  }
}

} // namespace

ForceRates operator+(const ForceRates& a, const ForceRates& b) {
  return {a.lateral + b.lateral, a.vertical + b.vertical, a.roll + b.roll, a.yaw + b.yaw};
}

ForceRates mirrored(const ForceRates& rates) {
  return {mirrored_wheel(rates.lateral, -1.0), mirrored_wheel(rates.vertical, 1.0),
          mirrored_wheel(rates.roll, -1.0), mirrored_wheel(rates.yaw, -1.0)};
}

WheelSensitivity compute_sensitivities(const PosedPair& pair, std::span<const LoadedPatch> patches,
                                       const SensitivityRequest& request,
                                       ContactStiffness& solver) {
  std::vector<SolvedPatch> solved;
  for (const LoadedPatch& patch : patches) {
    solved.push_back({patch.grid, patch.pressure, request.elements});
  }
  solver.set_contact(solved, request.combined_modulus, request.influence);

  const std::array<RigidMotion, motion_count> motions{lateral_motion(), vertical_motion(),
                                                      roll_motion(pair.pose.yaw), yaw_motion()};
  const Vector3 centre{0.0, pair.pose.lateral, pair.vertical};
  std::vector<Fields> gap_rates(patches.size());
  for (std::size_t k = 0; k < patches.size(); ++k) {
    compute_gap_rates(pair, patches[k].frame, patches[k].grid, patches[k].pressure, motions,
                      gap_rates[k]);
  }
  add_influence_rates(patches, request, gap_rates);
  WheelSensitivity result;
  const std::vector<WeightedRates> rates =
      RateSolver(patches, request, solver, gap_rates).solve(result);

  for (std::size_t k = 0; k < patches.size(); ++k) {
    const LoadedPatch& patch = patches[k];
    const Weighted sums = weighted_sums(patch.grid, patch.pressure);
    PatchSensitivity sensitivity;
    sensitivity.normal_force = sums[0];
    const WheelForce force = about_centre(patch.frame, centre, sums);
    result.force = result.force + force;
    // A plane that turns by one rad about its centre of pressure.
    ContactFrame turned = patch.frame;
    turned.normal = -1.0 * patch.frame.lateral;
    WheelForce turning = about_centre(turned, centre, sums);
    const auto fixed = [&](std::size_t motion) {
      WheelForce change = about_centre(patch.frame, centre, rates[k][motion]);
      change.moment = change.moment - cross(motions[motion].translation, force.force);
      return change;
    };
    sensitivity.normal_force_rates = {rates[k][0][0], rates[k][1][0], rates[k][2][0],
                                      rates[k][3][0]};
    sensitivity.fixed_plane = {fixed(0), fixed(1), fixed(2), fixed(3)};
    const ByMotion<double>& by = patch.angle_rates;
    sensitivity.turning_plane = {by.lateral * turning, by.vertical * turning, by.roll * turning,
                                 by.yaw * turning};
    if (!request.moments) {
      for (ForceRates* of_patch : {&sensitivity.fixed_plane, &sensitivity.turning_plane}) {
        for (WheelForce* by_motion :
             {&of_patch->lateral, &of_patch->vertical, &of_patch->roll, &of_patch->yaw}) {
          by_motion->moment = {};
        }
      }
    }
    result.fixed_planes = result.fixed_planes + sensitivity.fixed_plane;
    result.turning_planes = result.turning_planes + sensitivity.turning_plane;
    result.patches.push_back(sensitivity);
  }
  return result;
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
