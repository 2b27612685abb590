/// A problem on a given grid, which can be solved again and again by each method.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wrcontact.hpp"

namespace benchmark {

struct GridSize {
  std::int64_t lateral = 256;
  std::int64_t longitudinal = 128;

  [[nodiscard]] std::int64_t count() const { return lateral * longitudinal; }
  [[nodiscard]] static GridSize of(const wrcontact::Scene& scene) {
    return {static_cast<std::int64_t>(scene.number("left.grid.lateral")),
            static_cast<std::int64_t>(scene.number("left.grid.longitudinal"))};
  }
  [[nodiscard]] std::string text() const {
    return std::to_string(lateral) + 'x' + std::to_string(longitudinal);
  }
};

/// Milliseconds of the processor by stage; what belongs to no stage is set-up.
struct Times {
  double setup = 0.0;
  double geometry = 0.0;
  double remesh = 0.0;
  double mechanics = 0.0;
  double total = 0.0;

  /// Times of the last solution of a scene, which took `total`. Where a busy machine made its
  /// stages longer than that, each has its share of it.
  static Times of(const wrcontact::Scene& scene, double total) {
    const double share = std::min(1.0, total / scene.number("time_ms.total"));
    const auto stage = [&](const char* name) {
      return share * scene.number(std::string("time_ms.") + name);
    };
    Times times{0.0, stage("geometry"), stage("remesh"), stage("mechanics"), total};
    times.setup = std::max(0.0, total - times.geometry - times.remesh - times.mechanics);
    return times;
  }
};

struct Row {
  std::string case_name;
  std::string motion; ///< vehicle-step: how the scene changes from step to step
  GridSize grid;
  std::string method;
  std::string state; ///< "cold-process", "cold" or "warm"
  int wheels = 1;    ///< wheels solved; 0: a gap is given, there is no wheel
  int threads = 1;
  double accuracy = 0.0;            ///< requested
  std::optional<double> tolerance;  ///< of the iteration, if prescribed
  double fill = 0.0;                ///< fraction of elements under pressure
  double iterations = 0.0;          ///< a wheel, all grids together
  std::optional<double> error_p;    ///< largest, relative to pmax, on the same grid
  std::optional<double> error_pmax; ///< relative, against closed form or finer grid
  Times times;                      ///< medians
  double min_ms = 0.0;              ///< least total
  std::optional<double> percentile_90_ms;
  std::optional<double> worst_ms;
  double fft_pair_ms = 0.0;
  std::optional<double> memory_mb;
  int repeats = 0; ///< solutions behind the medians

  [[nodiscard]] double pairs() const { return times.mechanics / fft_pair_ms; }
  [[nodiscard]] double total_pairs() const { return times.total / fft_pair_ms; }
};

/// What is requested of a run; each case has its own defaults.
struct Plan {
  std::vector<std::string> methods{"default", "paper"};
  /// Largest error of p relative to pmax, 1e-4 if not given; of motions another one.
  std::optional<double> accuracy;
  int repeat = 15;          ///< warm solutions; fewer where they take seconds
  std::optional<int> steps; ///< of motions
  bool creep = false;       ///< of service: with creep forces, too

  [[nodiscard]] std::vector<double> accuracies() const {
    return accuracy ? std::vector{*accuracy} : std::vector{1e-2, 1e-3};
  }
};

struct Settings {
  std::string method = "default"; ///< or "paper"
  double tolerance = 1e-4;
};

/// What came out of the last solution by a method.
struct Quality {
  double fill = 0.0;
  double iterations = 0.0;
  double error_p = 0.0;
};

class Problem {
public:
  virtual ~Problem() = default;

  /// With new handles, from creating them; what the method had before is dropped.
  virtual Times solve_cold(const Settings& settings) = 0;
  /// With the handles of the last solution by this method.
  virtual Times solve_warm(const Settings& settings) = 0;
  /// Quality of the last solution by a method: error of its pressures against the same grid's
  /// distances solved to 1e-10 (above 1024x512 elements 1e-8) in double precision.
  virtual Quality judge(const std::string& method) = 0;
  /// Error of its pmax against the closed form, or a finer grid; none if neither can be had.
  virtual std::optional<double> error_pmax(const std::string& method) = 0;
  /// Wheels solved; 0 for a given gap.
  [[nodiscard]] virtual int wheels() const = 0;
};

struct CaseDescription {
  std::string name;
  std::string meaning;
};

/// Gaps given by formulas and wheel/rail scenes.
const std::vector<CaseDescription>& normal_cases();
const std::vector<CaseDescription>& scene_cases();
std::unique_ptr<Problem> make_normal_problem(const std::string& case_name, const GridSize& grid);
std::unique_ptr<Problem> make_scene_problem(const std::string& case_name, const GridSize& grid,
                                            int wheels);

/// Tolerance of the solution that errors of p are measured against.
double reference_tolerance(const GridSize& grid);
/// Largest difference relative to the largest reference pressure.
double largest_error(const std::vector<double>& pressure, const std::vector<double>& reference);

} // namespace benchmark
