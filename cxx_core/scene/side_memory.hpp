/// What a solution of a side leaves for the next one at a neighbouring position.
///
/// Units mm and N; left-hand frame of the side. Thread rule: plain values.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/rail_surface.hpp"
#include "mechanics/normal_contact.hpp"
#include "scene/side_request.hpp"
#include "scene/trial.hpp"

namespace wrc {

/// The error of a trial, estimated on two grids of its position: relative, of pmax and approach.
struct TrialError {
  double lateral = 0.0; ///< what the elements across the rail leave
  double total = 0.0;
};

/// A start, never an answer.
struct SideMemory {
  /// Where contact lay in a patch's rectangle of virtual penetration, as shares of its sides, and
  /// how many elements were enough.
  struct Patch {
    double lateral_first = 0.0, lateral_last = 1.0;
    double longitudinal_first = 0.0, longitudinal_last = 1.0;
    Resolution resolution;
    /// Pressures found, which move along with the plane: a start for the next ones.
    Grid grid;
    std::vector<double> pressure;
    /// When the error was estimated: ends of the penetration, and the largest pressure.
    double y_first = 0.0, y_last = 0.0;
    double peak_pressure = 0.0;
  };
  bool valid = false;
  double depth = 0.0;
  double load = 0.0;       ///< the one prescribed, N
  double lateral = 0.0;    ///< of the wheelset
  double last_move = 0.0;  ///< of the wheelset, to where this is
  double depth_rate = 0.0; ///< by the lateral position over that move, at the same load
  double accuracy = 0.0;
  std::vector<Patch> patches; ///< ordered by y
  /// Estimated on two grids; none if it was not met, or if the grid was given by hand. Without it
  /// the pressures are not those of the last solution.
  std::optional<double> error_estimate;
  bool slid = false; ///< the last step's distances had to be sampled at another depth, once more

  /// The same contact under another load: by Hertz the approach goes with it to the power of 2/3.
  [[nodiscard]] double depth_under(double other_load) const;
  /// The depth expected under another load at another place.
  [[nodiscard]] double expected_depth(double other_load, double other_lateral) const;
  /// `error`: none if it was not estimated at this position. What is known of it from before stays
  /// in force if the trial was made `as_before`, from this memory. `grid_accuracy`: the accuracy
  /// that the grids were made for. `at`: the wheelset's lateral position.
  void remember(const RailSurface& rail, const SideRequest& request, double at, const Trial& trial,
                const std::optional<TrialError>& error, bool as_before, double grid_accuracy);
  /// Whether the ends of penetration have hardly moved since the error was estimated.
  [[nodiscard]] bool places_are_near(std::span<const PatchPlan> patches) const;
  /// Whether pressures and elements of a trial are such that the estimate still holds.
  [[nodiscard]] bool estimate_holds(const Trial& trial) const;
  /// The last pressures, moved along with the planes: a third less time for steps of 0.1 % of a
  /// patch, a tenth for those of a hunting motion (docs/performance.md).
  [[nodiscard]] std::vector<std::optional<StartPressure>> starts() const;
};

} // namespace wrc
