/// What is said of a wheel's solution where it cannot be trusted.
///
/// Where a wheel has several patches, a warning of one of them begins with its number in the
/// results: "patch 1: ", "patch 0, part 1: ". Warnings of rounding and of depths that do not settle
/// are in depth_checks.hpp, creep forces in creep_forces.hpp. Units mm, MPa, rad. Thread rule: pure
/// functions.
#pragma once

#include "accuracy/grid_solution.hpp"
#include "records/wheel_request.hpp"
#include "records/wheel_result.hpp"
#include "records/wheel_solution.hpp"

namespace wrc {

/// Contact on the last elements, which a neighbour is next to.
bool reaches_neighbour(const Patch& patch);

/// Parts of the error estimate that have a warning of their own.
struct SolutionErrors {
  double ridge = 0.0;
  double interaction = 0.0;
};
/// Warnings of all patches together.
void warn_of_solution(const GridSolution& solution, const WheelRequest& request,
                      double wheel_radius, const SolutionErrors& errors, WheelSolution& result);
/// Warns of single patches of a result, which are in their final order.
void warn_of_patches(const WheelRequest& request, WheelSolution& result);
/// Warns of a largest pressure that no steel of wheels and rails carries; none of stiffer bodies.
void warn_of_pressure(WheelResult& wheel);

} // namespace wrc
