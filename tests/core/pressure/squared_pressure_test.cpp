#include "pressure/squared_pressure.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "pressure/constants.hpp"

namespace wrc::test::squared_pressure_test {
namespace {

/// A row with the square of a pressure, which falls to 0 at `edge` steps, seen in three equal rows.
std::vector<double> strip(double edge, std::size_t columns) {
  std::vector<double> pressure;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double square = edge - static_cast<double>(column);
      pressure.push_back(square > 0.0 ? std::sqrt(square) : 0.0);
    }
  }
  return pressure;
}

TEST(SquaredPressure, ContinuesLinearlyBeyondASmoothEdge) {
  const LevelSize size{3, 8};
  std::vector<double> squares;
  square_and_continue(size, strip(4.25, 8), squares);
  ASSERT_EQ(squares.size(), size.count());
  for (std::size_t column = 0; column < 5; ++column) {
    EXPECT_NEAR(squares[8 + column], 4.25 - static_cast<double>(column), 1e-14) << column;
  }
  // One element beyond contact, in the mean over the directions, and nothing farther out.
  EXPECT_LT(squares[8 + 5], 0.0);
  EXPECT_EQ(squares[8 + 6], 0.0);
}

TEST(SquaredPressure, TheEdgeOfALoneElementIsHalfWayOut) {
  const LevelSize size{3, 3};
  const std::vector<double> pressure{0, 0, 0, 0, 3, 0, 0, 0, 0};
  std::vector<double> squares;
  square_and_continue(size, pressure, squares);
  EXPECT_EQ(squares[4], 9.0);
  EXPECT_EQ(squares[5], -9.0);
  EXPECT_EQ(edge_square(size, pressure, 1.0, 1, 2), -9.0);
  EXPECT_EQ(edge_square(size, pressure, 2.0, 0, 0), -36.0);
}

TEST(SquaredPressure, EdgesStayBetweenTheCentres) {
  // Two equal pressures: the linear continuation alone would lie beyond the next centre.
  const LevelSize size{1, 4};
  const std::vector<double> even{2, 2, 0, 0};
  EXPECT_EQ(edge_square(size, even, 1.0, 0, 2), -4.0);
  // far = 2 near: the linear continuation is 0, the edge at the centre itself.
  const std::vector<double> steep{std::sqrt(2.0), 1, 0, 0};
  EXPECT_NEAR(edge_square(size, steep, 1.0, 0, 2), 0.0, 1e-15);
  EXPECT_LE(edge_square(size, std::vector<double>{3, 1, 0, 0}, 1.0, 0, 2), 0.0);
}

TEST(SquaredPressure, EdgesAreAtTheRootOfTheParabola) {
  // p^2 = 1 - (x/a)^2 at whole x: a line from the last pressure to the value beyond
  // crosses 0 a little farther out than at a.
  const LevelSize size{1, 7};
  for (const double semi_axis : {3.2, 3.5, 3.8}) {
    std::vector<double> pressure;
    for (int x = 0; x < 7; ++x) {
      pressure.push_back(std::sqrt(std::max(0.0, 1.0 - x * x / (semi_axis * semi_axis))));
    }
    const double near = pressure[3] * pressure[3];
    const double edge = 3.0 + near / (near - edge_square(size, pressure, 1.0, 0, 4));
    EXPECT_NEAR(edge, semi_axis + edge_beyond_pressures, 0.005) << semi_axis;
  }
}

} // namespace
} // namespace wrc::test::squared_pressure_test
