/// Solves a scene in all the ways that are compared, each timed beside its error.
///
/// Truth: the half-space on a grid of `truth_grid`, tolerance 1e-8, in double; its own uncertainty
/// is the difference to a grid half as fine in both directions (its error would be a third of that
/// if errors fell with the square of the step, and less where they do not fall so fast).
/// Each way is solved cold (no position known, profiles and plans kept), and warm: the wheelset
/// moves to and fro by 0.01 mm, and the steps that end in the scene itself are timed.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "wrc_tradeoff/family.hpp"

namespace tradeoff {

inline constexpr std::array<double, 2> truth_grid{576.0, 240.0};
inline constexpr std::array accuracies{1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4};

/// How a scene is solved.
struct Way {
  std::string label; ///< "auto", "double", "hertz", "kik-piotrowski" or "grid"
  double accuracy = 0.0;
  std::array<double, 2> grid{}; ///< of "grid"
};
/// All ways; those with grids by hand for some of the scenes only.
std::vector<Way> all_ways(bool with_grids);

/// Of a wheel; errors relative to the truth.
struct WheelError {
  double pmax = 0.0;
  double approach = 0.0;
  double area = 0.0;
  double normal_force = 0.0;
  std::optional<double> estimate;
  std::optional<double> validity;
  std::string warnings;
  [[nodiscard]] double controlled() const { return std::max(pmax, approach); }
};

struct Run {
  Way way;
  double cold_ms = 0.0;
  double warm_ms = 0.0;           ///< median
  std::array<WheelError, 2> cold; ///< left and right
  std::array<WheelError, 2> warm;
};

struct Measured {
  Case scene;
  std::string failure; ///< why there is none; else empty
  std::array<double, 2> truth_pmax{};
  std::array<double, 2> truth_uncertainty{}; ///< relative, of pmax and approach
  std::array<double, 2> patches{};
  std::vector<Run> runs;
};

struct MeasureOptions {
  int warm_steps = 15; ///< at most
  bool with_grids = false;
};

/// Never throws for what a scene may do: that is its `failure`.
Measured measure(const Case& scene, const MeasureOptions& options);

} // namespace tradeoff
