// What one joint solution of two patches costs, beside one patch of as many elements.
//
//   joint_cost [REPETITIONS [ROWS COLUMNS]]     default: 41, on four grids
//
// S1002 on rails on which it touches in two places. Joint: both patches, on the grid named each,
// with the load of the scene; once as they feel each other there, once without that. One patch:
// either of the two by itself, with its share of the load, on a grid of twice as many elements.
// Tolerance 1e-4, no pressures to start from, solver handle kept, one thread. All take turns;
// medians. docs/performance.md has the results. Not a test: nothing is expected of the times.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "mechanics/normal_solver.hpp"
#include "scene/scene_keys.hpp"
#include "scene/solve_scene.hpp"

namespace {

using namespace wrc;

struct Case {
  const char* rail;
  double lateral; ///< mm
  bool roll_solved;
  double load; ///< N
};

constexpr std::array<Case, 5> cases{{{"UIC60-Manchester", 5.0, false, 1e3},
                                     {"UIC60-Manchester", 5.0, false, 1e4},
                                     {"UIC60-Manchester", 5.0, false, 2e4},
                                     {"60E1", 5.0, true, 3e3},
                                     {"60E1", 5.0, true, 2e4}}};

struct GridSize {
  std::size_t rows;
  std::size_t columns;
};

SideResult solve_left(const Case& asked, const GridSize& grid) {
  Scene scene;
  set_text(scene, "track.rail", asked.rail);
  set_number(scene, "pose.lateral", asked.lateral);
  if (!asked.roll_solved) {
    set_number(scene, "pose.roll", 0.0);
  }
  set_number(scene, "load.vertical", asked.load);
  set_text(scene, "solve.side", "left");
  set_numbers(scene, "solve.grid",
              std::array{static_cast<double>(grid.rows), static_cast<double>(grid.columns)});
  set_number(scene, "solve.tolerance", 1e-6);
  return std::move(*solve_scene(scene).left);
}

/// A problem that is solved again and again, and how long it took.
class Run {
public:
  Run(const SideResult& side, const std::vector<const PatchResult*>& patches, double load,
      bool interacting) {
    for (const PatchResult* patch : patches) {
      PatchGap& gap = gaps_.emplace_back();
      gap.grid = patch->grid;
      gap.undeformed_distance = patch->undeformed_distance;
      gap.approach_share = patches.size() > 1 ? patch->share : 1.0;
    }
    problem_.patches = gaps_;
    problem_.combined_modulus = side.details.combined_modulus;
    problem_.load = load;
    problem_.tolerance = 1e-4;
    problem_.elements = side.details.elements;
    if (interacting && side.details.interaction) {
      problem_.interaction = &*side.details.interaction;
    }
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  void solve() {
    const auto start = std::chrono::steady_clock::now();
    const JointSolution solution = solver_.solve(problem_);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    times_.push_back(time.count());
    convolutions_ = solution.convolutions;
  }

  [[nodiscard]] double median() {
    const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() / 2);
    std::nth_element(times_.begin(), middle, times_.end());
    return *middle;
  }
  [[nodiscard]] int convolutions() const { return convolutions_; }

private:
  std::vector<PatchGap> gaps_;
  JointProblem problem_;
  NormalSolver solver_;
  std::vector<double> times_;
  int convolutions_ = 0;
};

void measure(const Case& asked, const GridSize& grid, int repetitions) {
  const auto finer = [](std::size_t count) {
    return static_cast<std::size_t>(std::lround(std::sqrt(2.0) * static_cast<double>(count)));
  };
  const SideResult joint = solve_left(asked, grid);
  const SideResult fine = solve_left(asked, {finer(grid.rows), finer(grid.columns)});
  const std::vector<const PatchResult*> both = solved_patches(joint);
  const std::vector<const PatchResult*> single = solved_patches(fine);
  if (both.size() != 2 || single.size() != 2) {
    std::printf("%-17s %6.0f N: not two patches\n", asked.rail, asked.load);
    return;
  }
  Run with(joint, both, *joint.details.load, true);
  Run without(joint, both, *joint.details.load, false);
  Run first(fine, {single[0]}, single[0]->normal_force, false);
  Run second(fine, {single[1]}, single[1]->normal_force, false);
  for (int i = 0; i < repetitions; ++i) {
    for (Run* run : {&with, &without, &first, &second}) {
      run->solve();
    }
  }
  const double one = 0.5 * (first.median() + second.median());
  std::printf("%-17s %6.0f N  %3zu x %-3zu  %-5s  %7.3f  %7.3f  %7.3f  %7.3f  %5.2f  %7.2f  "
              "%2d %2d / %2d %2d\n",
              asked.rail, asked.load, grid.rows, grid.columns,
              joint.details.interaction ? "close" : "apart", with.median(), without.median(),
              first.median(), second.median(), with.median() / one, without.median() / one,
              with.convolutions(), without.convolutions(), first.convolutions(),
              second.convolutions());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : 41;
  std::vector<GridSize> grids{{32, 32}, {64, 64}, {128, 128}, {256, 128}};
  if (argc > 3) {
    grids = {{static_cast<std::size_t>(std::atoi(argv[2])),
              static_cast<std::size_t>(std::atoi(argv[3]))}};
  }
  if (repetitions < 1 || grids[0].rows < 2 || grids[0].columns < 2) {
    std::fprintf(stderr, "joint_cost [REPETITIONS [ROWS COLUMNS]]: at least 1, 2, 2\n");
    return 2;
  }
  std::printf("Times in ms. joint: both patches, each on the grid, as they feel each other and\n"
              "without that; one: either by itself on a grid of twice as many elements; over one:\n"
              "joint over the mean of both; convolutions: joint, joint without / one, one\n\n"
              "%-17s %8s  %-9s  %-5s  %7s  %7s  %7s  %7s  %5s  %7s  %s\n",
              "rail", "load", "grid", "are", "joint", "without", "one", "one", "over", "without",
              "convolutions");
  for (const Case& asked : cases) {
    for (const GridSize& grid : grids) {
      measure(asked, grid, repetitions);
    }
  }
  return 0;
}
