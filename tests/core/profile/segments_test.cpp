/// Segments to curves: accuracy inside the pieces, junctions, errors.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/segments.hpp"

namespace wrc::test::segments_test {
namespace {

/// What segments.hpp promises.
constexpr double position_promise = 1e-11;
constexpr double curvature_promise = 1e-8;

std::string refusal_of(const std::vector<Segment>& segments) {
  try {
    (void)curve_of(segments);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "accepted";
}

TEST(Segments, LineIsExact) {
  const Curve curve = curve_of(std::vector<Segment>{{"side", LineSegment{{1.0, 2.0}, {4.0, 6.0}}}});
  EXPECT_DOUBLE_EQ(curve.length(), 5.0);
  for (double s = 0.0; s <= 5.0; s += 0.13) {
    EXPECT_NEAR(curve.at(s).lateral, 1.0 + 0.6 * s, position_promise);
    EXPECT_NEAR(curve.at(s).height, 2.0 + 0.8 * s, position_promise);
    EXPECT_NEAR(curve.at(s).curvature(), 0.0, 1e-12);
  }
}

TEST(Segments, ArcHasItsRadiusAndLengthOnBothSides) {
  for (const double radius : {3.0, 12.0, 500.0}) {
    for (const double side : {1.0, -1.0}) { // valley, crest
      const ArcSegment arc{{1.0, side * radius},
                           radius,
                           {1.0 - 0.6 * radius, side * 0.2 * radius},
                           {1.0 + 0.6 * radius, side * 0.2 * radius}};
      const Curve curve = curve_of(std::vector<Segment>{{"arc", arc}});
      EXPECT_NEAR(curve.length(), 2.0 * std::asin(0.6) * radius, 1e-12 * radius);
      for (double s = 0.0; s <= curve.length(); s += curve.length() / 997.0) {
        const CurvePoint point = curve.at(s);
        EXPECT_NEAR(std::hypot(point.lateral - 1.0, point.height - side * radius), radius,
                    position_promise);
        EXPECT_NEAR(point.curvature() * radius, side, curvature_promise);
      }
    }
  }
}

TEST(Segments, PolynomialMeetsItsGraphAndArcLength) {
  // A parabola has a closed arc length: (a sqrt(1 + a^2) + asinh a) / (4 c) with a = 2 c u.
  const double c = 0.03;
  const PolynomialSegment parabola{{1.0, 0.0, c}, 5.0, -5.0, 25.0};
  const Curve curve = curve_of(std::vector<Segment>{{"parabola", parabola}});
  const auto primitive = [c](double u) {
    const double a = 2.0 * c * u;
    return (a * std::sqrt(1.0 + a * a) + std::asinh(a)) / (4.0 * c);
  };
  EXPECT_NEAR(curve.length(), primitive(20.0) - primitive(-10.0), position_promise);
  for (double s = 0.0; s <= curve.length(); s += 0.0371) {
    const CurvePoint point = curve.at(s);
    const double u = point.lateral - 5.0;
    EXPECT_NEAR(point.height, 1.0 + c * u * u, position_promise);
    EXPECT_NEAR(primitive(u) - primitive(-10.0), s, 2.0 * position_promise);
    EXPECT_NEAR(point.curvature(), 2.0 * c / std::pow(1.0 + 4.0 * c * c * u * u, 1.5),
                curvature_promise * 2.0 * c);
  }
}

TEST(Segments, NodesAreCloseTogether) {
  const PolynomialSegment steep{{0.0, 3.0}, 0.0, 0.0, 10.0};
  const Curve curve = curve_of(std::vector<Segment>{{"steep", steep}});
  for (std::size_t i = 0; i < curve.piece_count(); ++i)
    EXPECT_LE(curve.starts()[i + 1] - curve.starts()[i], max_node_distance + 1e-12);
}

TEST(Segments, JunctionsReportGapAndKink) {
  const std::vector<Segment> segments = {
      {"flat", LineSegment{{0.0, 0.0}, {1.0, 0.0}}},
      {"rise", LineSegment{{1.0, 5e-4}, {2.0, 1.0 + 5e-4}}},
      {"fall", LineSegment{{2.0, 1.0 + 5e-4}, {3.0, 5e-4}}},
  };
  const std::vector<Junction> junctions = junctions_of(segments);
  ASSERT_EQ(junctions.size(), 2U);
  EXPECT_EQ(junctions[0].before, "flat");
  EXPECT_EQ(junctions[0].after, "rise");
  EXPECT_NEAR(junctions[0].gap, 5e-4, 1e-15);
  EXPECT_NEAR(junctions[0].kink, std::numbers::pi / 4.0, 1e-15);
  EXPECT_EQ(junctions[1].lateral, 2.0);
  EXPECT_EQ(junctions[1].gap, 0.0);
  EXPECT_NEAR(junctions[1].kink, -std::numbers::pi / 2.0, 1e-15);
}

TEST(Segments, MirroredHalfIsSymmetric) {
  const std::vector<Segment> half = {
      {"crown", PolynomialSegment{{0.0, 0.0, -0.01, -0.001}, 0.0, 0.0, 6.0}},
      {"shoulder", PolynomialSegment{{-0.576, -0.228, -0.01}, 6.0, 6.0, 9.0}},
  };
  const Curve curve = curve_of(with_mirrored_half(half));
  for (double s = 0.0; s < curve.length(); s += 0.07) {
    const CurvePoint left = curve.at(s);
    const CurvePoint right = curve.at(curve.length() - s);
    EXPECT_NEAR(left.lateral, -right.lateral, position_promise);
    EXPECT_NEAR(left.height, right.height, position_promise);
  }
}

TEST(Segments, RefusesGapsAndNamesTheSegments) {
  const std::string text = refusal_of({{"first", LineSegment{{0.0, 0.0}, {1.0, 0.0}}},
                                       {"second", LineSegment{{1.0, 2e-3}, {2.0, 0.0}}}});
  EXPECT_NE(text.find("'first' and 'second'"), std::string::npos) << text;
  EXPECT_NE(text.find("0.001"), std::string::npos) << text;
}

TEST(Segments, RefusesBadShapes) {
  EXPECT_EQ(refusal_of({{"line", LineSegment{{0.0, 0.0}, {1.0, 0.0}}}}), "accepted");
  EXPECT_NE(refusal_of({}), "accepted");
  EXPECT_NE(refusal_of({{"line", LineSegment{{1.0, 0.0}, {1.0, 0.0}}}}), "accepted");
  EXPECT_NE(refusal_of({{"line", LineSegment{{1.0, 0.0}, {NAN, 0.0}}}}), "accepted");
  EXPECT_NE(refusal_of({{"arc", ArcSegment{{0.0, 0.0}, -1.0, {1.0, 0.0}, {0.0, 1.0}}}}),
            "accepted");
  EXPECT_NE(refusal_of({{"arc", ArcSegment{{0.0, 0.0}, 1.0, {1.0, 0.0}, {0.0, 1.1}}}}), "accepted");
  EXPECT_NE(refusal_of({{"arc", ArcSegment{{0.0, 0.0}, 1.0, {1.0, 0.0}, {1.0, 0.0}}}}), "accepted");
  EXPECT_NE(refusal_of({{"polynomial", PolynomialSegment{{}, 0.0, 0.0, 1.0}}}), "accepted");
  EXPECT_NE(refusal_of({{"polynomial", PolynomialSegment{{1.0}, 0.0, 1.0, 0.0}}}), "accepted");
}

} // namespace
} // namespace wrc::test::segments_test
