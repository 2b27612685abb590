#include "wrc_benchmark/child.hpp"

#include <array>
#include <charconv>
#include <fstream>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "support/scene.hpp"

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

std::string text_of(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
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

} // namespace

void print_first_solve(Problem& problem, const Settings& settings) {
  const double before = memory_mb("VmRSS");
  const Times times = problem.solve_cold(settings);
  const nlohmann::json json{{"setup", times.setup},   {"geometry", times.geometry},
                            {"remesh", times.remesh}, {"mechanics", times.mechanics},
                            {"total", times.total},   {"memory_mb", memory_mb("VmHWM") - before}};
  std::cout << json << '\n';
}

FirstSolve run_first_solve(const std::string& case_name, const GridSize& grid, int wheels,
                           const Settings& settings) {
  std::vector<std::string> arguments{
      "wrc_benchmark", "--first-solve", "--case",        case_name,    "--grid",
      grid.text(),     "--method",      settings.method, "--accuracy", text_of(settings.tolerance)};
  if (wheels == 2) {
    arguments.emplace_back("--both-wheels");
  }
  const auto json = nlohmann::json::parse(output_of(std::move(arguments)));
  FirstSolve first;
  first.times = {json.at("setup"), json.at("geometry"), json.at("remesh"), json.at("mechanics"),
                 json.at("total")};
  first.memory_mb = json.at("memory_mb");
  return first;
}

} // namespace benchmark
