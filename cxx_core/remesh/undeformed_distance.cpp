#include "remesh/undeformed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "remesh/ray_rows.hpp"

namespace wrc {
namespace {

/// A row of a rail that is the same all along it has one ray. Others are met at once, and rays of
/// one element at a time where that fails. They go outwards from the middle of the row, each from
/// the height that its neighbour met.
class RowSampler {
public:
  RowSampler(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
             const RailNormals* known)
      : pair_(pair), frame_(frame), grid_(grid),
        one_rail_ray_(pair.rail.is_prismatic_along(frame.longitudinal)),
        rail_at_once_(pair.rail.is_prismatic_along(along_track)),
        known_(one_rail_ray_ || !rail_at_once_ ? known : nullptr),
        middle_column_(nearest_to_zero(grid.longitudinal_first, grid.longitudinal_step,
                                       grid.longitudinal_count)),
        rail_(pair.rail, frame), wheel_(pair, frame),
        rail_row_(pair.rail, one_rail_ray_ ? 0 : grid.longitudinal_count),
        wheel_row_(pair.wheel, grid.longitudinal_count), first_height_(wheel_.height()),
        row_height_(first_height_) {
    longitudinal_.reserve(grid.longitudinal_count);
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      longitudinal_.push_back(grid.longitudinal(column));
    }
  }

  /// Back to the frame's origin, to go the other way.
  void restart() {
    rail_.restart();
    row_height_ = first_height_;
  }

  /// The distances of a row, which must be next to the row before.
  void sample(std::size_t row, double* values) {
    const double lateral = grid_.lateral(row);
    std::optional<double> rail_position;
    if (one_rail_ray_) {
      rail_position = rail_ray(row, 0, 0.0);
      if (!rail_position) {
        std::fill_n(values, longitudinal_.size(), no_material_distance);
        return;
      }
    }
    bool all_met = meet_wheel(lateral);
    if (!one_rail_ray_) {
      all_met = meet_rail(lateral) && all_met;
    }
    if (!all_met) {
      sample_singly(row, rail_position, values);
    } else if (rail_position) {
      for (std::size_t column = 0; column < longitudinal_.size(); ++column) {
        values[column] = wheel_row_.position(column) - *rail_position;
      }
    } else {
      for (std::size_t column = 0; column < longitudinal_.size(); ++column) {
        values[column] = wheel_row_.position(column) - rail_row_.position(column);
      }
    }
  }

private:
  std::optional<double> rail_ray(std::size_t row, std::size_t column, double longitudinal) {
    return known_ != nullptr ? known_->position(row, column)
                             : rail_.solve(longitudinal, grid_.lateral(row));
  }

  bool meet_wheel(double lateral) {
    wheel_.start_from(row_height_);
    if (!wheel_.solve(longitudinal_[middle_column_], lateral)) {
      wheel_row_.meet_none(longitudinal_.size());
      return false;
    }
    row_height_ = wheel_.height();
    return wheel_row_.meet({wheel_.base(0.0, lateral), wheel_.longitudinal(), wheel_.normal(),
                            longitudinal_.data(), longitudinal_.size()},
                           wheel_.lateral());
  }

  bool meet_rail(double lateral) {
    if (!rail_at_once_ || !rail_.solve(longitudinal_[middle_column_], lateral) ||
        !rail_.line().is_on_graph()) {
      rail_row_.meet_none(longitudinal_.size());
      return false;
    }
    return rail_row_.meet({frame_.to_track(0.0, lateral, 0.0), frame_.longitudinal,
                           frame_.row_at(lateral).normal, longitudinal_.data(),
                           longitudinal_.size()},
                          rail_.line().lateral());
  }

  /// Height of the wheel profile where a ray of the row, which is met, meets it.
  [[nodiscard]] double height_met(std::size_t column, double lateral) const {
    const Vector3 met =
        wheel_.base(longitudinal_[column], lateral) + wheel_row_.position(column) * wheel_.normal();
    return std::sqrt(met.x * met.x + met.z * met.z) - pair_.wheel.radius();
  }

  void sample_singly(std::size_t row, std::optional<double> rail_position, double* values) {
    const double lateral = grid_.lateral(row);
    // The column next to it on the side of the middle has been there before.
    const auto sample_element = [&](std::size_t column, std::size_t before) {
      std::optional<double> wheel_position;
      if (wheel_row_.met(column)) {
        wheel_position = wheel_row_.position(column);
      } else {
        if (wheel_row_.met(before)) {
          wheel_.start_from(height_met(before, lateral));
        }
        wheel_position = wheel_.solve(longitudinal_[column], lateral);
      }
      if (!one_rail_ray_) {
        rail_position = rail_row_.met(column) ? std::optional(rail_row_.position(column))
                                              : rail_ray(row, column, longitudinal_[column]);
      }
      values[column] =
          wheel_position && rail_position ? *wheel_position - *rail_position : no_material_distance;
    };
    wheel_.start_from(row_height_);
    for (std::size_t column = middle_column_; column < longitudinal_.size(); ++column) {
      sample_element(column, column > middle_column_ ? column - 1 : column);
    }
    wheel_.start_from(row_height_);
    for (std::size_t column = middle_column_; column-- > 0;) {
      sample_element(column, column + 1);
    }
  }

  const PosedPair& pair_;
  const ContactFrame& frame_;
  const Grid& grid_;
  const bool one_rail_ray_; ///< a row
  const bool rail_at_once_; ///< rays of a row, else one by one
  const RailNormals* known_;
  const std::size_t middle_column_;
  RailRay rail_;
  WheelRay wheel_;
  RaySurface rail_row_;
  RaySurface wheel_row_;
  const double first_height_;
  double row_height_; ///< of the wheel profile in the middle of the row before
  std::vector<double> longitudinal_;
};

} // namespace

std::vector<double> sample_undeformed_distance(const PosedPair& pair, const ContactFrame& frame,
                                               const Grid& grid, const RailNormals* rail) {
  std::vector<double> distance(grid.element_count());
  RowSampler sampler(pair, frame, grid, rail);
  const std::size_t middle =
      nearest_to_zero(grid.lateral_first, grid.lateral_step, grid.lateral_count);
  const auto values_of = [&](std::size_t row) {
    return distance.data() + row * grid.longitudinal_count;
  };
  for (std::size_t row = middle; row < grid.lateral_count; ++row) {
    sampler.sample(row, values_of(row));
  }
  sampler.restart();
  for (std::size_t row = middle; row-- > 0;) {
    sampler.sample(row, values_of(row));
  }
  return distance;
}

SurfacePlace surfaces_at(const PosedPair& pair, const ContactFrame& frame, double longitudinal,
                         double lateral) {
  SurfacePlace place;
  RailRay rail(pair.rail, frame);
  if (const auto position = rail.solve(longitudinal, lateral)) {
    place.on_rail = true;
    place.rail = frame.to_track(longitudinal, lateral, *position);
    place.rail_angle = rail.line().angle();
  }
  WheelRay wheel(pair, frame);
  if (const auto position = wheel.solve(longitudinal, lateral)) {
    place.on_wheel = true;
    place.wheel = frame.to_track(longitudinal, lateral, *position);
    place.wheel_lateral = wheel.lateral();
    place.wheel_height = wheel.height();
  }
  return place;
}

} // namespace wrc
