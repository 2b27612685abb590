#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/hertz.hpp"
#include "models/kik_piotrowski.hpp"
#include "models/patch_model.hpp"
#include "patches/constants.hpp"

namespace wrc {
namespace {

class HertzPatch final : public PatchModel {
public:
  HertzPatch(const ModelWheel& side, const ContactPatch& place, const ContactStrip& contact)
      : PatchModel(tangent_plane(contact)), side_(side), place_(place), contact_(contact),
        curvature_(contact.lateral_curvature),
        lateral_per_s_(contact.lateral_rate / frame_.lateral.y) {
    if (!(curvature_ > 0.0)) { // profiles leave such a patch at a validity of 0
      const double half_width =
          std::max(0.5 * (place.contact_last - place.contact_first) / frame_.lateral.y,
                   min_axis_ratio * place.half_length);
      curvature_ = 2.0 * virtual_penetration_share * place.deepest * frame_.normal.z /
                   (half_width * half_width);
    }
    const double along = contact.longitudinal_curvature;
    const double drift = contact.longitudinal_rate / lateral_per_s_;
    const double across = curvature_ + drift * drift * along;
    const double mixed = -drift * along;
    const double mean = 0.5 * (along + across);
    const double radius = std::hypot(0.5 * (along - across), mixed);
    // The axis of the greater curvature, seen from x.
    const double angle = 0.5 * std::atan2(2.0 * mixed, along - across);
    cosine_ = std::cos(angle);
    sine_ = std::sin(angle);
    const double smaller = (along * curvature_) / (mean + radius); // det = kappa S
    unit_ = solve_hertz_for_approach(mean + radius, smaller, side.combined_modulus, 1.0);
  }

  double load(double depth) override {
    const double approach = approach_at(depth);
    return unit_.normal_force * approach * std::sqrt(approach);
  }
  ModelledPatch solve(double depth) override;
  [[nodiscard]] std::vector<double> sample(const Grid& grid) const override {
    std::vector<double> pressure;
    pressure.reserve(grid.element_count());
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      const double y = grid.lateral(row);
      for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
        const double x = grid.longitudinal(column);
        pressure.push_back(
            hertz_pressure(contact_at_depth_, cosine_ * x + sine_ * y, cosine_ * y - sine_ * x));
      }
    }
    return pressure;
  }

private:
  static ContactFrame tangent_plane(const ContactStrip& contact) {
    const double angle = std::atan(contact.rail_slope);
    return tangent_frame(contact.rail, angle, contact.rail_rise * std::cos(angle));
  }
  [[nodiscard]] double approach_at(double depth) const {
    return std::max(0.0, depth - (side_.first_touch + contact_.distance)) * frame_.normal.z;
  }
  [[nodiscard]] double validity_within(double half_width, double half_length) const;
  /// Deviation of the gap at both ends of virtual penetration from the parabola there, relative,
  /// below 1.
  [[nodiscard]] double width_difference() const;

  const ModelWheel& side_;
  ContactPatch place_;
  ContactStrip contact_;
  double curvature_;     ///< S
  double lateral_per_s_; ///< along the tangent
  double cosine_ = 1.0;  ///< of the axis of the greater curvature against x
  double sine_ = 0.0;
  HertzContact unit_;             ///< of an approach of 1 mm
  HertzContact contact_at_depth_; ///< in axes of its own
};

ModelledPatch HertzPatch::solve(double depth) {
  const double approach = approach_at(depth);
  const double root = std::sqrt(approach);
  contact_at_depth_ = {unit_.semi_axis_longitudinal * root, unit_.semi_axis_lateral * root,
                       unit_.peak_pressure * root, approach, unit_.normal_force * approach * root};
  ModelledPatch patch;
  patch.approach = approach;
  patch.normal_force = contact_at_depth_.normal_force;
  patch.peak_pressure = contact_at_depth_.peak_pressure;
  const double first = contact_at_depth_.semi_axis_longitudinal;
  const double second = contact_at_depth_.semi_axis_lateral;
  patch.area = std::numbers::pi * first * second;
  // Moments and extents of an ellipse turn alike.
  patch.semi_axis_longitudinal = std::hypot(first * cosine_, second * sine_);
  patch.semi_axis_lateral = std::hypot(first * sine_, second * cosine_);
  patch.extent = {-patch.semi_axis_lateral, patch.semi_axis_lateral, -patch.semi_axis_longitudinal,
                  patch.semi_axis_longitudinal};
  patch.validity = validity_within(patch.semi_axis_lateral, patch.semi_axis_longitudinal);
  return patch;
}

double HertzPatch::width_difference() const {
  const double gap = virtual_penetration_share * place_.deepest * frame_.normal.z;
  double difference = 0.0;
  for (const double end : {place_.contact_first, place_.contact_last}) {
    const double y = (end - contact_.rail.y) / frame_.lateral.y;
    const double ratio = 0.5 * curvature_ * y * y / gap;
    difference = std::max(difference, 1.0 - std::min(ratio, 1.0 / ratio));
  }
  return difference;
}

double HertzPatch::validity_within(double half_width, double half_length) const {
  const double edge_gap = 0.5 * curvature_ * half_width * half_width;
  double difference = 0.0;
  const auto compare_at = [&](double s) {
    const auto strip = side_.strips.at(s);
    if (!strip) {
      return false;
    }
    const double gap =
        along_normal(strip->distance - contact_.distance, strip->rail_slope, strip->rail_rise);
    const double y = dot(strip->rail - contact_.rail, frame_.lateral);
    difference = std::max(difference, std::abs(gap - 0.5 * curvature_ * y * y));
    return true;
  };
  bool inside = true;
  for (int i = -compared_places; i <= compared_places; ++i) {
    inside = compare_at(contact_.s + half_width * i / compared_places / lateral_per_s_) && inside;
  }
  // Another lobe lies beyond the ellipse, but not beyond the virtual penetration.
  difference =
      std::max({difference / edge_gap, width_difference(),
                side_.strips.difference_along(contact_, frame_.longitudinal.x * half_length)});
  return inside ? std::max(0.0, 1.0 - difference) : 0.0;
}

} // namespace

std::unique_ptr<PatchModel> make_hertz_patch(const ModelWheel& side, const ContactPatch& place) {
  return std::make_unique<HertzPatch>(side, place,
                                      side.strips.touching_at(place.deepest_s, "hertz"));
}

} // namespace wrc
