#include "support/service_run.hpp"

#include <cmath>
#include <numbers>

namespace driver {

ServiceStep service_step(int index) {
  constexpr double distance = 40.0;
  constexpr double mean_load = 80000.0;
  constexpr double turn = 2.0 * std::numbers::pi;
  struct Wave {
    double amplitude;
    double number; ///< turns over the wavelength
  };
  constexpr std::array waves{Wave{6.5, turn / 8000.0}, Wave{0.3, turn / 1370.0},
                             Wave{0.05, turn / 310.0}};
  const double x = distance * index;
  ServiceStep step;
  step.speed = 40000.0;
  for (const Wave& wave : waves) {
    step.lateral += wave.amplitude * std::sin(wave.number * x);
    step.lateral_velocity += step.speed * wave.amplitude * wave.number * std::cos(wave.number * x);
  }
  const Wave& hunting = waves.front();
  step.yaw = hunting.number * hunting.amplitude * std::cos(hunting.number * x);
  step.yaw_velocity = -step.speed * hunting.number * hunting.number * hunting.amplitude *
                      std::sin(hunting.number * x);
  const double left =
      mean_load * (1.0 + 0.2 * std::sin(turn * x / 900.0) + 0.05 * std::sin(turn * x / 210.0));
  step.load = {left, 2.0 * mean_load - left};
  return step;
}

} // namespace driver
