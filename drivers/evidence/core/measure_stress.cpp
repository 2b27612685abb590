// Costs of stresses below the surface in normal solutions of the same grid: medians of this
// machine, so read the ratios. Usage: measure_stress [REPEATS]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "base/stopwatch.hpp"
#include "damage/subsurface_stress.hpp"
#include "mechanics/normal_solver.hpp"
#include "support/patch_problem.hpp"
#include "support/random_wheels.hpp"

namespace {

using namespace wrc;
using namespace wrc::test;

template <class Work> double median_ms(int repeats, Work work) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const Stopwatch watch;
    work();
    times.push_back(watch.milliseconds());
  }
  return quantile(std::move(times), 0.5);
}

/// A normal solution whose contact fills so much of each side of 64 x 32 elements.
struct Contact {
  Grid grid{32, 64, 0.0375, 0.03125, -0.58125, -0.984375};
  std::vector<double> distance;
  PatchProblem problem{grid, {}, 1e5};
  NormalSolver solver;
  PatchSolution solution;

  explicit Contact(double fill) {
    for (std::size_t i = 0; i < grid.element_count(); ++i) {
      const double x = grid.longitudinal(i % 64);
      const double y = grid.lateral(i / 64);
      distance.push_back(x * x / 1000.0 + y * y / 500.0);
    }
    problem.patch.undeformed_distance = distance;
    problem.tolerance = 1e-4;
    problem.load = 1.0;
    double filled = 0.0;
    while (filled < 0.785 * fill * fill) {
      problem.load = *problem.load * 1.05;
      solution = solver.solve(problem);
      filled = 1.0 - static_cast<double>(
                         std::count(solution.pressure.begin(), solution.pressure.end(), 0.0)) /
                         static_cast<double>(grid.element_count());
    }
  }
};

constexpr const char* usage =
    "measure_stress [REPEATS]     default 101\n\n"
    "Measures costs of stresses below the surface in normal solutions of the same grid.\n";

int measure(const evidence::Arguments& arguments) {
  const int repeats = arguments.whole(0, "REPEATS", 101);
  arguments.refuse_beyond(1);
  std::printf("fill  tractions  normal ms  section of 100 x 60  greatest von Mises\n");
  for (const double fill : {0.95, 0.6}) {
    Contact contact(fill);
    const double normal =
        median_ms(repeats, [&] { contact.solution = contact.solver.solve(contact.problem); });
    for (const double share : {0.0, 0.3}) {
      const std::vector<double>& p = contact.solution.pressure;
      std::vector<double> x(share > 0.0 ? p.size() : 0);
      std::transform(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(x.size()), x.begin(),
                     [share](double value) { return share * value; });
      std::vector<double> places;
      std::vector<double> depths;
      for (int i = 0; i < 100; ++i) {
        places.push_back(fill * (0.03 * i - 1.5));
      }
      for (int i = 0; i < 60; ++i) {
        depths.push_back(fill * 0.04 * (i + 0.5));
      }
      double kept = 0.0;
      const double section = median_ms(repeats, [&] {
        kept += SubsurfaceStress({contact.grid, p, x, x}, 0.28)
                    .along(places, 0.01, depths)
                    .stresses.front()[zz];
      });
      const double greatest = median_ms(repeats, [&] {
        kept += SubsurfaceStress({contact.grid, p, x, x}, 0.28).greatest().von_mises;
      });
      std::printf("%4.2f  %9s  %9.3f  %14.1f normal  %11.1f normal%s\n", fill,
                  share > 0.0 ? "yes" : "no", normal, section / normal, greatest / normal,
                  std::isfinite(kept) ? "" : " not finite");
    }
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return evidence::run(argc, argv, usage, measure);
}
