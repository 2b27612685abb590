// count_model_errors: on how many random wheels planes and curves are as accurate as requested, by
// what the library states.
//
//   count_model_errors [SCENES]     default 6000: those of wrc_tradeoff --random 6000
//
// Prints a table, without friction, over the choices of solve.curved, what accuracies are of,
// accuracies and where the wheels touch, by the greatest angle of their contacts:
//   planes    share of wheels whose contacts all have a plane_error within the accuracy, and of
//             scenes in which all wheels have
//   model     likewise of the model_error, that of all contacts by their forces and of how they
//             displace each other
//   median .. of the model error over the accuracy
//   beyond    number of wheels with a model error beyond the accuracy, and how many of them have
//             a warning of it; of them, the first that applies: a profile has an edge in the
//             contact; their turn t leaves more than the accuracy along any curve, 0.01 t^2, of
//             pressures 0.02 t^2 (docs/method.md); how they displace each other; the rest
// Then the wheel with the greatest model error of each choice, as options for wrc_case.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.hpp"
#include "support/random_scenes.hpp"
#include "support/scene.hpp"
#include "support/statistics.hpp"

namespace {

constexpr std::uint64_t seed = 20240607;

struct Wheel {
  std::size_t scene = 0;
  double yaw = 0.0;    ///< rad
  double angle = 0.0;  ///< rad, the greatest of its contacts
  double planes = 0.0; ///< the greatest plane_error of its contacts
  double model = 0.0;
  double turn = 0.0; ///< rad, the greatest of its contacts
  bool has_warning = false;
  bool has_edge = false;
  bool has_interaction = false; ///< that is known in part
};

struct Way {
  const char* curved;
  const char* accuracy_of;
  double accuracy;
};

constexpr const char* of_turn = "the rail turns by";
constexpr const char* of_interaction = "effect on each other is known in part";
constexpr const char* of_edge = "a profile has a kink";

bool mention(const std::vector<std::string>& warnings, const char* part) {
  return std::ranges::any_of(
      warnings, [&](const std::string& one) { return one.find(part) != std::string::npos; });
}

std::vector<Wheel> wheels_of(const Way& way, std::size_t scenes) {
  std::vector<Wheel> wheels;
  driver::Solver solver;
  for (std::size_t i = 0; i < scenes; ++i) {
    driver::Scene scene;
    const driver::Settings drawn = driver::random_scene(seed, i);
    drawn.apply(scene);
    scene.set("solve.curved", way.curved);
    scene.set("solve.accuracy_of", way.accuracy_of);
    scene.set("solve.accuracy", way.accuracy);
    try {
      solver.solve(scene);
    } catch (const wrcontact::Error&) { // no contact, or a curve that is refused
      continue;
    }
    for (const std::string& side : driver::sides_of(scene)) {
      Wheel wheel;
      wheel.scene = i;
      wheel.yaw = std::abs(drawn.number_or("pose.yaw", 0.0));
      wheel.model = scene.number(side + ".model_error");
      const std::vector<std::string> warnings = driver::texts_of(scene, side + ".warnings");
      wheel.has_edge = mention(warnings, of_edge);
      wheel.has_interaction = mention(warnings, of_interaction);
      wheel.has_warning =
          wheel.has_interaction || mention(warnings, of_turn) || mention(warnings, "(model ");
      const int patches = scene.count_of(side + ".patches");
      for (int k = 0; k < patches; ++k) {
        const std::string patch = side + ".patches." + std::to_string(k);
        wheel.planes = std::max(wheel.planes, scene.number_or(patch + ".plane_error", 0.0));
        wheel.turn = std::max(wheel.turn, scene.number_or(patch + ".turn", 0.0));
        wheel.angle = std::max(wheel.angle, std::abs(scene.number_or(patch + ".angle", 0.0)));
      }
      wheels.push_back(wheel);
    }
  }
  return wheels;
}

double percent(std::size_t part, std::size_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1));
}

/// Of wheels and of scenes, those within an accuracy.
std::string shares_within(const std::vector<Wheel>& wheels, double Wheel::*error, double accuracy) {
  std::set<std::size_t> all;
  std::set<std::size_t> beyond;
  std::size_t within = 0;
  for (const Wheel& wheel : wheels) {
    all.insert(wheel.scene);
    if (wheel.*error <= accuracy) {
      ++within;
    } else {
      beyond.insert(wheel.scene);
    }
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.2f %%, %.2f %%", percent(within, wheels.size()),
                percent(all.size() - beyond.size(), all.size()));
  return text.data();
}

void print(const Way& way, const char* place, const std::vector<Wheel>& wheels) {
  const double on_curve = std::string_view(way.accuracy_of) == "pressures" ? 0.02 : 0.01;
  std::size_t beyond = 0;
  std::size_t warned = 0;
  std::array<std::size_t, 4> causes{};
  std::vector<double> ratios;
  for (const Wheel& wheel : wheels) {
    ratios.push_back(wheel.model / way.accuracy);
    if (wheel.model > way.accuracy) {
      ++beyond;
      warned += wheel.has_warning ? 1 : 0;
      const bool turns = on_curve * wheel.turn * wheel.turn > way.accuracy;
      ++causes[wheel.has_edge ? 0U : turns ? 1U : wheel.has_interaction ? 2U : 3U];
    }
  }
  std::printf("| %s | %s | %.0e | %s | %zu | %s | %s | %.2f | %.2f | %.2f | %.1f | %zu, %zu | %zu, "
              "%zu, %zu, %zu |\n",
              way.curved, way.accuracy_of, way.accuracy, place, wheels.size(),
              shares_within(wheels, &Wheel::planes, way.accuracy).c_str(),
              shares_within(wheels, &Wheel::model, way.accuracy).c_str(),
              driver::quantile(ratios, 0.5), driver::quantile(ratios, 0.95),
              driver::quantile(ratios, 0.99), driver::quantile(ratios, 1.0), beyond, warned,
              causes[0], causes[1], causes[2], causes[3]);
}

void note_worst(const Way& way, const std::vector<Wheel>& wheels, std::string& text) {
  const auto found = std::ranges::max_element(wheels, {}, &Wheel::model);
  if (found != wheels.end()) {
    std::ostringstream line;
    line << way.accuracy_of << " to " << way.accuracy << ", model error " << found->model << ": "
         << driver::random_scene(seed, found->scene).options()
         << " --set solve.curved=" << way.curved << " --set solve.accuracy_of=" << way.accuracy_of
         << " --set solve.accuracy=" << way.accuracy << '\n';
    text += line.str();
  }
}

constexpr const char* usage =
    "count_model_errors [SCENES]     default 6000\n\n"
    "Counts on how many random wheels planes and curves are as accurate as requested.\n";

int count(const wrc::evidence::Arguments& arguments) {
  const auto scenes = static_cast<std::size_t>(arguments.whole(0, "SCENES", 6000));
  arguments.refuse_beyond(1);
  constexpr double usual_yaw = 0.01; // rad: as in curves of the track
  struct Place {
    const char* name;
    double least, greatest;
  };
  constexpr std::array places{Place{"tread", 0.0, 0.15}, Place{"gauge corner", 0.15, 0.8},
                              Place{"flange", 0.8, 1.6}};
  std::string worst;
  std::puts(
      "| curved | accuracy of | accuracy | place | wheels | planes | model | median | 95 % | 99 % "
      "| worst | beyond, warned | edge, turn, interaction, rest |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const char* curved : {"no", "auto", "yes"}) {
    for (const char* accuracy_of : {"forces", "pressures"}) {
      for (const double accuracy : {1e-3, 1e-2}) {
        const Way way{curved, accuracy_of, accuracy};
        const std::vector<Wheel> wheels = wheels_of(way, scenes);
        print(way, "all", wheels);
        std::vector<Wheel> little_yawed;
        std::ranges::copy_if(wheels, std::back_inserter(little_yawed),
                             [&](const Wheel& wheel) { return wheel.yaw <= usual_yaw; });
        print(way, "yaw to 0.01 rad", little_yawed);
        note_worst(way, wheels, worst);
        for (const Place& place : places) {
          std::vector<Wheel> there;
          std::ranges::copy_if(wheels, std::back_inserter(there), [&](const Wheel& wheel) {
            return wheel.angle >= place.least && wheel.angle < place.greatest;
          });
          print(way, place.name, there);
        }
        std::fflush(stdout);
      }
    }
  }
  std::printf("\n%s", worst.c_str());
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return wrc::evidence::run(argc, argv, usage, count);
}
