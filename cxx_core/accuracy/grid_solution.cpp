#include "accuracy/grid_solution.hpp"

#include <algorithm>

#include "base/reductions.hpp"
#include "remesh/met_distance.hpp"

namespace wrc {

double Patch::overlap() const {
  const double least = least_of(undeformed_distance.data(), undeformed_distance.size());
  const auto index = static_cast<std::size_t>(
      std::find(undeformed_distance.begin(), undeformed_distance.end(), least) -
      undeformed_distance.begin());
  const std::size_t columns_of_grid = grid.longitudinal_count;
  const std::size_t row = index / columns_of_grid;
  const std::size_t column = index % columns_of_grid;
  double deepest = least;
  const auto deepen = [&](double before, double after) {
    const double curvature = before - 2.0 * least + after;
    if (curvature > 0.0 && is_met(before) && is_met(after)) { // not beside the end of a body
      deepest -= (after - before) * (after - before) / (8.0 * curvature);
    }
  };
  if (row > 0 && row + 1 < grid.lateral_count) {
    deepen(undeformed_distance[index - columns_of_grid],
           undeformed_distance[index + columns_of_grid]);
  }
  if (column > 0 && column + 1 < columns_of_grid) {
    deepen(undeformed_distance[index - 1], undeformed_distance[index + 1]);
  }
  return -deepest;
}

bool GridSolution::no_contact() const {
  return std::all_of(patches.begin(), patches.end(),
                     [](const Patch& patch) { return patch.no_contact(); });
}

double GridSolution::peak_pressure() const {
  double peak = 0.0;
  for (const Patch& patch : patches) {
    peak = std::max(peak, patch.contact.peak_pressure);
  }
  return peak;
}

Vector3 GridSolution::force() const {
  Vector3 sum;
  for (const Patch& patch : patches) {
    sum = sum + patch.contact_force.force;
  }
  return sum;
}

Vector3 GridSolution::force_of_main() const {
  std::size_t first = main;
  while (first > 0 && patches[first].penetration.shares_plane_with_previous) {
    --first;
  }
  Vector3 sum = patches[first].contact_force.force;
  for (std::size_t k = first + 1;
       k < patches.size() && patches[k].penetration.shares_plane_with_previous; ++k) {
    sum = sum + patches[k].contact_force.force;
  }
  return sum;
}

double GridSolution::sharpest_ridge() const {
  double sharpest = 0.0;
  for (const Patch& patch : patches) {
    sharpest = std::max(sharpest, patch.ridge);
  }
  return sharpest;
}

std::vector<PlanePatches> GridSolution::patches_by_plane(bool solved) const {
  std::vector<PlanePatches> planes;
  bool begins = true;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Patch& patch = patches[k];
    begins = begins || !patch.penetration.shares_plane_with_previous;
    if (solved && patch.no_contact()) {
      continue;
    }
    if (begins) {
      planes.emplace_back();
    }
    begins = false;
    planes.back().patches.push_back(k);
    planes.back().normal_force += patch.normal_force;
  }
  for (PlanePatches& plane : planes) {
    std::stable_sort(plane.patches.begin(), plane.patches.end(),
                     [this](std::size_t one, std::size_t other) {
                       return patches[one].normal_force > patches[other].normal_force;
                     });
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const PlanePatches& one, const PlanePatches& other) {
                     return one.normal_force > other.normal_force;
                   });
  return planes;
}

} // namespace wrc
