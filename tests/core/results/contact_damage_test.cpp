// Damage of a wheel from its patches: power by forces and creepages, fatigue, and the worst of
// several.
#include "results/contact_damage.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "records/damage_result.hpp"
#include "records/wheel_result.hpp"

namespace wrc::test::contact_damage_test {
namespace {

PatchResult patch_of(double normal_force, double longitudinal, double lateral, double pmax) {
  PatchResult patch;
  patch.normal_force = normal_force;
  patch.force = {0.0, 0.0, normal_force};
  patch.pmax = pmax;
  CreepResult& creep = patch.creep.emplace();
  creep.creepages = {2e-3, -1e-3, 1e-4};
  creep.longitudinal_force = longitudinal;
  creep.lateral_force = lateral;
  creep.power_per_speed = 75.0;
  return patch;
}

WheelResult wheel_of(std::vector<PatchResult> patches) {
  WheelResult wheel;
  wheel.patches = std::move(patches);
  return wheel;
}

TEST(ContactDamage, OnlyRequestedResultsAreComputed) {
  WheelResult wheel = wheel_of({patch_of(8e4, -3e4, 4e4 * 0.3, 900.0)});
  DamageRequest request;
  EXPECT_FALSE(request.any());
  request.fatigue = true;
  EXPECT_TRUE(request.any());
  find_damage(wheel, request);
  ASSERT_TRUE(wheel.damage);
  EXPECT_TRUE(wheel.damage->fatigue);
  EXPECT_FALSE(wheel.damage->wear);
  EXPECT_FALSE(wheel.damage->stress);
}

TEST(ContactDamage, PowerIsThatOfForcesAndCreepages) {
  WheelResult wheel = wheel_of({patch_of(8e4, -2e4, 1e4, 900.0), patch_of(2e4, -1e3, 0.0, 700.0)});
  DamageRequest request;
  request.wear = true;
  find_damage(wheel, request);
  EXPECT_NEAR(wheel.patches[0].damage->wear->tgamma, 2e4 * 2e-3 + 1e4 * 1e-3, 1e-9);
  EXPECT_EQ(wheel.patches[0].damage->wear->tgamma_with_spin, 75.0);
  EXPECT_FALSE(wheel.patches[0].damage->wear->volume) << "needs tractions by element";
  // Amounts of the wheel are sums.
  EXPECT_NEAR(wheel.damage->wear->tgamma, 50.0 + 2.0, 1e-9);
  EXPECT_EQ(wheel.damage->wear->tgamma_with_spin, 150.0);
}

/// Utilised friction above 0.3: the shakedown limit is 1/friction (Johnson 1985, 9.2), and the
/// surface index is what friction exceeds k/p0 by.
TEST(ContactDamage, FatigueIsThatOfTheShakedownMap) {
  DamageRequest request;
  request.fatigue = true;
  request.shear_yield = 300.0;
  WheelResult wheel = wheel_of({patch_of(8e4, -2.4e4, 3.2e4, 1200.0)});
  find_damage(wheel, request);
  const Fatigue& fatigue = *wheel.patches[0].damage->fatigue;
  EXPECT_NEAR(fatigue.friction, 0.5, 1e-12);
  EXPECT_NEAR(fatigue.pressure_ratio.value(), 4.0, 1e-12);
  EXPECT_NEAR(fatigue.surface_index.value(), 0.5 - 0.25, 1e-12);
}

TEST(ContactDamage, TheWorstPatchDeterminesTheWheel) {
  DamageRequest request;
  request.fatigue = true;
  WheelResult wheel =
      wheel_of({patch_of(8e4, -0.8e4, 0.0, 900.0), patch_of(2e4, -0.8e4, 0.0, 1500.0)});
  find_damage(wheel, request);
  EXPECT_EQ(wheel.damage->fatigue->surface_index,
            std::max(wheel.patches[0].damage->fatigue->surface_index,
                     wheel.patches[1].damage->fatigue->surface_index));
  EXPECT_GT(wheel.patches[1].damage->fatigue->surface_index,
            wheel.patches[0].damage->fatigue->surface_index);
}

/// Where an end of a body cuts a contact its largest pressure has no bound, nor what follows from
/// it.
TEST(ContactDamage, OfACutContactHasNoPeaks) {
  DamageRequest request;
  request.fatigue = request.wear = request.stress = true;
  WheelResult wheel =
      wheel_of({patch_of(8e4, -0.8e4, 0.0, 900.0), patch_of(2e4, -0.8e4, 0.0, 1500.0)});
  wheel.is_unbounded = wheel.patches[1].is_unbounded = true;
  find_damage(wheel, request);
  EXPECT_TRUE(wheel.patches[0].damage->fatigue->surface_index);
  for (const ContactDamage* damage : {&*wheel.patches[1].damage, &*wheel.damage}) {
    EXPECT_FALSE(damage->stress);
    EXPECT_FALSE(damage->wear->depth);
    EXPECT_FALSE(damage->fatigue->pressure_ratio);
    EXPECT_FALSE(damage->fatigue->surface_index);
    EXPECT_GT(damage->fatigue->friction, 0.0);
    EXPECT_GT(damage->wear->tgamma_with_spin, 0.0);
  }
}

} // namespace
} // namespace wrc::test::contact_damage_test
