/// The frictionless normal contact problem of two bodies, and what a solver answers.
///
/// One or several patches share the approach delta of the bodies. Each patch k has a plane, a grid
/// and undeformed distances of its own. Find pressures p >= 0 with, for each element of patch k,
///   g = h + u - s delta >= 0,  p g = 0,
/// and either the prescribed load, sum s p a b = F over all elements, or the prescribed approach
/// (Johnson, Contact Mechanics, 1985; the paper's equations 9.1 to 9.6). s is the element's share
/// of the approach, by how much its distance falls: the same for a patch, such as the cosine of its
/// angle, or one for each element where the surface turns within it. If delta is the vertical
/// approach, F is the vertical load. The conditions are those of least energy, so the shares in gap
/// and load are the same.
/// Patches are half-spaces of their own, u = A_k p (influence_coefficients.hpp); rows with angles
/// lie along a curve, and influence each other less (box_convolution.hpp). With `interaction`
/// they also lie in one mean plane, and u_k gains coupling_weight[k, l] times what the pressures of
/// patch l cause there (patch_coupling.hpp).
/// Units mm, N, MPa. Pressures are positive in compression, distances positive when apart.
/// Thread rule: plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/grid.hpp"
#include "half_space/influence_coefficients.hpp"
#include "half_space/steel.hpp"

namespace wrc {

struct PatchGap {
  Grid grid;
  /// Undeformed distance h per element centre, mm; may be negative. Finite.
  std::span<const double> undeformed_distance;
  double approach_cosine = 1.0;        ///< s of all elements, in (0, 1]
  std::span<const double> start = {};  ///< pressures to start from, MPa; none: by itself
  std::span<const double> shares = {}; ///< s of each element, positive; none: of all the same
  std::span<const double> angles = {}; ///< of rows along a curve, rad; none: a plane
  /// Factors of rows from these pressures to those that make the bodies yield; none: 1.
  std::span<const double> row_scales = {};
  /// Largest of those pressures that rows, or elements, have carried before; none: 0.
  std::span<const double> carried = {};

  [[nodiscard]] double share(std::size_t element) const {
    return shares.empty() ? approach_cosine : shares[element];
  }
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

struct NormalProblem {
  std::span<const PatchGap> patches; ///< at least one
  double combined_modulus = 0.0;     ///< E*, MPa (half_space/material.hpp)
  /// Exactly one of these two is set.
  std::optional<double> load;     ///< F in N, >= 0
  std::optional<double> approach; ///< delta in mm
  double tolerance = 1e-6;        ///< > 0; of pressures, relative to the largest one of all patches
  /// Fraction of the tolerance by which rounding in single precision may change the pressures, and
  /// results thus differ between instruction sets.
  double rounding_share = 0.1;
  int maximum_iterations = 5000;
  Elements elements = Elements::constant;
  const PatchInteraction* interaction = nullptr; ///< none: the patches do not interact
  std::span<const YieldingBody> yielding = {};   ///< of NormalSolver::solve_yielding alone
};

/// Precision of the iteration's directions. Answers meet the tolerance with both.
enum class Precision { mixed, double_only };

enum class StopReason { tolerance_met, iteration_limit, stagnation };
std::string_view name_of(StopReason reason);

struct NormalSolution {
  struct Patch {
    std::vector<double> pressure; ///< per element, MPa
    double normal_force = 0.0;    ///< sum p a b, N
    /// Of each body that yields: indentation per element, mm (mechanics/yielding.hpp).
    std::vector<std::vector<double>> indentation = {};
  };
  std::vector<Patch> patches;
  double approach = 0.0; ///< mm
  int iterations = 0;
  /// Applications of the influence coefficients to a field over all boxes, on all grids.
  int convolutions = 0;
  StopReason stop_reason = StopReason::tolerance_met;
  /// Estimate of the remaining error of the iteration: largest error of p relative to the largest
  /// p.
  double pressure_error = 0.0;
};

/// How well pressures and approach solve the problem of one patch, in double precision.
struct Residuals {
  double load_balance = 0.0;    ///< |sum s p a b - F| / F; 0 for a prescribed approach
  double least_gap = 0.0;       ///< min g over elements without pressure / largest u; < 0: overlap
  double complementarity = 0.0; ///< max |g| over elements with pressure / largest u
};

/// Largest number of elements a problem may have: a permitted range, not a tuning constant.
inline constexpr std::size_t maximum_element_count = std::size_t{1} << 26;

/// Throws Error(invalid_argument) for a grid outside its permitted ranges; names the argument.
void check_grid(const Grid& grid);

/// Throws Error(invalid_argument) for a problem outside its permitted ranges; names the argument.
void check_problem(const NormalProblem& problem);

/// The patch of a problem of one patch. Throws Error(invalid_argument) like check_problem, and for
/// several patches.
const PatchGap& single_patch(const NormalProblem& problem);

/// Residuals of the pressures of a single patch, from a separate convolution. They apply to any
/// solver's answer. When nothing is displaced (no pressure at all), gaps are taken relative to the
/// distance between the approach and the least undeformed distance. A least gap of 0 is reported
/// when every element carries pressure. Throws Error(invalid_argument) like single_patch, and for a
/// pressure span of another size.
Residuals compute_residuals(const NormalProblem& problem, std::span<const double> pressure,
                            double approach);

/// The same for displacements that the caller has just computed from these very pressures.
Residuals compute_residuals(const NormalProblem& problem, std::span<const double> pressure,
                            std::span<const double> displacement, double approach);

/// The paper's method for a single patch: Polonsky & Keer, Wear 231 (1999) 206-219, with DC-FFT
/// convolution. The tolerance is that of its gaps (polonsky_keer.cpp), and nothing is started from.
/// Throws Error(invalid_argument) like single_patch.
NormalSolution solve_with_polonsky_keer(const NormalProblem& problem);

} // namespace wrc
