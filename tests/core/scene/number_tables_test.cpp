// Tables of numbers: names, numbers that may be absent, units of derivatives, and older names.
#include "scene/number_tables.hpp"

#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "scene/damage_tables.hpp"
#include "scene/number_group.hpp"
#include "scene/number_ids.hpp"
#include "scene/number_table.hpp"
#include "scene/rate_tables.hpp"

namespace wrc::test::number_tables_test {
namespace {

using namespace number_tables;

template <class Table> void expect_different_names(const Table& table) {
  std::set<std::string_view> names;
  for (const auto& number : table) {
    EXPECT_TRUE(names.insert(number.name).second) << number.name;
  }
}

TEST(NumberTables, NamesOfATableAreDistinct) {
  for (std::size_t group = 0; group <= static_cast<std::size_t>(NumberGroup::damage); ++group) {
    with_table(static_cast<NumberGroup>(group),
               [](const auto& table) { expect_different_names(table); });
  }
}

template <auto... path> constexpr double read(const PatchResult& patch) {
  return Number<PatchResult>("", pure, member<path...>).value(patch);
}

TEST(NumberTables, MembersOfMembersAreRead) {
  PatchResult patch;
  patch.force.y = 3.5;
  patch.lobes = 2;
  EXPECT_EQ((read<&PatchResult::force, &Vector3::y>(patch)), 3.5);
  EXPECT_EQ(read<&PatchResult::lobes>(patch), 2.0);
}

/// What may be absent is not-a-number then, and says so.
TEST(NumberTables, AbsentNumbersAreNotANumber) {
  const CreepResult creep;
  const ContactDamage damage;
  std::size_t optional = 0;
  for (const auto& number : creep_numbers) {
    EXPECT_EQ(std::isnan(number.value(creep)), !number.always) << number.name;
    optional += number.always ? 0U : 1U;
  }
  EXPECT_EQ(optional, 2U + creep_rate_numbers.size()) << "error estimates and derivatives";
  for (const auto& number : damage_numbers) {
    EXPECT_FALSE(number.always) << number.name;
    EXPECT_TRUE(std::isnan(number.value(damage))) << number.name;
  }
}

TEST(NumberTables, DamageIsReadFromItsParts) {
  ContactDamage damage;
  damage.stress.emplace();
  damage.stress->von_mises = 400.0;
  damage.stress->error_estimate = HUGE_VAL;
  for (const auto& number : damage_numbers) {
    if (number.name == "stress.von_mises_max") {
      EXPECT_EQ(number.value(damage), 400.0);
    } else if (number.name == "stress.error_estimate") {
      EXPECT_TRUE(std::isnan(number.value(damage))) << "no estimate";
    } else if (number.name.starts_with("wear.")) {
      EXPECT_TRUE(std::isnan(number.value(damage)));
    }
  }
}

/// The value in metres over that in millimetres: by the powers of lengths in row and column.
TEST(NumberTables, DerivativesHaveTheUnitsOfTheirQuotient) {
  constexpr Convention si{Units::si, TrackFrame::left_up};
  constexpr Convention turned{Units::mm, TrackFrame::right_down};
  std::size_t entry = 0;
  for (const auto& number : jacobian_numbers) {
    const Variable& row = jacobian_rows[entry / state_count];
    const Variable& column = jacobian_columns[entry % state_count];
    const double expected = std::pow(1e-3, row.length - column.length);
    EXPECT_NEAR(to_caller(1.0, si, number.dimension), expected, 1e-12 * expected) << number.name;
    EXPECT_EQ(to_caller(1.0, turned, number.dimension), row.turns == column.turns ? 1.0 : -1.0);
    EXPECT_EQ(number.name, std::string(row.name) + ".by." + std::string(column.name));
    EXPECT_EQ(number.dimension.unit, std::string(row.unit) + std::string(column.unit));
    ++entry;
  }
}

TEST(NumberTables, RatesOfCreepForcesAreThoseOfTheMatrix) {
  CreepResult creep;
  creep.derivatives.emplace();
  for (std::size_t i = 0; i < 9; ++i) {
    creep.derivatives->by_creepage[i] = static_cast<double>(i);
  }
  creep.derivatives->by_load = {20.0, 21.0, 22.0};
  creep.derivatives->by_friction = {30.0, 31.0, 32.0};
  for (const auto& number : creep_rate_numbers) {
    if (number.name == "creep_force.lateral.by.spin") {
      EXPECT_EQ(number.value(creep), 5.0);
    } else if (number.name == "spin_moment.by.normal_force") {
      EXPECT_EQ(number.value(creep), 22.0);
    } else if (number.name == "creep_force.longitudinal.by.friction") {
      EXPECT_EQ(number.value(creep), 30.0);
    }
  }
}

} // namespace
} // namespace wrc::test::number_tables_test
