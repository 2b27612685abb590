/// Jacobians of the contact forces of a wheel against central differences of whole scenes.
///
///   compare_jacobian [SCENES [ACCURACY [OF_DIFFERENCES [YIELD]]]]     default 500 1e-2 1e-3
///
/// Prints the table of docs/evidence/derivatives.md: for each position and velocity the error of
/// its column of the Jacobian, moments over 750 mm, over the column's largest entry, and the
/// fraction of scenes in which that is within the accuracy; then over what the column would be
/// without slip (largest entry of the linear theory's, or its own), since a wheel that slides has
/// hardly any slope by its creepages; then how far two differences, over a step and half of it, are
/// apart: the nearer one counts, elements that change sides within a step show in either. At last
/// errors of positions while the height follows so that the vertical force stays: what is left
/// without the contact's stiffness. Scenes are drawn at random, with the position prescribed at
/// which a wheel carries 20 to 130 kN: S1002 and LMA on four rails, up to flange contact, creepages
/// up to 0.3 %. The differences are those of scenes at the third argument: at the accuracy of the
/// Jacobian they show whether forces and Jacobian belong together. With the fourth the yield stress
/// of both bodies is drawn, from it to six times it, MPa; then only scenes that yield count.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "arguments.hpp"
#include "base/error.hpp"
#include "derivatives/force_jacobian.hpp"
#include "results/wheel_state.hpp"
#include "support/random_wheels.hpp"
#include "support/state_differences.hpp"

namespace {

using namespace wrc;
using namespace wrc::test;

constexpr std::array<const char*, state_count> names{
    "lateral",          "vertical",          "roll",      "yaw",        "speed",
    "lateral velocity", "vertical velocity", "roll rate", "pitch rate", "yaw rate"};

constexpr std::array<std::size_t, 2> held{0, 3}; // lateral, yaw

/// A wheel under load, moving; without an Error if it stands on its rail.
Scene moving_wheel(Draw& draw, int index, double accuracy, double least_yield) {
  Scene scene = draw.wheel(index);
  if (least_yield > 0.0) {
    Draw steels(static_cast<unsigned>(index + 1));
    scene.wheel_steel.yield_stress = least_yield * steels.between(1.0, 6.0);
    scene.rail_steel.yield_stress = least_yield * steels.between(1.0, 6.0);
  }
  scene.accuracy_of = AccuracyOf::forces;
  scene.accuracy = accuracy;
  const double speed = draw.between(5e3, 6e4);
  scene.motion = Motion{.speed = speed,
                        .pitch = speed / scene.left.radius * (1.0 + draw.between(-3e-3, 3e-3)),
                        .lateral = speed * draw.between(-3e-3, 3e-3),
                        .vertical = speed * draw.between(-1e-3, 1e-3),
                        .roll = draw.between(-0.05, 0.05),
                        .yaw = draw.between(-0.05, 0.05)};
  const SceneResult under_load = solve_scene(scene);
  scene.roll = under_load.roll;
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  return scene;
}

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

/// The vertical velocity makes a creepage by the sine of the contact angle alone.
double share_of_step(const WheelResult& wheel, std::size_t which) {
  if (static_cast<StateVariable>(which) != StateVariable::vertical_velocity) {
    return 1.0;
  }
  double sine = 0.1;
  for (const PatchResult& patch : wheel.patches) {
    sine = std::max(sine, std::abs(patch.frame.normal.y));
  }
  return 1.0 / sine;
}

double largest_of(const ForceColumn& column) {
  double largest = 0.0;
  for (const double entry : column) {
    largest = std::max(largest, std::abs(entry));
  }
  return largest;
}

struct Errors {
  std::vector<double> of_columns, without_slip, of_differences;

  void add(const ForceColumn& found, const ForceColumn& one, const ForceColumn& other,
           double slope) {
    const double error = std::min(column_error(found, one), column_error(found, other));
    const double largest = largest_of(one);
    of_columns.push_back(error);
    without_slip.push_back(error * largest / std::max(largest, slope));
    of_differences.push_back(column_error(other, one));
  }
};

void print(const char* name, double accuracy, const Errors& errors) {
  const auto within = [accuracy](const std::vector<double>& of) {
    const auto count =
        std::count_if(of.begin(), of.end(), [accuracy](double e) { return e <= accuracy; });
    return static_cast<double>(count) / static_cast<double>(of.size());
  };
  std::printf("%-18s %6zu", name, errors.of_columns.size());
  for (const std::vector<double>* of : {&errors.of_columns, &errors.without_slip}) {
    std::printf(" | %7.4f %7.4f %7.4f %7.4f %7.3f", quantile(*of, 0.5), quantile(*of, 0.95),
                quantile(*of, 0.99), quantile(*of, 1.0), within(*of));
  }
  std::printf(" | %7.4f %7.4f\n", quantile(errors.of_differences, 0.95),
              quantile(errors.of_differences, 1.0));
}

/// Columns of a Jacobian, and by differences.
struct Case {
  Columns found, one, other, without_slip;
};

Case compare(Scene scene, double of_differences) {
  scene.derivatives = true;
  SceneResult here = solve_scene(scene);
  Scene linear = scene;
  linear.creep = CreepModel::linear;
  SceneResult without_slip = solve_scene(linear);
  scene.derivatives = false;
  scene.accuracy = of_differences;
  Case result;
  for (std::size_t which = 0; which < state_count; ++which) {
    const double share = share_of_step(*here.left, which);
    result.found[which] = column_of(*here.left->jacobian(), which);
    result.without_slip[which] = column_of(*without_slip.left->jacobian(), which);
    result.one[which] = difference_by(scene, which, &SceneResult::left, share);
    result.other[which] = difference_by(scene, which, &SceneResult::left, 0.5 * share);
  }
  return result;
}

constexpr const char* usage =
    "compare_jacobian [SCENES [ACCURACY [OF_DIFFERENCES [YIELD]]]]     default 500 1e-2 1e-3\n\n"
    "Compares Jacobians of the contact forces of a wheel with differences of whole scenes; with\n"
    "YIELD, MPa, of steels of one to six times that yield stress.\n";

int compare_all(const evidence::Arguments& arguments) {
  const int count = arguments.whole(0, "SCENES", 500);
  const double accuracy = arguments.positive(1, "ACCURACY", 1e-2);
  const double of_differences = arguments.positive(2, "OF_DIFFERENCES", 1e-3);
  const double least_yield = arguments.positive(3, "YIELD", 0.0);
  arguments.refuse_beyond(4);
  std::array<Errors, state_count> errors;
  std::array<Errors, position_count> held_errors;
  Draw draw;
  for (int i = 0; i < count; ++i) {
    try {
      const Scene scene = moving_wheel(draw, i, accuracy, least_yield);
      if (least_yield > 0.0 && (*solve_scene(scene).left->state & beyond_yield) == 0) {
        continue;
      }
      const Case of = compare(scene, of_differences);
      for (std::size_t which = 0; which < state_count; ++which) {
        errors[which].add(of.found[which], of.one[which], of.other[which],
                          largest_of(of.without_slip[which]));
      }
      for (const std::size_t which : held) {
        held_errors[which].add(at_held_load(of.found, which), at_held_load(of.one, which),
                               at_held_load(of.other, which),
                               largest_of(at_held_load(of.without_slip, which)));
      }
    } catch (const Error& error) {
      std::printf("scene %d: %s\n", i, error.what());
    }
  }
  std::printf("%-18s %6s | %-39s | %-39s | %s\n", "by", "scenes", "over the column",
              "over that without slip", "differences");
  std::printf("%-25s", "");
  for (int table = 0; table < 2; ++table) {
    std::printf(" | %7s %7s %7s %7s %7s", "median", "95 %", "99 %", "worst", "within");
  }
  std::printf(" | %7s %7s\n", "95 %", "worst");
  for (std::size_t which = 0; which < state_count; ++which) {
    print(names[which], accuracy, errors[which]);
  }
  std::printf("at held load\n");
  for (const std::size_t which : held) {
    print(names[which], accuracy, held_errors[which]);
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return evidence::run(argc, argv, usage, compare_all);
}
