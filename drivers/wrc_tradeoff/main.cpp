// wrc_tradeoff: what an accuracy costs, and whether it is met, over a fixed family of scenes.
#include <cstdio>
#include <iostream>

#include "support/output_file.hpp"
#include "support/parallel.hpp"
#include "support/program.hpp"
#include "wrc_tradeoff/pictures.hpp"
#include "wrc_tradeoff/reports.hpp"

namespace {

using tradeoff::Measured;

/// Every so many scenes grids by hand are measured too.
constexpr std::size_t grid_interval = 5;

std::vector<Measured> measure_all(const std::vector<tradeoff::Case>& family, int threads,
                                  int steps) {
  std::vector<Measured> all(family.size());
  driver::ProgressLines progress(family.size());
  driver::for_each_index(family.size(), threads, [&](std::size_t i) {
    all[i] = tradeoff::measure(family[i], {steps, i % grid_interval == 0});
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
      "Solves a fixed family of scenes at all accuracies and with all models, against much "
      "finer solutions of the same scenes, and tells what was asked, achieved, estimated, "
      "and how long it took.",
      "wrc_tradeoff");
  std::size_t scenes = 520;
  int threads = 1;
  int steps = 15;
  std::string csv;
  std::string json;
  std::string pictures;
  app.add_option("--scenes", scenes, "how many scenes of the family")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--threads", threads,
                 "scenes solved at once; times depend on it, and the errors of warm steps within "
                 "their scatter")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--steps", steps, "warm steps timed for each way to solve a scene, at most")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--csv", csv, "write one line for each wheel and way")->type_name("FILE");
  app.add_option("--json", json, "write everything as one object")->type_name("FILE");
  app.add_option("--pictures", pictures, "draw four pictures, tradeoff_*.png, into a folder")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
  app.footer("\nExample:\n  wrc_tradeoff --threads 2 --csv tradeoff.csv --pictures docs/images\n");
  return driver::run_program(app, argc, argv, [&] {
    const std::vector<Measured> all = measure_all(tradeoff::make_family(scenes), threads, steps);
    tradeoff::print_summary(all, std::cout);
    if (!csv.empty()) {
      driver::write_whole(csv, [&all](std::ostream& out) { tradeoff::print_csv(all, out); });
    }
    if (!json.empty()) {
      driver::write_whole(json, [&all](std::ostream& out) { tradeoff::print_json(all, out); });
    }
    if (!pictures.empty()) {
      tradeoff::draw_pictures(all, pictures);
    }
    return 0;
  });
}
