/// Friction too small to compute with.
///
/// Left-hand frame of the side. Thread rule: plain values.
#pragma once

#include <algorithm>
#include <cmath>

#include "creep/constants.hpp"
#include "creep/creep_request.hpp"
#include "creep/patch_motion.hpp"
#include "rolling/creep_laws.hpp"

namespace wrc {

/// Forces are homogeneous in friction and creepages, T(c mu, c w) = c T(mu, w): with so little
/// friction that its products are no numbers, tractions are found with more and as much more
/// creepage. From a creepage of 1 on that makes no difference: all slides.
class LeastFriction {
public:
  /// The linear law does not know friction.
  LeastFriction(const PatchMotion& given, CreepModel model) : motion_(given) {
    if (!(given.friction > 0.0 && given.friction < least_friction) || model == CreepModel::linear) {
      return;
    }
    Creepages& creepages = motion_.creepages;
    double largest = std::max(
        {std::abs(creepages.longitudinal), std::abs(creepages.lateral), std::abs(creepages.spin)});
    for (const double velocity : motion_.twist.value_or(Twist{})) {
      largest = std::max(largest, std::abs(velocity));
    }
    motion_.friction = least_friction;
    of_forces_ = given.friction / least_friction;
    of_creepages_ = std::max({of_forces_, std::min(largest, 1.0)});
    creepages.longitudinal /= of_creepages_;
    creepages.lateral /= of_creepages_;
    creepages.spin /= of_creepages_;
    motion_.slip_scale /= of_creepages_;
    if (motion_.twist) {
      for (double& velocity : *motion_.twist) {
        velocity /= of_creepages_;
      }
    }
  }

  /// To the friction given. Derivatives by it stay as they are.
  void take_back(CreepForces& forces, CreepResult& creep) const {
    if (of_forces_ == 1.0) {
      return;
    }
    const auto times = [](double factor, auto& values) {
      for (double& value : values) {
        value *= factor;
      }
    };
    for (double* value :
         {&forces.longitudinal, &forces.lateral, &forces.spin_moment, &creep.largest_traction,
          &creep.pressure_change, &creep.power_of_pressures}) {
      *value *= of_forces_;
    }
    times(of_forces_, creep.beyond_creepages);
    creep.power_per_speed *= of_forces_ * of_creepages_;
    times(of_forces_, creep.traction_x);
    times(of_forces_, creep.traction_y);
    times(of_creepages_, creep.slip_x);
    times(of_creepages_, creep.slip_y);
    if (creep.derivatives) {
      times(of_forces_ / of_creepages_, creep.derivatives->by_creepage);
      times(of_forces_ / of_creepages_, creep.derivatives->normal_by_creepage);
      times(of_forces_ / of_creepages_, creep.derivatives->by_normal_velocity);
      times(of_forces_, creep.derivatives->by_load);
      times(of_forces_, creep.derivatives->by_slip);
      times(of_forces_, creep.derivatives->normal_by_position);
      if (creep.derivatives->by_position) {
        times(of_forces_, *creep.derivatives->by_position);
      }
    }
  }

  /// To solve for.
  [[nodiscard]] const PatchMotion& motion() const { return motion_; }

private:
  PatchMotion motion_;
  double of_forces_ = 1.0; ///< requested forces over the found ones
  double of_creepages_ = 1.0;
};

} // namespace wrc
