#include "geometry/height_function.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::height_function_test {
namespace {

/// The table is built to 1e-12 mm along the normal; positions of some hundred mm carry 1e-13.
constexpr double normal_tolerance = 2e-12;
/// Newton's method on the curve leaves 1e-9 of a piece squared; what is steep multiplies rounding.
constexpr double angle_tolerance = 1e-9;

void expect_table_meets_curve(const CurveGraph& graph, std::string_view name) {
  const Curve& curve = graph.curve();
  for (std::size_t piece = graph.first_piece(); piece < graph.first_piece() + graph.piece_count();
       ++piece) {
    const double length = curve.starts()[piece + 1] - curve.starts()[piece];
    for (double share = 0.03; share < 1.0; share += 0.07) {
      const CurvePoint point = curve.at(piece, share * length);
      const HeightPoint table = graph.heights().at(point.lateral);
      EXPECT_NEAR((table.height - point.height) * point.tangent_lateral, 0.0, normal_tolerance)
          << name << ' ' << point.lateral;
      EXPECT_NEAR(std::atan(table.slope), std::atan(point.slope()), angle_tolerance)
          << name << ' ' << point.lateral;
    }
  }
}

TEST(HeightFunction, MeetsTheCurveOfAllBuiltInProfiles) {
  for (const auto name : standard_profile_names(ProfileKind::wheel)) {
    const WheelSurface wheel(standard_profile(name), {1360.0, 70.0, 460.0});
    expect_table_meets_curve(wheel.graph(), name);
  }
  for (const auto name : standard_profile_names(ProfileKind::rail)) {
    const RailSurface rail(standard_profile(name), {1435.0, 14.0, std::atan(0.025)});
    expect_table_meets_curve(rail.graph(), name);
  }
}

TEST(HeightFunction, FindsThePieceOfAnyPosition) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const HeightFunction& heights = wheel.graph().heights();
  const auto pieces = heights.pieces();
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    ASSERT_LT(pieces[piece].start, pieces[piece].end);
    EXPECT_EQ(heights.piece_at(pieces[piece].start), piece);
    EXPECT_EQ(heights.piece_at(0.5 * (pieces[piece].start + pieces[piece].end)), piece);
  }
  EXPECT_EQ(heights.piece_at(-1e6), 0u);
  EXPECT_EQ(heights.piece_at(1e6), pieces.size() - 1);
  EXPECT_EQ(heights.piece_at(std::numeric_limits<double>::quiet_NaN()), 0u);
}

TEST(HeightFunction, IsConstantBeyondTheEnds) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const HeightFunction& heights = wheel.graph().heights();
  EXPECT_EQ(heights.at(heights.end() + 5.0).height, heights.at(heights.end()).height);
  EXPECT_EQ(heights.at(heights.begin() - 5.0).height, heights.at(heights.begin()).height);
  EXPECT_FALSE(heights.covers(heights.end() + 1e-9));
  EXPECT_TRUE(heights.covers(heights.begin()));
}

TEST(HeightFunction, KinkKeepsItsTwoSlopes) {
  // Lines are met exactly, and no polynomial reaches across their joint.
  const WheelSurface wheel(wheel_with_flank(), {1360.0, 70.0, 460.0});
  const HeightFunction& heights = wheel.graph().heights();
  EXPECT_NEAR(heights.at(-30.0 - 1e-9).slope, -std::sqrt(3.0), 1e-11);
  EXPECT_NEAR(heights.at(-30.0 + 1e-9).slope, 0.0, 1e-11);
  EXPECT_NEAR(heights.at(-31.0).height, std::sqrt(3.0), 1e-12);
}

TEST(HeightFunction, AStepIsKept) {
  // S1002: the rounding of its coefficients leaves a step between two zones, as the curve has it.
  const Profile& profile = standard_profile("S1002");
  const CurveGraph graph(profile.curve, 0.5 * profile.curve.length());
  const Curve& curve = graph.curve();
  double largest = 0.0;
  for (std::size_t piece = graph.first_piece();
       piece + 1 < graph.first_piece() + graph.piece_count(); ++piece) {
    const double length = curve.starts()[piece + 1] - curve.starts()[piece];
    const double step = curve.at(piece + 1, 0.0).height - curve.at(piece, length).height;
    const double lateral = curve.at(piece + 1, 0.0).lateral;
    constexpr double beside = 1e-12;
    const double slope = graph.heights().at(lateral).slope;
    EXPECT_NEAR(graph.heights().at(lateral + beside).height -
                    graph.heights().at(lateral - beside).height,
                step, 1e-11 * (1.0 + std::abs(slope)))
        << lateral;
    largest = std::max(largest, std::abs(step));
  }
  EXPECT_GT(largest, 1e-4);
}

} // namespace
} // namespace wrc::test::height_function_test
