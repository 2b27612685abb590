/// Signs of mirror and half turn, against points and vectors that are mirrored and turned one by
/// one, for left and right wheels that roll forwards and backwards.
#include "creep/rolling_frame.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::rolling_frame_test {
namespace {

using Matrix = std::array<double, 9>;

constexpr Creepages creepages{3e-3, -5e-4, 7e-5};
constexpr Creepages other_creepages{-2e-3, 8e-4, 3e-5};
constexpr Matrix slopes{-9e5, 2e4, 3e3, 5e4, -8e5, -4e4, 6e3, 7e4, -1e4};
const Grid grid{3, 5, 0.4, 0.25, -0.3, 0.7};

/// A vector or a place in the plane.
struct InPlane {
  double x, y;
};

/// As the frames go: the picture of a place, or of a vector that is no moment.
struct Mapping {
  double along, across;

  [[nodiscard]] InPlane of(const InPlane& vector) const {
    return {along * vector.x, across * vector.y};
  }
};

InPlane slip_at(const Creepages& at, const InPlane& place) {
  return {at.longitudinal - at.spin * place.y, at.lateral + at.spin * place.x};
}

/// Slips at mapped places are the mapped slips.
void expect_mapped(const Creepages& from, const Creepages& to, const Mapping& map) {
  for (const InPlane& place : {InPlane{0.0, 0.0}, InPlane{2.0, 3.0}, InPlane{-4.0, 1.0}}) {
    const InPlane expected = map.of(slip_at(from, place));
    const InPlane found = slip_at(to, map.of(place));
    EXPECT_DOUBLE_EQ(found.x, expected.x);
    EXPECT_DOUBLE_EQ(found.y, expected.y);
  }
}

/// Of a force at a place.
CreepForces wrench_of(const InPlane& force, const InPlane& place) {
  return {force.x, force.y, place.x * force.y - place.y * force.x};
}

void expect_equal(const CreepForces& found, const CreepForces& expected) {
  EXPECT_EQ(found.longitudinal, expected.longitudinal);
  EXPECT_EQ(found.lateral, expected.lateral);
  EXPECT_EQ(found.spin_moment, expected.spin_moment);
}

CreepForces linear_law(const Matrix& by, const Creepages& at) {
  const auto row = [&](std::size_t i) {
    return by[3 * i] * at.longitudinal + by[3 * i + 1] * at.lateral + by[3 * i + 2] * at.spin;
  };
  return {row(0), row(1), row(2)};
}

class Frames : public testing::TestWithParam<std::array<bool, 2>> {
protected:
  [[nodiscard]] static bool right() { return GetParam()[0]; }
  [[nodiscard]] static bool backwards() { return GetParam()[1]; }
  const RollingFrame frame{right() ? -1.0 : 1.0, backwards()};
  const Mapping mirror{1.0, right() ? -1.0 : 1.0};
  const Mapping turn{backwards() ? -1.0 : 1.0, backwards() ? -1.0 : 1.0};
};

TEST_P(Frames, CreepagesAreThoseOfTheMappedSlips) {
  expect_mapped(creepages, frame.mirrored(creepages), mirror);
  expect_mapped(creepages, frame.turned(creepages), turn);
}

TEST_P(Frames, ForcesAreThoseOfTheMappedForceAtItsMappedPlace) {
  const InPlane force{30.0, -70.0};
  const InPlane place{2.0, 5.0};
  const CreepForces forces = wrench_of(force, place);
  expect_equal(frame.mirrored(forces), wrench_of(mirror.of(force), mirror.of(place)));
  expect_equal(frame.turned(forces), wrench_of(turn.of(force), turn.of(place)));
}

/// The traction of a stress on a mirrored area is the mirrored traction.
TEST_P(Frames, StressesPassOnMirroredTractions) {
  const auto traction = [](const Stress& s, const Vector3& normal) {
    return Vector3{s[xx] * normal.x + s[xy] * normal.y + s[xz] * normal.z,
                   s[xy] * normal.x + s[yy] * normal.y + s[yz] * normal.z,
                   s[xz] * normal.x + s[yz] * normal.y + s[zz] * normal.z};
  };
  Stress stress{};
  for (std::size_t i = 0; i < stress.size(); ++i) {
    stress[i] = 2.0 + static_cast<double>(i * i);
  }
  const Vector3 normal{1.0, 2.0, 4.0};
  const Vector3 found = traction(frame.mirrored(stress), frame.mirrored(normal));
  const Vector3 expected = frame.mirrored(traction(stress, normal));
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.y, expected.y);
  EXPECT_EQ(found.z, expected.z);
}

/// Forces from mapped creepages by mapped derivatives are the mapped forces.
TEST_P(Frames, DerivativesFollowFromThoseOfForcesAndCreepages) {
  CreepDerivatives derivatives;
  derivatives.by_creepage = slopes;
  derivatives.by_load = {0.2, -0.3, 0.5};
  derivatives.by_friction = derivatives.by_load;
  const CreepDerivatives mirrored = frame.mirrored(derivatives);
  RollingSolution solution;
  solution.by_creepage = slopes;
  const RollingSolution turned = frame.turned(solution);
  for (const Creepages& at : {creepages, other_creepages}) {
    const CreepForces forces = linear_law(slopes, at);
    expect_equal(linear_law(mirrored.by_creepage, frame.mirrored(at)), frame.mirrored(forces));
    expect_equal(linear_law(turned.by_creepage, frame.turned(at)), frame.turned(forces));
  }
  const CreepForces by_load = frame.mirrored(CreepForces{0.2, -0.3, 0.5});
  for (const auto& by : {mirrored.by_load, mirrored.by_friction}) {
    expect_equal({by[0], by[1], by[2]}, by_load);
  }
}

TEST_P(Frames, RatesAndForcesOfASolutionTurnAlike) {
  RollingSolution solution;
  solution.longitudinal_force = 3.0;
  solution.lateral_force = 5.0;
  solution.spin_moment = 7.0;
  solution.by_rate = {{3.0, 5.0, 7.0, 11.0}};
  solution.weighted_force = 13.0;
  solution.weighted_by_creepage = {17.0, 19.0, 23.0};
  const RollingSolution turned = frame.turned(solution);
  const CreepForces expected = frame.turned(CreepForces{3.0, 5.0, 7.0});
  expect_equal({turned.longitudinal_force, turned.lateral_force, turned.spin_moment}, expected);
  const std::array<double, 4>& rate = turned.by_rate[0];
  expect_equal({rate[0], rate[1], rate[2]}, expected);
  EXPECT_EQ(rate[3], 11.0); // along the normal
  EXPECT_EQ(turned.weighted_force, 13.0);
  // What changes a number that does not turn, by creepages that do.
  const Creepages by = frame.turned(Creepages{17.0, 19.0, 23.0});
  EXPECT_EQ(turned.weighted_by_creepage[0], by.longitudinal);
  EXPECT_EQ(turned.weighted_by_creepage[1], by.lateral);
  EXPECT_EQ(turned.weighted_by_creepage[2], by.spin);
}

/// Elements keep their numbers and vectors, at mapped places.
TEST_P(Frames, FieldsAreMappedElementByElement) {
  const Grid turned = frame.turned(grid);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < grid.element_count(); ++i) {
    numbers.push_back(1.0 + static_cast<double>(i));
  }
  const std::vector<double> turned_numbers = frame.turned_numbers(numbers);
  const SlipField slip = frame.turned(SlipField{numbers, frame.turned_numbers(numbers)});
  RollingSolution solution;
  solution.traction_x = solution.slip_y = solution.normal_displacement = numbers;
  solution = frame.turned(std::move(solution));
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const std::size_t i = row * grid.longitudinal_count + column;
      const std::size_t j = backwards() ? numbers.size() - 1 - i : i;
      const InPlane place = turn.of({grid.longitudinal(column), grid.lateral(row)});
      EXPECT_NEAR(turned.longitudinal(j % grid.longitudinal_count), place.x, 1e-15);
      EXPECT_NEAR(turned.lateral(j / grid.longitudinal_count), place.y, 1e-15);
      EXPECT_EQ(turned_numbers[j], numbers[i]);
      EXPECT_EQ(slip.x[j], turn.along * numbers[i]);
      EXPECT_EQ(slip.y[j], turn.across * turned_numbers[i]);
      EXPECT_EQ(solution.traction_x[j], turn.along * numbers[i]);
      EXPECT_EQ(solution.slip_y[j], turn.across * numbers[i]);
      EXPECT_EQ(solution.normal_displacement[j], numbers[i]);
    }
  }
}

/// The mirrored motions, with the mirrored forces.
TEST_P(Frames, RatesOfForcesFollowFromThoseOfForcesAndMotions) {
  const WheelForce force{{3.0, 5.0, 7.0}, {11.0, 13.0, 17.0}};
  const ForceRates rates = frame.mirrored(ForceRates{force, 2.0 * force, 3.0 * force, 4.0 * force});
  const Pose motion{frame.mirrored_lateral(1.0), frame.mirrored_lateral(1.0),
                    frame.mirrored_lateral(1.0)};
  const Vector3 mirrored_force = frame.mirrored(force.force);
  const Vector3 mirrored_moment = frame.mirrored_moment(force.moment);
  for (const auto& [rate, factor] : {std::pair(rates.lateral, motion.lateral),
                                     {rates.vertical, 2.0},
                                     {rates.roll, 3.0 * motion.roll},
                                     {rates.yaw, 4.0 * motion.yaw}}) {
    EXPECT_EQ(rate.force.x, factor * mirrored_force.x);
    EXPECT_EQ(rate.force.y, factor * mirrored_force.y);
    EXPECT_EQ(rate.force.z, factor * mirrored_force.z);
    EXPECT_EQ(rate.moment.x, factor * mirrored_moment.x);
    EXPECT_EQ(rate.moment.y, factor * mirrored_moment.y);
    EXPECT_EQ(rate.moment.z, factor * mirrored_moment.z);
  }
}

/// The mirrored wheelset in the mirrored motion, with the mirrored forces.
TEST_P(Frames, JacobiansFollowFromThoseOfForcesAndStates) {
  ForceJacobian jacobian{};
  for (std::size_t row = 0; row < jacobian.size(); ++row) {
    for (std::size_t column = 0; column < state_count; ++column) {
      jacobian[row][column] = 1.0 + static_cast<double>(state_count * row + column);
    }
  }
  const ForceJacobian mirrored = frame.mirrored(jacobian);
  const Motion motion = frame.mirrored(Motion{.speed = 1.0,
                                              .pitch = 1.0,
                                              .lateral = 1.0,
                                              .vertical = 1.0,
                                              .roll = 1.0,
                                              .yaw = 1.0,
                                              .curvature = 1.0,
                                              .acceleration = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}});
  const Pose pose = right() ? wrc::mirrored(Pose{1.0, 1.0, 1.0}) : Pose{1.0, 1.0, 1.0};
  const std::array<double, state_count> states{
      pose.lateral,    1.0,         pose.roll,     pose.yaw,  motion.speed, motion.lateral,
      motion.vertical, motion.roll, *motion.pitch, motion.yaw};
  const Vector3 force = frame.mirrored(Vector3{1.0, 1.0, 1.0});
  const Vector3 moment = frame.mirrored_moment({1.0, 1.0, 1.0});
  const std::array<double, 6> forces{force.x, force.y, force.z, moment.x, moment.y, moment.z};
  for (std::size_t row = 0; row < jacobian.size(); ++row) {
    for (std::size_t column = 0; column < state_count; ++column) {
      EXPECT_EQ(mirrored[row][column], forces[row] * states[column] * jacobian[row][column])
          << row << ' ' << column;
    }
  }
  EXPECT_EQ(motion.curvature, motion.yaw);
  EXPECT_EQ(motion.acceleration, (std::array{motion.speed, motion.lateral, motion.vertical,
                                             motion.roll, *motion.pitch, motion.yaw}));
  const RailDisplacement rail = frame.mirrored(RailDisplacement{1.0, 1.0, 1.0});
  EXPECT_EQ(rail.lateral, motion.lateral);
  EXPECT_EQ(rail.height, 1.0);
  EXPECT_EQ(rail.roll, motion.roll);
}

TEST_P(Frames, MirrorAndTurnAreTheirOwnInverses) {
  const Creepages twice = frame.turned(frame.turned(creepages));
  EXPECT_EQ(twice.longitudinal, creepages.longitudinal);
  EXPECT_EQ(twice.spin, creepages.spin);
  EXPECT_EQ(frame.mirrored(frame.mirrored(creepages)).lateral, creepages.lateral);
  const Grid back = frame.turned(frame.turned(grid));
  EXPECT_NEAR(back.longitudinal_first, grid.longitudinal_first, 1e-15);
  EXPECT_NEAR(back.lateral_first, grid.lateral_first, 1e-15);
  EXPECT_EQ(frame.turned_components(frame.turned_components({1.0, 2.0})),
            (std::vector<double>{1.0, 2.0}));
}

TEST(RollingFrame, MirrorsMotions) {
  const Motion motion{.speed = 2e4, .lateral = 5.0, .roll = 0.01, .yaw = 0.02, .curvature = 1e-6};
  const Motion other = mirrored(motion);
  EXPECT_EQ(other.lateral, -motion.lateral);
  EXPECT_EQ(other.yaw, -motion.yaw);
  EXPECT_EQ(other.speed, motion.speed);
  EXPECT_EQ(mirrored(other).roll, motion.roll);
}

INSTANTIATE_TEST_SUITE_P(Wheels, Frames,
                         testing::Values(std::array{false, false}, std::array{false, true},
                                         std::array{true, false}, std::array{true, true}),
                         [](const auto& info) {
                           return std::string(info.param[0] ? "right" : "left") +
                                  (info.param[1] ? "Backwards" : "Forwards");
                         });

} // namespace
} // namespace wrc::test::rolling_frame_test
