#include "accuracy/model_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy/constants.hpp"
#include "base/smoothstep.hpp"

namespace wrc {

SurfaceTurn combined_turn(const SurfaceTurn& one, const SurfaceTurn& other) {
  if (!(one.weight > 0.0) || !(other.weight > 0.0)) {
    return one.weight > 0.0 ? one : other;
  }
  const double weight = one.weight + other.weight;
  const auto mean = [&](double of_one, double of_other) {
    return (one.weight * of_one + other.weight * of_other) / weight;
  };
  const double middle = mean(one.mean, other.mean);
  const auto square = [middle](const SurfaceTurn& turn) {
    const double apart = turn.mean - middle;
    return turn.deviation * turn.deviation + apart * apart;
  };
  return {weight,
          middle,
          std::sqrt(mean(square(one), square(other))),
          std::min(one.first, other.first),
          std::max(one.last, other.last),
          std::min(one.curve_first, other.curve_first),
          std::max(one.curve_last, other.curve_last)};
}

double force_error_of_plane(const SurfaceTurn& turn, double plane_angle) {
  return (std::pow(turn.deviation, 3) + force_error_by_mean * turn.mean * turn.mean) /
         std::cos(plane_angle);
}

double depth_error_of_plane(const SurfaceTurn& turn) {
  return depth_error_by_turn * turn.from_rows() * turn.from_rows() +
         depth_error_on_curve * turn.of_rows() * turn.of_rows();
}

double depth_error_of_kink(const SurfaceTurn& turn, double ridge) {
  const double from_rows = std::max(0.0, ridge - 2.0 * turn.of_rows());
  return depth_error_by_kink * from_rows * from_rows;
}

double pressure_error_of_plane(const SurfaceTurn& turn) {
  return pressure_error_by_turn * turn.from_rows() * turn.from_rows() +
         pressure_error_on_curve * turn.of_rows() * turn.of_rows();
}

double curve_share(double turn, double accuracy, AccuracyOf accuracy_of,
                   bool position_is_prescribed) {
  const double error = (accuracy_of == AccuracyOf::pressures ? pressure_error_by_turn
                        : position_is_prescribed             ? load_power * depth_error_by_turn
                                                             : depth_error_by_turn) *
                       turn * turn;
  return smoothstep((error / accuracy - curve_begins) / (1.0 - curve_begins));
}

double angle_of_reference(const ContactFrame& frame) {
  const Vector3 normal = frame.row_at(0.0).normal;
  return std::atan2(-normal.y, normal.z);
}

double interaction_error(const GridSolution& solution, double combined_modulus) {
  double weighted = 0.0;
  double forces = 0.0;
  const std::size_t count = solution.patches.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Patch& patch = solution.patches[k];
    if (patch.no_contact()) {
      continue;
    }
    double missing = 0.0;
    for (std::size_t l = 0; l < count; ++l) {
      const Patch& other = solution.patches[l];
      if (l != k && !other.no_contact()) {
        const double weight =
            solution.interaction ? solution.interaction->coupling_weight[k * count + l] : 0.0;
        const double of_curves = angle_of_reference(patch.frame) - angle_of_reference(other.frame);
        const double of_planes = patch.frame.angle() - other.frame.angle();
        const double included =
            patch.frame.curve && other.frame.curve && weight > 0.0
                ? std::min(1.0, weight * std::cos(of_planes) / std::cos(of_curves))
                : weight;
        missing +=
            (1.0 - included) * other.normal_force /
            (std::numbers::pi * combined_modulus * norm(patch.frame.origin - other.frame.origin));
      }
    }
    forces += patch.normal_force;
    if (missing > 0.0) {
      weighted += patch.normal_force * std::min(1.0, load_power * missing / patch.overlap());
    }
  }
  return forces > 0.0 ? weighted / forces : 0.0;
}

double estimate_model_error(GridSolution& solution, AccuracyOf accuracy_of,
                            bool position_is_prescribed) {
  const double of_depth = position_is_prescribed ? load_power : 1.0;
  const bool of_pressures = accuracy_of == AccuracyOf::pressures;
  const double peak = solution.peak_pressure();
  double weighted = 0.0;
  double forces = 0.0;
  double pressures = 0.0;
  for (const PlanePatches& plane : solution.patches_by_plane(true)) {
    SurfaceTurn turn;
    double ridge = 0.0;
    double of_plane = 0.0;
    for (const std::size_t k : plane.patches) {
      const Patch& patch = solution.patches[k];
      turn = combined_turn(turn, patch.turn);
      ridge = std::max(ridge, patch.ridge);
      if (of_pressures) {
        const double error = pressure_error_of_plane(patch.turn);
        of_plane = std::max(of_plane, error);
        pressures = std::max(pressures, error * patch.contact.peak_pressure / peak);
      }
    }
    const double of_force =
        std::max(force_error_of_plane(turn, solution.patches[plane.patches.front()].frame.angle()),
                 of_depth * (depth_error_of_plane(turn) + depth_error_of_kink(turn, ridge)));
    for (const std::size_t k : plane.patches) {
      solution.patches[k].plane_error = std::max(of_plane, of_force);
      solution.patches[k].plane_force_error = of_force;
    }
    weighted += plane.normal_force * of_force;
    forces += plane.normal_force;
  }
  return std::max(pressures, forces > 0.0 ? weighted / forces : 0.0);
}

} // namespace wrc
