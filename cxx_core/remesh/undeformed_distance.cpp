#include "remesh/undeformed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "remesh/ray_rows.hpp"

namespace wrc {
namespace {

/// Rays of one element at a time where a row could not be met at once. They go outwards from the
/// middle of the row, each from the height that its neighbour met.
class RowSampler {
public:
  RowSampler(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
             const RailNormals* known)
      : pair_(pair), frame_(frame), grid_(grid), known_(known),
        rail_constant_along_rows_(pair.rail.varying() == nullptr && frame.longitudinal.y == 0.0 &&
                                  frame.longitudinal.z == 0.0),
        middle_column_(nearest_to_zero(grid.longitudinal_first, grid.longitudinal_step,
                                       grid.longitudinal_count)),
        rail_(pair.rail, frame), wheel_(pair, frame),
        rail_row_(pair.rail.graph().heights(), std::nullopt,
                  rail_constant_along_rows_ ? 0 : grid.longitudinal_count),
        wheel_row_(pair.wheel.graph().heights(), pair.wheel.radius(), grid.longitudinal_count),
        first_height_(wheel_.height()), row_height_(first_height_) {
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
    if (rail_constant_along_rows_) {
      rail_position = known_ != nullptr ? known_->position(row, 0) : rail_.solve(0.0, lateral);
      if (!rail_position) {
        std::fill_n(values, longitudinal_.size(), no_material_distance);
        return;
      }
    }
    bool all_met = meet_wheel(lateral);
    if (!rail_constant_along_rows_) {
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
  bool meet_wheel(double lateral) {
    wheel_.start_from(row_height_);
    if (!wheel_.solve(longitudinal_[middle_column_], lateral)) {
      wheel_row_.meet_none(longitudinal_.size());
      return false;
    }
    row_height_ = wheel_.height();
    if (pair_.wheel.varying() != nullptr) {
      wheel_row_.meet_none(longitudinal_.size());
      return false;
    }
    return wheel_row_.meet({wheel_.base(0.0, lateral), wheel_.longitudinal(), wheel_.normal(),
                            longitudinal_.data(), longitudinal_.size()},
                           wheel_.lateral());
  }

  bool meet_rail(double lateral) {
    if (pair_.rail.varying() != nullptr) {
      rail_row_.meet_none(longitudinal_.size());
      return false;
    }
    if (!rail_.solve(longitudinal_[middle_column_], lateral) || !rail_.on_graph()) {
      rail_row_.meet_none(longitudinal_.size());
      return false;
    }
    return rail_row_.meet({frame_.to_track(0.0, lateral, 0.0), frame_.longitudinal,
                           frame_.row_at(lateral).normal, longitudinal_.data(),
                           longitudinal_.size()},
                          rail_.point().lateral);
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
    const bool rail_is_known = known_ != nullptr && pair_.rail.varying() != nullptr;
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
      if (!rail_constant_along_rows_) {
        rail_position = rail_is_known           ? known_->position(row, column)
                        : rail_row_.met(column) ? std::optional(rail_row_.position(column))
                                                : rail_.solve(longitudinal_[column], lateral);
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
  const RailNormals* known_;
  const bool rail_constant_along_rows_;
  const std::size_t middle_column_;
  RailRay rail_;
  WheelRay wheel_;
  RaySurface rail_row_;
  RaySurface wheel_row_;
  const double first_height_;
  double row_height_; ///< of the wheel profile in the middle of the row before
  std::vector<double> longitudinal_;
};

void sample(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
            const RailNormals* known, std::vector<double>& distance) {
  distance.resize(grid.element_count());
  RowSampler sampler(pair, frame, grid, known);
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
}

} // namespace

void sample_undeformed_distance(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
                                std::vector<double>& distance) {
  sample(pair, frame, grid, nullptr, distance);
}

std::vector<double> sample_undeformed_distance(const PosedPair& pair, const ContactFrame& frame,
                                               const Grid& grid) {
  std::vector<double> distance;
  sample(pair, frame, grid, nullptr, distance);
  return distance;
}

std::vector<double> sample_undeformed_distance(const PosedPair& pair, const ContactFrame& frame,
                                               const Grid& grid, const RailNormals& rail) {
  std::vector<double> distance;
  sample(pair, frame, grid, &rail, distance);
  return distance;
}

SurfacePlace surfaces_at(const PosedPair& pair, const ContactFrame& frame, double longitudinal,
                         double lateral) {
  SurfacePlace place;
  RailRay rail(pair.rail, frame);
  if (const auto position = rail.solve(longitudinal, lateral)) {
    place.on_rail = true;
    place.rail = frame.to_track(longitudinal, lateral, *position);
    place.rail_angle = std::atan2(rail.point().tangent_height, rail.point().tangent_lateral);
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
