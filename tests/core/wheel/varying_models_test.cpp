/// Approximate models where the shape along the rail is not theirs: both ends of a flat and of a
/// gap.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/simple_profiles.hpp"
#include "support/varying_contact.hpp"
#include "wheel/approximate_wheel.hpp"

namespace wrc::test::varying_models_test {
namespace {

/// Without a rail for 4 mm.
SlicedProfile crown_with_gap() {
  SlicedProfile profile = crown_along({-100.0, -2.0, 0.0, 2.0, 100.0}, [](double) { return 0.0; });
  for (ProfileSlice& slice : profile.slices) {
    slice.features.assign(2, std::nullopt);
    if (slice.place != 0.0) {
      slice.features = {0.0, slice.curve.length()};
    }
  }
  return profile;
}

struct Place {
  std::string name;
  LeftBodies bodies;
};

/// A cylinder on a crown, which has the shape of both models across the rail.
std::vector<Place> places() {
  const RailSurface crown_rail(circular_rail(crown), level_track);
  const SlicedWheel flat = flattened_cylinder(
      450.0, 0.1, 0.004, [](double theta) { return chord_depth(theta, 450.0, 57.0); });
  std::vector<Place> all{
      {"gap", {WheelSurface(cylindrical_wheel(), wheelset), rail_of(crown_with_gap())}}};
  for (const double pitch : {0.01, 0.03, 0.062, 1.0}) {
    all.push_back({"flat at " + std::to_string(pitch), {wheel_of(flat, pitch), crown_rail}});
  }
  return all;
}

double area_of(const WheelSolution& solution) {
  double area = 0.0;
  for (const Patch& patch : solution.patches) {
    area += static_cast<double>(patch.contact.element_count) * patch.grid.element_area();
  }
  return area;
}

/// Limits are those where assumptions hold (docs/evidence/models.md).
void expect_right_or_warned(const WheelSolution& found, const WheelSolution& exact,
                            double pmax_error, double area_error, const std::string& name) {
  ASSERT_TRUE(found.validity) << name;
  if (*found.validity < 0.8) {
    EXPECT_TRUE(std::ranges::any_of(found.warnings, [](const Warning& warning) {
      return warning.kind == WarningClass::model_validity;
    })) << name;
    return;
  }
  EXPECT_NEAR(found.peak_pressure, exact.peak_pressure, pmax_error * exact.peak_pressure)
      << name << ", validity " << *found.validity;
  EXPECT_NEAR(area_of(found), area_of(exact), area_error * area_of(exact))
      << name << ", validity " << *found.validity;
  EXPECT_NEAR(found.depth, exact.depth, 0.1 * exact.depth)
      << name << ", validity " << *found.validity;
}

TEST(VaryingModels, AreRightOrWarnAtTheEndsOfFlatsAndGaps) {
  const WheelRequest request = under_load(80000.0, AccuracyOf::pressures, 1e-2);
  for (const Place& place : places()) {
    const WheelSurface& wheel = *place.bodies.wheel;
    const RailSurface& rail = *place.bodies.rail;
    const SideEquilibrium equilibrium = equilibrium_of(place.bodies);
    NormalSolver solver;
    const WheelSolution exact = solve_wheel(wheel, rail, equilibrium, request, solver);
    const auto solved = [&](ApproximateModel model) {
      return solve_wheel_approximately(wheel, rail, equilibrium, request, model);
    };
    const WheelSolution hertz = solved(ApproximateModel::hertz);
    const WheelSolution virtual_penetration = solved(ApproximateModel::kik_piotrowski);
    expect_right_or_warned(hertz, exact, 0.02, 0.1, "hertz, " + place.name);
    expect_right_or_warned(virtual_penetration, exact, 0.1, 0.15, "kik-piotrowski, " + place.name);
    if (place.name == "gap") {
      EXPECT_EQ(hertz.validity, 0.0);
      EXPECT_EQ(virtual_penetration.validity, 0.0);
    }
  }
}

} // namespace
} // namespace wrc::test::varying_models_test
