#include "accuracy/grid_solution.hpp"

#include <algorithm>

#include "base/reductions.hpp"
#include "remesh/met_distance.hpp"

namespace wrc {
namespace {

struct PatchLoad {
  ContactForce force;
  double normal = 0.0;
  void add(double share, const PatchLoad& other) {
    force.force = force.force + share * other.force.force;
    force.moment = force.moment + share * other.force.moment;
    normal += share * other.normal;
  }
};

/// Of all patches of one penetration, about a place.
PatchLoad load_of_whole(const GridSolution& solution, std::size_t whole, const Vector3& about) {
  PatchLoad sum;
  for (const Patch& patch : solution.patches) {
    if (patch.penetration.whole == whole) {
      const auto& [force, moment] = patch.contact_force;
      sum.add(1.0,
              {{force, moment + cross(patch.frame.origin - about, force)}, patch.normal_force});
    }
  }
  return sum;
}

} // namespace

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

void GridSolution::mix(std::span<const GridSolution> others) {
  if (others.empty()) {
    return;
  }
  std::vector<PatchLoad> changes;
  for (const Patch& patch : patches) {
    const auto load_of = [&patch](const GridSolution& solution) {
      return load_of_whole(solution, patch.penetration.whole, patch.frame.origin);
    };
    const PatchLoad now = load_of(*this);
    PatchLoad change;
    for (const GridSolution& other : others) {
      change.add(other.share, load_of(other));
      change.add(-other.share, now);
    }
    PatchLoad& of_patch = changes.emplace_back();
    of_patch.add(now.normal > 0.0 ? patch.normal_force / now.normal : 0.0, change);
  }
  for (std::size_t k = 0; k < patches.size(); ++k) {
    PatchLoad load{patches[k].contact_force, patches[k].normal_force};
    load.add(1.0, changes[k]);
    patches[k].contact_force = load.force;
    patches[k].normal_force = load.normal;
  }
  const double before = depth;
  for (const GridSolution& other : others) {
    depth += other.share * (other.depth - before);
  }
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
