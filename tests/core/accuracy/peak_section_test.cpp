// Largest pressures from a section that is finer than the grid.
#include "accuracy/peak_section.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/solve_scene.hpp"

namespace wrc::test::peak_section_test {
namespace {

double pmax_of(Scene scene, AccuracyOf accuracy_of) {
  scene.side = SideChoice::left;
  scene.accuracy_of = accuracy_of;
  return solve_scene(scene).left->pmax;
}

double truth_of(Scene scene) {
  scene.accuracy = 1e-4;
  return pmax_of(scene, AccuracyOf::pressures);
}

/// A lobe of three rows beside another contact: its crest is 1534 MPa, of which the grid has 1213.
Scene narrow_lobe() {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "54E1";
  scene.lateral = 4.23077;
  scene.yaw = 0.008356;
  scene.left.load = scene.right.load = 44196.6;
  return scene;
}

TEST(PeakSection, FindsTheCrestOfALobeOfAFewRows) {
  Scene scene = narrow_lobe();
  const double truth = truth_of(scene);
  scene.grid = {{36, 17}};
  EXPECT_GT(std::abs(pmax_of(scene, AccuracyOf::forces) / truth - 1.0), 0.1);
  EXPECT_LT(std::abs(pmax_of(scene, AccuracyOf::pressures) / truth - 1.0), 0.02);
}

/// The pressure of a rolling contact without jumps of curvature is as smooth as a semi-ellipse.
TEST(PeakSection, DoesNotChangeSmoothPressures) {
  Scene scene;
  scene.lateral = -3.0;
  scene.grid = {{128, 64}};
  const double fitted = pmax_of(scene, AccuracyOf::forces);
  EXPECT_NEAR(pmax_of(scene, AccuracyOf::pressures), fitted, 1e-3 * fitted);
}

/// Its crest is narrower than a quarter of a row.
TEST(PeakSection, FindsACrestAtTheEdgeOnFewRows) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = "LMA";
  scene.left.rail.name = scene.right.rail.name = "CHN60";
  scene.back_to_back = 1353.0;
  scene.left.radius = scene.right.radius = 815.4107784831;
  scene.track.gauge_height = 16.0;
  scene.track.inclination = 0.0;
  scene.lateral = 5.9892175406659565;
  scene.left.load = scene.right.load = 39767.54751222384;
  scene.accuracy = 1e-2;
  const double truth = 686.97; // on 576 x 240 elements
  EXPECT_NEAR(pmax_of(scene, AccuracyOf::pressures), truth, 1e-2 * truth);
}

/// Where the contact ends on a sharp arc of the rail: its crest is a fifth of a millimetre wide.
TEST(PeakSection, FindsACrestOfFewStripsWhereTheRailTurns) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = "LM";
  scene.left.rail.name = scene.right.rail.name = "UIC60-Manchester";
  scene.left.radius = scene.right.radius = 450.0;
  scene.track.inclination = 0.025;
  scene.lateral = 3.6192200982044778; // the right wheel at -3.6
  scene.left.load = scene.right.load = 64433.208577515805;
  scene.accuracy = 1e-2;
  const double truth = 1000.60; // on 576 x 240 elements
  EXPECT_NEAR(pmax_of(scene, AccuracyOf::pressures), truth, 1e-2 * truth);
}

/// Two strips at the edge, 15 % higher than all others.
TEST(PeakSection, FindsACrestAtTheEdgeThatOtherPressuresDoNotIndicate) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = "LMA";
  scene.left.rail.name = scene.right.rail.name = "54E2";
  scene.back_to_back = 1353.0;
  scene.left.radius = scene.right.radius = 402.7779769569668;
  scene.track.inclination = 0.0;
  scene.lateral = 4.426819897021721;
  scene.yaw = -0.004348968964251736;
  scene.left.load = scene.right.load = 23702.825677801095;
  scene.accuracy = 1e-2;
  const double truth = 692.91; // on 576 x 240 elements
  EXPECT_NEAR(pmax_of(scene, AccuracyOf::pressures), truth, 1e-2 * truth);
}

/// A narrow crest that is resolved may not be lost again on more rows.
TEST(PeakSection, ConvergesWhereACrestIsNarrow) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = "LMA";
  scene.left.rail.name = scene.right.rail.name = "54E1";
  scene.back_to_back = 1353.0;
  scene.left.radius = scene.right.radius = 421.31234301340305;
  scene.track.inclination = 0.02499479361892016;
  scene.lateral = 6.181563264567742;
  scene.yaw = -0.008892087308720242;
  scene.left.load = scene.right.load = 31577.916208644896;
  const double truth = 676.48; // on 576 x 240 elements
  for (const double accuracy : {1e-2, 3e-3, 1e-3}) {
    scene.accuracy = accuracy;
    EXPECT_NEAR(pmax_of(scene, AccuracyOf::pressures), truth, std::max(accuracy, 2e-3) * truth);
  }
}

TEST(PeakSection, HandlesBothKindsOfElements) {
  Scene scene = narrow_lobe();
  const double truth = truth_of(scene);
  scene.grid = {{72, 33}};
  for (const Elements elements : {Elements::constant, Elements::smooth}) {
    scene.elements = elements;
    EXPECT_LT(std::abs(pmax_of(scene, AccuracyOf::pressures) / truth - 1.0), 0.02);
  }
}

/// A wedge of angle d has p = E* d/(2 pi) ln(1/x) near its tip (Johnson, Contact Mechanics, 1985,
/// eq. 5.28).
TEST(PeakSection, AWedgeGrowsWithTheLogarithmOfItsStrips) {
  EXPECT_NEAR(growth_at_ridge(0.01, 115e3), 115e3 * 0.01 / (2.0 * std::acos(-1.0)), 1e-9);
  EXPECT_EQ(growth_at_ridge(0.0, 115e3), 0.0);
}

/// A crest is as narrow on few rows as on many: strips over the contact are never fewer than a
/// number.
TEST(PeakSection, FewRowsHaveMoreStripsEach) {
  Patch patch;
  patch.contact.box.lateral_first = 3;
  for (const std::size_t rows : {2U, 4U, 15U, 40U, 200U}) {
    patch.contact.box.lateral_last = 3 + rows - 1;
    const double strips = strips_in_row(patch);
    EXPECT_GE(strips, strips_per_row);
    EXPECT_GE(strips * static_cast<double>(rows), min_strips);
    EXPECT_TRUE(strips == strips_per_row || strips * static_cast<double>(rows) == min_strips);
  }
}

} // namespace
} // namespace wrc::test::peak_section_test
