/// Sensitivities of a side against central differences of the whole way: contact search, planes,
/// areas, grids and pressures anew at each position, with the height prescribed.
///
/// They cannot agree to more than the grid allows: its elements follow the contact, while the
/// sensitivity is that of the elements as they are, which also shows as scatter between steps.
/// Besides, it leaves out what a turning plane changes in gaps and areas and that the boundary
/// between two patches moves, which matters where they are about to join.
#include "derivatives/wheel_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ostream>

#include <gtest/gtest.h>

#include "geometry/contact_search.hpp"
#include "scene/solve_scene.hpp"
#include "support/simple_profiles.hpp"
#include "support/varying_contact.hpp"

namespace wrc::test::wheel_rates_test {
namespace {

/// Distance of the wheelset's centre from the contact, mm: a turn moves it by so much more.
constexpr double arm = 750.0;
/// Of the differences: in mm, and of the depth at the most.
constexpr double longest_step = 2e-3;
constexpr double step_share = 0.03;

struct Case {
  const char* name;
  const char* wheel;
  const char* rail;
  double lateral;
  double roll = 0.0;
  double yaw = 0.0;
  /// Of the largest rate. Seen: 2e-4 to 3e-3.
  double tolerance = 5e-3;
  GapConvention gap = GapConvention::tangent;
  Interaction interaction = Interaction::all;
  std::size_t patches = 1;
  double load = 80000.0;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

constexpr SolverOptions in_double{.precision = Precision::double_only};

/// At the height that the usual load asks for.
Scene scene_of(const Case& c) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = c.wheel;
  scene.left.rail.name = scene.right.rail.name = c.rail;
  scene.back_to_back = scene.left.wheel.name == "LMA" ? 1353.0 : 1360.0;
  scene.lateral = c.lateral;
  scene.roll = c.roll;
  scene.yaw = c.yaw;
  scene.gap = c.gap;
  scene.interaction = c.interaction;
  scene.left.load = c.load;
  scene.side = SideChoice::left;
  scene.grid = {{96, 96}};
  scene.tolerance = 1e-10;
  const SceneResult under_load = solve_scene(scene, in_double);
  scene.vertical = under_load.left->vertical - under_load.left->depth;
  return scene;
}

class SideSensitivities : public testing::TestWithParam<Case> {};

TEST_P(SideSensitivities, AreThoseOfTheWholeScene) {
  const Case& c = GetParam();
  const Scene scene = scene_of(c);
  SceneResult here = solve_scene(scene, in_double);
  ASSERT_EQ(solved_patches(*here.left).size(), c.patches);
  const std::optional<WheelRates> rates = wheel_rates_of(*here.left);
  ASSERT_TRUE(rates);

  const std::array<Vector3, 4> found{rates->force.lateral.force, rates->force.vertical.force,
                                     (1.0 / arm) * rates->force.roll.force,
                                     (1.0 / arm) * rates->force.yaw.force};
  double largest = 0.0;
  for (const Vector3& rate : found) {
    largest = std::max({largest, std::abs(rate.y), std::abs(rate.z)});
  }
  const double step = std::min(longest_step, step_share * here.left->depth);
  for (std::size_t motion = 0; motion < 4; ++motion) {
    Vector3 forces[2];
    for (const int end : {0, 1}) {
      Scene moved = scene;
      const double by = end == 0 ? -step : step;
      if (motion == 0) {
        moved.lateral += by;
      } else if (motion == 1) {
        *moved.vertical += by;
      } else if (motion == 2) {
        *moved.roll += by / arm;
      } else {
        moved.yaw += by / arm;
      }
      forces[end] = solve_scene(moved, in_double).left->force;
    }
    const Vector3 difference = (0.5 / step) * (forces[1] - forces[0]);
    EXPECT_NEAR(found[motion].y, difference.y, c.tolerance * largest) << motion;
    EXPECT_NEAR(found[motion].z, difference.z, c.tolerance * largest) << motion;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Positions, SideSensitivities,
    testing::Values(
        Case{"middle", "S1002", "60E1", 0.0}, Case{"outwards", "S1002", "60E1", -3.0},
        Case{"yawed", "S1002", "60E1", 1.0, 0.0, 0.02}, Case{"two lobes", "S1002", "60E1", 3.0},
        Case{"flange root", "S1002", "60E1", 5.6}, Case{"flange", "S1002", "60E1", 6.8, 1e-3},
        Case{"yawed flange", "S1002", "60E1", 6.5, 1e-3, 0.03},
        Case{"Manchester two lobes", "S1002", "UIC60-Manchester", 5.0, 4e-4},
        Case{"LMA", "LMA", "CHN60", 4.0}, Case{"LMA flange", "LMA", "CHN60", 9.0, 1e-3},
        Case{"vertical gaps", "S1002", "60E1", 2.0, 2e-3, 0.0, 5e-3, GapConvention::vertical},
        Case{"yawed vertical gaps", "S1002", "60E1", 2.0, 2e-3, 0.02, 5e-3,
             GapConvention::vertical},
        Case{"turned to a neighbour", "S1002", "60E1", 4.1, 1e-3},
        Case{"two patches", "S1002", "60E1", 6.4, 0.0, 0.02, 5e-3, GapConvention::tangent,
             Interaction::near, 2},
        // Elements stay in place.
        Case{"two patches that interact", "S1002", "60E1", 6.4, 0.0, 0.02, 6e-3,
             GapConvention::tangent, Interaction::all, 2},
        Case{"planes turned by distance", "S1002", "UIC60-Manchester", 5.0, 0.0, 0.0, 5e-3,
             GapConvention::tangent, Interaction::all, 2, 1000.0},
        Case{"parts of one contact", "S1002", "UIC60-Manchester", 5.0, 0.0, 0.0, 5e-3,
             GapConvention::tangent, Interaction::all, 2, 10000.0},
        // Planes that turn by 7 rad/mm, and contact that ends where the neighbour's begins: 7e-2.
        Case{"two patches that join", "S1002", "60E1", 6.5, 0.0, 0.02, 0.1, GapConvention::tangent,
             Interaction::all, 2}),
    [](const testing::TestParamInfo<Case>& tested) {
      std::string name = tested.param.name;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

/// A crown that ends at a lateral coordinate, without a side.
Profile crown_until(double end) {
  constexpr double begin = -35.0;
  const auto height = [](double y) { return std::sqrt(crown * crown - y * y) - crown; };
  const std::array<Segment, 1> segments{Segment{
      "crown", ArcSegment{{{0.0, -crown}}, crown, {{begin, height(begin)}}, {{end, height(end)}}}}};
  return {"crown", ProfileKind::rail, "", "", "", curve_of(segments)};
}

/// Where a rail ends within the contact, there is no distance beyond the end.
TEST(SideSensitivitiesAtTheEndOfARail, AreThoseOfTheWholeScene) {
  constexpr double tolerance = 0.03; // of the rate
  for (const double end : {2.0, 0.0, -1.0}) {
    const LeftBodies bodies(WheelSurface(cylindrical_wheel(), wheelset),
                            RailSurface(crown_until(end), level_track));
    WheelRequest request = under_load(80000.0, AccuracyOf::forces);
    const WheelResult under = solve_left(bodies, request);
    EXPECT_NEAR(under.patches.front().approach, under.depth, 0.05 * under.depth) << end;
    request.vertical_load.reset();
    const double height = under.vertical - under.depth;
    const auto solved_at = [&](double by) {
      request.vertical = height + by;
      return solve_left(bodies, request);
    };
    const std::optional<WheelRates> rates = wheel_rates_of(solved_at(0.0));
    ASSERT_TRUE(rates) << end;
    const double difference =
        (solved_at(longest_step).force.z - solved_at(-longest_step).force.z) / (2.0 * longest_step);
    EXPECT_NEAR(rates->force.vertical.force.z, difference, tolerance * std::abs(difference)) << end;
  }
}

/// Rows of elements pass the end of a part as the contact moves, and forces jump by the pressures
/// there. What counts is the slope of a straight line through many jumps, so elements do not follow
/// the contact but stay where the end is.
TEST(SideSensitivitiesAtTheEndOfARail, AreThoseOfElementsThatStayWhereItVaries) {
  constexpr double tolerance = 0.05; // of it
  constexpr int steps = 20;          // to each side
  for (const double end : {2.0, 0.0, -1.0}) {
    const Curve section = crown_until(end).curve;
    const LeftBodies bodies(
        WheelSurface(cylindrical_wheel(), wheelset),
        rail_of(profile_of(places_every(-100.0, 100.0, 50.0), [&](double) { return section; })));
    WheelRequest request = under_load(80000.0, AccuracyOf::forces);
    const WheelResult under = solve_left(bodies, request);
    request.vertical_load.reset();
    const auto solved_at = [&](double by) {
      request.vertical = under.vertical - under.depth + by;
      return solve_left(bodies, request);
    };
    const std::optional<WheelRates> rates = wheel_rates_of(solved_at(0.0));
    ASSERT_TRUE(rates) << end;
    double products = 0.0;
    double squares = 0.0;
    for (int i = -steps; i <= steps; ++i) {
      const double by = 0.1 * under.depth * i / steps;
      products += by * solved_at(by).force.z;
      squares += by * by;
    }
    const double slope = products / squares;
    EXPECT_NEAR(rates->force.vertical.force.z, slope, tolerance * std::abs(slope)) << end;
  }
}

/// A crown turned about the vertical axis through the track's middle, by slices.
LeftBodies on_turned_crown(const WheelSurface& wheel, double angle) {
  const double cosine = std::cos(angle);
  const Curve section = curve_of([cosine](double y) {
    const Height height = crown_at(cosine * y);
    return Height{height.value, cosine * height.first, cosine * cosine * height.second};
  });
  return {wheel, rail_of(profile_of(places_every(-100.0, 100.0, 50.0), [&](double x) {
            const double shift =
                x * std::tan(angle) + level_track.origin.value() * (1.0 / cosine - 1.0);
            return section.moved(0.0, shift, 0.0);
          }))};
}

/// The wheelset turns with it.
TEST(SideSensitivitiesOfVerticalGaps, TurnWithTheRail) {
  constexpr double angle = 0.04;
  const WheelSurface wheel(standard_profile("S1002"), wheelset);
  const Pose pose{-15.0, 0.02, 3e-3};
  const Pose turned{pose.lateral / std::cos(angle), pose.yaw + angle, pose.roll};
  const Profile section = first_of(tilted_crown({0.0}, 0.0), ProfileKind::rail);
  const LeftBodies level(wheel, RailSurface(section, level_track));
  WheelRequest request = under_load(80000.0, AccuracyOf::forces);
  request.gap = GapConvention::vertical;
  const WheelResult one = solve_left(level, request, pose);
  const WheelResult other = solve_left(on_turned_crown(wheel, angle), request, turned);
  EXPECT_NEAR(other.depth, one.depth, 1e-3 * one.depth);
  const std::optional<WheelRates> rates = wheel_rates_of(one);
  const std::optional<WheelRates> of_turned = wheel_rates_of(other);
  ASSERT_TRUE(rates && of_turned);
  const Rotation rotation({0.0, angle, 0.0});
  const auto expect_turned = [&](const WheelForce& found, const WheelForce& before, double factor,
                                 double lever, const char* name) {
    const double tolerance = 1e-2 * lever * norm(rates->by_pressures.vertical.force);
    EXPECT_LT(norm(found.force - factor * rotation.to_track(before.force)), tolerance) << name;
  };
  const ForceRates& to = of_turned->by_pressures;
  const ForceRates& from = rates->by_pressures;
  expect_turned(to.vertical, from.vertical, 1.0, 1.0, "vertical");
  expect_turned(to.lateral, from.lateral, std::cos(angle), 0.1, "lateral");
  expect_turned(to.roll, from.roll, 1.0, arm, "roll");
  expect_turned(to.yaw, from.yaw, 1.0, 0.1 * arm, "yaw");
}

TEST(SideSensitivitiesByName, AreComputedOnRequest) {
  Scene scene;
  scene.grid = {{24, 20}};
  SceneResult result = solve_scene(scene);
  EXPECT_FALSE(number_value(result, "left.sensitivities.lateral_force"));
  EXPECT_FALSE(number_value(result, "left.sensitivities.at_load.pressure_force.y.vertical"));
  EXPECT_TRUE(number_value(result, "left.sensitivities.pressure_force.y.roll"));
}

TEST(SideSensitivitiesByName, AreAbsentWithoutContact) {
  Scene scene;
  scene.vertical = 500.0;
  SceneResult result = solve_scene(scene);
  EXPECT_FALSE(wheel_rates_of(*result.left));
  EXPECT_FALSE(number_value(result, "left.sensitivities.pressure_force.y.lateral"));
  for (const std::string& name : number_names(result)) {
    EXPECT_EQ(name.find("sensitivities"), std::string::npos) << name;
  }
}

} // namespace
} // namespace wrc::test::wheel_rates_test
