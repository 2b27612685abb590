/// Forces of frictionless contact against the elastic energy that they derive from, and the
/// symmetry of their derivatives.
///
///   compare_energy [SCENES]     default 500
///
/// Prints quantiles of the errors of tests/core/support/energy_pairs.hpp over scenes drawn at
/// random, and each scene in which one exceeds 2e-3.
#include <cstdio>

#include "arguments.hpp"
#include "base/error.hpp"
#include "support/energy_pairs.hpp"

namespace {

constexpr const char* usage =
    "compare_energy [SCENES]     default 500\n\n"
    "Compares forces of frictionless contact with derivatives of their elastic energy.\n";

int compare(const wrc::evidence::Arguments& arguments) {
  using namespace wrc;
  using namespace wrc::test;
  const int count = arguments.whole(0, "SCENES", 500);
  arguments.refuse_beyond(1);
  constexpr double limit = 2e-3;
  std::vector<double> pairs, sensitivities, reported, energy;
  Draw draw;
  for (int i = 0; i < count; ++i) {
    try {
      const Scene scene = frictionless_wheel(draw, i);
      const EnergyErrors errors = energy_errors(scene);
      pairs.push_back(errors.pairs);
      sensitivities.push_back(errors.sensitivities);
      reported.push_back(errors.reported);
      energy.push_back(errors.energy);
      if (std::max({errors.pairs, errors.sensitivities, errors.energy}) > limit) {
        std::printf(
            "scene %d: %s on %s, y %.4f, yaw %.4f, %.0f N: pairs %.1e, of sensitivities %.1e, "
            "energy %.1e, reported %.1e; %zu patches, partial %.2f\n",
            i, scene.left.wheel.name.c_str(), scene.left.rail.name.c_str(), scene.lateral,
            scene.yaw, scene.left.load, errors.pairs, errors.sensitivities, errors.energy,
            errors.reported, errors.patches, errors.partial);
      }
    } catch (const Error& error) {
      std::printf("scene %d: %s\n", i, error.what());
    }
  }
  const auto print = [](const char* name, const std::vector<double>& values) {
    std::printf("%-32s median %.1e, 90 %% %.1e, 99 %% %.1e, worst %.1e\n", name,
                quantile(values, 0.5), quantile(values, 0.9), quantile(values, 0.99),
                quantile(values, 1.0));
  };
  std::printf("%zu scenes\n", pairs.size());
  print("pairs of differences", pairs);
  print("pairs of sensitivities", sensitivities);
  print("sensitivities, differences", reported);
  print("derivatives of the energy", energy);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return wrc::evidence::run(argc, argv, usage, compare);
}
