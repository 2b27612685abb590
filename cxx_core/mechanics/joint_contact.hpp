/// Several contact patches of two bodies, solved together.
///
/// Each patch k has a plane, a grid and undeformed distances of its own; what they share is the
/// approach delta. Find pressures p >= 0 with, for each element of patch k,
///   g = h + u - s_k delta >= 0,  p g = 0,
/// and either the load, sum_k s_k sum p a b = F, or delta is prescribed. s_k is the share of the
/// approach that acts along the patch's normal: the cosine of its angle, if delta is the vertical
/// approach and F the vertical load. The conditions are those of least energy, so the shares in
/// gap and load are the same.
/// Patches are half-spaces of their own, u = A_k p. Elastic interaction: with `coupling` the
/// patches also lie in one mean plane, and u_k gains coupling_weight[k, l] times what the pressures
/// of patch l cause there (patch_coupling.hpp). Units mm, N, MPa. Thread rule: plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/normal_contact.hpp"

namespace wrc {

struct PatchGap {
  Grid grid;
  std::span<const double> undeformed_distance; ///< h per element centre, mm. Finite.
  double approach_cosine = 1.0;                ///< s, in (0, 1]
  std::span<const double> start = {};          ///< pressures to start from, MPa; none: by itself
};

/// Where the patches lie in their mean plane, and how much of their interaction counts.
struct PatchInteraction {
  struct Place {
    double lateral = 0.0; ///< of the origin of the patch's grid, mm
    double longitudinal = 0.0;
  };
  std::vector<Place> places;
  std::vector<double>
      coupling_weight; ///< count x count, symmetric, 0 to 1; the diagonal is not used
};

struct JointProblem {
  std::span<const PatchGap> patches; ///< at least one
  double combined_modulus = 0.0;     ///< E*, MPa
  /// Exactly one of these two is set.
  std::optional<double> load;     ///< F in N, >= 0
  std::optional<double> approach; ///< delta in mm
  double tolerance = 1e-6;        ///< of the pressures, relative to the largest one of all patches
  /// Share of the tolerance by which rounding in single precision may change the pressures, and
  /// results thus differ between instruction sets.
  double rounding_share = 0.1;
  int maximum_iterations = 5000;
  Elements elements = Elements::constant;
  const PatchInteraction* interaction = nullptr; ///< none: the patches do not interact
};

struct JointSolution {
  struct Patch {
    std::vector<double> pressure; ///< per element, MPa
    double normal_force = 0.0;    ///< sum p a b, N
  };
  std::vector<Patch> patches;
  double approach = 0.0; ///< mm
  int iterations = 0;
  /// Applications of the influence coefficients to a field over all boxes, on all grids.
  int convolutions = 0;
  StopReason stop_reason = StopReason::tolerance_met;
  double pressure_error = 0.0; ///< as in NormalSolution
};

/// Throws Error(invalid_argument) for a problem outside its permitted ranges; names the argument.
void check_problem(const JointProblem& problem);

/// The paper's method (mechanics/normal_contact.hpp) for a problem of one patch.
JointSolution solve_with_polonsky_keer(const JointProblem& problem);

} // namespace wrc
