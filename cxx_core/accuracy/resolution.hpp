/// How many elements an accuracy takes, and how far off a solution on them is.
///
/// Elements are counted by the contact's own scale (pressure/contact_scale.hpp): with n rows over
/// its width and 0.64 n columns over its length, depth, forces and centre of pressure have an error
/// below 0.2231/n^2 + 12.125/n^4 in 97 of 100 wheels; with the position prescribed, where a force
/// goes with the depth to the power of 1.5, 1.25 times as much. The penetration shows the scale
/// before anything is solved (expected_contact.hpp), so that the same accuracy takes the same n
/// whatever the contact looks like: one that fills a fifth of its penetration, lobes, or contact
/// askew in its grid. Columns are an even number, the same for all contacts: the longest line
/// begins and ends between elements, where an edge leaves the smallest error. Element sizes vary
/// continuously with the scene, and the grid is anchored at the centre of the forces, so that
/// elements at the edges move least. The largest pressure, taken from a finer section
/// (peak_section.hpp), has the same error and that of its crest besides; where the wheel has a flat
/// it may also have a crest along the rail, which its second difference there shows. A gap that
/// bends along the rail (remesh/bend_along.hpp) takes more columns, and its error does not follow
/// the law below a fifth of the accuracy. If a profile has a kink under the pressures, forces also
/// have an error of first order in the rows. The area
/// of contact is not counted: it is right to 11 to 22 accuracies. A patch that has just formed or
/// is about to lift is on fewer rows: its error counts for forces as far as it carries the load.
/// Creep forces need more elements than normal ones, by a law of their own: they follow from the
/// shape of the contact, whose errors average out in normal forces, and a long contact needs more
/// elements along it. Units mm. Thread rule: pure functions. Not known here: errors of planes
/// (model_error.hpp) and of the half-space, and crests that the penetration does not show.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "accuracy/expected_contact.hpp"
#include "accuracy/grid_solution.hpp"

namespace wrc {

/// What a solution is to be accurate in, and how.
struct AccuracyGoal {
  double accuracy = 1e-3;
  bool position_is_prescribed = false;
  Elements elements = Elements::smooth;
  bool creep_forces = false; ///< whether pressures are to serve these, too
  bool stresses = false;     ///< likewise
  bool forces_only = false;  ///< whether the largest pressure need not be accurate

  /// That its normal contact is solved to: coarsest_accuracy where less is requested.
  [[nodiscard]] double of_contact() const;
};

struct ElementCounts {
  std::size_t lateral = 0;
  std::size_t longitudinal = 0;
};

/// Elements over the penetration of each patch, for solutions that find the depth of a load.
ElementCounts coarse_counts();

/// Sizes of a patch's elements, and between which of them the contact has its middle.
struct PatchElements {
  double mean_x = 0.0; ///< of the patch's penetration, and ...
  double mean_y = 0.0; ///< ... across the rail
  double lateral_step = 0.0;
  double longitudinal_step = 0.0;
  double middle = 0.5; ///< of the forces across the rail, relative to the width in the plane
};

/// For the accuracy, by the contacts that are to be expected.
std::vector<PatchElements> final_elements(std::span<const ExpectedContact> contacts,
                                          const AccuracyGoal& goal);

/// Relative errors of the results that the accuracy covers.
struct ErrorEstimate {
  double elements = 0.0;  ///< by the law; of forces, each patch by its share of the load
  double edges = 0.0;     ///< of moments and place, by where in their rows contact ends; likewise
  double iteration = 0.0; ///< remaining error of the iteration
  double crest = 0.0;     ///< what a section has not resolved
  double along = 0.0;     ///< of the largest pressure: what columns leave of a crest along the rail
  double ridge = 0.0;     ///< error due to a kink of a profile, on any number of rows
  /// What the iteration and the edges leave is independent of the rest.
  [[nodiscard]] double total() const {
    return std::hypot(columns_too() + crest + ridge, edges, iteration);
  }
  /// Without what the largest pressure and the edges add.
  [[nodiscard]] double of_forces() const { return std::hypot(elements + ridge, iteration); }
  /// What a second grid is for.
  [[nodiscard]] double reducible() const { return std::hypot(columns_too() + crest, iteration); }

private:
  [[nodiscard]] double columns_too() const { return std::max(elements, along); }
};
ErrorEstimate estimate_error(const GridSolution& solution, const AccuracyGoal& goal);

/// For a solution whose error exceeds the accuracy: more rows or columns where these leave too
/// much, and more rows for the crest. Without those for the crest, 120 wheelsets across the track
/// take 21 (S1002 / 60E1) to 55 % (S1002 / 56E1) fewer instructions at 1e-3, but accuracies of
/// pressures are met on fewer wheels (wrc_tradeoff --scenes 130): 99.6 instead of 100 % at 1e-2,
/// 99.2 instead of 100 at 3e-3, 97.3 instead of 100 at 1e-3, 98.1 instead of 99.6 at 3e-4. Without
/// any second grid 96.9 % at 1e-3. All of these misses are reported.
std::vector<PatchElements> finer_elements(const GridSolution& solution, const ErrorEstimate& error,
                                          const AccuracyGoal& goal);

} // namespace wrc
