#include "wrc_benchmark/report.hpp"

#include <fstream>
#include <iostream>
#include <unistd.h>

#include "benchmark_commit.hpp"
#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/text_table.hpp"
#include "wrcontact.h"

namespace benchmark {
namespace {

using driver::fixed;
using driver::json;
using driver::json_of;
using driver::power;
using driver::TextTable;

/// What the paper names for one case of 256 x 128 elements, its three modules together: a program
/// in Fortran on a laptop with an Intel Core i5-3230 at 2.60 GHz.
constexpr double paper_total_ms = 8250.0;

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown";
}

/// The paper's method beside the default one in the same state.
struct Ratio {
  const Row& row; ///< of the default method
  double mechanics = 0.0;
  double total = 0.0;
};

std::vector<Ratio> ratios(const std::vector<Row>& rows) {
  std::vector<Ratio> found;
  for (const Row& fast : rows) {
    for (const Row& slow : rows) {
      if (fast.method == "default" && slow.method == "paper" && fast.state == "warm" &&
          slow.state == "warm" && fast.case_name == slow.case_name && fast.motion == slow.motion &&
          (!fast.motion.empty() || fast.grid.text() == slow.grid.text()) &&
          fast.wheels == slow.wheels && fast.accuracy == slow.accuracy) {
        found.push_back({fast, slow.times.mechanics / fast.times.mechanics,
                         slow.times.total / fast.times.total});
      }
    }
  }
  return found;
}

json json_of(const Row& row) {
  json made{{"case", row.case_name},
            {"grid", {row.grid.lateral, row.grid.longitudinal}},
            {"method", row.method},
            {"state", row.state},
            {"wheels", row.wheels},
            {"threads", row.threads},
            {"accuracy", row.accuracy},
            {"tolerance", json_of(row.tolerance)},
            {"fill", row.fill},
            {"iterations", row.iterations},
            {"error_p", json_of(row.error_p)},
            {"error_pmax", json_of(row.error_pmax)},
            {"setup_ms", row.times.setup},
            {"geometry_ms", row.times.geometry},
            {"remesh_ms", row.times.remesh},
            {"mechanics_ms", row.times.mechanics},
            {"total_ms", row.times.total},
            {"min_ms", row.min_ms},
            {"fft_pair_ms", row.fft_pair_ms},
            {"pairs", row.pairs()},
            {"total_pairs", row.total_pairs()},
            {"memory_mb", json_of(row.memory_mb)},
            {"repeats", row.repeats}};
  if (!row.motion.empty()) {
    made["motion"] = row.motion;
    made["percentile_90_ms"] = json_of(row.percentile_90_ms);
    made["worst_ms"] = json_of(row.worst_ms);
  }
  return made;
}

json json_of(const ServiceRow& row) {
  using Times = ServiceRow::Times;
  return {{"case", "service"},
          {"wheel", row.wheel},
          {"rail", row.rail},
          {"accuracy", row.accuracy},
          {"accuracy_of", row.accuracy_of},
          {"prescribed", row.prescribed},
          {"creep", row.creep},
          {"steps", row.steps},
          {"error_depth", json_of(row.errors.depth)},
          {"error_normal_force", json_of(row.errors.normal_force)},
          {"error_lateral_force", row.errors.lateral_force},
          {"error_force", row.errors.force()},
          {"error_pmax", row.errors.pmax},
          {"reference_estimate", row.reference_estimate},
          {"solutions_mean", row.solutions_mean},
          {"solutions_max", row.solutions_max},
          {"mean_ms", row.times.mean},
          {"fft_pair_ms", row.fft_pair_ms},
          {"mean_pairs", row.pairs(&Times::mean)},
          {"median_pairs", row.pairs(&Times::median)},
          {"p99_pairs", row.pairs(&Times::percentile_99)},
          {"p999_pairs", row.pairs(&Times::percentile_999)},
          {"max_pairs", row.pairs(&Times::worst)}};
}

/// Three digits or so, whatever the size.
std::string time_text(double value) {
  return fixed(value, value < 9.995 ? 3 : value < 99.95 ? 2 : value < 999.5 ? 1 : 0);
}

/// The wheels are named beside the case if there are two.
std::string case_text(const Row& row) {
  return row.case_name + (row.wheels == 2 ? ", both" : "");
}

void print_cases(const std::vector<Row>& rows) {
  TextTable table("llllr");
  table.add({"case",       "grid", "method", "state", "requested",  "toler.", "error p",
             "error pmax", "fill", "iter",   "setup", "geom",       "remesh", "mechan",
             "total",      "min",  "pair",   "pairs", "total/pair", "MB"});
  for (const Row& row : rows) {
    if (row.motion.empty() && row.case_name != "batch") {
      table.add({case_text(row),
                 row.grid.text(),
                 row.method,
                 row.state,
                 power(row.accuracy, 0),
                 power(row.tolerance, 0),
                 power(row.error_p, 1),
                 power(row.error_pmax, 1),
                 fixed(row.fill, 2),
                 fixed(row.iterations, 0),
                 time_text(row.times.setup),
                 time_text(row.times.geometry),
                 time_text(row.times.remesh),
                 time_text(row.times.mechanics),
                 time_text(row.times.total),
                 time_text(row.min_ms),
                 time_text(row.fft_pair_ms),
                 fixed(row.pairs(), 1),
                 fixed(row.total_pairs(), 1),
                 row.memory_mb ? fixed(*row.memory_mb, 1) : "-"});
    }
  }
  if (table.row_count() > 1) {
    table.print(std::cout);
    std::cout
        << "\n  requested: largest error of p over pmax. toler.: tolerance given to the solver for "
           "it; for paper the loosest one that\n  gives an error p not larger than requested or "
           "than that of default. error p: true largest error of p over pmax, against\n  the same "
           "grid solved "
           "to 1e-10 (above 1024x512: 1e-8). error pmax: against the closed form, or a grid 2 to 3 "
           "times finer.\n  fill: fraction of elements under pressure. iter: iterations of one "
           "wheel on all grids. "
           "Processor times in ms, medians; min: least total.\n  pair: one FFTW transform of twice "
           "the grid "
           "in each direction and back, same run. pairs: mechan/pair; total/pair.\n  cold-process: "
           "first solution of a process; cold: new handle; warm: same handle again. MB: memory of "
           "a process\n  that solves once: its peak above that before, with gap and results.\n\n";
  }
}

void print_motions(const std::vector<Row>& rows) {
  TextTable table("llllr");
  table.add({"case", "motion", "method", "grid", "requested", "error pmax", "iter", "setup", "geom",
             "remesh", "mechan", "median", "90 %", "worst", "pair"});
  for (const Row& row : rows) {
    if (!row.motion.empty()) {
      table.add({row.case_name, row.motion, row.method, row.grid.text(), power(row.accuracy, 0),
                 power(row.error_pmax, 1), fixed(row.iterations, 0), time_text(row.times.setup),
                 time_text(row.times.geometry), time_text(row.times.remesh),
                 time_text(row.times.mechanics), time_text(row.times.total),
                 time_text(*row.percentile_90_ms), time_text(*row.worst_ms),
                 time_text(row.fft_pair_ms)});
    }
  }
  if (table.row_count() > 1) {
    table.print(std::cout);
    std::cout
        << "\n  Table 1 scene, both wheels, one solver handle. hunting: 3 mm sideways over a wave "
           "of "
           "8 m, steps of 40 mm, with yaw;\n  1 %, 0.1 %: lateral steps of this fraction of the "
           "patch's width. Times in ms per step. requested: error of pmax; error pmax:\n  largest "
           "of "
           "both "
           "wheels at ten steps, against 384x384 elements. grid: of the left wheel at the last "
           "step.\n  pair: that of 256x128. paper solves only five steps of the hunting.\n\n";
  }
}

void print_service(const std::vector<ServiceRow>& rows) {
  using Times = ServiceRow::Times;
  TextTable table("lllllr");
  table.add({"case", "profiles", "requested", "of", "prescribed", "depth", "normal", "lateral",
             "pmax", "solut.", "most", "mean ms", "pair ms", "mean", "median", "99 %", "99.9 %",
             "worst"});
  for (const ServiceRow& row : rows) {
    table.add({"service", row.wheel + " on " + row.rail, power(row.accuracy, 0), row.accuracy_of,
               row.prescribed + (row.creep == "none" ? "" : ", " + row.creep),
               power(row.errors.depth, 1), power(row.errors.normal_force, 1),
               power(row.errors.lateral_force, 1), power(row.errors.pmax, 1),
               fixed(row.solutions_mean, 2), fixed(row.solutions_max, 0), time_text(row.times.mean),
               time_text(row.fft_pair_ms), fixed(row.pairs(&Times::mean), 2),
               fixed(row.pairs(&Times::median), 2), fixed(row.pairs(&Times::percentile_99), 2),
               fixed(row.pairs(&Times::percentile_999), 2), fixed(row.pairs(&Times::worst), 2)});
  }
  if (table.row_count() > 1) {
    table.print(std::cout);
    std::cout
        << "\n  " << rows.front().steps
        << " steps of 40 mm over irregular track, both wheels, one solver handle; the very first "
           "step is cold and not counted.\n  requested: error of the results named by \"of\". "
           "prescribed: "
           "loads, with roll solved; or the roll and the height of each wheel that the\n  same "
           "loads give; creepages, motion: with creep forces of these. depth, normal, lateral, "
           "pmax: largest error of both wheels at about 40 steps, "
           "against accuracy 1e-5 (creep forces: 1e-4), relative;\n  of the lateral force over the "
           "vertical one. solut., most: joint solutions of a wheel per step, mean and largest "
           "number. mean ms:\n  "
           "processor time per step, keys set and both wheels solved. pair: one transform of "
           "twice 256x128 and back, sampled\n  between the steps of the row. mean to worst: times "
           "per step, in pairs.\n\n";
  }
}

void print_ratios(const std::vector<Row>& rows) {
  const auto found = ratios(rows);
  if (!found.empty()) {
    std::cout << "Times of paper over default, warm, one run:\n";
    TextTable table("llr");
    table.add({"  case", "grid", "requested", "mechanics", "total"});
    for (const Ratio& ratio : found) {
      table.add(
          {"  " + case_text(ratio.row) + (ratio.row.motion.empty() ? "" : ", " + ratio.row.motion),
           ratio.row.grid.text(), power(ratio.row.accuracy, 0), fixed(ratio.mechanics, 1),
           fixed(ratio.total, 1)});
    }
    table.print(std::cout);
    std::cout << '\n';
  }
  for (const Row& row : rows) {
    if (row.case_name == "table1" && row.grid.text() == "256x128" && row.state == "warm" &&
        row.method == "default") {
      std::cout
          << case_text(row) << ": " << fixed(row.times.total, 2) << " ms, "
          << fixed(paper_total_ms / row.times.total, 0)
          << " times less than the 8250 ms of the paper's program (Fortran, Intel Core i5-3230 "
             "at 2.60 GHz)\n";
    }
  }
}

} // namespace

json json_of(const Report& report) {
  json made;
  made["machine"] = {{"cpu", cpu_name()},
                     {"cores", sysconf(_SC_NPROCESSORS_ONLN)},
                     {"compiler", WRC_BENCHMARK_COMPILER},
                     {"flags", WRC_BENCHMARK_FLAGS},
                     {"threads", 1},
                     {"commit", WRC_BENCHMARK_COMMIT},
                     {"version", wrc_version()}};
  made["paper_total_ms"] = paper_total_ms;
  made["rows"] = json::array();
  for (const Row& row : report.rows) {
    made["rows"].push_back(json_of(row));
  }
  for (const ServiceRow& row : report.service) {
    made["rows"].push_back(json_of(row));
  }
  for (const RollingRow& row : report.rolling) {
    made["rows"].push_back(json_of(row));
  }
  made["paper_over_default"] = json::array();
  for (const Ratio& ratio : ratios(report.rows)) {
    made["paper_over_default"].push_back(
        {{"case", ratio.row.case_name},
         {"motion", ratio.row.motion},
         {"grid", {ratio.row.grid.lateral, ratio.row.grid.longitudinal}},
         {"wheels", ratio.row.wheels},
         {"accuracy", ratio.row.accuracy},
         {"mechanics", ratio.mechanics},
         {"total", ratio.total}});
  }
  if (report.batch) {
    made["batch"] = {{"speedup", report.batch->speedup},
                     {"machine_speedup", report.batch->machine_speedup},
                     {"work_ratio", report.batch->work_ratio},
                     {"bitwise_equal", report.batch->bitwise_equal}};
  }
  return made;
}

void print_tables(const Report& report) {
  std::cout << cpu_name() << ", " << WRC_BENCHMARK_COMPILER << " " << WRC_BENCHMARK_FLAGS
            << ", 1 thread, commit " << WRC_BENCHMARK_COMMIT << "\n\n";
  print_cases(report.rows);
  print_motions(report.rows);
  print_service(report.service);
  print_rolling(report.rolling);
  print_ratios(report.rows);
  if (report.batch) {
    std::cout << "batch: 64 scenes at accuracy 1e-3";
    for (const Row& row : report.batch->rows) {
      std::cout << ", " << fixed(row.times.total, 1) << " ms on " << row.threads
                << (row.threads == 1 ? " thread" : " threads");
    }
    std::cout << ": " << fixed(report.batch->speedup, 2) << " times faster, results "
              << (report.batch->bitwise_equal ? "equal bit for bit" : "NOT EQUAL")
              << ".\n  Two threads took " << fixed(report.batch->work_ratio, 2)
              << " times the processor time of one. Two threads that only transform did "
              << fixed(report.batch->machine_speedup, 2)
              << " times\n  the work of one in the same time: more is not to be expected of this "
                 "machine.\n";
  }
}

} // namespace benchmark
