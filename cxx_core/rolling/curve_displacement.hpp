/// Slip that pressures add along a surface whose rows are inclined to each other.
///
/// Rows whose normals differ push each other aside: with a_i the inclination of a row, to the
/// patch's plane or along a curve, and m and A_xs of half_space/traction_convolution.hpp pressures
/// displace by
///   u_s(i) = sum_j sin(a_i - a_j) m p_j / G,  u_x(i) = sum_j sin((a_i - a_j)/2) A_xs p_j / G,
/// wheel minus rail, s to the left. In steady rolling this is a slip -du/dx of each element.
/// Units mm, N, MPa. Thread rule: that of the plans.
/// Not known here: what tractions displace across, by the same sums with the opposite sign, which
/// opens the gap; what pressures of unlike bodies displace in a plane (unlike_bodies.hpp).
#pragma once

#include <span>
#include <vector>

#include "half_space/influence_cache.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// Per element, over the speed; both empty: none.
struct SlipByPressures {
  std::vector<double> x;
  std::vector<double> y;
};

/// None where no row is inclined. `inclinations`: of the rows by lateral index, rad; empty: none
/// is.
SlipByPressures slip_by_pressures(const RollingProblem& problem,
                                  std::span<const double> inclinations, LinePlans& plans);

/// The same by the means of two by two elements, bilinear between these: for a quarter of the
/// cost. Inclined rows push each other the less the nearer they are, so that the slip is smooth.
/// On 640 wheels (160 at 1e-2 and 1e-3, in planes and along curves) creep forces change by 0.008
/// accuracies in the median, 0.16 on 99 % and 0.25 at most; means of four by four change them by up
/// to 2.
SlipByPressures smooth_slip_by_pressures(const RollingProblem& problem,
                                         std::span<const double> inclinations, LinePlans& plans);

} // namespace wrc
