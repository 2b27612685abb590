// Approximate models of one patch: crossed cylinders by Hertz's closed form, scaling with depth,
// and pressures that add up to the force.
#include "geometry/contact_search.hpp"
#include "models/patch_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "models/hertz.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::patch_model_test {
namespace {

constexpr double modulus = 115384.6;
constexpr double wheel_radius = 460.0;
constexpr double crown_radius = 300.0;

/// A cylinder on a crown, both level where they touch.
class PatchModels : public testing::Test {
protected:
  WheelSurface wheel_{cylindrical_wheel(), {1360.0, 70.0, wheel_radius}};
  RailSurface rail_{circular_rail(crown_radius), {1435.0, 14.0, 0.0}};
  ContactScan scan_ = search_contacts(wheel_, rail_, {}, 1.0);
  ContactStrips strips_{wheel_, rail_, {}};
  ModelWheel side_{scan_, strips_, -scan_.candidates.front().distance, modulus};

  [[nodiscard]] ContactPatch patch_at(double depth) const {
    return find_contact_patches(scan_, depth).patches.front();
  }
  [[nodiscard]] std::unique_ptr<PatchModel> hertz(double depth) const {
    return make_hertz_patch(side_, patch_at(depth));
  }
  [[nodiscard]] std::unique_ptr<PatchModel> kik_piotrowski(double depth) const {
    return make_kik_piotrowski_patch(side_, patch_at(depth),
                                     tangent_frame(scan_.candidates.front().wheel.position, 0.0));
  }
};

/// Sum of a patch's pressures on elements around it.
double summed(const PatchModel& model, const PlaneArea& extent) {
  constexpr std::size_t count = 200;
  const double height = 1.1 * (extent.lateral_last - extent.lateral_first);
  const double length = 1.1 * (extent.longitudinal_last - extent.longitudinal_first);
  const double lateral = 0.5 * (extent.lateral_last + extent.lateral_first);
  const double longitudinal = 0.5 * (extent.longitudinal_last + extent.longitudinal_first);
  Grid grid{count, count, height / count, length / count, 0.0, 0.0};
  grid.lateral_first = lateral - 0.5 * (count - 1) * grid.lateral_step;
  grid.longitudinal_first = longitudinal - 0.5 * (count - 1) * grid.longitudinal_step;
  double sum = 0.0;
  for (const double pressure : model.sample(grid)) {
    sum += pressure * grid.element_area();
  }
  return sum;
}

TEST_F(PatchModels, HertzOnCrossedCylindersIsTheClosedForm) {
  constexpr double depth = 0.05;
  const auto model = hertz(depth);
  const ModelledPatch patch = model->solve(depth);
  const HertzContact exact =
      solve_hertz_for_approach(1.0 / wheel_radius, 1.0 / crown_radius, modulus, depth);
  EXPECT_NEAR(patch.normal_force / exact.normal_force, 1.0, 1e-5);
  EXPECT_NEAR(patch.peak_pressure / exact.peak_pressure, 1.0, 1e-5);
  EXPECT_NEAR(patch.semi_axis_longitudinal / exact.semi_axis_longitudinal, 1.0, 1e-5);
  EXPECT_NEAR(patch.semi_axis_lateral / exact.semi_axis_lateral, 1.0, 1e-5);
  EXPECT_NEAR(patch.approach, depth, 1e-9);
  EXPECT_GT(patch.validity, 0.99);
  EXPECT_NEAR(model->load(depth), patch.normal_force, 1e-9 * patch.normal_force);
}

TEST_F(PatchModels, PressuresAddUpToTheForce) {
  constexpr double depth = 0.05;
  const auto one = hertz(depth);
  const ModelledPatch ellipse = one->solve(depth);
  EXPECT_NEAR(summed(*one, ellipse.extent) / ellipse.normal_force, 1.0, 2e-3);
  const auto other = kik_piotrowski(depth); // between its strips the outline is a polygon
  const ModelledPatch strips = other->solve(depth);
  EXPECT_NEAR(summed(*other, strips.extent) / strips.normal_force, 1.0, 8e-3);
}

TEST_F(PatchModels, LoadsGrowWithThePowerOfThreeHalvesOfTheDepth) {
  for (const auto& model : {hertz(0.05), kik_piotrowski(0.05)}) {
    EXPECT_NEAR(model->load(0.08) / model->load(0.02), 8.0, 0.02);
    EXPECT_EQ(model->load(0.0), 0.0);
  }
}

TEST_F(PatchModels, BothModelsAgreeClosely) {
  const ModelledPatch one = hertz(0.05)->solve(0.05);
  const ModelledPatch other = kik_piotrowski(0.05)->solve(0.05);
  // 0.55 in place of the circle's 0.5 (tests of the formulas): loads by up to sqrt(1.1).
  EXPECT_NEAR(other.normal_force / one.normal_force, std::sqrt(1.1), 0.03);
  EXPECT_GT(other.validity, 0.9);
}

} // namespace
} // namespace wrc::test::patch_model_test
