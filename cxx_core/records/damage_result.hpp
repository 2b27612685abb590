/// What contact does to the steel: what is requested of it, and what is found.
///
/// Depths are positive into the body. Units mm, N, MPa. Thread rule: plain values.
#pragma once

#include <optional>

#include "damage/fatigue.hpp"
#include "damage/subsurface_stress.hpp"
#include "damage/wear.hpp"
#include "half_space/constants.hpp"

namespace wrc {

struct DamageRequest {
  bool stress = false;
  bool wear = false;
  bool fatigue = false;
  bool groove = false;
  bool of_wheel = false;       ///< stresses in the wheel instead of the rail
  bool section_across = false; ///< the section of stresses lies across the rail, else along it
  double poisson = 0.3;        ///< of that body
  double shear_yield = usual_shear_yield; ///< k, MPa
  WearRequest law{WearLaw::usfd, 6.75e-7, 3000.0, 1.0};

  [[nodiscard]] bool any() const { return stress || wear || fatigue || groove; }
};

struct WearTotals {
  double tgamma = 0.0;           ///< -(Fx xi + Fy eta), N
  double tgamma_with_spin = 0.0; ///< CreepResult::power_per_speed, N
  std::optional<double> volume;  ///< per distance rolled, mm^2; needs tractions by element
  std::optional<double>
      depth; ///< greatest across the profile, mm; none where pressures have no bound
};

struct Fatigue {
  double friction = 0.0;                ///< utilised: tangential over normal force
  std::optional<double> pressure_ratio; ///< p0/k; none where p0 has no bound
  ShakedownLimits limits;
  std::optional<double> surface_index; ///< likewise
  double rail_damage = 0.0;
};

/// Damage of a patch, or the worst of several; amounts of wear are added.
struct ContactDamage {
  /// Position in the patch's plane, left-hand frame; the estimate includes that of the pressures.
  std::optional<GreatestStress> stress;
  std::optional<WearTotals> wear;
  std::optional<Fatigue> fatigue;
  std::optional<double> groove_depth; ///< greatest of wheel and rail together, mm
};

} // namespace wrc
