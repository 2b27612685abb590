/// Solves a scene in all the ways that are compared, each timed beside its error.
///
/// Truth: the half-space on a grid of `truth_grid`, tolerance 1e-8, in double; its own uncertainty
/// is the difference to a grid half as fine in both directions (its error would be a third of that
/// if errors fell with the square of the step, and less where they do not fall so fast).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "wrc_tradeoff/errors.hpp"
#include "wrc_tradeoff/family.hpp"

namespace tradeoff {

inline constexpr std::array<double, 2> truth_grid{576.0, 240.0};
inline constexpr std::array accuracies{1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4};

/// How a scene is solved.
struct Way {
  /// "forces" or "pressures", of which the accuracy is; "double": pressures, in double precision;
  /// "hertz", "kik-piotrowski" or "grid".
  std::string label;
  double accuracy = 0.0;
  std::array<double, 2> grid{}; ///< of "grid"
};

struct Run {
  Way way;
  double time_ms = 0.0;             ///< median
  std::array<WheelError, 2> errors; ///< left and right
};

struct Measured {
  Case scene;
  std::string failure; ///< why there is none; else empty
  std::array<double, 2> truth_pmax{};
  std::array<WheelError, 2> truth_uncertainty;
  std::array<int, 2> patches{};
  std::vector<Run> runs;
};

struct MeasureOptions {
  std::vector<std::string> labels; ///< of the ways
  int repeats = 15;                ///< timed, at most
};

/// All ways with these labels.
std::vector<Way> ways_of(const std::vector<std::string>& labels);

/// Never throws for what a scene may do: that is its `failure`.
Measured measure(const Case& scene, const MeasureOptions& options);

} // namespace tradeoff
