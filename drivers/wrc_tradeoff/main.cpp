// wrc_tradeoff: what an accuracy costs, and whether it is met, over a fixed family of scenes.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <thread>

#include "support/output_file.hpp"
#include "support/program.hpp"
#include "wrc_tradeoff/pictures.hpp"
#include "wrc_tradeoff/reports.hpp"

namespace {

using tradeoff::Measured;

/// Tells on stderr how far it is and how long it will take, at most every other second.
class Progress {
public:
  explicit Progress(std::size_t count) : count_(count) {}

  void one_done() {
    const std::scoped_lock lock(mutex_);
    ++done_;
    const double seconds = seconds_since(start_);
    if (done_ < count_ && seconds - told_ < 2.0) {
      return;
    }
    told_ = seconds;
    const double left = seconds * static_cast<double>(count_ - done_) / static_cast<double>(done_);
    std::fprintf(stderr, "wrc_tradeoff: %zu of %zu scenes, %.0f s left\n", done_, count_, left);
  }

private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  std::mutex mutex_;
  std::size_t count_;
  std::size_t done_ = 0;
  Clock::time_point start_ = Clock::now();
  double told_ = 0.0;
};

/// Every so many scenes grids by hand are measured too.
constexpr std::size_t grid_interval = 5;

std::vector<Measured> measure_all(const std::vector<tradeoff::Case>& family, int threads,
                                  int steps) {
  std::vector<Measured> all(family.size());
  std::atomic<std::size_t> next{0};
  Progress progress(family.size());
  const auto work = [&] {
    for (std::size_t i = next++; i < family.size(); i = next++) {
      all[i] = tradeoff::measure(family[i], {steps, i % grid_interval == 0});
      progress.one_done();
    }
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i) {
    others.emplace_back(work);
  }
  work();
  others.clear();
  return all;
}

template <class Print> void write(const std::string& path, Print print) {
  driver::OutputFile file(path);
  print(file.stream());
  file.commit();
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
      write(csv, [&all](std::ostream& out) { tradeoff::print_csv(all, out); });
    }
    if (!json.empty()) {
      write(json, [&all](std::ostream& out) { tradeoff::print_json(all, out); });
    }
    if (!pictures.empty()) {
      tradeoff::draw_pictures(all, pictures);
    }
    return 0;
  });
}
