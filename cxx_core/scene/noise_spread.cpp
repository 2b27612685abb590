#include "scene/noise_spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.hpp"
#include "measured/constants.hpp"
#include "scene/constants.hpp"
#include "scene/number_tables.hpp"
#include "scene/solve_scene.hpp"

namespace wrc {
namespace {

/// Which curves of the profiles are taken, and which of them; without, those of the result.
struct Line {
  std::vector<Curve> ProfileDoubt::*curves = nullptr;
  std::size_t number = 0;
  bool is_of_all = false; ///< smoothed ones also of profiles whose waves are no noise
};

bool is_changed(const ProfileDoubt& doubt, const Line& line) {
  return line.curves == &ProfileDoubt::likely ||
         (line.curves == &ProfileDoubt::smoothed && (line.is_of_all || doubt.is_of_waves));
}

const Curve& curve_of(const ProfileDoubt& doubt, const Line& line) {
  return is_changed(doubt, line) && line.number < (doubt.*line.curves).size()
             ? (doubt.*line.curves)[line.number]
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
  choice.options = {.rail_origin = choice.options.rail_origin};
}

/// The scene with curves of its profiles, on grids by accuracy, whatever the caller's are.
Scene scene_with(const NoisyScene& noisy, const Line& line) {
  Scene scene = noisy.scene;
  take_curve(scene.left.wheel, ProfileKind::wheel, noisy.left_wheel, line);
  take_curve(scene.left.rail, ProfileKind::rail, noisy.left_rail, line);
  take_curve(scene.right.wheel, ProfileKind::wheel, noisy.right_wheel, line);
  take_curve(scene.right.rail, ProfileKind::rail, noisy.right_rail, line);
  scene.accuracy = std::max(scene.accuracy, likely_line_accuracy);
  // All lines together take no more elements than one solution may.
  scene.element_limit = std::max(scene.element_limit.value_or(usual_spread_elements) / likely_lines,
                                 least_line_elements);
  scene.grid.reset();
  scene.tolerance = Scene().tolerance;
  scene.solver = SolverChoice::standard;
  scene.elements = Elements::smooth;
  scene.derivatives = false;
  scene.damage = {};
  if (scene.load_of != LoadOf::total) {
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

constexpr Numbers no_numbers = [] {
  Numbers numbers{};
  numbers.fill(std::numeric_limits<double>::quiet_NaN());
  return numbers;
}();

/// Of the lines from the first one to `most`, or to the last that all profiles have.
std::vector<Numbers> numbers_of_lines(const NoisyScene& noisy, Line line, std::size_t most) {
  for (const NoisyScene::Doubt* doubt :
       {&noisy.left_wheel, &noisy.left_rail, &noisy.right_wheel, &noisy.right_rail}) {
    if (doubt->valid() && is_changed(doubt->get(), line)) {
      most = std::min(most, (doubt->get().*line.curves).size());
    }
  }
  SceneSolver solver;
  std::vector<Numbers> lines;
  for (; line.number < most; ++line.number) {
    lines.push_back(numbers_with(noisy, line, solver).value_or(no_numbers));
  }
  return lines;
}

/// Mean squares of differences from the result; not-a-number of too few.
Numbers mean_squares(const std::vector<Numbers>& lines, const Numbers& centre, int least) {
  Numbers squares{};
  for (std::size_t i = 0; i < squares.size(); ++i) {
    int count = 0;
    for (const Numbers& numbers : lines) {
      const double difference = numbers[i] - centre[i];
      if (std::isfinite(difference)) {
        squares[i] += difference * difference;
        ++count;
      }
    }
    squares[i] = count >= least ? squares[i] / count : std::numeric_limits<double>::quiet_NaN();
  }
  return squares;
}

std::vector<double> radius_differences(const std::vector<Numbers>& lines) {
  std::vector<double> differences;
  differences.reserve(lines.size());
  for (const Numbers& numbers : lines) {
    differences.push_back(numbers[0]);
  }
  return differences;
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
    number = spread_deviations * std::sqrt(number);
  }
  return {known(squares[0]),
          wheel_spread(centre, squares, 1),
          wheel_spread(centre, squares, 3),
          {},
          {}};
}

SceneSpread spread_from(const NoisyScene& noisy) {
  SceneSolver solver;
  const std::optional<Numbers> solved = numbers_with(noisy, {}, solver);
  if (!solved) {
    return {};
  }
  const Numbers& centre = *solved;
  const std::vector<Numbers> likely =
      numbers_of_lines(noisy, {&ProfileDoubt::likely}, likely_lines);
  Numbers squares = mean_squares(likely, centre, least_spread_solutions);
  std::vector<Numbers> smoothed;
  if (std::ranges::any_of(
          std::array{noisy.left_wheel, noisy.left_rail, noisy.right_wheel, noisy.right_rail},
          [](const NoisyScene::Doubt& doubt) {
            return doubt.valid() && doubt.get().is_of_waves;
          })) {
    smoothed = numbers_of_lines(noisy, {&ProfileDoubt::smoothed, 1}, smoothed_waves.size());
    const Numbers waves = mean_squares(smoothed, centre, 1);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      squares[i] += waves[i];
    }
  }
  SceneSpread spread = spread_of_numbers(centre, squares);
  spread.likely_differences = radius_differences(likely);
  spread.smoothed_differences = radius_differences(smoothed);
  return spread;
}

SmoothedScene smoothed_from(const NoisyScene& noisy) {
  const std::vector<Numbers> lines =
      numbers_of_lines(noisy, {&ProfileDoubt::smoothed, 0, true}, smoothed_waves.size());
  SmoothedScene smoothed;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    smoothed.left[i] = {known(lines[i][1]), known(lines[i][2])};
    smoothed.right[i] = {known(lines[i][3]), known(lines[i][4])};
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
