/// Steps of time with a history: a wheelset that parks on a slope, is pushed, brakes to rest and
/// starts again, by an implicit integrator of this file.
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "owned_handles.hpp"
#include "wrcontact.hpp"

namespace history_test {
namespace {

using Six = std::array<double, 6>;
using wrcontact::History;
using wrcontact::Scene;
using wrcontact::Solver;
using wrcontact::Step;
using wrcontact::StepArguments;

constexpr double weight = 160e3; // N
constexpr double friction = 0.3;
constexpr double gravity = 9810.0; // mm/s^2
/// t, and t mm^2; of a loaded axle.
const Six masses{weight / gravity, weight / gravity, weight / gravity, 5e6, 1.2e6, 5e6};

Scene scene_of_steps() {
  Scene scene;
  scene.set("solve.accuracy", 1e-2);
  scene.set("solve.accuracy_of", "forces");
  scene.set("friction.coefficient", friction);
  return scene;
}

/// Solves a x = b by elimination with pivots.
Six solved(std::array<Six, 6> a, Six b) {
  for (std::size_t column = 0; column < 6; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < 6; ++row) {
      pivot = std::abs(a[row][column]) > std::abs(a[pivot][column]) ? row : pivot;
    }
    std::swap(a[column], a[pivot]);
    std::swap(b[column], b[pivot]);
    for (std::size_t row = column + 1; row < 6; ++row) {
      const double factor = a[row][column] / a[column][column];
      for (std::size_t i = column; i < 6; ++i) {
        a[row][i] -= factor * a[column][i];
      }
      b[row] -= factor * b[column];
    }
  }
  for (std::size_t row = 6; row-- > 0;) {
    for (std::size_t i = row + 1; i < 6; ++i) {
      b[row] -= a[row][i] * b[i];
    }
    b[row] /= a[row][row];
  }
  return b;
}

/// A wheelset with six degrees of freedom, by the implicit Euler method. Its pitch is locked by a
/// brake or free.
struct Wheelset {
  Scene scene = scene_of_steps();
  Solver solver;
  History history;
  Six q{}, v{};
  Six load{0.0, 0.0, -weight, 0.0, 0.0, 0.0}; ///< of the vehicle and gravity
  bool locked = true;
  Step contact;
  int failed = 0; ///< steps whose iteration did not end
  int iterations = 0;
  Six rest{}; ///< of the balance of forces
  std::array<Six, 6> jacobian{};

  Wheelset() {
    StepArguments arguments;
    const std::array<double, 2> loads{weight, 0.0};
    EXPECT_TRUE(solver.equilibrium(scene, WRC_LOAD_OF_AXLE, loads, q, contact, arguments));
  }

  double force(std::size_t i) const { return contact.force[i] + contact.force[6 + i]; }

  Six moved(const Six& next, double dt) const {
    Six at = q;
    for (std::size_t i = 0; i < 6; ++i) {
      at[i] += dt * next[i];
    }
    return at;
  }

  /// Balance of the forces after a step with these velocities; returns the worst part of it.
  double evaluate(const Six& next, double dt) {
    StepArguments arguments;
    arguments.history = &history;
    arguments.time_step = dt;
    arguments.derivatives = true;
    EXPECT_TRUE(solver.step(scene, moved(next, dt), next, contact, arguments));
    ++iterations;
    for (std::size_t i = 0; i < 6; ++i) {
      rest[i] = load[i] + force(i) - masses[i] * (next[i] - v[i]) / dt;
      for (std::size_t j = 0; j < 6; ++j) {
        const std::size_t k = 6 * j + i;
        jacobian[i][j] = -contact.by_velocity[k] - contact.by_velocity[36 + k] -
                         dt * (contact.by_position[k] + contact.by_position[36 + k]);
      }
      jacobian[i][i] += masses[i] / dt;
    }
    if (locked) {
      jacobian[4] = {};
      jacobian[4][4] = 1.0;
      rest[4] = 0.0;
    }
    double worst = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      worst = std::max(worst, std::abs(rest[i]) / (weight * (i < 3 ? 1.0 : 750.0)));
    }
    return worst;
  }

  /// Newton's method; a change that makes the residual grow is halved, since friction bends
  /// sharply.
  void step(double dt) {
    constexpr int most_iterations = 20;
    constexpr double tolerance = 1e-4; // of the balance, over the weight
    constexpr double least_share = 1.0 / 64.0;
    Six next = v;
    if (locked) {
      next[4] = 0.0;
    }
    double worst = evaluate(next, dt);
    int iteration = 0;
    for (; worst > tolerance && iteration < most_iterations; ++iteration) {
      const Six start = next;
      const Six change = solved(jacobian, rest);
      const double before = worst;
      for (double share = 1.0; share >= least_share; share *= 0.5) {
        for (std::size_t i = 0; i < 6; ++i) {
          next[i] = start[i] + share * change[i];
        }
        worst = evaluate(next, dt);
        if (worst < before) {
          break;
        }
      }
    }
    failed += worst > tolerance ? 1 : 0;
    v = next;
    q = moved(next, dt);
    history.accept();
  }

  void run(double duration, double dt) {
    for (int i = 0; i < static_cast<int>(std::lround(duration / dt)); ++i) {
      step(dt);
    }
  }
};

TEST(History, WheelsetParksOnASlope) {
  Wheelset wheelset;
  constexpr double slope = 0.01;
  wheelset.load[0] = -slope * weight;
  wheelset.run(0.5, 0.01);
  EXPECT_NEAR(wheelset.force(0), slope * weight, 1e-3 * weight);
  const double settled = wheelset.q[0];
  EXPECT_LT(settled, -1e-5); // it hangs on the contact
  EXPECT_GT(settled, -5e-3);
  wheelset.run(by_extent(9.5, 2.0), 0.02);
  // Without history it creeps 0.4 um, with the default standstill speed of 1 mm/s.
  EXPECT_NEAR(wheelset.q[0], settled, 2e-4);
  EXPECT_LT(std::abs(wheelset.v[0]), 1e-3);
  EXPECT_EQ(wheelset.failed, 0);
}

TEST(History, WheelsetSlidesWhereAPushExceedsFriction) {
  for (const std::size_t direction : some_of({0U, 1U}, 1)) {
    for (const double share : {0.9, 1.5}) {
      SCOPED_TRACE(std::to_string(direction) + " " + std::to_string(share));
      Wheelset wheelset;
      wheelset.run(0.02, 1e-3);
      const double start = wheelset.q[direction];
      wheelset.load[direction] = share * friction * weight;
      wheelset.run(0.1, 1e-3);
      const double moved = wheelset.q[direction] - start;
      if (share < 1.0) {
        EXPECT_LT(std::abs(moved), 0.1); // the contacts give way
        EXPECT_LT(std::abs(wheelset.v[direction]), 0.3);
        EXPECT_NEAR(wheelset.force(direction), -share * friction * weight, 0.02 * weight);
      } else if (direction == 0) {
        const double acceleration = (share - 1.0) * friction * gravity;
        EXPECT_NEAR(moved, 0.5 * acceleration * 0.1 * 0.1, 0.1 * moved);
      } else {
        EXPECT_GT(moved, 0.5);
      }
      EXPECT_EQ(wheelset.failed, 0);
    }
  }
}

TEST(History, BrakesToRestAndStays) {
  Wheelset wheelset;
  wheelset.v[0] = 1e3;
  const double stop = 1e3 / (friction * gravity); // s
  wheelset.run(0.5 * stop, 2e-3);
  EXPECT_NEAR(wheelset.v[0],
              1e3 - friction * gravity * 2e-3 * static_cast<double>(std::lround(0.5 * stop / 2e-3)),
              20.0);
  wheelset.run(0.8 * stop, 2e-3);
  const double stopped = wheelset.q[0];
  EXPECT_NEAR(stopped, 0.5 * 1e3 * stop, 0.02 * stopped);
  wheelset.run(by_extent(1.0, 0.2), 0.01);
  EXPECT_NEAR(wheelset.q[0], stopped, 1e-2); // what oscillates on the contact dies out
  EXPECT_LT(std::abs(wheelset.v[0]), 1e-2);
  EXPECT_EQ(wheelset.failed, 0);
}

TEST(History, StartsOnASlopeWhenItsBrakeIsReleased) {
  Wheelset wheelset;
  constexpr double slope = 0.02;
  wheelset.load[0] = slope * weight;
  wheelset.run(0.2, 5e-3);
  EXPECT_LT(std::abs(wheelset.v[0]), 1.0);
  wheelset.locked = false;
  const double start = wheelset.q[0];
  wheelset.run(0.5, 5e-3);
  const double radius = 460.0;
  const double acceleration = slope * weight / (masses[0] + masses[4] / (radius * radius));
  EXPECT_NEAR(wheelset.v[0], 0.5 * acceleration, 0.01 * wheelset.v[0]);
  EXPECT_NEAR(wheelset.v[4] * radius, wheelset.v[0], 0.01 * wheelset.v[0]);
  EXPECT_NEAR(wheelset.q[0] - start, 0.125 * acceleration, 0.02 * (wheelset.q[0] - start));
  EXPECT_EQ(wheelset.failed, 0);
}

TEST(History, StandstillWithSidewaysVelocitiesFailsNoStep) {
  for (const auto& [speed, lateral] : some_of({std::pair{50.0, 10.0}, {0, 10}, {0, 0.1}}, 1)) {
    SCOPED_TRACE(std::to_string(speed) + " " + std::to_string(lateral));
    Wheelset wheelset;
    wheelset.locked = false;
    wheelset.v = {speed, lateral, 0.0, 0.0, speed / 460.0, 0.0};
    wheelset.run(0.1, 1e-3);
    EXPECT_EQ(wheelset.failed, 0);
    EXPECT_LT(wheelset.iterations, 600);
    EXPECT_LT(std::abs(wheelset.v[1]), std::max(1.0, 0.5 * lateral));
  }
}

/// Forces of a hunting wheelset with and without history.
TEST(History, EqualsSteadyRollingAtSpeed) {
  constexpr double speed = 30e3;
  constexpr double dt = 1e-3; // 30 mm, of a contact of 12 mm
  constexpr double amplitude = 2.0;
  constexpr double frequency = 2.0 * std::numbers::pi * speed / 15e3;
  Wheelset still;
  Scene scene = scene_of_steps();
  scene.set("solve.accuracy", 1e-3);
  Solver solver;
  History history;
  for (int i = 0; i < 30; ++i) {
    const double phase = frequency * dt * i;
    Six q = still.q;
    q[1] = amplitude * std::sin(phase);
    const Six v{speed, amplitude * frequency * std::cos(phase), 0.0, 0.0, speed / 460.0, 0.0};
    Step steady;
    ASSERT_TRUE(solver.step(scene, q, v, steady));
    // A very long step is steady rolling whatever was before, as far as both are iterated.
    StepArguments arguments;
    arguments.history = &history;
    arguments.time_step = 1e6;
    Step step;
    ASSERT_TRUE(solver.step(scene, q, v, step, arguments));
    for (std::size_t k = 0; k < 12; ++k) {
      EXPECT_NEAR(step.force[k], steady.force[k], 1e-4 * 80e3 * (k % 6 < 3 ? 1.0 : 750.0))
          << i << ' ' << k;
    }
    if (i == 0) {
      history.accept();
    }
    arguments.time_step = dt;
    ASSERT_TRUE(solver.step(scene, q, v, step, arguments));
    history.accept();
    for (std::size_t k = 0; k < 12; ++k) {
      if (k % 6 < 3) {
        EXPECT_NEAR(step.force[k], steady.force[k], 1e-3 * 80e3) << i << ' ' << k;
      }
    }
  }
}

/// A state at rest in which tractions are held.
struct Held {
  Wheelset wheelset;
  Six v{};
  StepArguments arguments;
  Held() {
    wheelset.load[0] = 0.05 * weight;
    wheelset.run(0.05, 1e-3);
    v = {0.3, -0.2, 0.0, 0.0, 0.0, 1e-4};
    arguments.history = &wheelset.history;
    arguments.time_step = 1e-3;
  }
  Step step(const Six& q, const Six& velocity) {
    Step result;
    EXPECT_TRUE(wheelset.solver.step(wheelset.scene, q, velocity, result, arguments));
    return result;
  }
};

TEST(History, ARejectedStepIsRepeatedToTheBit) {
  Held held;
  const Six q = held.wheelset.q;
  const Step first = held.step(q, held.v);
  held.step(q, {40.0, 0.0, 0.0, 0.0, 0.0, 0.0}); // slides; not accepted
  Step failing;
  Six beside = q;
  beside[1] = 200.0;
  EXPECT_THROW(
      held.wheelset.solver.step(held.wheelset.scene, beside, held.v, failing, held.arguments),
      wrcontact::Error);
  EXPECT_EQ(held.step(q, held.v).force, first.force);
  // From a copy too, after the original has gone on, and without the solver's memory.
  History copy;
  copy.copy(held.wheelset.history);
  held.wheelset.history.accept();
  EXPECT_NE(held.step(q, held.v).force, first.force);
  held.arguments.history = &copy;
  held.wheelset.solver.clear();
  EXPECT_EQ(held.step(q, held.v).force, first.force);
  // None: as a new one. Without history: as ever.
  copy.clear();
  const Step cleared = held.step(q, held.v);
  const History fresh;
  held.arguments.history = &fresh;
  EXPECT_EQ(held.step(q, held.v).force, cleared.force);
  Scene other = scene_of_steps();
  Step plain;
  Step after;
  ASSERT_TRUE(held.wheelset.solver.step(other, q, held.v, plain));
  ASSERT_TRUE(held.wheelset.solver.step(held.wheelset.scene, q, held.v, after));
  EXPECT_EQ(after.force, plain.force);
}

/// The speed that creepages are over near standstill is but a unit.
TEST(History, StandstillSpeedHasNoEffect) {
  Held held;
  const Six q = held.wheelset.q;
  const Step one = held.step(q, held.v);
  held.wheelset.scene.set("motion.standstill_speed", 100.0);
  const Step other = held.step(q, held.v);
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_NEAR(one.force[k], other.force[k], 1e-4 * 80e3 * (k % 6 < 3 ? 1.0 : 750.0)) << k;
  }
}

/// By velocities what adhesion resists over the step, by positions what moves the contact.
TEST(History, DerivativesAreThoseOfDifferences) {
  Held held;
  held.wheelset.scene.set("solve.accuracy", 1e-3);
  for (const double speed : {0.3, 50.0}) {
    SCOPED_TRACE(speed);
    Six v = held.v;
    v[0] = speed;
    v[4] = speed > 1.0 ? speed / 460.0 : 0.0;
    held.arguments.derivatives = true;
    const Step at = held.step(held.wheelset.q, v);
    const Six steps{1e-2, 1e-2, 0.0, 1e-5, 1e-5, 1e-5};
    for (std::size_t j : {0U, 1U, 3U, 4U, 5U}) {
      Six ahead = v;
      Six behind = v;
      ahead[j] += steps[j];
      behind[j] -= steps[j];
      const Step later = held.step(held.wheelset.q, ahead);
      const Step earlier = held.step(held.wheelset.q, behind);
      double scale = 0.0;
      for (std::size_t k = 0; k < 12; ++k) {
        const double of_moment = k % 6 < 3 ? 1.0 : 1.0 / 750.0;
        scale = std::max(scale, of_moment * std::abs(at.by_velocity[36 * (k / 6) + 6 * j + k % 6]));
      }
      for (std::size_t k = 0; k < 12; ++k) {
        const double of_moment = k % 6 < 3 ? 1.0 : 1.0 / 750.0;
        const double difference = 0.5 * (later.force[k] - earlier.force[k]) / steps[j];
        EXPECT_NEAR(of_moment * at.by_velocity[36 * (k / 6) + 6 * j + k % 6],
                    of_moment * difference, 0.03 * scale)
            << j << ' ' << k;
      }
    }
  }
}

TEST(History, RefusesWhatItCannotSolve) {
  Scene scene = scene_of_steps();
  Solver solver;
  History history;
  const Six q = Wheelset().q;
  const Six v{};
  std::array<double, 12> force{};
  wrc_history* handle = history.handle();
  wrc_step_arguments arguments{};
  arguments.struct_size = sizeof arguments;
  const auto step = [&] {
    return wrc_solver_step_with(solver.handle(), scene.handle(), q.data(), v.data(), &arguments,
                                force.data());
  };
  const auto says = [&](const char* text) {
    return std::string(wrc_scene_error(scene.handle())).find(text) != std::string::npos;
  };
  arguments.time_step = 1e-3;
  EXPECT_EQ(step(), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(says("time_step = 0.001"));
  arguments.histories = &handle;
  for (const double wrong : {0.0, -1.0, 1e10, std::nan("")}) {
    arguments.time_step = wrong;
    EXPECT_EQ(step(), WRC_INVALID_ARGUMENT);
    EXPECT_TRUE(says("time_step")) << wrong;
  }
  arguments.time_step = 1e-3;
  wrc_history* none = nullptr;
  arguments.histories = &none;
  EXPECT_EQ(step(), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(says("history: "));
  arguments.histories = &handle;
  scene.set("solve.creep", "fastsim");
  EXPECT_EQ(step(), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(says("solve.creep")) << wrc_scene_error(scene.handle());
  scene.set("solve.creep", "full");
  scene.set("material.wheel.youngs_modulus", 70000.0);
  EXPECT_EQ(step(), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(says("unlike")) << wrc_scene_error(scene.handle());
  double loads[2] = {80e3, 80e3};
  Six found{};
  EXPECT_EQ(wrc_solver_equilibrium(solver.handle(), scene.handle(), WRC_LOADS_OF_WHEELS, loads,
                                   nullptr, &arguments, found.data(), force.data()),
            WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_history_copy(handle, nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_history_accept(nullptr), WRC_INVALID_ARGUMENT);
}

/// Histories of a batch, on any threads.
TEST(History, BatchesAreSteps) {
  const Six q = Wheelset().q;
  constexpr std::size_t count = 3;
  std::array<Scene, count> scenes{scene_of_steps(), scene_of_steps(), scene_of_steps()};
  std::array<Solver, count> solvers;
  std::array<History, count> histories;
  std::array<wrc_scene*, count> scene_handles{};
  std::array<wrc_solver*, count> solver_handles{};
  std::array<wrc_history*, count> history_handles{};
  std::vector<double> positions;
  std::vector<double> velocities;
  for (std::size_t i = 0; i < count; ++i) {
    scene_handles[i] = scenes[i].handle();
    solver_handles[i] = solvers[i].handle();
    history_handles[i] = histories[i].handle();
    positions.insert(positions.end(), q.begin(), q.end());
    const Six v{1.0 + static_cast<double>(i), 0.5, 0.0, 0.0, 0.0, 0.0};
    velocities.insert(velocities.end(), v.begin(), v.end());
  }
  wrc_step_arguments arguments{};
  arguments.struct_size = sizeof arguments;
  arguments.histories = history_handles.data();
  arguments.time_step = 1e-3;
  std::array<double, 12 * count> forces{};
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(wrc_step_batch_with(solver_handles.data(), scene_handles.data(), count, 2,
                                  positions.data(), velocities.data(), &arguments, forces.data(),
                                  nullptr),
              WRC_OK);
    for (History& history : histories) {
      history.accept();
    }
  }
  Solver solver;
  Scene scene = scene_of_steps();
  for (std::size_t i = 0; i < count; ++i) {
    History history;
    Step step;
    for (int k = 0; k < 3; ++k) {
      StepArguments one;
      one.history = &history;
      one.time_step = 1e-3;
      ASSERT_TRUE(solver.step(scene, q, {1.0 + static_cast<double>(i), 0.5, 0.0, 0.0, 0.0, 0.0},
                              step, one));
      history.accept();
    }
    for (std::size_t k = 0; k < 12; ++k) {
      EXPECT_EQ(forces[12 * i + k], step.force[k]);
    }
  }
  history_handles[1] = history_handles[0];
  EXPECT_EQ(wrc_step_batch_with(solver_handles.data(), scene_handles.data(), count, 2,
                                positions.data(), velocities.data(), &arguments, forces.data(),
                                nullptr),
            WRC_INVALID_ARGUMENT);
}

} // namespace
} // namespace history_test
