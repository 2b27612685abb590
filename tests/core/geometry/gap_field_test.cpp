/// The vertical distance of wheel and rail and its derivatives, against bisection and differences.
#include "geometry/gap_field.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"
#include "profile/standard_profiles.hpp"

namespace wrc::test::gap_field_test {
namespace {

double bisected(double low, double high, const std::function<double(double)>& rising) {
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (rising(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// z of the wheel's underside over a place, the centre at height 0: where its radius is met.
double wheel_height(const WheelSurface& wheel, const Pose& pose, double x, double y) {
  const Rotation rotation(pose);
  return bisected(-wheel.radius() - 60.0, -0.5 * wheel.radius(), [&](double z) {
    Vector3 body = rotation.to_body({x, y - pose.lateral, z});
    body.y -= wheel.taping_line();
    return wheel.radius() + wheel.over(body)->height - std::hypot(body.x, body.z);
  });
}

/// `slices`: none of a prismatic rail.
double rail_height(const RailSurface& rail, const SlicedSurface* slices, double x, double y) {
  if (slices == nullptr)
    return rail.graph().at_lateral(y).height;
  return bisected(-40.0, 20.0, [&](double z) {
    double lateral = 0.0;
    double height = 0.0;
    rail.to_profile_frame(y, z, lateral, height);
    return height - slices->over(rail.along() + x, lateral)->height;
  });
}

/// A crown whose radius and height vary along the track: waves of 60 and 35 mm.
SlicedProfile wavy_rail() {
  return profile_of(places_every(-120.0, 120.0, 2.0), [](double x) {
    return curve_of([&](double y) {
             return crown_at(y, 1.0 + 0.3 * std::sin(2.0 * std::numbers::pi * x / 60.0));
           })
        .moved(0.0, 0.0, 0.05 * std::cos(2.0 * std::numbers::pi * x / 35.0));
  });
}

struct Bodies {
  const char* name;
  WheelSurface wheel;
  RailSurface rail;
  std::shared_ptr<const SlicedSurface> slices{}; ///< of the rail
};

std::vector<Bodies> all_bodies() {
  const Profile s1002 = standard_profile("S1002");
  const WheelSurface round(s1002, wheelset);
  const WheelSurface wavy = wavy_wheel(s1002.curve, {{1, 0.5, 0.3}, {20, 0.01, -1.0}}, 0.7);
  const WheelSurface flat = wheel_of(
      flattened_cylinder(460.0, 0.2, 0.002, [](double t) { return rounded_depth(t, 0.9, 0.1); }),
      0.0304);
  TrackDimensions inclined = level_track;
  inclined.inclination = 0.025;
  const RailSurface level(standard_profile("60E1"), level_track);
  const auto slices = sliced_rail(wavy_rail(), 0.0);
  const RailSurface varying = rail_of(wavy_rail(), 3.31);
  const RailSurface turned = rail_of(wavy_rail(), -7.27, inclined, {0.3, -0.4, 0.015});
  return {{"round on constant", round, level},
          {"wavy on constant", wavy, level},
          {"flat on constant", flat, level},
          {"round on varying", round, varying, slices},
          {"wavy on varying", wavy, varying, slices},
          {"flat on inclined varying", flat, turned, slices},
          {"round on inclined varying", round, turned, slices},
          {"wavy on inclined varying", wavy, turned, slices}};
}

const std::vector<Pose> poses{
    {0.0, 0.0, 0.0}, {1.5, 0.0, 0.01}, {-2.0, 0.03, 0.0}, {0.7, -0.05, -0.02}};

TEST(GapField, IsTheDistanceOfBothSurfaces) {
  for (const Bodies& bodies : all_bodies())
    for (const Pose& pose : poses) {
      GapField field(bodies.wheel, bodies.rail, pose);
      for (const double x : {-40.0, -11.0, 0.0, 0.3, 25.0})
        for (const double y : {738.0, 746.3, 751.1, 765.0}) {
          const auto point = field.at(x, y);
          ASSERT_TRUE(point) << bodies.name << ' ' << x << ' ' << y;
          EXPECT_NEAR(point->rail.value, rail_height(bodies.rail, bodies.slices.get(), x, y), 1e-11)
              << bodies.name;
          EXPECT_NEAR(point->rail.value + point->gap.value, wheel_height(bodies.wheel, pose, x, y),
                      1e-11)
              << bodies.name << ' ' << x << ' ' << y;
        }
    }
}

/// Differences of the fourth order over 0.02 mm, away from knots along and joints across.
TEST(GapField, HasTheDerivativesOfDifferences) {
  constexpr double step = 0.02;
  for (const Bodies& bodies : all_bodies())
    for (const Pose& pose : poses) {
      GapField field(bodies.wheel, bodies.rail, pose);
      for (const double x : {-40.0, -11.0, 0.3, 25.0})
        for (const double y : {738.2, 746.3, 751.1, 763.3}) {
          const auto rate = [&](double Graph::*of, double dx, double dy) {
            const auto at = [&](double steps) {
              return field.at(x + steps * dx, y + steps * dy).value().gap.*of;
            };
            return (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
          };
          const Graph here = field.at(x, y).value().gap;
          const std::string where = std::string(bodies.name) + ' ' + std::to_string(x) + ' ' +
                                    std::to_string(y) + " yaw " + std::to_string(pose.yaw);
          EXPECT_NEAR(here.x, rate(&Graph::value, step, 0.0), 1e-10) << where;
          EXPECT_NEAR(here.y, rate(&Graph::value, 0.0, step), 1e-10) << where;
          EXPECT_NEAR(here.xx, rate(&Graph::x, step, 0.0), 1e-9) << where;
          EXPECT_NEAR(here.xy, rate(&Graph::y, step, 0.0), 1e-9) << where;
          EXPECT_NEAR(here.xy, rate(&Graph::x, 0.0, step), 1e-9) << where;
          EXPECT_NEAR(here.yy, rate(&Graph::y, 0.0, step), 1e-9) << where;
        }
    }
}

TEST(GapField, DoesNotDependOnWhatWasLookedUpBefore) {
  for (const Bodies& bodies : all_bodies()) {
    GapField field(bodies.wheel, bodies.rail, poses.back());
    const auto fresh = field.at(5.0, 751.0);
    (void)field.at(-60.0, 735.0);
    field.restart();
    const auto again = field.at(5.0, 751.0);
    EXPECT_EQ(fresh->gap.value, again->gap.value) << bodies.name;
    EXPECT_EQ(fresh->gap.xx, again->gap.xx) << bodies.name;
    (void)field.at(40.0, 735.0);
    EXPECT_NEAR(field.at(5.0, 751.0)->gap.value, fresh->gap.value, 1e-11) << bodies.name;
  }
}

TEST(GapField, HasNothingBesideTheBodies) {
  const RailSurface rail = rail_of(wavy_rail());
  const WheelSurface wheel(standard_profile("S1002"), wheelset);
  GapField field(wheel, rail, {});
  EXPECT_FALSE(field.at(0.0, 785.0)); // beside the rail
  EXPECT_FALSE(field.at(0.0, 715.0));
  EXPECT_FALSE(field.at(125.0, 750.0)); // beyond its end
  EXPECT_FALSE(field.at(-125.0, 750.0));
  EXPECT_TRUE(field.at(119.0, 750.0));
  GapField aside(wheel, rail, {95.0, 0.0, 0.0});
  EXPECT_FALSE(aside.at(0.0, 750.0)); // beside the wheel
}

} // namespace
} // namespace wrc::test::gap_field_test
