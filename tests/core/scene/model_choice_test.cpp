// The contact model of a scene, and its reason in words.
#include "scene/model_choice.hpp"

#include <gtest/gtest.h>

namespace wrc::test::model_choice_test {
namespace {

TEST(ModelChoice, IsTheRequestedModelOrTheHalfSpace) {
  Scene scene;
  EXPECT_FALSE(choose_model(scene).approximate);
  EXPECT_TRUE(choose_model(scene).reason.starts_with("auto: "));
  scene.model = ModelRequest::half_space;
  EXPECT_FALSE(choose_model(scene).approximate);
  EXPECT_EQ(choose_model(scene).name, "half-space");
  scene.model = ModelRequest::hertz;
  EXPECT_EQ(choose_model(scene).approximate, ApproximateModel::hertz);
  scene.model = ModelRequest::kik_piotrowski;
  EXPECT_EQ(choose_model(scene).name, "kik-piotrowski");
  scene.yaw = 0.01;
  EXPECT_EQ(choose_model(scene).approximate, ApproximateModel::kik_piotrowski);
  EXPECT_EQ(choose_model(scene).name, "kik-piotrowski-yawed") << "the paper's has no yaw";
}

} // namespace
} // namespace wrc::test::model_choice_test
