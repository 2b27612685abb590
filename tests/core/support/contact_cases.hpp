/// Gaps the solver tests share: smooth, split, sharp, rough and flat.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/grid.hpp"

namespace wrc::test {

/// Steel on steel.
inline constexpr double steel_modulus = 210000.0 / 1.82;

struct ContactCase {
  std::string name;
  Grid grid;
  std::vector<double> distance;
};

/// Grid centred at the origin.
Grid centred_grid(std::size_t lateral_count, std::size_t longitudinal_count, double lateral_step,
                  double longitudinal_step);

std::vector<double> hertz_gap(const Grid& grid, double longitudinal_curvature,
                              double lateral_curvature);

/// Hertz, two lobes, wedge, noise, flat punch, and a body that ends in the grid (1e3 mm beside it).
/// Made for a load of 5000 N times the aspect ratio, which fills about half of the grid.
std::vector<ContactCase> contact_cases(std::size_t lateral_count, std::size_t longitudinal_count,
                                       double aspect_ratio);
inline constexpr double case_load = 5000.0;

} // namespace wrc::test
