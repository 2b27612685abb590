// The greatest von Mises stress below a contact: search on coarse elements, then climbs.
#include <algorithm>
#include <array>
#include <cmath>

#include "damage/constants.hpp"
#include "damage/subsurface_stress.hpp"

namespace wrc {

void SubsurfaceStress::scan(const Level& level, double depth, GreatestStress& found) const {
  const Grid& grid = level.grid;
  // Below the contact, without the margin that coarser elements need.
  const std::size_t margin = &level == levels_.data() ? 0 : 2;
  const Places places{grid.longitudinal(margin), grid.longitudinal_count - 2 * margin,
                      grid.lateral(margin), grid.lateral_count - 2 * margin};
  const std::vector<Stress> plane = sums<float>(level, places, depth);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const double value = von_mises(plane[i]);
    if (value > found.von_mises) {
      found = {value,
               0.0,
               0.0,
               grid.longitudinal(margin + i % places.x_count),
               grid.lateral(margin + i / places.x_count),
               depth};
    }
  }
}

std::vector<GreatestStress> SubsurfaceStress::search() const {
  // The coarsest elements that show the contact, unless the depth demands finer ones.
  std::size_t shown = levels_.size() - 1;
  while (shown > 0 && std::min(levels_[shown].grid.lateral_count,
                               levels_[shown].grid.longitudinal_count) < search_elements) {
    --shown;
  }
  const Grid& whole = levels_.front().grid;
  const double half_width =
      0.5 * std::min(whole.lateral_step * static_cast<double>(whole.lateral_count),
                     whole.longitudinal_step * static_cast<double>(whole.longitudinal_count));
  std::vector<GreatestStress> found;
  for (double depth = deepest_search * half_width;; depth /= search_depth_ratio) {
    const bool surface = depth < shallowest_search * levels_[shown].size();
    const double at_depth = surface ? 0.0 : depth;
    const Level& deep = level_for(depth, depth_of_search_element);
    const Level& level =
        deep.grid.lateral_step < levels_[shown].grid.lateral_step ? levels_[shown] : deep;
    scan(level, at_depth, found.emplace_back());
    if (surface) {
      break;
    }
  }
  found.push_back(below_pressure(deepest_search * half_width));
  return found;
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
      found = {value, 0.0, 0.0, x, y, depth};
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
  double best = value_at(place);
  for (int round = 0; round < search_parabolas; ++round) {
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
      const double top =
          curvature < 0.0 ? std::clamp(-slope / curvature, -1.0, 1.0) : std::copysign(1.0, slope);
      place = moved(top * step[direction]);
      best += top * (slope + 0.5 * top * curvature);
    }
  }
  found.x = place[0];
  found.y = place[1];
  found.depth = place[2];
}

void SubsurfaceStress::climb_on_surface(GreatestStress& found) const {
  const Level& level = levels_.front();
  if (levels_.size() > 1) {
    scan(levels_[1], 0.0, found);
  }
  const Grid& grid = level.grid;
  const auto nearest = [](double place, double first, double step, std::size_t count) {
    return std::clamp(std::round((place - first) / step), 0.0, static_cast<double>(count - 1));
  };
  double x =
      nearest(found.x, grid.longitudinal_first, grid.longitudinal_step, grid.longitudinal_count);
  double y = nearest(found.y, grid.lateral_first, grid.lateral_step, grid.lateral_count);
  const auto value_at = [&](double column, double row) {
    return von_mises(point(level, grid.longitudinal_first + column * grid.longitudinal_step,
                           grid.lateral_first + row * grid.lateral_step, 0.0));
  };
  double best = value_at(x, y);
  for (double stride = surface_stride; stride >= 1.0;) {
    bool moved = false;
    for (const auto& [dx, dy] :
         {std::pair(-stride, 0.0), {stride, 0.0}, {0.0, -stride}, {0.0, stride}}) {
      const double value = value_at(x + dx, y + dy);
      if (value > best) {
        best = value;
        x += dx;
        y += dy;
        moved = true;
      }
    }
    stride *= moved ? 1.0 : 0.5;
  }
  found.x = grid.longitudinal_first + x * grid.longitudinal_step;
  found.y = grid.lateral_first + y * grid.lateral_step;
}

GreatestStress SubsurfaceStress::greatest() const {
  std::vector<GreatestStress> tops = search();
  double highest = 0.0;
  for (const GreatestStress& top : tops) {
    highest = std::max(highest, top.von_mises);
  }
  GreatestStress found;
  for (GreatestStress& top : tops) {
    if (!(top.von_mises > 0.0) || top.von_mises < worth_climbing * highest) {
      continue;
    }
    if (top.depth > 0.0) {
      climb_below(top);
    } else {
      climb_on_surface(top);
    }
    const Stress stress = point(level_for(top.depth, depth_of_element), top.x, top.y, top.depth);
    if (von_mises(stress) > found.von_mises) {
      found = {
          von_mises(stress), greatest_shear(stress), principal_stresses(stress)[0], top.x, top.y,
          top.depth};
    }
  }
  return found;
}

} // namespace wrc
