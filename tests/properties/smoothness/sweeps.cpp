// Parts 1 to 3: along lines of small steps, and Newton's iteration for a force.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>

#include "smoothness.hpp"
#include "steps.hpp"
#include "support/parallel.hpp"
#include "support/random_scenes.hpp"

namespace smoothness {
namespace {

constexpr double lateral_step = 1e-4;  // mm
constexpr double vertical_step = 1e-5; // mm

/// Of one position.
struct Swept {
  std::string failure;
  std::vector<std::map<std::string, double>> worst; ///< of each line
  std::vector<Flag> flags;
  double slope_difference = 0.0; ///< of the force's slope to its sensitivity, relative
};

std::string pair_name(std::size_t pair) {
  return std::string(pairs[pair][0]) + " / " + pairs[pair][1];
}

std::string text_of(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// Solves at equal steps of a key, and adds what comes out to the lines.
void sweep(const Options& options, Solving& solving, wrcontact::Scene& scene,
           const std::string& key, double first, double step, std::vector<Line>& lines) {
  const int count = options.steps + 1 + 2 * static_cast<int>(window);
  for (int i = 0; i < count; ++i) {
    scene.set(key, first + step * (i - static_cast<int>(window)));
    solving.solve(scene);
    for (Line& line : lines) {
      line.add(scene);
    }
  }
}

Swept sweep_laterally(const Options& options, std::size_t pair, double lateral) {
  Swept made;
  wrcontact::Scene scene = make_scene(options, pair, lateral);
  Solving solving(options);
  std::vector<Line> lines;
  for (const char* side : {"left", "right"}) {
    lines.emplace_back(side,
                       std::vector<std::string>{"vertical_force", "lateral_force", "normal_force"},
                       std::vector<std::string>{"depth", "pmax", "area"});
  }
  sweep(options, solving, scene, "pose.lateral", lateral, lateral_step, lines);
  for (const Line& line : lines) {
    made.worst.push_back(line.worst(load));
    const auto flags = line.flags(load, options.limit, text_of("y = %.4f", lateral));
    made.flags.insert(made.flags.end(), flags.begin(), flags.end());
  }
  return made;
}

/// The left wheel alone, with the roll that the load gave; the height at which it carries the load.
double prescribe_position(Solving& solving, wrcontact::Scene& scene) {
  solving.solve(scene);
  const double roll = scene.number("roll");
  const double height = scene.number("left.vertical") - scene.number("left.depth");
  scene.set("solve.side", "left");
  scene.set("pose.roll", roll);
  scene.set("pose.vertical", height);
  return height;
}

Swept sweep_vertically(const Options& options, std::size_t pair, double lateral) {
  Swept made;
  wrcontact::Scene scene = make_scene(options, pair, lateral);
  Solving solving(options);
  const double middle = prescribe_position(solving, scene);
  const double first = middle - 0.5 * vertical_step * options.steps;
  std::vector<Line> lines;
  lines.emplace_back("left",
                     std::vector<std::string>{"normal_force", "vertical_force", "lateral_force"},
                     std::vector<std::string>{"pmax", "area"});
  sweep(options, solving, scene, "pose.vertical", first, vertical_step, lines);
  const std::vector<double>& forces = lines[0].values("vertical_force");
  const double force = lines[0].values("normal_force")[forces.size() / 2];
  made.worst.push_back(lines[0].worst(force));
  made.flags = lines[0].flags(force, options.limit,
                              text_of("y = %.4f", lateral) + text_of(", z from %.17g", first));
  const std::string name = "left.sensitivities.pressure_force.z.vertical";
  if (scene.has_number(name)) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < forces.size(); ++i) {
      steps.push_back(forces[i] - forces[i - 1]);
    }
    std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
    made.slope_difference =
        std::abs(steps[steps.size() / 2] / vertical_step / scene.number(name) - 1.0);
  }
  return made;
}

using SweepOne = std::function<Swept(const Options&, std::size_t, double)>;

std::vector<Swept> sweep_all(const Options& options, const char* what, const SweepOne& sweep_one) {
  const auto positions = static_cast<std::size_t>(options.positions);
  std::vector<Swept> all(pairs.size() * positions);
  driver::ProgressLines progress(all.size());
  driver::for_each_index(all.size(), options.threads, [&](std::size_t i) {
    try {
      all[i] = sweep_one(options, i / positions, lateral_of(options, i % positions));
    } catch (const wrcontact::Error& error) {
      all[i].failure = text_of("y = %.4f: ", lateral_of(options, i % positions)) + error.what();
    }
    progress.one_done([&](std::size_t done, double seconds) {
      std::fprintf(stderr, "smoothness: %s, %zu of %zu positions, %.0f s\n", what, done, all.size(),
                   seconds);
    });
  });
  return all;
}

/// The worst of all positions, one row a pair and side.
void print_rows(const std::vector<Swept>& all, const Options& options,
                const std::vector<std::string>& quantities) {
  const auto positions = static_cast<std::size_t>(options.positions);
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    const std::vector<Swept> some(all.begin() + static_cast<std::ptrdiff_t>(pair * positions),
                                  all.begin() +
                                      static_cast<std::ptrdiff_t>((pair + 1) * positions));
    std::size_t flagged = 0;
    for (const Swept& swept : some) {
      flagged += swept.flags.empty() ? 0 : 1;
    }
    for (std::size_t line = 0; line < 2; ++line) {
      std::map<std::string, double> worst;
      for (const Swept& swept : some) {
        for (const std::string& quantity : quantities) {
          if (line < swept.worst.size()) {
            worst[quantity] = std::max(worst[quantity], swept.worst[line].at(quantity));
          }
        }
      }
      if (!worst.empty()) {
        std::printf("%-14s %-6s", pair_name(pair).c_str(), line == 0 ? "left" : "right");
        for (const std::string& quantity : quantities) {
          std::printf(" %14.1e", worst[quantity]);
        }
        std::printf(" %10zu\n", flagged);
      }
    }
  }
}

bool print_sweeps(const std::vector<Swept>& all, const Options& options,
                  const std::vector<std::string>& quantities) {
  std::printf("%-14s %-6s", "pair", "side");
  for (const std::string& quantity : quantities) {
    std::printf(" %14s", quantity.c_str());
  }
  std::printf("  positions beyond\n");
  print_rows(all, options, quantities);
  std::vector<Flag> flags;
  std::size_t failures = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string pair = pair_name(i / static_cast<std::size_t>(options.positions));
    for (Flag flag : all[i].flags) {
      flag.where.insert(0, pair + ", ");
      flags.push_back(flag);
    }
    if (!all[i].failure.empty()) {
      ++failures;
      std::printf("no solution: %s, %s\n", pair.c_str(), all[i].failure.c_str());
    }
  }
  std::stable_sort(flags.begin(), flags.end(), [](const Flag& one, const Flag& other) {
    return one.deviation > other.deviation;
  });
  std::printf("%zu steps beyond %g, worst first\n", flags.size(), options.limit);
  for (std::size_t i = 0; i < std::min(flags.size(), static_cast<std::size_t>(options.list)); ++i) {
    std::printf("  %.2e %s: %s: %s\n", flags[i].deviation, flags[i].quantity.c_str(),
                flags[i].where.c_str(), flags[i].changed.c_str());
  }
  return flags.empty() && failures == 0;
}

/// Iterations until the height changes by less than 1 nm; `most` + 1 if it does not.
int iterate(const Options& options, Solving& solving, wrcontact::Scene& scene, double start) {
  constexpr double close = 1e-6;      // mm
  constexpr double difference = 1e-3; // mm
  constexpr int most = 20;
  const auto force_at = [&](double z) {
    scene.set("pose.vertical", z);
    solving.solve(scene);
    return scene.number("left.vertical_force");
  };
  double z = start;
  for (int i = 1; i <= most; ++i) {
    const double force = force_at(z);
    const std::string name = "left.sensitivities.pressure_force.z.vertical";
    const double slope = options.derivative == "sensitivities"
                             ? scene.number(name)
                             : (force_at(z - difference) - force) / -difference;
    const double change = (load - force) / slope;
    z += change;
    if (std::abs(change) < close) {
      return i;
    }
  }
  return most + 1;
}

/// The larger number of iterations from a depth 10 % too large and too small.
int iterations_at(const Options& options, std::size_t pair, double lateral) {
  wrcontact::Scene scene = make_scene(options, pair, lateral);
  Solving solving(options);
  const double height = prescribe_position(solving, scene);
  solving.solve(scene);
  const double off = 0.1 * scene.number("left.depth");
  return std::max(iterate(options, solving, scene, height - off),
                  iterate(options, solving, scene, height + off));
}

} // namespace

void ask(wrcontact::Scene& scene, const Options& options) {
  scene.set("solve.accuracy", options.accuracy);
  scene.set("solve.accuracy_of", options.accuracy_of);
  scene.set("solve.curved", options.curved);
}

wrcontact::Scene make_scene(const Options& options, std::size_t pair, double lateral) {
  wrcontact::Scene scene;
  driver::make_pair(pairs[pair][0], pairs[pair][1]).apply(scene);
  scene.set("load.both", load);
  scene.set("pose.lateral", lateral);
  ask(scene, options);
  return scene;
}

double lateral_of(const Options& options, std::size_t position) {
  return options.positions > 1
             ? options.first + (options.last - options.first) * static_cast<double>(position) /
                                   (options.positions - 1)
             : 0.5 * (options.first + options.last);
}

bool measure_lateral_sweeps(const Options& options) {
  std::printf(
      "\nPart 1. Load prescribed, %d steps of 0.1 um to the left at %d positions: largest "
      "difference of a step\nto the median of those within %zu steps of it; forces relative "
      "to the load, others to themselves\n",
      options.steps, options.positions, window);
  return print_sweeps(sweep_all(options, "part 1", sweep_laterally), options,
                      {"vertical_force", "lateral_force", "normal_force", "depth", "pmax", "area"});
}

bool measure_vertical_sweeps(const Options& options) {
  std::printf("\nPart 2. Position prescribed, %d steps of 0.01 um upwards at %d positions, left "
              "wheel: the same, forces\nrelative to the normal force\n",
              options.steps, options.positions);
  const std::vector<Swept> all = sweep_all(options, "part 2", sweep_vertically);
  const bool kept = print_sweeps(
      all, options, {"normal_force", "vertical_force", "lateral_force", "pmax", "area"});
  double difference = 0.0;
  for (const Swept& swept : all) {
    difference = std::max(difference, swept.slope_difference);
  }
  std::printf("slope of the vertical force against its sensitivity: %.1e at worst\n", difference);
  return kept;
}

bool measure_newton(const Options& options) {
  std::printf("\nPart 3. Newton's iteration in the height for a vertical force, left wheel, from "
              "10 %% off in depth (either way),\nderivative from %s: iterations until the height "
              "changes by less than 1 nm\n",
              options.derivative.c_str());
  const auto positions = static_cast<std::size_t>(options.positions);
  std::vector<int> counts(pairs.size() * positions);
  std::vector<std::string> failures(counts.size());
  driver::for_each_index(counts.size(), options.threads, [&](std::size_t i) {
    try {
      counts[i] = iterations_at(options, i / positions, lateral_of(options, i % positions));
    } catch (const wrcontact::Error& error) {
      failures[i] = error.what();
    }
  });
  bool kept = true;
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    std::map<int, int> shares;
    for (std::size_t k = 0; k < positions; ++k) {
      ++shares[counts[pair * positions + k]];
    }
    std::printf("%-14s", pair_name(pair).c_str());
    for (const auto& [count, times] : shares) {
      std::printf("  %s: %d",
                  count == 0   ? "failed"
                  : count > 20 ? "not in 20"
                               : std::to_string(count).c_str(),
                  times);
    }
    std::printf("\n");
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0 || counts[i] > options.newton) {
      kept = false;
      std::printf("  %s, y = %.4f: %s\n", pair_name(i / positions).c_str(),
                  lateral_of(options, i % positions),
                  counts[i] == 0 ? failures[i].c_str() : std::to_string(counts[i]).c_str());
    }
  }
  return kept;
}

} // namespace smoothness
