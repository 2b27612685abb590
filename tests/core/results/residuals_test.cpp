/// Residuals of a wheel, of pressures as they were solved and of wrong ones.
#include "results/residuals.hpp"

#include <gtest/gtest.h>

#include "scene/solve_scene.hpp"

namespace wrc::test::residuals_test {
namespace {

TEST(Residuals, AreSmallAndShowWhatIsWrong) {
  Scene scene;
  scene.side = SideChoice::left;
  SceneResult good = solve_scene(scene);
  const Residuals found = residuals_of(*good.left);
  EXPECT_LT(found.load_balance, 1e-6);
  EXPECT_GT(found.least_gap, -1e-3);
  EXPECT_LT(found.complementarity, 1e-3);
  SceneResult wrong = solve_scene(scene);
  PatchResult& patch = wrong.left->patches.front();
  for (double& pressure : patch.pressure) {
    pressure *= 1.1;
  }
  patch.force = 1.1 * patch.force;
  const Residuals shown = residuals_of(*wrong.left);
  EXPECT_GT(shown.load_balance, 0.09);
  EXPECT_GT(shown.complementarity, 0.05);
}

} // namespace
} // namespace wrc::test::residuals_test
