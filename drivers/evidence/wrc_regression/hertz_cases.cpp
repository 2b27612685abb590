#include <cmath>
#include <numbers>

#include "support/scene.hpp"
#include "wrc_regression/checks.hpp"

namespace driver {

std::vector<Check> run_hertz_cases() {
  constexpr double pi = std::numbers::pi;
  constexpr double modulus = 210000.0 / (2.0 * (1.0 - 0.3 * 0.3)); // combined, MPa
  constexpr double load = 80000.0;
  std::vector<Check> checks;
  for (const double radius : {100.0, 460.0}) {
    const double contact = std::cbrt(0.75 * load * radius / modulus);
    const double pmax = 1.5 * load / (pi * contact * contact);
    const double approach = contact * contact / radius;

    constexpr int count = 128;
    constexpr double fill = 0.6; // of each side
    const double step = 2.0 * contact / (fill * count);
    std::vector<double> distance;
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const double y = (i - 0.5 * (count - 1)) * step;
        const double x = (j - 0.5 * (count - 1)) * step;
        distance.push_back((x * x + y * y) / (2.0 * radius));
      }
    }
    NormalContact normal;
    normal.set_grid(count, count, step, step);
    normal.set_distance(distance);
    normal.set("combined_modulus", modulus);
    normal.set("normal_load", load);
    normal.solve();

    const std::string name = "sphere of radius " + std::to_string(static_cast<int>(radius)) + " mm";
    // docs/validation.md: 0.31/n^2 and 0.16/n^2 with n elements across, here 77; four times that.
    const Tolerance fine{"grid", 2e-4, "discretisation with 77 elements across, order 2"};
    checks.push_back({"hertz", name, "pmax", pmax, normal.number("pmax"), fine, ""});
    checks.push_back({"hertz", name, "approach", approach, normal.number("approach"), fine, ""});
  }
  return checks;
}

} // namespace driver
