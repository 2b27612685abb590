// How wide and long a contact is to its elements: on ellipses its axes, less with crests and askew.
#include "pressure/contact_scale.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::contact_scale_test {
namespace {

struct Ellipse {
  double y = 0.0;
  double half_width = 1.0;
  double half_length = 1.0;
  double skew = 0.0; ///< of x with y
};

/// Hertz's pressures on ellipses, on rows of 0.1 mm with second differences of neighbours.
ContactScale scale_of(std::initializer_list<Ellipse> ellipses) {
  const Grid grid{31, 2001, 0.25, 0.005, -3.75, -5.0};
  std::vector<double> pressure(grid.element_count());
  for (std::size_t element = 0; element < pressure.size(); ++element) {
    const double x = grid.longitudinal(element % grid.longitudinal_count);
    const double y = grid.lateral(element / grid.longitudinal_count);
    for (const Ellipse& one : ellipses) {
      const double u = (x - one.skew * y) / one.half_length;
      const double v = (y - one.y) / one.half_width;
      pressure[element] += std::sqrt(std::max(1.0 - u * u - v * v, 0.0));
    }
  }
  return contact_scale(grid, pressure);
}

TEST(ContactScale, OfAnEllipseIsItsAxes) {
  const ContactScale scale = scale_of({{.half_width = 2.0, .half_length = 3.0}});
  EXPECT_NEAR(scale.across, 4.0, 0.05 * 4.0);
  EXPECT_NEAR(scale.along, 6.0, 0.02);
}

/// The same on eight times as many rows: differences reach over as many more.
TEST(ContactScale, HardlyDependsOnTheGrid) {
  std::vector<double> widths;
  for (const std::size_t rows : {32u, 256u}) {
    const double step = 8.0 / static_cast<double>(rows);
    const Grid grid{rows, 1000, step, 0.01, -4.0 + 0.5 * step, -5.0};
    std::vector<double> pressure(grid.element_count());
    for (std::size_t element = 0; element < pressure.size(); ++element) {
      const double x = grid.longitudinal(element % grid.longitudinal_count);
      const double y = grid.lateral(element / grid.longitudinal_count);
      pressure[element] = std::sqrt(std::max(1.0 - x * x - y * y / 4.0, 0.0));
    }
    widths.push_back(contact_scale(grid, pressure).across);
  }
  EXPECT_NEAR(widths[1], widths[0], 0.05 * widths[0]);
}

/// Side by side: as wide as one of them, since each has half of the force.
TEST(ContactScale, TwoLobesCountAsWideAsOne) {
  const ContactScale scale = scale_of({{.y = -2.0}, {.y = 2.0}});
  EXPECT_NEAR(scale.across, 2.0, 0.08 * 2.0);
  EXPECT_NEAR(scale.along, 2.0, 0.02);
}

/// Lines of 2 mm in a contact that is sqrt(2) times as long; across, lines of sqrt(2) mm in one
/// that is 2 mm wide.
TEST(ContactScale, OfStaggeredLinesIsThatOfTheLines) {
  const ContactScale scale = scale_of({{.skew = 1.0}});
  EXPECT_NEAR(scale.across, std::sqrt(2.0), 0.09 * std::sqrt(2.0));
  EXPECT_NEAR(scale.along, 2.0, 0.02);
}

/// A single element has its own size: sqrt(24/4) of its width, sqrt(20/12) of its length.
TEST(ContactScale, OfOneElement) {
  const Grid grid{3, 5, 0.2, 0.3, 0.0, 0.0};
  std::vector<double> pressure(15, 0.0);
  pressure[7] = 10.0;
  const ContactScale scale = contact_scale(grid, pressure);
  EXPECT_NEAR(scale.across, std::sqrt(6.0) * 0.2, 1e-12);
  EXPECT_NEAR(scale.along, std::sqrt(20.0 / 12.0) * 0.3, 1e-12);
}

} // namespace
} // namespace wrc::test::contact_scale_test
