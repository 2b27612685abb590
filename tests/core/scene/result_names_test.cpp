#include "scene/result_names.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "derivatives/wheel_rates.hpp"
#include "scene/solve_scene.hpp"

namespace wrc::test::result_names_test {
namespace {

TEST(ResultNames, APrefixIsRemovedOnlyIfPresent) {
  std::string_view name = "left.pmax";
  EXPECT_FALSE(strip_prefix(name, "right."));
  EXPECT_EQ(name, "left.pmax");
  EXPECT_TRUE(strip_prefix(name, "left."));
  EXPECT_EQ(name, "pmax");
}

TEST(ResultNames, IndexBelowTheCount) {
  std::size_t index = 99;
  std::string_view name = "12.pmax";
  EXPECT_TRUE(strip_index(name, 13, index));
  EXPECT_EQ(index, 12U);
  EXPECT_EQ(name, "pmax");
  for (const std::string_view wrong : {"12.pmax", "-1.pmax", "x.pmax", ".pmax", "", "3", "3x"}) {
    std::string_view rest = wrong;
    EXPECT_FALSE(strip_index(rest, 12, index)) << wrong;
  }
}

SceneResult rolling_wheel() {
  Scene scene;
  scene.side = SideChoice::left;
  scene.accuracy = 0.1;
  scene.left.creepages = Creepages{1e-3, 5e-4, 1e-4};
  scene.derivatives = true;
  return solve_scene(scene);
}

/// Whether a name has this part; each of them has a value.
bool lists(SceneResult& result, const std::string& part) {
  bool found = false;
  for (const std::string& name : number_names(result)) {
    EXPECT_TRUE(number_value(result, name).has_value()) << name;
    found = found || name.find(part) != std::string::npos;
  }
  return found;
}

TEST(ResultNames, EachHasAValue) {
  SceneResult result = rolling_wheel();
  EXPECT_TRUE(lists(result, "sensitivities."));
  EXPECT_TRUE(lists(result, "jacobian."));
}

/// A solution that had not converged listed a Jacobian that it did not have.
TEST(ResultNames, LeaveOutRatesThatAreNotFinite) {
  SceneResult result = rolling_wheel();
  SceneWheel& wheel = result.left.value();
  wheel = SceneWheel(WheelResult(wheel)); // without the sensitivities of its creep forces
  wheel.patches.front().frame.origin.x = std::numeric_limits<double>::quiet_NaN();
  ASSERT_EQ(wheel.sensitivities(), nullptr);
  wheel.stop_reason = StopReason::iteration_limit;
  EXPECT_FALSE(lists(result, "sensitivities."));
  EXPECT_FALSE(lists(result, "jacobian."));
}

/// A failed solution that ended above the first touch read beyond an array of no planes.
TEST(ResultNames, LeaveOutRatesAboveTheFirstTouch) {
  SceneResult result = rolling_wheel();
  SceneWheel& wheel = result.left.value();
  wheel = SceneWheel(WheelResult(wheel)); // without the sensitivities of its creep forces
  wheel.depth = -0.025;
  EXPECT_EQ(wheel.sensitivities(), nullptr);
  EXPECT_FALSE(lists(result, "sensitivities."));
  EXPECT_FALSE(lists(result, "jacobian."));
}

} // namespace
} // namespace wrc::test::result_names_test
