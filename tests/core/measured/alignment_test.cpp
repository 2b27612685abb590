// Points are laid on the nominal profile they come from, however they were moved, worn or noisy.
#include "measured/alignment.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "profile/profile.hpp"

namespace wrc::test::alignment_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::vector<Position> points_on(const Curve& curve) {
  std::vector<Position> points;
  for (double arc = 0.0; arc < curve.length(); arc += 0.4) {
    const CurvePoint at = curve.at(arc);
    points.push_back({at.lateral, at.height});
  }
  return points;
}

/// The motion that takes points back from where another one put them.
void expect_inverse(const RigidMotion& found, const RigidMotion& other, double angle,
                    double distance) {
  EXPECT_NEAR(found.rotation, -other.rotation, angle);
  for (const Position& point : {Position{-60.0, 20.0}, Position{0.0, 0.0}, Position{60.0, -4.0}}) {
    const Position back = found.of(other.of(point));
    EXPECT_NEAR(back[0], point[0], distance);
    EXPECT_NEAR(back[1], point[1], distance);
  }
}

TEST(Alignment, TakesPointsBackToTheirCurve) {
  for (const char* name : {"S1002", "LMA", "60E1"}) {
    const Curve curve = standard_profile(name).curve;
    for (const RigidMotion& motion :
         {RigidMotion{0.0, {0.0, 0.0}}, RigidMotion{2.0 * degree, {0.8, -0.5}},
          RigidMotion{-1.0 * degree, {-1.5, 0.7}}}) {
      std::vector<Position> points = points_on(curve);
      for (Position& point : points)
        point = motion.of(point);
      const auto found = alignment_to(curve, points);
      ASSERT_TRUE(found) << name;
      expect_inverse(found->motion, motion, 1e-6, 1e-4);
      EXPECT_LT(found->deviation, 1e-4);
      EXPECT_GT(found->share, 0.99);
    }
  }
}

/// A hollow 60 mm wide and 2 mm deep, noise of 0.01 mm: ordinary least squares turn by 0.5 degrees.
TEST(Alignment, WornPartsDoNotCount) {
  const Curve curve = standard_profile("S1002").curve;
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 0.01);
  std::vector<Position> points = points_on(curve);
  const RigidMotion motion{1.0 * degree, {0.5, 0.3}};
  for (Position& point : points) {
    if (std::abs(point[0] - 5.0) < 30.0)
      point[1] -= 2.0 * std::pow(std::cos((point[0] - 5.0) / 60.0 * std::numbers::pi), 2);
    point = motion.of({point[0] + noise(engine), point[1] + noise(engine)});
  }
  const auto found = alignment_to(curve, points);
  ASSERT_TRUE(found);
  expect_inverse(found->motion, motion, 0.02 * degree, 0.05);
  EXPECT_GT(found->share, 0.5);
  EXPECT_LT(found->share, 0.85);
}

/// Laser scanners have an origin and axes of their own.
TEST(Alignment, PointsMayLieAnywhere) {
  for (const char* name : {"S1002", "60E1"}) {
    const Curve curve = standard_profile(name).curve;
    for (const RigidMotion& motion :
         {RigidMotion{0.0, {250.0, -300.0}}, RigidMotion{20.0 * degree, {-40.0, 90.0}},
          RigidMotion{-12.0 * degree, {3.0, 0.0}}}) {
      std::vector<Position> points = points_on(curve);
      for (Position& point : points)
        point = motion.of(point);
      const auto found = alignment_from_afar(curve, points);
      ASSERT_TRUE(found) << name;
      expect_inverse(found->motion, motion, 1e-6, 1e-4);
      EXPECT_GT(found->beside, 0.99);
    }
  }
}

TEST(Alignment, AStraightLineOrFewPointsDetermineNothing) {
  const Curve curve = standard_profile("S1002").curve;
  std::vector<Position> line;
  for (double y = 35.0; y < 59.0; y += 0.2)
    line.push_back({y, 1.364323640 - y / 15.0});
  EXPECT_FALSE(alignment_to(curve, line));
  EXPECT_FALSE(alignment_to(curve, std::vector<Position>(10, {0.0, 0.0})));
}

} // namespace
} // namespace wrc::test::alignment_test
