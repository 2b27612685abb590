// Errors and costs of the models of creep forces against the full theory, over random cases.
//
//   compare_creep_models [CASES]      ellipses; a fifth of that number of each other patch; default
//   500
//
// Prints the tables of docs/evidence/models.md: of each model the root mean square and the
// largest error of Fx, Fy (in mu N) and Mz (in mu N c, c^2 the contact's area over pi), and the
// median time of a call, processor's time of this thread. The reference is the full theory on 128 x
// 64 elements.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "core/creep_cases.hpp"
#include "rolling/fastsim.hpp"

namespace {

using namespace wrc;
using namespace wrc::evidence;

constexpr double reference_tolerance = 2e-4;

double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

CreepForces forces_of(const RollingSolution& solution) {
  return {solution.longitudinal_force, solution.lateral_force, solution.spin_moment};
}

/// All that models are given of a case; computed outside the time of a call.
struct Given {
  CreepCase problem;
  RollingEllipse ellipse;
  KalkerCoefficients kalker;
};

/// Prepares a case and returns the call that is timed.
using Call = std::function<CreepForces()>;
using Model = std::function<Call(const Given&)>;

struct Row {
  std::string name;
  Model model;
  bool moment = true;
  std::array<double, 3> squares{};
  std::array<double, 3> largest{};
  std::vector<double> times;

  Row(std::string row_name, Model row_model, bool has_moment = true)
      : name(std::move(row_name)), model(std::move(row_model)), moment(has_moment) {}

  void add(const Given& given, const CreepForces& reference) {
    const Call call = model(given);
    CreepForces forces = call(); // not the first: buffers and plans are there
    constexpr int few = 3;
    double best = 1e300;
    for (int i = 0; i < few; ++i) {
      const double start = thread_time();
      forces = call();
      best = std::min(best, thread_time() - start);
    }
    if (best < 20.0) { // too short for one reading of the clock
      constexpr int many = 50;
      const double start = thread_time();
      for (int i = 0; i < many; ++i) {
        forces = call();
      }
      best = (thread_time() - start) / many;
    }
    times.push_back(best);
    const double whole = given.problem.friction * given.problem.load;
    const double c =
        std::sqrt(given.ellipse.longitudinal_semi_axis * given.ellipse.lateral_semi_axis);
    const std::array<double, 3> errors{
        (forces.longitudinal - reference.longitudinal) / whole,
        (forces.lateral - reference.lateral) / whole,
        moment ? (forces.spin_moment - reference.spin_moment) / (whole * c) : 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
      squares[k] += errors[k] * errors[k];
      largest[k] = std::max(largest[k], std::abs(errors[k]));
    }
  }

  void print() {
    const auto count = static_cast<double>(times.size());
    const auto percent = [](double value) {
      char text[32];
      std::snprintf(text, sizeof text, value < 0.0995 ? "%.2g" : "%.0f", 100.0 * value);
      return std::string(text);
    };
    const auto list = [&](const std::array<double, 3>& values, auto change) {
      std::string text;
      for (std::size_t k = 0; k < 3; ++k) {
        text += k > 0 ? ", " : "";
        text += k == 2 && !moment ? "-" : percent(change(values[k]));
      }
      return text;
    };
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                     times.end());
    std::printf("| %s | %s | %s | %.3g |\n", name.c_str(),
                list(squares, [&](double sum) { return std::sqrt(sum / count); }).c_str(),
                list(largest, [](double value) { return value; }).c_str(), times[times.size() / 2]);
    std::fflush(stdout);
  }
};

Model full(std::size_t along, std::size_t across, double tolerance) {
  return [=](const Given& given) -> Call {
    auto gridded = std::make_shared<GriddedCase>(given.problem, along, across, tolerance);
    auto solver = std::make_shared<RollingSolver>();
    return [=] { return forces_of(solver->solve(gridded->problem)); };
  };
}

Model strips(std::size_t along, std::size_t across, bool of_ellipse) {
  return [=](const Given& given) -> Call {
    auto gridded = std::make_shared<GriddedCase>(given.problem, along, across, 1e-3);
    RollingSolver solver;
    Flexibilities flexibilities = flexibilities_of(gridded->problem, solver);
    if (of_ellipse) {
      const double lead = flexibilities.spin_lead;
      flexibilities = flexibilities_of(given.ellipse, given.kalker);
      flexibilities.spin_lead = lead;
    }
    return [=] { return forces_of(solve_with_fastsim(gridded->problem, flexibilities)); };
  };
}

/// With the flexibilities' own cost.
Model strips_with_flexibilities(std::size_t along, std::size_t across) {
  return [=](const Given& given) -> Call {
    auto gridded = std::make_shared<GriddedCase>(given.problem, along, across, 1e-3);
    auto solver = std::make_shared<RollingSolver>();
    return [=] {
      return forces_of(
          solve_with_fastsim(gridded->problem, flexibilities_of(gridded->problem, *solver)));
    };
  };
}

Model fastsim(std::size_t count, bool one_flexibility = false) {
  return [=](const Given& given) -> Call {
    Flexibilities flexibilities = flexibilities_of(given.ellipse, given.kalker);
    if (one_flexibility) { // weighted with the creepages (Kalker 1982)
      const Creepages& w = given.problem.creepages;
      const double spin =
          std::sqrt(given.ellipse.longitudinal_semi_axis * given.ellipse.lateral_semi_axis) *
          w.spin;
      const double mean =
          (std::abs(w.longitudinal) * flexibilities.longitudinal +
           std::abs(w.lateral) * flexibilities.lateral + std::abs(spin) * flexibilities.spin) /
          std::hypot(w.longitudinal, w.lateral, spin);
      flexibilities = {mean, mean, mean, 0.0};
    }
    const RollingEllipse ellipse = given.ellipse;
    const Creepages creepages = given.problem.creepages;
    return [=] { return fastsim_forces(ellipse, flexibilities, creepages, {count, count}).forces; };
  };
}

template <typename Law> Model law(Law forces) {
  return [=](const Given& given) -> Call {
    const RollingEllipse ellipse = given.ellipse;
    const Creepages creepages = given.problem.creepages;
    return [=] { return forces(ellipse, kalker_coefficients(ellipse), creepages); };
  };
}

CreepForces cut_linear(const RollingEllipse& ellipse, const KalkerCoefficients& kalker,
                       const Creepages& creepages) {
  CreepForces forces = linear_forces(ellipse, kalker, creepages);
  const double share = std::min(1.0, ellipse.friction * ellipse.load /
                                         std::hypot(forces.longitudinal, forces.lateral));
  return {share * forces.longitudinal, share * forces.lateral, share * forces.spin_moment};
}

std::vector<Row> models_of(PatchShape shape) {
  std::vector<Row> rows;
  if (shape == PatchShape::ellipse) {
    rows.emplace_back("linear", law(linear_forces));
    rows.emplace_back("linear, cut at mu N", law(cut_linear));
    rows.emplace_back("Shen-Hedrick-Elkins", law(shen_hedrick_elkins_forces));
    rows.emplace_back("Polach", law([](const auto& ellipse, const auto& kalker, const auto& w) {
                        return polach_forces(ellipse, kalker, w);
                      }),
                      false);
    rows.emplace_back("FASTSIM 16 x 16, one L", fastsim(16, true));
    rows.emplace_back("FASTSIM 10 x 10", fastsim(10));
    rows.emplace_back("FASTSIM 16 x 16", fastsim(16));
    rows.emplace_back("FASTSIM 32 x 32", fastsim(32));
    rows.emplace_back("FASTSIM 64 x 64", fastsim(64));
  } else {
    rows.emplace_back("FASTSIM 16 x 16 on the equivalent ellipse", fastsim(16));
  }
  rows.emplace_back("strips 64 x 32, L of the equivalent ellipse", strips(64, 32, true));
  rows.emplace_back("strips 16 x 8", strips(16, 8, false));
  rows.emplace_back("strips 32 x 16", strips(32, 16, false));
  rows.emplace_back("strips 64 x 32", strips(64, 32, false));
  rows.emplace_back("strips 64 x 32 with L computed", strips_with_flexibilities(64, 32));
  rows.emplace_back("full 12 x 6, 2e-2", full(12, 6, 2e-2));
  rows.emplace_back("full 16 x 8, 1e-2", full(16, 8, 1e-2));
  rows.emplace_back("full 32 x 16, 3e-3", full(32, 16, 3e-3));
  rows.emplace_back("full 64 x 32, 1e-3", full(64, 32, 1e-3));
  return rows;
}

void compare(PatchShape shape, const char* title, int cases) {
  std::vector<Row> rows = models_of(shape);
  CaseDraw draw(static_cast<std::uint64_t>(shape) + 1);
  RollingSolver solver;
  for (int number = 0; number < cases; ++number) {
    const CreepCase drawn = draw_case(shape, draw);
    const RollingEllipse ellipse = equivalent_ellipse(drawn);
    const Given given{drawn, ellipse, kalker_coefficients(ellipse)};
    const GriddedCase fine(drawn, 128, 64, reference_tolerance);
    const CreepForces reference = forces_of(solver.solve(fine.problem));
    for (Row& row : rows) {
      row.add(given, reference);
    }
  }
  std::printf("\n%s, %d cases\n\n| model | rms error of Fx, Fy, Mz, %% | largest, %% | us |\n"
              "|---|---|---|---|\n",
              title, cases);
  for (Row& row : rows) {
    row.print();
  }
}

constexpr const char* usage =
    "compare_creep_models [CASES]     default 500\n\n"
    "Compares errors and costs of the models of creep forces: CASES ellipses, and a fifth of that\n"
    "number of each other patch.\n";

int compare_all(const Arguments& arguments) {
  const int cases = arguments.whole(0, "CASES", 500);
  arguments.refuse_beyond(1);
  const int others = std::max(1, cases / 5);
  compare(PatchShape::ellipse, "Ellipses", cases);
  compare(PatchShape::lobes_across, "Two lobes side by side", others);
  compare(PatchShape::lobes_along, "Two lobes, one behind the other", others);
  compare(PatchShape::banana, "Bananas", others);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return run(argc, argv, usage, compare_all);
}
