#include "remesh/rail_normals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/reductions.hpp"
#include "remesh/constants.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

RailNormals::RailNormals(const RailSurface& rail, const ContactFrame& frame, const Grid& grid)
    : frame_(frame), grid_(grid),
      by_row_(frame.longitudinal.y == 0.0 && frame.longitudinal.z == 0.0) {
  const std::size_t columns = by_row_ ? 1 : grid.longitudinal_count;
  places_.reserve(grid.lateral_count * columns);
  RailRay ray(rail, frame);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double lateral = grid.lateral(row);
    for (std::size_t column = 0; column < columns; ++column) {
      const auto position = ray.solve(by_row_ ? 0.0 : grid.longitudinal(column), lateral);
      Place place{position.has_value(), lateral * frame.lateral,
                  frame.normal,         frame.lateral,
                  frame.normal,         {}};
      if (position) {
        const CurvePoint& point = ray.point();
        place.foot = place.foot + *position * frame.normal;
        place.tangent = {0.0, point.tangent_lateral, point.tangent_height};
        place.normal = {0.0, -point.tangent_height, point.tangent_lateral};
        place.normal_rate = {0.0, -point.second_height, point.second_lateral};
        place.direction = (1.0 / dot(frame.normal, place.normal)) * place.normal;
      }
      places_.push_back(place);
    }
  }
}

std::optional<double> RailNormals::position(std::size_t row) const {
  const Place& place = places_[row];
  return place.met ? std::optional(dot(place.foot, frame_.normal)) : std::nullopt;
}

void RailNormals::shift(const Vector3& by) {
  const double along = dot(by, frame_.longitudinal);
  const double across = dot(by, frame_.lateral);
  const double up = dot(by, frame_.normal);
  const std::size_t columns = by_row_ ? 1 : grid_.longitudinal_count;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    Place& place = places_[i];
    const Rates moved = rates(i / columns, i % columns, along, across);
    place.direction = place.direction + moved.direction;
    // From an origin that goes along.
    place.foot = place.foot + (dot(moved.arm, frame_.normal) - up) * frame_.normal;
  }
}

Vector3 RailNormals::arm(std::size_t row, std::size_t column) const {
  return places_[index(row, column)].foot + grid_.longitudinal(column) * frame_.longitudinal;
}

RailNormals::Rates RailNormals::rates(std::size_t row, std::size_t column, double along,
                                      double across) const {
  const Place& place = places_[index(row, column)];
  const Vector3 in_plane = along * frame_.longitudinal + across * frame_.lateral;
  const double facing = 1.0 / dot(frame_.normal, place.normal);
  const Vector3 arm = in_plane - (dot(place.normal, in_plane) * facing) * frame_.normal;
  const Vector3 turned = (dot(place.tangent, arm) * facing) * place.normal_rate;
  return {turned - dot(frame_.normal, turned) * place.direction, arm};
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
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double pressures = sum_of(pressure.data() + i * together, together);
    if (pressures > 0.0) {
      const double inclination = -dot(places_[i].direction, frame_.lateral);
      sum += pressures;
      first += pressures * inclination;
      second += pressures * inclination * inclination;
      least = std::min(least, inclination);
      most = std::max(most, inclination);
    }
  }
  if (!(sum > 0.0)) {
    return {};
  }
  const double mean = first / sum;
  return {grid_.element_area() * sum, mean, std::sqrt(std::max(0.0, second / sum - mean * mean)),
          std::atan(least), std::atan(most)};
}

} // namespace wrc
