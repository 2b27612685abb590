#include "scene/noise_spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "measured/constants.hpp"
#include "scene/number_tables.hpp"
#include "scene/solve_scene.hpp"

namespace wrc {
namespace {

/// Deviations that hold the truth in 95 of 100 cases.
/// origin: published: Student's distribution with ten degrees of freedom (likely_lines).
constexpr double deviations = 2.228;
/// Solutions that a spread is computed from, at least.
/// origin: reasoned: with seven degrees of freedom the deviations are 2.36, 6 % more; fewer are
/// those of the smoother lines only.
constexpr int least_solutions = 7;
/// Accuracy of the solutions with likely curves.
/// origin: reasoned: a spread of 10 % is then known to a few per cent, as its number of lines knows
/// it to 22 %.
constexpr double likely_accuracy = 1e-2;

/// Spread over its result above which it is a little over, and beyond usable_excess of which the
/// result is not to be used.
/// origin: reasoned: points with a spread of 20 % do not say what a pressure is.
constexpr double usable_spread = 0.1;

/// Elements that a line has in any case.
/// origin: bound: the least that solve.element_limit permits.
constexpr double least_element_limit = 1e3;

/// Which curves of the profiles are taken, and which of them; without, those of the result.
struct Line {
  std::vector<Curve> ProfileDoubt::*curves = nullptr;
  std::size_t number = 0;
  bool is_of_all = false; ///< smoothed ones also of profiles whose waves are no noise
};

const Curve& curve_of(const ProfileDoubt& doubt, const Line& line) {
  const bool is_changed =
      line.curves == &ProfileDoubt::likely ||
      (line.curves == &ProfileDoubt::smoothed && (line.is_of_all || doubt.is_of_waves));
  return is_changed && line.number < (doubt.*line.curves).size() ? (doubt.*line.curves)[line.number]
                                                                 : doubt.curve;
}

void take_curve(ProfileChoice& choice, ProfileKind kind, const NoisyScene::Doubt& doubt,
                const Line& line) {
  if (!doubt.valid()) {
    return;
  }
  auto profile = std::make_shared<Profile>();
  profile->name = choice.name;
  profile->kind = kind;
  profile->curve = curve_of(doubt.get(), line);
  choice.given = std::move(profile);
  choice.smoothing.reset();
}

/// The scene with curves of its profiles, on grids by accuracy, whatever the caller's are.
Scene scene_with(const NoisyScene& noisy, const Line& line) {
  Scene scene = noisy.scene;
  take_curve(scene.left.wheel, ProfileKind::wheel, noisy.left_wheel, line);
  take_curve(scene.left.rail, ProfileKind::rail, noisy.left_rail, line);
  take_curve(scene.right.wheel, ProfileKind::wheel, noisy.right_wheel, line);
  take_curve(scene.right.rail, ProfileKind::rail, noisy.right_rail, line);
  scene.accuracy = std::max(scene.accuracy, likely_accuracy);
  // All lines together take no more elements than one solution may.
  scene.element_limit = std::max(scene.element_limit / likely_lines, least_element_limit);
  scene.grid.reset();
  scene.tolerance = Scene().tolerance;
  scene.solver = SolverChoice::standard;
  scene.derivatives = false;
  scene.damage = {};
  if (!scene.left.total_load && !scene.right.total_load) {
    scene.motion.reset();
    scene.left.creepages.reset();
    scene.right.creepages.reset();
  }
  return scene;
}

double area_of(const WheelResult& wheel) {
  double area = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    area += number_tables::area_of_patch(patch);
  }
  return area;
}

/// rolling_radius_difference, and pmax and area of both wheels; not-a-number where there is none.
using Numbers = std::array<double, 5>;

Numbers numbers_of(const SceneResult& result) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Numbers numbers{result.rolling_radius_difference.value_or(none), none, none, none, none};
  std::size_t at = 1;
  for (const std::optional<SceneWheel>* wheel : {&result.left, &result.right}) {
    if (*wheel && (*wheel)->solved) {
      numbers[at] = number_tables::peak_of((*wheel)->is_unbounded, (*wheel)->pmax);
      numbers[at + 1] = area_of(**wheel);
    }
    at += 2;
  }
  return numbers;
}

/// None of a line that does not touch the rail, say.
std::optional<Numbers> numbers_with(const NoisyScene& noisy, const Line& line,
                                    SceneSolver& solver) {
  try {
    return numbers_of(solver.solve(scene_with(noisy, line)));
  } catch (const Error& error) {
    if (error.code() == ErrorCode::out_of_memory) {
      throw;
    }
    return std::nullopt;
  }
}

/// Mean squares of differences from the result, of the lines from the first one up to `most`;
/// not-a-number of too few.
Numbers mean_squares(const NoisyScene& noisy, const Numbers& centre, Line line, std::size_t most,
                     int least) {
  SceneSolver solver;
  Numbers squares{};
  std::array<int, std::tuple_size_v<Numbers>> counts{};
  std::size_t lines = most;
  for (const NoisyScene::Doubt* doubt :
       {&noisy.left_wheel, &noisy.left_rail, &noisy.right_wheel, &noisy.right_rail}) {
    if (doubt->valid() && (line.curves == &ProfileDoubt::likely || doubt->get().is_of_waves)) {
      lines = std::min(lines, (doubt->get().*line.curves).size());
    }
  }
  for (; line.number < lines; ++line.number) {
    if (const std::optional<Numbers> numbers = numbers_with(noisy, line, solver)) {
      for (std::size_t i = 0; i < numbers->size(); ++i) {
        const double difference = (*numbers)[i] - centre[i];
        if (std::isfinite(difference)) {
          squares[i] += difference * difference;
          ++counts[i];
        }
      }
    }
  }
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squares[i] =
        counts[i] >= least ? squares[i] / counts[i] : std::numeric_limits<double>::quiet_NaN();
  }
  return squares;
}

std::optional<double> known(double number) {
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Of pmax and area, which begin there.
WheelSpread wheel_spread(const Numbers& centre, const Numbers& spreads, std::size_t begin) {
  WheelSpread wheel{{known(spreads[begin]), known(spreads[begin + 1])}, {}};
  for (const std::size_t i : {begin, begin + 1}) {
    if (std::isfinite(spreads[i])) {
      const double excess = spreads[i] > 0.0 ? spreads[i] / (usable_spread * centre[i]) : 0.0;
      wheel.grade = std::max(wheel.grade.value_or(Grade::fine),
                             grade_of(Warning{WarningClass::profile_noise, {}, excess}));
    }
  }
  return wheel;
}

SceneSpread spread_of_numbers(const Numbers& centre, Numbers squares) {
  for (double& number : squares) {
    number = deviations * std::sqrt(number);
  }
  return {known(squares[0]), wheel_spread(centre, squares, 1), wheel_spread(centre, squares, 3)};
}

SceneSpread spread_from(const NoisyScene& noisy) {
  SceneSolver solver;
  const std::optional<Numbers> solved = numbers_with(noisy, {}, solver);
  if (!solved) {
    return {};
  }
  const Numbers& centre = *solved;
  Numbers squares =
      mean_squares(noisy, centre, {&ProfileDoubt::likely}, likely_lines, least_solutions);
  const bool is_of_waves = std::ranges::any_of(
      std::array{noisy.left_wheel, noisy.left_rail, noisy.right_wheel, noisy.right_rail},
      [](const NoisyScene::Doubt& doubt) { return doubt.valid() && doubt.get().is_of_waves; });
  if (is_of_waves) {
    const Numbers waves =
        mean_squares(noisy, centre, {&ProfileDoubt::smoothed, 1}, smoothed_waves.size(), 1);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      squares[i] += waves[i];
    }
  }
  return spread_of_numbers(centre, squares);
}

SmoothedScene smoothed_from(const NoisyScene& noisy) {
  SceneSolver solver;
  SmoothedScene smoothed;
  for (std::size_t i = 0; i < smoothed_waves.size(); ++i) {
    if (const auto numbers = numbers_with(noisy, {&ProfileDoubt::smoothed, i, true}, solver)) {
      smoothed.left[i] = {known((*numbers)[1]), known((*numbers)[2])};
      smoothed.right[i] = {known((*numbers)[3]), known((*numbers)[4])};
    }
  }
  return smoothed;
}

} // namespace

SceneSpread exact_spread(const SceneResult& result) {
  const Numbers centre = numbers_of(result);
  Numbers squares = centre;
  for (double& square : squares) {
    square *= 0.0;
  }
  return spread_of_numbers(centre, squares);
}

const SceneSpread& spread_of(SceneResult& result) {
  if (!result.spread) {
    result.spread = result.noise ? spread_from(*result.noise) : exact_spread(result);
  }
  return *result.spread;
}

const SmoothedScene* smoothed_of(SceneResult& result) {
  if (!result.smoothed && result.noise) {
    result.smoothed = smoothed_from(*result.noise);
  }
  return result.smoothed ? &*result.smoothed : nullptr;
}

} // namespace wrc
