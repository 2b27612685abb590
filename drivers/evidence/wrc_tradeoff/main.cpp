// wrc_tradeoff: what an accuracy costs, and whether it is met, over a fixed family of scenes.
#include <cstdio>
#include <iostream>

#include "support/output_file.hpp"
#include "support/parallel.hpp"
#include "support/program.hpp"
#include "wrc_tradeoff/reports.hpp"

namespace {

using tradeoff::Measured;

/// Every so many scenes grids by hand are measured too.
constexpr std::size_t grid_interval = 5;

struct Options {
  std::size_t scenes = 520;
  std::size_t random = 0; ///< instead of the family
  std::string accuracy_of = "both";
  int threads = 1;
  int repeats = 15;
  std::string csv, json, pictures;
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

std::vector<Measured> measure_all(const Options& options) {
  const std::vector<tradeoff::Case> family = options.random > 0
                                                 ? tradeoff::make_random(options.random)
                                                 : tradeoff::make_family(options.scenes);
  std::vector<Measured> all(family.size());
  driver::ProgressLines progress(family.size());
  driver::for_each_index(family.size(), options.threads, [&](std::size_t i) {
    all[i] = tradeoff::measure(family[i], {labels_of(options, i), options.repeats});
    progress.one_done([&](std::size_t done, double seconds) {
      const double left =
          seconds * static_cast<double>(family.size() - done) / static_cast<double>(done);
      std::fprintf(stderr, "wrc_tradeoff: %zu of %zu scenes, %.0f s left\n", done, family.size(),
                   left);
    });
  });
  return all;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Solves a fixed family of scenes, or random ones, at all accuracies and with all models,\n"
      "against much finer solutions of the same scenes, and reports what was requested, achieved\n"
      "and estimated, and how long it took.",
      "wrc_tradeoff");
  Options options;
  auto* scenes = app.add_option("--scenes", options.scenes, "how many scenes of the family")
                     ->check(CLI::Range(1, 100000))
                     ->capture_default_str();
  app.add_option(
         "--random", options.random,
         "so many scenes drawn at random over what vehicles may meet, instead of the family; "
         "without models and grids by hand")
      ->check(CLI::Range(1, 1000000))
      ->excludes(scenes);
  app.add_option("--accuracy-of", options.accuracy_of, "what accuracies are of")
      ->check(CLI::IsMember({"forces", "pressures", "both"}))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "scenes solved at once; times depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--repeats", options.repeats,
                 "solutions timed for each way to solve a scene, at "
                 "most")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--csv", options.csv, "write one line for each wheel and way")->type_name("FILE");
  app.add_option("--json", options.json, "write everything as one object")->type_name("FILE");
  app.add_option("--pictures", options.pictures, "draw pictures, tradeoff_*.png, into a folder")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
  app.footer("\nExamples:\n"
             "  wrc_tradeoff --threads 2 --csv tradeoff.csv --pictures docs/images\n"
             "  wrc_tradeoff --threads 2 --random 6000 --accuracy-of forces\n");
  return driver::run_program(app, argc, argv, [&options] {
    const std::vector<Measured> all = measure_all(options);
    tradeoff::print_summary(all, std::cout);
    if (!options.csv.empty()) {
      driver::write_whole(options.csv,
                          [&all](std::ostream& out) { tradeoff::print_csv(all, out); });
    }
    if (!options.json.empty()) {
      driver::write_whole(options.json, [&all](std::ostream& out) {
        driver::print_json(tradeoff::json_of(all), out, 1);
      });
    }
    if (!options.pictures.empty()) {
      tradeoff::draw_pictures(all, options.pictures, options.random == 0);
    }
    return 0;
  });
}
