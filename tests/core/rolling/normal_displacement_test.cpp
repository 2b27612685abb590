// What tractions open the gap by, against K/(pi G) times the integral of q.(x, y)/r^2.
#include "rolling/normal_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::normal_displacement_test {
namespace {

/// Tractions on one element, as seen from the others.
class NormalDisplacement : public testing::Test {
protected:
  NormalDisplacement() {
    problem_.grid = {9, 12, 0.5, 0.4, -2.0, -2.2};
    problem_.shear_modulus = 80000.0;
    problem_.difference_parameter = 0.15;
  }
  [[nodiscard]] std::size_t count() const { return problem_.grid.element_count(); }
  /// Midpoint rule on 60 x 60 pieces of the element under tractions.
  [[nodiscard]] double expected(std::size_t element, double qx, double qy) const {
    constexpr int pieces = 60;
    const Grid& grid = problem_.grid;
    const auto lateral = [&grid](std::size_t i) {
      return grid.lateral(i / grid.longitudinal_count);
    };
    const auto longitudinal = [&grid](std::size_t i) {
      return grid.longitudinal(i % grid.longitudinal_count);
    };
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
      for (int j = 0; j < pieces; ++j) {
        const double x = longitudinal(element) - longitudinal(loaded_) -
                         grid.longitudinal_step * ((j + 0.5) / pieces - 0.5);
        const double y =
            lateral(element) - lateral(loaded_) - grid.lateral_step * ((i + 0.5) / pieces - 0.5);
        sum += (qx * x + qy * y) / (x * x + y * y);
      }
    }
    return problem_.difference_parameter / (std::numbers::pi * problem_.shear_modulus) *
           grid.element_area() / (pieces * pieces) * sum;
  }
  [[nodiscard]] std::vector<double> opened_by(double qx, double qy) {
    std::vector<double> x(count(), 0.0);
    std::vector<double> y(count(), 0.0);
    x[loaded_] = qx;
    y[loaded_] = qy;
    return normal_displacement(problem_, x, y, plans_);
  }

  const std::size_t loaded_ = 3 * 12 + 4;
  RollingProblem problem_;
  LinePlans plans_;
};

TEST_F(NormalDisplacement, IsTheIntegralOverTheElement) {
  for (const auto& [qx, qy] :
       {std::pair{120.0, 0.0}, std::pair{0.0, 90.0}, std::pair{50.0, -70.0}}) {
    const std::vector<double> opened = opened_by(qx, qy);
    ASSERT_EQ(opened.size(), count());
    const double largest = *std::max_element(opened.begin(), opened.end());
    ASSERT_GT(largest, 0.0);
    for (std::size_t i = 0; i < count(); ++i) {
      EXPECT_NEAR(opened[i], expected(i, qx, qy), 1e-3 * largest) << i;
    }
  }
}

TEST_F(NormalDisplacement, IsZeroForLikeBodies) {
  problem_.difference_parameter = 0.0;
  for (const double opened : opened_by(120.0, 90.0)) {
    EXPECT_EQ(opened, 0.0);
  }
}

} // namespace
} // namespace wrc::test::normal_displacement_test
