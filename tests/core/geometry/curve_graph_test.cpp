#include "geometry/curve_graph.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::curve_graph_test {
namespace {

TEST(CurveGraph, EndsWhereTheCurveTurnsUpright) {
  const Curve curve = circular_rail(300.0).curve;
  const CurveGraph graph(curve, arc_of_crown(curve));
  EXPECT_NEAR(graph.lateral_begin(), -35.0, 1e-9);
  EXPECT_NEAR(graph.lateral_end(), 35.0, 1e-9);
  EXPECT_TRUE(graph.covers(0.0));
  EXPECT_FALSE(graph.covers(35.1));
}

TEST(CurveGraph, MeetsTheCurveOverEveryLateral) {
  const Curve curve = circular_rail(300.0).curve;
  const CurveGraph graph(curve, arc_of_crown(curve));
  for (double lateral = -34.9; lateral < 35.0; lateral += 0.7) {
    double arc = 0.0;
    const CurvePoint point = graph.at_lateral(lateral, arc);
    const double height = std::sqrt(300.0 * 300.0 - lateral * lateral) - 300.0;
    EXPECT_NEAR(point.lateral, lateral, 1e-12);
    EXPECT_NEAR(point.height, height, 1e-10);
    EXPECT_NEAR(curve.at(arc).lateral, lateral, 1e-12);
    EXPECT_NEAR(graph.heights().at(lateral).height, height, 1e-10);
  }
  EXPECT_NEAR(graph.at_lateral(99.0).lateral, 35.0, 1e-9); // clamped
}

TEST(CurveGraph, HighestPointAndRidge) {
  const Curve crown = circular_rail(300.0).curve;
  EXPECT_NEAR(crown.at(arc_of_crown(crown)).lateral, 0.0, 1e-6);
  EXPECT_NEAR(CurveGraph(crown, arc_of_crown(crown)).sharpest_ridge(-30.0, 30.0), 0.0, 1e-6);
  // Flank of 60 degrees and tread: a valley seen from the flank, which is no ridge.
  const Curve flank = wheel_with_flank().curve;
  const CurveGraph graph(flank, 20.0 + 10.0);
  EXPECT_EQ(graph.sharpest_ridge(-39.0, 59.0), 0.0);
}

TEST(CurveGraph, RefusesASeedOnAnUprightSide) {
  EXPECT_THROW(CurveGraph(circular_rail(300.0).curve, 1.0), Error);
}

} // namespace
} // namespace wrc::test::curve_graph_test
