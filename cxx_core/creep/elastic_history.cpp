#include "creep/elastic_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "records/wheel_result.hpp"

namespace wrc {
namespace {

ContactFrame from_rail(ContactFrame frame, const RailSurface& rail) {
  frame.origin = frame.origin - Vector3{0.0, rail.origin_y(), rail.origin_z()};
  return frame;
}

/// A position in the plane of another frame.
struct PlanePosition {
  double x, y;
};

PlanePosition position_in(const ContactFrame& other, const ContactFrame& frame, double x,
                          double y) {
  const Vector3 apart = frame.to_track(x, y, 0.0) - other.origin;
  return {dot(apart, other.longitudinal), other.lateral_of(apart)};
}

double middle(double first, double step, std::size_t count) {
  return first + 0.5 * step * static_cast<double>(count - 1);
}

/// The patch that another one continues; null: none.
const PatchHistory* continued_by(const WheelHistory& history, const ContactFrame& frame,
                                 const Grid& grid) {
  const PatchHistory* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PatchHistory& patch : history) {
    const PlanePosition at = position_in(
        patch.frame, frame,
        middle(grid.longitudinal_first, grid.longitudinal_step, grid.longitudinal_count),
        middle(grid.lateral_first, grid.lateral_step, grid.lateral_count));
    const auto from_middle = [](double place, double first, double step, std::size_t count) {
      return std::abs(place - middle(first, step, count)) / (step * static_cast<double>(count));
    };
    const Grid& other = patch.grid;
    const double apart =
        std::max(from_middle(at.x, other.longitudinal_first, other.longitudinal_step,
                             other.longitudinal_count),
                 from_middle(at.y, other.lateral_first, other.lateral_step, other.lateral_count));
    constexpr double at_its_edge = 0.5; // of the rectangle
    if (apart < std::min(least, at_its_edge)) {
      least = apart;
      nearest = &patch;
    }
  }
  return nearest;
}

/// Two elements and the weight of the second.
struct Between {
  std::size_t first, second;
  double weight;
};

Between between(double place, double first, double step, std::size_t count) {
  const double index = std::clamp((place - first) / step, 0.0, static_cast<double>(count - 1));
  const auto below = static_cast<std::size_t>(index);
  return {below, std::min(below + 1, count - 1), index - static_cast<double>(below)};
}

} // namespace

void add_history(const WheelHistory& history, const RailSurface& rail, const ContactFrame& frame,
                 const Grid& grid, double step_length, SlipField& slip) {
  slip.x.resize(grid.element_count());
  slip.y.resize(grid.element_count());
  const ContactFrame now = from_rail(frame, rail);
  const PatchHistory* before = continued_by(history, now, grid);
  if (before == nullptr) {
    return;
  }
  const Grid& old = before->grid;
  for (std::size_t at = 0; at < grid.element_count(); ++at) {
    const PlanePosition place =
        position_in(before->frame, now, grid.longitudinal(at % grid.longitudinal_count),
                    grid.lateral(at / grid.longitudinal_count));
    const Between along =
        between(place.x, old.longitudinal_first, old.longitudinal_step, old.longitudinal_count);
    const Between across = between(place.y, old.lateral_first, old.lateral_step, old.lateral_count);
    const auto value = [&](const std::vector<double>& field) {
      const auto line = [&](std::size_t row) {
        const double* const values = field.data() + row * old.longitudinal_count;
        return std::lerp(values[along.first], values[along.second], along.weight);
      };
      return std::lerp(line(across.first), line(across.second), across.weight);
    };
    slip.x[at] -= value(before->x) / step_length;
    slip.y[at] -= value(before->y) / step_length;
  }
}

WheelHistory history_of(const WheelResult& wheel) {
  WheelHistory history;
  for (const PatchResult* patch : solved_patches(wheel)) {
    if (patch->creep && !patch->creep->displacement_x.empty()) {
      history.push_back({from_rail(patch->frame, *wheel.details.rail), patch->creep->grid,
                         patch->creep->displacement_x, patch->creep->displacement_y});
    }
  }
  return history;
}

} // namespace wrc
