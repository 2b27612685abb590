/// One wheel as it was solved: patches with their pressures, and what is known of them together.
///
/// Units mm, N, MPa, rad; left-hand frame of the side (geometry/frames.hpp). Thread rule: plain
/// values.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "accuracy/grid_solution.hpp"
#include "base/warning.hpp"
#include "mechanics/normal_contact.hpp"
#include "records/wheel_request.hpp"

namespace wrc {

struct StageTimes {
  double remesh = 0.0; ///< s
  double mechanics = 0.0;
};

struct WheelSolution {
  WheelRequest request; ///< that was solved
  bool in_contact = false;
  bool solved = false; ///< the mechanics have run
  /// With pressure only. By contact, the one with the largest normal force first; within a contact
  /// by force, too.
  std::vector<Patch> patches;
  double vertical = 0.0;      ///< height of the wheelset's centre
  double depth = 0.0;         ///< vertical, from the first touch to that height
  std::optional<double> load; ///< vertical, of the normal problem; or the height was prescribed
  std::optional<PatchInteraction> interaction; ///< none: the patches do not interact
  double peak_pressure = 0.0;
  /// Relative, of forces or pressures as the accuracy; none if not known.
  std::optional<double> discretisation_error;
  double force_error = 0.0;          ///< likewise, of forces alone
  std::optional<double> model_error; ///< accuracy/model_error.hpp
  /// Both together; the error of elements is independent of that of planes.
  [[nodiscard]] std::optional<double> error_estimate() const {
    return discretisation_error && model_error
               ? std::optional(std::hypot(*discretisation_error, *model_error))
               : std::nullopt;
  }
  std::optional<double> validity; ///< of an approximate model, see patch_model.hpp
  StopReason stop_reason = StopReason::tolerance_met;
  int iterations = 0;   ///< of all solutions together
  int convolutions = 0; ///< likewise: applications of the influence coefficients
  int solutions = 0;    ///< normal problems solved
  StageTimes times;
  Warnings warnings;
};

} // namespace wrc
