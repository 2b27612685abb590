/// The curve midway between wheel and rail, and distances along its normals, in closed form.
#include "remesh/mean_curve.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "remesh/rail_normals.hpp"
#include "remesh/row_scales.hpp"
#include "remesh/undeformed_distance.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::mean_curve_test {
namespace {

constexpr double wheel_radius = 460.0;
constexpr double crown = 60.0;
constexpr double axis = 717.5 + 35.0; // of a rail whose gauge face is 35 mm from it
constexpr double depth = 0.1;

/// A groove of this radius around the rolling circle.
Profile grooved_wheel(double radius) {
  constexpr double half_width = 30.0;
  const double rise = radius - std::sqrt(radius * radius - half_width * half_width);
  const std::array<Segment, 1> segments{Segment{
      "groove", ArcSegment{{{0.0, radius}}, radius, {{-half_width, rise}}, {{half_width, rise}}}}};
  return {"groove", ProfileKind::wheel, "", "", "", curve_of(segments)};
}

/// A rail of 60 mm in a groove of `groove` mm, lowered by `depth` from the first touch.
struct Grooved {
  explicit Grooved(double groove, double by = depth)
      : wheel(grooved_wheel(groove), {1360.0, 70.0, wheel_radius}),
        rail(circular_rail(crown), {1435.0, 14.0, 0.0}), pair{wheel,
                                                              rail,
                                                              {axis - 750.0, 0.0, 0.0},
                                                              wheel_radius - by},
        frame(tangent_frame({0.0, axis, 0.0}, 0.0)) {}
  WheelSurface wheel;
  RailSurface rail;
  PosedPair pair;
  ContactFrame frame;
};

TEST(MeanCurve, LiesMidwayBetweenBothSections) {
  const Grooved contact(70.0);
  const auto curve = mean_curve(contact.pair, contact.frame, -12.0, 14.0).curve;
  ASSERT_TRUE(curve);
  for (const double u : {-11.0, -2.5, 0.0, 6.0, 13.0}) {
    const double on_rail = std::sqrt(crown * crown - u * u) - crown;
    const double on_wheel = std::sqrt(70.0 * 70.0 - u * u) - 70.0 - depth;
    const ContactCurve::Point point = curve->at(curve->arc_over(u));
    EXPECT_NEAR(point.lateral, u, 1e-7);
    EXPECT_NEAR(point.height, 0.5 * (on_rail + on_wheel), 1e-7);
    const double slope = -0.5 * u * (1.0 / (on_rail + crown) + 1.0 / (on_wheel + 70.0 + depth));
    EXPECT_NEAR(point.sine / point.cosine, slope, 1e-5);
  }
}

/// How far a place is from a circle with its centre at a height, along a direction upwards.
double to_circle(const ContactCurve::Point& at, double centre, double radius) {
  const double up = at.cosine * (at.height - centre) - at.sine * at.lateral;
  const double apart = std::hypot(at.lateral, at.height - centre);
  return std::sqrt(up * up - (apart - radius) * (apart + radius)) - up;
}

TEST(MeanCurve, DistancesAreAlongItsNormals) {
  const Grooved contact(crown + 0.5);
  ContactFrame frame = contact.frame;
  frame.curve = mean_curve(contact.pair, frame, -14.0, 14.0).curve;
  ASSERT_TRUE(frame.curve);
  const Grid grid{15, 3, 1.8, 0.4, -12.6, -0.4};
  const RailNormals rail(contact.rail, frame, grid);
  const std::vector<double> distance = sample_undeformed_distance(contact.pair, frame, grid, &rail);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const ContactCurve::Point point = frame.curve->at(grid.lateral(row));
    const double on_rail = to_circle(point, -crown, crown);
    const double on_wheel = to_circle(point, -crown - 0.5 - depth, crown + 0.5);
    EXPECT_NEAR(distance[3 * row + 1], on_wheel - on_rail, 1e-9);
    EXPECT_NEAR(rail.height(row, 0), on_rail, 1e-9);
    // Both are inclined to the row by half the slope of the distance between them.
    const double slope = point.sine / point.cosine;
    const double u = point.lateral - on_rail * point.sine;
    const double of_rail = -u / std::sqrt(crown * crown - u * u);
    EXPECT_NEAR(rail.inclination(row), (of_rail - slope) / (1.0 + of_rail * slope), 1e-9);
    EXPECT_LT(std::abs(rail.inclination(row)), 2e-3);
  }
  const std::vector<double> again = sample_undeformed_distance(contact.pair, frame, grid);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    EXPECT_NEAR(again[i], distance[i], 1e-12);
  }
  for (const double scale : row_scales(contact.pair, frame, grid, rail)) {
    EXPECT_NEAR(scale, 1.0, 1e-9);
  }
}

TEST(MeanCurve, IsNoneBetweenACylinderAndAPlane) {
  const WheelSurface wheel(cylindrical_wheel(), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(inclined_rail(0.0), {1435.0, 14.0, 0.0});
  const PosedPair pair{wheel, rail, {}, wheel_radius - 0.05};
  const double y = rail.origin_y();
  const MeanCurve found = mean_curve(
      pair, tangent_frame({0.0, y, rail.graph().at_lateral(y).height}, 0.0), -10.0, 10.0);
  EXPECT_FALSE(found.curve);
  EXPECT_EQ(found.refusal, "");
}

TEST(MeanCurve, IsTakenInPart) {
  const Grooved contact(70.0);
  const auto whole = mean_curve(contact.pair, contact.frame, -12.0, 14.0).curve;
  const auto half = mean_curve(contact.pair, contact.frame, -12.0, 14.0, 0.5).curve;
  EXPECT_FALSE(mean_curve(contact.pair, contact.frame, -12.0, 14.0, 0.0).curve);
  for (const double u : {-11.0, 3.0}) {
    const ContactCurve::Point of_whole = whole->at(whole->arc_over(u));
    const ContactCurve::Point of_half = half->at(half->arc_over(u));
    EXPECT_NEAR(of_half.height, 0.5 * of_whole.height, 1e-7);
    EXPECT_NEAR(of_half.sine / of_half.cosine, 0.5 * of_whole.sine / of_whole.cosine, 1e-5);
  }
}

TEST(MeanCurve, IsRefusedWhereItsNormalsCrossWithinTheOverlap) {
  const Grooved contact(40.0, 30.0);
  EXPECT_TRUE(mean_curve(contact.pair, contact.frame, -8.0, 8.0).curve);
  const Grooved deep(40.0, 130.0);
  const MeanCurve crossing = mean_curve(deep.pair, deep.frame, -8.0, 8.0);
  EXPECT_FALSE(crossing.curve);
  EXPECT_NE(crossing.refusal.find("cross"), std::string::npos) << crossing.refusal;
  const MeanCurve missing = mean_curve(contact.pair, contact.frame, 300.0, 310.0);
  EXPECT_FALSE(missing.curve);
  EXPECT_NE(missing.refusal.find("fewer than two"), std::string::npos) << missing.refusal;
}

} // namespace
} // namespace wrc::test::mean_curve_test
