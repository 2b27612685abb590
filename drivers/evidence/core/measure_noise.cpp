/// Largest pressures of wheels whose points have noise, against those of the points without it.
///
///   measure_noise [SAMPLES [FOLDER [STRIDE]]]     default 5, no measured wheels and 1
///
/// FOLDER holds measured wheels in columns (tests/reference/profiles of the sources). Prints, for
/// S1002 at y = 0, pmax with the smoothing wavelengths that a user might choose and with the
/// automatic smoothing; for each sort of noise how often pmax is within 5 % of the truth and within
/// the spread, with one of STRIDE samples; and what the automatic smoothing changes of points that
/// have no noise added.
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
#include "scene/solve_scene.hpp"

namespace {

using namespace wrc;
using namespace wrc::test;

struct Wheel {
  std::string name;
  Profile profile;
};

struct Pressure {
  double largest = std::numeric_limits<double>::quiet_NaN();
  double spread = std::numeric_limits<double>::quiet_NaN();
};

Pressure pressure_of(const Profile& wheel, double lateral, double accuracy = 1e-2) {
  Scene scene;
  scene.left.wheel.name = scene.right.wheel.name = wheel.name;
  scene.left.wheel.given = scene.right.wheel.given = std::make_shared<const Profile>(wheel);
  scene.side = SideChoice::left;
  scene.lateral = lateral;
  scene.accuracy = accuracy;
  SceneResult result = solve_scene(scene);
  Pressure pressure;
  pressure.largest = number_value(result, "left.pmax").value_or(pressure.largest);
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
              wheel.name.c_str(), samples, pressure_of(wheel.profile, 0.0).largest);
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
        const double pmax = pressure_of(noisy(wheel, sample, length), 0.0).largest;
        least = std::min(least, pmax);
        greatest = std::max(greatest, pmax);
      }
      std::printf(" %.0f..%.0f |", least, greatest);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}

struct Counts {
  int near = 0;   ///< within 5 % of the truth
  int inside = 0; ///< or within the spread
  int all = 0;
  std::vector<double> widths;
  std::vector<double> errors;
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
  Sort white{"independent", {}};
  Sort rounded{"rounded", {}};
  Sort filtered{"filtered", {}};
  Sort correlated{"correlated", {}};
  for (const double spacing : {0.1, 0.25, 0.5, 1.0}) {
    for (const double deviation : {0.002, 0.005, 0.01, 0.02}) {
      Noise noise{deviation, spacing};
      white.noises.push_back(noise);
      for (const double width : {0.25, 0.5, 1.0}) {
        noise.width = width;
        if (spacing <= std::max(width, 0.25)) {
          correlated.noises.push_back(noise);
        }
      }
      noise.width = 0.0;
      for (const double cutoff : {0.8, 2.5}) {
        noise.cutoff = cutoff;
        if (deviation > 0.002 && spacing < 1.0) {
          filtered.noises.push_back(noise);
        }
      }
    }
    for (const double digit : {0.0001, 0.001, 0.01}) {
      Noise noise{0.0, spacing};
      noise.digit = digit;
      rounded.noises.push_back(noise);
    }
  }
  return {white, rounded, filtered, correlated};
}

void add_sample(const Wheel& wheel, const Noise& noise, double lateral, Counts& counts) {
  constexpr double near = 0.05;
  const double truth = pressure_of(wheel.profile, lateral).largest;
  const Pressure found = pressure_of(noisy(wheel, noise, automatic_smoothing), lateral);
  const double error = std::abs(found.largest - truth);
  counts.near += error < near * truth ? 1 : 0;
  counts.inside += error < near * truth || error < found.spread ? 1 : 0;
  ++counts.all;
  counts.widths.push_back(found.spread / found.largest);
  counts.errors.push_back(error / truth);
}

/// Each sort of noise on each wheel, of which one in `stride` is solved.
void print_coverage(const std::vector<Wheel>& wheels, std::uint64_t stride) {
  constexpr double laterals[] = {0.0, -4.0, 3.0};
  std::printf("\n| noise | within 5 %% | or within the spread | of | median error | error of 95 in "
              "100 | median spread |\n|---|---|---|---|---|---|---|\n");
  std::uint64_t number = 0;
  for (const Sort& sort : sorts()) {
    Counts counts;
    for (const Wheel& wheel : wheels) {
      for (Noise noise : sort.noises) {
        noise.seed = ++number;
        if (number % stride == 0) {
          add_sample(wheel, noise, laterals[(number / stride) % 3], counts);
        }
      }
    }
    std::printf("| %s | %d | %d | %d | %.0f %% | %.0f %% | %.0f %% |\n", sort.name.c_str(),
                counts.near, counts.inside, counts.all, 100.0 * part_of(counts.errors, 0.5),
                100.0 * part_of(counts.errors, 0.95), 100.0 * part_of(counts.widths, 0.5));
    std::fflush(stdout);
  }
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
    const double raw = pressure(0.0).largest;
    const Pressure found = pressure(automatic_smoothing);
    std::printf("| %s | %.1f | %.1f | %.2f %% | %.1f |\n",
                file.substr(file.find_last_of('/') + 1).c_str(), raw, found.largest,
                100.0 * (found.largest / raw - 1.0), found.spread);
  }
}

constexpr const char* usage =
    "measure_noise [SAMPLES [FOLDER [STRIDE]]]     default 5, no measured wheels and 1\n\n"
    "Compares largest pressures of wheels whose points have noise with those without it. FOLDER\n"
    "holds measured wheels in columns (tests/reference/profiles of the sources). Of about 340\n"
    "samples with four wheels one of STRIDE is solved.\n";

int measure(const evidence::Arguments& arguments) {
  const int samples = arguments.whole(0, "SAMPLES", 5);
  const int stride = std::max(arguments.count() > 2 ? arguments.whole(2, "STRIDE", 1) : 1, 1);
  arguments.refuse_beyond(3);
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
  print_coverage(wheels, static_cast<std::uint64_t>(stride));
  print_changes(files);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return evidence::run(argc, argv, usage, measure);
}
