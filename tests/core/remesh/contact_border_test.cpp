#include "remesh/contact_border.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "remesh/constants.hpp"

namespace wrc::test::contact_border_test {
namespace {

constexpr double none = no_material_distance;

/// Three rows of four elements, of which two in the middle carry pressure.
const Grid grid{3, 4, 1.0, 1.0, -1.0, -1.5};
const std::vector<double> pressure{0.0, 0.0, 0.0, 0.0, 0.0, 9.0, 8.0, 0.0, 0.0, 0.0, 0.0, 0.0};

TEST(ContactBorder, PairsElementsUnderPressureWithTheirNeighbours) {
  const std::vector<double> distance(12, -0.1);
  const auto border = contact_border(grid, pressure, distance);
  ASSERT_EQ(border.size(), 6U);
  EXPECT_EQ(border[0].inside, 5U); // before it, then below and above
  EXPECT_EQ(border[0].outside, 4U);
  EXPECT_TRUE(border[0].is_along);
  EXPECT_EQ(border[1].outside, 1U);
  EXPECT_FALSE(border[1].is_along);
  EXPECT_EQ(border[2].outside, 9U);
  EXPECT_EQ(border[3].inside, 6U);
  EXPECT_EQ(border[3].outside, 7U);
  EXPECT_FALSE(body_ends_in_contact(grid, pressure, distance));
}

TEST(ContactBorder, SaysWhereABodyEnds) {
  for (const std::size_t missed : {1U, 4U, 7U, 10U}) {
    std::vector<double> distance(12, -0.1);
    distance[missed] = none;
    EXPECT_TRUE(body_ends_in_contact(grid, pressure, distance)) << missed;
    for (const BorderPair& pair : contact_border(grid, pressure, distance))
      EXPECT_EQ(pair.ends, pair.outside == missed) << missed;
  }
  std::vector<double> distance(12, -0.1);
  distance[0] = distance[3] = none; // at the corners, beside no element under pressure
  EXPECT_FALSE(body_ends_in_contact(grid, pressure, distance));
}

/// A model's pressures may lie where a body is not.
TEST(ContactBorder, LiesWhereRaysMiss) {
  std::vector<double> distance(12, -0.1);
  distance[6] = none;
  const auto border = contact_border(grid, pressure, distance);
  ASSERT_EQ(border.size(), 4U); // of element 5 alone
  EXPECT_TRUE(body_ends_in_contact(grid, pressure, distance));
}

} // namespace
} // namespace wrc::test::contact_border_test
