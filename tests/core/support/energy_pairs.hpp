/// Forces of frictionless contact against the energy that they derive from.
///
/// A left wheel at a prescribed position: forces along its lateral position y, height z and roll,
/// about the axis of which the moment counts. Their derivatives by each other's coordinate are
/// equal, from central differences of whole scenes and from the sensitivities reported; and each is
/// minus the derivative of the elastic energy, E = sum p u dA/2, where u = -h under pressure; of
/// steel that yields with more of it (mechanics/yielding.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "creep/total_force.hpp"
#include "derivatives/wheel_rates.hpp"
#include "half_space/displacement_operator.hpp"
#include "mechanics/yielding.hpp"
#include "profile/profile.hpp"
#include "remesh/row_scales.hpp"
#include "scene/solve_scene.hpp"
#include "support/random_wheels.hpp"

namespace wrc::test {

/// Along y, z and the roll; moments over this arm, N.
inline constexpr double energy_arm = 750.0;
using CoordinateForces = std::array<double, 3>;

/// A case of force_direction.json: values of an independent solver of curved patches. Its file
/// states a Poisson's ratio of 0.3; its heights are those of 0.28.
inline Scene scene_of_direction(const nlohmann::json& entry) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = entry.at("wheel");
  scene.left.rail.name = scene.right.rail.name = entry.at("rail");
  scene.wheel_material.poisson = scene.rail_material.poisson = 0.28;
  scene.lateral = entry.at("lateral_mm");
  scene.yaw = entry.at("yaw_rad");
  scene.roll = entry.at("roll_rad").get<double>();
  scene.left.load = scene.right.load = entry.at("vertical_load_N");
  scene.side = SideChoice::left;
  scene.accuracy = 3e-4;
  return scene;
}

/// Prescribes the position that the load asks for.
inline void stay_where_loaded(Scene& scene) {
  const SceneResult under_load = solve_scene(scene);
  scene.roll = under_load.roll;
  scene.vertical = under_load.left->vertical - under_load.left->depth;
}

/// All built-in wheels and rails, tread to flange, 20 to 130 kN; every other one with yaw. The
/// position is the one that this load asks for.
inline Scene frictionless_wheel(Draw& draw, int index) {
  const std::vector<std::string_view> wheels = standard_profile_names(ProfileKind::wheel);
  const std::vector<std::string_view> rails = standard_profile_names(ProfileKind::rail);
  Scene scene;
  const auto number = static_cast<std::size_t>(index);
  scene.left.wheel.name = scene.right.wheel.name = wheels[number % wheels.size()];
  scene.left.rail.name = scene.right.rail.name = rails[number / wheels.size() % rails.size()];
  scene.back_to_back = scene.left.wheel.name == "S1002" ? 1360.0 : 1353.0;
  scene.lateral = draw.between(-7.0, 9.0);
  scene.yaw = index % 2 == 0 ? 0.0 : draw.between(-0.01, 0.01);
  scene.left.load = scene.right.load = std::pow(10.0, draw.between(4.3, 5.1));
  scene.side = SideChoice::left;
  scene.accuracy_of = AccuracyOf::forces;
  scene.accuracy = 1e-4;
  stay_where_loaded(scene);
  return scene;
}

/// Of steel that yields, in its own patch, that by which the energy differs from half the product
/// of pressures and distances: sum_b c_b (p P_b' - P_b).A P_b.
inline double yielding_sum(const PatchResult& patch, const WheelDetails& details) {
  const std::vector<double> pressure = over_scales(patch.grid, patch.row_scales, patch.pressure);
  const YieldTerms terms(patch.grid, pressure, patch.row_scales, yielding_of(patch, details));
  DisplacementOperator displace(patch.grid, details.request.combined_modulus,
                                details.request.elements, row_angles(patch.frame, patch.grid));
  double sum = 0.0;
  for (std::size_t b = 0; b < terms.excess.size(); ++b) {
    std::vector<double> by_excess(pressure.size());
    displace.apply(terms.excess[b], by_excess);
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      sum += (pressure[i] * terms.slope[b][i] - terms.excess[b][i]) * by_excess[i];
    }
  }
  return sum;
}

inline double elastic_energy(const WheelResult& wheel) {
  double energy = 0.0;
  for (const PatchResult* patch : solved_patches(wheel)) {
    double sum = yielding_sum(*patch, wheel.details);
    for (std::size_t i = 0; i < patch->pressure.size(); ++i) {
      sum -= patch->pressure[i] * patch->undeformed_distance[i];
    }
    energy += 0.5 * patch->grid.element_area() * sum;
  }
  return energy;
}

/// Of forces and a moment about the wheelset's centre, without forces of friction.
inline CoordinateForces along_coordinates(const Vector3& force, const Vector3& moment, double yaw) {
  return {force.y, force.z, (std::cos(yaw) * moment.x + std::sin(yaw) * moment.y) / energy_arm};
}

struct EnergyErrors {
  double pairs = 0.0;         ///< by differences of forces
  double sensitivities = 0.0; ///< their pairs
  double reported = 0.0;      ///< sensitivities against differences
  double energy = 0.0;        ///< its derivatives against the forces, over the amount of the force
  std::size_t patches = 0;
  double partial = 0.0; ///< how far from 0 and 1 the coupling weights of patches are
};

/// Over the mean of the two stiffnesses of a pair.
inline double largest_asymmetry(const std::array<CoordinateForces, 3>& rates) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      largest = std::max(largest, std::abs(rates[i][j] - rates[j][i]) /
                                      std::sqrt(std::abs(rates[i][i] * rates[j][j])));
    }
  }
  return largest;
}

inline CoordinateForces forces_of(const WheelResult& wheel, double yaw) {
  const WheelForce total = total_force(wheel);
  return along_coordinates(total.force, total.moment, yaw);
}

/// By each coordinate: of the forces, and of the energy.
struct EnergyDifferences {
  std::array<CoordinateForces, 3> forces{};
  CoordinateForces energy{};
};

/// Of the fourth order: forces and energies go with powers of the depth.
inline EnergyDifferences energy_differences(const Scene& scene, double step) {
  EnergyDifferences result;
  for (std::size_t j = 0; j < 3; ++j) {
    for (const auto& [steps, weight] : {std::pair(1.0, 4.0 / 3.0), std::pair(2.0, -1.0 / 3.0)}) {
      for (const double sign : {-1.0, 1.0}) {
        Scene moved = scene;
        const double by = sign * steps * step;
        (j == 0   ? moved.lateral
         : j == 1 ? *moved.vertical
                  : *moved.roll) += j == 2 ? by / energy_arm : by;
        const SceneResult there = solve_scene(moved);
        const double share = sign * weight / (2.0 * steps * step);
        const CoordinateForces forces = forces_of(*there.left, scene.yaw);
        for (std::size_t i = 0; i < 3; ++i) {
          result.forces[i][j] += share * forces[i];
        }
        result.energy[j] += share * elastic_energy(*there.left);
      }
    }
  }
  return result;
}

/// Where the stiffness changes within a step, at the birth of a lobe or where a kink of a profile
/// enters, differences are no derivatives: over two steps, the better ones count.
inline EnergyErrors energy_errors(const Scene& scene) {
  SceneResult here = solve_scene(scene);
  WheelResult& wheel = *here.left;
  const CoordinateForces forces = forces_of(wheel, scene.yaw);
  const double amount = std::hypot(forces[0], forces[1]);
  const auto rates = wheel_rates_of(wheel);
  const ForceRates& reported = rates->force;
  const std::array<const WheelForce*, 3> by{&reported.lateral, &reported.vertical, &reported.roll};
  std::array<CoordinateForces, 3> sensitivities{};
  for (std::size_t j = 0; j < 3; ++j) {
    const CoordinateForces rate = along_coordinates(by[j]->force, by[j]->moment, scene.yaw);
    for (std::size_t i = 0; i < 3; ++i) {
      sensitivities[i][j] = rate[i] / (j == 2 ? energy_arm : 1.0);
    }
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EnergyErrors errors{infinity, largest_asymmetry(sensitivities), infinity, infinity};
  for (const double step : {2e-3, 4e-3}) { // mm
    const EnergyDifferences differences = energy_differences(scene, step);
    errors.pairs = std::min(errors.pairs, largest_asymmetry(differences.forces));
    double reported_error = 0.0;
    double energy_error = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      energy_error = std::max(energy_error, std::abs(differences.energy[i] + forces[i]) / amount);
      for (std::size_t j = 0; j < 3; ++j) {
        reported_error =
            std::max(reported_error,
                     std::abs(sensitivities[i][j] - differences.forces[i][j]) /
                         std::sqrt(std::abs(differences.forces[i][i] * differences.forces[j][j])));
      }
    }
    errors.reported = std::min(errors.reported, reported_error);
    errors.energy = std::min(errors.energy, energy_error);
  }
  errors.patches = solved_patches(wheel).size();
  if (wheel.details.interaction) {
    for (const double weight : wheel.details.interaction->coupling_weight) {
      errors.partial = std::max(errors.partial, std::min(weight, 1.0 - weight));
    }
  }
  return errors;
}

} // namespace wrc::test
