/// The map of features: through them, ascending, C2, exact where nothing differs.
#include <vector>

#include <gtest/gtest.h>

#include "geometry/feature_map.hpp"

namespace wrc::test::feature_map_test {
namespace {

TEST(FeatureMap, EqualFeaturesGiveTheParameterToTheBit) {
  const std::vector<double> features{0.0, 0.1, 33.3, 87.01};
  const FeatureMap map(features, features);
  for (const double u : {0.0, 0.07, 12.345, 86.9}) {
    const QuinticValues arc = map.at(u < 0.1 ? 0 : u < 33.3 ? 1 : 2, u);
    EXPECT_EQ(arc.value, u);
    EXPECT_EQ(arc.first, 1.0);
    EXPECT_EQ(arc.second, 0.0);
  }
}

TEST(FeatureMap, AscendsAndIsC2ForPartsOfAnyLength) {
  const std::vector<double> parameters{0.0, 10.0, 20.0, 21.0, 60.0};
  const std::vector<double> arcs{3.0, 3.5, 33.0, 33.1, 40.0};
  const FeatureMap map(parameters, arcs);
  for (std::size_t k = 0; k + 1 < parameters.size(); ++k) {
    const QuinticValues end = map.at(k, parameters[k + 1]);
    EXPECT_NEAR(map.at(k, parameters[k]).value, arcs[k], 1e-14);
    EXPECT_NEAR(end.value, arcs[k + 1], 1e-12);
    EXPECT_NEAR(end.second, 0.0, 1e-11);
    if (k + 2 < parameters.size()) {
      EXPECT_NEAR(end.first, map.at(k + 1, parameters[k + 1]).first, 1e-12);
    }
    for (int i = 0; i <= 1000; ++i) {
      const double share = i / 1000.0;
      EXPECT_GT(map.at(k, parameters[k] + share * (parameters[k + 1] - parameters[k])).first, 0.0);
    }
  }
}

} // namespace
} // namespace wrc::test::feature_map_test
