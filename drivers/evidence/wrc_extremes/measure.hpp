/// Solves a point through the public interface and judges the result.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "wrc_extremes/gap_problem.hpp"
#include "wrc_extremes/row.hpp"
#include "wrcontact.hpp"

namespace extremes {

/// The smallest tolerance a scene takes; errors of double precision are measured there.
inline constexpr double tolerance_floor = 1e-13;
/// Elements up to which pressures are compared with elimination in extended precision.
inline constexpr std::size_t most_dense_elements = 512;

/// A gap given directly. With at most `most_dense_elements` its pressures are compared with
/// elimination in long double.
struct NormalCase {
  GapProblem problem;
  double tolerance = tolerance_floor;
};
void measure_normal(const NormalCase& one, Row& row, std::uint64_t seed);

/// What a gap's solution is, for comparisons between problems.
struct NormalAnswer {
  std::vector<double> pressure;
  double approach = 0.0;
  double pmax = 0.0;
};
/// Throws wrcontact::Error.
NormalAnswer solve_normal(const NormalCase& one);

/// A scene, left wheel: solved to 1e-3 or the accuracy it requests, checked patch by patch,
/// compared with itself at a finer accuracy or on a finer grid, and, on a grid of 32 x 16 elements,
/// with elimination in long double.
using SceneSetup = std::function<void(wrcontact::Scene&)>;
struct SceneOptions {
  double finer = 2e-4; ///< accuracy that the result is compared with; 0: none
  bool with_dense = true;
  /// A prescribed grid, rows and columns, to compare with instead. The error may then reach the
  /// library's estimate instead of the accuracy.
  std::vector<double> finer_grid = {};
};
void measure_scene(const SceneSetup& setup, Row& row, std::uint64_t seed,
                   const SceneOptions& options = {});

/// Measures a point, with status, text and verdict of a refusal if the library throws one.
void measure(const Measurement& measurement, Row& row, std::uint64_t seed);

} // namespace extremes
