// Contact that lies outside the rectangle of the iteration is found, displaced elements are not.
#include "mechanics/exterior_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mechanics/projected_cg.hpp"

namespace wrc::test::exterior_check_test {
namespace {

constexpr std::size_t rows = 24;
constexpr std::size_t columns = 60;

/// Two paraboloids on one grid, of which the iteration works on a rectangle around the first.
class ExteriorCheckTest : public testing::Test {
protected:
  /// `second`: how much farther away the second one is, in the first one's approach.
  std::optional<ElementBox> check(double second) {
    const double approach = 10.0;
    problem_.count = 1;
    problem_.cascades.resize(1);
    PatchCascade& cascade = problem_.cascades.front();
    cascade.kernel = {1.0, Elements::constant};
    cascade.level_count = 1;
    cascade.levels.resize(1);
    Level& level = cascade.finest();
    level.size = {rows, columns};
    level.distance.resize(rows * columns);
    level.shares.assign(rows * columns, 1.0);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const double y = static_cast<double>(i) - 11.5;
        const double x = static_cast<double>(j);
        level.distance[i * columns + j] =
            std::min(0.4 * ((x - 14.0) * (x - 14.0) + y * y),
                     0.4 * ((x - 45.0) * (x - 45.0) + y * y) + second * approach);
      }
    }
    cascade.box = {2, 21, 4, 24};
    copy_box(level.size, cascade.box, level.distance, cascade.box_distance);
    copy_box(level.size, cascade.box, level.shares, cascade.box_shares);
    cascade.box_pressure.assign(cascade.box_distance.size(), 0.0);
    ProjectedCg<double> iteration(cache_);
    IterationBox box;
    box.rows = cascade.box.rows();
    box.columns = cascade.box.columns();
    box.kernel = cascade.kernel;
    box.pressure = cascade.box_pressure;
    box.distance = cascade.box_distance;
    box.shares = cascade.box_shares;
    const std::vector<IterationBox> boxes{box};
    IterationRequest request;
    request.boxes = boxes;
    request.approach = approach;
    request.tolerance = 1e-8;
    largest_pressure_ = iteration.solve(request).largest_pressure;
    const ExteriorCheck exterior{cache_, single_, double_};
    return exterior.larger_box(problem_, 0, approach, tolerance_ * largest_pressure_);
  }

  double tolerance_ = 1e-4;
  double largest_pressure_ = 0.0;
  InfluenceCache cache_;
  ConvolutionWorkspace<float> single_;
  ConvolutionWorkspace<double> double_;
  ScaledProblem problem_;
};

TEST_F(ExteriorCheckTest, EnlargesTheBoxOverContactThatWasMissed) {
  const std::optional<ElementBox> box = check(0.2);
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->holds(11, 45));
  EXPECT_TRUE(box->holds(11, 14)) << "what it held before";
  EXPECT_LT(box->last_column, columns - 1) << "not the whole grid";
}

/// The first contact displaces the surface under the second body by a fifth of the approach: a body
/// that penetrates by less is not in contact.
TEST_F(ExteriorCheckTest, TakesDisplacementsIntoAccount) {
  for (const double tolerance : {1e-4, 1e-12}) { // in single and in double precision
    tolerance_ = tolerance;
    EXPECT_FALSE(check(0.95)) << tolerance;
    EXPECT_TRUE(check(0.5)) << tolerance;
  }
}

TEST_F(ExteriorCheckTest, FindsNothingWithoutPenetrationOutside) {
  EXPECT_FALSE(check(1.5));
}

} // namespace
} // namespace wrc::test::exterior_check_test
