#include "keys/scene.hpp"

#include <cmath>

#include "base/lower_case.hpp"
#include "keys/constants.hpp"

namespace wrc {
Scene::Scene() {
  track.inclination = std::atan(1.0 / 40.0);
}

std::vector<YieldingBody> yielding_bodies_of(const Scene& scene) {
  return yielding_bodies(scene.wheel_material, scene.wheel_steel, scene.rail_material,
                         scene.rail_steel);
}

DamageRequest damage_request_of(const Scene& scene) {
  DamageRequest request = scene.damage;
  request.poisson = (request.of_wheel ? scene.wheel_material : scene.rail_material).poisson;
  request.shear_yield = scene.shear_yield.value_or(
      shear_yield_of(request.of_wheel ? scene.wheel_steel : scene.rail_steel));
  return request;
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
