/// Area of contact against ellipses, and on fields where it can be told by hand.
#include "pressure/contact_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "extent.hpp"
#include "mechanics/normal_solver.hpp"
#include "models/hertz.hpp"
#include "pressure/constants.hpp"
#include "support/patch_problem.hpp"

namespace wrc::test::contact_area_test {
namespace {

/// Sums of some thousand numbers of the order of one.
constexpr double rounding = 1e-12;
constexpr double modulus = 1e5;

/// An ellipse turned and shifted against a grid of square elements around it.
struct Case {
  Grid grid;
  HertzContact contact;
  double curvature_x = 1.0 / 300.0;
  double curvature_y = 1.0 / 300.0;
  double angle = 0.0;

  [[nodiscard]] double true_area() const {
    return std::numbers::pi * contact.semi_axis_longitudinal * contact.semi_axis_lateral;
  }
  template <typename Field> [[nodiscard]] std::vector<double> sample(const Field& field) const {
    std::vector<double> values;
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
        const double x = grid.longitudinal(column);
        const double y = grid.lateral(row);
        values.push_back(field(std::cos(angle) * x + std::sin(angle) * y,
                               std::cos(angle) * y - std::sin(angle) * x));
      }
    }
    return values;
  }
  [[nodiscard]] std::vector<double> sampled() const {
    return sample([&](double x, double y) { return hertz_pressure(contact, x, y); });
  }
  [[nodiscard]] std::vector<double> solved(NormalSolver& solver, Elements elements) const {
    const std::vector<double> gap = sample(
        [&](double x, double y) { return 0.5 * (curvature_x * x * x + curvature_y * y * y); });
    PatchProblem problem(grid, gap, modulus);
    problem.load = contact.normal_force;
    problem.tolerance = 1e-5;
    problem.elements = elements;
    return PatchSolution(solver.solve(problem)).pressure;
  }
};

/// `across` elements across the shorter axis; shifts are in elements.
Case make_case(double axes, double across, double angle, double shift_x, double shift_y) {
  Case result;
  const HertzBodies bodies = equivalent_hertz_bodies(axes, 1.0, modulus, 100.0);
  result.curvature_x = 1.0 / bodies.longitudinal_radius;
  result.curvature_y = 1.0 / bodies.lateral_radius;
  result.contact = solve_hertz(result.curvature_x, result.curvature_y, modulus, 100.0);
  result.angle = angle;
  const double step = 2.0 * std::min(axes, 1.0) / across;
  const double reach_x = std::hypot(axes * std::cos(angle), std::sin(angle));
  const double reach_y = std::hypot(axes * std::sin(angle), std::cos(angle));
  const auto columns = static_cast<std::size_t>(2.0 * reach_x / step) + 6;
  const auto rows = static_cast<std::size_t>(2.0 * reach_y / step) + 6;
  result.grid = {rows,
                 columns,
                 step,
                 step,
                 step * (shift_y - 0.5 * static_cast<double>(rows)),
                 step * (shift_x - 0.5 * static_cast<double>(columns))};
  return result;
}

double counted_area(const Grid& grid, const std::vector<double>& pressure) {
  return grid.element_area() * static_cast<double>(std::count_if(pressure.begin(), pressure.end(),
                                                                 [](double p) { return p > 0.0; }));
}

struct Errors {
  double mean_square = 0.0;
  double largest = 0.0;
  double mean_square_counted = 0.0;
};

/// Relative errors over random orientations and shifts, times the square of `across`.
template <typename Pressures>
Errors measure_errors(double across, int cases, const Pressures& pressures) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Errors errors;
  int count = 0;
  for (const double axes : {0.2, 0.5, 1.0, 2.0, 5.0}) {
    for (int index = 0; index < cases; ++index) {
      const double angle = index % 2 == 0 ? 0.0 : std::numbers::pi * uniform(generator);
      const double shift = uniform(generator);
      const Case one = make_case(axes, across * (0.95 + 0.1 * uniform(generator)), angle, shift,
                                 uniform(generator));
      const std::vector<double> pressure = pressures(one);
      const double factor = across * across / one.true_area();
      const double error = factor * (contact_area(one.grid, pressure) - one.true_area());
      const double counted = factor * (counted_area(one.grid, pressure) - one.true_area());
      errors.mean_square += error * error;
      errors.mean_square_counted += counted * counted;
      errors.largest = std::max(errors.largest, std::abs(error));
      ++count;
    }
  }
  errors.mean_square = std::sqrt(errors.mean_square / count);
  errors.mean_square_counted = std::sqrt(errors.mean_square_counted / count);
  return errors;
}

TEST(ContactArea, SampledEllipsesAreTooLargeByTheShiftOfTheEdge) {
  for (const double across : {6.0, 12.0, 24.0, 48.0, 96.0, 192.0}) {
    const Errors errors = measure_errors(across, 12, [](const Case& one) { return one.sampled(); });
    // Solved pressures are too small at the edge, these are not.
    const double shift = edge_beyond_pressures * across;
    EXPECT_LT(errors.mean_square, 0.6 + 3.0 * shift) << across;
    EXPECT_LT(errors.largest, 1.5 + 4.0 * shift) << across;
  }
}

TEST(ContactArea, SolvedEllipsesAreBetterThanCounted) {
  NormalSolver solver;
  for (const double across : some_of({3.0, 6.0, 10.0, 16.0, 24.0, 48.0, 96.0}, 4)) {
    // As documented: order two down to a remainder of the first.
    for (const auto& [elements, second, first] :
         {std::tuple{Elements::constant, 0.8, 0.03}, {Elements::smooth, 0.5, 0.013}}) {
      const Errors errors = measure_errors(
          across, 10, [&, of = elements](const Case& one) { return one.solved(solver, of); });
      EXPECT_LT(errors.mean_square, second + first * across) << across;
      EXPECT_LT(errors.mean_square, 0.6 * errors.mean_square_counted) << across;
    }
  }
}

TEST(ContactArea, ChangesLittleWhenTheContactMoves) {
  // Counted areas change by whole elements.
  const double limits[] = {0.5, 0.3, 0.2};
  int index = 0;
  for (const double across : {6.0, 12.0, 24.0}) {
    double before = 0.0;
    double largest = 0.0;
    for (int step = 0; step <= 400; ++step) {
      const double shift = step / 400.0;
      const Case one = make_case(1.7, across, 0.3, 0.6180339 * shift, shift);
      const double area = contact_area(one.grid, one.sampled()) / one.grid.element_area();
      largest = step > 0 ? std::max(largest, std::abs(area - before)) : 0.0;
      before = area;
    }
    EXPECT_LT(largest, limits[index++]) << across;
  }
}

TEST(ContactArea, StraightEdgesAreShiftedByTheirShareOfAnElement) {
  // p^2 linear along x, the same in all rows; the grid's edges cut it off. No farther than to the
  // centre of the next element.
  const Grid grid{4, 9, 0.5, 2.0, 0.0, 0.0};
  for (const double edge : {0.3, 2.5, 3.01, 3.5, 3.99, 7.75}) {
    std::vector<double> pressure;
    for (std::size_t index = 0; index < grid.element_count(); ++index) {
      pressure.push_back(std::sqrt(std::max(0.0, edge - static_cast<double>(index % 9))));
    }
    // One element alone has nothing to take the slope from: half-way.
    const double shift = std::min(edge_beyond_pressures, std::ceil(edge) - edge);
    const double length = edge > 1.0 ? edge + shift + 0.5 : 1.0;
    EXPECT_NEAR(contact_area(grid, pressure), length * 2.0 * 4.0 * 0.5, rounding * 10.0) << edge;
    // Turned by a right angle, and in one row or column.
    const Grid turned{9, 1, 2.0, 0.5, 0.0, 0.0};
    const Grid row{1, 9, 0.5, 2.0, 0.0, 0.0};
    pressure.resize(9);
    EXPECT_NEAR(contact_area(turned, pressure), length, rounding) << edge;
    EXPECT_NEAR(contact_area(row, pressure), length, rounding) << edge;
  }
}

TEST(ContactArea, EllipsesCutByTheGridKeepOrderTwo) {
  for (const double across : {8.0, 16.0, 32.0, 64.0}) {
    for (const double shift : {0.0, 0.3, 0.6, 0.9}) {
      const Case one = make_case(1.6, across, 0.0, shift, 1.0 - shift);
      const std::vector<double> pressure = one.sampled();
      // All rows from a third on.
      const std::size_t first = one.grid.lateral_count / 3;
      Grid grid = one.grid;
      grid.lateral_count -= first;
      grid.lateral_first = one.grid.lateral(first);
      const double cut =
          (grid.lateral_first - 0.5 * grid.lateral_step) / one.contact.semi_axis_lateral;
      const double expected =
          one.true_area() * (std::acos(cut) - cut * std::sqrt(1.0 - cut * cut)) / std::numbers::pi;
      const double area =
          contact_area(grid, std::span(pressure).subspan(first * grid.longitudinal_count));
      EXPECT_NEAR(area / expected, 1.0, 8.0 / (across * across)) << across << " " << shift;
    }
  }
}

TEST(ContactArea, EvenPressuresAndPunches) {
  const Grid grid{5, 7, 0.5, 2.0, 3.0, -4.0};
  // All of the grid, whatever the pressures.
  std::vector<double> pressure(35, 3.0);
  EXPECT_DOUBLE_EQ(contact_area(grid, pressure), 35.0);
  pressure[0] = 1e-3;
  EXPECT_DOUBLE_EQ(contact_area(grid, pressure), 35.0);
  for (const Grid& line : {Grid{1, 35, 0.5, 2.0, 0.0, 0.0}, Grid{35, 1, 0.5, 2.0, 0.0, 0.0}}) {
    EXPECT_DOUBLE_EQ(contact_area(line, pressure), 35.0);
  }
  const Grid single{1, 1, 0.5, 2.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(contact_area(single, std::vector<double>{2.0}), 1.0);
  // A flat punch of 30 x 20 elements, even or rising to its edge: corners are rounded.
  const Grid wide{40, 50, 1.0, 1.0, 0.0, 0.0};
  for (const double rise : {0.0, 0.5, 5.0}) {
    std::vector<double> punch(2000, 0.0);
    for (std::size_t row = 10; row < 30; ++row) {
      for (std::size_t column = 10; column < 40; ++column) {
        const bool rim = row == 10 || row == 29 || column == 10 || column == 39;
        punch[row * 50 + column] = rim ? 1.0 + rise : 1.0;
      }
    }
    const double area = contact_area(wide, punch);
    EXPECT_LE(area, 600.0 + rounding * 600.0);
    EXPECT_GT(area, 600.0 - 4.0 * 0.25);
  }
}

TEST(ContactArea, SingleElementsAndEdgesStayWithinHalfAnElement) {
  const Grid grid{5, 6, 0.5, 2.0, 0.0, 0.0};
  for (std::size_t index = 0; index < grid.element_count(); ++index) {
    std::vector<double> pressure(grid.element_count(), 0.0);
    pressure[index] = 1e-5;
    const double area = contact_area(grid, pressure);
    EXPECT_GE(area, 2.0 / 3.0 - rounding) << index;
    EXPECT_LE(area, 1.0 + rounding) << index;
  }
}

TEST(ContactArea, DoesNotDependOnUnitsOrSides) {
  const Case one = make_case(2.0, 9.3, 0.4, 0.2, 0.7);
  const std::vector<double> pressure = one.sampled();
  const double area = contact_area(one.grid, pressure);
  for (const double factor : {1e-100, 1e-3, 1e100}) {
    std::vector<double> other = pressure;
    for (double& value : other) {
      value *= factor;
    }
    EXPECT_NEAR(contact_area(one.grid, other), area, rounding * area);
  }
  std::vector<double> mirrored;
  std::vector<double> transposed;
  const std::size_t rows = one.grid.lateral_count;
  const std::size_t columns = one.grid.longitudinal_count;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto* values = pressure.data() + (rows - 1 - row) * columns;
    mirrored.insert(mirrored.end(), values, values + columns);
  }
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < rows; ++row) {
      transposed.push_back(pressure[row * columns + column]);
    }
  }
  Grid turned = one.grid;
  std::swap(turned.lateral_count, turned.longitudinal_count);
  EXPECT_NEAR(contact_area(one.grid, mirrored), area, rounding * area);
  EXPECT_NEAR(contact_area(turned, transposed), area, rounding * area);
}

TEST(ContactArea, OfTwoContactsIsTheirSum) {
  const Case one = make_case(1.5, 11.0, 0.0, 0.3, 0.1);
  const std::vector<double> pressure = one.sampled();
  const std::size_t columns = one.grid.longitudinal_count;
  Grid both = one.grid;
  both.longitudinal_count = 2 * columns;
  std::vector<double> twice;
  for (std::size_t row = 0; row < one.grid.lateral_count; ++row) {
    for (const double factor : {1.0, 3.0}) {
      for (std::size_t column = 0; column < columns; ++column) {
        twice.push_back(factor * pressure[row * columns + column]);
      }
    }
  }
  const double area = contact_area(one.grid, pressure);
  EXPECT_NEAR(contact_area(both, twice), 2.0 * area, rounding * area);
}

TEST(ContactArea, IsZeroWithoutPressure) {
  const Grid grid{3, 2, 1.0, 1.0, 0.0, 0.0};
  const std::vector<double> none(6, 0.0);
  EXPECT_EQ(contact_area(grid, none), 0.0);
  const std::vector<double> wrong(5, 0.0);
  EXPECT_THROW(contact_area(grid, wrong), Error);
}

} // namespace
} // namespace wrc::test::contact_area_test
