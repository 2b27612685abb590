#include "remesh/rail_normals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/reductions.hpp"
#include "remesh/constants.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

RailNormals::RailNormals(const RailSurface& rail, const ContactFrame& frame, const Grid& grid)
    : frame_(frame), grid_(grid), by_row_(rail.is_prismatic_along(frame.longitudinal)) {
  const std::size_t columns = by_row_ ? 1 : grid.longitudinal_count;
  places_.reserve(grid.lateral_count * columns);
  rows_.reserve(grid.lateral_count);
  RailRay ray(rail, frame);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double lateral = grid.lateral(row);
    const ContactFrame::Row& at = rows_.emplace_back(frame.row_at(lateral));
    for (std::size_t column = 0; column < columns; ++column) {
      const auto position = ray.solve(by_row_ ? 0.0 : grid.longitudinal(column), lateral);
      Place place{position.has_value(), at.place, at.normal, {at.normal, at.lateral, {}, {}}};
      if (position) {
        place.foot = place.foot + *position * at.normal;
        place.surface = ray.line().normal();
        place.direction = (1.0 / dot(at.normal, place.surface.normal)) * place.surface.normal;
      }
      places_.push_back(place);
    }
  }
}

std::optional<double> RailNormals::position(std::size_t row, std::size_t column) const {
  const Place& place = places_[index(row, column)];
  return place.met ? std::optional(height(row, column)) : std::nullopt;
}

void RailNormals::shift(const Vector3& by) {
  const double along = dot(by, frame_.longitudinal);
  const std::size_t columns = by_row_ ? 1 : grid_.longitudinal_count;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    Place& place = places_[i];
    const ContactFrame::Row& at = rows_[i / columns];
    const double across = dot(by, at.lateral);
    const double up = dot(by, at.normal);
    const Rates moved = rates(i / columns, i % columns, along, across);
    place.direction = place.direction + moved.direction;
    // From an origin that goes along.
    place.foot = place.foot + (dot(moved.arm, at.normal) - up) * at.normal;
  }
}

double RailNormals::height(std::size_t row, std::size_t column) const {
  const Vector3& foot = places_[index(row, column)].foot;
  const ContactFrame::Row& at = rows_[row];
  return frame_.curve ? dot(foot - at.place, at.normal) : dot(foot, at.normal);
}

Vector3 RailNormals::arm(std::size_t row, std::size_t column) const {
  return places_[index(row, column)].foot + grid_.longitudinal(column) * frame_.longitudinal;
}

RailNormals::Rates RailNormals::rates(std::size_t row, std::size_t column, double along,
                                      double across) const {
  const Place& place = places_[index(row, column)];
  const SurfaceNormal& surface = place.surface;
  const ContactFrame::Row& at = rows_[row];
  const Vector3 in_plane = along * frame_.longitudinal + across * at.lateral;
  const double facing = 1.0 / dot(at.normal, surface.normal);
  const Vector3 arm = in_plane - (dot(surface.normal, in_plane) * facing) * at.normal;
  const Vector3 turned =
      (dot(surface.across, arm) * facing) * surface.by_across + (arm.x * facing) * surface.by_along;
  return {turned - dot(at.normal, turned) * place.direction, arm};
}

std::vector<double> RailNormals::shares(const Vector3& up) const {
  std::vector<double> shares(grid_.element_count());
  const std::size_t together = by_row_ ? grid_.longitudinal_count : 1;
  double* share = shares.data();
  for (const Place& place : places_) {
    std::fill_n(share, together, std::max(dot(up, place.direction), min_facing_cosine));
    share += together;
  }
  return shares;
}

/// Elements that have the same direction and foot count together.
ContactForce RailNormals::force(std::span<const double> pressure) const {
  const std::size_t together = by_row_ ? grid_.longitudinal_count : 1;
  ContactForce sum;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double* p = pressure.data() + i * together;
    const double pressures = sum_of(p, together);
    if (!(pressures > 0.0)) {
      continue;
    }
    double first_moments = 0.0;
    for (std::size_t k = 0; k < together; ++k) {
      first_moments += p[k] * grid_.longitudinal((i * together + k) % grid_.longitudinal_count);
    }
    const Vector3 arm = pressures * places_[i].foot + first_moments * frame_.longitudinal;
    sum.force = sum.force + pressures * places_[i].direction;
    sum.moment = sum.moment + cross(arm, places_[i].direction);
  }
  const double area = grid_.element_area();
  return {area * sum.force, area * sum.moment};
}

SurfaceTurn RailNormals::turn(std::span<const double> pressure) const {
  const std::size_t together = by_row_ ? grid_.longitudinal_count : 1;
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  SurfaceTurn turn{0.0, 0.0, 0.0, infinite, -infinite, infinite, -infinite};
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double pressures = sum_of(pressure.data() + i * together, together);
    if (pressures > 0.0) {
      const ContactFrame::Row& at = rows_[i * together / grid_.longitudinal_count];
      const double inclination = -dot(places_[i].direction, at.lateral);
      sum += pressures;
      first += pressures * inclination;
      second += pressures * inclination * inclination;
      const double of_row =
          frame_.curve ? std::atan2(dot(at.lateral, frame_.normal), dot(at.lateral, frame_.lateral))
                       : 0.0;
      turn.curve_first = std::min(turn.curve_first, of_row);
      turn.curve_last = std::max(turn.curve_last, of_row);
      const double angle = of_row + std::atan(inclination);
      turn.first = std::min(turn.first, angle);
      turn.last = std::max(turn.last, angle);
    }
  }
  if (!(sum > 0.0)) {
    return {};
  }
  turn.weight = grid_.element_area() * sum;
  turn.mean = first / sum;
  turn.deviation = std::sqrt(std::max(0.0, second / sum - turn.mean * turn.mean));
  return turn;
}

} // namespace wrc
