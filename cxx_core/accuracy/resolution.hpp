/// How many elements an accuracy takes, and how far off a solution on them is.
///
/// Grids span the virtual penetration of a patch, of which contact takes about 0.7 each way. The
/// accuracy alone decides on their elements, which makes costs the same in every step and results
/// continuous in the scene. With n rows and at least 0.45 n columns, depth, forces and centre of
/// pressure have an error below 1.5/n^2 in 95 to 99 of 100 wheels, half of them a third of it or
/// more; the force at a prescribed position 1.5 times as much, since it goes with the depth to the
/// power of 1.5. Where contact fills less of the grid than usual (flange contact with much yaw), n
/// is that of as many elements under pressure. Two grids compared tell no more about a single wheel
/// (docs/accuracy.md). The largest pressure, taken from a finer section (peak_section.hpp), has the
/// same error and that of its crest besides. The area of contact is not counted: it is right to
/// about forty accuracies. Averages of the gap over elements in place of its values at their
/// centres were tried: errors of pmax are 5 to 10 times as large in the median, and no smaller in
/// the tail.
/// Creep forces need more elements than normal ones, by a law of their own: they follow from the
/// shape of the contact, whose errors average out in normal forces, and a long contact needs more
/// elements along it.
/// Units: none. Thread rule: pure functions. Not known here: errors of planes and of the
/// half-space.
#pragma once

#include <algorithm>
#include <cstddef>

#include "accuracy/grid_solution.hpp"
#include "patches/plane_area.hpp"

namespace wrc {

struct ElementCounts {
  std::size_t lateral = 0;
  std::size_t longitudinal = 0; ///< of a patch as long as wide
  /// The power of a patch's length over its width by which there are more along it.
  double longitudinal_growth = 0.0;
};

/// What a solution is to be accurate in, and how.
struct AccuracyGoal {
  double accuracy = 1e-3;
  bool position_is_prescribed = false;
  Elements elements = Elements::smooth;
  bool creep_forces = false; ///< whether pressures are to serve these, too
  bool stresses = false;     ///< likewise
};

ElementCounts counts_for(const AccuracyGoal& goal);
/// Elements over the area of a patch.
Grid grid_over(const PlaneArea& area, const ElementCounts& counts);
/// Of the solution before the final one, which finds the depth for a load.
ElementCounts coarse_counts(double accuracy);

/// Relative errors of what the accuracy is of.
struct ErrorEstimate {
  double rows = 0.0;      ///< by the law
  double columns = 0.0;   ///< by the law
  double iteration = 0.0; ///< what it has left
  double crest = 0.0;     ///< what a section has not resolved
  [[nodiscard]] double total() const { return std::max(rows, columns) + iteration + crest; }
};
ErrorEstimate estimate_error(const GridSolution& solution, const AccuracyGoal& goal);

/// For a solution whose error is above the accuracy: more rows or columns where these leave too
/// much, and more rows for the crest.
ElementCounts refined_counts(const ElementCounts& counts, const ErrorEstimate& error,
                             double accuracy);

} // namespace wrc
