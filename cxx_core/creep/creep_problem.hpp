/// The tangential problem of a patch on its own pressures, and what its solution says of the patch.
///
/// The problem is in the rolling frame (rolling_frame.hpp), on a grid of its own (creep_grid.hpp):
/// pressures interpolated and scaled to the patch's normal force, and the slip of each element
/// beyond creepages, and that by pressures where rows are inclined
/// (rolling/curve_displacement.hpp). How it is solved is up to the caller. Left-hand frame of the
/// side. Units mm, N, MPa, rad. Thread rule: plain values.
#pragma once

#include <vector>

#include "base/grid.hpp"
#include "creep/creep_rates.hpp"
#include "creep/creep_request.hpp"
#include "creep/patch_motion.hpp"
#include "records/wheel_result.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/curve_displacement.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// A patch, its motion and what is requested of it.
struct PatchTask {
  const WheelResult& wheel;
  const PatchResult& patch;
  const PatchMotion& motion;
  const CreepRequest& request;
  const PatchRates* rates; ///< none where they are not known
};

class CreepProblem {
public:
  /// Fills in grid, pressures and elements of `creep`. What the task refers to must stay.
  CreepProblem(const PatchTask& task, LinePlans& plans, CreepResult& creep);
  CreepProblem(const CreepProblem&) = delete;
  CreepProblem& operator=(const CreepProblem&) = delete;
  ~CreepProblem() = default;

  /// Its fields belong to this object.
  [[nodiscard]] const RollingProblem& rolling() const { return problem_; }
  /// Requests derivatives by positions, where they are known (of like bodies), and by the slip
  /// beyond creepages.
  void request_rates();
  /// Fills in what a solution has of fields, areas, derivatives, error and power.
  CreepForces take(RollingSolution solution, CreepResult& creep) const;

private:
  PatchTask task_;
  LinePlans& plans_;
  Grid grid_; ///< of the patch's plane
  std::vector<SlipRow> rows_;
  SlipField slip_;       ///< in the patch's plane
  ProblemFields fields_; ///< in the rolling frame, as the problem's
  std::vector<ProblemRate> rates_;
  std::vector<double> angles_;   ///< of rows along a curve, in the rolling frame
  SlipByPressures by_pressures_; ///< likewise
  RollingProblem problem_;
  double error_of_elements_ = 0.0;
};

} // namespace wrc
