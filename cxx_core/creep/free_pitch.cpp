#include "creep/free_pitch.hpp"

#include <algorithm>
#include <cmath>

#include "base/root_bracket.hpp"
#include "creep/constants.hpp"
#include "creep/creep_elements.hpp"
#include "creep/creep_forces.hpp"
#include "creep/rolling_frame.hpp"
#include "creep/total_force.hpp"

namespace wrc {
namespace {

/// The axle in the track frame.
Vector3 axle_of(const WheelResult& wheel) {
  const WheelDetails& details = wheel.details;
  return RollingFrame(details.mirror)
      .mirrored_moment(Rotation(details.pose).to_track({0.0, 1.0, 0.0}));
}

class PitchSearch {
public:
  PitchSearch(std::span<DrivenWheel> wheels, double torque, RollingSolver& solver)
      : wheels_(wheels), torque_(torque), solver_(solver) {
    const Motion& motion = *wheels.front().request.motion;
    double force = 0.0;
    double bound = 0.0;
    double radius = 0.0;
    double accuracy = 0.0;
    for (const DrivenWheel& driven : wheels) {
      const double normal_force = driven.wheel->normal_force;
      force += normal_force;
      radius += normal_force * driven.wheel->centroid.rolling_radius;
      bound +=
          greatest_friction(driven.request.friction) * normal_force * driven.request.nominal_radius;
      accuracy = std::max(accuracy, driven.request.accuracy);
    }
    const double nominal = wheels.front().request.nominal_radius;
    rolling_ = force > 0.0 ? motion.speed * force / radius : motion.speed / nominal;
    largest_ = bound;
    undriven_ = no_driving_friction * force * nominal;
    creepage_ = std::hypot(motion.speed, motion.standstill_speed) / nominal;
    const bool unlike = std::ranges::any_of(
        wheels, [](const DrivenWheel& driven) { return unlike_bodies(driven.request); });
    tolerance_ = (unlike ? creep_iteration_share : free_pitch_tolerance) * accuracy * bound;
  }

  FreePitch find() {
    if (largest_ <= undriven_) {
      const bool slides = std::abs(torque_) > undriven_;
      const double slip = slides ? std::copysign(creepage_, torque_) : 0.0;
      return {unbalanced(rolling_ + slip, std::nullopt).place, slides};
    }
    const Tangent cheap = find_cheaply();
    FreePitch found = find_from(cheap);
    found.ambiguous = cheap.another && !found.saturated;
    found.evaluations = evaluations_;
    return found;
  }

private:
  using Point = RootBracket::Point;
  struct Tangent {
    double rate;
    double slope;
    bool another = false; ///< with more slip the torque is held again
  };

  FreePitch find_from(const Tangent& cheap) {
    last_ = unbalanced(cheap.rate, std::nullopt);
    if (is_balanced(last_)) {
      return {last_.place, false};
    }
    const double step = cheap.slope < 0.0 ? -last_.value / cheap.slope
                                          : std::copysign(1e-3 * creepage_, last_.value);
    return search(step, 4.0, [this](double rate) { return unbalanced(rate, std::nullopt); });
  }

  /// With a model instead of the requested one, if any.
  Point unbalanced(double rate, std::optional<CreepModel> model) {
    double moment = torque_;
    evaluations_ += model ? 0 : 1;
    for (DrivenWheel& driven : wheels_) {
      CreepRequest request = driven.request;
      request.motion->pitch = rate;
      request.model = model.value_or(request.model);
      request.derivatives = false;
      solve_creep_forces(*driven.wheel, request, solver_);
      moment += dot(axle_of(*driven.wheel), total_force(*driven.wheel).moment);
    }
    return {rate, moment};
  }

  [[nodiscard]] bool is_balanced(const Point& point) const {
    return std::abs(point.value) <= tolerance_;
  }

  Tangent find_cheaply() {
    const auto cheaply = [this](double rate) { return unbalanced(rate, CreepModel::polach); };
    last_ = cheaply(rolling_);
    const double direction = std::copysign(1.0, last_.value);
    const bool falls = std::any_of(wheels_.begin(), wheels_.end(), [](const DrivenWheel& driven) {
      return driven.request.friction.falls();
    });
    const FreePitch found = is_balanced(last_)
                                ? FreePitch{rolling_}
                                : search(direction * 1e-3 * creepage_, falls ? 1.0 : 4.0, cheaply);
    if (found.saturated) {
      return {rolling_, 0.0};
    }
    const bool another =
        falls && direction * cheaply(rolling_ + direction * creepage_).value > tolerance_;
    const double apart = creep_difference_step * 1e-3 * creepage_;
    return {found.rate,
            (cheaply(found.rate + apart).value - cheaply(found.rate - apart).value) / (2.0 * apart),
            another};
  }

  /// From the point evaluated last on, until the sum changes its sign; then between. Steps grow by
  /// `growth` at most, and some lead to sliding at the latest.
  template <class Function> FreePitch search(double step, double growth, const Function& function) {
    Point ahead = last_;
    const double slowest = rolling_ - creepage_;
    const double fastest = rolling_ + creepage_;
    while ((ahead.value < 0.0) == (last_.value < 0.0)) {
      if (ahead.place <= slowest || ahead.place >= fastest) {
        return {ahead.place, true};
      }
      const Point behind = last_ = ahead;
      ahead = function(std::clamp(last_.place + step, slowest, fastest));
      if (is_balanced(ahead)) {
        return {ahead.place, false};
      }
      const double slope = (ahead.value - behind.value) / (ahead.place - behind.place);
      const double widest = growth * std::abs(step);
      const double next =
          slope < 0.0 ? std::min(std::abs(2.0 * ahead.value / slope), widest) : widest;
      step = std::copysign(evaluations_ < outward_evaluations ? next : fastest - slowest, step);
    }
    RootBracket bracket(last_, ahead, RootBracket::End::other);
    Point found = ahead;
    int left = pitch_evaluations;
    // Forces that jump with their elements may balance nowhere. The bracket holds such a jump once
    // it is too narrow for a sum with the slope between the first two points to be off by more
    // than the tolerance.
    const double slope = std::abs((ahead.value - last_.value) / (ahead.place - last_.place));
    bracket.narrow(tolerance_ / slope, [&](double rate) -> std::optional<double> {
      found = function(rate);
      return is_balanced(found) || --left == 0 ? std::nullopt : std::optional(found.value);
    });
    return {found.place, false};
  }

  std::span<DrivenWheel> wheels_;
  double torque_;
  RollingSolver& solver_;
  double rolling_ = 0.0;  ///< rate of pure rolling
  double creepage_ = 0.0; ///< what adds a longitudinal creepage of 1
  double largest_ = 0.0;  ///< torque that friction holds
  double undriven_ = 0.0; ///< torque below which friction does not drive
  double tolerance_ = 0.0;
  Point last_;
  int evaluations_ = 0; ///< by the requested model
};

} // namespace

FreePitch solve_free_pitch(std::span<DrivenWheel> wheels, double torque, RollingSolver& solver) {
  return PitchSearch(wheels, torque, solver).find();
}

} // namespace wrc
