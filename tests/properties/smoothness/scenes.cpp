// Parts 4 and 5: random scenes moved by next to nothing, and solved after one another.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "smoothness.hpp"
#include "support/parallel.hpp"
#include "support/random_scenes.hpp"

namespace smoothness {
namespace {

using driver::Settings;

/// Scenes that one solver solves in turn, on one thread.
constexpr std::size_t share_of_a_solver = 50;
constexpr double next_to_nothing = 1e-9; // mm

std::string asked(const Options& options) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(),
                " --set solve.accuracy=%g --set solve.accuracy_of=%s --set solve.curved=%s",
                options.accuracy, options.accuracy_of.c_str(), options.curved.c_str());
  return text.data();
}

/// What a move of next to nothing changed, the worse wheel.
struct Change {
  std::string failure;
  double force = 0.0;    ///< any of the forces, relative to the load
  double depth = 0.0;    ///< relative
  double pressure = 0.0; ///< pmax, relative
  std::string side;      ///< the worse one of force
  std::string told;      ///< warnings of both solutions
};

using Figures = std::map<std::string, double>;

Figures figures_of(const wrcontact::Scene& scene) {
  Figures figures;
  for (const char* side : {"left", "right"}) {
    for (const char* name : {".vertical_force", ".lateral_force", ".longitudinal_force",
                             ".normal_force", ".depth", ".pmax"}) {
      figures[std::string(side) + name] = scene.number(std::string(side) + name);
    }
  }
  return figures;
}

/// What a solution says of itself that explains a jump.
std::string remarks(const wrcontact::Scene& scene, bool converged) {
  std::string line = converged ? "" : "not converged";
  for (const std::string& name : scene.text_names()) {
    if (name.find(".warnings.") != std::string::npos) {
      line += (line.empty() ? "" : "; ") + scene.text(name);
    }
  }
  return line;
}

void compare(const Figures& before, const Figures& after, const Settings& settings,
             Change& change) {
  for (const auto& [name, value] : before) {
    const std::string side = name.substr(0, name.find('.'));
    const double difference = std::abs(after.at(name) - value);
    if (name.ends_with("_force")) {
      const double relative = difference / settings.number_or("load." + side, load);
      change.side = relative >= change.force ? side : change.side;
      change.force = std::max(change.force, relative);
    } else {
      double& worst = name.ends_with("depth") ? change.depth : change.pressure;
      worst = std::max(worst, difference / std::abs(value));
    }
  }
}

Change change_of(const Options& options, Solving& solving, const Settings& settings) {
  Change change;
  wrcontact::Scene scene;
  try {
    settings.apply(scene);
    ask(scene, options);
    const std::string before_told = remarks(scene, solving.solve(scene));
    const Figures before = figures_of(scene);
    scene.set("pose.lateral", settings.number_or("pose.lateral", 0.0) + next_to_nothing);
    change.told = remarks(scene, solving.solve(scene));
    if (change.told != before_told) {
      change.told = '[' + before_told + "] -> [" + change.told + ']';
    }
    compare(before, figures_of(scene), settings, change);
  } catch (const wrcontact::Error& error) {
    change.failure = error.what();
  }
  return change;
}

/// Calls work(chunk's solver's first scene, one past its last) on the threads.
template <class Work>
void in_shares(const Options& options, long count, const char* what, Work work) {
  const auto all = static_cast<std::size_t>(count);
  const std::size_t shares = (all + share_of_a_solver - 1) / share_of_a_solver;
  driver::ProgressLines progress(shares);
  driver::for_each_index(shares, options.threads, [&](std::size_t share) {
    const std::size_t first = share * share_of_a_solver;
    work(first, std::min(first + share_of_a_solver, all));
    progress.one_done([&](std::size_t done, double seconds) {
      std::fprintf(stderr, "smoothness: %s, %zu of %zu scenes, %.0f s\n", what,
                   std::min(done * share_of_a_solver, all), all, seconds);
    });
  });
}

void print_failures(const std::map<std::string, long>& failures) {
  for (const auto& [text, times] : failures) {
    std::printf("  not solved: %ld times: %s\n", times, text.c_str());
  }
}

/// Up to the first number, which differs from scene to scene.
std::string kind_of(const std::string& failure) {
  return failure.substr(0, failure.find_first_of("0123456789"));
}

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

void print_quantiles(const char* name, std::vector<double> values) {
  if (values.empty()) {
    return;
  }
  values = sorted(std::move(values));
  const auto at = [&values](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  std::printf("  %-10s %10.1e %10.1e %10.1e %10.1e %10.1e\n", name, at(0.5), at(0.9), at(0.99),
              at(0.999), at(1.0));
}

/// The scenes beyond the limits, worst first.
void print_beyond(const std::vector<Change>& all, std::vector<std::size_t> beyond,
                  const Options& options) {
  const double most = options.pressure_share * options.accuracy;
  const auto excess = [&](std::size_t i) {
    return std::max(all[i].force / options.limit, all[i].pressure / most);
  };
  std::sort(beyond.begin(), beyond.end(),
            [&](std::size_t one, std::size_t other) { return excess(one) > excess(other); });
  const auto warned = std::count_if(beyond.begin(), beyond.end(),
                                    [&](std::size_t i) { return !all[i].told.empty(); });
  std::printf("%zu beyond, %ld of them with a warning\n", beyond.size(), static_cast<long>(warned));
  beyond.resize(std::min(beyond.size(), static_cast<std::size_t>(options.list)));
  for (const std::size_t i : beyond) {
    const Change& change = all[i];
    std::printf("  forces %.1e (%s), pmax %.1e%s%s:%s %s\n", change.force, change.side.c_str(),
                change.pressure, change.told.empty() ? "" : ", ", change.told.c_str(),
                asked(options).c_str(), driver::random_scene(options.seed, i).options().c_str());
  }
}

} // namespace

bool measure_moved_scenes(const Options& options) {
  std::printf("\nPart 4. %ld random scenes, moved by 1e-9 mm: changes of forces relative to the "
              "load, of depth and pmax to\nthemselves, the worse wheel\n",
              options.scenes);
  std::vector<Change> all(static_cast<std::size_t>(options.scenes));
  in_shares(options, options.scenes, "part 4", [&](std::size_t first, std::size_t end) {
    Solving solving(options);
    for (std::size_t i = first; i < end; ++i) {
      all[i] = change_of(options, solving, driver::random_scene(options.seed, i));
    }
  });
  const double most = options.pressure_share * options.accuracy;
  std::map<std::string, long> failures;
  std::vector<double> force;
  std::vector<double> depth;
  std::vector<double> pressure;
  std::vector<std::size_t> beyond;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].failure.empty()) {
      ++failures[kind_of(all[i].failure)];
      continue;
    }
    force.push_back(all[i].force);
    depth.push_back(all[i].depth);
    pressure.push_back(all[i].pressure);
    if (!(all[i].force < options.limit && all[i].pressure < most)) {
      beyond.push_back(i);
    }
  }
  const auto solved = static_cast<double>(force.size());
  const double share = solved > 0.0 ? 1.0 - static_cast<double>(beyond.size()) / solved : 0.0;
  std::printf("             median       90 %%       99 %%     99.9 %%      worst\n");
  print_quantiles("forces", force);
  print_quantiles("depth", depth);
  print_quantiles("pmax", pressure);
  print_failures(failures);
  std::printf("%.2f %% of %.0f scenes within %g and %g\n", 100.0 * share, solved, options.limit,
              most);
  print_beyond(all, std::move(beyond), options);
  return share >= options.scene_share;
}

namespace {

/// A scene of a sequence: what is set, and what is asked.
struct Posed {
  Settings settings;
  Options options;
  bool one_side = false;
};

/// Sequences as a vehicle code and a study make them: new scenes, small steps from the last one,
/// returns to earlier ones (rejected steps), other accuracies, one wheel alone.
class Sequence {
public:
  Sequence(const Options& options, std::size_t first)
      : options_(options), first_(first), random_(options.seed + first) {}

  Posed next() {
    const std::uint64_t draw = random_() % 20;
    Posed posed = posed_.empty() || draw < 8 ? fresh() : posed_.back();
    if (draw >= 8 && draw < 14) {
      const double y = posed.settings.number_or("pose.lateral", 0.0);
      posed.settings.set("pose.lateral", y + 1e-3 * static_cast<double>(random_() % 20));
    } else if (draw >= 14 && draw < 17 && !posed_.empty()) {
      posed = posed_[posed_.size() - 1 - random_() % std::min<std::size_t>(posed_.size(), 5)];
    } else if (draw >= 17) {
      constexpr std::array accuracies{1e-1, 1e-2, 3e-3, 1e-3};
      posed.options.accuracy = accuracies[random_() % accuracies.size()];
      posed.options.accuracy_of = random_() % 2 == 0 ? "forces" : "pressures";
      posed.one_side = random_() % 2 == 0;
    }
    posed_.push_back(posed);
    return posed;
  }

private:
  Posed fresh() { return {driver::random_scene(options_.seed, first_ + posed_.size()), options_}; }

  const Options& options_;
  std::size_t first_;
  std::mt19937_64 random_;
  std::vector<Posed> posed_;
};

/// Everything that comes out but times, numbers as their bits.
struct Outcome {
  wrc_status status = WRC_OK;
  std::string error;
  std::map<std::string, std::uint64_t> numbers;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<double>> fields;
};

template <class Solve> Outcome outcome_of(const Posed& posed, Solve solve) {
  Outcome made;
  wrcontact::Scene scene;
  try {
    posed.settings.apply(scene);
    ask(scene, posed.options);
    if (posed.one_side) {
      scene.set("solve.side", "left");
    }
    made.status = solve(scene) ? WRC_OK : WRC_NOT_CONVERGED;
  } catch (const wrcontact::Error& error) {
    made.status = error.status();
    made.error = error.what();
    return made;
  }
  for (const std::string& name : scene.number_names()) {
    if (!name.starts_with("time_ms.")) {
      made.numbers[name] = std::bit_cast<std::uint64_t>(scene.number(name));
    }
  }
  for (const std::string& name : scene.text_names()) {
    made.texts[name] = scene.text(name);
  }
  for (const char* side : {"left", "right"}) {
    if (scene.has_number(std::string(side) + ".patches.0.pmax")) {
      made.fields[side] = scene.field(std::string(side) + ".pressure");
    }
  }
  return made;
}

template <class Map> std::string first_difference(const Map& one, const Map& other) {
  for (const auto& [name, value] : one) {
    const auto found = other.find(name);
    if (found == other.end() || found->second != value) {
      return name;
    }
  }
  return one.size() == other.size() ? "" : "a result that only one has";
}

std::string difference(const Outcome& one, const Outcome& other) {
  if (one.status != other.status || one.error != other.error) {
    return "status";
  }
  std::string name = first_difference(one.numbers, other.numbers);
  name = name.empty() ? first_difference(one.texts, other.texts) : name;
  return name.empty() && one.fields != other.fields ? "pressure" : name;
}

/// A scene whose results depend on what was solved before.
struct Differing {
  std::string name; ///< of the first result that differs
  Posed before;
  Posed posed;
};

std::string told(const Posed& posed) {
  return posed.settings.options() + asked(posed.options) +
         (posed.one_side ? " --set solve.side=left" : "");
}

} // namespace

bool measure_sequences(const Options& options) {
  std::printf(
      "\nPart 5. %ld scenes in sequences of %zu through one solver, against each by itself: "
      "bits of all results\n",
      options.sequence, share_of_a_solver);
  std::vector<Differing> found(static_cast<std::size_t>(options.sequence));
  in_shares(options, options.sequence, "part 5", [&](std::size_t first, std::size_t end) {
    Sequence sequence(options, first);
    wrcontact::Solver solver;
    Posed before;
    for (std::size_t i = first; i < end; ++i) {
      const Posed posed = sequence.next();
      found[i].name = difference(
          outcome_of(posed, [&](wrcontact::Scene& scene) { return solver.solve(scene); }),
          outcome_of(posed, [](wrcontact::Scene& scene) { return scene.solve(); }));
      if (!found[i].name.empty()) {
        found[i].before = before;
        found[i].posed = posed;
      }
      before = posed;
    }
  });
  std::map<std::string, long> names;
  long differing = 0;
  for (const Differing& each : found) {
    differing += each.name.empty() ? 0 : 1;
    ++names[each.name];
  }
  std::printf("%ld of %ld scenes differ; first by name:", differing, options.sequence);
  for (const auto& [name, times] : names) {
    if (!name.empty()) {
      std::printf(" %s %ld;", name.c_str(), times);
    }
  }
  std::printf("\n");
  long listed = 0;
  for (const Differing& each : found) {
    if (!each.name.empty() && listed++ < options.list) {
      std::printf("  %s: %s\n    after %s\n", each.name.c_str(), told(each.posed).c_str(),
                  told(each.before).c_str());
    }
  }
  return differing <= options.differing;
}

} // namespace smoothness
