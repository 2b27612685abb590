// A wheel that was measured with a tilt is turned back where its faces show it, or has a warning;
// wheels without a tilt have neither.
#include "measured/tilt.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "measured/alignment.hpp"
#include "samples.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::tilt_test {
namespace {

using namespace reading;

constexpr double degree = std::numbers::pi / 180.0;

enum class Faces { none, back, both };

/// S1002 every 0.4 mm, with faces 25 mm long, turned by an angle.
std::vector<Position> wheel(Faces faces, double angle, double noise = 0.0) {
  std::vector<Position> points;
  if (faces != Faces::none)
    for (double z = -16.0; z < 9.0; z += 0.4)
      points.push_back({-70.0, z});
  const Curve curve = standard_profile("S1002").curve;
  for (double arc = 0.2; arc < curve.length(); arc += 0.4) {
    const CurvePoint at = curve.at(arc);
    points.push_back({at.lateral, at.height});
  }
  if (faces == Faces::both)
    for (double z = -9.0; z > -34.0; z -= 0.4)
      points.push_back({65.0, z});
  std::mt19937 engine(3);
  std::normal_distribution<double> draw(0.0, noise > 0.0 ? noise : 1.0);
  const RigidMotion motion{angle, {0.0, 0.0}};
  for (Position& point : points) {
    if (noise > 0.0)
      point = {point[0] + draw(engine), point[1] + draw(engine)};
    point = motion.of(point);
  }
  return points;
}

ReadResult read(const std::vector<Position>& points, ReadOptions options = {}) {
  options.kind = ProfileKind::wheel;
  return profile_through(points, "wheel", options);
}

bool warns_of_tilt(const ReadResult& read) {
  return std::any_of(
      read.profile.warnings.begin(), read.profile.warnings.end(),
      [](const Warning& warning) { return warning.kind == WarningClass::profile_tilt; });
}

TEST(Tilt, FacesAreFoundWithTheirTilt) {
  for (const double angle : {0.0, 1.0 * degree, -0.4 * degree}) {
    const std::vector<Position> points = wheel(Faces::both, angle, 0.01);
    const auto back = flange_back_of(points);
    const auto face = field_face_of(points);
    ASSERT_TRUE(back && face);
    EXPECT_NEAR(back->tilt, angle, 0.03 * degree);
    EXPECT_NEAR(face->tilt, angle, 0.03 * degree);
    EXPECT_NEAR(back->length, 25.0, 3.0);
  }
  EXPECT_FALSE(flange_back_of(wheel(Faces::none, 0.0)));
  EXPECT_FALSE(field_face_of(wheel(Faces::back, 0.0)));
}

TEST(Tilt, ParallelFacesTurnTheWheelBack) {
  for (const double angle : {1.0 * degree, -0.8 * degree}) {
    const ReadResult result = read(wheel(Faces::both, angle));
    EXPECT_TRUE(says(result, "since flange back and field face are tilted by"));
    EXPECT_FALSE(warns_of_tilt(result));
    const auto found = alignment_to(standard_profile("S1002").curve, result.measured);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->motion.rotation, 0.0, 0.02 * degree);
    ReadOptions strict;
    strict.strict = true;
    EXPECT_THROW((void)read(wheel(Faces::both, angle), strict), Error);
    strict.rotation = -angle;
    EXPECT_NO_THROW((void)read(wheel(Faces::both, angle), strict));
  }
  EXPECT_FALSE(says(read(wheel(Faces::both, 0.05 * degree, 0.005)), "turned"));
  EXPECT_TRUE(says(read(wheel(Faces::both, 0.4 * degree, 0.005)), "not turned: flange back and"));
}

TEST(Tilt, OneFaceIsAWarning) {
  for (const double angle : {1.0 * degree, -1.0 * degree}) {
    const ReadResult result = read(wheel(Faces::back, angle));
    EXPECT_TRUE(warns_of_tilt(result));
    EXPECT_FALSE(says(result, "turned"));
  }
  EXPECT_FALSE(warns_of_tilt(read(wheel(Faces::back, 0.05 * degree))));
}

TEST(Tilt, WithoutFacesABuiltInWheelShowsIt) {
  for (const double angle : {1.0 * degree, -1.0 * degree, 0.3 * degree}) {
    const ReadResult result = read(wheel(Faces::none, angle, 0.005));
    ASSERT_TRUE(warns_of_tilt(result));
    ReadOptions strict;
    strict.strict = true;
    strict.smoothing_wavelength = automatic_smoothing;
    EXPECT_THROW((void)read(wheel(Faces::none, angle, 0.005), strict), Error);
  }
  EXPECT_FALSE(warns_of_tilt(read(wheel(Faces::none, 0.05 * degree, 0.005))));
}

/// Neither built-in wheels nor measured ones, whose flange backs have up to 0.53 degrees.
TEST(Tilt, WheelsThatAreNotTiltedHaveNoWarning) {
  for (const std::string_view name : standard_profile_names(ProfileKind::wheel)) {
    std::vector<Position> points;
    const Curve curve = standard_profile(name).curve;
    for (double arc = 0.0; arc < curve.length(); arc += 0.5)
      points.push_back({curve.at(arc).lateral, curve.at(arc).height});
    EXPECT_FALSE(warns_of_tilt(read(points))) << name;
  }
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  for (const char* name :
       {"Car7216_0001r", "Car7358_0001r", "S1002-Manchester", "avg_wheel", "circ_r100",
        "left-wheel-v1-pre-dry", "whl_left_iter288", "worn_high_mileage"}) {
    const ReadResult result =
        read_profile(reference_file(std::string("profiles/") + name + ".txt"), options);
    EXPECT_FALSE(warns_of_tilt(result)) << name;
    EXPECT_FALSE(says(result, "turned by")) << name;
  }
}

/// As a laser scanner may give them, which knows nothing of the wheel.
TEST(Tilt, PointsAnywhereAreAlignedToANominal) {
  ReadOptions options;
  options.align_to = "S1002";
  std::vector<Position> points = wheel(Faces::none, 20.0 * degree);
  for (Position& point : points)
    point = {point[0] - 40.0, point[1] + 90.0};
  const ReadResult aligned = read(points, options);
  const auto left = alignment_to(standard_profile("S1002").curve, aligned.measured);
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->motion.rotation, 0.0, 1e-5);
  EXPECT_LT(std::hypot(left->motion.shift[0], left->motion.shift[1]), 1e-3);
}

TEST(Tilt, AStatedRotationOrNominalReplacesTheSearch) {
  ReadOptions options;
  options.rotation = 0.0;
  EXPECT_FALSE(warns_of_tilt(read(wheel(Faces::none, degree), options)));
  options.rotation = -degree;
  const Curve nominal = standard_profile("S1002").curve;
  const auto turned = alignment_to(nominal, read(wheel(Faces::none, degree), options).measured);
  ASSERT_TRUE(turned);
  EXPECT_NEAR(turned->motion.rotation, 0.0, 1e-4);
  options.rotation.reset();
  options.align_to = "S1002";
  const ReadResult aligned = read(wheel(Faces::none, degree, 0.005), options);
  EXPECT_TRUE(says(aligned, "aligned to S1002: turned by -"));
  const auto left = alignment_to(nominal, aligned.measured);
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->motion.rotation, 0.0, 1e-5);
  EXPECT_FALSE(warns_of_tilt(aligned));
  options.align_to = "60E1";
  EXPECT_THROW((void)read(wheel(Faces::none, 0.0), options), Error);
  options.align_to = "no such wheel";
  EXPECT_THROW((void)read(wheel(Faces::none, 0.0), options), Error);
  options = {};
  options.rotation = 0.6;
  EXPECT_THROW((void)read(wheel(Faces::none, 0.0), options), Error);
}

} // namespace
} // namespace wrc::test::tilt_test
