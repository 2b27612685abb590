// Fields of damage by name: one value for each place, and what is made of them agrees.
#include "scene/patch_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "damage/element_stress.hpp"

namespace wrc::test::patch_fields_test {
namespace {

TEST(PatchFields, AreListedByName) {
  EXPECT_EQ(damage_field("pressure"), nullptr);
  EXPECT_EQ(damage_field(""), nullptr);
  ASSERT_NE(damage_field("wear_depth"), nullptr);
  EXPECT_EQ(damage_field("wear_depth")->name, "wear_depth");
}

/// The section's comparison stress is that of its components, on both sides.
TEST(PatchFields, ComparisonStressesAreThoseOfTheComponents) {
  Scene scene;
  scene.accuracy = 1e-2;
  scene.damage.stress = true;
  const SceneResult result = solve_scene(scene);
  for (const WheelResult* wheel : {&*result.left, &*result.right}) {
    const PatchResult& patch = wheel->patches.front();
    const auto field = [&](const std::string& name) {
      return damage_field(name)->compute(wheel->details, patch);
    };
    const std::vector<double> von_mises_field = field("stress_von_mises");
    std::array<std::vector<double>, 6> components;
    constexpr std::array names{"xx", "yy", "zz", "xy", "xz", "yz"};
    for (std::size_t c = 0; c < names.size(); ++c) {
      components[c] = field(std::string("stress_") + names[c]);
      ASSERT_EQ(components[c].size(), von_mises_field.size());
    }
    ASSERT_GT(von_mises_field.size(), 1000U);
    double largest = 0.0;
    for (std::size_t i = 0; i < von_mises_field.size(); ++i) {
      Stress stress{};
      for (std::size_t c = 0; c < names.size(); ++c) {
        stress[c] = components[c][i];
      }
      EXPECT_NEAR(von_mises(stress), von_mises_field[i], 1e-9 * patch.pmax);
      largest = std::max(largest, von_mises_field[i]);
    }
    // Below Hertzian contacts of any shape 0.55 to 0.65 of the largest pressure (Johnson 1985).
    EXPECT_NEAR(largest / patch.pmax, 0.6, 0.06);
  }
}

/// Components with one y are mirrored on the right.
TEST(PatchFields, OfTheRightSideAreMirrorImages) {
  Scene scene;
  scene.accuracy = 1e-2;
  scene.damage.stress = true;
  const SceneResult result = solve_scene(scene);
  const auto field = [](const WheelResult& wheel, const char* name) {
    return damage_field(name)->compute(wheel.details, wheel.patches.front());
  };
  for (const char* name : {"stress_xy", "stress_yz", "stress_zz"}) {
    const std::vector<double> left = field(*result.left, name);
    const std::vector<double> right = field(*result.right, name);
    const double sign = std::string(name) == "stress_zz" ? 1.0 : -1.0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      EXPECT_EQ(right[i], sign * left[i]) << name << i;
    }
  }
}

/// One value for each lobe, in the convention of the caller.
TEST(PatchFields, OfLobesAreInTheCallersConvention) {
  Scene scene;
  scene.accuracy = 1e-2;
  scene.lateral = 5.0;
  SceneResult result = solve_scene(scene);
  Convention turned;
  turned.units = Units::si;
  turned.frame = TrackFrame::right_down;
  const auto field = [&](const std::string& name, const Convention& convention) {
    return *field_values(result, "left.patches.0.lobe_" + name, convention);
  };
  for (const char* name :
       {"normal_force", "force_x", "force_y", "force_z", "angle", "x", "y", "z", "s_wheel",
        "t_rail", "semi_axes_longitudinal", "semi_axes_lateral", "rolling_radius"}) {
    EXPECT_EQ(field(name, {}).size(), 2U) << name;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(field("y", turned)[k], -1e-3 * field("y", {})[k], 1e-12);
    EXPECT_EQ(field("force_y", turned)[k], -field("force_y", {})[k]);
    EXPECT_EQ(field("normal_force", turned)[k], field("normal_force", {})[k]);
    EXPECT_EQ(field("angle", turned)[k], field("angle", {})[k]);
  }
}

} // namespace
} // namespace wrc::test::patch_fields_test
