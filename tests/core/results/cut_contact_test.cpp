/// Contacts that the end of a rail cuts off.
#include "results/cut_contact.hpp"

#include <algorithm>
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
    EXPECT_TRUE(has_warning(cut, "an end of the rail at 100 mm: pressures")) << along;
    EXPECT_GT(cut.pmax, whole.pmax) << along;
  }
  const WheelResult before = solve_left(at(90.0), under_load(80000.0)); // not reached
  EXPECT_FALSE(before.meets_part_end);
  EXPECT_FALSE(has_warning(before, ""));
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
  const auto found = find_cut(patches, *bodies.wheel, *bodies.rail);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_along);
  distance = level;
  EXPECT_FALSE(find_cut(patches, *bodies.wheel, *bodies.rail));
}

} // namespace
} // namespace wrc::test::cut_contact_test
