#include "creep/patch_coefficients.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "creep/creep_forces.hpp"
#include "records/wheel_result.hpp"
#include "rolling/constants.hpp"

namespace wrc {
namespace {

/// Creep forces of unit creepages, one after the other: longitudinal, lateral, spin.
using UnitForces = std::array<CreepResult, 3>;

/// Of solutions of a patch, or of a part of one.
KalkerCoefficients coefficients_of(const PatchResult& patch, const UnitForces& forces,
                                   double mirror, double modulus) {
  // In the left-hand frame, about the centre of pressure and by creepages there.
  const double x = patch.contact.centroid_longitudinal;
  const double y = patch.contact.centroid_lateral;
  const auto by = [&](const CreepResult& creep) {
    const double lateral = mirror * creep.lateral_force;
    return std::array{creep.longitudinal_force, lateral,
                      mirror * creep.spin_moment + y * creep.longitudinal_force - x * lateral};
  };
  const std::array along = by(forces[0]);
  const std::array across = by(forces[1]);
  std::array turning = by(forces[2]);
  const double spin = mirror * forces[2].creepages.spin;
  const double longitudinal = spin * y - forces[2].creepages.longitudinal;
  const double lateral = -spin * x - mirror * forces[2].creepages.lateral;
  for (std::size_t i = 0; i < turning.size(); ++i) {
    turning[i] = (turning[i] + longitudinal * along[i] + lateral * across[i]) / spin;
  }
  const double area = patch.semi_axis_longitudinal * patch.semi_axis_lateral;
  const double scale = -1.0 / (modulus * area);
  return {scale * along[0], scale * across[1],
          0.5 * scale * (turning[1] - across[2]) / std::sqrt(area), scale * turning[2] / area};
}

/// Adds a solution's coefficients with a weight.
void add_to(HeapOptional<KalkerCoefficients>& sum, double weight, const KalkerCoefficients& found) {
  const KalkerCoefficients before = sum ? *sum : KalkerCoefficients{};
  sum = KalkerCoefficients{before.c11 + weight * found.c11, before.c22 + weight * found.c22,
                           before.c23 + weight * found.c23, before.c33 + weight * found.c33};
}

} // namespace

void find_patch_coefficients(WheelResult& wheel, const CreepRequest& options,
                             RollingSolver& solver) {
  CreepRequest request = options;
  request.model = CreepModel::full;
  request.friction = {};
  request.friction.coefficient = no_slip_friction;
  request.material.difference_parameter = 0.0;
  request.derivatives = false;
  for (PatchResult& patch : wheel.patches) {
    if (!(patch.normal_force > 0.0) || (patch.pressure.empty() && patch.parts.empty())) {
      continue;
    }
    // Where all adheres, errors fall with the size of elements, which fall with the root of the
    // accuracy: those of twice the size tell what is left.
    for (const bool fine : {false, true}) {
      request.accuracy = (fine ? 1.0 : 4.0) * options.accuracy;
      const double weight = fine ? 2.0 : -1.0;
      UnitForces whole;
      std::vector<UnitForces> parts(patch.parts.size());
      const double mirror = wheel.details.mirror;
      const std::array units{Creepages{1.0, 0.0, 0.0}, Creepages{0.0, mirror, 0.0},
                             Creepages{0.0, 0.0, mirror}};
      for (std::size_t i = 0; i < units.size(); ++i) {
        request.creepages = units[i];
        std::vector<CreepResult> of_parts;
        whole[i] = creep_of_patch(wheel, patch, request, solver, of_parts);
        for (std::size_t part = 0; part < of_parts.size(); ++part) {
          parts[part][i] = std::move(of_parts[part]);
        }
      }
      const auto add = [&](PatchResult& of, const UnitForces& forces) {
        add_to(of.kalker, weight, coefficients_of(of, forces, mirror, options.material.modulus));
      };
      for (std::size_t i = 0; i < parts.size(); ++i) {
        add(patch.parts[i], parts[i]);
      }
      if (parts.empty()) {
        add(patch, whole);
      }
    }
  }
}

} // namespace wrc
