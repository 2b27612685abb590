/// The largest von Mises stress of random scenes against fine solutions.
///
///   compare_stress [SCENES [SEED]]     default 100 1
///
/// Prints the table of docs/damage.md. Scenes: S1002 and LMA on four rails up to flange contact, 20
/// to 130 kN, half of them with creepages of 1e-4 to 1e-2. Truth: the accuracy `truth`, and there
/// the greatest of sections through all rows, climbed from.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "damage/subsurface_stress.hpp"
#include "scene/scene_keys.hpp"
#include "scene/solve_scene.hpp"

namespace {

using namespace wrc;

constexpr double truth_accuracy = 2e-4;
constexpr std::array accuracies{1e-1, 1e-2, 1e-3};

class Draw {
public:
  explicit Draw(unsigned seed) : random_(seed) {}
  Scene scene(int index) {
    constexpr std::array<const char*, 4> rails{"60E1", "CHN60", "54E1", "60E2"};
    Scene scene;
    const bool lma = index % 2 != 0;
    scene.left.wheel.name = scene.right.wheel.name = lma ? "LMA" : "S1002";
    scene.left.rail.name = scene.right.rail.name = rails[static_cast<std::size_t>(index / 2) % 4];
    scene.back_to_back = lma ? 1353.0 : 1360.0;
    scene.lateral = between(-7.0, 7.0);
    scene.yaw = between(-0.01, 0.01);
    scene.left.load = scene.right.load = std::pow(10.0, between(4.3, 5.1));
    scene.side = SideChoice::left;
    scene.damage.stress = true;
    if (index / 8 % 2 != 0) {
      const double size = std::pow(10.0, between(-4.0, -2.0));
      const double angle = between(0.0, 6.28);
      scene.left.creepages =
          Creepages{size * std::cos(angle), size * std::sin(angle), between(-1e-4, 1e-3)};
    }
    return scene;
  }

private:
  double between(double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random_);
  }
  std::mt19937_64 random_;
};

/// The greatest below one patch, from sections below every row of elements.
double greatest_below(const PatchResult& patch) {
  std::vector<double> x;
  std::vector<double> y;
  const bool tractions = patch.creep && !patch.creep->traction_x.empty();
  const Grid& grid = tractions ? patch.creep->grid : patch.grid;
  if (tractions) {
    x = patch.creep->traction_x;
    y = patch.creep->traction_y;
    for (auto* traction : {&x, &y}) {
      for (double& value : *traction) {
        value = -value;
      }
    }
  }
  const SubsurfaceStress stress({grid, tractions ? patch.creep->pressure : patch.pressure, x, y},
                                0.3);
  std::vector<double> places;
  for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
    places.push_back(grid.longitudinal(j));
  }
  const double width = 2.0 * std::min(patch.semi_axis_longitudinal, patch.semi_axis_lateral);
  std::vector<double> depths{0.0};
  for (double depth = 0.5 * std::max(grid.longitudinal_step, grid.lateral_step); depth < width;
       depth *= 1.08) {
    depths.push_back(depth);
  }
  double greatest = 0.0;
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    const StressSection section = stress.along(places, grid.lateral(i), depths);
    for (std::size_t k = 0; k < section.stresses.size(); ++k) {
      if (von_mises(section.stresses[k]) > greatest) {
        greatest = von_mises(section.stresses[k]);
        at = {places[k % places.size()], grid.lateral(i), depths[k / places.size()]};
      }
    }
  }
  greatest = von_mises(stress.at(at[0], at[1], at[2]));
  std::array<double, 3> step{0.5 * grid.longitudinal_step, 0.5 * grid.lateral_step, 0.04 * at[2]};
  for (int round = 0; round < 30 && at[2] > 0.0; ++round) {
    bool moved = false;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double sign : {-1.0, 1.0}) {
        auto there = at;
        there[k] += sign * step[k];
        const double value = von_mises(stress.at(there[0], there[1], there[2]));
        if (value > greatest) {
          greatest = value;
          at = there;
          moved = true;
        }
      }
    }
    if (!moved) {
      for (double& each : step) {
        each *= 0.5;
      }
      if (step[2] < 2e-3 * at[2]) {
        break;
      }
    }
  }
  return greatest;
}

double greatest_below(const WheelResult& wheel) {
  double greatest = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    if (patch.parts.empty()) {
      greatest = std::max(greatest, greatest_below(patch));
    }
    for (const PatchResult& part : patch.parts) {
      greatest = std::max(greatest, greatest_below(part));
    }
  }
  return greatest;
}

} // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  Draw draw(argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1);
  for (int i = 0; i < count; ++i) {
    Scene scene = draw.scene(i);
    try {
      scene.accuracy = truth_accuracy;
      SceneResult fine = solve_scene(scene);
      const double truth = greatest_below(*fine.left);
      const auto& at = *fine.left->damage->stress;
      std::printf("%d %d %.3f %.2f truth %.2f own %.5f depth %.3f pmax %.1f", i, scene.has_creepages(), scene.lateral, scene.left.load, truth, at.von_mises / truth - 1.0, at.depth,
                  fine.left->pmax);
      for (const AccuracyOf of : {AccuracyOf::pressures, AccuracyOf::forces}) {
        for (const double accuracy : accuracies) {
          scene.accuracy = accuracy;
          scene.accuracy_of = of;
          const SceneResult found = solve_scene(scene);
          std::printf(" | %.5f %.5f", found.left->damage->stress->von_mises / truth - 1.0,
                      greatest_below(*found.left) / truth - 1.0);
        }
      }
      std::printf("\n");
      std::fflush(stdout);
    } catch (const Error& error) {
      std::printf("%d %s\n", i, error.what());
    }
  }
  return 0;
}
