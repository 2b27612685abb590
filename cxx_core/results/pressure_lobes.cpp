#include "results/pressure_lobes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/reductions.hpp"
#include "geometry/side_frame.hpp"
#include "pressure/lobe_shares.hpp"
#include "remesh/rail_normals.hpp"
#include "results/make_wheel_result.hpp"

namespace wrc {
namespace {

/// Sums over the pressures of some elements.
struct Sums {
  Vector3 force; ///< along the rail's normals; N over the area of an element, as all of these
  double pressures = 0.0;
  double longitudinal = 0.0; ///< first moments
  double lateral = 0.0;
  double longitudinal_square = 0.0; ///< second ones
  double lateral_square = 0.0;

  void add(double share, const Sums& other) {
    force = force + share * other.force;
    pressures += share * other.pressures;
    longitudinal += share * other.longitudinal;
    lateral += share * other.lateral;
    longitudinal_square += share * other.longitudinal_square;
    lateral_square += share * other.lateral_square;
  }
};

std::vector<Sums> sums_of_rows(const PatchResult& patch, const RailSurface& rail) {
  const Grid& grid = patch.grid;
  const RailNormals normals(rail, patch.frame, grid);
  std::vector<Sums> rows(grid.lateral_count);
  const double* pressure = patch.pressure.data();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < grid.longitudinal_count; ++j, ++pressure) {
      if (*pressure > 0.0) {
        const double along = grid.longitudinal(j);
        const double across = grid.lateral(i);
        rows[i].add(*pressure,
                    {normals.direction(i, j), 1.0, along, across, along * along, across * across});
      }
    }
  }
  return rows;
}

/// Of the Hertzian ellipse (pressure/pressure_field.hpp).
double semi_axis(double variance) {
  return std::sqrt(5.0 * std::max(0.0, variance));
}

void add_lobes(const PatchResult& patch, const WheelDetails& side,
               std::vector<PressureLobe>& lobes) {
  if (patch.pressure.empty()) {
    return;
  }
  const SideFrame frame(side.mirror);
  const std::vector<Sums> rows = sums_of_rows(patch, *side.rail);
  std::vector<double> forces;
  Sums whole;
  for (const Sums& row : rows) {
    forces.push_back(row.pressures);
    whole.add(1.0, row);
  }
  // The patch's force has the normals before the last step in depth, or that of a model's plane.
  const double area = patch.grid.element_area();
  const Vector3 rest = patch.contact_force.force - area * whole.force;
  for (const std::vector<double>& shares : lobe_shares(forces)) {
    Sums sums;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      sums.add(shares[i], rows[i]);
    }
    PressureLobe& lobe = lobes.emplace_back();
    lobe.force = frame.mirrored(area * sums.force + (sums.pressures / whole.pressures) * rest);
    lobe.angle = std::atan2(-lobe.force.y, lobe.force.z);
    const double along = sums.longitudinal / sums.pressures;
    const double across = sums.lateral / sums.pressures;
    lobe.centroid = point_on(side.pair(), patch.frame, along, across, frame);
    lobe.semi_axis_longitudinal =
        semi_axis(sums.longitudinal_square / sums.pressures - along * along);
    lobe.semi_axis_lateral = semi_axis(sums.lateral_square / sums.pressures - across * across);
  }
}

} // namespace

std::vector<PressureLobe> pressure_lobes(const PatchResult& patch, const WheelDetails& side) {
  std::vector<PressureLobe> lobes;
  add_lobes(patch, side, lobes);
  std::vector<const PatchResult*> parts;
  for (const PatchResult& part : patch.parts) {
    parts.push_back(&part);
  }
  std::ranges::sort(parts, {}, [](const PatchResult* part) { return part->frame.origin.y; });
  for (const PatchResult* part : parts) {
    add_lobes(*part, side, lobes);
  }
  return lobes;
}

} // namespace wrc
