// Differences of cheaper laws by creepages.
#include "creep/creep_on_patch.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "creep/creep_request.hpp"

namespace wrc::test::creep_on_patch_test {
namespace {

PatchResult some_patch() {
  PatchResult patch;
  patch.normal_force = 8e4;
  patch.semi_axis_longitudinal = 6.0;
  patch.semi_axis_lateral = 4.0;
  patch.grid = {10, 10, 1.0, 1.0, 0.0, 0.0};
  return patch;
}

CreepRequest some_request() {
  CreepRequest request;
  request.model = CreepModel::polach;
  request.material.modulus = 82000.0;
  return request;
}

/// Central differences of a quadratic law are exact.
TEST(CreepOnPatch, DifferencesOfAQuadraticLawAreExact) {
  PatchMotion motion;
  motion.friction = 0.3;
  const Creepages at{1e-3, -5e-4, 1e-4};
  const auto derivatives =
      difference_by_creepage(some_patch(), some_request(), motion, at, [](const Creepages& w) {
        return std::array{-5e7 * w.longitudinal + 1e9 * w.longitudinal * w.lateral,
                          -4e7 * w.lateral - 2e7 * w.spin, 3e7 * w.spin * w.spin};
      });
  const std::array<double, 9> exact{-5e7 + 1e9 * at.lateral,
                                    1e9 * at.longitudinal,
                                    0.0,
                                    0.0,
                                    -4e7,
                                    -2e7,
                                    0.0,
                                    0.0,
                                    6e7 * at.spin};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(derivatives[i], exact[i], 1e-2) << i; // of 5e7: rounding of the differences
  }
}

/// The step is a share of the creepage at which all slides: of a law that saturates there,
/// differences leave no more than their second order.
TEST(CreepOnPatch, StepsResolveASaturatingLaw) {
  PatchMotion motion;
  motion.friction = 0.3;
  const double whole = 0.3 * 8e4;
  const double size = 82000.0 * 24.0 / whole; // of creepages at which the contact slides
  const auto derivatives =
      difference_by_creepage(some_patch(), some_request(), motion, {}, [&](const Creepages& w) {
        return std::array{-whole * std::tanh(size * w.longitudinal)};
      });
  EXPECT_NEAR(derivatives[0] / (-whole * size), 1.0, 1e-4);
  EXPECT_NE(derivatives[0], -whole * size) << "a step that is not too small";
}

TEST(CreepOnPatch, WithoutFrictionOnlyTheLinearLawHasDerivatives) {
  PatchMotion motion;
  CreepRequest request = some_request();
  const auto law = [](const Creepages& w) { return std::array{-w.longitudinal}; };
  EXPECT_EQ(difference_by_creepage(some_patch(), request, motion, {}, law)[0], 0.0);
  request.model = CreepModel::linear;
  EXPECT_NEAR(difference_by_creepage(some_patch(), request, motion, {}, law)[0], -1.0, 1e-10);
}

} // namespace
} // namespace wrc::test::creep_on_patch_test
