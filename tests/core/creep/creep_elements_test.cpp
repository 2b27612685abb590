// Elements of creep forces share a limit, and each counts as often as it is solved.
#include "creep/creep_elements.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "creep/constants.hpp"
#include "records/wheel_result.hpp"

namespace wrc::test::creep_elements_test {
namespace {

/// Hertz's pressures on an ellipse.
PatchResult patch_of(double a, double b) {
  PatchResult patch;
  patch.grid = {60, 80, 2.2 * b / 60.0, 2.2 * a / 80.0, -1.1 * b, -1.1 * a};
  patch.grid.lateral_first += 0.5 * patch.grid.lateral_step;
  patch.grid.longitudinal_first += 0.5 * patch.grid.longitudinal_step;
  for (std::size_t row = 0; row < 60; ++row) {
    for (std::size_t column = 0; column < 80; ++column) {
      const double y = patch.grid.lateral(row) / b;
      const double x = patch.grid.longitudinal(column) / a;
      patch.pressure.push_back(1000.0 * std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
  }
  patch.normal_force = 1000.0 * 2.0 / 3.0 * 3.14159 * a * b;
  return patch;
}

CreepRequest request_of(CreepModel model) {
  CreepRequest request;
  request.model = model;
  request.accuracy = 1e-2;
  return request;
}

double wanted_by(const PatchResult& patch, const CreepRequest& request) {
  return grid_of_patch(patch, SmoothPressure(patch.grid, patch.pressure), request).wanted;
}

TEST(CreepElements, ModelsThatNeedPressures) {
  EXPECT_TRUE(on_own_pressures(request_of(CreepModel::full)));
  EXPECT_FALSE(on_own_pressures(request_of(CreepModel::fastsim)));
  CreepRequest unlike = request_of(CreepModel::full);
  EXPECT_FALSE(unlike_bodies(unlike));
  unlike.material.difference_parameter = 0.1;
  EXPECT_TRUE(unlike_bodies(unlike));
  unlike.model = CreepModel::fastsim;
  EXPECT_FALSE(unlike_bodies(unlike));
}

TEST(CreepElements, OfAFreePitchCountOncePerSolution) {
  const PatchResult patch = patch_of(6.0, 4.0);
  CreepRequest request = request_of(CreepModel::full);
  const double once = wanted_by(patch, request);
  request.pitch_is_free = true;
  EXPECT_NEAR(wanted_by(patch, request), cost_of_free_pitch * once, 1e-9 * once);
}

TEST(CreepElements, KeepWithinTheirLimit) {
  const PatchResult patch = patch_of(6.0, 4.0);
  CreepRequest request = request_of(CreepModel::full);
  request.accuracy = 1e-4;
  request.element_limit = 600.0;
  const CreepGrid chosen =
      grid_of_patch(patch, SmoothPressure(patch.grid, patch.pressure), request);
  EXPECT_GT(chosen.wanted, 600.0);
  EXPECT_LE(static_cast<double>(chosen.grid.element_count()), 600.0);
  EXPECT_GT(static_cast<double>(chosen.grid.element_count()), 300.0) << "as many as there may be";
}

TEST(CreepElements, OfACutContactAreNoFinerThanItsPlace) {
  WheelResult wheel;
  wheel.patches = {patch_of(6.0, 4.0)};
  wheel.discretisation_error = 0.1;
  CreepRequest request = request_of(CreepModel::full);
  request.accuracy = 1e-3;
  EXPECT_EQ(with_elements(request, wheel).accuracy, 1e-3) << "whole: the error of the peak, say";
  wheel.is_cut = true;
  EXPECT_EQ(with_elements(request, wheel).accuracy, 0.1);
  EXPECT_LT(wanted_by(wheel.patches[0], with_elements(request, wheel)),
            0.1 * wanted_by(wheel.patches[0], request));
  wheel.discretisation_error = 3.0; // once a tolerance that no iteration takes
  EXPECT_EQ(with_elements(request, wheel).accuracy, coarsest_of_cut);
  wheel.discretisation_error = 1e-4;
  EXPECT_EQ(with_elements(request, wheel).accuracy, 1e-3);
}

TEST(CreepElements, PatchesGetTheSameFractionOfTheirNeed) {
  WheelResult wheel;
  wheel.patches = {patch_of(6.0, 4.0), patch_of(3.0, 2.0)};
  CreepRequest request = request_of(CreepModel::full);
  EXPECT_EQ(share_of_elements(wheel, request), 1.0) << "the limit is far";
  const double need = wanted_by(wheel.patches[0], request) + wanted_by(wheel.patches[1], request);
  request.element_limit = 0.5 * need;
  EXPECT_NEAR(share_of_elements(wheel, request), 0.5, 0.02);
  request.element_share = share_of_elements(wheel, request);
  double elements = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    elements += static_cast<double>(
        grid_of_patch(patch, SmoothPressure(patch.grid, patch.pressure), request)
            .grid.element_count());
  }
  EXPECT_LE(elements, 0.5 * need);
  EXPECT_EQ(share_of_elements(wheel, request_of(CreepModel::polach)), 1.0);
  wheel.patches.pop_back();
  EXPECT_EQ(share_of_elements(wheel, request), 1.0) << "a single patch has the whole limit";
}

} // namespace
} // namespace wrc::test::creep_elements_test
