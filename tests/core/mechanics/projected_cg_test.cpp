// The iteration on rectangles: conditions of contact by plain sums, one box, two boxes, open sides.
#include "mechanics/projected_cg.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::projected_cg_test {
namespace {

constexpr std::size_t rows = 14;
constexpr std::size_t columns = 18;
constexpr double tolerance = 1e-6;

/// A rectangle with a rough paraboloid over it.
struct Body {
  explicit Body(double middle, double curvature, double aspect = 1.2) {
    box.rows = rows;
    box.columns = columns;
    box.kernel = {aspect, Elements::constant};
    distance.resize(box.count());
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const double y = aspect * (static_cast<double>(i) - 6.3);
        const double x = static_cast<double>(j) - middle;
        distance[i * columns + j] =
            curvature * (x * x + y * y) + 0.3 * std::sin(static_cast<double>(7 * i + 3 * j));
      }
    }
    pressure.assign(box.count(), 1.0);
  }
  /// To be called when the body stays where it is.
  IterationBox bound() {
    shares.resize(box.count());
    for (std::size_t i = 0; i < shares.size(); ++i) {
      shares[i] = box.share * (1.0 + 0.05 * std::sin(static_cast<double>(2 * i)));
    }
    box.pressure = pressure;
    box.distance = distance;
    box.shares = shares;
    return box;
  }

  [[nodiscard]] std::vector<double> displacement(InfluenceCache& cache) const {
    const auto table = cache.table(box.kernel, rows, columns);
    std::vector<double> u(box.count(), 0.0);
    const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    for (std::size_t i = 0; i < u.size(); ++i) {
      for (std::size_t j = 0; j < u.size(); ++j) {
        u[i] += table->row(apart(i / columns, j / columns))[apart(i % columns, j % columns)] *
                pressure[j];
      }
    }
    return u;
  }
  [[nodiscard]] double load() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      sum += shares[i] * pressure[i];
    }
    return sum;
  }

  IterationBox box;
  std::vector<double> distance;
  std::vector<double> pressure;
  std::vector<double> shares; ///< of the approach, none like its neighbours
};

/// Pressures are not negative; gaps are 0 under them and not negative elsewhere.
void expect_contact(const Body& body, double approach, InfluenceCache& cache) {
  const std::vector<double> u = body.displacement(cache);
  const double largest = *std::max_element(u.begin(), u.end());
  std::size_t touching = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double gap = body.distance[i] + u[i] - body.shares[i] * approach;
    EXPECT_GE(body.pressure[i], 0.0);
    if (body.pressure[i] > 0.0) {
      EXPECT_NEAR(gap, 0.0, 10.0 * tolerance * largest) << i;
      ++touching;
    } else {
      EXPECT_GT(gap, -10.0 * tolerance * largest) << i;
    }
  }
  EXPECT_GT(touching, 20U);
  EXPECT_LT(touching, u.size());
}

template <typename Real> class ProjectedCgTest : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ProjectedCgTest, Precisions);

TYPED_TEST(ProjectedCgTest, MeetsTheConditionsWithTheApproachGiven) {
  InfluenceCache cache;
  ProjectedCg<TypeParam> iteration(cache);
  Body body(8.4, 0.4);
  const std::vector<IterationBox> boxes{body.bound()};
  IterationRequest request;
  request.boxes = boxes;
  request.approach = 12.0;
  request.tolerance = tolerance;
  const IterationOutcome outcome = iteration.solve(request);
  EXPECT_EQ(outcome.stop_reason, StopReason::tolerance_met);
  EXPECT_EQ(outcome.approach, 12.0);
  expect_contact(body, 12.0, cache);
  EXPECT_NEAR(outcome.largest_pressure,
              *std::max_element(body.pressure.begin(), body.pressure.end()),
              10.0 * tolerance * outcome.largest_pressure);
}

TYPED_TEST(ProjectedCgTest, LoadAndApproachAreTheSameProblem) {
  InfluenceCache cache;
  ProjectedCg<TypeParam> iteration(cache);
  Body by_load(8.4, 0.4);
  IterationRequest request;
  const std::vector<IterationBox> boxes{by_load.bound()};
  request.boxes = boxes;
  request.load = 150.0;
  request.tolerance = tolerance;
  const IterationOutcome outcome = iteration.solve(request);
  EXPECT_EQ(outcome.stop_reason, StopReason::tolerance_met);
  EXPECT_NEAR(by_load.load(), 150.0, 10.0 * tolerance * 150.0);
  expect_contact(by_load, outcome.approach, cache);
  Body by_approach(8.4, 0.4);
  const std::vector<IterationBox> others{by_approach.bound()};
  request.boxes = others;
  request.load.reset();
  request.approach = outcome.approach;
  iteration.solve(request);
  EXPECT_NEAR(by_approach.load(), 150.0, 1e-4 * 150.0);
}

/// Two boxes that do not interact share one approach, each element by its own share of it.
TYPED_TEST(ProjectedCgTest, BoxesShareTheLoadAtOneApproach) {
  InfluenceCache cache;
  ProjectedCg<TypeParam> iteration(cache);
  Body one(8.4, 0.4);
  Body other(7.1, 0.6, 0.9);
  other.box.share = 0.8;
  other.box.weight = 1.5;
  const std::vector<IterationBox> boxes{one.bound(), other.bound()};
  IterationRequest request;
  request.boxes = boxes;
  request.load = 250.0;
  request.tolerance = tolerance;
  const IterationOutcome outcome = iteration.solve(request);
  EXPECT_EQ(outcome.stop_reason, StopReason::tolerance_met);
  EXPECT_NEAR(one.load() + 1.5 * other.load(), 250.0, 10.0 * tolerance * 250.0);
  expect_contact(one, outcome.approach, cache);
  expect_contact(other, outcome.approach, cache);
}

/// Contact that comes up at an open side ends the iteration and says where.
TYPED_TEST(ProjectedCgTest, SaysWhichOpenSideContactReaches) {
  InfluenceCache cache;
  ProjectedCg<TypeParam> iteration(cache);
  Body body(1.0, 0.4);
  body.box.open_first_column = body.box.open_last_column = true;
  const std::vector<IterationBox> boxes{body.bound()};
  IterationRequest request;
  request.boxes = boxes;
  request.approach = 12.0;
  request.tolerance = tolerance;
  body.pressure.assign(body.box.count(), 0.0);
  const IterationOutcome outcome = iteration.solve(request);
  EXPECT_TRUE(outcome.reached_any);
  EXPECT_TRUE(outcome.reached.front().first_column);
  EXPECT_FALSE(outcome.reached.front().last_column);
}

TYPED_TEST(ProjectedCgTest, StopsAtTheLimitOfIterations) {
  InfluenceCache cache;
  ProjectedCg<TypeParam> iteration(cache);
  Body body(8.4, 0.4);
  const std::vector<IterationBox> boxes{body.bound()};
  IterationRequest request;
  request.boxes = boxes;
  request.approach = 12.0;
  request.tolerance = tolerance;
  request.maximum_iterations = 2;
  const IterationOutcome outcome = iteration.solve(request);
  EXPECT_EQ(outcome.stop_reason, StopReason::iteration_limit);
  EXPECT_EQ(outcome.iterations, 2);
  EXPECT_GT(outcome.error, tolerance);
}

} // namespace
} // namespace wrc::test::projected_cg_test
