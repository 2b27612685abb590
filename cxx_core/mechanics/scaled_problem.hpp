/// The normal problem without dimensions, on a cascade of grids for each patch.
///
/// Lengths are counted in longitudinal steps of each grid, so u = K p with the influence
/// coefficients of influence_cache.hpp; the approach in that of the first patch's finest grid. Mean
/// pressure 1 over the grids if the load is given, approach 1 if that is given: numbers of the
/// order of 1 whatever the units and the size. Distances start from the least one.
/// Thread rule: one object serves one thread at a time; memory is reused by the next problem.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "half_space/influence_cache.hpp"
#include "mechanics/cascade.hpp"
#include "mechanics/normal_contact.hpp"

namespace wrc {

/// One grid of a patch's cascade, in its own unit of length.
struct Level {
  LevelSize size;
  Grid grid; ///< in mm, from the finest level's first element
  std::vector<double> distance;
  std::vector<double> pressure;
  std::vector<double> shares; ///< of the approach, by element, in this level's unit
  std::vector<double> angles; ///< of rows along a curve
  double share = 1.0;         ///< a typical one of these
  double weight = 1.0; ///< element area times unit of length, relative to the first patch's grid
  [[nodiscard]] double load_weight() const { return share * weight; }
};

/// Angles of some of a grid's rows; none of a plane.
inline std::span<const double> angles_of(const Level& level, std::size_t first, std::size_t count) {
  return level.angles.empty() ? std::span<const double>()
                              : std::span<const double>(level.angles).subspan(first, count);
}

/// Grids of one patch, finest first, and the box worked on.
struct PatchCascade {
  InfluenceKernel kernel;
  PatchInteraction::Place place; ///< of the finest level's first element in the mean plane
  std::vector<Level> levels;
  std::size_t level_count = 0; ///< of the levels, those of this problem
  ElementBox box;
  std::vector<double> box_pressure;
  std::vector<double> box_distance;
  std::vector<double> box_shares;

  /// The grid of this patch that goes with a grid of the longest cascade.
  [[nodiscard]] Level& at(std::size_t index) { return levels[std::min(index, level_count - 1)]; }
  [[nodiscard]] Level& finest() { return levels.front(); }
  [[nodiscard]] const Level& finest() const { return levels.front(); }
};

struct ScaledProblem {
  /// The approach at which the first element touches, mm; nothing else is set yet.
  static double first_touch(const NormalProblem& problem);
  /// `problem` must make contact.
  void set(const NormalProblem& problem, InfluenceCache& cache);
  /// Takes pressures to start from onto the finest grids that are short enough (max_started_side)
  /// and returns the index of these; none if not all patches have some.
  std::optional<std::size_t> take_start(const NormalProblem& problem);
  /// First pressures on grid `index` of all patches. With the approach given there are none: the
  /// first residual shows where contact is.
  void draw_pressure(std::size_t index);

  std::size_t count = 0;              ///< of patches
  std::vector<PatchCascade> cascades; ///< at least one per patch
  std::size_t level_count = 0;        ///< of the longest cascade
  const PatchInteraction* interaction = nullptr;
  std::optional<double> load; ///< sum of weight times share times p
  double approach = 0.0;
  double pressure_scale = 0.0; ///< MPa
  double approach_scale = 0.0; ///< mm
  double least_approach = 0.0; ///< mm, see first_touch

private:
  void set_scales(const NormalProblem& problem);
  void set_levels(const NormalProblem& problem, double farthest);
  [[nodiscard]] std::size_t longest_side(std::size_t index) const;
};

/// The box around all that overlaps at an approach: contact cannot lie outside. False if nothing
/// does.
bool find_penetration_box(const Level& level, double approach, std::size_t margin, ElementBox& box);

} // namespace wrc
