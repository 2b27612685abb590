/// The stated error of steady creep forces on a path, against steps of time with a history.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "derivatives/steady_error.hpp"
#include "extent.hpp"
#include "results/grade.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/solve_scene.hpp"
#include "scene/varying_lists.hpp"
#include "scene/vehicle_step.hpp"

namespace wrc::test::steady_forces_test {
namespace {

constexpr double speed = 2e4; // mm/s
constexpr double radius = 460.0;

/// A value that varies along the path by waves, with its first two derivatives.
struct Waves {
  struct Wave {
    double amplitude, length, phase;
  };
  std::vector<Wave> waves;

  [[nodiscard]] std::array<double, 3> at(double s) const {
    std::array<double, 3> sum{};
    for (const Wave& wave : waves) {
      const double k = 2.0 * std::numbers::pi / wave.length;
      const double angle = k * s + wave.phase;
      sum[0] += wave.amplitude * std::sin(angle);
      sum[1] += k * wave.amplitude * std::cos(angle);
      sum[2] -= k * k * wave.amplitude * std::sin(angle);
    }
    return sum;
  }
};

/// A wheelset on a path: its height makes the load vary, its pitch rate the creepage.
struct Sequence {
  double lateral = 0.0;
  double yaw = 0.0;
  double creepage = 0.0;
  Waves load;      ///< over the mean
  Waves creepages; ///< longitudinal
};

/// Loads that vary by 5 to 40 % over 15 to 400 mm, creepages of 0.1 to 3 of saturation, of every
/// fourth sequence with a wave of their own.
Sequence drawn_sequence(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto log_between = [&](double low, double high) {
    return low * std::pow(high / low, between(0.0, 1.0));
  };
  const auto wave = [&](double amplitude) {
    return Waves::Wave{amplitude, log_between(15.0, 400.0), between(0.0, 2.0 * std::numbers::pi)};
  };
  Sequence sequence;
  sequence.lateral = between(-3.0, 2.0);
  constexpr double saturation = 2e-3; // mu N over Kalker's G a b C11
  const double size = saturation * log_between(0.1, 3.0);
  const double direction = between(0.0, 2.0 * std::numbers::pi);
  sequence.creepage = size * std::cos(direction);
  sequence.yaw = size * std::sin(direction);
  const int count = 1 + static_cast<int>(between(0.0, 3.0));
  for (int i = 0; i < count; ++i) {
    sequence.load.waves.push_back(wave(log_between(0.05, 0.4) / count));
  }
  if (seed % 4 == 0) {
    sequence.creepages.waves.push_back(wave(size * between(0.1, 0.6)));
  }
  return sequence;
}

class PathOfAWheel {
public:
  explicit PathOfAWheel(const Sequence& sequence) : sequence_(sequence) {
    scene_.side = SideChoice::left;
    scene_.accuracy = 5e-3;
    scene_.accuracy_of = AccuracyOf::forces;
    scene_.lateral = sequence.lateral;
    scene_.yaw = sequence.yaw;
    const SceneResult result = solver_.solve(scene_);
    height_ = result.left->details.vertical;
    depth_ = result.left->depth;
    roll_ = result.roll;
    length_ = 2.0 * result.left->patches.front().semi_axis_longitudinal;
  }

  [[nodiscard]] double contact_length() const { return length_; }

  SceneResult solved(double s, std::shared_ptr<const ContactHistory> history, double distance) {
    // By Hertz the load goes with depth to the power of 1.5.
    const std::array<double, 3> load = sequence_.load.at(s);
    const std::array<double, 3> creepage = sequence_.creepages.at(s);
    const double by_load = -depth_ / 1.5;
    VehicleState state;
    state.position = {0.0, sequence_.lateral, height_ + by_load * load[0], roll_,
                      0.0, sequence_.yaw};
    const double rolling = speed / radius;
    state.velocity = {speed,
                      0.0,
                      by_load * load[1] * speed,
                      0.0,
                      rolling * (1.0 - sequence_.creepage - creepage[0]),
                      0.0};
    Scene scene = scene_;
    state.derivatives = history == nullptr;
    state.time_step = history ? distance / speed : 0.0;
    state.history = std::move(history);
    scene = scene_at(scene, state);
    scene.acceleration = {
        0.0, 0.0, by_load * load[2] * speed * speed, 0.0, -rolling * creepage[1] * speed, 0.0};
    return solver_.solve(scene);
  }

private:
  Sequence sequence_;
  Scene scene_;
  SceneSolver solver_;
  double height_ = 0.0, depth_ = 0.0, roll_ = 0.0, length_ = 0.0;
};

struct Errors {
  double told = 0.0; ///< largest of the sequence, over mu N
  double true_one = 0.0;
  std::size_t lost = 0; ///< positions with another number of patches than one
};

Errors errors_of(const Sequence& sequence, double length) {
  PathOfAWheel path(sequence);
  const double step = path.contact_length() / 6.0;
  const double begin = -3.0 * path.contact_length(); // until what was before is forgotten
  auto history = std::make_shared<const ContactHistory>();
  Errors errors;
  for (double s = begin; s < length; s += step) {
    const SceneResult transient = path.solved(s, history, step);
    history = history_after(transient);
    if (s < -step) {
      continue;
    }
    const SceneResult steady = path.solved(s, nullptr, 0.0);
    if (steady.left->patches.size() != 1 || transient.left->patches.size() != 1) {
      ++errors.lost;
      continue;
    }
    const PatchResult& patch = steady.left->patches.front();
    const CreepResult& one = *patch.creep;
    const CreepResult& other = *transient.left->patches.front().creep;
    errors.true_one =
        std::max(errors.true_one, std::hypot(one.longitudinal_force - other.longitudinal_force,
                                             one.lateral_force - other.lateral_force) /
                                      (one.friction * patch.normal_force));
    errors.told = std::max(errors.told, one.steady_error.value());
  }
  return errors;
}

/// Steps of a sixth of the contact err by 0.7 % themselves, solutions by up to 0.5 %.
TEST(SteadyForces, TheirErrorIsCoveredOnRandomSequences) {
  std::vector<unsigned> all(100);
  std::iota(all.begin(), all.end(), 1U);
  const std::vector<unsigned> seeds = some_of(all, 4);
  const double length = by_extent(120.0, 40.0);
  std::size_t covered = 0;
  std::vector<double> ratios;
  for (const unsigned seed : seeds) {
    const Errors errors = errors_of(drawn_sequence(seed), length);
    ASSERT_GT(errors.true_one, 0.0);
    covered += errors.told >= errors.true_one ? 1 : 0;
    ratios.push_back(errors.told / errors.true_one);
    if (is_long_run()) {
      std::printf("%u: told %.4f, true %.4f, ratio %.2f, lost %zu\n", seed, errors.told,
                  errors.true_one, ratios.back(), errors.lost);
    }
  }
  EXPECT_GE(static_cast<double>(covered), 0.92 * static_cast<double>(seeds.size()));
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  if (is_long_run()) {
    std::printf("covered %zu of %zu, median %.2f times\n", covered, seeds.size(), *middle);
    EXPECT_LE(*middle, 4.0);
  }
}

/// The wheelset sinks by `slope` as it travels.
Scene sinking_scene(double slope) {
  Scene scene;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  scene.vertical = 459.75; // 0.07 mm below the first touch
  scene.derivatives = true;
  scene.motion.emplace();
  scene.motion->speed = speed;
  scene.motion->pitch = 1.003 * speed / radius;
  scene.motion->vertical = -slope * speed;
  scene.motion->vertical_is_given = true;
  return scene;
}

bool warns_of_steady_forces(const SceneResult& result) {
  const Warnings warnings = all_warnings(result);
  return std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.kind == WarningClass::steady_forces;
  });
}

TEST(SteadyForces, TheirErrorFollowsTheRatesAlongThePath) {
  const SceneResult still = solve_scene(sinking_scene(0.0));
  EXPECT_LT(still.left->patches.front().creep->steady_error.value(), 1e-12);
  EXPECT_FALSE(warns_of_steady_forces(still));
  // Rolling contact at Hertz's rates: dF/F is at most dN/N, of 1.5 of the depth's.
  const SceneResult sinking = solve_scene(sinking_scene(1e-4));
  const PatchResult& patch = sinking.left->patches.front();
  const double error = patch.creep->steady_error.value();
  const double length = 2.0 * patch.semi_axis_longitudinal;
  EXPECT_GT(error, 0.1 * 0.7 * length * 1e-4 / sinking.left->depth);
  EXPECT_LT(error, 1.5 * 0.7 * length * 1e-4 / sinking.left->depth);
  EXPECT_NEAR(solve_scene(sinking_scene(2e-4)).left->patches.front().creep->steady_error.value(),
              2.0 * error, 0.02 * error);
  EXPECT_TRUE(warns_of_steady_forces(solve_scene(sinking_scene(1e-2))));
  EXPECT_NEAR(sinking.right->patches.front().creep->steady_error.value(), error, 1e-3 * error)
      << "both sides";
}

/// Rails that fall as the wheelset does: nothing changes between them.
TEST(SteadyForces, SlopesOfRailsAndTheirVelocitiesCountAgainstTheWheelset) {
  Scene scene = sinking_scene(1e-3);
  scene.left.slope = {0.0, -1e-3, 0.0};
  scene.right.slope = scene.left.slope;
  EXPECT_LT(solve_scene(scene).left->patches.front().creep->steady_error.value(), 1e-6);
  scene.left.slope = {};
  scene.left.velocity = {0.0, -1e-3 * speed, 0.0};
  EXPECT_LT(solve_scene(scene).left->patches.front().creep->steady_error.value(), 1e-6);
}

TEST(SteadyForces, ErrorIsNotKnownWithoutRatesAndChangesNoForce) {
  Scene scene = sinking_scene(1e-4);
  const SceneResult with = solve_scene(scene);
  scene.derivatives = false;
  const SceneResult without = solve_scene(scene);
  const CreepResult& creep = *without.left->patches.front().creep;
  EXPECT_FALSE(creep.steady_error);
  scene.derivatives = true;
  scene.acceleration = {0.0, 1e4, -1e4, 1.0, 1e3, 1.0};
  scene.left.slope = {1e-3, 1e-3, 1e-6};
  const SceneResult other = solve_scene(scene);
  EXPECT_NE(other.left->patches.front().creep->steady_error,
            with.left->patches.front().creep->steady_error);
  for (const SceneResult* one : {&with, &other}) {
    EXPECT_EQ(one->left->patches.front().creep->longitudinal_force, creep.longitudinal_force);
    EXPECT_EQ(one->left->patches.front().creep->lateral_force, creep.lateral_force);
  }
  for (const double speed : {0.0, 0.5}) {
    scene.motion->speed = speed;
    EXPECT_FALSE(solve_scene(scene).left->patches.front().creep->steady_error) << "standstill";
  }
}

/// Two errors just below the accuracy are above it together.
TEST(SteadyForces, TheirWarningsCountTheErrorOfElements) {
  Scene scene = sinking_scene(1e-4);
  SceneResult result = solve_scene(scene);
  WheelResult& wheel = *result.left;
  wheel.warnings = {{WarningClass::creep_accuracy, "of elements", 1.9}};
  for (PatchResult& patch : wheel.patches) {
    patch.creep->error_estimate = 0.019;
    patch.creep->steady_error = 0.019;
  }
  warn_of_steady_forces(wheel, 0.01);
  ASSERT_EQ(wheel.warnings.size(), 2U);
  EXPECT_EQ(grade_of(wheel.warnings[0]), Grade::do_not_use);
  wheel.warnings.clear();
  warn_of_steady_forces(wheel, 0.02);
  ASSERT_EQ(wheel.warnings.size(), 1U);
  EXPECT_EQ(grade_of(wheel.warnings[0]), Grade::slightly_over);
  wheel.warnings.clear();
  warn_of_steady_forces(wheel, 0.03);
  EXPECT_TRUE(wheel.warnings.empty());
}

TEST(SteadyForces, AccelerationAloneIsNoMotion) {
  Scene scene;
  scene.acceleration = {0.0, 100.0, 0.0, 0.0, 0.0, 0.0};
  const SceneResult result = solve_scene(scene);
  EXPECT_FALSE(result.pitch);
  EXPECT_FALSE(result.left->patches.front().creep);
}

class VaryingSteadyForces : public VaryingScene {};

/// At the end of a flat forces change within a contact length, beside it not at all.
TEST_F(VaryingSteadyForces, TheirErrorIncludesWhatTheProfileChanges) {
  Scene scene = scene_on("60E1", wheel_with_chord());
  scene.side = SideChoice::left;
  scene.derivatives = true;
  scene.motion->pitch = 1.003 * scene.motion->speed / scene.nominal_radius();
  scene.pitch = 0.3;
  const double beside = solve_scene(scene).left->patches.front().creep->steady_error.value();
  scene.pitch = 0.06;
  const double at_end = solve_scene(scene).left->patches.front().creep->steady_error.value();
  EXPECT_LT(beside, 1e-2);
  EXPECT_GT(at_end, 2e-2);
}

} // namespace
} // namespace wrc::test::steady_forces_test
