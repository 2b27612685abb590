#include "geometry/wheel_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "geometry/constants.hpp"

namespace wrc {
namespace {

double seed_of_wheel(const Curve& curve) {
  // The piece that holds the taping line, s = 0, or the middle if the profile does not reach it.
  for (std::size_t piece = 0; piece < curve.piece_count(); ++piece) {
    const double length = curve.starts()[piece + 1] - curve.starts()[piece];
    if (curve.at(piece, 0.0).lateral <= 0.0 && curve.at(piece, length).lateral >= 0.0) {
      return curve.starts()[piece] + 0.5 * length;
    }
  }
  return 0.5 * curve.length();
}

} // namespace

WheelSurface::WheelSurface(const Profile& profile, const WheelsetDimensions& dimensions)
    : WheelSurface(profile.curve, dimensions) {}

WheelSurface::WheelSurface(const Curve& profile, const WheelsetDimensions& dimensions)
    : graph_(profile.without_steps(), seed_of_wheel(profile)),
      taping_line_(0.5 * dimensions.back_to_back + dimensions.tape_offset),
      radius_(dimensions.radius), dimensions_(dimensions) {
  for (std::size_t piece = 0; piece < profile.piece_count(); ++piece) {
    if (!(radius_ + profile.at(piece, 0.0).height > 0.0)) {
      throw_invalid_argument("wheelset.radius", radius_,
                             "large enough that the whole wheel profile has a positive radius, mm");
    }
  }
  const std::size_t first = graph_.first_piece();
  const Curve& curve = graph_.curve();
  for (std::size_t node = 0; node <= graph_.piece_count(); ++node) {
    const bool last = node == graph_.piece_count();
    const std::size_t piece = first + node - (last ? 1 : 0);
    const double length = curve.starts()[piece + 1] - curve.starts()[piece];
    const CurvePoint point = curve.at(piece, last ? length : 0.0);
    nodes_.lateral.push_back(point.lateral);
    nodes_.height.push_back(point.height);
    nodes_.slope.push_back(point.slope());
    if (node > 0 && !last) {
      const double before =
          curve.at(piece - 1, curve.starts()[piece] - curve.starts()[piece - 1]).slope();
      if (before - point.slope() > ridge_turn) {
        ridges_.push_back({node, before});
      }
    }
    largest_radius_ = std::max(largest_radius_, radius_ + point.height);
  }
}

WheelSurface::WheelSurface(std::shared_ptr<const SlicedSurface> slices,
                           const WheelsetDimensions& dimensions, double pitch)
    : WheelSurface(slices->section(pitch), dimensions) {
  slices_ = std::move(slices);
  pitch_ = pitch;
  std::vector<RoundStretch> stretches;
  for (const ConstantStretch& where : slices_->constant_stretches()) {
    const WheelSurface round(slices_->section(where.along.begin), dimensions);
    stretches.push_back({where, std::make_shared<const WheelSurface>(round)});
  }
  round_ = std::make_shared<const std::vector<RoundStretch>>(std::move(stretches));
}

WheelSurface WheelSurface::turned(double pitch) const {
  if (slices_ == nullptr) {
    return *this;
  }
  WheelSurface wheel(slices_->section(pitch), dimensions_);
  wheel.slices_ = slices_;
  wheel.pitch_ = pitch;
  wheel.round_ = round_;
  return wheel;
}

double WheelSurface::touch_angle(double yaw, double rise, bool varies) const {
  const double of_locus = steepest_flank * std::abs(std::sin(yaw));
  const double above = (wheel_out_of_reach + rise) / radius_;
  const double of_slope = varies ? std::asin(steepest_along) : 0.0;
  return of_locus < 1.0 && above < 1.0 ? std::asin(of_locus) + std::acos(1.0 - above) + of_slope
                                       : std::numeric_limits<double>::infinity();
}

double WheelSurface::touch_slope(double yaw) const {
  return steepest_flank * std::abs(std::sin(yaw)) +
         (slices_ != nullptr ? slices_->steepest_along() / radius_ : 0.0);
}

std::shared_ptr<const WheelSurface> WheelSurface::round_at(double pitch, double yaw,
                                                           bool rail_varies) const {
  if (round_ == nullptr) {
    return nullptr;
  }
  for (const RoundStretch& stretch : *round_) {
    const Stretch& along = stretch.where.along;
    const double half = 0.5 * (along.end - along.begin);
    const double from_middle = std::remainder(pitch - (along.begin + half), 2.0 * std::numbers::pi);
    if (std::abs(from_middle) + touch_angle(yaw, stretch.where.rise, rail_varies) <= half) {
      return stretch.wheel;
    }
  }
  return nullptr;
}

WheelSurface WheelSurface::as_round() const {
  WheelSurface round = *this;
  round.slices_.reset();
  round.round_.reset();
  return round;
}

std::optional<PartEnd> WheelSurface::nearest_end(double x) const {
  std::optional<PartEnd> end =
      slices_ != nullptr ? slices_->nearest_end(pitch_ + std::asin(x / radius_)) : std::nullopt;
  if (end) {
    end->distance *= radius_;
  }
  return end;
}

std::shared_ptr<const WheelSurface> turned(const std::shared_ptr<const WheelSurface>& wheel,
                                           double pitch, double yaw, bool rail_varies) {
  if (wheel->is_prismatic_along(along_track)) {
    return wheel;
  }
  std::shared_ptr<const WheelSurface> round = wheel->round_at(pitch, yaw, rail_varies);
  return round != nullptr ? round : std::make_shared<const WheelSurface>(wheel->turned(pitch));
}

LocusPose::LocusPose(const Pose& pose, const Rotation& rotation_of_pose)
    : rotation(rotation_of_pose), lateral(pose.lateral), a(rotation.cos_yaw),
      b(rotation.sin_yaw * rotation.sin_roll), along(-rotation.sin_yaw * rotation.cos_roll),
      amplitude_square(a * a + b * b), inverse_square(1.0 / amplitude_square) {}

LocusPoint WheelSurface::locus(const CurvePoint& profile_point, const LocusAngle& angle,
                               const LocusPose& pose) const {
  const double rho = radius_ + profile_point.height;
  const double radial = profile_point.tangent_lateral;
  LocusPoint point;
  point.position = pose.rotation.to_track(
      {rho * angle.sine, taping_line_ + profile_point.lateral, -rho * angle.cosine});
  point.position.y += pose.lateral;
  const Vector3 normal = pose.rotation.to_track(
      {radial * angle.sine, -profile_point.tangent_height, -radial * angle.cosine});
  const double length = std::sqrt(normal.y * normal.y + normal.z * normal.z);
  point.tangent_y = -normal.z / length;
  point.tangent_z = normal.y / length;
  point.lateral = profile_point.lateral;
  point.height = profile_point.height;
  point.wheel_angle = std::atan2(angle.sine, angle.cosine);
  point.normal_curvature = radial / rho;
  return point;
}

} // namespace wrc
