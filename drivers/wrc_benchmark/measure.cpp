#include "wrc_benchmark/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/scene.hpp"
#include "wrc_benchmark/yardstick.hpp"

namespace benchmark {
namespace {

/// A line of /proc/self/status in MB: "VmRSS" resident now, "VmHWM" at the most so far.
double memory_mb(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(name + ':')) {
      return std::stod(line.substr(name.size() + 1)) / 1024.0;
    }
  }
  return 0.0;
}

/// Runs this program with arguments and returns what it prints.
std::string output_of(std::vector<std::string> arguments) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    throw driver::Failure("no pipe for a child process");
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  pid_t child = 0;
  const int failed =
      posix_spawn(&child, "/proc/self/exe", &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::string output;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; failed == 0 && (count = read(ends[0], part.data(), part.size())) > 0;) {
    output.append(part.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  int status = -1;
  if (failed != 0 || waitpid(child, &status, 0) != child || status != 0) {
    throw driver::Failure("the first solution in a process of its own has failed");
  }
  return output;
}

struct FirstSolve {
  Times times;
  double memory_mb = 0.0; ///< peak memory minus that before the case's handles were made
};

/// Starts a child and reads what it prints. Throws Failure.
FirstSolve run_first_solve(const std::string& case_name, const GridSize& grid, int wheels,
                           const Settings& settings) {
  std::vector<std::string> arguments{"wrc_benchmark", "--first-solve",
                                     "--case",        case_name,
                                     "--grid",        grid.text(),
                                     "--method",      settings.method,
                                     "--accuracy",    driver::text_of(settings.tolerance)};
  if (wheels == 2) {
    arguments.emplace_back("--both-wheels");
  }
  const auto json = driver::json::parse(output_of(std::move(arguments)));
  FirstSolve first;
  first.times = {json.at("setup"), json.at("geometry"), json.at("remesh"), json.at("mechanics"),
                 json.at("total")};
  first.memory_mb = json.at("memory_mb");
  return first;
}

constexpr double default_accuracy = 1e-4;
/// New handles and child processes per row, at the most.
constexpr int most_blocks = 5;
/// Time for the repeated solutions of a row, at the least one solution.
constexpr double time_budget_ms = 1500.0;

/// One method of a case while it is measured.
struct Series {
  Settings settings;
  Quality cold_quality;
  int blocks = 1;
  int warm_per_block = 1;
  std::vector<Times> cold;
  std::vector<Times> warm;
  std::vector<Times> cold_process;
  std::vector<double> memory_mb;
};

/// The largest tolerance at which the paper's method is as good as the default one, or as the
/// accuracy asked if that is more: its tolerance is one of gaps, so that pressures are off by more.
double paper_tolerance(Problem& problem, double accuracy, double default_error) {
  constexpr double greatest = 0.1;
  constexpr double least = 1e-12;
  const double target = std::max(accuracy, default_error);
  for (double decade = std::min(10.0 * accuracy, greatest); decade > least; decade /= 10.0) {
    for (const double factor : {1.0, 0.3}) {
      const double tolerance = factor * decade;
      const Settings settings{"paper", tolerance};
      problem.solve_cold(settings);
      double error = problem.judge("paper").error_p;
      if (error <= target && problem.wheels() > 0) {
        problem.solve_warm(settings); // a scene is then posed again, with the depth found before
        error = problem.judge("paper").error_p;
      }
      if (error <= target) {
        return tolerance;
      }
    }
  }
  throw driver::Failure("the paper's method does not reach the accuracy of this case");
}

std::vector<Series> prepare(Problem& problem, const Plan& plan) {
  std::vector<Series> all;
  const double accuracy = plan.accuracy.value_or(default_accuracy);
  problem.solve_cold({"default", accuracy});
  const double default_error = problem.judge("default").error_p;
  for (const std::string& method : plan.methods) {
    Series series;
    series.settings = {method, accuracy};
    if (method == "paper") {
      series.settings.tolerance = paper_tolerance(problem, accuracy, default_error);
    }
    const double time = problem.solve_cold(series.settings).total;
    series.cold_quality = problem.judge(method);
    const double affordable = std::max(1.0, std::min(time_budget_ms / time, 1e6));
    const int solutions = std::min(plan.repeat, static_cast<int>(affordable));
    series.blocks = std::min(solutions, most_blocks);
    series.warm_per_block = (solutions + series.blocks - 1) / series.blocks;
    all.push_back(series);
  }
  return all;
}

Row row_of(const Series& series, const std::string& state, const std::vector<Times>& times,
           const Quality& quality) {
  Row row;
  row.method = series.settings.method;
  row.tolerance = series.settings.tolerance;
  row.state = state;
  row.fill = quality.fill;
  row.iterations = quality.iterations;
  row.error_p = quality.error_p;
  row.times = median(times);
  const auto all = totals(times);
  row.min_ms = *std::min_element(all.begin(), all.end());
  row.memory_mb = median(series.memory_mb);
  row.repeats = static_cast<int>(times.size());
  return row;
}

} // namespace

void print_first_solve(Problem& problem, const Settings& settings) {
  const double before = memory_mb("VmRSS");
  const Times times = problem.solve_cold(settings);
  const driver::json made{{"setup", times.setup},   {"geometry", times.geometry},
                          {"remesh", times.remesh}, {"mechanics", times.mechanics},
                          {"total", times.total},   {"memory_mb", memory_mb("VmHWM") - before}};
  std::cout << made << '\n';
}

std::unique_ptr<Problem> make_problem(const std::string& case_name, const GridSize& grid,
                                      int wheels) {
  return wheels == 0 ? make_normal_problem(case_name, grid)
                     : make_scene_problem(case_name, grid, wheels);
}

std::vector<Row> measure(const std::string& case_name, const GridSize& grid, int wheels,
                         const Plan& plan) {
  const auto problem = make_problem(case_name, grid, wheels);
  std::vector<Series> all = prepare(*problem, plan);
  Yardstick yardstick(grid);
  yardstick.sample();
  // The methods and the yardstick take turns, so that what else goes on meets them alike.
  for (int block = 0; block < most_blocks; ++block) {
    for (Series& series : all) {
      if (block >= series.blocks) {
        continue;
      }
      const FirstSolve first = run_first_solve(case_name, grid, wheels, series.settings);
      series.cold_process.push_back(first.times);
      series.memory_mb.push_back(first.memory_mb);
      series.cold.push_back(problem->solve_cold(series.settings));
      for (int i = 0; i < series.warm_per_block; ++i) {
        series.warm.push_back(problem->solve_warm(series.settings));
      }
      yardstick.sample();
    }
  }
  std::vector<Row> rows;
  for (const Series& series : all) {
    const Quality warm_quality = problem->judge(series.settings.method);
    const auto error_pmax = problem->error_pmax(series.settings.method);
    rows.push_back(row_of(series, "cold-process", series.cold_process, series.cold_quality));
    rows.push_back(row_of(series, "cold", series.cold, series.cold_quality));
    rows.push_back(row_of(series, "warm", series.warm, warm_quality));
    for (std::size_t i = rows.size() - 3; i < rows.size(); ++i) {
      rows[i].case_name = case_name;
      rows[i].grid = grid;
      rows[i].wheels = wheels;
      rows[i].accuracy = plan.accuracy.value_or(default_accuracy);
      rows[i].error_pmax = error_pmax;
      rows[i].fft_pair_ms = yardstick.milliseconds();
    }
  }
  return rows;
}

} // namespace benchmark
