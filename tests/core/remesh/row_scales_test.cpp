// Scales of rows against closed forms, and the fields that are multiplied by them.
#include "remesh/row_scales.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/simple_profiles.hpp"

namespace wrc::test::row_scales_test {
namespace {

constexpr double wheel_radius = 460.0;
constexpr double axis = 717.5 + 35.0; // of a rail whose gauge face is 35 mm from it
constexpr double rounding = 1e-12;
const Grid grid{11, 5, 3.0, 2.0, -15.0, -4.0};

/// A wheel whose lower side rises to the field side by this angle.
Profile conical_wheel(double angle) {
  const double slope = -std::tan(angle);
  const std::array<Segment, 1> segments{
      Segment{"cone", LineSegment{{{-70.0, -70.0 * slope}}, {{60.0, 60.0 * slope}}}}};
  return {"cone", ProfileKind::wheel, "", "", "", curve_of(segments)};
}

/// Scales of a cone over a plane, which both rise by `angle`, in a frame that rises by another one.
std::vector<double> scales_of_cone(double angle, double frame_angle) {
  const WheelSurface wheel(conical_wheel(angle), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(inclined_rail(angle), {1435.0, 14.0, 0.0});
  const double y = rail.origin_y();
  const ContactFrame frame =
      tangent_frame({0.0, y, rail.graph().at_lateral(y).height}, frame_angle);
  const PosedPair pair{wheel, rail, {}, wheel_radius + 2.0};
  return row_scales(pair, frame, grid, RailNormals(rail, frame, grid));
}

TEST(RowScales, AreOneOnASurfaceParallelToThePlane) {
  for (const double angle : {0.0, 0.05}) {
    const std::vector<double> scales = scales_of_cone(angle, angle);
    ASSERT_EQ(scales.size(), grid.lateral_count);
    for (const double scale : scales) {
      EXPECT_NEAR(scale, 1.0, rounding) << angle;
    }
  }
}

TEST(RowScales, FollowTheCosineOfTheInclination) {
  for (const double inclination : {0.1, -0.1, 0.3}) {
    const std::vector<double> scales = scales_of_cone(0.05, 0.05 - inclination);
    ASSERT_EQ(scales.size(), grid.lateral_count);
    for (const double scale : scales) {
      EXPECT_NEAR(scale, std::pow(std::cos(inclination), 0.75), rounding) << inclination;
    }
  }
}

/// Where wheel and rail are not parallel, by the product of both inclinations, but not less than
/// 0: a cylinder over a crown of radius R, in a frame that is turned by an angle about the top of
/// the rail.
class RowScalesOfCrown : public testing::Test {
protected:
  static constexpr double crown_radius = 300.0;
  static constexpr double angle = 0.1;
  const WheelSurface wheel{cylindrical_wheel(), {1360.0, 70.0, wheel_radius}};
  const RailSurface rail{circular_rail(crown_radius), {1435.0, 14.0, 0.0}};
  const PosedPair pair{wheel, rail, {}, wheel_radius + 0.25};
};

TEST_F(RowScalesOfCrown, TakeTheProductOfInclinationsToOneSide) {
  const ContactFrame frame = tangent_frame({0.0, axis, 0.0}, angle);
  Grid wide = grid;
  wide.lateral_first = -33.0;
  wide.lateral_step = 6.0;
  const std::vector<double> scales = row_scales(pair, frame, wide, RailNormals(rail, frame, wide));
  ASSERT_EQ(scales.size(), wide.lateral_count);
  for (std::size_t row = 0; row < wide.lateral_count; ++row) {
    const double from_centre = wide.lateral(row) + crown_radius * std::sin(angle);
    const double of_rail =
        -from_centre / std::sqrt(crown_radius * crown_radius - from_centre * from_centre);
    const double of_wheel = -std::tan(angle);
    const double product = std::max(of_wheel * of_rail, 0.0);
    EXPECT_NEAR(scales[row], std::pow(1.0 + product, -0.375), rounding) << row;
  }
  EXPECT_EQ(scales.front(), 1.0); // inclined to opposite sides
  EXPECT_LT(scales.back(), 0.995);
}

TEST_F(RowScalesOfCrown, AreOneBesideWheelAndRail) {
  const ContactFrame frame = tangent_frame({0.0, axis, 0.0}, angle);
  Grid wide = grid;
  wide.lateral_first = -250.0;
  wide.lateral_step = 50.0;
  const std::vector<double> scales = row_scales(pair, frame, wide, RailNormals(rail, frame, wide));
  EXPECT_EQ(scales.front(), 1.0);
  EXPECT_EQ(scales.back(), 1.0);
  EXPECT_NE(scales[wide.lateral_count / 2], 1.0);
}

TEST_F(RowScalesOfCrown, AreAbsentWithTheVerticalConvention) {
  const ContactFrame frame = vertical_frame({0.0, axis, 0.0}, Rotation({0.0, 0.0, angle}));
  EXPECT_TRUE(row_scales(pair, frame, grid, RailNormals(rail, frame, grid)).empty());
}

TEST(RowScales, MultiplyingAndDividingAreInverse) {
  std::vector<double> scales(grid.lateral_count);
  std::vector<double> field(grid.element_count());
  for (std::size_t row = 0; row < scales.size(); ++row) {
    scales[row] = 0.7 + 0.05 * static_cast<double>(row);
  }
  for (std::size_t i = 0; i < field.size(); ++i) {
    field[i] = std::sin(1.0 + 0.7 * static_cast<double>(i));
  }
  const std::vector<double> times = times_scales(grid, scales, field);
  const std::vector<double> over = over_scales(grid, scales, field);
  const std::vector<double> back = over_scales(grid, scales, times);
  ASSERT_EQ(times.size(), field.size());
  ASSERT_EQ(over.size(), field.size());
  ASSERT_EQ(back.size(), field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double scale = scales[i / grid.longitudinal_count];
    EXPECT_DOUBLE_EQ(times[i], field[i] * scale) << i;
    EXPECT_DOUBLE_EQ(over[i], field[i] / scale) << i;
    EXPECT_DOUBLE_EQ(back[i], field[i]) << i;
  }
}

TEST(RowScales, FieldsAreUnchangedWithoutScalesAndEmptyFieldsStayEmpty) {
  const std::vector<double> scales(grid.lateral_count, 0.9);
  const std::vector<double> field(grid.element_count(), 2.5);
  EXPECT_EQ(times_scales(grid, {}, field), field);
  EXPECT_EQ(over_scales(grid, {}, field), field);
  EXPECT_TRUE(times_scales(grid, scales, {}).empty());
  EXPECT_TRUE(over_scales(grid, scales, {}).empty());
}

} // namespace
} // namespace wrc::test::row_scales_test
