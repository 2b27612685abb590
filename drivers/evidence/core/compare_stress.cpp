/// The largest von Mises stress of random wheels against fine solutions.
///
///   compare_stress [SCENES [SEED]]     default 100, 1
///
/// Prints the table of docs/evidence/validation.md: how many wheels meet an accuracy, quantiles of
/// errors, how many estimates are no less, how many ms stresses take; with creepages apart for
/// stresses that are greatest below and on the surface. Truth: the accuracy `truth_accuracy`. The
/// last column is what the search leaves: against the greatest of sections below rows of
/// elements, climbed from. Scenes are drawn at random: S1002 and LMA on four rails, up to flange
/// contact, 20 to 130 kN, half of them with creepages of 1e-4 to 1e-2.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "arguments.hpp"
#include "base/error.hpp"
#include "damage/subsurface_stress.hpp"
#include "results/contact_damage.hpp"
#include "support/random_wheels.hpp"

namespace {

using namespace wrc;
using namespace wrc::test;

constexpr double truth_accuracy = 2e-4;
constexpr std::array accuracies{1e-1, 1e-2, 1e-3};

Scene rolling_wheel(Draw& draw, int index) {
  Scene scene = draw.wheel(index);
  scene.damage.stress = true;
  if (index / 8 % 2 != 0) {
    const double size = std::pow(10.0, draw.between(-4.0, -2.0));
    const double angle = draw.between(0.0, 6.28);
    scene.left.creepages =
        Creepages{size * std::cos(angle), size * std::sin(angle), draw.between(-1e-4, 1e-3)};
  }
  return scene;
}

/// The greatest below one patch, from sections below 40 rows or all.
double greatest_below(const PatchResult& patch, const DamageRequest& request) {
  const SubsurfaceStress stress = stresses_below(patch, request);
  const Grid& grid = patch.grid;
  std::vector<double> places;
  for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
    places.push_back(grid.longitudinal(j));
  }
  const double step = std::min(grid.longitudinal_step, grid.lateral_step);
  const double width =
      2.0 * std::max(std::min(patch.semi_axis_longitudinal, patch.semi_axis_lateral), step);
  std::vector<double> depths{0.0};
  double depth = 0.5 * std::max(grid.longitudinal_step, grid.lateral_step);
  while (depth < width) {
    depths.push_back(depth);
    depth *= 1.08;
  }
  double greatest = 0.0;
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < grid.lateral_count; i += 1 + grid.lateral_count / 40) {
    const StressSection section = stress.along(places, grid.lateral(i), depths);
    for (std::size_t k = 0; k < section.stresses.size(); ++k) {
      if (von_mises(section.stresses[k]) > greatest) {
        greatest = von_mises(section.stresses[k]);
        at = {places[k % places.size()], grid.lateral(i), depths[k / places.size()]};
      }
    }
  }
  greatest = von_mises(stress.at(at[0], at[1], at[2]));
  std::array<double, 3> stride{0.5 * grid.longitudinal_step, 0.5 * grid.lateral_step, 0.04 * at[2]};
  for (int round = 0; round < 30 && at[2] > 0.0; ++round) {
    bool moved = false;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double sign : {-1.0, 1.0}) {
        auto there = at;
        there[k] += sign * stride[k];
        const double value = von_mises(stress.at(there[0], there[1], there[2]));
        if (value > greatest) {
          greatest = value;
          at = there;
          moved = true;
        }
      }
    }
    if (!moved) {
      for (double& each : stride) {
        each *= 0.5;
      }
      if (stride[2] < 2e-3 * at[2]) {
        break;
      }
    }
  }
  return greatest;
}

double greatest_below(const WheelResult& wheel) {
  const DamageRequest& request = wheel.details.damage;
  double greatest = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    if (patch.parts.empty()) {
      greatest = std::max(greatest, greatest_below(patch, request));
    }
    for (const PatchResult& part : patch.parts) {
      greatest = std::max(greatest, greatest_below(part, request));
    }
  }
  return greatest;
}

/// Errors at one accuracy.
struct Found {
  std::vector<double> errors, searches, times;
  double met = 0.0;
  double bounded = 0.0;
};

/// Without creepages; with them, below the surface; on it.
constexpr std::array groups{"no", "yes", "surface"};
using Table = std::array<std::array<Found, accuracies.size()>, groups.size()>;

void measure(Scene scene, Table& all, int index) {
  scene.accuracy = truth_accuracy;
  const SceneResult fine = solve_scene(scene);
  const GreatestStress& truth = *fine.left->damage->stress;
  const std::size_t group = !scene.has_creepages() ? 0 : truth.depth > 0.0 ? 1 : 2;
  for (std::size_t i = 0; i < accuracies.size(); ++i) {
    scene.accuracy = accuracies[i];
    const SceneResult result = solve_scene(scene);
    const GreatestStress& stress = *result.left->damage->stress;
    Found& found = all[group][i];
    const double error = std::abs(stress.von_mises / truth.von_mises - 1.0);
    found.errors.push_back(error);
    found.searches.push_back(std::abs(stress.von_mises / greatest_below(*result.left) - 1.0));
    found.times.push_back(result.time.damage);
    found.met += error <= accuracies[i] ? 1.0 : 0.0;
    found.bounded += error <= stress.error_estimate ? 1.0 : 0.0;
    if (error > accuracies[i]) {
      std::printf("scene %d at %g: error %.2g, estimate %.2g, y %.3f mm, %.0f N, depth %.3f mm\n",
                  index, accuracies[i], error, stress.error_estimate, scene.lateral,
                  scene.left.load, stress.depth);
    }
  }
}

constexpr const char* usage =
    "compare_stress [SCENES [SEED]]     default 100 1\n\n"
    "Compares the largest von Mises stress of random wheels with fine solutions.\n";

int compare(const evidence::Arguments& arguments) {
  const int count = arguments.whole(0, "SCENES", 100);
  Draw draw(static_cast<unsigned>(arguments.whole(1, "SEED", 1, 0)));
  arguments.refuse_beyond(2);
  Table all;
  for (int i = 0; i < count; ++i) {
    const Scene scene = rolling_wheel(draw, i);
    try {
      measure(scene, all, i);
    } catch (const Error& error) {
      std::printf("scene %d: %s\n", i, error.what());
    }
  }
  std::printf("creepages accuracy wheels met bounded  median     90 %%     worst  search  ms\n");
  for (std::size_t group = 0; group < all.size(); ++group) {
    for (std::size_t i = 0; i < accuracies.size(); ++i) {
      const Found& found = all[group][i];
      const auto wheels = static_cast<double>(found.errors.size());
      if (wheels > 0.0) {
        std::printf("%9s %8g %6.0f %3.0f %7.0f  %.1e  %.1e  %.1e  %.1e  %.2f\n", groups[group],
                    accuracies[i], wheels, 100.0 * found.met / wheels,
                    100.0 * found.bounded / wheels, quantile(found.errors, 0.5),
                    quantile(found.errors, 0.9), quantile(found.errors, 1.0),
                    quantile(found.searches, 1.0), quantile(found.times, 0.5));
      }
    }
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return evidence::run(argc, argv, usage, compare);
}
