// What a sum over rows leaves in the place of a force, by how its edges lie in them.
#include "pressure/edge_rows.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::edge_rows_test {
namespace {

std::vector<ContactRow> rows_of(const std::vector<double>& forces) {
  std::vector<ContactRow> rows;
  for (const double force : forces) {
    rows.push_back({force, 0.0, 0.0});
  }
  return rows;
}

/// Forces per width of a triangle from 0 to 20 with its top at `top`, in rows of height 1.
std::vector<ContactRow> triangle(double top, double first) {
  std::vector<double> forces;
  for (double y = first; y < 21.0; y += 1.0) {
    forces.push_back(std::max(0.0, y < top ? y / top : (20.0 - y) / (20.0 - top)));
  }
  return rows_of(forces);
}

double middle_of(const std::vector<ContactRow>& rows, double first) {
  double force = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    force += rows[i].force;
    moment += rows[i].force * (first + static_cast<double>(i));
  }
  return moment / force;
}

TEST(EdgeRows, PredictTheErrorOfASum) {
  constexpr double top = 10.0;                       // a row there leaves nothing of the moment
  const double axis = std::sqrt(5.0 * 400.0 / 24.0); // of the triangle's variance
  for (const double first : {-0.9, -0.7, -0.5, -0.3, -0.05}) {
    const std::vector<ContactRow> rows = triangle(top, first);
    const double error = std::abs(middle_of(rows, first) - top) / axis;
    EXPECT_NEAR(edge_error(rows), error, 2e-4) << first;
  }
}

TEST(EdgeRows, SteeperOnOneSideLeaveAMoment) {
  EXPECT_NEAR(edge_error(triangle(10.0, -0.5)), 0.0, 1e-12);
  EXPECT_GT(edge_error(triangle(3.0, -0.5)), 5e-4);
  EXPECT_NEAR(edge_error(triangle(3.0, -0.5)), edge_error(triangle(17.0, -0.5)), 1e-12);
}

/// A row that enters where the force per width ends.
TEST(EdgeRows, AreContinuousWhereARowEnters) {
  EXPECT_NEAR(edge_error(triangle(3.0, 1e-9)), edge_error(triangle(3.0, -1e-9)), 1e-8);
  // A last row that bears more than the next one: the edge is taken to be one row away.
  EXPECT_NEAR(edge_error(rows_of({0.0, 5.0, 4.0, 3.0, 2.0, 1.0})),
              edge_error(rows_of({1e-9, 5.0, 4.0, 3.0, 2.0, 1.0})), 1e-8);
}

TEST(EdgeRows, OfASingleRowHaveNone) {
  EXPECT_EQ(edge_error(rows_of({0.0, 2.0, 0.0})), 0.0);
}

} // namespace
} // namespace wrc::test::edge_rows_test
