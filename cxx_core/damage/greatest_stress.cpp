// The greatest von Mises stress below a contact: search on coarse elements, then climbs.
#include <algorithm>
#include <array>
#include <cmath>

#include "damage/constants.hpp"
#include "damage/subsurface_stress.hpp"

namespace wrc {
namespace {

/// Maximum of the parabola through values at -1, 0 and 1; without one there, the side that rises.
double top_of_parabola(double behind, double middle, double ahead) {
  const double slope = 0.5 * (ahead - behind);
  const double curvature = behind + ahead - 2.0 * middle;
  return curvature < 0.0 ? std::clamp(-slope / curvature, -1.0, 1.0) : std::copysign(1.0, slope);
}

/// Rounded up.
std::size_t whole_ratio(std::size_t count, std::size_t divisor) {
  return (count + divisor - 1) / divisor;
}

} // namespace

void SubsurfaceStress::scan(const Level& level, const Places& places, double depth,
                            GreatestStress& found) const {
  const std::vector<Stress> plane = sums<float>(level, places, depth);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const double value = von_mises(plane[i]);
    if (value > found.von_mises) {
      const std::size_t column = i % places.x_count;
      const std::size_t row = i / places.x_count;
      found = {value,
               0.0,
               0.0,
               places.x_first +
                   static_cast<double>(column * places.x_stride) * level.grid.longitudinal_step,
               places.y_first +
                   static_cast<double>(row * places.y_stride) * level.grid.lateral_step,
               depth,
               0.0};
    }
  }
}

double SubsurfaceStress::half_width() const {
  const Grid& grid = levels_.front().grid;
  return 0.5 * std::min(grid.lateral_step * static_cast<double>(grid.lateral_count),
                        grid.longitudinal_step * static_cast<double>(grid.longitudinal_count));
}

std::size_t SubsurfaceStress::level_shown() const {
  const Grid& grid = levels_.front().grid;
  std::size_t shown = 0;
  while (shown + 1 < levels_.size() &&
         std::min(grid.lateral_count, grid.longitudinal_count) >> (shown + 1) >= search_elements) {
    ++shown;
  }
  return shown;
}

SubsurfaceStress::Places SubsurfaceStress::below_contact(const Level& level) const {
  const Grid& whole = levels_.front().grid;
  const Grid& grid = level.grid;
  const auto halvings = static_cast<std::size_t>(&level - levels_.data());
  const std::size_t along = (grid.longitudinal_count - (whole.longitudinal_count >> halvings)) / 2;
  const std::size_t across = (grid.lateral_count - (whole.lateral_count >> halvings)) / 2;
  const std::size_t columns = grid.longitudinal_count - 2 * along;
  const std::size_t rows = grid.lateral_count - 2 * across;
  const std::size_t x_stride = whole_ratio(columns, most_search_places);
  const std::size_t y_stride = whole_ratio(rows, most_search_places);
  return {grid.longitudinal(along),
          whole_ratio(columns, x_stride),
          grid.lateral(across),
          whole_ratio(rows, y_stride),
          x_stride,
          y_stride};
}

std::vector<GreatestStress> SubsurfaceStress::search() const {
  // Coarser elements where the depth allows them.
  const Level& shown = levels_[level_shown()];
  const double shorter = std::min(shown.grid.longitudinal_step, shown.grid.lateral_step);
  std::vector<GreatestStress> found;
  for (double depth = deepest_search * half_width();; depth /= search_depth_ratio) {
    const bool surface = depth < shallowest_search * shorter;
    const Level& level =
        std::max(shown, level_for(depth, depth_of_search_element),
                 [](const Level& a, const Level& b) { return a.size() < b.size(); });
    scan(level, below_contact(level), surface ? 0.0 : depth, found.emplace_back());
    if (surface) {
      break;
    }
  }
  // Between the depths.
  for (std::size_t i = 1; i + 2 < found.size(); ++i) {
    const double shift =
        top_of_parabola(found[i - 1].von_mises, found[i].von_mises, found[i + 1].von_mises);
    if (std::abs(shift) < 1.0) {
      found[i].depth *= std::pow(search_depth_ratio, -shift);
    }
  }
  return found;
}

bool SubsurfaceStress::has_narrow_top() const {
  const auto greatest = [](const Level& level) {
    return *std::max_element(level.loads[0].begin(), level.loads[0].end());
  };
  return greatest(levels_[level_shown()]) < share_shown * greatest(levels_.front());
}

GreatestStress SubsurfaceStress::below_pressure(double deepest) const {
  const Level& level = levels_.front();
  const Grid& grid = level.grid;
  const auto& pressure = level.loads[0];
  const auto place = static_cast<std::size_t>(std::max_element(pressure.begin(), pressure.end()) -
                                              pressure.begin());
  const std::size_t columns = grid.longitudinal_count;
  GreatestStress found;
  const double x = grid.longitudinal(columns - 1 - place % columns); // rows are kept backwards
  const double y = grid.lateral(place / columns);
  const double shallowest = std::min(grid.longitudinal_step, grid.lateral_step);
  double depth = deepest;
  while (depth > shallowest) {
    const double value = von_mises(point(level_for(depth, depth_of_search_element), x, y, depth));
    if (value > found.von_mises) {
      found = {value, 0.0, 0.0, x, y, depth, 0.0};
    }
    depth /= search_depth_ratio;
  }
  return found;
}

void SubsurfaceStress::climb_below(GreatestStress& found) const {
  const Grid& grid = level_for(found.depth, depth_of_search_element).grid;
  std::array<double, 3> place{found.x, found.y, found.depth};
  const std::array<double, 3> step{0.5 * grid.longitudinal_step, 0.5 * grid.lateral_step,
                                   0.25 * found.depth};
  const auto value_at = [this](const std::array<double, 3>& at) {
    return von_mises(point(level_for(at[2], depth_of_search_element), at[0], at[1], at[2]));
  };
  for (int round = 0; round < search_rounds; ++round) {
    const double start = value_at(place);
    double best = start;
    for (const std::size_t direction : {2U, 0U, 1U}) {
      const auto moved = [&](double offset) {
        std::array<double, 3> there = place;
        there[direction] += offset;
        return there;
      };
      const double behind = value_at(moved(-step[direction]));
      const double ahead = value_at(moved(step[direction]));
      const double slope = 0.5 * (ahead - behind);
      const double curvature = behind + ahead - 2.0 * best;
      const double top = top_of_parabola(behind, best, ahead);
      place = moved(top * step[direction]);
      best += top * (slope + 0.5 * top * curvature);
    }
    if (best < (1.0 + least_gain) * start) {
      break;
    }
  }
  found.x = place[0];
  found.y = place[1];
  found.depth = place[2];
}

void SubsurfaceStress::climb_on_surface(GreatestStress& found) const {
  for (std::size_t i = std::max<std::size_t>(level_shown(), 1); i-- > 0;) {
    const Grid& grid = levels_[i].grid;
    const auto around = [](double place, double first, double step, std::size_t reach) {
      return first + (std::round((place - first) / step) - static_cast<double>(reach)) * step;
    };
    const double x =
        around(found.x, grid.longitudinal_first, grid.longitudinal_step, surface_reach_along);
    const double y = around(found.y, grid.lateral_first, grid.lateral_step, surface_reach_across);
    found.von_mises = 0.0;
    scan(levels_[i], {x, 2 * surface_reach_along + 1, y, 2 * surface_reach_across + 1}, 0.0, found);
  }
}

GreatestStress SubsurfaceStress::greatest() const {
  std::vector<GreatestStress> tops = search();
  const auto lower = [](const GreatestStress& a, const GreatestStress& b) {
    return a.von_mises < b.von_mises;
  };
  const double highest = std::max_element(tops.begin(), tops.end(), lower)->von_mises;
  // Over the depth, too.
  const auto stands_out = [&](std::size_t i) {
    return tops[i].von_mises >= worth_climbing * highest && tops[i].von_mises > 0.0 &&
           (i == 0 || tops[i - 1].von_mises <= tops[i].von_mises) &&
           (i + 1 == tops.size() || tops[i + 1].von_mises <= tops[i].von_mises);
  };
  std::vector<GreatestStress> climbed;
  if (has_narrow_top()) {
    climbed.push_back(below_pressure(tops.front().depth));
  }
  for (std::size_t i = 0; i < tops.size(); ++i) {
    if (stands_out(i)) {
      climbed.push_back(tops[i]);
    }
  }
  GreatestStress found;
  for (GreatestStress& top : climbed) {
    if (top.depth > 0.0) {
      climb_below(top);
    } else {
      climb_on_surface(top);
    }
    const Stress stress = point(level_for(top.depth, depth_of_element), top.x, top.y, top.depth);
    if (von_mises(stress) > found.von_mises) {
      found = {von_mises(stress),
               greatest_shear(stress),
               principal_stresses(stress)[0],
               top.x,
               top.y,
               top.depth,
               0.0};
    }
  }
  if (tractions_) {
    const double size = levels_.front().size();
    const double near = size / (size + found.depth);
    found.error_estimate = near_surface_error * near * near * std::sqrt(size / half_width());
  }
  return found;
}

} // namespace wrc
