// Marches of FASTSIM against closed forms of single strips.
#include "rolling/fastsim_loops.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::fastsim_loops_test {
namespace {

constexpr std::size_t slices = 2000;

/// One strip of half length l in the middle of the group; the traction grows by `k` over a
/// semi-axis in adhesion, against x and y.
StripSums march_strip(double l, double k_x, double k_y, double place = 0.0) {
  EllipseStrips strips{};
  double places[strip_group] = {};
  const std::size_t j = 5;
  const double step = 2.0 * l / static_cast<double>(slices);
  strips.half_length[j] = l;
  strips.change_x[j] = k_x * step;
  strips.change_y[j] = k_y * step;
  places[j] = place;
  return march_ellipse(strips, places, slices);
}

/// Integral over a strip of the traction: k (l - x) up to where it meets l^2 - x^2, the bound then.
double strip_force(double l, double k) {
  const double edge = std::clamp(k - l, -l, l);
  return k * (l - edge) * (l - edge) / 2.0 + l * l * (edge + l) -
         (edge * edge * edge + l * l * l) / 3.0;
}

TEST(FastsimLoops, AStripOfAnEllipseCarriesItsClosedForm) {
  for (const double l : {0.3, 1.0}) {
    for (const double k : {0.05, 0.4, 0.9, 5.0}) {
      // Sums count slices, weighted with half the length.
      const double force = march_strip(l, k, 0.0).x * 2.0 / static_cast<double>(slices);
      EXPECT_NEAR(force, -strip_force(l, k), 2e-3 * strip_force(l, k)) << l << ' ' << k;
    }
  }
}

TEST(FastsimLoops, TractionsTurnWithTheSlip) {
  const StripSums along = march_strip(0.8, 0.5, 0.0);
  const StripSums across = march_strip(0.8, 0.0, 0.5);
  const StripSums oblique = march_strip(0.8, 0.3, 0.4);
  EXPECT_NEAR(across.y, along.x, 1e-12 * std::abs(along.x));
  EXPECT_NEAR(oblique.x, 0.6 * along.x, 1e-12 * std::abs(along.x));
  EXPECT_NEAR(oblique.y, 0.8 * along.x, 1e-12 * std::abs(along.x));
  EXPECT_EQ(oblique.slipping, along.slipping);
}

TEST(FastsimLoops, MomentsHaveTheirLevers) {
  // All slides: lateral tractions are the bound, symmetric about the middle.
  const StripSums sliding = march_strip(0.8, 1e3, 1e3, 0.25);
  EXPECT_NEAR(sliding.moment, 0.0, 1e-9);
  EXPECT_NEAR(sliding.moment_x, 0.25 * sliding.x, 1e-12 * std::abs(sliding.x));
  // In adhesion -k (l - x) has the moment 2 k l^3/3 about the middle, as long as it stays in bound.
  const StripSums sticking = march_strip(1.0, 0.0, 1e-4);
  EXPECT_NEAR(sticking.moment * 2.0 / static_cast<double>(slices), 1e-4 * 2.0 / 3.0, 1e-6);
}

/// Elements of one strip, three in contact, a gap, two in contact.
TEST(FastsimLoops, EveryStretchOfElementsHasALeadingEdge) {
  const std::vector<double> bound{0.0, 9.0, 9.0, 9.0, 0.0, 9.0, 9.0};
  const std::vector<double> change_x(7, 0.2);
  const std::vector<double> change_y(7, -0.1);
  std::vector<double> x(7), y(7), cut_x(7), cut_y(7), state(3);
  MarchedElements elements;
  elements.rows = 7;
  elements.pitch = 1;
  elements.bound = bound.data();
  elements.change_x = change_x.data();
  elements.change_y = change_y.data();
  march_elements(elements, x.data(), y.data(), cut_x.data(), cut_y.data(), state.data());
  const std::vector<double> along{0.0, 0.5, 1.5, 2.5, 0.0, 0.5, 1.5}; // elements from the edge
  for (std::size_t i = 0; i < along.size(); ++i) {
    EXPECT_NEAR(x[i], -0.2 * along[i], 1e-14);
    EXPECT_NEAR(y[i], 0.1 * along[i], 1e-14);
    EXPECT_NEAR(cut_x[i], 0.0, 1e-14);
  }
}

/// What grows from row to row is integrated from the edge: y = sum of (c + m i), at its centres.
TEST(FastsimLoops, ChangesThatGrowAreIntegratedExactly) {
  constexpr double slope = 0.03;
  constexpr std::size_t rows = 12;
  std::vector<double> bound(rows, 9.0), change_x(rows, 0.0), change_y(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    change_y[i] = 0.2 + slope * static_cast<double>(i);
  }
  std::vector<double> x(rows), y(rows), cut_x(rows), cut_y(rows), state(3);
  MarchedElements elements;
  elements.rows = rows;
  elements.pitch = 1;
  elements.bound = bound.data();
  elements.change_x = change_x.data();
  elements.change_y = change_y.data();
  elements.change_y_by_row = slope;
  march_elements(elements, x.data(), y.data(), cut_x.data(), cut_y.data(), state.data());
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) + 0.5; // from the edge; c at the first centre, t = 0.5
    EXPECT_NEAR(y[i], -(0.2 * t + slope * (0.5 * t * t - 0.5 * t)), 1e-14) << i;
  }
}

TEST(FastsimLoops, TractionsAreCutBackOntoTheBound) {
  const std::vector<double> bound{0.3, 0.5, 0.2};
  const std::vector<double> change_x(3, 0.8);
  const std::vector<double> change_y(3, 0.6);
  std::vector<double> x(3), y(3), cut_x(3), cut_y(3), state(3);
  MarchedElements elements;
  elements.rows = 3;
  elements.pitch = 1;
  elements.bound = bound.data();
  elements.change_x = change_x.data();
  elements.change_y = change_y.data();
  march_elements(elements, x.data(), y.data(), cut_x.data(), cut_y.data(), state.data());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::hypot(x[i], y[i]), bound[i], 1e-14);
    EXPECT_NEAR(x[i] / y[i], 0.8 / 0.6, 1e-12);
    const double part = i == 0 ? 0.5 : 1.0;
    const double before = i == 0 ? 0.0 : x[i - 1];
    EXPECT_NEAR(cut_x[i] * part, before - part * 0.8 - x[i], 1e-14);
  }
}

} // namespace
} // namespace wrc::test::fastsim_loops_test
