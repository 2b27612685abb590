// The problem without dimensions: units, weights, first pressures, and the box of penetration.
#include "mechanics/scaled_problem.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::scaled_problem_test {
namespace {

constexpr double modulus = 115384.6;

/// Two patches, of which the second is inclined, farther away, and on elements twice as long.
class ScaledProblemTest : public testing::Test {
protected:
  ScaledProblemTest() {
    for (std::size_t k = 0; k < 2; ++k) {
      const Grid& grid = grids_[k];
      for (std::size_t i = 0; i < grid.lateral_count; ++i) {
        for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
          const double y = grid.lateral(i);
          const double x = grid.longitudinal(j);
          distances_[k].push_back(1e-3 * (x * x + y * y) + offsets_[k]);
        }
      }
      patches_.push_back({grids_[k], distances_[k], cosines_[k]});
    }
    problem_.patches = patches_;
    problem_.combined_modulus = modulus;
  }

  static constexpr std::array<double, 2> cosines_{1.0, 0.8};
  static constexpr std::array<double, 2> offsets_{0.02, 0.05};
  std::array<Grid, 2> grids_{{{40, 50, 0.3, 0.25, -5.85, -6.125}, {24, 20, 0.4, 0.5, -4.6, -4.75}}};
  std::array<std::vector<double>, 2> distances_;
  std::vector<PatchGap> patches_;
  NormalProblem problem_;
  InfluenceCache cache_;
  ScaledProblem scaled_;
};

TEST_F(ScaledProblemTest, FirstTouchIsTheLeastVerticalDistance) {
  const auto least = [this](std::size_t k) {
    return *std::min_element(distances_[k].begin(), distances_[k].end()) / cosines_[k];
  };
  EXPECT_DOUBLE_EQ(ScaledProblem::first_touch(problem_), std::min(least(0), least(1)));
}

/// The sum of weighted pressures stands for the load in N, and distances for mm.
TEST_F(ScaledProblemTest, UnitsBelongTogether) {
  problem_.load = 60000.0;
  scaled_.set(problem_, cache_);
  double load = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Level& finest = scaled_.cascades[k].finest();
    const double force = cosines_[k] * grids_[k].element_area() * scaled_.pressure_scale;
    // One pressure of 1 everywhere: its vertical force over that of the first grid's unit.
    load += force * static_cast<double>(grids_[k].element_count());
    EXPECT_NEAR(finest.load_weight() / scaled_.cascades[0].finest().load_weight(),
                force / (cosines_[0] * grids_[0].element_area() * scaled_.pressure_scale), 1e-12);
    // u = K p in steps of this grid: p/(pi E*) times the step is its unit of length.
    const double unit =
        scaled_.pressure_scale / (std::numbers::pi * modulus) * grids_[k].longitudinal_step;
    EXPECT_NEAR(finest.distance[3] * unit,
                distances_[k][3] - ScaledProblem::first_touch(problem_) * cosines_[k],
                1e-12 * distances_[k][3]);
  }
  EXPECT_NEAR(load, 60000.0, 1e-8);
}

TEST_F(ScaledProblemTest, CoarserGridsKeepLoadAndExtent) {
  problem_.load = 60000.0;
  scaled_.set(problem_, cache_);
  const PatchCascade& cascade = scaled_.cascades[0];
  ASSERT_GT(cascade.level_count, 1U);
  for (std::size_t i = 1; i < cascade.level_count; ++i) {
    const Level& finer = cascade.levels[i - 1];
    const Level& level = cascade.levels[i];
    EXPECT_NEAR(level.load_weight(), 4.0 * finer.load_weight(), 1e-12);
    EXPECT_NEAR(level.grid.lateral_first - 0.5 * level.grid.lateral_step,
                finer.grid.lateral_first - 0.5 * finer.grid.lateral_step, 1e-12);
    EXPECT_NEAR(level.grid.longitudinal_first - 0.5 * level.grid.longitudinal_step,
                finer.grid.longitudinal_first - 0.5 * finer.grid.longitudinal_step, 1e-12);
  }
}

TEST_F(ScaledProblemTest, FirstPressuresCarryTheLoad) {
  problem_.load = 60000.0;
  scaled_.set(problem_, cache_);
  for (std::size_t index = 0; index < scaled_.level_count; ++index) {
    scaled_.draw_pressure(index);
    double load = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Level& level = scaled_.cascades[k].at(index);
      for (const double p : level.pressure) {
        EXPECT_GE(p, 0.0);
        load += level.load_weight() * p;
      }
    }
    EXPECT_NEAR(load, *scaled_.load, 1e-9 * *scaled_.load) << index;
  }
}

TEST_F(ScaledProblemTest, StartsFromPressuresOfAllPatchesOrOfNone) {
  problem_.load = 60000.0;
  std::array<std::vector<double>, 2> start{std::vector<double>(2000, 500.0),
                                           std::vector<double>(480, 250.0)};
  patches_[0].start = start[0];
  scaled_.set(problem_, cache_);
  EXPECT_FALSE(scaled_.take_start(problem_).has_value());
  patches_[1].start = start[1];
  scaled_.set(problem_, cache_);
  EXPECT_EQ(scaled_.take_start(problem_), 0U);
  EXPECT_NEAR(scaled_.cascades[0].finest().pressure[7] * scaled_.pressure_scale, 500.0, 1e-9);
  EXPECT_NEAR(scaled_.cascades[1].finest().pressure[7] * scaled_.pressure_scale, 250.0, 1e-9);
}

TEST_F(ScaledProblemTest, StartsOnAGridShortEnough) {
  grids_[0] = {250, 50, 0.05, 0.25, -6.225, -6.125}; // 125 x 25, then 63 x 13
  distances_[0].assign(grids_[0].element_count(), 0.02);
  distances_[0][0] = 0.01;
  std::array<std::vector<double>, 2> start{std::vector<double>(12500, 0.0),
                                           std::vector<double>(480, 250.0)};
  for (std::size_t i = 0; i < start[0].size(); ++i) {
    start[0][i] = static_cast<double>(i % 50);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    patches_[k] = {grids_[k], distances_[k], cosines_[k], start[k]};
  }
  problem_.load = 60000.0;
  scaled_.set(problem_, cache_);
  EXPECT_EQ(scaled_.take_start(problem_), 2U);
  const Level& level = scaled_.cascades[0].at(2);
  ASSERT_EQ(level.size.rows, 63U);
  ASSERT_EQ(level.size.columns, 13U);
  // Means of four columns.
  EXPECT_NEAR(level.pressure[3 * 13 + 5] * scaled_.pressure_scale, 21.5, 1e-9);
  // A short grid has no coarser ones.
  EXPECT_NEAR(scaled_.cascades[1].at(2).pressure[7] * scaled_.pressure_scale, 250.0, 1e-9);
}

TEST(PenetrationBox, ContainsAllOverlapAndAMargin) {
  Level level;
  level.size = {6, 8};
  level.shares.assign(48, 0.5);
  level.distance.assign(48, 10.0);
  level.distance[2 * 8 + 3] = 0.9; // below 0.5 times 2
  level.distance[3 * 8 + 6] = 0.1;
  level.distance[5 * 8 + 0] = 1.1; // above
  ElementBox box;
  ASSERT_TRUE(find_penetration_box(level, 2.0, 0, box));
  EXPECT_EQ(box.first_row, 2U);
  EXPECT_EQ(box.last_row, 3U);
  EXPECT_EQ(box.first_column, 3U);
  EXPECT_EQ(box.last_column, 6U);
  ASSERT_TRUE(find_penetration_box(level, 2.0, 2, box));
  EXPECT_EQ(box.first_row, 0U);
  EXPECT_EQ(box.last_row, 5U);
  EXPECT_EQ(box.first_column, 1U);
  EXPECT_EQ(box.last_column, 7U);
  EXPECT_FALSE(find_penetration_box(level, 0.1, 2, box));
  level.shares[5 * 8 + 0] = 0.6; // 1.1 is below 0.6 times 2
  ASSERT_TRUE(find_penetration_box(level, 2.0, 0, box));
  EXPECT_EQ(box.last_row, 5U);
  EXPECT_EQ(box.first_column, 0U);
}

} // namespace
} // namespace wrc::test::scaled_problem_test
