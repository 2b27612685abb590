// wrc_benchmark: times whole scenes by stage, each time beside the error of what was computed.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

#include "benchmark_commit.hpp"
#include "support/program.hpp"
#include "support/scene.hpp"

namespace {

/// What the paper names for one case of 256 x 128 elements, its three modules together: the
/// program in Fortran on a laptop with an Intel Core i5-3230 at 2.60 GHz.
constexpr double paper_total_ms = 8250.0;
/// Tolerance of the solution that the iteration's error is measured against.
constexpr double truth_tolerance = 1e-11;
/// The grid's error is measured against a grid this much finer in both directions.
constexpr std::size_t truth_refinement = 3;

struct Case {
  std::string name;
  std::string meaning;
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"table1", "S1002 on 60E1, centred, 80 kN, left wheel", {}, {{"solve.side", "left"}}},
      {"manchester-5",
       "S1002 on the Manchester UIC60, y = 5 mm without roll: two lobes, left wheel",
       {{"pose.lateral", 5.0}, {"pose.roll", 0.0}},
       {{"solve.side", "left"}, {"track.rail", "UIC60-Manchester"}}}};
  return all;
}

struct Grid {
  std::size_t lateral = 256;
  std::size_t longitudinal = 128;
};

struct Row {
  std::string case_name;
  Grid grid;
  std::string method;
  std::string state;
  double accuracy = 0.0;
  double fill = 0.0;
  double iterations = 0.0;
  double error_p = 0.0;
  double error_pmax = 0.0;
  double complementarity = 0.0;
  double setup_ms = 0.0;
  double geometry_ms = 0.0;
  double remesh_ms = 0.0;
  double mechanics_ms = 0.0;
  double total_ms = 0.0;
  double min_ms = 0.0;
  double memory_mb = 0.0;
};

driver::Scene scene_of(const Case& chosen, const Grid& grid, const std::string& method,
                       double tolerance) {
  driver::Scene scene;
  for (const auto& [key, value] : chosen.numbers) {
    scene.set(key, value);
  }
  for (const auto& [key, value] : chosen.texts) {
    scene.set(key, value);
  }
  scene.set("solve.grid", std::vector<double>{static_cast<double>(grid.lateral),
                                              static_cast<double>(grid.longitudinal)});
  scene.set("solve.solver", method);
  scene.set("solve.tolerance", tolerance);
  return scene;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void set_times(Row& row, const std::map<std::string, std::vector<double>>& times) {
  const auto at = [&times](const char* stage) { return median(times.at(stage)); };
  row.setup_ms = at("profile") + at("setup");
  row.geometry_ms = at("geometry");
  row.remesh_ms = at("remesh");
  row.mechanics_ms = at("mechanics");
  row.total_ms = at("total");
  row.min_ms = *std::min_element(times.at("total").begin(), times.at("total").end());
}

/// Rows of one case: the first solution in the process, and the median of those that follow.
std::vector<Row> measure(const Case& chosen, const Grid& grid, const std::string& method,
                         double tolerance, int repetitions) {
  const char* stages[] = {"profile", "setup", "geometry", "remesh", "mechanics", "total"};
  std::map<std::string, std::vector<double>> first;
  std::map<std::string, std::vector<double>> following;
  driver::Scene scene = scene_of(chosen, grid, method, tolerance);
  for (int i = 0; i <= repetitions; ++i) {
    scene.solve();
    for (const char* stage : stages) {
      (i == 0 ? first : following)[stage].push_back(scene.number(std::string("time_ms.") + stage));
    }
  }
  Row row;
  row.case_name = chosen.name;
  row.grid = grid;
  row.method = method;
  row.accuracy = tolerance;
  row.fill = scene.number("left.fill");
  row.iterations = scene.number("left.iterations");
  row.complementarity = scene.number("left.residuals.complementarity");
  row.memory_mb = peak_memory_mb();

  driver::Scene truth = scene_of(chosen, grid, method, truth_tolerance);
  truth.solve();
  const auto pressure = scene.field("left.pressure");
  const auto true_pressure = truth.field("left.pressure");
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    row.error_p = std::max(row.error_p, std::abs(pressure[i] - true_pressure[i]));
  }
  row.error_p /= truth.number("left.pmax");
  driver::Scene fine =
      scene_of(chosen, {truth_refinement * grid.lateral, truth_refinement * grid.longitudinal},
               method, tolerance);
  fine.solve();
  row.error_pmax = std::abs(scene.number("left.pmax") / fine.number("left.pmax") - 1.0);

  std::vector<Row> rows(2, row);
  rows[0].state = "cold";
  set_times(rows[0], first);
  rows[1].state = "warm";
  set_times(rows[1], following);
  return rows;
}

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown";
}

void print_json(const std::vector<Row>& rows) {
  nlohmann::json json;
  json["machine"] = {{"cpu", cpu_name()},
                     {"cores", sysconf(_SC_NPROCESSORS_ONLN)},
                     {"compiler", WRC_BENCHMARK_COMPILER},
                     {"flags", WRC_BENCHMARK_FLAGS},
                     {"threads", 1},
                     {"commit", WRC_BENCHMARK_COMMIT},
                     {"version", wrc_version()}};
  json["paper_total_ms"] = paper_total_ms;
  json["rows"] = nlohmann::json::array();
  for (const Row& row : rows) {
    json["rows"].push_back({{"case", row.case_name},
                            {"grid", {row.grid.lateral, row.grid.longitudinal}},
                            {"method", row.method},
                            {"state", row.state},
                            {"accuracy", row.accuracy},
                            {"fill", row.fill},
                            {"iterations", row.iterations},
                            {"error_p", row.error_p},
                            {"error_pmax", row.error_pmax},
                            {"complementarity", row.complementarity},
                            {"setup_ms", row.setup_ms},
                            {"geometry_ms", row.geometry_ms},
                            {"remesh_ms", row.remesh_ms},
                            {"mechanics_ms", row.mechanics_ms},
                            {"total_ms", row.total_ms},
                            {"min_ms", row.min_ms},
                            {"memory_mb", row.memory_mb}});
  }
  std::cout << json.dump(2) << '\n';
}

void print_table(const std::vector<Row>& rows) {
  std::cout << cpu_name() << ", " << WRC_BENCHMARK_COMPILER << " " << WRC_BENCHMARK_FLAGS
            << ", 1 thread, commit " << WRC_BENCHMARK_COMMIT << "\n\n"
            << "case          grid       method   state  fill iter   error p error pmax  setup  "
               "geometry  remesh  mechanics    total      min ms  MB\n";
  for (const Row& row : rows) {
    std::ostringstream grid;
    grid << row.grid.lateral << 'x' << row.grid.longitudinal;
    std::cout << std::left << std::setw(14) << row.case_name << std::setw(11) << grid.str()
              << std::setw(9) << row.method << std::setw(6) << row.state << std::right << std::fixed
              << std::setprecision(2) << std::setw(5) << row.fill << std::setprecision(0)
              << std::setw(5) << row.iterations << std::scientific << std::setprecision(1)
              << std::setw(10) << row.error_p << std::setw(11) << row.error_pmax << std::fixed
              << std::setprecision(2) << std::setw(7) << row.setup_ms << std::setw(10)
              << row.geometry_ms << std::setw(8) << row.remesh_ms << std::setw(11)
              << row.mechanics_ms << std::setw(9) << row.total_ms << std::setw(12) << row.min_ms
              << std::setprecision(0) << std::setw(4) << row.memory_mb << '\n';
  }
  std::cout << "\nThe paper's program took 8250 ms for a case of 256 x 128 (Fortran, Intel Core "
               "i5-3230 at 2.60 GHz).\n";
  for (const Row& row : rows) {
    if (row.grid.lateral == 256 && row.grid.longitudinal == 128 && row.state == "warm") {
      std::cout << "  " << row.case_name << ": " << std::fixed << std::setprecision(1)
                << row.total_ms << " ms here, " << std::setprecision(0)
                << paper_total_ms / row.total_ms << " times less, on another machine\n";
    }
  }
  std::cout
      << "\nTimes are medians. error p: largest difference from the solution of the same grid "
         "at tolerance 1e-11, over pmax.\nerror pmax: difference from a grid three times "
         "finer. cold: first solution of the case; warm: those after it, same handle.\n"
         "MB: peak memory of the process so far.\n";
}

Grid parse_grid(const std::string& text) {
  std::istringstream stream(text);
  Grid grid;
  char cross = ' ';
  char rest = ' ';
  if (!(stream >> grid.lateral >> cross >> grid.longitudinal) || cross != 'x' || stream >> rest ||
      grid.lateral < 1 || grid.longitudinal < 1 || grid.lateral > 2048 ||
      grid.longitudinal > 2048) {
    throw driver::Failure("--grid " + text + ": allowed is NxM with N and M from 1 to 2048");
  }
  return grid;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Times wheel/rail scenes by stage, each time beside the error of what was "
               "computed.\nOne thread; the times of one run may be compared, those of two "
               "machines may not.",
               "wrc_benchmark");
  std::string case_name;
  std::string grid_text = "256x128";
  double tolerance = 1e-6;
  std::string method = "default";
  int repetitions = 9;
  bool json = false;
  std::string case_list = "case to run; all if not given:";
  for (const Case& known : cases()) {
    case_list += "\n" + known.name + ": " + known.meaning;
  }
  app.add_option("--case", case_name, case_list)->type_name("NAME");
  app.add_option("--grid", grid_text, "elements across x along (default 256x128)")
      ->type_name("NxM");
  app.add_option("--accuracy", tolerance, "tolerance of the iteration (default 1e-6)")
      ->type_name("EPS");
  app.add_option("--method", method, "default or paper (Polonsky & Keer 1999)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"default", "paper"}));
  app.add_option("--repetitions", repetitions, "solutions timed after the first (default 9)")
      ->check(CLI::Range(1, 1000));
  app.add_flag("--json", json, "print one JSON object instead of the table");
  return driver::run_program(app, argc, argv, [&] {
    const Grid grid = parse_grid(grid_text);
    std::vector<Row> rows;
    std::string names;
    for (const Case& known : cases()) {
      names += ' ' + known.name;
      if (!case_name.empty() && case_name != known.name) {
        continue;
      }
      std::cerr << "wrc_benchmark: " << known.name << ", " << grid_text << ", method " << method
                << " ...\n";
      for (const Row& row : measure(known, grid, method, tolerance, repetitions)) {
        rows.push_back(row);
      }
    }
    if (rows.empty()) {
      throw driver::Failure("--case " + case_name + ": allowed is one of" + names);
    }
    if (json) {
      print_json(rows);
    } else {
      print_table(rows);
    }
    return 0;
  });
}
