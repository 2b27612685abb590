#include "table/table_step.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "results/wheel_state.hpp"
#include "support/errors.hpp"
#include "table/constants.hpp"
#include "table/small_table.hpp"

namespace wrc::test {
namespace {

/// Pressed down by 70 um from first touch.
VehicleState running_state() {
  static const SceneResult touch = [] {
    Scene scene = scene_of_small_table();
    scene.lateral = 0.2;
    scene.yaw = 0.003;
    scene.until = Module::geometry;
    return solve_scene(scene);
  }();
  VehicleState state;
  state.position = {0.0, 0.2, touch.vertical - 0.07, touch.roll, 0.0, 0.003};
  state.velocity = SixNumbers{2e4, 15.0, 0.0, 0.0, 43.5, 0.01};
  state.derivatives = true;
  return state;
}

TEST(TableStep, BothWheelsAreMirrorImagesToTheBit) {
  VehicleState state = running_state();
  state.position[2] += 0.02;
  state.rails = SixNumbers{0.1, 0.02, 0.0002, -0.05, -0.03, 0.0001};
  state.rail_velocities = SixNumbers{3.0, 1.0, 0.001, -2.0, 0.5, 0.002};
  state.curvature = 1e-6;
  state.friction = {0.3, 0.2};
  VehicleState mirrored = state;
  constexpr SixNumbers signs{1.0, -1.0, 1.0, -1.0, 1.0, -1.0};
  for (std::size_t i = 0; i < 6; ++i) {
    mirrored.position[i] *= signs[i];
    (*mirrored.velocity)[i] *= signs[i];
    (*mirrored.rails)[i] = (i % 3 == 1 ? 1.0 : -1.0) * (*state.rails)[(i + 3) % 6];
    (*mirrored.rail_velocities)[i] =
        (i % 3 == 1 ? 1.0 : -1.0) * (*state.rail_velocities)[(i + 3) % 6];
  }
  mirrored.curvature = -1e-6;
  mirrored.friction = {0.2, 0.3};
  const TableStep step = step_in_table(small_table(), state, nullptr, true);
  const TableStep other = step_in_table(small_table(), mirrored, nullptr, true);
  EXPECT_GT(step.wheels[0].force[2], 1e4);
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    EXPECT_EQ(step.errors[wheel], other.errors[1 - wheel]);
    EXPECT_EQ(step.outputs[wheel], other.outputs[1 - wheel]);
    EXPECT_EQ(step.output_errors[wheel], other.output_errors[1 - wheel]);
    for (std::size_t row = 0; row < 6; ++row) {
      const double sign = row == 1 || row == 3 || row == 5 ? -1.0 : 1.0;
      EXPECT_EQ(step.wheels[wheel].force[row], sign * other.wheels[1 - wheel].force[row]);
      for (std::size_t column = 0; column < 6; ++column) {
        EXPECT_EQ(step.wheels[wheel].by_position[column][row],
                  sign * signs[column] * other.wheels[1 - wheel].by_position[column][row]);
      }
    }
  }
}

/// With the same numbers as a step, within the error that comes with them.
TEST(TableStep, IsTheExactStepWithinItsError) {
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  VehicleState state = running_state();
  for (const double speed : {2e4, -2e4}) {
    (*state.velocity)[0] = speed;
    (*state.velocity)[4] = 43.5 * speed / 2e4;
    const TableStep found = step_in_table(small_table(), state, nullptr);
    SceneResult result = solver.solve(scene_at(scene, state));
    const auto exact = wheel_forces(result, scene.convention, true);
    EXPECT_GT(exact[0].force[2], 3e4);
    for (std::size_t wheel = 0; wheel < 2; ++wheel) {
      const double load = 0.5 * small_table().ranges.load;
      for (std::size_t row = 0; row < 3; ++row) {
        EXPECT_NEAR(found.wheels[wheel].force[row], exact[wheel].force[row],
                    found.errors[wheel][0] * load);
      }
      for (std::size_t row = 3; row < 6; ++row) { // arms of up to 750 mm
        EXPECT_NEAR(found.wheels[wheel].force[row], exact[wheel].force[row],
                    750.0 * found.errors[wheel][0] * load);
      }
      const double stiffness = exact[wheel].by_position[2][2];
      EXPECT_NEAR(found.wheels[wheel].by_position[2][2], stiffness, 0.1 * std::abs(stiffness));
      const double by_rail = exact[wheel].by_rail[1][2];
      EXPECT_NEAR(found.wheels[wheel].by_rail[1][2], by_rail, 0.1 * std::abs(by_rail));
    }
  }
}

TEST(TableStep, OutsideItNamesThePlaceOrSolves) {
  VehicleState state = running_state();
  state.position[1] = 2.5;
  try {
    step_in_table(small_table(), state, nullptr);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(std::string(error.what()).find("left wheel: lateral position"), std::string::npos)
        << error.what();
  }
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  const ExactAnswer exact{scene, solver};
  const TableStep found = step_in_table(small_table(), state, &exact);
  SceneResult result = solver.solve(scene_at(scene, state));
  const auto forces = wheel_forces(result, scene.convention, true);
  EXPECT_EQ(found.wheels[0].force, forces[0].force);
  EXPECT_EQ(found.wheels[0].by_velocity, forces[0].by_velocity);
  EXPECT_EQ(found.wheels[0].state, exact_solution);
  EXPECT_EQ(found.errors[0][0], 0.0);
  Scene other = scene;
  other.track.gauge = 1434.0;
  const ExactAnswer of_other{other, solver};
  EXPECT_THROW(step_in_table(small_table(), state, &of_other), Error);
}

/// What the exact solution would not be of: the table's wheels, or the full theory at the
/// velocities of the step.
TEST(TableStep, RefusesAScenePartlyUnlikeTheTables) {
  const auto message_of = [](void (*change)(Scene&), double lateral) -> std::string {
    Scene scene = scene_of_small_table();
    change(scene);
    SceneSolver solver;
    const ExactAnswer exact{scene, solver};
    VehicleState state = running_state();
    state.position[1] = lateral;
    try {
      step_in_table(small_table(), state, &exact);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  constexpr double inside = 0.2; // of the table: before anybody asks for the exact solution
  EXPECT_EQ(message_of([](Scene&) {}, inside), "");
  EXPECT_NE(message_of([](Scene& scene) { scene.left.creepages = Creepages{}; }, inside), "");
  EXPECT_NE(message_of([](Scene& scene) { scene.creep = CreepModel::fastsim; }, inside), "");
  EXPECT_NE(message_of([](Scene& scene) { scene.curved = CurvedChoice::yes; }, inside), "");
  EXPECT_NE(message_of([](Scene& scene) { scene.solver = SolverChoice::paper; }, inside), "");
  EXPECT_NE(
      message_of([](Scene& scene) { scene.track.gauge = 1440.0; }, inside).find("track.gauge"),
      std::string::npos);
  ContactTable measured_again = small_table();
  ++measured_again.identity.profiles;
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  const ExactAnswer exact{scene, solver};
  VehicleState state = running_state();
  state.position[1] = 2.5;
  EXPECT_THROW(step_in_table(measured_again, state, &exact), Error);
}

/// With continuous slopes, a flag, and an error that holds.
TEST(TableStep, GoesOnBeyondTheLargestLoad) {
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  VehicleState state = running_state();
  const auto step_at = [&](double down) {
    VehicleState deep = state;
    deep.position[2] -= down;
    return step_in_table(small_table(), deep, nullptr);
  };
  double low = 0.0; // where the left wheel exceeds it, by bisection
  double high = 0.1;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    ((step_at(middle).wheels[0].state & beyond_load) != 0 ? high : low) = middle;
  }
  const double largest = small_table().ranges.load;
  EXPECT_NEAR(step_at(low).wheels[0].force[2], largest, 0.02 * largest);
  constexpr double step = 1e-6;
  const WheelForces before = step_at(low - step).wheels[0];
  const WheelForces after = step_at(high + step).wheels[0];
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_NEAR(after.by_position[2][row], before.by_position[2][row],
                1e-4 * std::abs(before.by_position[2][2]));
  }
  const TableStep found = step_at(high + 0.01);
  state.position[2] -= high + 0.01;
  SceneResult result = solver.solve(scene_at(scene, state));
  const auto exact = wheel_forces(result, scene.convention, false);
  EXPECT_GT(exact[0].force[2], 1.1 * largest);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_NEAR(found.wheels[0].force[row], exact[0].force[row],
                found.errors[0][0] * exact[0].force[2]);
  }
  state.position[2] -= 1.0;
  expect_error(
      ErrorCode::invalid_argument, [&] { (void)step_in_table(small_table(), state, nullptr); },
      "left wheel: load, after Hertz = ", "the table reaches to 120000 N, and goes on to 220454 N");
}

TEST(TableStep, SolvesExactlyOnRailsThatAreDisplaced) {
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  const ExactAnswer exact{scene, solver};
  VehicleState state = running_state();
  state.position[1] = 2.5;
  state.rails = SixNumbers{0.1, 0.02, 0.0002, -0.05, -0.03, 0.0001};
  for (const WheelForces& wheel : step_in_table(small_table(), state, &exact).wheels) {
    EXPECT_EQ(wheel.state & exact_solution, exact_solution);
  }
}

/// Over the last part of its lateral range, to both sides: the exact solution comes in with its
/// slope.
TEST(TableStep, ForcesGoOverIntoTheExactOnesBeforeTheBorder) {
  ContactTable table = small_table();
  table.radius += 2e-3; // some per cent of the load off, so that a jump shows
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  const ExactAnswer exact{scene, solver};
  VehicleState state = running_state();
  const auto step_at = [&](double lateral) {
    state.position[1] = lateral;
    return step_in_table(table, state, &exact).wheels[0];
  };
  const auto solved = [](const WheelForces& wheel) { return (wheel.state & exact_solution) != 0; };
  EXPECT_FALSE(solved(step_at(0.0)));
  for (const double side : {-1.0, 1.0}) {
    double begin = 0.0; // where the exact solution begins, by bisection
    double end = 2.0;
    while (end - begin > 1e-9) {
      const double middle = 0.5 * (begin + end);
      (solved(step_at(side * middle)) ? end : begin) = middle;
    }
    EXPECT_GT(begin, 0.1);
    const double border = begin + border_share; // of a range of 1 mm
    constexpr double step = 1e-3;
    for (const double place :
         {begin, begin + 0.3 * border_share, begin + 0.7 * border_share, border}) {
      const WheelForces at = step_at(side * place);
      const WheelForces ahead = step_at(side * place + step);
      const WheelForces behind = step_at(side * place - step);
      const double difference = (ahead.force[2] - behind.force[2]) / (2.0 * step);
      // Of the exact solution at an accuracy of 1e-2: 5 % of the stiffest derivative.
      EXPECT_NEAR(at.by_position[1][2], difference, 0.05 * std::abs(at.by_position[2][2])) << place;
    }
  }
}

TEST(TableStep, ErrorsGrowWithFriction) {
  VehicleState state = running_state();
  (*state.velocity)[1] = 0.0;
  state.friction = {0.3, 1.35};
  const TableStep step = step_in_table(small_table(), state, nullptr);
  state.friction = {0.3, 0.3};
  const TableStep usual = step_in_table(small_table(), state, nullptr);
  EXPECT_EQ(step.errors[0], usual.errors[0]);
  EXPECT_GT(step.errors[1][0], 2.0 * usual.errors[1][0]);
  EXPECT_GT(step.errors[1][1], 2.0 * usual.errors[1][1]);
}

/// Within the errors that come with them; and of a wheel that is solved exactly without an error.
TEST(TableStep, HasOutputsWithTheirErrors) {
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  VehicleState state = running_state();
  const TableStep found = step_in_table(small_table(), state, nullptr, true);
  SceneResult result = solver.solve(scene_at(scene, state));
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    SceneWheel& solved = wheel == 0 ? *result.left : *result.right;
    const WheelOutputs exact = outputs_of(solved);
    EXPECT_GT(exact[0], 0.0);
    EXPECT_NEAR(exact[1], solved.centroid.t_rail, 0.0);
    EXPECT_NEAR(exact[5] + exact[6], solved.normal_force, 1e-9 * solved.normal_force);
    for (std::size_t i = 0; i < output_count; ++i) {
      EXPECT_NEAR(found.outputs[wheel][i], exact[i], 1.5 * found.output_errors[wheel][i] + 1e-9)
          << wheel_outputs[i].name;
    }
  }
  state.position[1] = 2.5; // outside
  const ExactAnswer exact{scene, solver};
  const TableStep outside = step_in_table(small_table(), state, &exact, true);
  SceneResult again = solver.solve(scene_at(scene, state));
  EXPECT_EQ(outside.outputs[0], outputs_of(*again.left));
  EXPECT_EQ(outside.output_errors[0], WheelOutputs{});
  state.position[2] = 462.0;
  state.position[1] = 0.0;
  EXPECT_EQ(step_in_table(small_table(), state, nullptr, true).outputs[1], WheelOutputs{});
}

/// Of the lateral positions of the left wheel the table's up to -0.5 mm, exact ones from 0 on.
ContactTable half_exact_table() {
  ContactTable table = small_table();
  ErrorMap steep(table.errors.ranges(), {4, 1});
  for (std::size_t i = 0; i < steep.vertices().size(); ++i) {
    steep.vertices()[i].fill(i < 4 ? 0.01 : 0.5);
  }
  table.errors = steep;
  table.tolerance = 0.1;
  return table;
}

/// A fraction would be no state.
TEST(TableStep, IsOnTheFlangeTipOrNotByTheLargerPart) {
  ContactTable table = half_exact_table();
  std::vector<float>& numbers = table.places.coefficients();
  for (std::size_t i = static_cast<std::size_t>(PlacePart::tip); i < numbers.size();
       i += place_part_count) {
    numbers[i] = 1.0F; // as the exact solution is not
  }
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  const ExactAnswer exact{scene, solver};
  VehicleState state = running_state();
  for (const auto& [lateral, on_tip] : {std::pair(-0.4, 1.0), std::pair(-0.1, 0.0)}) {
    state.position[1] = lateral;
    const TableStep found = step_in_table(table, state, &exact, true);
    EXPECT_EQ(found.wheels[0].state & exact_solution, exact_solution);
    EXPECT_EQ(found.outputs[0][output_count - 1], on_tip);
  }
}

/// Between exact cells and others, forces go over with a continuous slope.
TEST(TableStep, BlendsTheExactSolutionIn) {
  const ContactTable table = half_exact_table();
  const Scene scene = scene_of_small_table();
  SceneSolver solver;
  const ExactAnswer exact{scene, solver};
  VehicleState state = running_state();
  const auto step_at = [&](double lateral) {
    state.position[1] = lateral;
    return step_in_table(table, state, &exact).wheels[0];
  };
  EXPECT_EQ(step_at(-0.8).state & exact_solution, 0);
  EXPECT_EQ(step_at(0.6).state & exact_solution, exact_solution);
  constexpr double step = 1e-3;
  for (double lateral = -0.4; lateral < -0.1; lateral += 0.06) {
    const WheelForces at = step_at(lateral);
    EXPECT_EQ(at.state & exact_solution, exact_solution);
    const WheelForces ahead = step_at(lateral + step);
    const WheelForces behind = step_at(lateral - step);
    for (const std::size_t row : {1U, 2U}) {
      const double difference = (ahead.force[row] - behind.force[row]) / (2.0 * step);
      // Of the exact solution at an accuracy of 1e-2: 5 % of the stiffest derivative.
      EXPECT_NEAR(at.by_position[1][row], difference, 0.05 * std::abs(at.by_position[2][2]));
    }
  }
}

TEST(TableStep, LiftedWheelsHaveNoForces) {
  VehicleState state = running_state();
  state.position[2] = 462.0;
  const TableStep found = step_in_table(small_table(), state, nullptr);
  for (const WheelForces& wheel : found.wheels) {
    EXPECT_EQ(wheel.force, SixNumbers{});
    EXPECT_EQ(wheel.state, lifted);
  }
}

TEST(TableStep, RefusesNumbersOutOfRange) {
  const auto refuses = [](auto change) {
    VehicleState state = running_state();
    change(state);
    EXPECT_THROW(step_in_table(small_table(), state, nullptr), Error);
  };
  refuses([](VehicleState& s) { s.position[2] = std::nan(""); });
  refuses([](VehicleState& s) { s.position[1] = 1e300; });
  refuses([](VehicleState& s) { (*s.velocity)[4] = std::nan(""); });
  refuses([](VehicleState& s) { s.friction = {0.3, -1.0}; });
  refuses([](VehicleState& s) { s.curvature = 1.0; });
  VehicleState state = running_state();
  state.friction = {0.0, 1e-300};
  state.velocity = SixNumbers{1e6, -1e6, 1e6, 1e3, -1e5, 1e3};
  for (const WheelForces& wheel : step_in_table(small_table(), state, nullptr).wheels) {
    for (const double number : wheel.force) {
      EXPECT_TRUE(std::isfinite(number));
    }
  }
}

/// As a forged file may have them: all are finite, but forces would be 0 times infinity.
TEST(TableStep, RefusesATableWhoseNumbersGiveNoForce) {
  ContactTable table = small_table();
  std::vector<float>& numbers = table.contact.coefficients();
  for (std::size_t i = static_cast<std::size_t>(TablePart::normal); i < numbers.size();
       i += table_part_count) {
    numbers[i] = 0.0F;
  }
  VehicleState state = running_state();
  for (const bool derivatives : {false, true}) {
    state.derivatives = derivatives;
    expect_error(
        ErrorCode::file_malformed, [&] { (void)step_in_table(table, state, nullptr); },
        "no finite force");
  }
}

TEST(TableStep, ConvertsUnitsAndFrame) {
  ContactTable table = small_table();
  const TableStep found = step_in_table(table, running_state(), nullptr);
  table.convention = {Units::si, TrackFrame::right_down};
  VehicleState state = running_state();
  for (const std::size_t length : {0U, 1U, 2U}) {
    state.position[length] *= length == 0 ? 1e-3 : -1e-3;
    (*state.velocity)[length] *= length == 0 ? 1e-3 : -1e-3;
  }
  state.position[5] = -state.position[5];
  (*state.velocity)[5] = -(*state.velocity)[5];
  const TableStep turned = step_in_table(table, state, nullptr);
  EXPECT_NEAR(turned.wheels[0].force[2], -found.wheels[0].force[2], 1e-6);
  EXPECT_NEAR(turned.wheels[0].force[3], 1e-3 * found.wheels[0].force[3], 1e-6);
  EXPECT_NEAR(turned.wheels[0].by_position[2][2], 1e3 * found.wheels[0].by_position[2][2], 1.0);
}

} // namespace
} // namespace wrc::test
