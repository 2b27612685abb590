// Step lengths of several boxes at once, against the conditions of the least energy.
#include "mechanics/joint_step.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace wrc::test::joint_step_test {
namespace {

constexpr std::size_t boxes = 2;
constexpr std::size_t order = 2 * boxes;

/// Energies of directions 0, 1 and pressures 2, 3; work and load.
struct System {
  std::array<std::array<double, order>, order> energy{
      {{4.0, 0.3, 1.0, 0.2}, {0.3, 3.0, 0.1, 0.9}, {1.0, 0.1, 5.0, 0.4}, {0.2, 0.9, 0.4, 2.0}}};
  std::array<double, order> work{1.0, -0.7, 0.5, 0.2};
  std::array<double, order> load{0.4, -0.4, 2.0, 3.0};
};

JointStep step_of(const System& system) {
  JointStep step;
  step.begin(boxes);
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      step.set_energy(i, j, system.energy[i][j]);
    }
    step.set_work(i, system.work[i]);
    step.set_load(i, system.load[i]);
  }
  return step;
}

std::array<double, order> answer_of(const JointStep& step) {
  return {step.step(0), step.step(1), step.growth(0), step.growth(1)};
}

/// b - A x.
std::array<double, order> work_left(const System& system, const std::array<double, order>& x) {
  std::array<double, order> left = system.work;
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j < order; ++j) {
      left[i] -= system.energy[i][j] * x[j];
    }
  }
  return left;
}

TEST(JointStep, LeavesNoWorkWithTheApproachGiven) {
  const System system;
  JointStep step = step_of(system);
  ASSERT_TRUE(step.solve(false));
  for (const double left : work_left(system, answer_of(step))) {
    EXPECT_NEAR(left, 0.0, 1e-8);
  }
}

TEST(JointStep, KeepsTheLoadAndLeavesWorkOfTheApproachOnly) {
  const System system;
  JointStep step = step_of(system);
  ASSERT_TRUE(step.solve(true));
  const std::array<double, order> x = answer_of(step);
  double load = 0.0;
  for (std::size_t i = 0; i < order; ++i) {
    load += system.load[i] * x[i];
  }
  EXPECT_NEAR(load, 0.0, 1e-12);
  const std::array<double, order> left = work_left(system, x);
  const double approach = left[2] / system.load[2];
  EXPECT_GT(std::abs(approach), 1e-3);
  for (std::size_t i = 0; i < order; ++i) {
    EXPECT_NEAR(left[i], approach * system.load[i], 1e-8) << i;
  }
}

TEST(JointStep, DirectionsWithoutEnergyAreLeftOut) {
  System system;
  for (std::size_t i = 0; i < order; ++i) {
    system.energy[1][i] = system.energy[i][1] = 0.0; // a box that rests
    system.energy[3][i] = system.energy[i][3] = 0.0; // and has no pressure
  }
  system.work[1] = system.work[3] = system.load[1] = system.load[3] = 0.0;
  JointStep step = step_of(system);
  ASSERT_TRUE(step.solve(false));
  EXPECT_EQ(step.step(1), 0.0);
  EXPECT_EQ(step.growth(1), 0.0);
  const double determinant = 4.0 * 5.0 - 1.0;
  EXPECT_NEAR(step.step(0), (5.0 * 1.0 - 1.0 * 0.5) / determinant, 1e-8);
  EXPECT_NEAR(step.growth(0), (4.0 * 0.5 - 1.0 * 1.0) / determinant, 1e-8);
}

TEST(JointStep, HandlesADirectionParallelToThePressures) {
  System system;
  system.energy[0][2] = system.energy[2][0] = 2.0 * system.energy[0][0];
  system.energy[2][2] = 4.0 * system.energy[0][0];
  system.energy[0][3] = system.energy[3][0] = 0.2;
  system.energy[2][3] = system.energy[3][2] = 0.4;
  system.energy[1][2] = system.energy[2][1] = 2.0 * system.energy[0][1];
  system.work[2] = 2.0 * system.work[0];
  JointStep step = step_of(system);
  ASSERT_TRUE(step.solve(false));
  for (const double left : work_left(system, answer_of(step))) {
    EXPECT_NEAR(left, 0.0, 1e-6);
  }
}

TEST(JointStep, ReportsAnEnergyWithoutMinimum) {
  System system;
  system.energy[0][1] = system.energy[1][0] = 5.0;
  JointStep step = step_of(system);
  EXPECT_FALSE(step.solve(true));
}

} // namespace
} // namespace wrc::test::joint_step_test
