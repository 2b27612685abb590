/// What can be read off the pressures of a solution: peak, patches, forces, extents.
///
/// Peak: largest value of the quadratic least-squares surface through the 3 x 3 elements around
/// the largest one; its error falls with the square of the step where the pressure is smooth.
/// Patches: connected sets of elements with p > 0, neighbours by edge or corner (8-neighbour).
/// Semi-axes: those of the Hertzian ellipse with the same second moments of pressure,
/// a = sqrt(5 <x^2>), since <x^2> = a^2/5 for p = p0 sqrt(1 - r^2) (Johnson, Contact Mechanics,
/// 1985, eq. 4.27, integrated). Moments are sums over element centres; against Hertz the semi-axes
/// come out too short by about 0.35/n^2, n elements across.
/// Units mm, N, MPa; frame and order of elements of base/grid.hpp. Areas are counted in
/// elements, so they are of order one in the step; contact_area.hpp has better ones. Independent of
/// gaps and of how p was found.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

/// Which edges of the grid carry pressure: the contact may then go on beyond the grid.
struct EdgeContact {
  bool lateral_first = false;
  bool lateral_last = false;
  bool longitudinal_first = false;
  bool longitudinal_last = false;

  [[nodiscard]] bool any() const {
    return lateral_first || lateral_last || longitudinal_first || longitudinal_last;
  }
};

/// Inclusive range of element indices.
struct IndexBox {
  std::size_t lateral_first = 0;
  std::size_t lateral_last = 0;
  std::size_t longitudinal_first = 0;
  std::size_t longitudinal_last = 0;
};

struct PressureRegion {
  double peak_pressure = 0.0;            ///< MPa, from the local fit
  double largest_element_pressure = 0.0; ///< MPa
  double area = 0.0;         ///< mm^2, element count times element area; see contact_area.hpp
  double normal_force = 0.0; ///< N
  double centroid_longitudinal = 0.0;  ///< mm, pressure-weighted
  double centroid_lateral = 0.0;       ///< mm, pressure-weighted
  double semi_axis_longitudinal = 0.0; ///< mm; 0 for a single row of elements
  double semi_axis_lateral = 0.0;      ///< mm; 0 for a single row of elements
  std::size_t element_count = 0;
  std::size_t first_element = 0;   ///< index of the first one with pressure
  std::size_t largest_element = 0; ///< index of the one with the largest pressure
  EdgeContact touches_edge;
  IndexBox box; ///< of the elements with pressure; meaningless when there is none
};

/// Peak pressure by the local fit, MPa. Never below the largest element pressure, which it falls
/// back to at the edge of the grid or of the contact; 0 without pressure.
double peak_pressure(const Grid& grid, std::span<const double> pressure);

/// The connected patches, largest normal force first; equal forces in order of the first element.
std::vector<PressureRegion> pressure_regions(const Grid& grid, std::span<const double> pressure);

/// The same figures over all elements with pressure together.
PressureRegion summarise_pressure(const Grid& grid, std::span<const double> pressure);

} // namespace wrc
