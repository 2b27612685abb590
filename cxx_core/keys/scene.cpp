#include "keys/scene.hpp"

#include <cmath>

#include "base/lower_case.hpp"

namespace wrc {
namespace {

/// Waves of a wheel have no effect if the sum of their amplitudes, times the squares of their
/// orders, is below this length times the accuracy, mm. origin: derived: a thousandth of an overlap
/// of 1e-4 mm, that of some newtons on a wheel; the change of its curvature is less.
constexpr double negligible_waves = 1e-3 * 1e-4;

} // namespace

Scene::Scene() {
  track.inclination = std::atan(1.0 / 40.0);
}

bool is_sliced(const ProfileChoice& choice) {
  const std::string name = lower_case(choice.name);
  return !choice.given && (name.ends_with(".slcs") || name.ends_with(".slcw"));
}

bool has_waves(const ProfileChoice& wheel, double accuracy) {
  double size = 0.0;
  for (const RadiusHarmonic& wave : wheel.harmonics) {
    size += std::abs(wave.amplitude) * wave.order * wave.order;
  }
  return size > negligible_waves * accuracy;
}

bool has_prismatic_rails(const Scene& scene) {
  return !is_sliced(scene.left.rail) && !is_sliced(scene.right.rail);
}

bool has_round_wheels(const Scene& scene) {
  return !is_sliced(scene.left.wheel) && !is_sliced(scene.right.wheel) &&
         !has_waves(scene.left.wheel, scene.accuracy) &&
         !has_waves(scene.right.wheel, scene.accuracy);
}

} // namespace wrc
