#include "scene/number_ids.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "derivatives/force_jacobian.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::number_ids_test {
namespace {

/// With creep forces and their derivatives, near contacts, and patches of several parts.
SceneResult solve_rich_scene(double lateral) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = "UIC60-Manchester";
  scene.lateral = lateral;
  scene.accuracy = 0.1;
  scene.near_tolerance = 10.0;
  scene.left.load = scene.right.load = 1e4;
  scene.left.creepages = scene.right.creepages = Creepages{1e-3, 0.0, 0.0};
  scene.derivatives = true;
  return solve_scene(scene);
}

TEST(NumberIds, EveryResultNameHasADistinctId) {
  std::set<std::string> seen;
  for (const double lateral : {-5.0, 5.0}) {
    SceneResult result = solve_rich_scene(lateral);
    std::set<std::int32_t> ids;
    for (const std::string& name : number_names(result)) {
      const auto id = number_id(name);
      ASSERT_TRUE(id) << name;
      const auto packed = pack(*id);
      ASSERT_TRUE(packed) << name;
      EXPECT_GT(*packed, 0) << name;
      EXPECT_TRUE(ids.insert(*packed).second) << name;
      const auto unpacked = unpack(*packed);
      ASSERT_TRUE(unpacked) << name;
      EXPECT_EQ(number_value(result, *unpacked), number_value(result, name)) << name;
      seen.insert(name);
    }
  }
  for (const char* part : {".parts.1.", ".near_contacts.0.", ".creep_force.", ".at_load."}) {
    EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [part](const std::string& name) {
      return name.find(part) != std::string::npos;
    })) << part;
  }
}

TEST(NumberIds, AreThoseOfTheScenesOfAnyResult) {
  // Prescribed so high that there is no contact, and one wheel only.
  Scene scene;
  scene.vertical = 500.0;
  scene.side = SideChoice::left;
  SceneResult empty = solve_scene(scene);
  for (const char* name :
       {"right.pmax", "rolling_radius_difference", "wheelset.force.y", "left.error_estimate",
        "left.validity", "left.patches.0.pmax", "left.patches.3.parts.2.creep_force.lateral",
        "left.near_contacts.7.distance", "left.sensitivities.pressure_force.y.roll",
        "left.sensitivities.at_load.vertical.roll", "right.residuals.least_gap"}) {
    const auto id = number_id(name);
    ASSERT_TRUE(id) << name;
    EXPECT_TRUE(std::isnan(number_value(empty, *id))) << name;
  }
  EXPECT_EQ(number_value(empty, *number_id("left.area")), 0.0);
}

TEST(NumberIds, UnknownNamesHaveNoId) {
  for (const char* name :
       {"", "left", "left.", "left.pmaximum", "top.pmax", "pmax", "left.time_ms.total",
        "left.rigid_contact", "left.centroid.distance", "left.patches.0", "left.patches.-1.pmax",
        "left.patches.x.pmax", "left.patches.0.parts.0.parts.0.pmax", "left.patches.0.depth",
        "left.patches.99999999999999999999.pmax", "left.near_contacts.0.pmax", "roll.x"}) {
    EXPECT_FALSE(number_id(name)) << name;
  }
}

TEST(NumberIds, IndicesArePackedUpToTheirLimits) {
  const auto packed = [](const std::string& index, const std::string& part) {
    const auto id = number_id("right.patches." + index + ".parts." + part + ".pmax");
    return id ? pack(*id) : std::nullopt;
  };
  const auto last = packed(std::to_string(max_packed_index), std::to_string(max_packed_part));
  ASSERT_TRUE(last);
  EXPECT_EQ(unpack(*last)->index, max_packed_index);
  EXPECT_EQ(unpack(*last)->part, max_packed_part + 1);
  EXPECT_TRUE(unpack(*last)->right);
  EXPECT_FALSE(packed(std::to_string(max_packed_index + 1), "0"));
  EXPECT_FALSE(packed("0", std::to_string(max_packed_part + 1)));
}

TEST(NumberIds, InvalidIntegersAreRefused) {
  for (const std::int32_t none : {0, 1, 59, -1, 4711, INT32_MAX, INT32_MIN}) {
    EXPECT_FALSE(unpack(none)) << none;
  }
  // Of any bits only those that a name gives are taken.
  std::mt19937 bits(1);
  int taken = 0;
  for (int i = 0; i < 1000000; ++i) {
    const auto any = static_cast<std::int32_t>(bits());
    if (const auto id = unpack(any)) {
      EXPECT_EQ(pack(*id), any);
      ++taken;
    }
  }
  EXPECT_GT(taken, 0);
  const std::int32_t roll = pack(*number_id("roll")).value();
  for (int bit = 0; bit < 32; ++bit) {
    const auto other = static_cast<std::int32_t>(static_cast<std::uint32_t>(roll) ^ (1U << bit));
    const auto id = unpack(other);
    // Another number of the scene, or that of another group that has no place.
    EXPECT_TRUE(!id || (!id->right && id->index == 0 && id->part == 0)) << bit;
  }
}

TEST(JacobianNames, AreThoseOfRowsAndColumnsInTheCallersConvention) {
  Scene scene;
  scene.lateral = 2.0;
  scene.accuracy = 1e-2;
  scene.motion = Motion{.speed = 2e4, .yaw = 0.01};
  scene.derivatives = true;
  SceneResult result = solve_scene(scene);
  const ForceJacobian jacobian = *result.right->jacobian();
  const Convention si_down{Units::si, TrackFrame::right_down};
  const auto value = [&](const char* name, const Convention& convention = {}) {
    return number_value(result, std::string("right.") + name, convention).value();
  };
  EXPECT_EQ(value("jacobian.force.y.by.yaw"), jacobian[1][3]);
  EXPECT_EQ(value("jacobian.moment.z.by.yaw_rate"), jacobian[5][9]);
  // Newtons, metres and radians; lateral and vertical components and their turns change sign.
  EXPECT_DOUBLE_EQ(value("jacobian.force.x.by.lateral", si_down), -1e3 * jacobian[0][0]);
  EXPECT_DOUBLE_EQ(value("jacobian.force.z.by.vertical", si_down), 1e3 * jacobian[2][1]);
  EXPECT_DOUBLE_EQ(value("jacobian.force.y.by.yaw", si_down), jacobian[1][3]);
  EXPECT_DOUBLE_EQ(value("jacobian.moment.x.by.roll", si_down), 1e-3 * jacobian[3][2]);
  EXPECT_DOUBLE_EQ(value("jacobian.moment.z.by.lateral", si_down), jacobian[5][0]);
  EXPECT_DOUBLE_EQ(value("jacobian.moment.z.by.speed", si_down), -jacobian[5][4]);
  EXPECT_DOUBLE_EQ(value("jacobian.force.x.by.pitch_rate", si_down), jacobian[0][8]);
  const auto& by_creepage = result.right->patches.at(0).creep->derivatives.value().by_creepage;
  EXPECT_EQ(value("patches.0.creep_force.lateral.by.spin"), by_creepage[5]);
  EXPECT_DOUBLE_EQ(value("patches.0.creep_force.lateral.by.spin", si_down), 1e-3 * by_creepage[5]);
  EXPECT_DOUBLE_EQ(value("patches.0.spin_moment.by.spin", si_down), 1e-6 * by_creepage[8]);
  EXPECT_DOUBLE_EQ(value("patches.0.spin_moment.by.lateral", si_down), 1e-3 * by_creepage[7]);
  EXPECT_FALSE(number_value(result, "right.jacobian.force.x.by.pitch", Convention{}));
  const auto names = number_names(result);
  EXPECT_NE(std::find(names.begin(), names.end(), "left.jacobian.moment.y.by.roll_rate"),
            names.end());
}

} // namespace
} // namespace wrc::test::number_ids_test
