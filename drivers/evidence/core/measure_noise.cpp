/// Largest pressures and conicities of wheels whose points have noise, against those of the points
/// without it.
///
///   measure_noise [SAMPLES [FOLDER [STRIDE [REPEATS]]]]     default 5, no measured wheels, 1 and 1
///
/// FOLDER holds measured wheels in columns (tests/reference/profiles of the sources). Prints, for
/// S1002 at y = 0, pmax with the smoothing wavelengths that a user might choose and with the
/// automatic smoothing; for each sort of noise how often pmax and the conicity are within 5 % of
/// the truth and within the spread, with one of STRIDE samples, each REPEATS times with other
/// noise; and what the automatic smoothing changes of points that have no noise added.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "base/error.hpp"
#include "measured/noisy_points.hpp"
#include "measured/readers.hpp"
#include "profile/standard_profiles.hpp"
#include "reports/conicity.hpp"
#include "scene/solve_scene.hpp"

namespace {

using namespace wrc;
using namespace wrc::test;

struct Wheel {
  std::string name;
  Profile profile;
};

/// A result and its spread.
struct Found {
  double value = std::numeric_limits<double>::quiet_NaN();
  double spread = std::numeric_limits<double>::quiet_NaN();
};

Scene scene_with(const Profile& wheel) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = wheel.name;
  scene.left.wheel.given = scene.right.wheel.given = std::make_shared<const Profile>(wheel);
  return scene;
}

Found pressure_of(const Profile& wheel, double lateral, double accuracy = 1e-2) {
  Scene scene = scene_with(wheel);
  scene.side = SideChoice::left;
  scene.lateral = lateral;
  scene.accuracy = accuracy;
  SceneResult result = solve_scene(scene);
  Found pressure;
  pressure.value = number_value(result, "left.pmax").value_or(pressure.value);
  pressure.spread = number_value(result, "left.spread.pmax").value_or(pressure.spread);
  return pressure;
}

ReadOptions options_with(double smoothing, WheelOrigin origin) {
  ReadOptions options;
  options.kind = ProfileKind::wheel;
  options.origin = origin;
  options.smoothing_wavelength = smoothing;
  return options;
}

Profile noisy(const Wheel& wheel, const Noise& noise, double smoothing) {
  return profile_through(noisy_points(wheel.profile.curve, noise), "noisy",
                         options_with(smoothing, WheelOrigin::tape))
      .profile;
}

void print_wavelengths(const Wheel& wheel, int samples) {
  constexpr double lengths[] = {0.0, 3.0, 5.0, 8.0, 15.0, automatic_smoothing};
  std::printf("pmax of %s at y = 0, MPa, least and greatest of %d samples; truth %.0f\n",
              wheel.name.c_str(), samples, pressure_of(wheel.profile, 0.0).value);
  std::printf("| noise, distance, mm | unsmoothed | 3 mm | 5 mm | 8 mm | 15 mm | automatic |\n"
              "|---|---|---|---|---|---|---|\n");
  for (const Noise& noise :
       {Noise{0.005, 0.25}, Noise{0.02, 0.1}, Noise{0.02, 0.25}, Noise{0.02, 1.0}}) {
    std::printf("| %g, %g |", noise.deviation, noise.spacing);
    for (const double length : lengths) {
      double least = HUGE_VAL;
      double greatest = 0.0;
      for (int i = 0; i < samples; ++i) {
        Noise sample = noise;
        sample.seed = static_cast<std::uint64_t>(i) + 1;
        const double pmax = pressure_of(noisy(wheel, sample, length), 0.0).value;
        least = std::min(least, pmax);
        greatest = std::max(greatest, pmax);
      }
      std::printf(" %.0f..%.0f |", least, greatest);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}

/// What a spread says of a result, sample by sample.
struct Counts {
  int near = 0;   ///< within 5 % of the truth
  int inside = 0; ///< or within the spread
  std::vector<double> widths;
  std::vector<double> errors;

  void add(const Counts& other) {
    near += other.near;
    inside += other.inside;
    widths.insert(widths.end(), other.widths.begin(), other.widths.end());
    errors.insert(errors.end(), other.errors.begin(), other.errors.end());
  }
  void add(double found, double spread, double truth) {
    constexpr double close = 0.05;
    const double error = std::abs(found - truth);
    near += error < close * truth ? 1 : 0;
    inside += error < close * truth || error < spread ? 1 : 0;
    widths.push_back(spread / found);
    errors.push_back(error / truth);
  }
};

/// The value below which this part of them is.
double part_of(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  const auto place = static_cast<std::size_t>(part * static_cast<double>(values.size()));
  return values.empty() ? 0.0 : values[std::min(place, values.size() - 1)];
}

struct Sort {
  std::string name;
  std::vector<Noise> noises;
};

/// Noise of 0.002 to 0.02 mm at points 0.1 to 1 mm apart.
std::vector<Sort> sorts() {
  std::vector<Sort> all{{"independent", {}},         {"rounded", {}},
                        {"filtered, 0.8 mm", {}},    {"filtered, 2.5 mm", {}},
                        {"correlated, 0.25 mm", {}}, {"correlated, 0.5 mm", {}},
                        {"correlated, 1 mm", {}}};
  for (const double spacing : {0.1, 0.25, 0.5, 1.0}) {
    for (const double digit : {0.0001, 0.001, 0.01}) {
      Noise noise{0.0, spacing};
      noise.digit = digit;
      all[1].noises.push_back(noise);
    }
    for (const double deviation : {0.002, 0.005, 0.01, 0.02}) {
      Noise noise{deviation, spacing};
      all[0].noises.push_back(noise);
      std::size_t sort = 2;
      for (const double cutoff : {0.8, 2.5}) {
        noise.cutoff = cutoff;
        if (deviation > 0.002 && spacing < 1.0) {
          all[sort].noises.push_back(noise);
        }
        ++sort;
      }
      noise.cutoff = 0.0;
      for (const double width : {0.25, 0.5, 1.0}) {
        noise.width = width;
        if (spacing <= width) {
          all[sort].noises.push_back(noise);
        }
        ++sort;
      }
    }
  }
  return all;
}

driver::RadiusDifference radius_differences(const Profile& wheel, const Curve& curve) {
  constexpr double step = 0.1;
  constexpr int count = 45;
  Profile with_curve = wheel;
  with_curve.curve = curve;
  Scene scene = scene_with(with_curve);
  scene.roll = 0.0;
  scene.until = Module::geometry;
  SceneSolver solver;
  driver::RadiusDifference samples;
  for (int i = -count; i <= count; ++i) {
    scene.lateral = step * i;
    samples.lateral.push_back(scene.lateral);
    samples.difference.push_back(*solver.solve(scene).rolling_radius_difference);
  }
  return samples;
}

/// The equivalent conicity at 3 mm on 60E1, without roll, as EN 15302 has it.
Found conicity_of(const Profile& wheel) {
  constexpr double amplitude = 3.0;
  const driver::RadiusDifference centre = radius_differences(wheel, wheel.curve);
  Found found{driver::equivalent_conicity(centre, amplitude).value};
  if (wheel.doubt.valid()) {
    const ProfileDoubt& doubt = wheel.doubt.get();
    std::vector<driver::RadiusDifference> likely;
    std::vector<driver::RadiusDifference> smoothed;
    for (const Curve& curve : doubt.likely) {
      likely.push_back(radius_differences(wheel, curve));
    }
    for (std::size_t i = 1; doubt.is_of_waves && i < doubt.smoothed.size(); ++i) {
      smoothed.push_back(radius_differences(wheel, doubt.smoothed[i]));
    }
    found.spread = driver::conicity_spread(centre, likely, smoothed, amplitude);
  }
  return found;
}

void print_counts(const std::string& sort, const char* result, const Counts& counts) {
  std::printf("| %s | %s | %d | %d | %zu | %.0f %% | %.0f %% | %.0f %% |\n", sort.c_str(), result,
              counts.near, counts.inside, counts.errors.size(), 100.0 * part_of(counts.errors, 0.5),
              100.0 * part_of(counts.errors, 0.95), 100.0 * part_of(counts.widths, 0.5));
  std::fflush(stdout);
}

/// Each sort of noise on each wheel, drawn `repeats` times; one in `stride` is solved.
void print_coverage(const std::vector<Wheel>& wheels, std::uint64_t stride, int repeats) {
  constexpr double laterals[] = {0.0, -4.0, 3.0};
  std::printf(
      "\n| noise | result | within 5 %% | or within the spread | of | median error | error of "
      "95 in 100 | median spread |\n|---|---|---|---|---|---|---|---|\n");
  std::uint64_t number = 0;
  Counts all_pressures;
  Counts all_conicities;
  for (const Sort& sort : sorts()) {
    Counts pressures;
    Counts conicities;
    for (const Wheel& wheel : wheels) {
      Profile exact = wheel.profile;
      exact.doubt = {};
      const double true_conicity = conicity_of(exact).value;
      for (std::size_t i = 0; i < sort.noises.size() * static_cast<std::size_t>(repeats); ++i) {
        Noise noise = sort.noises[i % sort.noises.size()];
        noise.seed = ++number;
        if (number % stride == 0) {
          const double lateral = laterals[(number / stride) % 3];
          const Profile measured = noisy(wheel, noise, automatic_smoothing);
          const Found found = pressure_of(measured, lateral);
          pressures.add(found.value, found.spread, pressure_of(wheel.profile, lateral).value);
          const Found conicity = conicity_of(measured);
          conicities.add(conicity.value, conicity.spread, true_conicity);
        }
      }
    }
    print_counts(sort.name, "pmax", pressures);
    print_counts(sort.name, "conicity", conicities);
    all_pressures.add(pressures);
    all_conicities.add(conicities);
  }
  print_counts("all", "pmax", all_pressures);
  print_counts("all", "conicity", all_conicities);
}

/// What the automatic smoothing changes of points as they are.
void print_changes(const std::vector<std::string>& files) {
  std::printf(
      "\n| file | pmax unsmoothed | automatic | change | spread |\n|---|---|---|---|---|\n");
  for (const std::string& file : files) {
    const auto pressure = [&file](double smoothing) {
      const ReadOptions options = options_with(smoothing, WheelOrigin::by_file);
      return pressure_of(read_profile(file, options).profile, 0.0, 1e-3);
    };
    const double raw = pressure(0.0).value;
    const Found found = pressure(automatic_smoothing);
    std::printf("| %s | %.1f | %.1f | %.2f %% | %.1f |\n",
                file.substr(file.find_last_of('/') + 1).c_str(), raw, found.value,
                100.0 * (found.value / raw - 1.0), found.spread);
  }
}

constexpr const char* usage =
    "measure_noise [SAMPLES [FOLDER [STRIDE [REPEATS]]]]     default 5, none, 1 and 1\n\n"
    "Compares largest pressures and conicities of wheels whose points have noise with those\n"
    "without it. FOLDER holds measured wheels in columns (tests/reference/profiles of the\n"
    "sources). Of 328 samples with four wheels, or REPEATS times as many, one of STRIDE is\n"
    "solved.\n";

int measure(const evidence::Arguments& arguments) {
  const int samples = arguments.whole(0, "SAMPLES", 5);
  const int stride = std::max(arguments.count() > 2 ? arguments.whole(2, "STRIDE", 1) : 1, 1);
  const int repeats = std::max(arguments.count() > 3 ? arguments.whole(3, "REPEATS", 1) : 1, 1);
  arguments.refuse_beyond(4);
  std::vector<Wheel> wheels{{"S1002", standard_profile("S1002")}, {"LMA", standard_profile("LMA")}};
  print_wavelengths(wheels.front(), samples);
  std::vector<std::string> files;
  if (arguments.count() > 1) {
    const std::string folder = arguments.text(1) + '/';
    for (const char* name : {"Car7216_0001r", "left-wheel-v1-pre-dry"})
      wheels.push_back(
          {name,
           read_profile(folder + name + ".txt", options_with(0.0, WheelOrigin::by_file)).profile});
    for (const char* name :
         {"Car7216_0001r", "Car7358_0001r", "left-wheel-v1-pre-dry", "worn_high_mileage",
          "S1002-Manchester", "whl_left_iter288", "avg_wheel"})
      files.push_back(folder + name + ".txt");
  }
  print_coverage(wheels, static_cast<std::uint64_t>(stride), repeats);
  print_changes(files);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return evidence::run(argc, argv, usage, measure);
}
