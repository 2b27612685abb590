/// Jacobians of the contact forces of a wheel against central differences of whole scenes.
///
///   compare_jacobian [SCENES [ACCURACY]]     default 500 1e-2
///
/// Prints the table of docs/creep.md: for each position and velocity the error of its column of the
/// Jacobian, over the column's largest entry, moments over 750 mm; at last those of positions while
/// the height follows so that the vertical force stays: what is left without the contact's
/// stiffness. Scenes are drawn at random, with
/// the position prescribed at which a wheel carries 20 to 130 kN: S1002 and LMA on four rails, up
/// to flange contact, creepages up to 0.3 %. The differences are those of scenes at 1e-3.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "support/state_differences.hpp"

namespace {

using namespace wrc;
using namespace wrc::test;

constexpr std::array<const char*, state_count> names{
    "lateral",          "vertical",          "roll",      "yaw",        "speed",
    "lateral velocity", "vertical velocity", "roll rate", "pitch rate", "yaw rate"};

constexpr std::array<std::size_t, 2> held{0, 3}; // lateral, yaw

class Draw {
public:
  /// A wheel under load, moving; without an Error if it stands on its rail.
  Scene scene(int index, double accuracy) {
    constexpr std::array<const char*, 4> rails{"60E1", "CHN60", "54E1", "60E2"};
    Scene scene;
    const bool lma = index % 2 != 0;
    scene.left.wheel.name = scene.right.wheel.name = lma ? "LMA" : "S1002";
    scene.left.rail.name = scene.right.rail.name = rails[static_cast<std::size_t>(index / 2) % 4];
    scene.back_to_back = lma ? 1353.0 : 1360.0;
    scene.lateral = between(-7.0, 7.0);
    scene.yaw = between(-0.01, 0.01);
    scene.left.load = scene.right.load = std::pow(10.0, between(4.3, 5.1));
    scene.accuracy_of = AccuracyOf::forces;
    scene.accuracy = accuracy;
    scene.side = SideChoice::left;
    const double speed = between(5e3, 6e4);
    scene.motion = Motion{.speed = speed,
                          .pitch = speed / scene.left.radius * (1.0 + between(-3e-3, 3e-3)),
                          .lateral = speed * between(-3e-3, 3e-3),
                          .vertical = speed * between(-1e-3, 1e-3),
                          .roll = between(-0.05, 0.05),
                          .yaw = between(-0.05, 0.05)};
    const SceneResult under_load = solve_scene(scene);
    scene.roll = under_load.roll;
    scene.vertical = under_load.left->vertical - under_load.left->depth;
    return scene;
  }

private:
  double between(double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random_);
  }
  std::mt19937_64 random_{1};
};

using Columns = std::array<ForceColumn, state_count>;

constexpr std::size_t vertical = 1;
constexpr std::size_t vertical_force = 2;

ForceColumn at_held_load(const Columns& columns, std::size_t which) {
  const double height = -columns[which][vertical_force] / columns[vertical][vertical_force];
  ForceColumn result = columns[which];
  for (std::size_t row = 0; row < result.size(); ++row) {
    result[row] += height * columns[vertical][row];
  }
  return result;
}

double quantile(std::vector<double>& values, double share) {
  std::sort(values.begin(), values.end());
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

} // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 500;
  const double accuracy = argc > 2 ? std::atof(argv[2]) : 1e-2;
  std::array<std::vector<double>, state_count> errors;
  std::array<std::vector<double>, position_count> held_errors;
  Draw draw;
  for (int i = 0; i < count; ++i) {
    try {
      Scene scene = draw.scene(i, accuracy);
      scene.derivatives = true;
      SceneResult here = solve_scene(scene);
      const ForceJacobian& jacobian = *jacobian_of(*here.left);
      scene.derivatives = false;
      scene.accuracy = 1e-3;
      Columns found;
      Columns expected;
      for (std::size_t which = 0; which < state_count; ++which) {
        found[which] = column_of(jacobian, which);
        expected[which] = difference_by(scene, which, &SceneResult::left);
        errors[which].push_back(column_error(found[which], expected[which]));
      }
      for (const std::size_t which : held) {
        held_errors[which].push_back(
            column_error(at_held_load(found, which), at_held_load(expected, which)));
      }
    } catch (const Error& error) {
      std::printf("scene %d: %s\n", i, error.what());
    }
  }
  std::printf("%-18s %8s %8s %8s %8s\n", "by", "scenes", "median", "95 %", "worst");
  const auto print = [](const char* name, const char* held_load, std::vector<double>& of) {
    std::printf("%-18s %8zu %8.4f %8.4f %8.4f%s\n", name, of.size(), quantile(of, 0.5),
                quantile(of, 0.95), quantile(of, 1.0), held_load);
  };
  for (std::size_t which = 0; which < state_count; ++which) {
    print(names[which], "", errors[which]);
  }
  for (const std::size_t which : held) {
    print(names[which], " at held load", held_errors[which]);
  }
  return 0;
}
