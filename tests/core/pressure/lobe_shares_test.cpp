#include "pressure/lobe_shares.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <gtest/gtest.h>

namespace wrc::test::lobe_shares_test {
namespace {

using Values = std::vector<double>;

constexpr std::size_t count = 40;

/// Ellipses of these heights and half widths about 12 and 27 rows.
Values two_ellipses(double first, double first_width, double second, double second_width) {
  Values rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i);
    const double a = (at - 12.0) / first_width;
    const double b = (at - 27.0) / second_width;
    rows[i] = first * std::sqrt(std::max(0.0, 1.0 - a * a)) +
              second * std::sqrt(std::max(0.0, 1.0 - b * b));
  }
  return rows;
}

/// Smooth ones that overlap.
Values two_waves(double first, double second, double width) {
  Values rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i);
    rows[i] = first * std::exp(-std::pow((at - 14.3) / width, 2)) +
              second * std::exp(-std::pow((at - 24.9) / width, 2));
  }
  return rows;
}

Values forces_of(const Values& rows) {
  Values forces;
  for (const Values& shares : lobe_shares(rows)) {
    forces.push_back(std::inner_product(rows.begin(), rows.end(), shares.begin(), 0.0));
  }
  return forces;
}

TEST(LobeShares, NothingHasNoLobeAndOneCrestHasAll) {
  EXPECT_TRUE(lobe_shares({}).empty());
  EXPECT_TRUE(lobe_shares(Values(5, 0.0)).empty());
  for (const Values& rows : {Values{1.0}, Values{2.0, 2.0}, Values{0.0, 1.0, 3.0, 3.0, 2.0}}) {
    const auto shares = lobe_shares(rows);
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_EQ(shares.front(), Values(rows.size(), 1.0));
  }
}

TEST(LobeShares, SeparateContactsKeepTheirForces) {
  const Values rows = two_ellipses(5.0, 6.0, 1.0, 7.0);
  const Values first = two_ellipses(5.0, 6.0, 0.0, 7.0);
  const Values forces = forces_of(rows);
  ASSERT_EQ(forces.size(), 2U);
  const double of_first = std::accumulate(first.begin(), first.end(), 0.0);
  const double all = std::accumulate(rows.begin(), rows.end(), 0.0);
  EXPECT_NEAR(forces[0], of_first, 1e-12 * all);
  EXPECT_NEAR(forces[1], all - of_first, 1e-12 * all);
}

TEST(LobeShares, AddUpToOneInEachRow) {
  for (const double width : {4.0, 5.5, 6.5, 7.0, 9.0}) {
    const auto shares = lobe_shares(two_waves(3.0, 2.0, width));
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0.0;
      for (const Values& lobe : shares) {
        EXPECT_GE(lobe[i], 0.0);
        sum += lobe[i];
      }
      EXPECT_NEAR(sum, 1.0, 1e-14);
    }
  }
}

/// The lesser one passes its force to the greater one before it is gone.
TEST(LobeShares, ALobeThatMergesHasNoForceThen) {
  for (const double second : {0.3, 1.0, 2.9, 3.5}) {
    Values before = forces_of(two_waves(3.0, second, 4.0));
    ASSERT_EQ(before.size(), 2U);
    std::size_t merged = 0;
    for (double width = 4.0; width < 9.0; width += 1e-3) {
      const Values rows = two_waves(3.0, second, width);
      Values forces = forces_of(rows);
      const double all = std::accumulate(rows.begin(), rows.end(), 0.0);
      if (forces.size() < before.size()) {
        ++merged;
        forces.insert(second < 3.0 ? forces.end() : forces.begin(), 0.0);
      }
      for (std::size_t k = 0; k < before.size(); ++k) {
        EXPECT_NEAR(forces[k], before[k], 3e-3 * all) << second << ' ' << width;
      }
      before = forces_of(rows);
    }
    EXPECT_EQ(merged, 1U) << second;
  }
}

/// The middle one of three gives to both; a ripple on a crest is no lobe.
TEST(LobeShares, ThreeLobesAndARipple) {
  const Values rows{0.0, 1.0, 4.0, 3.0, 2.9, 3.9, 3.1, 2.6, 3.8, 1.0, 0.0};
  const Values forces = forces_of(rows);
  ASSERT_EQ(forces.size(), 3U);
  EXPECT_NEAR(forces[0] + forces[1] + forces[2], std::accumulate(rows.begin(), rows.end(), 0.0),
              1e-12);
  EXPECT_EQ(forces_of({0.0, 1.0, 4.0, 3.9, 4.1, 1.0}).size(), 1U);
}

/// Plateaus of zeros and of pressure.
TEST(LobeShares, BordersOfPlateausLieInTheirMiddle) {
  const auto shares = lobe_shares(Values{1.0, 2.0, 0.0, 0.0, 0.0, 3.0, 3.0, 1.0});
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0][1], 1.0);
  EXPECT_EQ(shares[0][3], 0.5);
  EXPECT_EQ(shares[0][5], 0.0);
}

} // namespace
} // namespace wrc::test::lobe_shares_test
