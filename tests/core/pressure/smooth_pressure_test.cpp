/// Pressures between elements and up to the edge, on Hertz's pressures and on what the normal
/// solver makes of them.
#include "pressure/smooth_pressure.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::smooth_pressure_test {
namespace {

/// Hertz's pressures of an ellipse with these semi-axes, at the centres of the elements.
std::vector<double> hertz(const Grid& grid, double a, double b) {
  std::vector<double> pressure;
  for (std::size_t j = 0; j < grid.lateral_count; ++j) {
    for (std::size_t i = 0; i < grid.longitudinal_count; ++i) {
      const double x = grid.longitudinal(i) / a;
      const double y = grid.lateral(j) / b;
      pressure.push_back(std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
  }
  return pressure;
}

constexpr Grid coarse{12, 14, 0.5, 0.7, -2.6, -4.4};

/// The largest difference of p^2.
double difference(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0.0;
  for (std::size_t at = 0; at < one.size(); ++at) {
    largest = std::max(largest, std::abs(one[at] * one[at] - other[at] * other[at]));
  }
  return largest;
}

TEST(SmoothPressure, HertzsComeOutExactlyAlongRows) {
  const SmoothPressure smooth(coarse, hertz(coarse, 4.0, 2.3));
  const Grid fine{8, 60, 0.5, 0.134, -2.1, -3.95}; // in the middles of rows
  std::vector<double> pressure;
  smooth.fill(fine, pressure);
  EXPECT_LT(difference(pressure, hertz(fine, 4.0, 2.3)), 1e-12);
}

// Of the second difference, which is that of Hertz, linear interpolation would leave an eighth. No
// element of this ellipse has just entered it.
TEST(SmoothPressure, HasTheSecondDifferenceAcrossRows) {
  const SmoothPressure smooth(coarse, hertz(coarse, 3.92, 2.3));
  const Grid fine{60, 60, 0.077, 0.134, -2.27, -3.95};
  std::vector<double> pressure;
  smooth.fill(fine, pressure);
  EXPECT_LT(difference(pressure, hertz(fine, 3.92, 2.3)), 1e-12);
}

// Second differences about 0 differ in sign, those beside it are 0.
TEST(SmoothPressure, IsLinearAcrossRowsAtAKink) {
  constexpr Grid grid{9, 9, 1.0, 1.0, -4.0, -4.0};
  std::vector<double> pressure;
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    const double square = 100.0 - 5.0 * std::abs(grid.lateral(i));
    pressure.insert(pressure.end(), grid.longitudinal_count, std::sqrt(square));
  }
  const Grid fine{13, 1, 0.5, 1.0, -3.0, 0.0};
  std::vector<double> between;
  SmoothPressure(grid, pressure).fill(fine, between);
  for (std::size_t i = 0; i < fine.lateral_count; ++i) {
    EXPECT_NEAR(between[i] * between[i], 100.0 - 5.0 * std::abs(fine.lateral(i)), 1e-9);
  }
}

// The ends are linear between elements, and those of the lines nearest to the axes.
TEST(SmoothPressure, ExtentsAreThoseOfTheEllipse) {
  const SmoothPressure smooth(coarse, hertz(coarse, 4.0, 2.3));
  EXPECT_NEAR(smooth.longitudinal_extent()->first, -4.0, 0.03);
  EXPECT_NEAR(smooth.longitudinal_extent()->last, 4.0, 0.03);
  EXPECT_NEAR(smooth.lateral_extent()->first, -2.3, 0.03);
  EXPECT_NEAR(smooth.lateral_extent()->last, 2.3, 0.03);
}

// The row outside is continued to 3 (p1^2 - p2^2) + p3^2: a little below 0, and above, where it
// counts as 0.
TEST(SmoothPressure, ExtentsHaveNoStepWhereContactReachesTheNextRow) {
  constexpr Grid grid{6, 5, 1.0, 1.0, 0.0, 0.0};
  const auto last = [&](double change) {
    std::vector<double> pressure;
    for (const double square : {0.8, 1.5, 1.8 + change, 1.6, 1.0, 0.0}) {
      pressure.insert(pressure.end(), grid.longitudinal_count, std::sqrt(square));
    }
    return SmoothPressure(grid, pressure).lateral_extent()->last;
  };
  EXPECT_NEAR(last(-1e-9), 5.0, 1e-6);
  EXPECT_NEAR(last(1e-9), 5.0, 1e-6);
}

// Against sums over a hundred places: p^2 is linear in halves of elements, 0.1 semi-axes long, and
// so up to 0.0025 off, where p is 0.2 and more.
TEST(SmoothPressure, MeansOverElementsCountThePartInContact) {
  const SmoothPressure smooth(coarse, hertz(coarse, 4.0, 2.3));
  const Grid other{4, 11, 1.0, 0.8, -1.6, -3.9};
  std::vector<double> pressure;
  std::vector<double> covered;
  smooth.fill_means(other, pressure, covered);
  constexpr std::size_t places = 100;
  Grid fine = other;
  fine.longitudinal_count *= places;
  fine.longitudinal_step /= static_cast<double>(places);
  fine.longitudinal_first += 0.5 * (fine.longitudinal_step - other.longitudinal_step);
  std::vector<double> values;
  smooth.fill(fine, values);
  for (std::size_t at = 0; at < pressure.size(); ++at) {
    double sum = 0.0;
    double inside = 0.0;
    for (std::size_t k = 0; k < places; ++k) {
      sum += values[at * places + k];
      inside += values[at * places + k] > 0.0 ? 1.0 : 0.0;
    }
    EXPECT_NEAR(pressure[at], sum / static_cast<double>(places), 0.0025 / (2.0 * 0.2)) << at;
    EXPECT_NEAR(covered[at], inside / static_cast<double>(places), 0.03) << at;
  }
}

// What an element at the end of a row holds is not what stands at its centre.
TEST(SmoothPressure, ValuesAtEndsOfRowsDoNotCount) {
  std::vector<double> pressure = hertz(coarse, 4.0, 2.3);
  const SmoothPressure exact(coarse, pressure);
  const std::vector<double> whole = pressure;
  for (std::size_t at = 4 * coarse.longitudinal_count; at < 8 * coarse.longitudinal_count; ++at) {
    const bool end = whole[at] > 0.0 && (!(whole[at - 1] > 0.0) || !(whole[at + 1] > 0.0));
    pressure[at] *= end ? 0.8 : 1.0;
  }
  ASSERT_NE(pressure, whole);
  std::vector<double> one;
  std::vector<double> other;
  exact.fill(coarse, one);
  SmoothPressure(coarse, pressure).fill(coarse, other);
  EXPECT_LT(difference(one, other), 1e-12);
}

// Forces that follow from the edge would step whenever an element enters.
TEST(SmoothPressure, AnElementThatEntersChangesNothingAtFirst) {
  const std::vector<double> before = hertz(coarse, 4.0, 2.3);
  const SmoothPressure smooth(coarse, before);
  const Grid fine{30, 34, 0.18, 0.27, -2.7, -4.5};
  std::vector<double> pressure;
  std::vector<double> covered;
  smooth.fill_means(fine, pressure, covered);
  int entering = 0;
  for (std::size_t at = 0; at < before.size(); ++at) {
    std::vector<double> after = before;
    after[at] = std::max(after[at], 1e-6);
    entering += before[at] > 0.0 ? 0 : 1;
    const std::size_t columns = coarse.longitudinal_count;
    const auto loaded = [&](std::size_t beside) {
      return beside < before.size() && before[beside] > 0.0;
    };
    if (!loaded(at - 1) && !loaded(at + 1) && !loaded(at - columns) && !loaded(at + columns)) {
      continue;
    }
    const SmoothPressure entered(coarse, after);
    std::vector<double> now;
    std::vector<double> covered_now;
    entered.fill_means(fine, now, covered_now);
    EXPECT_LT(difference(pressure, now), 1e-6) << at;
    for (std::size_t i = 0; i < covered.size(); ++i) {
      EXPECT_NEAR(covered_now[i], covered[i], 1e-6) << at << " seen at " << i;
    }
    EXPECT_NEAR(entered.lateral_extent()->last, smooth.lateral_extent()->last, 1e-6) << at;
    EXPECT_NEAR(entered.longitudinal_extent()->first, smooth.longitudinal_extent()->first, 1e-6)
        << at;
  }
  EXPECT_GT(entering, 30);
}

/// At the end of a flat p^2 has a crest beside the edge. Ends bear what they do in the solution;
/// p^2 continued from further in is below 0 there.
TEST(SmoothPressure, EndsOfBentRowsBearWhatTheirElementsDo) {
  constexpr Grid grid{5, 12, 1.0, 1.0, -2.0, 0.0};
  constexpr double crest = 7.0;
  constexpr double first = 1.2;
  constexpr double last = 9.2;
  const auto square = [](double x) {
    return x < crest ? (x - first) / (crest - first) : (last - x) / (last - crest);
  };
  const auto mean_about = [&square](double centre) {
    constexpr int parts = 1000;
    double mean = 0.0;
    for (int k = 0; k < parts; ++k) {
      mean += std::sqrt(std::max(square(centre - 0.5 + (k + 0.5) / parts), 0.0)) / parts;
    }
    return mean;
  };
  std::vector<double> row;
  double force = 0.0;
  for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
    const double x = grid.longitudinal(j);
    const double mean = mean_about(x);
    force += mean;
    const bool end = x == 1.0 || x == 9.0; // bears its mean
    row.push_back(end ? mean : std::sqrt(std::max(square(x), 0.0)));
  }
  std::vector<double> pressure;
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    pressure.insert(pressure.end(), row.begin(), row.end());
  }
  const auto missing = [&](double bend) {
    std::vector<double> means;
    std::vector<double> covered;
    SmoothPressure(grid, pressure, bend)
        .fill_means({1, 48, 1.0, 0.25, 0.0, -0.375}, means, covered);
    return std::abs(0.25 * std::accumulate(means.begin(), means.end(), 0.0) / force - 1.0);
  };
  EXPECT_GT(missing(0.0), 0.15);
  EXPECT_LT(missing(1.0), 0.05);
  EXPECT_LT(missing(0.5), missing(0.0));
}

TEST(SmoothPressure, NarrowContactsEndHalfAnElementOutside) {
  const Grid grid{5, 6, 1.0, 1.0, 0.0, 0.0};
  std::vector<double> pressure(30, 0.0);
  EXPECT_FALSE(SmoothPressure(grid, pressure).lateral_extent());
  pressure[14] = 3.0; // row 2, column 2
  const SmoothPressure one(grid, pressure);
  EXPECT_NEAR(one.longitudinal_extent()->first, 1.5, 1e-12);
  EXPECT_NEAR(one.longitudinal_extent()->last, 2.5, 1e-12);
  EXPECT_NEAR(one.lateral_extent()->first, 1.5, 1e-12);
  std::vector<double> values;
  one.fill(grid, values);
  EXPECT_NEAR(values[14], 3.0, 1e-12);
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), 0.0), values[14]);
  // Contact at the grid's edge, and all over it.
  EXPECT_NEAR(SmoothPressure(grid, std::vector<double>(30, 1.0)).lateral_extent()->last, 4.5,
              1e-12);
}

TEST(SmoothPressure, NothingOutsideTheGrid) {
  const SmoothPressure smooth(coarse, std::vector<double>(coarse.element_count(), 1.0));
  std::vector<double> values;
  smooth.fill(Grid{1, 3, 1.0, 20.0, 0.0, -20.0}, values);
  EXPECT_EQ(values[0], 0.0);
  EXPECT_NEAR(values[1], 1.0, 1e-12);
  EXPECT_EQ(values[2], 0.0);
}

} // namespace
} // namespace wrc::test::smooth_pressure_test
