/// Contacts that the end of a rail cuts off.
#include "results/cut_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "remesh/met_distance.hpp"
#include "support/simple_profiles.hpp"
#include "support/varying_contact.hpp"

namespace wrc::test::cut_contact_test {
namespace {

/// A level crown that ends at 100 mm.
LeftBodies at(double along) {
  return {
      WheelSurface(cylindrical_wheel(), wheelset),
      rail_of(crown_along(places_every(-100.0, 100.0, 20.0), [](double) { return 0.0; }), along)};
}

bool has_warning(const WheelResult& wheel, const std::string& words) {
  return std::any_of(wheel.warnings.begin(), wheel.warnings.end(), [&](const Warning& warning) {
    return warning.kind == WarningClass::profile_end &&
           warning.text.find(words) != std::string::npos;
  });
}

/// The first touch is below the axle, on the rail in all cases; half the contact is 6 mm long.
TEST(CutContact, HasAWarningAndAStateWhereTheRailEndsUnderPressure) {
  const WheelResult whole = solve_left(at(80.0), under_load(80000.0));
  EXPECT_FALSE(whole.meets_part_end);
  EXPECT_FALSE(has_warning(whole, ""));
  for (const double along : {96.0, 99.0}) {
    const WheelResult cut = solve_left(at(along), under_load(80000.0));
    EXPECT_TRUE(cut.meets_part_end) << along;
    EXPECT_TRUE(has_warning(cut, "an end of the rail at 100 mm: pressures have no bound")) << along;
    EXPECT_TRUE(cut.is_unbounded && cut.patches[0].is_unbounded) << along;
  }
  const WheelResult before = solve_left(at(90.0), under_load(80000.0)); // not reached
  EXPECT_FALSE(before.meets_part_end);
  EXPECT_FALSE(before.is_unbounded || before.patches[0].is_unbounded);
  EXPECT_FALSE(has_warning(before, ""));
}

/// Its edge is known to half an element: depth and place are no better.
TEST(CutContact, ErrorCoversDepthAndPlace) {
  for (const double along : {95.0, 97.0, 98.0, 99.0, 99.7}) {
    WheelRequest request = under_load(80000.0);
    request.accuracy_of = AccuracyOf::forces;
    request.accuracy = 1e-4;
    const WheelResult fine = solve_left(at(along), request);
    const double semi_axis = fine.patches[0].semi_axis_longitudinal;
    for (const double accuracy : {1e-2, 6e-3, 2e-3}) {
      request.accuracy = accuracy;
      const WheelResult cut = solve_left(at(along), request);
      const double error = std::hypot(*cut.error_estimate, *fine.error_estimate);
      EXPECT_LT(std::abs(cut.depth / fine.depth - 1.0), error) << along << ' ' << accuracy;
      EXPECT_LT(std::abs(cut.centroid.x - fine.centroid.x) / semi_axis, error)
          << along << ' ' << accuracy;
      EXPECT_FALSE(std::ranges::any_of(cut.warnings, [](const Warning& warning) {
        return warning.kind == WarningClass::accuracy;
      })) << "the cause has a warning";
    }
  }
}

/// A profile that ends under the pressures is such an end, along the whole track.
TEST(CutContact, IsSeenAtTheEndOfAProfile) {
  constexpr double radius = 300.0;
  const auto height_at = [](double y) { return std::sqrt(radius * radius - y * y) - radius; };
  const std::array<Segment, 2> segments{
      Segment{"gauge side", LineSegment{{{-35.0, -22.0}}, {{-35.0, height_at(-35.0)}}}},
      Segment{"crown",
              ArcSegment{
                  {{0.0, -radius}}, radius, {{-35.0, height_at(-35.0)}}, {{3.0, height_at(3.0)}}}}};
  const Profile rail{"cut", ProfileKind::rail, "", "", "", curve_of(segments)};
  const LeftBodies bodies{WheelSurface(cylindrical_wheel(), wheelset),
                          RailSurface(rail, level_track)};
  for (const double accuracy : {1e-2, 1e-3}) {
    WheelRequest request = under_load(80000.0);
    request.accuracy = accuracy;
    const WheelResult cut = solve_left(bodies, request);
    EXPECT_TRUE(cut.is_unbounded);
    EXPECT_FALSE(cut.meets_part_end) << "the state of bodies that vary";
    EXPECT_TRUE(has_warning(cut, "contact reaches the end of a profile: pressures"));
    request.accuracy_of = AccuracyOf::forces;
    EXPECT_LT(*cut.error_estimate, 2.0 * *solve_left(bodies, request).error_estimate)
        << "pmax, which is not given, does not count";
  }
}

TEST(CutContact, IsSeenWhereAnotherPartGoesOnBelow) {
  const LeftBodies bodies = at(97.0);
  const WheelResult cut = solve_left(bodies, under_load(80000.0));
  std::vector<PatchResult> patches = cut.patches;
  ASSERT_EQ(patches.size(), 1U);
  std::vector<double>& distance = patches[0].undeformed_distance;
  const auto beyond_end = [&](double below) {
    std::vector<double> changed = distance;
    for (std::size_t i = 1; i < changed.size(); ++i)
      if (!is_met(changed[i]) && is_met(changed[i - 1]))
        changed[i] = changed[i - 1] + below;
    return changed;
  };
  const std::vector<double> lower = beyond_end(5.0);
  const std::vector<double> level = beyond_end(0.0);
  distance = lower;
  const auto found = mark_cuts(patches, *bodies.wheel, *bodies.rail);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_along);
  distance = level;
  EXPECT_FALSE(mark_cuts(patches, *bodies.wheel, *bodies.rail));
}

} // namespace
} // namespace wrc::test::cut_contact_test
