/// Results of a fixed list of problems, written by one machine and compared with another's.
///
///   instruction_sets record FILE        solves the problems
///   instruction_sets compare ONE OTHER  largest differences; fails if they are too large
///
/// Scalars are compared relative to their value, residuals as they are (they are relative), the
/// fields relative to their largest value. Allowed is a tenth of the tolerance asked for in mixed
/// precision, and 1e-10 in double. Grids are given: numbers of elements chosen by accuracy could
/// change at a threshold.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "wrcontact.hpp"

namespace {

struct Accuracy {
  const char* precision;
  double tolerance;
  [[nodiscard]] double allowed() const {
    return precision == std::string("double") ? 1e-10 : 0.1 * tolerance;
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    out << precision << ' ' << tolerance;
    return out.str();
  }
};
constexpr std::array<Accuracy, 5> accuracies{
    {{"mixed", 1e-3}, {"mixed", 1e-4}, {"mixed", 1e-6}, {"double", 1e-6}, {"double", 1e-10}}};

/// One result: values, what they are divided by, and the largest difference allowed.
struct Result {
  std::vector<double> values;
  double scale = 1.0;
  double allowed = 0.0;
};
using Results = std::map<std::string, Result>; // by "problem; accuracy; name"

/// Takes numbers and fields by name.
template <class Solved> class Recorder {
public:
  Recorder(Results& results, const Solved& solved, std::string problem, double allowed)
      : results_(results), solved_(solved), problem_(std::move(problem)), allowed_(allowed) {}

  void take_number(const std::string& name) {
    const double value = solved_.number(name);
    const bool is_relative = name.find("residuals") != std::string::npos;
    results_[problem_ + "; " + name] = {{value}, is_relative ? 1.0 : std::abs(value), allowed_};
  }
  void take_field(const std::string& name) {
    std::vector<double> values = solved_.field(name);
    double scale = 0.0;
    for (const double value : values) {
      scale = std::max(scale, std::abs(value));
    }
    results_[problem_ + "; " + name] = {std::move(values), scale, allowed_};
  }

private:
  Results& results_;
  const Solved& solved_;
  std::string problem_;
  double allowed_;
};

template <class Problem> void solve(Problem& problem, const std::string& name) {
  if (!problem.solve()) {
    throw std::runtime_error(name + ": not converged");
  }
}

struct ScenePlace {
  const char* name;
  double lateral;
  double yaw;
  const char* wheel;
  const char* rail;
};
constexpr std::array<ScenePlace, 4> scene_places{{{"centred", 0.0, 0.0, "S1002", "60E1"},
                                                  {"two lobes", 5.0, 0.0, "S1002", "60E1"},
                                                  {"flange, yawed", 8.0, 0.01, "S1002", "60E1"},
                                                  {"LMA on CHN60", 2.0, -0.02, "LMA", "CHN60"}}};

void record_scene(const ScenePlace& place, const Accuracy& accuracy, Results& results) {
  const std::string problem = std::string(place.name) + "; " + accuracy.text();
  wrcontact::Scene scene;
  scene.set("solve.grid", std::vector{40.0, 50.0});
  scene.set("solve.tolerance", accuracy.tolerance);
  scene.set("wheelset.wheel", place.wheel);
  scene.set("track.rail", place.rail);
  scene.set("pose.lateral", place.lateral);
  scene.set("pose.yaw", place.yaw);
  wrcontact::Solver solver;
  solver.set("precision", accuracy.precision);
  if (!solver.solve(scene)) {
    throw std::runtime_error(problem + ": not converged");
  }
  Recorder recorder(results, scene, problem, accuracy.allowed());
  recorder.take_number("roll");
  recorder.take_number("vertical");
  for (const std::string side : {"left", "right"}) {
    for (const char* name : {".pmax", ".normal_force", ".vertical_force", ".lateral_force",
                             ".approach", ".depth", ".area", ".residuals.load_balance",
                             ".residuals.least_gap", ".residuals.complementarity"}) {
      recorder.take_number(side + name);
    }
    recorder.take_field(side + ".pressure");
  }
}

/// Undeformed distances by name, on [-1, 1] x [-1, 1], mm.
double distance_at(const std::string& shape, double lateral, double longitudinal) {
  const double bowl = 0.05 * lateral * lateral + 0.05 * longitudinal * longitudinal;
  if (shape == "ellipse") {
    return 0.01 * lateral * lateral + 0.1 * longitudinal * longitudinal;
  }
  if (shape == "waves") {
    return bowl + 0.002 * std::cos(9.0 * lateral) * std::cos(7.0 * longitudinal + 1.0);
  }
  return bowl;
}

void record_normal(const std::string& shape, bool load_is_given, const Accuracy& accuracy,
                   Results& results) {
  const std::string problem =
      shape + (load_is_given ? ", load given" : ", approach given") + "; " + accuracy.text();
  constexpr std::int64_t rows = 61;
  constexpr std::int64_t columns = 80;
  std::vector<double> distance;
  for (std::int64_t row = 0; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) {
      distance.push_back(distance_at(shape, 2.0 * (static_cast<double>(row) + 0.5) / rows - 1.0,
                                     2.0 * (static_cast<double>(column) + 0.5) / columns - 1.0));
    }
  }
  wrcontact::NormalContact normal;
  normal.set_grid(rows, columns, 2.0 / rows, 2.0 / columns);
  normal.set_distance(distance);
  normal.set(load_is_given ? "normal_load" : "approach", load_is_given ? 2000.0 : 0.02);
  normal.set("tolerance", accuracy.tolerance);
  normal.set("precision", accuracy.precision);
  solve(normal, problem);
  Recorder recorder(results, normal, problem, accuracy.allowed());
  for (const char* name : {"approach", "normal_force", "pmax", "area", "residuals.load_balance",
                           "residuals.least_gap", "residuals.complementarity"}) {
    recorder.take_number(name);
  }
  recorder.take_field("pressure");
  recorder.take_field("displacement");
}

void record(const std::string& path) {
  Results results;
  for (const Accuracy& accuracy : accuracies) {
    for (const ScenePlace& place : scene_places) {
      record_scene(place, accuracy, results);
    }
    for (const char* shape : {"bowl", "ellipse", "waves"}) {
      record_normal(shape, true, accuracy, results);
      record_normal(shape, false, accuracy, results);
    }
  }
  std::ofstream file(path);
  file.precision(std::numeric_limits<double>::max_digits10);
  for (const auto& [name, result] : results) {
    file << name << '\n' << result.scale << ' ' << result.allowed << ' ' << result.values.size();
    for (const double value : result.values) {
      file << ' ' << value;
    }
    file << '\n';
  }
  if (!file.flush()) {
    throw std::runtime_error(path + " cannot be written");
  }
}

Results read(const std::string& path) {
  std::ifstream file(path);
  Results results;
  std::string name;
  std::string line;
  while (std::getline(file, name) && std::getline(file, line)) {
    std::istringstream values(line);
    Result result;
    std::size_t count = 0;
    values >> result.scale >> result.allowed >> count;
    result.values.resize(count);
    for (double& value : result.values) {
      values >> value;
    }
    if (!values) {
      throw std::runtime_error(path + ": cannot read " + name);
    }
    results[name] = std::move(result);
  }
  if (results.empty()) {
    throw std::runtime_error(path + " holds no results");
  }
  return results;
}

double difference(const Result& one, const Result& other) {
  if (one.values.size() != other.values.size()) {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    const double difference = std::abs(one.values[i] - other.values[i]);
    if (!(difference <= largest)) { // also where it is no number
      largest = difference;
    }
  }
  return largest == 0.0 ? 0.0 : largest / one.scale;
}

/// Whether all differences are allowed; tells the largest of each accuracy.
bool compare(const std::string& one_path, const std::string& other_path) {
  const Results one = read(one_path);
  const Results other = read(other_path);
  bool good = one.size() == other.size();
  struct Worst {
    double difference = 0.0;
    std::string name = "none";
  };
  std::map<double, Worst> worst; // by what is allowed
  for (const auto& [name, result] : one) {
    const auto found = other.find(name);
    const double found_difference = found == other.end() ? std::numeric_limits<double>::infinity()
                                                         : difference(result, found->second);
    if (!(found_difference <= result.allowed)) {
      std::cout << "  " << name << ": differs by " << found_difference << ", allowed is "
                << result.allowed << '\n';
      good = false;
    }
    Worst& of_accuracy = worst[result.allowed];
    if (found_difference > of_accuracy.difference) {
      of_accuracy = {found_difference, name};
    }
  }
  for (const auto& [allowed, of_accuracy] : worst) {
    std::cout << "  allowed " << allowed << ", largest difference " << of_accuracy.difference
              << " (" << of_accuracy.name << ")\n";
  }
  return good;
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 2 && arguments[0] == "record") {
      record(arguments[1]);
      return EXIT_SUCCESS;
    }
    if (arguments.size() == 3 && arguments[0] == "compare") {
      return compare(arguments[1], arguments[2]) ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    std::cerr << "usage: instruction_sets record FILE | compare ONE OTHER\n";
  } catch (const std::exception& error) {
    std::cerr << "instruction_sets: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
