/// A curve across the rail against arcs of circles.
#include "patches/contact_curve.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "patches/contact_frame.hpp"

namespace wrc::test::contact_curve_test {
namespace {

constexpr double radius = 13.0;
/// Pieces of 0.2 mm leave h^4 / 384 of the fourth derivative, and h^4 / 2880 of the arc's.
constexpr double interpolation = 1e-7;

/// A convex arc with its top at 0, to both sides by `half` mm of the plane.
ContactCurve arc_of_circle(double half, std::size_t pieces) {
  std::vector<ContactCurve::Node> nodes;
  for (std::size_t i = 0; i <= pieces; ++i) {
    const double u = half * (2.0 * static_cast<double>(i) / static_cast<double>(pieces) - 1.0);
    const double v = std::sqrt(radius * radius - u * u);
    nodes.push_back({u, v - radius, -u / v});
  }
  return ContactCurve(nodes);
}

TEST(ContactCurve, FollowsACircleByItsArc) {
  const ContactCurve curve = arc_of_circle(7.0, 70);
  for (const double arc : {-7.0, -3.21, 0.0, 0.05, 2.0, 6.9}) {
    const ContactCurve::Point point = curve.at(arc);
    const double angle = arc / radius;
    EXPECT_NEAR(point.lateral, radius * std::sin(angle), interpolation) << arc;
    EXPECT_NEAR(point.height, radius * (std::cos(angle) - 1.0), interpolation) << arc;
    EXPECT_NEAR(std::atan2(point.sine, point.cosine), -angle, 1e-5) << arc;
    EXPECT_NEAR(curve.curvature(arc), -1.0 / radius, 1e-5) << arc;
    EXPECT_NEAR(curve.arc_over(point.lateral), arc, interpolation) << arc;
  }
}

TEST(ContactCurve, GoesOnStraightBeyondItsEnds) {
  const ContactCurve curve = arc_of_circle(5.0, 50);
  const double end = curve.arc_over(5.0);
  const ContactCurve::Point last = curve.at(end);
  for (const double beyond : {0.5, 30.0}) {
    const ContactCurve::Point point = curve.at(end + beyond);
    EXPECT_NEAR(point.lateral, last.lateral + beyond * last.cosine, 1e-12);
    EXPECT_NEAR(point.height, last.height + beyond * last.sine, 1e-12);
    EXPECT_EQ(point.sine, last.sine);
    EXPECT_NEAR(curve.arc_over(point.lateral), end + beyond, 1e-9);
    EXPECT_EQ(curve.curvature(end + beyond), 0.0);
  }
}

TEST(ContactCurve, IsTheSameFromAnotherOrigin) {
  const ContactCurve curve = arc_of_circle(7.0, 70);
  const ContactCurve moved = curve.seen_from(2.0, -0.3);
  EXPECT_NEAR(moved.arc_over(0.0), 0.0, 1e-12);
  const double apart = curve.arc_over(2.0);
  for (const double arc : {-4.0, 0.0, 1.5}) {
    EXPECT_NEAR(moved.at(arc).lateral, curve.at(arc + apart).lateral - 2.0, 1e-12);
    EXPECT_NEAR(moved.at(arc).height, curve.at(arc + apart).height + 0.3, 1e-12);
    EXPECT_NEAR(moved.at(arc).sine, curve.at(arc + apart).sine, 1e-12);
  }
}

TEST(ContactCurve, RowsOfAFrameStandOnIt) {
  ContactFrame frame = tangent_frame({0.0, 750.0, -1.0}, 0.2);
  const Grid grid{9, 3, 1.0, 1.0, -4.0, -1.0};
  EXPECT_TRUE(row_angles(frame, grid).empty());
  frame.curve = std::make_shared<const ContactCurve>(arc_of_circle(7.0, 70));
  const std::vector<double> angles = row_angles(frame, grid);
  ASSERT_EQ(angles.size(), 9u);
  const Vector3 centre = frame.origin - radius * frame.normal;
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(angles[i], -grid.lateral(i) / radius, 1e-5);
    // All normals of a circle go through its centre.
    const Vector3 above = frame.to_track(0.0, grid.lateral(i), 2.0) - centre;
    EXPECT_NEAR(norm(above), radius + 2.0, 1e-6);
    EXPECT_NEAR(frame.lateral_of(frame.row_at(grid.lateral(i)).place), grid.lateral(i), 1e-6);
  }
}

} // namespace
} // namespace wrc::test::contact_curve_test
