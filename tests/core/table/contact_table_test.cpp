#include "table/contact_table.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "table/small_table.hpp"

namespace wrc::test {
namespace {

/// The number of each column of derivatives, and a step of differences.
struct Column {
  double* number;
  double step;
};
std::array<Column, table_rate_count> columns_of(TableState& s) {
  constexpr double length = 1e-5;
  constexpr double turn = 1e-8;
  constexpr double speed = 0.03;
  constexpr double rate = 3e-5;
  return {{{&s.position[1], length},
           {&s.position[2], length},
           {&s.position[3], turn},
           {&s.position[5], turn},
           {&s.velocity[0], speed},
           {&s.velocity[1], speed},
           {&s.velocity[2], speed},
           {&s.velocity[3], rate},
           {&s.velocity[4], rate},
           {&s.velocity[5], rate},
           {&s.rail[0], length},
           {&s.rail[1], length},
           {&s.rail[2], turn},
           {&s.rail_velocity[0], speed},
           {&s.rail_velocity[1], speed},
           {&s.rail_velocity[2], rate}}};
}

TEST(ContactTable, DerivativesAreThoseOfItsForces) {
  const ContactTable& table = small_table();
  const std::size_t cells = table.errors.cell_count();
  for (std::size_t i = 0; i < 3 * cells; ++i) {
    TableState state = random_state(table, i % cells, 900 + i / cells);
    state.curvature = 1e-6;
    state.rail = {0.2, -0.1, 0.0005};
    const TableContact found = contact_in_table(table, state, true);
    if (!found.inside || found.lifted) {
      continue;
    }
    EXPECT_EQ(found.force, contact_in_table(table, state, false).force);
    const auto columns = columns_of(state);
    for (std::size_t column = 0; column < table_rate_count; ++column) {
      const double step = columns[column].step;
      *columns[column].number += step;
      const TableContact ahead = contact_in_table(table, state, false);
      *columns[column].number -= 2.0 * step;
      const TableContact behind = contact_in_table(table, state, false);
      *columns[column].number += step;
      for (std::size_t row = 0; row < 6; ++row) {
        const double difference = (ahead.force[row] - behind.force[row]) / (2.0 * step);
        // 1e-3 of itself for what the law curves over a step, and rounding: 1e-10 of the load, or
        // of its moment.
        const double rounding = (row < 3 ? 1e-5 : 1e-2) / step;
        EXPECT_NEAR(found.rates[row][column], difference, 1e-3 * std::abs(difference) + rounding)
            << "row " << row << ", column " << column;
      }
    }
  }
}

TEST(ContactTable, RollingBackwardsIsTheMirrorImage) {
  const ContactTable& table = small_table();
  for (std::size_t i = 0; i < 20; ++i) {
    TableState state = random_state(table, i % table.errors.cell_count(), 77);
    const TableContact forwards = contact_in_table(table, state, false);
    state.position[5] = -state.position[5];
    for (const std::size_t turning : {0U, 4U, 5U}) {
      state.velocity[turning] = -state.velocity[turning];
    }
    const TableContact backwards = contact_in_table(table, state, false);
    constexpr std::array signs{-1.0, 1.0, 1.0, 1.0, -1.0, -1.0};
    for (std::size_t row = 0; row < 6; ++row) {
      // What the law has of its nodes' rounding, of the load's moment.
      EXPECT_NEAR(backwards.force[row], signs[row] * forwards.force[row],
                  1e-5 * (row < 3 ? 1e5 : 7e7));
    }
  }
}

TEST(ContactTable, ForcesAndSlopesVanishWhereTheWheelLifts) {
  const ContactTable& table = small_table();
  TableState state = random_state(table, 0, 5);
  double before = -1.0;
  bool lifted = false;
  for (int i = 0; i < 4000 && !lifted; ++i) {
    state.position[2] += 1e-4;
    const TableContact found = contact_in_table(table, state, true);
    ASSERT_TRUE(found.inside);
    if (found.lifted) {
      EXPECT_LT(before, 100.0);
      EXPECT_EQ(found.force, (std::array<double, 6>{}));
      lifted = true;
    }
    before = found.force[2];
  }
  EXPECT_TRUE(lifted);
}

TEST(ContactTable, GoesToItsAlignedPlaceAndBack) {
  ContactTable table = small_table();
  table.flange = 0.5;
  const auto& axes = table.shift.axes();
  table.shift = TensorSpline<2, 1>(axes, std::vector<double>(axes[0].count * axes[1].count, 0.3));
  for (double u = -5.0; u < 5.0; u += 0.37) {
    EXPECT_NEAR(from_aligned(table, aligned(table, u, 0.001, 0.002), 0.001, 0.002), u, 1e-12);
  }
}

TEST(ContactTable, StatesItsErrors) {
  const ContactTable& table = small_table();
  EXPECT_GT(table.measured.states, 400U);
  const double promised = 2e-3 * static_cast<double>(table.measured.states);
  EXPECT_LE(static_cast<double>(table.measured.beyond), promised + 2.0 * std::sqrt(promised));
  TableErrors measured;
  measured.states = 1000;
  EXPECT_NEAR(measured.beyond_at_most(), 3.0e-3, 0.2e-3); // the rule of three
  measured.beyond = 5;
  EXPECT_NEAR(measured.beyond_at_most(), 10.5e-3, 0.2e-3);
  EXPECT_LT(table.measured.percentile_99, 0.03);
  EXPECT_GT(table.measured.worst, table.measured.median);
  EXPECT_GT(table.bytes(), 1000U);
}

} // namespace
} // namespace wrc::test
