/// The frictionless normal contact problem on a grid, and what a solver answers.
///
/// Find pressures p >= 0 with, for each element,
///   g = h + u - approach >= 0,  p g = 0,  u = A p  (half-space, see influence_coefficients.hpp),
/// and either the prescribed normal load, sum p a b = Q, or the prescribed approach
/// (Johnson, Contact Mechanics, 1985; the paper's equations 9.1 to 9.6).
/// Units mm, N, MPa. Pressures are positive in compression, distances positive when apart.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/grid.hpp"
#include "half_space/influence_coefficients.hpp"

namespace wrc {

struct NormalProblem {
  Grid grid;
  /// Undeformed distance h per element centre, mm; may be negative. Finite.
  std::span<const double> undeformed_distance;
  double combined_modulus = 0.0; ///< E*, MPa (half_space/material.hpp)
  /// Exactly one of these two is set.
  std::optional<double> normal_load; ///< Q in N, >= 0
  std::optional<double> approach;    ///< mm
  double tolerance = 1e-6;           ///< relative, > 0
  int maximum_iterations = 5000;
  Elements elements = Elements::constant;
};

enum class StopReason { tolerance_met, iteration_limit, stagnation };
std::string_view name_of(StopReason reason);

/// Recomputed from the final pressures in double precision, after the iteration has ended.
struct Residuals {
  double load_balance = 0.0;    ///< |sum p a b - Q| / Q; 0 for a prescribed approach
  double least_gap = 0.0;       ///< min g over elements without pressure / largest u; < 0: overlap
  double complementarity = 0.0; ///< max |g| over elements with pressure / largest u
};

struct NormalSolution {
  std::vector<double> pressure;     ///< per element, MPa
  std::vector<double> displacement; ///< u per element, both bodies together, mm; may be left empty
  double approach = 0.0;            ///< mm
  double normal_force = 0.0;        ///< sum p a b, N
  int iterations = 0;
  StopReason stop_reason = StopReason::tolerance_met;
  /// Estimate of what the iteration left: largest error of p relative to the largest p.
  double pressure_error = 0.0;
  Residuals residuals; ///< filled together with the displacement
};

/// Largest number of elements a problem may have: a permitted range, not a tuning constant.
inline constexpr std::size_t maximum_element_count = std::size_t{1} << 26;

/// Throws Error(invalid_argument) for a grid outside its permitted ranges; names the argument.
void check_grid(const Grid& grid);

/// Throws Error(invalid_argument) for a problem outside its permitted ranges; names the argument.
void check_problem(const NormalProblem& problem);

/// How well these pressures and this approach solve the problem, from a convolution of its own.
/// Any solver's answer can be judged with it. When nothing is displaced (no pressure at all), gaps
/// are taken relative to the distance between the approach and the least undeformed distance. A
/// least gap of 0 is reported when every element bears pressure.
/// Throws Error(invalid_argument) like check_problem, and for a pressure span of another size.
Residuals compute_residuals(const NormalProblem& problem, std::span<const double> pressure,
                            double approach);

/// The same for displacements that the caller has just computed from these very pressures.
Residuals compute_residuals(const NormalProblem& problem, std::span<const double> pressure,
                            std::span<const double> displacement, double approach);

/// The paper's method: Polonsky & Keer, Wear 231 (1999) 206-219, with DC-FFT convolution.
/// Throws Error(invalid_argument) on sizes, values or tolerances outside their range.
NormalSolution solve_with_polonsky_keer(const NormalProblem& problem);

} // namespace wrc
