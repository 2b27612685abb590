#include "wheel/sensitivities.hpp"

#include <cmath>

#include "remesh/gap_rates.hpp"

namespace wrc {
namespace {

constexpr std::size_t motion_count = 3; // not a tuning constant
using MotionValues = std::array<double, motion_count>;
using Fields = std::vector<std::vector<double>>;

WheelForce operator+(const WheelForce& a, const WheelForce& b) {
  return {a.force + b.force, a.roll_moment + b.roll_moment};
}

WheelForce operator*(double s, const WheelForce& a) {
  return {s * a.force, s * a.roll_moment};
}

/// The vector part seen in the mirror y -> -y, of a motion that keeps its sign or changes it.
WheelForce mirrored_wheel(const WheelForce& a, double motion_sign) {
  return {{motion_sign * a.force.x, -motion_sign * a.force.y, motion_sign * a.force.z},
          -motion_sign * a.roll_moment};
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

/// The wheelset's axis of roll.
struct RollAxis {
  Vector3 centre;
  Vector3 direction;

  [[nodiscard]] double moment(Vector3 place, Vector3 force) const {
    return dot(direction, cross(place - centre, force));
  }
};

/// Lever of a unit pressure on each element of a patch.
std::vector<double> levers_of(const LoadedPatch& patch, const RollAxis& axis) {
  const Grid& grid = patch.grid;
  const auto lever_at = [&](double longitudinal, double lateral) {
    return axis.moment(patch.frame.to_track(longitudinal, lateral, 0.0), patch.frame.normal);
  };
  const double origin = lever_at(0.0, 0.0);
  const double along = lever_at(1.0, 0.0) - origin;
  const double across = lever_at(0.0, 1.0) - origin;
  std::vector<double> levers;
  levers.reserve(grid.element_count());
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      levers.push_back(origin + across * grid.lateral(row) + along * grid.longitudinal(column));
    }
  }
  return levers;
}

/// Rates of a patch's normal force, and of its moment about the axis where that stands.
struct PatchRates {
  MotionValues force{};
  MotionValues moment{};
};

class RateSolver {
public:
  RateSolver(std::span<const LoadedPatch> patches, const SensitivityRequest& request,
             ContactStiffness& solver, const std::vector<Fields>& gap_rates, const Fields& levers)
      : patches_(patches), request_(request), solver_(solver), gap_rates_(gap_rates),
        levers_(levers), rates_(patches.size()) {}

  std::vector<PatchRates> solve(WheelSensitivity& result) {
    if (request_.influence != nullptr && patches_.size() > 1) {
      solve_by_motion(result);
    } else {
      solve_by_force(result);
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

  /// Patches that do not interact: one solution gives the forces' rates by all motions, one
  /// more the moments'.
  void solve_by_force(WheelSensitivity& result) {
    Fields ones;
    for (const LoadedPatch& patch : patches_) {
      ones.emplace_back(patch.grid.element_count(), 1.0);
    }
    read_off(solve_for(ones, result), &PatchRates::force);
    if (request_.roll_moment) {
      read_off(solve_for(levers_, result), &PatchRates::moment);
    }
  }

  void read_off(const Fields& answer, MotionValues PatchRates::*values) {
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      for (std::size_t motion = 0; motion < motion_count; ++motion) {
        (rates_[k].*values)[motion] =
            -patches_[k].grid.element_area() * sum_of_products(answer[k], gap_rates_[k][motion]);
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
        rates_[k].force[motion] = -force_of(patches_[k].grid, pressure[k]);
        if (request_.roll_moment) {
          rates_[k].moment[motion] =
              -patches_[k].grid.element_area() * sum_of_products(pressure[k], levers_[k]);
        }
      }
    }
  }

  std::span<const LoadedPatch> patches_;
  const SensitivityRequest& request_;
  ContactStiffness& solver_;
  const std::vector<Fields>& gap_rates_; ///< by patch and motion
  const Fields& levers_;
  std::vector<PatchRates> rates_;
};

/// What the pressures displace more at each other counts as a change of the gaps.
void add_influence_rates(std::span<const LoadedPatch> patches, const SensitivityRequest& request,
                         std::vector<Fields>& gap_rates) {
  const std::array<PatchInfluence*, motion_count> changes{request.influence_rates.lateral,
                                                          request.influence_rates.vertical,
                                                          request.influence_rates.roll};
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

Vector3 centre_of_pressure(const LoadedPatch& patch, double normal_force) {
  const Grid& grid = patch.grid;
  double longitudinal = 0.0;
  double lateral = 0.0;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const double force =
          patch.pressure[row * grid.longitudinal_count + column] * grid.element_area();
      longitudinal += force * grid.longitudinal(column);
      lateral += force * grid.lateral(row);
    }
  }
  return normal_force > 0.0
             ? patch.frame.to_track(longitudinal / normal_force, lateral / normal_force, 0.0)
             : patch.frame.origin;
}

} // namespace

ForceRates operator+(const ForceRates& a, const ForceRates& b) {
  return {a.lateral + b.lateral, a.vertical + b.vertical, a.roll + b.roll};
}

ForceRates mirrored(const ForceRates& rates) {
  return {mirrored_wheel(rates.lateral, -1.0), mirrored_wheel(rates.vertical, 1.0),
          mirrored_wheel(rates.roll, -1.0)};
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
                                                      roll_motion(pair.pose.yaw)};
  const RollAxis axis{{0.0, pair.pose.lateral, pair.vertical}, motions[2].rotation};
  std::vector<Fields> gap_rates(patches.size());
  Fields levers;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    compute_gap_rates(pair, patches[k].frame, patches[k].grid, patches[k].pressure, motions,
                      gap_rates[k]);
    levers.push_back(levers_of(patches[k], axis));
  }
  add_influence_rates(patches, request, gap_rates);
  WheelSensitivity result;
  const std::vector<PatchRates> rates =
      RateSolver(patches, request, solver, gap_rates, levers).solve(result);

  for (std::size_t k = 0; k < patches.size(); ++k) {
    const LoadedPatch& patch = patches[k];
    const ContactFrame& frame = patch.frame;
    PatchSensitivity sensitivity;
    sensitivity.normal_force = force_of(patch.grid, patch.pressure);
    const Vector3 force = sensitivity.normal_force * frame.normal;
    const double moment = patch.grid.element_area() * sum_of_products(patch.pressure, levers[k]);
    result.force = result.force + WheelForce{force, moment};
    // A plane that turns by one rad.
    const Vector3 turned = -sensitivity.normal_force * frame.lateral;
    const WheelForce turning{
        turned, request.roll_moment
                    ? axis.moment(centre_of_pressure(patch, sensitivity.normal_force), turned)
                    : 0.0};
    const auto fixed = [&](std::size_t motion) {
      const double by_centre = -dot(axis.direction, cross(motions[motion].translation, force));
      return WheelForce{rates[k].force[motion] * frame.normal,
                        request.roll_moment ? rates[k].moment[motion] + by_centre : 0.0};
    };
    sensitivity.normal_force_rates = {rates[k].force[0], rates[k].force[1], rates[k].force[2]};
    sensitivity.fixed_plane = {fixed(0), fixed(1), fixed(2)};
    sensitivity.turning_plane = {patch.angle_rates.lateral * turning,
                                 patch.angle_rates.vertical * turning,
                                 patch.angle_rates.roll * turning};
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
  return CondensedRates{condensed(rates.lateral), condensed(rates.roll)};
}

} // namespace wrc
