// wrc_tradeoff: what an accuracy costs, and whether it is met, over a fixed family of scenes.
#include <cstdio>
#include <iostream>

#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/parallel.hpp"
#include "support/program.hpp"
#include "wrc_tradeoff/creep.hpp"
#include "wrc_tradeoff/reports.hpp"
#include "wrc_tradeoff/truth.hpp"

namespace {

using tradeoff::Measured;

/// One in this number of scenes is also solved on prescribed grids.
constexpr std::size_t grid_interval = 5;

struct Options {
  std::size_t scenes = 520;
  std::size_t random = 0; ///< instead of the family
  std::size_t creep = 0;  ///< models of creep forces, instead of all others
  bool motion = false;    ///< creep forces of a wheelset in motion
  std::size_t truth = 0;  ///< wheels judged against solutions along curves
  std::string truths;     ///< file of these solutions
  std::string accuracy_of = "both";
  bool position = false;
  int threads = 1;
  int repeats = 15;
  std::string json, pictures;
};

/// Random scenes are solved for what accuracies are worth; the family in all ways.
std::vector<std::string> labels_of(const Options& options, std::size_t index) {
  std::vector<std::string> labels;
  if (options.accuracy_of != "pressures") {
    labels.emplace_back("forces");
  }
  if (options.accuracy_of != "forces") {
    labels.emplace_back("pressures");
  }
  if (options.random == 0) {
    if (options.accuracy_of != "forces") {
      labels.emplace_back("double");
    }
    labels.insert(labels.end(), {"hertz", "kik-piotrowski"});
    if (index % grid_interval == 0) {
      labels.emplace_back("grid");
    }
  }
  return labels;
}

/// Results of measure(i) for `count` scenes, with lines of progress on stderr.
template <class Measure>
auto measure_scenes(std::size_t count, const Options& options, Measure measure) {
  std::vector<decltype(measure(count))> all(count);
  driver::ProgressLines progress(count);
  driver::for_each_index(count, options.threads, [&](std::size_t i) {
    all[i] = measure(i);
    progress.one_done([&](std::size_t done, double seconds) {
      const double left = seconds * static_cast<double>(count - done) / static_cast<double>(done);
      std::fprintf(stderr, "wrc_tradeoff: %zu of %zu scenes, %.0f s left\n", done, count, left);
    });
  });
  return all;
}

std::vector<Measured> measure_all(const Options& options) {
  const std::vector<tradeoff::Case> family = options.random > 0
                                                 ? tradeoff::make_random(options.random)
                                                 : tradeoff::make_family(options.scenes);
  return measure_scenes(family.size(), options, [&](std::size_t i) {
    return tradeoff::measure(family[i], {labels_of(options, i), options.repeats, options.position});
  });
}

/// Prints and writes what options ask for.
template <class All, class Summary, class Json, class Draw>
void report(const All& all, const Options& options, Summary print_summary, Json json_of,
            Draw draw) {
  print_summary(all, std::cout);
  if (!options.json.empty()) {
    driver::write_whole(options.json,
                        [&](std::ostream& out) { driver::print_json(json_of(all), out, 1); });
  }
  if (!options.pictures.empty()) {
    draw(all, options.pictures);
  }
}

void compare_creep_models(const Options& options) {
  const auto cases = options.motion ? tradeoff::make_motion_cases(options.creep)
                                    : tradeoff::make_creep_cases(options.creep);
  report(measure_scenes(
             cases.size(), options,
             [&](std::size_t i) { return tradeoff::measure_creep(cases[i], options.repeats); }),
         options, tradeoff::print_creep_summary, tradeoff::creep_json_of, tradeoff::draw_creep);
}

void judge_by_truth(const Options& options) {
  const auto cases = tradeoff::make_truth_cases(options.truth);
  tradeoff::TruthFile truths(options.truths);
  report(measure_scenes(cases.size(), options,
                        [&](std::size_t i) { return tradeoff::measure_truth(cases[i], truths); }),
         options, tradeoff::print_truth_summary, tradeoff::truth_json_of,
         [](const auto&, const auto&) {});
}

} // namespace

int main(int argc, char** argv) {
  driver::Program app(
      "wrc_tradeoff",
      "Solves many scenes at every accuracy and with every contact model, compares each with a "
      "much\nfiner solution, and reports requested, true and estimated errors and the time taken.");
  Options options;
  const auto scenes = app.add("--scenes", options.scenes, "number of scenes of the fixed family")
                          .within(1, 100000)
                          .show_default();
  const auto random =
      app.add("--random", options.random,
              "instead of the family: number of random scenes, over all that vehicles may "
              "meet; only accuracies are compared, no other models or prescribed grids")
          .within(1, 1000000)
          .excludes(scenes);
  const auto accuracy_of = app.add("--accuracy-of", options.accuracy_of,
                                   "results that accuracies apply to (solve.accuracy_of)")
                               .one_of({"forces", "pressures", "both"})
                               .show_default();
  const auto position = app.flag("--position", options.position,
                                 "prescribe the position that each load gives instead of the load; "
                                 "missed accuracies are listed with the loads");
  const auto creep = app.add("--creep", options.creep,
                             "instead of everything else: compare models of creep forces on this "
                             "number of scenes, with creepages of 0.1 to 10 times saturation")
                         .within(1, 100000)
                         .excludes(scenes)
                         .excludes(random)
                         .excludes(accuracy_of)
                         .excludes(position);
  app.flag("--motion", options.motion,
           "with --creep: steps of a wheelset that hunts over irregular track, not creepages")
      .needs(creep);
  const auto truth =
      app.add("--truth", options.truth,
              "instead of everything else: judge results, estimates and warnings at 1e-2 and 1e-3 "
              "on this number of wheels as vehicles use them, and for ten of them three with creep "
              "forces, two on flats and two on a crossing, by solutions along curves")
          .within(10, 100000)
          .excludes(scenes)
          .excludes(random)
          .excludes(accuracy_of)
          .excludes(position)
          .excludes(creep);
  app.add("--truths", options.truths,
          "with --truth: file that keeps the solutions along curves; those that it has are not "
          "solved again")
      .type("FILE")
      .needs(truth);
  app.add("--threads", options.threads, "scenes solved at once; times depend on it")
      .within(1, 1024)
      .show_default();
  app.add("--repeats", options.repeats, "largest number of timed solutions per scene and setting")
      .within(1, 1000)
      .show_default();
  app.add("--json", options.json, "write all results as one JSON object").type("FILE");
  app.add("--pictures", options.pictures, "draw tradeoff_*.png into an existing folder")
      .type("FOLDER")
      .existing_folder();
  app.footer("\nExamples:\n"
             "  wrc_tradeoff --threads 2 --json tradeoff.json --pictures docs/images\n"
             "  wrc_tradeoff --threads 2 --random 6000 --accuracy-of forces\n"
             "  wrc_tradeoff --threads 2 --creep 500 --pictures docs/images\n"
             "  wrc_tradeoff --threads 2 --truth 1000 --truths truths.json\n");
  return app.run(argc, argv, [&options] {
    if (options.creep > 0) {
      compare_creep_models(options);
      return 0;
    }
    if (options.truth > 0) {
      judge_by_truth(options);
      return 0;
    }
    report(measure_all(options), options, tradeoff::print_summary, tradeoff::json_of,
           [&options](const auto& all, const auto& folder) {
             tradeoff::draw_pictures(all, folder, options.random == 0);
           });
    return 0;
  });
}
