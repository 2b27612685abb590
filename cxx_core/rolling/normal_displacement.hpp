/// How tractions of unlike bodies displace their surfaces across.
///
/// Units mm, MPa. Thread rule: pure function.
#pragma once

#include <span>
#include <vector>

#include "half_space/influence_cache.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// What tractions on the whole grid open the gap by, mm per element: K/(pi G) times the integral of
/// q.(x, y)/r^2.
std::vector<double> normal_displacement(const RollingProblem& problem,
                                        std::span<const double> traction_x,
                                        std::span<const double> traction_y, LinePlans& plans);

} // namespace wrc
