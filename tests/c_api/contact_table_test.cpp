/// Tables of contact forces through the interface.
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "wrcontact.hpp"

namespace contact_table_test {
namespace {

wrcontact::Scene scene_of_table() {
  wrcontact::Scene scene;
  scene.set("solve.accuracy", 0.01);
  scene.set("solve.accuracy_of", "forces");
  return scene;
}

/// In a second.
wrc_table_options small() {
  wrc_table_options options{};
  options.lateral = 1.0;
  options.roll = 0.003;
  options.yaw = 0.01;
  options.load = 120000.0;
  options.fineness = 0.2;
  options.threads = 2;
  return options;
}

wrcontact::Table& table() {
  static wrcontact::Table made = [] {
    wrcontact::Table fresh;
    wrcontact::Scene scene = scene_of_table();
    fresh.build(scene, small());
    return fresh;
  }();
  return made;
}

std::array<double, 6> position_under_load() {
  wrcontact::Scene scene = scene_of_table();
  wrcontact::Solver solver;
  std::array<double, 6> position{0.0, 0.2, 0.0, 0.0, 0.0, 0.002};
  wrcontact::Step step;
  wrcontact::StepArguments arguments;
  const std::array<double, 6> velocity{2e4, 0.0, 0.0, 0.0, 43.5, 0.0};
  EXPECT_TRUE(solver.equilibrium(scene, WRC_LOAD_OF_AXLE, {1.2e5, 0.0}, position, step, arguments,
                                 &velocity));
  return position;
}

TEST(ContactTable, GivesTheForcesOfAStepAndItsError) {
  const std::array<double, 6> position = position_under_load();
  const std::array<double, 6> velocity{2e4, 10.0, 0.0, 0.0, 43.5, 0.0};
  wrcontact::Scene scene = scene_of_table();
  wrcontact::Solver solver;
  wrcontact::Step exact;
  wrcontact::StepArguments arguments;
  arguments.derivatives = true;
  arguments.friction = {0.35, 0.35};
  ASSERT_TRUE(solver.step(scene, position, velocity, exact, arguments));
  wrcontact::Step found;
  wrcontact::StepArguments for_table = arguments;
  const std::array<double, 2> error = table().step(position, velocity, found, for_table);
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    EXPECT_GT(error[wheel], 0.0);
    EXPECT_LT(error[wheel], 0.1);
    EXPECT_EQ(found.states[wheel], 0);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(found.force[6 * wheel + i], exact.force[6 * wheel + i], error[wheel] * 6e4);
    }
    // Fz by z
    EXPECT_NEAR(found.by_position[36 * wheel + 14], exact.by_position[36 * wheel + 14],
                0.1 * std::abs(exact.by_position[36 * wheel + 14]));
  }
}

TEST(ContactTable, HasOutputsAndLikelyErrors) {
  std::array<double, 6> position = position_under_load();
  const std::array<double, 6> velocity{2e4, 10.0, 0.0, 0.0, 43.5, 0.0};
  wrcontact::Step step;
  wrcontact::StepArguments arguments;
  wrcontact::TableOutputs outputs;
  auto error = table().step(position, velocity, step, arguments, nullptr, nullptr, &outputs);
  EXPECT_EQ(std::string(wrc_table_output_name(0)), "wear_number");
  EXPECT_EQ(wrc_table_output_name(WRC_TABLE_OUTPUTS), nullptr);
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    EXPECT_GT(outputs.likely_errors[2 * wheel], 0.0);
    EXPECT_LE(outputs.likely_errors[2 * wheel], error[wheel]);
    EXPECT_GT(outputs.outputs[WRC_TABLE_OUTPUTS * wheel], 0.0);
    const double load = step.force[6 * wheel + 2]; // all of it on the tread
    EXPECT_NEAR(outputs.outputs[WRC_TABLE_OUTPUTS * wheel + 5], load, 0.01 * load);
  }
  error = table().equilibrium(WRC_LOADS_OF_WHEELS, {5e4, 7e4}, position, velocity, step, arguments,
                              &outputs);
  EXPECT_NEAR(step.force[2], 5e4, 0.1);
  EXPECT_NEAR(step.force[8], 7e4, 0.1);
  EXPECT_GT(error[0], 0.0);
  wrcontact::Scene scene = scene_of_table();
  wrcontact::Solver solver;
  wrc_step_arguments given{};
  given.struct_size = sizeof given;
  given.outputs = outputs.outputs.data();
  EXPECT_EQ(wrc_solver_step_with(solver.handle(), scene.handle(), position.data(), velocity.data(),
                                 &given, step.force.data()),
            WRC_INVALID_ARGUMENT);
}

TEST(ContactTable, OutsideIsRefusedOrSolved) {
  std::array<double, 6> position = position_under_load();
  position[5] = 0.02;
  const std::array<double, 6> velocity{2e4, 0.0, 0.0, 0.0, 43.5, 0.0};
  wrcontact::Step step;
  step.force[0] = -1.0;
  wrcontact::StepArguments arguments;
  try {
    table().step(position, velocity, step, arguments);
    FAIL();
  } catch (const wrcontact::Error& error) {
    EXPECT_EQ(error.status(), WRC_INVALID_ARGUMENT);
    EXPECT_NE(std::string(error.what()).find("left wheel: yaw against the rail = 0.02"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(step.force[0], -1.0);
  wrcontact::Scene scene = scene_of_table();
  wrcontact::Solver solver;
  const auto error = table().step(position, velocity, step, arguments, &solver, &scene);
  EXPECT_EQ(error[0], 0.0);
  EXPECT_EQ(step.states[0] & WRC_SOLVED_EXACTLY, WRC_SOLVED_EXACTLY);
  wrcontact::Step exact;
  ASSERT_TRUE(solver.step(scene, position, velocity, exact));
  EXPECT_EQ(step.force, exact.force);
  scene.set("track.gauge", 1440.0);
  EXPECT_THROW(table().step(position, velocity, step, arguments, &solver, &scene),
               wrcontact::Error);
  EXPECT_THROW(table().step(position, velocity, step, arguments, &solver, nullptr),
               wrcontact::Error);
}

TEST(ContactTable, ComesBackFromItsFile) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("wrcontact_contact_table_test_" + std::to_string(getpid()) + ".table");
  table().save(path.string());
  wrcontact::Table read;
  EXPECT_THROW(read.facts(), wrcontact::Error);
  read.load(path.string());
  const wrc_table_facts facts = read.facts();
  EXPECT_EQ(facts.lateral, 1.0);
  EXPECT_EQ(facts.worst_error, table().facts().worst_error);
  EXPECT_GT(facts.states, 100.0);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  try {
    read.load(path.string());
    FAIL();
  } catch (const wrcontact::Error& error) {
    EXPECT_EQ(error.status(), WRC_FILE_MALFORMED);
  }
  EXPECT_EQ(read.facts().lateral, 1.0); // the one it had
  std::filesystem::remove(path);
  EXPECT_THROW(read.load(path.string()), wrcontact::Error);
}

TEST(ContactTable, SaysWhatItIsOf) {
  const std::vector<std::string> lines = table().lines();
  ASSERT_GT(lines.size(), 10U);
  EXPECT_EQ(lines[0], "wheelset.wheel = S1002");
  EXPECT_EQ(lines[1], "track.rail = 60E1");
  EXPECT_TRUE(wrcontact::Table().lines().empty());
  EXPECT_EQ(wrc_table_line(table().handle(), -1), nullptr);
  EXPECT_EQ(table().share().lines(), lines);
}

TEST(ContactTable, ThreadsShareIt) {
  wrcontact::Table other = table().share();
  const std::array<double, 6> position = position_under_load();
  const std::array<double, 6> velocity{2e4, 0.0, 0.0, 0.0, 43.5, 0.0};
  wrcontact::Step one;
  wrcontact::Step two;
  wrcontact::StepArguments arguments;
  table().step(position, velocity, one, arguments);
  other.step(position, velocity, two, arguments);
  EXPECT_EQ(one.force, two.force);
  EXPECT_EQ(wrc_table_share(table().handle(), table().handle()), WRC_OK); // it has it already
  EXPECT_STREQ(wrc_table_error(table().handle()), "");
}

TEST(ContactTable, StopsWhereItsProgressReturnsFalse) {
  wrcontact::Table stopped;
  wrcontact::Scene scene = scene_of_table();
  double last = 0.0;
  try {
    stopped.build(scene, small(), [&last](double fraction) {
      last = fraction;
      return fraction < 0.3;
    });
    FAIL();
  } catch (const wrcontact::Error& error) {
    EXPECT_EQ(error.status(), WRC_NO_RESULT);
  }
  EXPECT_GE(last, 0.3);
  EXPECT_LT(last, 0.9);
}

TEST(ContactTable, RefusesOptionsOutOfRange) {
  wrcontact::Table none;
  wrcontact::Scene scene = scene_of_table();
  const auto refuses = [&](auto change, const char* text) {
    wrc_table_options options = small();
    change(options);
    try {
      none.build(scene, options);
      FAIL() << text;
    } catch (const wrcontact::Error& error) {
      EXPECT_EQ(error.status(), WRC_INVALID_ARGUMENT);
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  refuses([](wrc_table_options& o) { o.fineness = 100.0; }, "fineness = 100");
  refuses([](wrc_table_options& o) { o.threads = -3; }, "threads = -3");
  refuses([](wrc_table_options& o) { o.lateral = -1.0; }, "lateral = -1");
  refuses([](wrc_table_options& o) { o.yaw = std::nan(""); }, "yaw = nan");
  wrc_table_options unsized{};
  EXPECT_EQ(wrc_table_build(none.handle(), scene.handle(), &unsized, nullptr, nullptr),
            WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_table_build(none.handle(), nullptr, nullptr, nullptr, nullptr),
            WRC_INVALID_ARGUMENT);
  wrc_table_facts facts{};
  EXPECT_EQ(wrc_table_get_facts(table().handle(), &facts), WRC_INVALID_ARGUMENT);
}

} // namespace
} // namespace contact_table_test
