// wrc_benchmark: times the solvers and whole scenes, and shows each time beside its error.
#include <algorithm>
#include <iostream>
#include <sstream>

#include "support/json.hpp"
#include "support/program.hpp"
#include "support/scene.hpp"
#include "wrc_benchmark/measure.hpp"
#include "wrc_benchmark/motion_cases.hpp"
#include "wrc_benchmark/report.hpp"

namespace {

using benchmark::GridSize;

struct Options {
  std::vector<std::string> cases;
  std::string grid = "256x128";
  benchmark::Plan plan;
  std::string method;
  bool json = false;
  bool first_solve = false;
  bool both_wheels = false;
};

enum class Kind { gap, scene, vehicle, batch, service, rolling };

struct Case {
  benchmark::CaseDescription description;
  Kind kind;
};

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const auto& description : benchmark::normal_cases()) {
    all.push_back({description, Kind::gap});
  }
  for (const auto& description : benchmark::scene_cases()) {
    all.push_back({description, Kind::scene});
  }
  all.push_back(
      {{"vehicle-step", "scene: a hunting wheelset, both wheels, step by step"}, Kind::vehicle});
  all.push_back({{"batch", "scene: 64 scenes on one and on two threads"}, Kind::batch});
  all.push_back({{"rolling", "pressures: creep forces of 40 ellipses on 8x4 to 256x128 elements"},
                 Kind::rolling});
  all.push_back({{"service", "scene: a run over irregular track, three pairs of profiles; takes "
                             "over a minute and runs only if named"},
                 Kind::service});
  return all;
}

GridSize parse_grid(const std::string& text) {
  constexpr std::int64_t greatest = 8192;
  std::istringstream stream(text);
  GridSize grid;
  char cross = ' ';
  char rest = ' ';
  if (!(stream >> grid.lateral >> cross >> grid.longitudinal) || cross != 'x' || stream >> rest ||
      grid.lateral < 1 || grid.longitudinal < 1 || grid.lateral > greatest ||
      grid.longitudinal > greatest) {
    throw driver::Failure("--grid " + text +
                          ": must be NxM with N and M from 1 to 8192, or \"all\"");
  }
  return grid;
}

std::vector<GridSize> grids_of(const Options& options) {
  if (options.grid != "all") {
    return {parse_grid(options.grid)};
  }
  std::vector<GridSize> grids;
  for (std::int64_t lateral = 32; lateral <= 4096; lateral *= 2) {
    grids.push_back({lateral, lateral / 2});
  }
  return grids;
}

std::vector<Case> chosen_cases(const Options& options) {
  std::vector<Case> all = all_cases();
  std::vector<Case> chosen;
  for (const std::string& name : options.cases) {
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const Case& known) { return known.description.name == name; });
    if (found == all.end()) {
      std::string text = "--case " + name + ": must be one of";
      for (const Case& known : all) {
        text += ' ' + known.description.name;
      }
      throw driver::Failure(text);
    }
    chosen.push_back(*found);
  }
  if (chosen.empty() && options.grid == "all") {
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [](const Case& known) {
      return known.description.name == "hertz-circle" || known.description.name == "two-lobes";
    });
  }
  if (chosen.empty()) {
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
                 [](const Case& known) { return known.kind != Kind::service; });
  }
  return chosen;
}

void check_grid(const Case& chosen, const GridSize& grid) {
  constexpr std::int64_t greatest = 2048; // a grid three times finer is solved too
  if (chosen.kind == Kind::scene && std::max(grid.lateral, grid.longitudinal) > greatest) {
    throw driver::Failure("--grid " + grid.text() + ": must be between 1 and 2048 with --case " +
                          chosen.description.name);
  }
}

void append(const std::vector<benchmark::Row>& rows, benchmark::Report& report) {
  report.rows.insert(report.rows.end(), rows.begin(), rows.end());
}

void measure_on_grid(const Case& chosen, const GridSize& grid, benchmark::Plan plan,
                     benchmark::Report& report) {
  // Beyond this the paper's method takes minutes.
  constexpr std::int64_t large = 1024 * 512;
  if (plan.methods.size() > 1 && grid.count() > large) {
    plan.methods = {"default"};
  }
  const std::string& name = chosen.description.name;
  for (const int wheels : chosen.kind == Kind::gap ? std::vector{0}
                          : name == "table1"       ? std::vector{1, 2}
                                                   : std::vector{1}) {
    std::cerr << "wrc_benchmark: " << name << ", " << grid.text()
              << (wheels == 2 ? ", both wheels" : "") << " ...\n";
    append(benchmark::measure(name, grid, wheels, plan), report);
  }
}

benchmark::Report measure(const std::vector<Case>& cases, const std::vector<GridSize>& grids,
                          const benchmark::Plan& plan) {
  benchmark::Report report;
  for (const Case& chosen : cases) {
    if (chosen.kind == Kind::gap || chosen.kind == Kind::scene) {
      for (const GridSize& grid : grids) {
        measure_on_grid(chosen, grid, plan, report);
      }
      continue;
    }
    std::cerr << "wrc_benchmark: " << chosen.description.name << " ...\n";
    if (chosen.kind == Kind::vehicle) {
      append(benchmark::measure_vehicle_steps(plan), report);
    } else if (chosen.kind == Kind::rolling) {
      report.rolling = benchmark::measure_rolling(plan.repeat);
    } else if (chosen.kind == Kind::service) {
      report.service = benchmark::measure_service(plan);
    } else {
      report.batch = benchmark::measure_batch(std::min(plan.repeat, 5));
      append(report.batch->rows, report);
    }
  }
  return report;
}

int run(const Options& options) {
  const std::vector<Case> cases = chosen_cases(options);
  const std::vector<GridSize> grids = grids_of(options);
  for (const Case& chosen : cases) {
    for (const GridSize& grid : grids) {
      check_grid(chosen, grid);
    }
  }
  if (options.first_solve) {
    const Case& chosen = cases.front();
    const bool scene = chosen.kind == Kind::scene;
    if (cases.size() != 1 || grids.size() != 1 || (chosen.kind != Kind::gap && !scene)) {
      throw driver::Failure(
          "--first-solve: give exactly one --case, of those with a grid, and one --grid");
    }
    const auto problem = benchmark::make_problem(chosen.description.name, grids.front(),
                                                 scene ? (options.both_wheels ? 2 : 1) : 0);
    benchmark::print_first_solve(*problem, {options.method.empty() ? "default" : options.method,
                                            options.plan.accuracy.value_or(1e-4)});
    return 0;
  }
  benchmark::Plan plan = options.plan;
  if (!options.method.empty()) {
    plan.methods = {options.method};
  }
  const benchmark::Report report = measure(cases, grids, plan);
  if (options.json) {
    driver::print_json(benchmark::json_of(report), std::cout);
  } else {
    benchmark::print_tables(report);
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  driver::Program app(
      "wrc_benchmark",
      "Times the contact solver and whole wheel/rail scenes, shows the true error beside each\n"
      "time, and compares the default method with the paper's (Polonsky & Keer 1999). Uses one\n"
      "thread, except in batch. Times of one run may be compared with each other. To compare\n"
      "machines, use ratios, or times in transforms of the same size (pairs).");
  Options options;
  std::string case_list = "case to run, may be repeated; default: all except service:";
  for (const Case& known : all_cases()) {
    case_list += "\n" + known.description.name + ": " + known.description.meaning;
  }
  app.add("--case", options.cases, case_list).type("NAME").one_value_each();
  app.add("--grid", options.grid,
          "elements across x along the rail (default 256x128), or \"all\": 32x16 to 4096x2048, "
          "for hertz-circle and two-lobes if no case is given; vehicle-step, batch, rolling and "
          "service choose their own")
      .type("NxM");
  app.add("--accuracy", options.plan.accuracy,
          "requested error: of all pressures relative to pmax (default 1e-4); with vehicle-step of "
          "pmax, with service of forces and of pressures (default 1e-2 and 1e-3)")
      .type("EPS")
      .within(1e-9, 0.1);
  app.add("--method", options.method,
          "method to time; default: both, but paper only up to 1024x512")
      .type("NAME")
      .one_of({"default", "paper"});
  app.add("--repeat", options.plan.repeat,
          "warm solutions per row (default 15; fewer if they take more than 1.5 s)")
      .type("N")
      .within(1, 1000);
  app.add("--steps", options.plan.steps,
          "steps of vehicle-step (default 200: one wave) and of service (default 2000)")
      .type("N")
      .within(1, 100000);
  app.flag("--creep", options.plan.creep,
           "with --case service: add rows with creep forces, of small creepages and of the "
           "motion of the run");
  app.flag("--json", options.json, "print one JSON object instead of the tables");
  app.flag(
      "--first-solve", options.first_solve,
      "solve one --case on one --grid once, with --accuracy as the solver's tolerance, and print "
      "times and memory as JSON; the benchmark runs itself this way for cold-process");
  app.flag("--both-wheels", options.both_wheels,
           "with --first-solve --case table1: solve both wheels");
  app.footer(
      "\nExamples:\n"
      "  wrc_benchmark                                  everything at 256x128, under a "
      "minute\n"
      "  wrc_benchmark --case table1 --method default   where the time of a scene is spent\n"
      "  wrc_benchmark --grid all --method default      how the cost grows with the grid\n"
      "  wrc_benchmark --case two-lobes --accuracy 1e-6 --json\n"
      "  wrc_benchmark --case service --steps 300       the cost of a step in a realistic run\n"
      "docs/evidence/performance.md explains the columns.");
  return app.run(argc, argv, [&] { return run(options); });
}
