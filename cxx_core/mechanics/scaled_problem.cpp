#include "mechanics/scaled_problem.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/reductions.hpp"
#include "mechanics/constants.hpp"

namespace wrc {
namespace {

double sum_of(const std::vector<double>& values) {
  return wrc::sum_of(values.data(), values.size());
}

/// The approach at which each element touches.
std::vector<double> heights_of(const Level& level) {
  std::vector<double> heights(level.distance.size());
  std::transform(level.distance.begin(), level.distance.end(), level.shares.begin(),
                 heights.begin(), std::divides<>());
  return heights;
}

/// The approach below which a given fraction of the elements lies.
double start_height(const Level& level) {
  std::vector<double> ordered = heights_of(level);
  const auto rank =
      static_cast<std::ptrdiff_t>(start_quantile * static_cast<double>(ordered.size() - 1));
  std::nth_element(ordered.begin(), ordered.begin() + rank, ordered.end());
  return ordered[static_cast<std::size_t>(rank)];
}

/// Pressures like Hertz's over the elements below a height; even ones where nothing lies below it
/// (a punch).
void draw_pressure_below(Level& level, double height) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < level.pressure.size(); ++i) {
    const double depth = std::max(0.0, height * level.shares[i] - level.distance[i]);
    level.pressure[i] = std::sqrt(depth);
    deepest = std::max(deepest, depth);
  }
  if (deepest == 0.0) {
    for (std::size_t i = 0; i < level.pressure.size(); ++i) {
      // Rounded like the height: the lowest element must not be left out.
      level.pressure[i] = level.distance[i] / level.shares[i] <= height ? 1.0 : 0.0;
    }
  }
}

} // namespace

/// The box around all that overlaps at an approach: contact cannot lie outside. False if nothing
/// does.
bool find_penetration_box(const Level& level, double approach, std::size_t margin,
                          ElementBox& box) {
  std::vector<double> depth(level.distance.size());
  std::transform(level.distance.begin(), level.distance.end(), level.shares.begin(), depth.begin(),
                 [approach](double distance, double share) { return share * approach - distance; });
  return find_pressure_box(level.size, depth, margin, box);
}

double ScaledProblem::first_touch(const NormalProblem& problem) {
  double touch = std::numeric_limits<double>::infinity();
  for (const PatchGap& patch : problem.patches) {
    if (patch.shares.empty()) {
      const double least =
          least_of(patch.undeformed_distance.data(), patch.undeformed_distance.size());
      touch = std::min(touch, least / patch.approach_cosine);
      continue;
    }
    touch = std::min(touch, least_ratio(patch.undeformed_distance.data(), patch.shares.data(),
                                        patch.shares.size()));
  }
  return touch;
}

void ScaledProblem::set(const NormalProblem& problem, InfluenceCache& cache) {
  count = problem.patches.size();
  approach = 0.0;
  interaction = problem.interaction;
  least_approach = first_touch(problem);
  set_scales(problem);
  // No element farther away than the approach is in contact, and no approach is larger than that of
  // the whole load on one element. Keeps absent bodies (any finite distance) within range.
  double farthest = 1.0;
  if (load) {
    farthest = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const Level& finest = cascades[k].finest();
      farthest =
          std::max(farthest, *load / finest.load_weight() *
                                 cache.table(cascades[k].kernel, 1, 1)->row(0)[0] / finest.share);
    }
  }
  set_levels(problem, farthest);
}

void ScaledProblem::set_scales(const NormalProblem& problem) {
  const double step = problem.patches[0].grid.longitudinal_step;
  const double area = problem.patches[0].grid.element_area();
  const double modulus = std::numbers::pi * problem.combined_modulus;
  cascades.resize(std::max(cascades.size(), count));
  double elements = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const PatchGap& patch = problem.patches[k];
    std::vector<Level>& levels = cascades[k].levels;
    levels.resize(std::max<std::size_t>(levels.size(), 1));
    Level& finest = levels.front();
    cascades[k].kernel = {shared_aspect(patch.grid.lateral_step / patch.grid.longitudinal_step),
                          problem.elements};
    finest.grid = patch.grid;
    finest.grid.lateral_first = 0.0;
    finest.grid.longitudinal_first = 0.0;
    if (interaction != nullptr) {
      cascades[k].place = {interaction->places[k].lateral + patch.grid.lateral_first,
                           interaction->places[k].longitudinal + patch.grid.longitudinal_first};
    }
    const double unit = step / patch.grid.longitudinal_step;
    finest.share = patch.approach_cosine * unit;
    finest.shares.assign(patch.grid.element_count(), finest.share);
    std::transform(patch.shares.begin(), patch.shares.end(), finest.shares.begin(),
                   [unit](double share) { return unit * share; });
    finest.angles.assign(patch.angles.begin(), patch.angles.end());
    finest.weight = (patch.grid.element_area() / area) * (patch.grid.longitudinal_step / step);
    elements += finest.weight * sum_of(finest.shares);
  }
  if (problem.load) {
    pressure_scale = *problem.load / step / problem.patches[0].grid.lateral_step / elements;
    approach_scale = pressure_scale / modulus * step;
    load = elements;
  } else {
    approach_scale = *problem.approach - least_approach;
    pressure_scale = approach_scale / step * modulus;
    load.reset();
    approach = 1.0;
  }
}

void ScaledProblem::set_levels(const NormalProblem& problem, double farthest) {
  const double step = problem.patches[0].grid.longitudinal_step;
  level_count = 1;
  for (std::size_t k = 0; k < count; ++k) {
    const PatchGap& patch = problem.patches[k];
    PatchCascade& cascade = cascades[k];
    cascade.level_count = 1;
    for (LevelSize size{patch.grid.lateral_count, patch.grid.longitudinal_count}; can_coarsen(size);
         size = coarser_size(size)) {
      ++cascade.level_count;
    }
    level_count = std::max(level_count, cascade.level_count);
    cascade.levels.resize(std::max(cascade.levels.size(), cascade.level_count));
    Level& finest = cascade.finest();
    finest.size = {patch.grid.lateral_count, patch.grid.longitudinal_count};
    finest.distance.resize(patch.grid.element_count());
    const double unit = approach_scale * (patch.grid.longitudinal_step / step);
    const double limit = 4.0 * farthest * finest.share;
    for (std::size_t i = 0; i < finest.distance.size(); ++i) {
      const double above = patch.undeformed_distance[i] - least_approach * patch.share(i);
      finest.distance[i] = std::min(above / unit, limit);
    }
    for (std::size_t i = 1; i < cascade.level_count; ++i) {
      const Level& finer = cascade.levels[i - 1];
      Level& level = cascade.levels[i];
      level.size = coarser_size(finer.size);
      level.grid = finer.grid;
      level.grid.lateral_count = level.size.rows;
      level.grid.longitudinal_count = level.size.columns;
      level.grid.lateral_step *= 2.0;
      level.grid.longitudinal_step *= 2.0;
      level.grid.lateral_first += 0.5 * finer.grid.lateral_step;
      level.grid.longitudinal_first += 0.5 * finer.grid.longitudinal_step;
      level.share = finer.share / 2.0;
      level.weight = finer.weight * 8.0;
      coarsen_distance(finer.size, finer.distance, level.distance);
      coarsen_distance(finer.size, finer.shares, level.shares);
      coarsen_angles(finer.angles, level.angles);
    }
  }
}

void ScaledProblem::draw_pressure(std::size_t index) {
  double height = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count && load; ++k) {
    height = std::min(height, start_height(cascades[k].at(index)));
  }
  double drawn = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    Level& level = cascades[k].at(index);
    level.pressure.assign(level.size.count(), 0.0);
    if (load) {
      draw_pressure_below(level, height);
      drawn += level.weight * std::inner_product(level.pressure.begin(), level.pressure.end(),
                                                 level.shares.begin(), 0.0);
    }
    cascades[k].box = {0, level.size.rows - 1, 0, level.size.columns - 1};
  }
  for (std::size_t k = 0; k < count && load; ++k) {
    for (double& value : cascades[k].at(index).pressure) {
      value *= *load / drawn;
    }
  }
  approach = load ? height : approach;
}

/// Of the grids `index` of all patches.
std::size_t ScaledProblem::longest_side(std::size_t index) const {
  std::size_t longest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const LevelSize& size = cascades[k].levels[std::min(index, cascades[k].level_count - 1)].size;
    longest = std::max({longest, size.rows, size.columns});
  }
  return longest;
}

std::optional<std::size_t> ScaledProblem::take_start(const NormalProblem& problem) {
  const bool given =
      std::all_of(problem.patches.begin(), problem.patches.end(), [](const PatchGap& patch) {
        return patch.start.size() == patch.undeformed_distance.size();
      });
  if (!given) {
    return std::nullopt;
  }
  std::size_t index = 0;
  while (index + 1 < level_count && longest_side(index) > max_started_side) {
    ++index;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::span<const double> start = problem.patches[k].start;
    std::vector<Level>& levels = cascades[k].levels;
    levels[0].pressure.resize(start.size());
    std::transform(start.begin(), start.end(), levels[0].pressure.begin(),
                   [this](double p) { return p / pressure_scale; });
    for (std::size_t i = 1; i <= std::min(index, cascades[k].level_count - 1); ++i) {
      coarsen_pressure(levels[i - 1].size, levels[i - 1].pressure, levels[i].pressure);
    }
  }
  return index;
}

} // namespace wrc
