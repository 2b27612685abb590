#include "scene/static_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "scene/constants.hpp"
#include "scene/number_table.hpp"

namespace wrc {

namespace {

using namespace dimensions;

using Two = std::array<double, 2>;
using TwoByTwo = std::array<Two, 2>;

/// What is missing of the loads, and how it falls with height and roll. A moment counts over the
/// arm.
struct Balance {
  Two missing{};
  TwoByTwo slope{}; ///< of each load carried, by height and roll
};

/// Height and roll at which each wheel by itself would carry its load, its depth then, and which
/// loads are so small that a wheel that touches carries them.
struct Start {
  Two place{};
  Two depth{};
  std::array<bool, 2> is_touch{};
};

/// Where a wheel touches or would touch.
double lateral_of(const WheelResult& wheel) {
  return wheel.patches.empty() ? wheel.rigid_contact.y : wheel.centroid.y;
}

/// Change of height and roll that raises both wheels by these amounts at their contacts.
Two raise(const SceneResult& result, double lateral, const Two& by) {
  const double left_y = lateral_of(*result.left);
  const double turn = (by[0] - by[1]) / (left_y - lateral_of(*result.right));
  return {by[0] - (left_y - lateral) * turn, turn};
}

Start start_of(Scene scene, const Two& loads, SceneSolver& solver) {
  scene.vertical.reset();
  scene.roll.reset();
  scene.load_of = LoadOf::pressures;
  scene.motion.reset();
  scene.derivatives = false;
  scene.left.load = loads[0];
  scene.right.load = loads[1];
  for (SceneSide* side : {&scene.left, &scene.right}) {
    side->creepages.reset();
  }
  const SceneResult result = solver.solve(scene);
  const WheelResult& left = *result.left;
  const WheelResult& right = *result.right;
  const Two change =
      raise(result, scene.lateral, {left.vertical - left.depth, right.vertical - right.depth});
  return {{change[0], result.roll + change[1]},
          {left.depth, right.depth},
          {left.patches.empty(), right.patches.empty()}};
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
    *value /= usual_contact_arm;
  }
  return balance;
}

/// How far a wheel is above the height where it would carry its load by itself, if it is lifted.
double lift_of(const WheelResult& wheel, double height, double depth) {
  return wheel.patches.empty() ? height - wheel.vertical + depth : 0.0;
}

/// Newton's change of height and roll; lifted wheels, which have no slopes, are lowered.
Two step_of(const Balance& balance, const SceneResult& result, const Two& place, const Start& start,
            double lateral) {
  const Two lift{lift_of(*result.left, place[0], start.depth[0]),
                 lift_of(*result.right, place[0], start.depth[1])};
  if (lift[0] > 0.0 || lift[1] > 0.0) {
    return raise(result, lateral, {-lift[0], -lift[1]});
  }
  return newton_change(balance.slope, balance.missing);
}

} // namespace

Two checked_loads(const StaticLoads& loads, const Convention& convention) {
  const auto check = [](double load, const char* name) {
    if (!(load > 0.0 && load <= largest_static_load)) {
      throw_invalid_argument(name, load, "must be above 0 and at most 1e7 N");
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
  if (!(std::abs(inside) < usual_contact_arm * first)) {
    throw_invalid_argument("loads[1] (moment about x)", second,
                           "must be less than the axle's load times 750 mm, at which a wheel "
                           "lifts");
  }
  return {first, -inside};
}

Two newton_change(const TwoByTwo& slope, const Two& missing) {
  const auto& [first, second] = slope;
  const double determinant = first[0] * second[1] - first[1] * second[0];
  return {(missing[0] * second[1] - missing[1] * first[1]) / determinant,
          (missing[1] * first[0] - missing[0] * second[0]) / determinant};
}

Two loads_of_wheels(LoadsOf of, const Two& loads) {
  if (of == LoadsOf::wheels) {
    return loads;
  }
  const double half = 0.5 * loads[0];
  const double moved = 0.5 * loads[1] / usual_contact_arm;
  const double least = least_wheel_share * loads[0];
  return {std::max(half + moved, least), std::max(half - moved, least)};
}

StaticEquilibrium find_static_equilibrium(const Scene& scene, const VehicleState& state,
                                          const StaticLoads& loads, SceneSolver& solver) {
  const Convention& convention = scene.convention;
  Two requested = checked_loads(loads, convention);
  VehicleState with_slopes = state;
  with_slopes.position[2] = to_caller(scene.nominal_radius(), convention, turning_length);
  with_slopes.position[3] = 0.0;
  with_slopes.derivatives = true;
  Scene posed = scene_at(scene, with_slopes);
  posed.side = SideChoice::both;
  posed.steady_errors = false;
  const Two each = loads_of_wheels(loads.of, requested);
  // Each wheel's load to its own size, an axle's moment to that of its load.
  const Two sizes = loads.of == LoadsOf::wheels ? requested : Two{requested[0], requested[0]};
  const Start start = start_of(posed, each, solver);
  const bool all_touch = start.is_touch[0] && start.is_touch[1];
  for (std::size_t i = 0; i < requested.size(); ++i) {
    if (loads.of == LoadsOf::wheels ? start.is_touch[i] : all_touch) {
      requested[i] = 0.0;
    }
  }
  Two place = start.place;
  const double tolerance = load_share_of_accuracy * posed.accuracy;

  StaticEquilibrium best;
  best.unbalanced = std::numeric_limits<double>::infinity();
  Two best_place = place;
  Two step{};
  bool is_lifted = true; // one of the wheels, in the best place
  int vain = 0;
  int solutions = 1;
  for (; solutions < most_static_solutions && vain < most_vain_solutions && !best.converged;
       ++solutions) {
    posed.vertical = place[0];
    posed.roll = place[1];
    SceneResult result = solver.solve(posed);
    const Balance balance = balance_of(result, loads.of, requested);
    const double unbalanced =
        std::hypot(balance.missing[0] / sizes[0], balance.missing[1] / sizes[1]);
    const bool lifts = (result.left->patches.empty() && !start.is_touch[0]) ||
                       (result.right->patches.empty() && !start.is_touch[1]);
    const bool meets = unbalanced <= tolerance;
    const bool sets_down = is_lifted && !lifts;
    const bool nears = lifts == is_lifted && unbalanced < best.unbalanced;
    const bool gains =
        sets_down || (nears && unbalanced < (1.0 - least_static_progress) * best.unbalanced);
    vain = gains ? 0 : vain + 1;
    if (meets || sets_down || nears) {
      is_lifted = lifts;
      step = step_of(balance, result, place, start, posed.lateral);
      best_place = place;
      best = {posed, std::move(result), 0.0, 0.0, unbalanced, meets};
    } else {
      step = {0.5 * step[0], 0.5 * step[1]};
    }
    place = {best_place[0] + step[0], best_place[1] + step[1]};
  }
  best.solutions = solutions;
  best.scene.derivatives = state.derivatives;
  best.scene.side = scene.side;
  best.vertical = to_caller(best_place[0], convention, turning_length);
  best.roll = to_caller(best_place[1], convention, pure);
  return best;
}

} // namespace wrc
