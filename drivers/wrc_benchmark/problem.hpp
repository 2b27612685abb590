/// A problem on a given grid, which can be solved again and again by each method.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wrc_benchmark/row.hpp"

namespace benchmark {

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
  /// Of the last solution by a method: error of its pressures against the same grid's distances
  /// solved to 1e-10 (above 1024x512 elements 1e-8) in double precision.
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

/// Gaps given by formulas (normal_cases.cpp) and wheel/rail scenes (scene_cases.cpp).
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
