// Results over a grid of keys: the order of cells, cells without contact, and the file.
#include "scene/table.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "base/file.hpp"
#include "keys/scene_keys.hpp"
#include "support/errors.hpp"

namespace wrc::test::table_test {
namespace {

constexpr std::array<std::int64_t, 2> counts{3, 2};
constexpr std::array values{-2.0, 0.0, 4.0, 5e4, 9e4};

Scene coarse_scene() {
  Scene scene;
  scene.side = SideChoice::left;
  scene.accuracy = 1e-2;
  return scene;
}

TEST(TableGrid, CellsAreCountedWithTheFirstKeyFastest) {
  const TableGrid grid(coarse_scene(), "pose.lateral load.both", values.data(), counts.data(),
                       "left.normal_force left.pmax");
  ASSERT_EQ(grid.cell_count(), 6U);
  ASSERT_EQ(grid.result_count(), 2U);
  SceneSolver solver;
  for (const std::size_t cell : {0U, 2U, 4U}) {
    std::array<double, 2> results{};
    grid.solve_cell(cell, solver, results.data());
    Scene scene = coarse_scene();
    set_number(scene, "pose.lateral", values[cell % 3]);
    set_number(scene, "load.both", values[3 + cell / 3]);
    const SceneResult expected = solve_scene(scene);
    EXPECT_EQ(results[0], expected.left->normal_force);
    EXPECT_EQ(results[1], expected.left->pmax);
  }
}

TEST(TableGrid, CellsWithoutContactAreNotNumbers) {
  const std::array<std::int64_t, 1> one{1};
  const std::array far{100.0}; // beside the rail
  const TableGrid grid(coarse_scene(), "pose.lateral", far.data(), one.data(), "left.pmax");
  SceneSolver solver;
  double result = 0.0;
  grid.solve_cell(0, solver, &result);
  EXPECT_TRUE(std::isnan(result));
}

TEST(TableGrid, AnImpossibleSceneIsRefusedAtOnce) {
  const auto make = [](const char* keys, const char* results) {
    const TableGrid grid(coarse_scene(), keys, values.data(), counts.data(), results);
  };
  expect_error(
      ErrorCode::unknown_name, [&] { make("pose.lateral load.both", "left.nothing"); },
      "left.nothing");
  expect_error(
      ErrorCode::unknown_name, [&] { make("pose.nothing load.both", "left.pmax"); },
      "pose.nothing");
  expect_error(
      ErrorCode::invalid_argument, [&] { make("pose.lateral pose.lateral", "left.pmax"); },
      "twice");
  expect_error(
      ErrorCode::invalid_argument, [&] { make("pose.lateral", ""); }, "results");
}

TEST(TableGrid, TheFileHoldsKeysAndResultsRowByRow) {
  const TableGrid grid(coarse_scene(), "pose.lateral load.both", values.data(), counts.data(),
                       "left.pmax");
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) /
                                     ("wrcontact_table_test_" + std::to_string(getpid()));
  const std::array numbers{1.5, 2.5, 3.5, 4.5, 5.5, std::nan("")};
  grid.write(path, "1.2.3", numbers);
  const std::string text = read_file(path, 100000);
  std::filesystem::remove(path);
  EXPECT_NE(text.find("wrcontact 1.2.3"), std::string::npos);
  EXPECT_NE(text.find("# pose.lateral load.both left.pmax\n-2 50000 1.5\n0 50000 2.5\n"
                      "4 50000 3.5\n-2 90000 4.5\n"),
            std::string::npos)
      << text;
  EXPECT_TRUE(text.ends_with("4 90000 nan\n")) << text;
}

} // namespace
} // namespace wrc::test::table_test
