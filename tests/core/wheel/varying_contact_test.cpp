/// Contact on rails that vary along the track and wheels that vary around the circumference:
/// rotated scenes, Hertz's closed form, another program, patches at both ends of a flat,
/// smoothness.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "models/hertz.hpp"
#include "remesh/rail_normals.hpp"
#include "remesh/undeformed_distance.hpp"
#include "support/simple_profiles.hpp"
#include "support/varying_contact.hpp"

namespace wrc::test::varying_contact_test {
namespace {

constexpr double load = 80000.0;

WheelSurface cylinder() {
  return WheelSurface(cylindrical_wheel(), wheelset);
}
RailSurface straight_crown() {
  return RailSurface(circular_rail(crown), level_track);
}

struct TiltedPair {
  LeftBodies level;
  LeftBodies inclined;
  double vertical;          ///< of the level wheel's centre
  double inclined_vertical; ///< of the other's, which is behind the rail's origin
};

/// A crown of one profile, and the same turned about the y axis by slices. The wheels' centres are
/// where the rotation leads, at a virtual penetration of 0.08 mm.
TiltedPair tilted_pair(const WheelSurface& wheel, const Pose& pose, double angle) {
  const std::vector<double> places = places_every(-200.0, 200.0, 20.0);
  const LeftBodies level(
      wheel, RailSurface(first_of(tilted_crown(places, 0.0), ProfileKind::rail), level_track));
  const double vertical = equilibrium_of(level, pose).vertical - 0.08;
  const Vector3 centre = tilted({0.0, 0.0, vertical}, angle);
  return {level, LeftBodies(wheel, rail_of(tilted_crown(places, angle), centre.x)), vertical,
          centre.z};
}

struct TiltedCase {
  const char* name;
  WheelSurface wheel;
  Pose pose;
};

std::vector<TiltedCase> tilted_cases() {
  return {{"cylinder", cylinder(), {}},
          {"S1002", WheelSurface(standard_profile("S1002"), wheelset), {-15.0, 0.0, 0.0}}};
}

constexpr std::array angles{0.01, -0.05, 0.1};

/// The same rays in space: equal but for rounding and the section's polynomials.
TEST(VaryingContact, ATiltedRailHasTheDistancesAndPressuresOfTheLevelOne) {
  for (const TiltedCase& each : tilted_cases())
    for (const double angle : angles) {
      const TiltedPair pair = tilted_pair(each.wheel, each.pose, angle);
      const PosedPair level{*pair.level.wheel, *pair.level.rail, each.pose, pair.vertical};
      const PosedPair inclined{*pair.inclined.wheel, *pair.inclined.rail, each.pose,
                               pair.inclined_vertical};
      WheelRequest request = under_load(load);
      request.vertical_load.reset();
      request.vertical = pair.vertical;
      const WheelResult here = solve_left(pair.level, request, each.pose);
      const PatchResult& patch = here.patches.at(0);
      ContactFrame turned = patch.frame;
      for (Vector3* axis : {&turned.longitudinal, &turned.lateral, &turned.normal})
        *axis = tilted(*axis, angle);
      turned.origin = tilted(turned.origin, angle);
      turned.origin.x -= pair.inclined.rail->along(); // counted from the wheelset
      const auto distance = sample_undeformed_distance(level, patch.frame, patch.grid);
      const auto other = sample_undeformed_distance(inclined, turned, patch.grid);
      double largest = 0.0;
      for (std::size_t i = 0; i < distance.size(); ++i)
        largest = std::max(largest, std::abs(distance[i] - other[i]));
      EXPECT_LT(largest, 1e-9) << each.name << ' ' << angle;

      const auto solved = [&](const std::vector<double>& gap) {
        const PatchGap of_patch{patch.grid, gap, 1.0, {}, {}, {}};
        NormalProblem problem;
        problem.patches = {&of_patch, 1};
        problem.combined_modulus = steel;
        problem.approach = 0.0;
        problem.tolerance = 1e-10;
        return NormalSolver().solve(problem).patches[0].pressure;
      };
      const std::vector<double> pressure = solved(distance);
      const std::vector<double> turned_pressure = solved(other);
      const double pmax = *std::max_element(pressure.begin(), pressure.end());
      for (std::size_t i = 0; i < pressure.size(); ++i)
        ASSERT_NEAR(pressure[i], turned_pressure[i], 1e-7 * pmax); // 1e-9 mm over 0.08 mm
      const Vector3 force =
          RailNormals(*pair.level.rail, patch.frame, patch.grid).force(pressure).force;
      const Vector3 turned_force =
          RailNormals(*pair.inclined.rail, turned, patch.grid).force(turned_pressure).force;
      EXPECT_LT(norm(turned_force - tilted(force, angle)), 1e-7 * norm(force)) << each.name;
    }
}

/// As a whole its penetration is measured vertically, and its elements differ.
TEST(VaryingContact, ATiltedRailHasTheForcesAndPlaceOfTheLevelOneToTheAccuracy) {
  for (const TiltedCase& each : tilted_cases())
    for (const double angle : angles) {
      const TiltedPair pair = tilted_pair(each.wheel, each.pose, angle);
      WheelRequest request = under_load(load);
      request.vertical_load.reset();
      request.vertical = pair.vertical;
      const WheelResult here = solve_left(pair.level, request, each.pose);
      request.vertical = pair.inclined_vertical;
      const WheelResult there = solve_left(pair.inclined, request, each.pose);
      const double accuracy = request.accuracy;
      EXPECT_LT(norm(there.force - tilted(here.force, angle)), accuracy * norm(here.force))
          << each.name << ' ' << angle;
      EXPECT_NEAR(there.pmax, here.pmax, accuracy * here.pmax) << each.name << ' ' << angle;
      const Vector3 place = tilted({here.centroid.x, here.centroid.y, here.centroid.z}, angle) -
                            Vector3{pair.inclined.rail->along(), 0.0, 0.0};
      EXPECT_NEAR(there.centroid.x, place.x, 0.01) << each.name << ' ' << angle;
      EXPECT_NEAR(there.centroid.y, place.y, 0.01) << each.name << ' ' << angle;
      EXPECT_NEAR(there.centroid.z, place.z, 0.001) << each.name << ' ' << angle;
    }
}

constexpr double revolution = 2.0 * std::numbers::pi;

TEST(VaryingContact, HasHertzsPressureOnACrest) {
  const double amplitude = 0.1;
  const double wave_number = revolution / 100.0;
  const LeftBodies bodies(cylinder(),
                          rail_of(crown_along(places_every(-60.0, 60.0, 1.0), [&](double x) {
                            return amplitude * std::cos(wave_number * x);
                          })));
  for (const double small : {10.0, 50.0, 1000.0}) {
    const WheelResult wheel = solve_left(bodies, under_load(small));
    const HertzContact hertz = solve_hertz(
        1.0 / wheelset.radius + amplitude * wave_number * wave_number, 1.0 / crown, steel, small);
    EXPECT_NEAR(wheel.pmax, hertz.peak_pressure, *wheel.error_estimate * hertz.peak_pressure);
    EXPECT_NEAR(wheel.depth, hertz.approach, 1e-3 * hertz.approach);
  }
}

/// CONTACT rev 2707 (open source), brute-force search, 0.2 mm elements, 80 kN and steel of
/// G = 82000 MPa, nu = 0.28: cylinder of 460 mm on crowns of 300 mm whose height varies.
struct Reference {
  const char* rail;
  double along;
  double pmax;  ///< MPa
  double down;  ///< of the wheel's centre, mm
  double place; ///< of the contact along the track, mm
};
constexpr std::array references{Reference{"slope", 0.0, 1139.031, 0.067510345, 4.599434},
                                Reference{"slope", 13.0, 1139.031, -0.062489654, 4.599435},
                                Reference{"corrugated", 0.0, 1057.632, 0.10667471, 0.0},
                                Reference{"corrugated", 5.0, 1094.056, 0.10117735, 1.014081},
                                Reference{"corrugated", 15.0, 1198.253, 0.077950963, 0.7906424},
                                Reference{"corrugated", 20.0, 1212.757, 0.073685601, 0.0},
                                Reference{"wave", 0.0, 1072.065, 0.18731808, 0.0},
                                Reference{"wave", 10.0, 1090.709, 0.16547708, 1.923277},
                                Reference{"wave", 40.0, 1191.728, 0.009207608, 1.451844},
                                Reference{"wave", 50.0, 1200.056, -0.0068092151, 0.0}};

double height_of(const std::string& rail, double x) {
  return rail == "slope"        ? 0.01 * x
         : rail == "corrugated" ? -0.02 * std::cos(revolution * x / 40.0)
                                : -0.1 * std::cos(revolution * x / 100.0);
}

double step_of(const std::string& rail) {
  return rail == "slope" ? 10.0 : rail == "corrugated" ? 1.0 : 2.0;
}

TEST(VaryingContact, AgreesWithAnotherProgramOnSlopesAndWaves) {
  const Material material{2.0 * 82000.0 * 1.28, 0.28};
  for (const Reference& each : references) {
    const LeftBodies bodies(cylinder(),
                            rail_of(crown_along(places_every(-100.0, 100.0, step_of(each.rail)),
                                                [&](double x) { return height_of(each.rail, x); }),
                                    each.along));
    WheelRequest request = under_load(load, AccuracyOf::pressures, 1e-4);
    request.combined_modulus = combined_modulus(material, material);
    const WheelResult wheel = solve_left(bodies, request);
    EXPECT_NEAR(wheel.pmax, each.pmax, 3e-4 * each.pmax) << each.rail << ' ' << each.along;
    EXPECT_NEAR(wheel.vertical - wheel.depth, wheelset.radius - each.down, 1e-4)
        << each.rail << ' ' << each.along;
    EXPECT_NEAR(wheel.centroid.x, each.place, 0.3) << each.rail << ' ' << each.along;
  }
}

constexpr double flat_radius = 450.0;

SlicedWheel wheel_with_flat(double depth) {
  return flattened_cylinder(flat_radius, 0.2, 0.001,
                            [&](double theta) { return rounded_depth(theta, depth, 0.06); });
}

TEST(VaryingContact, BothEndsOfAFlatCarryALoadEach) {
  const auto wheel = wheel_with_flat(2.0);
  const WheelResult level =
      solve_left({wheel_of(wheel), straight_crown()}, under_load(load, AccuracyOf::forces));
  ASSERT_EQ(level.patches.size(), 2U);
  EXPECT_NEAR(level.patches[0].force.z, 0.5 * load, 1e-3 * load);
  EXPECT_NEAR(level.patches[1].force.z, 0.5 * load, 1e-3 * load);
  EXPECT_NEAR(level.patches[0].centroid.x, -level.patches[1].centroid.x, 1e-3);
  // Turned by so much, either way, the sides change places.
  const auto turned = [&](double pitch) {
    return solve_left({wheel_of(wheel, pitch), straight_crown()},
                      under_load(load, AccuracyOf::forces));
  };
  const WheelResult ahead = turned(0.001);
  const WheelResult behind = turned(-0.001);
  ASSERT_EQ(ahead.patches.size(), 2U);
  ASSERT_EQ(behind.patches.size(), 2U);
  EXPECT_GT(ahead.patches[0].force.z, 1.2 * ahead.patches[1].force.z);
  EXPECT_GT(ahead.patches[0].centroid.x, 0.0);
  EXPECT_NEAR(ahead.patches[0].force.z, behind.patches[0].force.z, 1e-3 * load);
  EXPECT_NEAR(ahead.patches[0].centroid.x, -behind.patches[0].centroid.x, 1e-2);
}

/// A pitch at which patches of both ends of a flat become one, or the second one leaves the rail.
struct Event {
  double depth; ///< of the flat, mm
  double before;
  double after;
  double jump; ///< that is permitted, over the load
};

class FlatEvent : public testing::TestWithParam<Event> {};

/// Right before and after, to 1e-9 rad: a patch dies without a jump, patches join to the accuracy.
TEST_P(FlatEvent, IsPassedWithoutAJump) {
  const Event event = GetParam();
  const auto wheel = wheel_with_flat(event.depth);
  const auto solved = [&](double pitch) {
    return solve_left({wheel_of(wheel, pitch), straight_crown()},
                      under_load(load, AccuracyOf::forces));
  };
  const auto joined = [](const WheelResult& result) {
    double least = 0.0;
    for (const PatchResult& patch : result.patches)
      least = std::min(least, patch.penetration.x_first);
    return least < -10.0; // the end of the flat that is behind belongs to a patch
  };
  double low = event.before;
  double high = event.after;
  ASSERT_TRUE(joined(solved(low)));
  ASSERT_FALSE(joined(solved(high)));
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (joined(solved(middle)) ? low : high) = middle;
  }
  const WheelResult one = solved(low);
  const WheelResult other = solved(high);
  const double stiffness = 1.5 / one.depth; // of the load, per mm
  EXPECT_LT(std::abs(one.vertical - one.depth - other.vertical + other.depth) * stiffness,
            event.jump);
  EXPECT_LT(norm(one.force - other.force), event.jump * load);
  EXPECT_LT(std::abs(one.centroid.x - other.centroid.x), event.jump * flat_radius);
}

INSTANTIATE_TEST_SUITE_P(VaryingContact, FlatEvent,
                         testing::Values(Event{2.0, 0.00249, 0.002495, 1e-5},
                                         Event{1.0, 0.0026, 0.002605, 1e-5},
                                         Event{0.5, 0.00341, 0.00343, 1e-3}));

/// By how much values leave the straight line through them, at the most.
double from_line(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double sum = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    moment += (static_cast<double>(i) - 0.5 * (count - 1.0)) * values[i];
  }
  const double slope = 12.0 * moment / (count * (count * count - 1.0));
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    largest = std::max(largest, std::abs(values[i] - sum / count -
                                         slope * (static_cast<double>(i) - 0.5 * (count - 1.0))));
  return largest;
}

constexpr int steps = 10;
constexpr double step_along = 1e-4; // mm

/// Forces and height, the latter by the stiffness, and the moment about the axle over the radius,
/// leave their slopes over steps of 0.1 um by less than this share of the load.
void expect_smooth(const std::function<WheelResult(double)>& at, double from, double limit) {
  std::array<std::vector<double>, 4> values;
  double height = 0.0;
  double stiffness = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const WheelResult result = at(from + step_along * i);
    if (i == 0) {
      height = result.vertical - result.depth;
      stiffness = 1.5 / result.depth;
    }
    values[0].push_back(result.force.x / load);
    values[1].push_back(result.force.y / load);
    values[2].push_back(stiffness * (result.vertical - result.depth - height));
    values[3].push_back(result.moment.y / (load * wheelset.radius));
  }
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_LT(from_line(values.at(k)), limit) << "at " << from << ", value " << k;
}

/// Measured over 20 windows of 40 steps each: 1.0e-7 (cylinder, no yaw), 7.2e-8 (S1002, yawed).
TEST(VaryingContact, ForcesAreSmoothAlongAWaveUnderATaper) {
  const SlicedProfile slices = profile_of(places_every(-150.0, 150.0, 5.0), [](double x) {
    return curve_of([&](double y) { return crown_at(y, 1.0 + 0.0005 * x); })
        .moved(0.0, 0.0, 0.1 * std::cos(revolution * x / 100.0) + 0.01 * x);
  });
  const RailSurface rail = rail_of(slices);
  const WheelSurface s1002(standard_profile("S1002"), wheelset);
  for (const double from : {-38.07, 4.9999, 23.4}) { // 5: where a slice is
    expect_smooth(
        [&](double along) {
          return solve_left({cylinder(), rail.posed({}, along)},
                            under_load(load, AccuracyOf::forces));
        },
        from, 1e-6);
    expect_smooth(
        [&](double along) {
          return solve_left({s1002, rail.posed({}, along)}, under_load(load, AccuracyOf::forces),
                            {-15.0, 0.01, 0.0});
        },
        from, 1e-6);
  }
}

/// Measured over 40 windows of 40 steps each: 4.1e-7, where the middle of the flat is down.
TEST(VaryingContact, ForcesAreSmoothThroughAFlat) {
  for (const auto& [depth, from] : {std::pair(0.5, -0.0605), {1.0, -0.001}}) {
    const auto wheel = wheel_with_flat(depth);
    expect_smooth(
        [&](double along) {
          return solve_left({wheel_of(wheel, along / flat_radius), straight_crown()},
                            under_load(load, AccuracyOf::forces));
        },
        from * flat_radius, 1e-6);
  }
}

} // namespace
} // namespace wrc::test::varying_contact_test
