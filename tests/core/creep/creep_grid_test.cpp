// Elements of the tangential problem: how many a contact of a given shape has, and where they lie.
#include "creep/creep_grid.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "accuracy/constants.hpp"
#include "creep/constants.hpp"
#include "patches/plane_area.hpp"

namespace wrc::test::creep_grid_test {
namespace {

constexpr double accuracy = 1e-2;
/// Elements along a contact as long as wide, by the law.
const double wanted = std::sqrt(creep_error_of_one_column / (share_of_creep_columns * accuracy));

/// Hertz's pressures on ellipses, the largest of 1000 MPa on the first.
struct Ellipse {
  double x, y;
  double a, b;
  double height = 1.0;
  double skew = 0.0; ///< of x with y
};

/// Of the root of 1 - u^2, from -1.
double integral(double u) {
  const double inside = std::clamp(u, -1.0, 1.0);
  return 0.5 * (inside * std::sqrt(1.0 - inside * inside) + std::asin(inside));
}

/// Means along the elements, as a solution has them: rows have the forces that they should.
struct Pressures {
  Grid grid = grid_over({-10.0, 10.0, -10.0, 10.0}, 400, 200);
  std::vector<double> values;

  explicit Pressures(std::initializer_list<Ellipse> ellipses) : values(grid.element_count()) {
    for (std::size_t element = 0; element < values.size(); ++element) {
      const double x = grid.longitudinal(element % grid.longitudinal_count);
      const double y = grid.lateral(element / grid.longitudinal_count);
      for (const Ellipse& one : ellipses) {
        const double v = (y - one.y) / one.b;
        const double square = std::max(1.0 - v * v, 1e-12);
        const double half = one.a * std::sqrt(square);
        const double from_middle = x - one.x - one.skew * (y - one.y);
        const double mean = square * one.a / grid.longitudinal_step *
                            (integral((from_middle + 0.5 * grid.longitudinal_step) / half) -
                             integral((from_middle - 0.5 * grid.longitudinal_step) / half));
        values[element] += mean > 1e-9 ? 1e3 * one.height * mean : 0.0;
      }
    }
  }
};

CreepGrid grid_of(const Pressures& pressures, double of_forces = accuracy, double bend = 0.0) {
  const SmoothPressure smooth(pressures.grid, pressures.values);
  return creep_grid({pressures.grid, pressures.values, smooth, bend}, of_forces, 1e9);
}

void expect_counts(const CreepGrid& found, double rows, double columns) {
  // Even numbers. An ellipse's scale by differences over an eighth of it exceeds its width by 12 %,
  // which takes 6 % of the columns.
  EXPECT_EQ(found.grid.lateral_count % 2, 0u);
  EXPECT_EQ(found.grid.longitudinal_count % 2, 0u);
  EXPECT_NEAR(static_cast<double>(found.grid.lateral_count), rows + 1.0, 1.0 + 0.12 * rows);
  EXPECT_NEAR(static_cast<double>(found.grid.longitudinal_count), columns + 1.0,
              1.0 + 0.06 * columns);
}

/// The law of their number holds for ellipses: what it says stays.
TEST(CreepGrid, BentGapsHaveMoreColumns) {
  const Pressures pressures{{1.0, -2.0, 4.0, 4.0}};
  const CreepGrid found = grid_of(pressures, accuracy, 1.0);
  expect_counts(found, creep_rows_by_columns * wanted, bent_creep_columns * wanted);
  EXPECT_NEAR(found.columns, grid_of(pressures).columns, 1e-9);
}

TEST(CreepGrid, ReachesFromEdgeToEdgeWithTheElementsOfTheLaw) {
  const CreepGrid found = grid_of(Pressures{{1.0, -2.0, 4.0, 4.0}});
  expect_counts(found, creep_rows_by_columns * wanted, wanted);
  EXPECT_NEAR(found.columns, wanted, 0.05 * wanted);
  const Grid& grid = found.grid;
  EXPECT_NEAR(grid.longitudinal_first - 0.5 * grid.longitudinal_step, -3.0, 0.02);
  EXPECT_NEAR(grid.longitudinal(grid.longitudinal_count - 1) + 0.5 * grid.longitudinal_step, 5.0,
              0.02);
  EXPECT_NEAR(grid.lateral_first - 0.5 * grid.lateral_step, -6.0, 0.05);
  const CreepGrid finer = grid_of(Pressures{{1.0, -2.0, 4.0, 4.0}}, 0.25 * accuracy);
  EXPECT_NEAR(finer.columns, 2.0 * found.columns, 1e-9);
}

/// By the power of length over width.
TEST(CreepGrid, LongContactsHaveMoreColumnsAndTheSameRows) {
  expect_counts(grid_of(Pressures{{0.0, 0.0, 8.0, 0.5}}), creep_rows_by_columns * wanted,
                std::pow(16.0, columns_by_sides_exponent) * wanted);
  expect_counts(grid_of(Pressures{{0.0, 0.0, 4.0, 3.5}}), creep_rows_by_columns * wanted,
                std::pow(8.0 / 7.0, columns_by_sides_exponent) * wanted);
}

/// Two alike have four times the variation over the square of the width, of which differences over
/// an eighth of it see half; a third one between them, five times as high and half as wide, takes
/// more rows again.
TEST(CreepGrid, CrestsHaveMoreRows) {
  expect_counts(grid_of(Pressures{{0.0, -4.0, 4.0, 4.0}, {0.0, 4.0, 4.0, 4.0}}),
                std::sqrt(2.0) * creep_rows_by_columns * wanted, wanted);
  const CreepGrid crest =
      grid_of(Pressures{{0.0, -4.0, 4.0, 4.0}, {0.0, 4.0, 4.0, 4.0}, {0.0, 0.0, 4.0, 2.0, 5.0}});
  EXPECT_GE(crest.grid.lateral_count, 1.9 * creep_rows_by_columns * wanted);
}

/// Its longest row is 8 mm, its rectangle 8 sqrt(2) mm long, and its longest column 8/sqrt(2) mm.
TEST(CreepGrid, CountsAlongTheLongestLines) {
  expect_counts(grid_of(Pressures{{0.0, 0.0, 4.0, 4.0, 1.0, 1.0}}),
                std::sqrt(2.0) * creep_rows_by_columns * wanted,
                std::sqrt(2.0) * std::pow(std::sqrt(2.0), columns_by_sides_exponent) * wanted);
}

TEST(CreepGrid, AreBounded) {
  const CreepGrid found = grid_of(Pressures{{0.0, 0.0, 4.0, 4.0}}, 1e-9);
  expect_counts(found, 2.0 * max_creep_columns, max_creep_columns);
  // By the ellipse's scale, 12 % more than its width, it is shorter than it is wide.
  EXPECT_NEAR(found.columns, max_creep_columns * std::pow(1.12, columns_by_sides_exponent),
              0.05 * max_creep_columns);
}

TEST(CreepGrid, WithoutContactIsThatOfThePressures) {
  const Pressures none{};
  EXPECT_EQ(grid_of(none).grid.element_count(), none.grid.element_count());
}

} // namespace
} // namespace wrc::test::creep_grid_test
