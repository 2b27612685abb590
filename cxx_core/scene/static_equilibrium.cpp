#include "scene/static_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "scene/number_table.hpp"

namespace wrc {

namespace {

using namespace dimensions;

/// Solutions of Newton's method.
/// origin: bound: 4 to 8 are needed from tread to flange.
constexpr int max_solutions = 40;

/// Distance of a wheel's contact from the wheelset's centre, mm, by which a moment is shared at the
/// start, and least share of a wheel there.
/// origin: bound: the start only.
constexpr double contact_arm = 750.0;
constexpr double least_share = 0.02;

/// Largest load, N, as load.left permits.
/// origin: bound: a hundred times what wheels carry.
constexpr double max_load = 1e7;

/// Loads are met within this share of the accuracy.
/// origin: bound: forces themselves are off by the accuracy.
constexpr double accuracy_share = 0.01;

/// Least determinant of the slopes, of the product of their lengths, and how far the wheelset is
/// lowered below it, mm.
/// origin: bound: a wheel in contact has 0.1 at the least; a lifted one 0.
constexpr double least_determinant = 1e-6;
constexpr double lowering = 0.1;

using Two = std::array<double, 2>;
using TwoByTwo = std::array<Two, 2>;

/// What is missing of the loads, and how it falls with height and roll. A moment counts over the
/// arm.
struct Balance {
  Two missing{};
  TwoByTwo slope{}; ///< of each load carried, by height and roll
};

/// N and N mm, checked; of an axle the moment that the wheels have to bear.
Two checked(const StaticLoads& loads, const Convention& convention) {
  const auto check = [](double load, const char* name) {
    if (!(load > 0.0 && load <= max_load)) {
      throw_invalid_argument(name, load, "allowed is above 0 to 1e7 N");
    }
  };
  const auto& [first, second] = loads.values;
  if (loads.of == LoadsOf::wheels) {
    check(first, "loads[0] (left wheel)");
    check(second, "loads[1] (right wheel)");
    return {first, second};
  }
  check(first, "loads[0] (axle)");
  const double inside = from_caller(second, convention, moment);
  if (!(std::abs(inside) < contact_arm * first)) {
    throw_invalid_argument("loads[1] (moment about x)", second,
                           "allowed is less than the axle's load times 750 mm, at which a wheel "
                           "lifts");
  }
  return {first, -inside};
}

/// About what each wheel carries.
Two loads_of_wheels(LoadsOf of, const Two& loads) {
  if (of == LoadsOf::wheels) {
    return loads;
  }
  const double half = 0.5 * loads[0];
  const double moved = 0.5 * loads[1] / contact_arm;
  const double least = least_share * loads[0];
  return {std::max(half + moved, least), std::max(half - moved, least)};
}

/// Height and roll at which each wheel by itself would carry its load.
Two start_of(Scene scene, const Two& loads, SceneSolver& solver) {
  scene.vertical.reset();
  scene.roll.reset();
  scene.normal_load.reset();
  scene.motion.reset();
  scene.derivatives = false;
  scene.left.load = loads[0];
  scene.right.load = loads[1];
  for (SceneSide* side : {&scene.left, &scene.right}) {
    side->total_load.reset();
    side->creepages.reset();
  }
  const SceneResult result = solver.solve(scene);
  const WheelResult& left = *result.left;
  const WheelResult& right = *result.right;
  const double left_height = left.vertical - left.depth;
  const double right_height = right.vertical - right.depth;
  const double turn = (left_height - right_height) / (left.centroid.y - right.centroid.y);
  return {left_height - (left.centroid.y - scene.lateral) * turn, result.roll + turn};
}

Balance balance_of(SceneResult& result, LoadsOf of, const Two& loads) {
  Balance balance{loads, {}};
  const auto take = [&balance](std::size_t load, SceneWheel& wheel, bool is_moment) {
    const WheelForce total = wheel.total.value_or(WheelForce{});
    balance.missing[load] -= is_moment ? total.moment.x : total.force.z;
    if (const ForceJacobian* jacobian = wheel.jacobian()) {
      const auto& row = (*jacobian)[is_moment ? 3 : 2];
      balance.slope[load][0] += row[static_cast<std::size_t>(StateVariable::vertical)];
      balance.slope[load][1] += row[static_cast<std::size_t>(StateVariable::roll)];
    }
  };
  if (of == LoadsOf::wheels) {
    take(0, *result.left, false);
    take(1, *result.right, false);
    return balance;
  }
  for (SceneWheel* wheel : {&*result.left, &*result.right}) {
    take(0, *wheel, false);
    take(1, *wheel, true);
  }
  for (double* value : {&balance.missing[1], &balance.slope[1][0], &balance.slope[1][1]}) {
    *value /= contact_arm;
  }
  return balance;
}

/// Newton's change of height and roll; where a wheel carries nothing, down.
Two step_of(const Balance& balance) {
  const auto& [first, second] = balance.slope;
  const double determinant = first[0] * second[1] - first[1] * second[0];
  const double size = std::hypot(first[0], second[0]) * std::hypot(first[1], second[1]);
  if (!(std::abs(determinant) > least_determinant * size)) {
    return {-lowering, 0.0};
  }
  return {(balance.missing[0] * second[1] - balance.missing[1] * first[1]) / determinant,
          (balance.missing[1] * first[0] - balance.missing[0] * second[0]) / determinant};
}

} // namespace

StaticEquilibrium find_static_equilibrium(const Scene& scene, const VehicleState& state,
                                          const StaticLoads& loads, SceneSolver& solver) {
  const Convention& convention = scene.convention;
  const Two requested = checked(loads, convention);
  VehicleState with_slopes = state;
  with_slopes.position[2] = to_caller(scene.nominal_radius(), convention, turning_length);
  with_slopes.position[3] = 0.0;
  with_slopes.derivatives = true;
  Scene posed = scene_at(scene, with_slopes);
  posed.side = SideChoice::both;
  const Two each = loads_of_wheels(loads.of, requested);
  Two place = start_of(posed, each, solver);
  // Each wheel's load to its own size, an axle's moment to that of its load.
  const Two sizes = loads.of == LoadsOf::wheels ? requested : Two{requested[0], requested[0]};
  const double tolerance = accuracy_share * posed.accuracy;

  StaticEquilibrium best;
  best.unbalanced = std::numeric_limits<double>::infinity();
  Two best_place = place;
  Two step{};
  for (int solutions = 0; solutions < max_solutions && !best.converged; ++solutions) {
    posed.vertical = place[0];
    posed.roll = place[1];
    SceneResult result = solver.solve(posed);
    const Balance balance = balance_of(result, loads.of, requested);
    const double unbalanced =
        std::hypot(balance.missing[0] / sizes[0], balance.missing[1] / sizes[1]);
    if (unbalanced < best.unbalanced) {
      step = step_of(balance);
      best_place = place;
      best = {posed, std::move(result), 0.0, 0.0, unbalanced, unbalanced <= tolerance};
    } else {
      step = {0.5 * step[0], 0.5 * step[1]};
    }
    place = {best_place[0] + step[0], best_place[1] + step[1]};
  }
  best.scene.derivatives = state.derivatives;
  best.scene.side = scene.side;
  best.vertical = to_caller(best_place[0], convention, turning_length);
  best.roll = to_caller(best_place[1], convention, pure);
  return best;
}

} // namespace wrc
