/// Calls for vehicle simulations: one step, many, patches, creep forces at the caller's creepages,
/// tables; against what keys, solve and results by name do.
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "owned_handles.hpp"
#include "wrcontact.hpp"

namespace vehicle_test {
namespace {

using Six = std::array<double, 6>;
using wrcontact::Scene;
using wrcontact::Solver;
using wrcontact::Step;

const std::array<const char*, 6> components{"force.x",  "force.y",  "force.z",
                                            "moment.x", "moment.y", "moment.z"};

/// Height at which about 80 kN are carried, and slow sliding.
const Six position{1e6, 3.0, 459.815, 1.8e-4, 0.5, 1e-3};
const Six velocity{2e4, 15.0, 1.0, 2e-3, 43.5, -5e-3};

Scene vehicle_scene(const char* creep = "fastsim") {
  Scene scene;
  scene.set("solve.accuracy", 1e-2);
  scene.set("solve.accuracy_of", "forces");
  scene.set("solve.creep", creep);
  return scene;
}

/// The same by keys.
void set_state(Scene& scene, const Six& q, const Six& v) {
  for (const auto& [key, value] : {std::pair("pose.lateral", q[1]),
                                   {"pose.vertical", q[2]},
                                   {"pose.roll", q[3]},
                                   {"pose.yaw", q[5]},
                                   {"motion.speed", v[0]},
                                   {"motion.lateral", v[1]},
                                   {"motion.vertical", v[2]},
                                   {"motion.roll", v[3]},
                                   {"motion.pitch", v[4]},
                                   {"motion.yaw", v[5]}}) {
    scene.set(key, value);
  }
}

double total(const Scene& scene, std::size_t i) {
  return scene.number(std::string(i < 6 ? "left.total." : "right.total.") + components[i % 6]);
}

TEST(Steps, EqualKeysAndSolve) {
  Scene by_keys = vehicle_scene();
  set_state(by_keys, position, velocity);
  by_keys.set("track.right.displacement", {0.5, -0.01, 1e-3});
  by_keys.set("solve.derivatives", "yes");
  by_keys.solve();
  Scene scene = vehicle_scene();
  Solver solver;
  Step step;
  const Six rails{0.0, 0.0, 0.0, 0.5, -0.01, 1e-3};
  ASSERT_TRUE(solver.step(scene, position, velocity, step, true, &rails));
  const std::array<const char*, 6> positions{"", "lateral", "vertical", "roll", "", "yaw"};
  const std::array<const char*, 6> velocities{"speed",     "lateral_velocity", "vertical_velocity",
                                              "roll_rate", "pitch_rate",       "yaw_rate"};
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(step.force[i], total(by_keys, i)) << i;
    EXPECT_EQ(total(scene, i), step.force[i]) << i;
    const std::string row =
        std::string(i < 6 ? "left" : "right") + ".jacobian." + components[i % 6] + ".by.";
    for (std::size_t j = 0; j < 6; ++j) {
      const std::size_t at = 36 * (i / 6) + 6 * j + i % 6;
      EXPECT_EQ(step.by_velocity[at], by_keys.number(row + velocities[j])) << row << velocities[j];
      EXPECT_EQ(step.by_position[at],
                *positions[j] == '\0' ? 0.0 : by_keys.number(row + positions[j]))
          << row << positions[j];
    }
  }
  EXPECT_EQ(step.states, (std::array<std::int32_t, 2>{}));
}

TEST(StepArguments, EqualKeysAndSolve) {
  Scene by_keys = vehicle_scene();
  set_state(by_keys, position, velocity);
  by_keys.set("track.left.displacement", {0.2, -0.05, 0.0});
  by_keys.set("track.left.velocity", {3.0, 0.0, 0.0});
  by_keys.set("motion.curvature", -2e-6);
  by_keys.set("friction.left", 0.2);
  by_keys.set("friction.right", 0.4);
  by_keys.solve();
  Scene scene = vehicle_scene();
  Solver solver;
  Step step;
  wrcontact::StepArguments arguments;
  arguments.rails = Six{0.2, -0.05, 0.0, 0.0, 0.0, 0.0};
  arguments.rail_velocities = Six{3.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  arguments.curvature = -2e-6;
  arguments.friction = {0.2, 0.4};
  ASSERT_TRUE(solver.step(scene, position, velocity, step, arguments));
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(step.force[i], total(by_keys, i)) << i;
  }
  // They stay, and derivatives of rails oppose those of the wheelset.
  wrcontact::StepArguments later;
  later.derivatives = true;
  Step again;
  ASSERT_TRUE(solver.step(scene, position, velocity, again, later));
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(again.force[i], step.force[i]) << i;
    const std::size_t of_wheel = 36 * (i / 6) + i % 6;
    const std::size_t of_rail = 18 * (i / 6) + i % 6;
    EXPECT_EQ(later.by_rail[of_rail + 6], -again.by_position[of_wheel + 12]) << i;
    EXPECT_EQ(later.by_rail_velocity[of_rail], -again.by_velocity[of_wheel + 6]) << i;
  }
}

TEST(StepArguments, OfAnotherSizeAreRefused) {
  Scene scene = vehicle_scene();
  Solver solver;
  std::array<double, 12> force{};
  wrc_step_arguments arguments{};
  for (const std::uint64_t size :
       {std::uint64_t{0}, std::uint64_t{offsetof(wrc_step_arguments, histories) - 8},
        std::uint64_t{1} << 40}) {
    arguments.struct_size = size;
    EXPECT_EQ(wrc_solver_step_with(solver.handle(), scene.handle(), position.data(),
                                   velocity.data(), &arguments, force.data()),
              WRC_INVALID_ARGUMENT);
    wrc_solver* solvers[] = {solver.handle()};
    wrc_scene* scenes[] = {scene.handle()};
    EXPECT_EQ(wrc_step_batch_with(solvers, scenes, 1, 1, position.data(), velocity.data(),
                                  &arguments, force.data(), nullptr),
              WRC_INVALID_ARGUMENT);
  }
  // That of programs compiled before there were histories is not.
  arguments.struct_size = offsetof(wrc_step_arguments, histories);
  EXPECT_EQ(wrc_solver_step_with(solver.handle(), scene.handle(), position.data(), velocity.data(),
                                 &arguments, force.data()),
            WRC_OK);
  EXPECT_EQ(wrc_solver_step_with(solver.handle(), scene.handle(), position.data(), velocity.data(),
                                 nullptr, force.data()),
            WRC_OK);
}

TEST(LongWaves, ShiftRailsAndWheelsetTogether) {
  Scene scene = vehicle_scene();
  Solver solver;
  Step here;
  Step far;
  wrcontact::StepArguments arguments;
  ASSERT_TRUE(solver.step(scene, position, velocity, here, arguments));
  arguments.rails = Six{1500.0, -800.0, 0.0, 1500.0, -800.0, 0.0};
  Six moved = position;
  moved[1] += 1500.0;
  moved[2] -= 800.0;
  ASSERT_TRUE(solver.step(scene, moved, velocity, far, arguments));
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(far.force[i], here.force[i], 1e-6 * std::abs(here.force[i]) + 1.0) << i;
  }
}

TEST(Equilibria, PutAWheelsetWhereItsWheelsCarryTheLoads) {
  Scene scene = vehicle_scene();
  Solver solver;
  Step step;
  wrcontact::StepArguments arguments;
  Six place{0.0, 3.0, 0.0, 0.0, 0.0, 1e-3};
  ASSERT_TRUE(solver.equilibrium(scene, WRC_LOADS_OF_WHEELS, {9e4, 5e4}, place, step, arguments,
                                 &velocity));
  EXPECT_NEAR(step.force[2], 9e4, 20.0);
  EXPECT_NEAR(step.force[8], 5e4, 20.0);
  EXPECT_EQ(scene.number("left.total.force.z"), step.force[2]);
  Step there;
  ASSERT_TRUE(solver.step(scene, place, velocity, there));
  EXPECT_EQ(there.force, step.force) << "the same bits by a step";
  const Six before = place;
  EXPECT_THROW(solver.equilibrium(scene, WRC_LOAD_OF_AXLE, {1e5, 1e9}, place, step, arguments),
               wrcontact::Error);
  EXPECT_THROW(solver.equilibrium(scene, 2, {1e5, 0.0}, place, step, arguments), wrcontact::Error);
  EXPECT_EQ(place, before);
}

TEST(Steps, UseTheConventionOfTheScene) {
  Scene scene = vehicle_scene();
  Solver solver;
  Step inside;
  ASSERT_TRUE(solver.step(scene, position, velocity, inside, true));
  Scene other = vehicle_scene();
  other.set("convention.units", "SI");
  other.set("convention.frame", "right-down");
  const auto turned = [](const Six& values, double pitch_sign) {
    return Six{1e-3 * values[0], -1e-3 * values[1],      -1e-3 * values[2],
               values[3],        pitch_sign * values[4], -values[5]};
  };
  Step outside;
  ASSERT_TRUE(solver.step(other, turned(position, 1.0), turned(velocity, 1.0), outside, true));
  const Six scale{1.0, -1.0, -1.0, 1e-3, -1e-3, -1e-3};
  const Six columns{1e3, -1e3, -1e3, 1.0, 1.0, -1.0};
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(outside.force[i], scale[i % 6] * inside.force[i], 1e-7 * 8e4)
        << i; // what the iteration makes of rounding
  }
  // Derivatives of FASTSIM are differences, which amplify rounding.
  for (std::size_t i = 0; i < 72; ++i) {
    const double factor = scale[i % 6] * columns[i / 6 % 6];
    EXPECT_NEAR(outside.by_velocity[i], factor * inside.by_velocity[i],
                1e-7 * std::abs(factor * inside.by_velocity[i]) + 1e-6)
        << i;
  }
}

TEST(Steps, AWheelsetOffItsRailsHasNoForces) {
  Scene scene = vehicle_scene();
  Solver solver;
  Step step;
  Six lifted = position;
  lifted[2] = 470.0;
  ASSERT_TRUE(solver.step(scene, lifted, velocity, step, true));
  EXPECT_EQ(step.force, (std::array<double, 12>{}));
  EXPECT_EQ(step.by_velocity, (std::array<double, 72>{}));
  EXPECT_EQ(step.states, (std::array<std::int32_t, 2>{WRC_LIFTED, WRC_LIFTED}));
  EXPECT_EQ(scene.number("left.state"), WRC_LIFTED);
  EXPECT_TRUE(scene.patches().empty());
  lifted[3] = 10.2 / 750.0; // the right wheel comes down again
  ASSERT_TRUE(solver.step(scene, lifted, velocity, step));
  EXPECT_EQ(step.states, (std::array<std::int32_t, 2>{WRC_LIFTED, 0}));
  EXPECT_GT(step.force[8], 0.0);
}

TEST(Steps, AFailedStepChangesNothing) {
  Scene scene = vehicle_scene();
  Solver solver;
  Step step;
  ASSERT_TRUE(solver.step(scene, position, velocity, step));
  const Step before = step;
  Six refused = position;
  refused[5] = 0.3;
  try {
    solver.step(scene, refused, velocity, step);
    FAIL();
  } catch (const wrcontact::Error& error) {
    EXPECT_EQ(error.status(), WRC_INVALID_ARGUMENT);
    EXPECT_NE(std::string(error.what()).find("pose.yaw = 0.3"), std::string::npos) << error.what();
  }
  const double gauge = scene.get_number("track.gauge");
  scene.set("track.gauge", 600.0); // the wheels are beside the rails
  EXPECT_THROW(solver.step(scene, position, velocity, step), wrcontact::Error);
  scene.set("track.gauge", gauge);
  EXPECT_EQ(step.force, before.force);
  EXPECT_EQ(total(scene, 1), before.force[1]);
  EXPECT_EQ(scene.get_number("pose.lateral"), position[1]);
  std::array<double, 12> force{};
  EXPECT_EQ(wrc_solver_step(solver.handle(), scene.handle(), nullptr, velocity.data(), nullptr,
                            force.data(), nullptr, nullptr, nullptr),
            WRC_INVALID_ARGUMENT);
  EXPECT_STREQ(wrc_scene_error(scene.handle()), "position = NULL: a pointer must be given");
}

void expect_refused_step(Scene& scene, const std::string& text, bool derivatives) {
  Step step;
  try {
    Solver().step(scene, position, velocity, step, derivatives);
    FAIL() << text;
  } catch (const wrcontact::Error& error) {
    EXPECT_EQ(error.status(), WRC_INVALID_ARGUMENT);
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(Steps, AreRefusedWithoutForcesOrDerivatives) {
  Scene scene = vehicle_scene();
  for (const char* until : {"geometry", "remesh"}) {
    scene.set("solve.until", until);
    expect_refused_step(scene, std::string("solve.until = ") + until, false);
  }
  scene.set("solve.until", "mechanics");
  for (const char* model : {"hertz", "kik-piotrowski"}) {
    scene.set("solve.model", model);
    expect_refused_step(scene, std::string("solve.model = ") + model, true);
  }
}

TEST(StepBatches, HaveTheBitsOfSingleStepsForAnyNumberOfThreads) {
  constexpr std::size_t count = 5;
  std::vector<Scene> scenes;
  std::vector<Solver> solvers(count);
  std::vector<wrc_scene*> scene_handles;
  std::vector<wrc_solver*> solver_handles;
  std::vector<double> q, v, f(12 * count), expected;
  for (std::size_t i = 0; i < count; ++i) {
    scenes.push_back(vehicle_scene());
    Six at = position;
    at[1] += 0.01 * static_cast<double>(i);
    at[5] = i == 3 ? 0.5 : at[5]; // refused
    q.insert(q.end(), at.begin(), at.end());
    v.insert(v.end(), velocity.begin(), velocity.end());
    Scene alone = vehicle_scene();
    Step step;
    if (i != 3) {
      Solver().step(alone, at, velocity, step);
    }
    expected.insert(expected.end(), step.force.begin(), step.force.end());
  }
  for (std::size_t i = 0; i < count; ++i) {
    scene_handles.push_back(scenes[i].handle());
    solver_handles.push_back(solvers[i].handle());
  }
  for (const int threads : {1, 3}) {
    std::fill(f.begin(), f.end(), 0.0);
    std::vector<wrc_status> statuses(count, -1);
    std::vector<std::int32_t> states(2 * count, -1);
    EXPECT_EQ(wrc_step_batch(solver_handles.data(), scene_handles.data(), count, threads, q.data(),
                             v.data(), nullptr, f.data(), nullptr, nullptr, states.data(),
                             statuses.data()),
              WRC_INVALID_ARGUMENT);
    EXPECT_EQ(f, expected) << threads;
    EXPECT_EQ(statuses, (std::vector<wrc_status>{WRC_OK, WRC_OK, WRC_OK, WRC_INVALID_ARGUMENT, 0}));
    EXPECT_EQ(states, (std::vector<std::int32_t>{0, 0, 0, 0, 0, 0, -1, -1, 0, 0}));
  }
  scene_handles[1] = scene_handles[0];
  EXPECT_EQ(wrc_step_batch(solver_handles.data(), scene_handles.data(), count, 1, q.data(),
                           v.data(), nullptr, f.data(), nullptr, nullptr, nullptr, nullptr),
            WRC_INVALID_ARGUMENT);
}

// Tread and flange of the left wheel carry; results by name have the larger force first.
TEST(Patches, AreInTheOrderOfTheirPlaces) {
  Scene scene = vehicle_scene();
  scene.set("track.rail", "56E1");
  scene.set("pose.lateral", 6.15);
  scene.set("motion.speed", 2e4);
  scene.solve();
  const auto patches = scene.patches();
  ASSERT_EQ(patches.size(), 3U);
  EXPECT_EQ(patches[0].wheel, 0.0);
  EXPECT_EQ(patches[2].wheel, 1.0);
  EXPECT_LT(patches[0].s_wheel, patches[1].s_wheel);
  double force_z = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string prefix =
        patches[i].normal_force == scene.number("left.patches.0.normal_force") ? "left.patches.0."
                                                                               : "left.patches.1.";
    EXPECT_EQ(patches[i].s_wheel, scene.number(prefix + "s_wheel"));
    EXPECT_EQ(patches[i].y, scene.number(prefix + "y"));
    EXPECT_EQ(patches[i].angle, scene.number(prefix + "angle"));
    EXPECT_EQ(patches[i].creepage_spin, scene.number(prefix + "creepage.spin"));
    EXPECT_EQ(patches[i].creep_force_lateral, scene.number(prefix + "creep_force.lateral"));
    // Creep forces lie in the plane but for the tangents of elements, normal forces have a
    // direction of their own.
    EXPECT_NEAR(patches[i].normal_y, -std::sin(scene.number(prefix + "plane_angle")), 1e-12);
    force_z += patches[i].normal_force * std::cos(patches[i].angle) -
               patches[i].creep_force_lateral * patches[i].normal_y;
  }
  EXPECT_NEAR(force_z / scene.number("left.total.force.z"), 1.0, 1e-3);
  std::int64_t count = 0;
  wrc_patch one{};
  EXPECT_EQ(wrc_scene_patches(scene.handle(), &one, sizeof one, 1, &count), WRC_TOO_SMALL);
  EXPECT_EQ(count, 3);
  EXPECT_EQ(wrc_scene_patches(scene.handle(), &one, 24, 1, &count), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_scene_patches(Scene().handle(), &one, sizeof one, 1, &count), WRC_NO_RESULT);
}

/// Creepages of all patches, as keys.
TEST(CreepOfACaller, EqualsCreepOfGivenCreepages) {
  for (const char* model : {"full", "polach", "fastsim"}) {
    SCOPED_TRACE(model);
    Scene given = vehicle_scene(model);
    given.set("pose.lateral", 5.0); // two lobes in one plane
    given.set("solve.grid", {40.0, 60.0});
    given.set("creepage.right", {1e-3, -5e-4, 2e-4});
    given.set("creepage.left", {1e-3, -5e-4, 2e-4});
    given.solve();
    Scene scene = vehicle_scene(model);
    scene.set("pose.lateral", 5.0);
    scene.set("solve.grid", {40.0, 60.0});
    scene.solve();
    Solver solver;
    const auto patches = scene.patches();
    ASSERT_EQ(patches.size(), 2U);
    for (std::int64_t patch = 0; patch < 2; ++patch) {
      const std::string prefix = patch == 0 ? "left.patches.0." : "right.patches.0.";
      std::array<double, 9> by{};
      const auto forces = solver.creep(scene, patch, {1e-3, -5e-4, 2e-4}, &by);
      const double bound = 0.3 * scene.number(prefix + "normal_force");
      const std::array<const char*, 3> names{"creep_force.longitudinal", "creep_force.lateral",
                                             "spin_moment"};
      for (std::size_t i = 0; i < 3; ++i) {
        const double size = i < 2 ? bound : 6.0 * bound;
        EXPECT_NEAR(forces[i] / size, given.number(prefix + names[i]) / size, 1e-10) << names[i];
        for (std::size_t j = 0; j < 3; ++j) {
          std::array<double, 3> ahead{1e-3, -5e-4, 2e-4};
          std::array<double, 3> behind = ahead;
          const double step = j < 2 ? 2e-5 : 4e-6;
          ahead[j] += step;
          behind[j] -= step;
          const double difference =
              (solver.creep(scene, patch, ahead)[i] - solver.creep(scene, patch, behind)[i]) /
              (2.0 * step);
          EXPECT_NEAR(by[3 * i + j] * ahead[j] / size, difference * ahead[j] / size, 3e-2)
              << names[i] << " by " << j;
        }
      }
    }
    EXPECT_THROW(solver.creep(scene, 2, {0.0, 0.0, 0.0}), wrcontact::Error);
    EXPECT_THROW(solver.creep(scene, -1, {0.0, 0.0, 0.0}), wrcontact::Error);
    EXPECT_THROW(solver.creep(scene, 0, {NAN, 0.0, 0.0}), wrcontact::Error);
  }
}

TEST(Tables, EqualSingleSolutions) {
  Scene scene = vehicle_scene();
  scene.set("motion.speed", 2e4);
  const std::vector<double> laterals{-3.0, 0.0, 4.0};
  const std::vector<double> yaws{0.0, 2e-3};
  const std::vector<std::string> results{"left.total.force.y", "right.patches.0.angle",
                                         "left.patches.7.angle"};
  const std::string path = testing::TempDir() + "table." + std::to_string(getpid()) + ".txt";
  const auto table =
      scene.tabulate({{"pose.lateral", laterals}, {"pose.yaw", yaws}}, results, 2, path);
  ASSERT_EQ(table.size(), 18U);
  EXPECT_EQ(scene.get_number("pose.lateral"), 0.0);
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("pose.lateral: 3 values"), std::string::npos);
  EXPECT_NE(text.str().find("speed = 20000.0"), std::string::npos);
  EXPECT_NE(text.str().find("\n# pose.lateral pose.yaw left.total.force.y"), std::string::npos);
  std::string line;
  while (text.peek() == '#' && std::getline(text, line)) {
  }
  std::size_t at = 0;
  for (const double yaw : yaws) {
    for (const double lateral : laterals) {
      Scene alone = vehicle_scene();
      alone.set("motion.speed", 2e4);
      alone.set("pose.lateral", lateral);
      alone.set("pose.yaw", yaw);
      alone.solve();
      std::array<std::string, 5> columns;
      for (std::string& column : columns) {
        text >> column;
      }
      EXPECT_EQ(std::stod(columns[0]), lateral);
      EXPECT_EQ(std::stod(columns[1]), yaw);
      EXPECT_EQ(table[at], alone.number(results[0]));
      EXPECT_EQ(std::stod(columns[2]), table[at]);
      EXPECT_EQ(table[at + 1], alone.number(results[1]));
      EXPECT_TRUE(std::isnan(table[at + 2]));
      EXPECT_EQ(columns[4], "nan");
      at += 3;
    }
  }
  std::remove(path.c_str());
  const auto on_one_thread =
      scene.tabulate({{"pose.lateral", laterals}, {"pose.yaw", yaws}}, results, 1);
  for (std::size_t i = 0; i < table.size(); i += i % 3 == 1 ? 2 : 1) { // without the not-a-numbers
    EXPECT_EQ(on_one_thread[i], table[i]) << i;
  }
}

TEST(Tables, AreRefusedBeforeTheFirstSolution) {
  Scene scene;
  const auto text_of = [&scene](const char* key, double value, const char* result) {
    try {
      scene.tabulate({{key, {value}}}, {result});
    } catch (const wrcontact::Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(text_of("pose.lateral", 2e4, "left.pmax"),
            "pose.lateral = 20000: must be between -1e4 and 1e4 mm");
  EXPECT_NE(text_of("pose.sideways", 0.0, "left.pmax").find("pose.sideways"), std::string::npos);
  EXPECT_EQ(text_of("pose.lateral", 0.0, "left.pmux"),
            "results: there is no result \"left.pmux\"; nearest: left.pmax");
  EXPECT_EQ(text_of("pose.lateral", 0.0, ""), "results: at least one name is needed");
  // Beside the rail there is no contact, which is no failure of the table.
  EXPECT_TRUE(std::isnan(scene.tabulate({{"track.gauge", {600}}}, {"left.pmax"}).at(0)));
}

TEST(Tables, ReportTheCauseIfASolutionIsRefused) {
  Scene scene;
  scene.set("pose.roll", 0.0);
  try {
    scene.tabulate({{"pose.vertical", {459.9, 380.0}}}, {"left.pmax"}, 2);
    FAIL() << "accepted";
  } catch (const wrcontact::Error& error) {
    EXPECT_STREQ(error.what(), "pose.vertical = 380: wheel and rail would overlap by 79.82 mm or "
                               "more; the overlap must be less than 50 mm");
  }
}

} // namespace
} // namespace vehicle_test
