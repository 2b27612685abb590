#include "derivatives/gap_rates.hpp"

#include <algorithm>
#include <cmath>

#include "remesh/ray_rows.hpp"

namespace wrc {
namespace {

/// Columns of a row, `end` not included.
struct ColumnRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] std::size_t count() const { return end - begin; }
};

class RateSampler {
public:
  RateSampler(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
              std::span<const double> wanted, std::span<const RigidMotion> motions,
              std::vector<std::vector<double>>& rates)
      : wheel_(pair.wheel), grid_(grid), wanted_(wanted), ray_(pair, frame),
        row_(pair.wheel, grid.longitudinal_count), first_height_(ray_.height()),
        row_height_(first_height_), rates_(rates) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      longitudinal_.push_back(grid.longitudinal(column));
    }
    const Rotation rotation(pair.pose);
    for (const RigidMotion& motion : motions) {
      motions_.push_back({rotation.to_body(motion.translation), rotation.to_body(motion.rotation)});
    }
  }

  /// Back to the frame's origin, to go the other way.
  void restart() { row_height_ = first_height_; }

  /// The rates of a row; rays start from the height met in the middle of the row before.
  void sample(std::size_t row) {
    const ColumnRange range = wanted_range(row);
    if (range.count() == 0) {
      return;
    }
    const double lateral = grid_.lateral(row);
    const std::size_t middle = range.begin + range.count() / 2;
    ray_.start_from(row_height_);
    const bool middle_met = ray_.solve(longitudinal_[middle], lateral).has_value();
    if (middle_met) {
      row_height_ = ray_.height();
    }
    if (middle_met) {
      row_.meet({ray_.base(0.0, lateral), ray_.longitudinal(), ray_.normal(),
                 longitudinal_.data() + range.begin, range.count()},
                ray_.lateral());
    } else {
      row_.meet_none(range.count());
    }
    // Outwards from the middle, so that a single ray starts from the height its neighbour met.
    ray_.start_from(row_height_);
    for (std::size_t column = middle; column < range.end; ++column) {
      sample_element(row, column, column - range.begin);
    }
    ray_.start_from(row_height_);
    for (std::size_t column = middle; column-- > range.begin;) {
      sample_element(row, column, column - range.begin);
    }
  }

private:
  [[nodiscard]] ColumnRange wanted_range(std::size_t row) const {
    const std::size_t columns = grid_.longitudinal_count;
    if (wanted_.empty()) {
      return {0, columns};
    }
    ColumnRange range{0, columns};
    const double* values = wanted_.data() + row * columns;
    while (range.end > 0 && !(values[range.end - 1] > 0.0)) {
      --range.end;
    }
    while (range.begin < range.end && !(values[range.begin] > 0.0)) {
      ++range.begin;
    }
    return range;
  }

  void sample_element(std::size_t row, std::size_t column, std::size_t in_row) {
    const std::size_t element = row * grid_.longitudinal_count + column;
    if (!wanted_.empty() && !(wanted_[element] > 0.0)) {
      return;
    }
    const double lateral = grid_.lateral(row);
    double position = 0.0;
    if (row_.met(in_row)) {
      position = row_.position(in_row);
    } else if (const auto single = ray_.solve(longitudinal_[column], lateral)) {
      position = *single;
    } else {
      return;
    }
    const Vector3 normal = ray_.normal();
    Vector3 place = ray_.base(longitudinal_[column], lateral) + position * normal;
    const Vector3 gradient = ray_.gradient(place);
    place.y += wheel_.taping_line(); // from the wheelset's centre
    const double inverse = 1.0 / dot(normal, gradient);
    for (std::size_t motion = 0; motion < motions_.size(); ++motion) {
      const Vector3 moved = motions_[motion].translation + cross(motions_[motion].rotation, place);
      rates_[motion][element] = dot(moved, gradient) * inverse;
    }
  }

  const WheelSurface& wheel_;
  const Grid& grid_;
  const std::span<const double> wanted_;
  std::vector<RigidMotion> motions_; ///< in the wheelset frame
  std::vector<double> longitudinal_;
  WheelRay ray_;
  RaySurface row_;
  const double first_height_;
  double row_height_;
  std::vector<std::vector<double>>& rates_;
};

} // namespace

RigidMotion lateral_motion() {
  return {{0.0, 1.0, 0.0}, {}};
}

RigidMotion vertical_motion() {
  return {{0.0, 0.0, 1.0}, {}};
}

RigidMotion roll_motion(double yaw) {
  return {{}, {std::cos(yaw), std::sin(yaw), 0.0}};
}

RigidMotion yaw_motion() {
  return {{}, {0.0, 0.0, 1.0}};
}

std::array<RigidMotion, motion_count> all_motions(double yaw) {
  return {lateral_motion(), vertical_motion(), roll_motion(yaw), yaw_motion()};
}

void compute_gap_rates(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
                       std::span<const double> wanted, std::span<const RigidMotion> motions,
                       std::vector<std::vector<double>>& rates) {
  rates.resize(motions.size());
  for (std::vector<double>& field : rates) {
    field.assign(grid.element_count(), 0.0);
  }
  RateSampler sampler(pair, frame, grid, wanted, motions, rates);
  const std::size_t middle =
      nearest_to_zero(grid.lateral_first, grid.lateral_step, grid.lateral_count);
  for (std::size_t row = middle; row < grid.lateral_count; ++row) {
    sampler.sample(row);
  }
  sampler.restart();
  for (std::size_t row = middle; row-- > 0;) {
    sampler.sample(row);
  }
}

} // namespace wrc
