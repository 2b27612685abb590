/// How many elements an accuracy takes, and how far off a solution on them is.
///
/// Grids span the virtual penetration of a patch, of which contact takes about 0.7 each way. With n
/// rows over it, depth, forces and centre of pressure have an error below 2.6 n^-2.18 in 97 of 100
/// wheels, half of them a third of it or more; the force at a prescribed position 1.5 times as
/// much, since it goes with the depth to the power of 1.5. The law alone decides about grids for
/// forces, which makes results continuous in the scene, and it is the estimate: two grids compared
/// tell no more about a single wheel (docs/accuracy.md). The area of contact is not counted: it is
/// right to about forty accuracies.
///
/// The largest pressure takes what the narrowest crest asks for: where the curvature of a profile
/// jumps inside the contact, pressures have crests of tenths of a millimetre. A crest is measured
/// by the elements m under a semi-ellipse with its top value and second difference, 4/m^2. Along
/// the rail contact is smooth; n elements lie under its crest. In 97 of 100 of 2400 solutions (600
/// wheels, accuracies of 1e-2 to 3e-4) pmax and depth had errors below
///   max((0.03 + 1.6/m)/m^2, 0.2 e) + (0.06 ln(slenderness) + 1.2/n)/n^2,
/// e being the error of integrals and the slenderness, 1 or more, length over width of the contact,
/// in half of them of a third of it or more. Where crests alternate with valleys, as on rough
/// profiles, each counts as a wave with its height H and N rows as well: 64 H/N^4. Averages of the
/// gap over elements in place of its values at their centres were tried: errors of pmax are 5 to 10
/// times as large in the median, and no smaller in the tail. Units: none. Thread rule: pure
/// functions. Not known here: errors of planes and of the half-space; crests narrower than a row
/// (crest_rows.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "scene/accuracy_of.hpp"
#include "scene/grid_solution.hpp"

namespace wrc {

struct ElementCounts {
  std::size_t lateral = 0;
  std::size_t longitudinal = 0;
};

/// Beyond so many rows nothing is refined.
inline constexpr std::size_t most_rows = 1200;

/// What a solution is to be accurate in, and how.
struct AccuracyGoal {
  AccuracyOf of = AccuracyOf::pressures;
  double accuracy = 1e-3;
  bool position_is_prescribed = false;
};

/// For depth or force, forces and moments.
ElementCounts counts_for_forces(const AccuracyGoal& goal);
/// Of the solution before the final one, which finds the depth and, for pressures, crests.
ElementCounts coarse_counts(const AccuracyGoal& goal);
/// Error of pmax, relative, that crests may leave.
double crest_error_for(const AccuracyGoal& goal);
/// For pressures, for each patch of a coarse solution.
std::vector<ElementCounts> counts_for_pressures(const GridSolution& coarse,
                                                const AccuracyGoal& goal);

/// Likewise for a solution whose error is above the accuracy, on as many elements or more; empty if
/// there is no finer grid.
std::vector<ElementCounts> finer_counts(const GridSolution& solution, const AccuracyGoal& goal);

/// Relative error of what the accuracy is of. `coarser_peak`: the largest pressure on the grid
/// before, MPa; at a kink of a profile, where no pressure is bounded, it tells what laws do not.
double estimate_error(const GridSolution& solution, const AccuracyGoal& goal, double coarser_peak);

} // namespace wrc
