#include "creep/patch_motion.hpp"

#include <cmath>
#include <utility>

#include "creep/constants.hpp"
#include "records/wheel_result.hpp"

namespace wrc {
namespace {

/// Geometry of slip of a plane with its pressures.
SlipGeometry geometry_of(const PosedPair& pair, const ContactFrame& frame, double approach,
                         const Grid& grid, std::span<const double> pressure,
                         const SlipChoice& choice) {
  return slip_geometry(loaded_rows(slip_rows(pair, frame, grid, pressure, choice), grid, pressure),
                       approach);
}

} // namespace

Creepages creepages_at(const Creepages& reference, double longitudinal, double lateral) {
  return {reference.longitudinal - reference.spin * lateral,
          reference.lateral + reference.spin * longitudinal, reference.spin};
}

WheelsetMotion wheelset_motion(const WheelResult& wheel, const CreepRequest& request) {
  const RollingFrame frame(wheel.details.mirror);
  const RailSurface& rail = *wheel.details.rail;
  return {frame.mirrored(*request.motion),
          wheel.details.pose,
          wheel.details.vertical,
          request.nominal_radius,
          frame.mirrored(request.rail_velocity),
          rail.origin_y(),
          rail.origin_z(),
          !request.motion->vertical_is_given &&
              !wheel.details.pair().is_prismatic_along(along_track),
          frame.mirrored(request.rail_slope)};
}

void find_slip_geometry(WheelResult& wheel, const CreepRequest& request) {
  if (request.slip.variation == SlipVariation::planar || !request.motion) {
    return;
  }
  const PosedPair pair = wheel.details.pair();
  const auto find = [&](PatchResult& patch) {
    patch.slip =
        geometry_of(pair, patch.frame, patch.approach, patch.grid, patch.pressure, request.slip);
  };
  for (PatchResult& patch : wheel.patches) {
    if (patch.slip) {
      continue;
    }
    if (patch.parts.empty()) {
      find(patch);
      continue;
    }
    std::vector<LoadedRow> rows;
    for (PatchResult& part : patch.parts) {
      find(part);
      const Vector3 apart = part.frame.origin - patch.frame.origin;
      for (const LoadedRow& row : part.slip->rows) {
        rows.push_back(moved_row(row, dot(apart, patch.frame.longitudinal),
                                 dot(apart, patch.frame.lateral), dot(apart, patch.frame.normal),
                                 patch.frame.lateral_of(apart)));
      }
    }
    patch.slip = slip_geometry(std::move(rows), patch.approach);
  }
}

PatchMotion motion_of(const PatchResult& patch, const PatchResult& whole, const WheelResult& wheel,
                      const CreepRequest& request) {
  const double mirror = wheel.details.mirror;
  PatchMotion motion;
  if (request.motion) {
    const RigidSlip slip =
        rigid_slip(*wheel.details.motion, patch.frame, patch.approach, patch.penetration.ahead);
    motion = {slip.creepages, RollingFrame(mirror, slip.reference_speed < 0.0), slip.slip_speed};
    if (patch.slip) {
      motion.creepages = fitted_creepages(*patch.slip, slip.twist);
      motion.twist = slip.twist;
    }
    motion.step_length = request.time_step * slip.slip_speed;
    motion.rolling_share = std::abs(slip.reference_speed) / slip.slip_speed;
  } else {
    const Vector3 apart = patch.frame.origin - whole.frame.origin;
    const RollingFrame frame(mirror);
    motion = {creepages_at(frame.mirrored(request.creepages), dot(apart, whole.frame.longitudinal),
                           whole.frame.lateral_of(apart)),
              frame, request.speed};
  }
  motion.friction = friction_of(
      request.friction, patch.reference.s_wheel,
      motion.slip_speed * std::hypot(motion.creepages.longitudinal, motion.creepages.lateral));
  if (motion.friction < least_friction) { // no tractions, so no displacements to keep
    motion.step_length = 0.0;
  }
  return motion;
}

std::vector<SlipRow> rows_on(const WheelResult& wheel, const PatchResult& patch, const Grid& grid,
                             const SlipChoice& choice) {
  return slip_rows(wheel.details.pair(), patch.frame, grid, {}, choice);
}

MovedContact::MovedContact(const WheelResult& wheel, const PatchResult& patch,
                           const PatchRates& rates, std::size_t position, double step)
    : wheel_(wheel), pose_(wheel.details.pose), height_(wheel.details.vertical),
      frame_(patch.frame), approach_(patch.approach - step * rates.gap[position]),
      ahead_(patch.penetration.ahead) {
  const std::array<double*, position_count> moved{&pose_.lateral, &height_, &pose_.roll,
                                                  &pose_.yaw};
  *moved[position] += step;
  // A curve stays where it is, seen from an origin that moves.
  frame_ = patch.frame.seen_from(patch.frame.origin + step * rates.reference[position]);
  const double angle = step * rates.angle[position];
  frame_.lateral = std::cos(angle) * patch.frame.lateral + std::sin(angle) * patch.frame.normal;
  frame_.normal = std::cos(angle) * patch.frame.normal - std::sin(angle) * patch.frame.lateral;
}

PosedPair MovedContact::pair() const {
  return {*wheel_.details.wheel, *wheel_.details.rail, pose_, height_};
}

SlipGeometry MovedContact::geometry(const Grid& grid, std::span<const double> pressure,
                                    const SlipChoice& choice) const {
  return geometry_of(pair(), frame_, approach_, grid, pressure, choice);
}

std::vector<SlipRow> MovedContact::rows(const Grid& grid, const SlipChoice& choice) const {
  return slip_rows(pair(), frame_, grid, {}, choice);
}

Twist MovedContact::twist() const {
  WheelsetMotion motion = *wheel_.details.motion;
  motion.pose = pose_;
  motion.height = height_;
  return rigid_slip(motion, frame_, approach_, ahead_).twist;
}

std::array<CreepagesByTwist, position_count> slip_rates(const WheelResult& wheel,
                                                        const PatchResult& patch,
                                                        const PatchRates& rates,
                                                        const SlipChoice& choice) {
  std::array<CreepagesByTwist, position_count> result{};
  const auto moves = moves_of(patch, rates, creep_pressure_step);
  for (std::size_t position = 0; position < position_count; ++position) {
    const MovedPatch& moved = moves[position].ahead;
    const double step = 0.5 * moves[position].apart;
    const SlipGeometry ahead =
        MovedContact(wheel, patch, rates, position, step)
            .geometry(moved_grid(patch.grid, moved.elements), moved.pressure, choice);
    for (std::size_t creepage = 0; creepage < ahead.creepages_by_twist.size(); ++creepage) {
      for (std::size_t i = 0; i < twist_count; ++i) {
        result[position][creepage][i] =
            (ahead.creepages_by_twist[creepage][i] - patch.slip->creepages_by_twist[creepage][i]) /
            step;
      }
    }
  }
  return result;
}

} // namespace wrc
