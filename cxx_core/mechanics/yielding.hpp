/// What bodies that yield add to the normal contact problem, and its solution.
///
/// With P_b what body b takes of the pressures beyond its elastic range (half_space/steel.hpp), and
/// c_b its stiffness, the energy of contact is
///   1/2 p.A p + sum_b c_b/2 P_b.A P_b + p.(h - s delta),  p >= 0,
/// so gaps are h + A p + w - s delta with the indentation of the steel
///   w = sum_b c_b P_b' A P_b,
/// and how they change with the pressures is
///   H v = A v + sum_b [c_b P_b' A (P_b' v) + c_b P_b'' (A P_b) v]     (products by element).
/// The energy is convex, since P_b is convex and growing in p and no entry of A is negative (along
/// a curve as long as it turns by less than 90 degrees): one solution, whatever it starts from.
/// With p below the onset everywhere it is the elastic one.
///
/// Steel pressed again (PatchGap::carried) takes only what it has not taken before: P_b begins at
/// the pressure carried (excess_of of half_space/steel.hpp). The dent w of the pressing before is
/// then part of h. The energy stays convex.
///
/// Newton's method on the elements in contact, C = {p > 0 or gap < 0}: H v = -gap on C by conjugate
/// gradients, v without load if the load is given, then p = max(0, p + v), less of it where that
/// has more energy. Preconditioned by E M E + (1 - E^2)/diag(H), M the inverse of the periodic
/// convolution as in projected_cg.hpp and E^2 = diag(A)/diag(H): M where steel is elastic; where it
/// yields, the product with A P_b dominates. Whole grids, in double precision: contact cannot
/// leave the penetration that they cover, however much it grows.
/// Pressures are those of solvers (normal_contact.hpp), 1/row_scales of a patch's own.
/// Units mm, N, MPa. Thread rule: pure functions; a cache serves one thread at a time.
#pragma once

#include <span>
#include <vector>

#include "half_space/influence_cache.hpp"
#include "half_space/steel.hpp"
#include "mechanics/normal_contact.hpp"

namespace wrc {

/// Of a patch: for each body sqrt(c_b) times P_b and its derivatives by a solver's pressure.
struct YieldTerms {
  using Fields = std::vector<std::vector<double>>;
  Fields excess;
  Fields slope;     ///< no unit
  Fields curvature; ///< 1/MPa

  /// `scales`: of rows; none: 1. `carried`: of PatchGap.
  YieldTerms(const Grid& grid, std::span<const double> pressure, std::span<const double> scales,
             std::span<const YieldingBody> bodies, std::span<const double> carried = {});
  /// Adds to displacements what body b adds to gaps, from A times its excess.
  void add_indentation(std::size_t b, std::span<const double> by_excess,
                       std::span<double> displacement) const;
};

/// Solves the problem with bodies that yield, from pressures near the answer in `start` of each
/// patch. The tolerance is that of the last step of the pressures, relative to the largest one.
NormalSolution solve_yielding(const NormalProblem& problem, InfluenceCache& cache);

} // namespace wrc
