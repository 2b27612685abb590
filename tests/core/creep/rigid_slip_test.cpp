/// The slip of rows, creepages that fit it and what tractions on rows add up to, against sums of
/// their own.
#include "creep/rigid_slip.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::rigid_slip_test {
namespace {

constexpr Twist moving{1e-3, -2e-3, 4e-4, 3e-6, 2e-3, 1e-4};
constexpr double approach = 0.05;

/// Two lobes 8 mm apart, one of them under another angle.
struct Patch {
  Grid grid{20, 12, 0.6, 0.8, -5.7, -4.0};
  std::vector<SlipRow> rows;
  std::vector<double> pressure;

  Patch() {
    for (std::size_t j = 0; j < grid.lateral_count; ++j) {
      const double y = grid.lateral(j);
      const double angle = y < 0.0 ? -0.08 + 0.02 * y : 0.15 + 0.01 * y;
      rows.push_back({y, -0.05 + 0.004 * y * y, std::sin(angle), std::cos(angle)});
      for (std::size_t i = 0; i < grid.longitudinal_count; ++i) {
        const double x = grid.longitudinal(i) / 4.0;
        const double at = (std::abs(y) - 4.0) / 1.8;
        pressure.push_back((y < 0.0 ? 900.0 : 400.0) *
                           std::sqrt(std::max(0.0, 1.0 - x * x - at * at)));
      }
    }
  }
  [[nodiscard]] SlipGeometry geometry() const {
    return slip_geometry(loaded_rows(rows, grid, pressure), approach);
  }
};

/// From the velocity of the place and its tangent.
std::array<double, 2> slip_at(const SlipRow& row, double x) {
  const Vector3 place{x, row.lateral, row.height + approach};
  const Vector3 velocity = Vector3{moving[0], moving[1], moving[2]} +
                           cross(Vector3{moving[3], moving[4], moving[5]}, place);
  return {velocity.x, row.cosine * velocity.y + row.sine * velocity.z};
}

TEST(RigidSlip, IsThatOfThePositionAlongItsTangent) {
  const Patch patch;
  const SlipGeometry geometry = patch.geometry();
  const Creepages creepages = fitted_creepages(geometry, moving);
  const SlipField beyond = slip_beyond(geometry, patch.rows, patch.grid, moving);
  for (std::size_t j = 0; j < patch.rows.size(); ++j) {
    for (std::size_t i = 0; i < patch.grid.longitudinal_count; ++i) {
      const double x = patch.grid.longitudinal(i);
      const double y = patch.grid.lateral(j);
      const std::size_t at = j * patch.grid.longitudinal_count + i;
      const auto slip = slip_at(patch.rows[j], x);
      EXPECT_NEAR(beyond.x[at] + creepages.longitudinal - creepages.spin * y, slip[0], 1e-15);
      EXPECT_NEAR(beyond.y[at] + creepages.lateral + creepages.spin * x, slip[1], 1e-15);
    }
  }
}

/// No other creepages leave less: each is at the bottom of its parabola.
TEST(RigidSlip, CreepagesLeaveTheLeastSquares) {
  const Patch patch;
  const SlipGeometry geometry = patch.geometry();
  const Creepages best = fitted_creepages(geometry, moving);
  const auto left = [&](double longitudinal, double lateral, double spin) {
    const Creepages c{best.longitudinal + longitudinal, best.lateral + lateral, best.spin + spin};
    const double rest = slip_variation(geometry, moving, c);
    return rest * rest;
  };
  const double least = left(0.0, 0.0, 0.0);
  for (const std::array<double, 3>& step :
       {std::array{1e-5, 0.0, 0.0}, std::array{0.0, 1e-5, 0.0}, std::array{0.0, 0.0, 1e-5}}) {
    const double above = left(step[0], step[1], step[2]) - least;
    const double below = left(-step[0], -step[1], -step[2]) - least;
    EXPECT_GT(above, 0.0);
    EXPECT_NEAR(above, below, 1e-9 * least + 1e-5 * above);
  }
  // What is left is the sum over elements, with the turning within them.
  const SlipField beyond = slip_beyond(geometry, patch.rows, patch.grid, moving);
  const Grid& grid = patch.grid;
  const double within =
      (grid.longitudinal_step * grid.longitudinal_step + grid.lateral_step * grid.lateral_step) /
      12.0; // of an element, mean square of the distance from its centre
  double squares = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < patch.pressure.size(); ++i) {
    const SlipRow& row = patch.rows[i / grid.longitudinal_count];
    const double turning = row.cosine * moving[5] - row.sine * moving[4] - best.spin;
    squares += patch.pressure[i] *
               (beyond.x[i] * beyond.x[i] + beyond.y[i] * beyond.y[i] + within * turning * turning);
    weights += patch.pressure[i];
  }
  EXPECT_NEAR(slip_variation(geometry, moving, best), std::sqrt(squares / weights),
              1e-9 * std::sqrt(squares / weights));
}

/// On a plane that is flat they are those at the reference, and nothing is left.
TEST(RigidSlip, OfAPlaneIsThatOfItsReference) {
  Patch patch;
  for (SlipRow& row : patch.rows) {
    row = {row.lateral, -approach};
  }
  const SlipGeometry geometry = patch.geometry();
  const Creepages creepages = fitted_creepages(geometry, moving);
  EXPECT_NEAR(creepages.longitudinal, moving[0], 1e-16);
  EXPECT_NEAR(creepages.lateral, moving[1], 1e-16);
  EXPECT_NEAR(creepages.spin, moving[5], 1e-16);
  EXPECT_NEAR(slip_variation(geometry, moving, creepages), 0.0, 1e-12);
}

/// A single element under pressure has its slip and its turning.
TEST(RigidSlip, OfASingleElement) {
  Patch patch;
  for (double& p : patch.pressure) {
    p = 0.0;
  }
  const std::size_t row = 16;
  const std::size_t column = 3;
  patch.pressure[row * patch.grid.longitudinal_count + column] = 100.0;
  const Creepages creepages = fitted_creepages(patch.geometry(), moving);
  const double x = patch.grid.longitudinal(column);
  const auto slip = slip_at(patch.rows[row], x);
  EXPECT_NEAR(creepages.longitudinal - creepages.spin * patch.grid.lateral(row), slip[0], 1e-15);
  EXPECT_NEAR(creepages.lateral + creepages.spin * x, slip[1], 1e-15);
  EXPECT_NEAR(creepages.spin, patch.rows[row].cosine * moving[5] - patch.rows[row].sine * moving[4],
              1e-15);
}

/// Seen from another origin of the plane they are transferred creepages.
TEST(RigidSlip, OfRowsFromAnotherOrigin) {
  const Patch patch;
  std::vector<LoadedRow> moved;
  for (const LoadedRow& row : patch.geometry().rows) {
    moved.push_back(moved_row(row, 2.0, -3.0, 0.1, -3.0));
  }
  // The same motion with its velocities at the new origin.
  Twist there = moving;
  const Vector3 velocity =
      Vector3{moving[0], moving[1], moving[2]} +
      cross(Vector3{moving[3], moving[4], moving[5]}, Vector3{-2.0, 3.0, -0.1});
  there[0] = velocity.x;
  there[1] = velocity.y;
  there[2] = velocity.z;
  const Creepages here = fitted_creepages(patch.geometry(), moving);
  const Creepages found = fitted_creepages(slip_geometry(moved, approach), there);
  EXPECT_NEAR(found.spin, here.spin, 1e-15);
  EXPECT_NEAR(found.longitudinal, here.longitudinal - here.spin * 3.0, 1e-15);
  EXPECT_NEAR(found.lateral, here.lateral - here.spin * 2.0, 1e-15);
}

/// Tractions do the work of their force and moment: what creepages fit, and the rest.
TEST(RigidSlip, ForcesAndMomentsDoTheWorkOfTractions) {
  const Patch patch;
  const SlipGeometry geometry = patch.geometry();
  std::vector<double> qx;
  std::vector<double> qy;
  double power = 0.0;
  std::array<double, 3> forces{};
  for (std::size_t i = 0; i < patch.pressure.size(); ++i) {
    const double x = patch.grid.longitudinal(i % patch.grid.longitudinal_count);
    const SlipRow& row = patch.rows[i / patch.grid.longitudinal_count];
    qx.push_back(0.2 * patch.pressure[i] * std::cos(x));
    qy.push_back(0.3 * patch.pressure[i] * std::sin(0.5 + row.lateral));
    const auto slip = slip_at(row, x);
    const double area = patch.grid.element_area();
    power += area * (qx[i] * slip[0] + qy[i] * slip[1]);
    forces[0] += area * qx[i];
    forces[1] += area * qy[i];
    forces[2] += area * (x * qy[i] - row.lateral * qx[i]);
  }
  const auto work = [](const Wrench& wrench) {
    double sum = 0.0;
    for (std::size_t i = 0; i < twist_count; ++i) {
      sum += wrench[i] * moving[i];
    }
    return sum;
  };
  const Creepages c = fitted_creepages(geometry, moving);
  const double fitted = forces[0] * c.longitudinal + forces[1] * c.lateral + forces[2] * c.spin;
  const double rounding = 1e-12 * std::abs(power);
  EXPECT_NEAR(work(wrench_of(geometry.creepages_by_twist, forces)), fitted, rounding);
  EXPECT_NEAR(work(wrench_beyond(geometry, patch.rows, patch.grid, qx, qy)), power - fitted,
              rounding);
  EXPECT_GT(std::abs(power - fitted), 1e-3 * std::abs(power));
}

} // namespace
} // namespace wrc::test::rigid_slip_test
