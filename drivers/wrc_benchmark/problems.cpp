// Problems on a given grid. Gaps given by formulas: Hertz's circle and ellipse, and two lobes; each
// contact reaches over 60 % of both sides of its grid, whatever the number of elements. Wheel/rail
// scenes: the whole way from profiles to pressures.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>

#include "support/scene.hpp"
#include "wrc_benchmark/problem.hpp"
#include "wrc_benchmark/yardstick.hpp"

namespace benchmark {
namespace {

constexpr double combined_modulus = 210000.0 / (2.0 * (1.0 - 0.3 * 0.3));
constexpr double hertz_load = 80000.0;
constexpr double share_of_side = 0.6;

/// A gap over the plane; x along, y across, mm.
struct Gap {
  double lateral_side = 0.0;
  double longitudinal_side = 0.0;
  double lateral_centre = 0.0;
  double (*distance)(const Gap& gap, double x, double y) = nullptr;
  double coefficient_x = 0.0; ///< of x^2
  double coefficient_y = 0.0; ///< of y^2
  std::optional<double> pmax; ///< closed form, MPa
};

double paraboloid(const Gap& gap, double x, double y) {
  return gap.coefficient_x * x * x + gap.coefficient_y * y * y;
}

/// Hertz's contact of given semi-axes a (along) >= b (across) under the load:
/// p0 = 3 Q/(2 pi a b), and the gap A x^2 + B y^2 with, for e^2 = 1 - b^2/a^2,
///   A = p0/E* b/(e^2 a^2) (K - E),  B = p0/E* b/(e^2 a^2) (a^2/b^2 E - K)
/// (Johnson, Contact Mechanics, 1985, eqs. 4.31 and 4.32; both pi p0/(4 a E*) for a circle).
Gap hertz_gap(double a, double b) {
  Gap gap;
  gap.longitudinal_side = 2.0 * a / share_of_side;
  gap.lateral_side = 2.0 * b / share_of_side;
  gap.distance = paraboloid;
  const double p0 = 3.0 * hertz_load / (2.0 * std::numbers::pi * a * b);
  gap.pmax = p0;
  if (a == b) {
    gap.coefficient_x = gap.coefficient_y = std::numbers::pi * p0 / (4.0 * a * combined_modulus);
    return gap;
  }
  const double e2 = 1.0 - b * b / (a * a);
  const double e = std::sqrt(e2);
  const double integral_k = std::comp_ellint_1(e);
  const double integral_e = std::comp_ellint_2(e);
  const double common = p0 / combined_modulus * b / (e2 * a * a);
  gap.coefficient_x = common * (integral_k - integral_e);
  gap.coefficient_y = common * (a * a / (b * b) * integral_e - integral_k);
  return gap;
}

/// A wheel of radius 460 mm that touches a rail's head at two points 8 mm apart, across with
/// relative radii of 150 and 80 mm, the second 0.02 mm farther away. Under 80 kN the contacts,
/// which carry 70 and 30 %, reach from -7.18 to 5.80 mm across and over 6.61 mm to both sides
/// along, as measured on 1024 x 512 elements.
double two_lobes(const Gap&, double x, double y) {
  const double first = (y + 4.0) * (y + 4.0) / (2.0 * 150.0);
  const double second = (y - 4.0) * (y - 4.0) / (2.0 * 80.0) + 0.02;
  return x * x / (2.0 * 460.0) + std::min(first, second);
}

Gap two_lobes_gap() {
  Gap gap;
  gap.lateral_side = (7.18 + 5.80) / share_of_side;
  gap.lateral_centre = 0.5 * (5.80 - 7.18);
  gap.longitudinal_side = 2.0 * 6.61 / share_of_side;
  gap.distance = two_lobes;
  return gap;
}

Gap gap_of(const std::string& case_name) {
  if (case_name == "hertz-circle") {
    return hertz_gap(6.0, 6.0);
  }
  if (case_name == "hertz-ellipse") {
    return hertz_gap(12.0, 1.5);
  }
  return two_lobes_gap();
}

class NormalCase : public Problem {
public:
  NormalCase(const std::string& case_name, const GridSize& grid)
      : gap_(gap_of(case_name)), grid_(grid) {
    sample(grid_, distance_);
  }

  Times solve_cold(const Settings& settings) override {
    handles_.erase(settings.method);
    ProcessorStopwatch watch;
    driver::NormalContact& normal = handles_[settings.method];
    prepare(normal, grid_, settings);
    return solve(normal, distance_, watch);
  }

  Times solve_warm(const Settings& settings) override {
    driver::NormalContact& normal = handles_.at(settings.method);
    ProcessorStopwatch watch;
    return solve(normal, distance_, watch);
  }

  Quality judge(const std::string& method) override {
    if (reference_.empty()) {
      driver::NormalContact normal;
      prepare(normal, grid_, {"default", reference_tolerance(grid_)});
      normal.set("precision", "double");
      ProcessorStopwatch watch;
      solve(normal, distance_, watch);
      reference_ = normal.field("pressure");
    }
    const driver::NormalContact& normal = handles_.at(method);
    return {normal.number("fill"), normal.number("iterations"),
            largest_error(normal.field("pressure"), reference_)};
  }

  std::optional<double> error_pmax(const std::string& method) override {
    if (!true_pmax_) {
      true_pmax_ = gap_.pmax ? gap_.pmax : finer_pmax();
    }
    if (!true_pmax_) {
      return {};
    }
    return std::abs(handles_.at(method).number("pmax") / *true_pmax_ - 1.0);
  }

  [[nodiscard]] int wheels() const override { return 0; }

private:
  void sample(const GridSize& grid, std::vector<double>& distance) const {
    const double lateral_step = gap_.lateral_side / static_cast<double>(grid.lateral);
    const double longitudinal_step =
        gap_.longitudinal_side / static_cast<double>(grid.longitudinal);
    const auto centre = [](std::int64_t index, std::int64_t count, double step) {
      return (static_cast<double>(index) - 0.5 * static_cast<double>(count - 1)) * step;
    };
    distance.clear();
    distance.reserve(static_cast<std::size_t>(grid.count()));
    for (std::int64_t i = 0; i < grid.lateral; ++i) {
      const double y = gap_.lateral_centre + centre(i, grid.lateral, lateral_step);
      for (std::int64_t j = 0; j < grid.longitudinal; ++j) {
        distance.push_back(gap_.distance(gap_, centre(j, grid.longitudinal, longitudinal_step), y));
      }
    }
  }

  void prepare(driver::NormalContact& normal, const GridSize& grid,
               const Settings& settings) const {
    normal.set_grid(grid.lateral, grid.longitudinal,
                    gap_.lateral_side / static_cast<double>(grid.lateral),
                    gap_.longitudinal_side / static_cast<double>(grid.longitudinal));
    normal.set("solver", settings.method);
    normal.set("elements", "constant"); // so that all methods solve the same problem
    normal.set("combined_modulus", combined_modulus);
    normal.set("normal_load", hertz_load);
    normal.set("tolerance", settings.tolerance);
  }

  /// Everything before the solution, from the start of the watch, is set-up.
  static Times solve(driver::NormalContact& normal, const std::vector<double>& distance,
                     ProcessorStopwatch& watch) {
    normal.set_distance(distance);
    Times times;
    times.setup = watch.lap();
    const bool converged = normal.solve();
    times.mechanics = watch.lap();
    times.total = times.setup + times.mechanics;
    if (!converged) {
      std::cerr << "wrc_benchmark: a solution has not converged\n";
    }
    return times;
  }

  [[nodiscard]] std::optional<double> finer_pmax() const {
    constexpr std::int64_t most_elements = std::int64_t{1} << 22;
    const std::int64_t factor = 9 * grid_.count() <= most_elements ? 3 : 2;
    const GridSize fine{factor * grid_.lateral, factor * grid_.longitudinal};
    if (fine.count() > 2 * most_elements) {
      return {};
    }
    driver::NormalContact normal;
    prepare(normal, fine, {"default", 1e-6});
    std::vector<double> distance;
    sample(fine, distance);
    ProcessorStopwatch watch;
    solve(normal, distance, watch);
    return normal.number("pmax");
  }

  Gap gap_;
  GridSize grid_;
  std::vector<double> distance_;
  std::map<std::string, driver::NormalContact> handles_;
  std::vector<double> reference_;
  std::optional<double> true_pmax_;
};

} // namespace

const std::vector<CaseDescription>& normal_cases() {
  static const std::vector<CaseDescription> all{
      {"hertz-circle", "given gap: Hertz's circle, in closed form"},
      {"hertz-ellipse", "given gap: Hertz's ellipse of 8:1, along the rail"},
      {"two-lobes", "given gap: two unequal contacts side by side"}};
  return all;
}

std::unique_ptr<Problem> make_normal_problem(const std::string& case_name, const GridSize& grid) {
  return std::make_unique<NormalCase>(case_name, grid);
}

double reference_tolerance(const GridSize& grid) {
  constexpr std::int64_t large = 1024 * 512;
  return grid.count() > large ? 1e-8 : 1e-10;
}

double largest_error(const std::vector<double>& pressure, const std::vector<double>& reference) {
  double error = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    error = std::max(error, std::abs(pressure[i] - reference[i]));
    largest = std::max(largest, reference[i]);
  }
  return error / largest;
}

namespace {

/// pmax is compared with a grid this much finer in both directions.
constexpr std::int64_t refinement = 3;
constexpr double finer_tolerance = 1e-6;

class SceneCase : public Problem {
public:
  SceneCase(std::string case_name, const GridSize& grid, int wheels)
      : case_name_(std::move(case_name)), grid_(grid), wheels_(wheels) {}

  Times solve_cold(const Settings& settings) override {
    handles_.erase(settings.method);
    ProcessorStopwatch watch;
    Handles& handles = handles_[settings.method];
    prepare(handles.scene, grid_, settings);
    return solve(handles, watch);
  }

  Times solve_warm(const Settings& settings) override {
    ProcessorStopwatch watch;
    return solve(handles_.at(settings.method), watch);
  }

  Quality judge(const std::string& method) override {
    const driver::Scene& scene = handles_.at(method).scene;
    Quality quality;
    for (const std::string& side : driver::sides_of(scene)) {
      quality.fill = std::max(quality.fill, scene.number(side + ".fill"));
      quality.iterations = std::max(quality.iterations, scene.number(side + ".iterations"));
      quality.error_p = std::max(quality.error_p, error_p(scene, side, method));
    }
    return quality;
  }

  /// None of the paper's method, whose gaps are vertical: another problem.
  std::optional<double> error_pmax(const std::string& method) override {
    if (method == "paper") {
      return std::nullopt;
    }
    const driver::Scene& scene = handles_.at(method).scene;
    if (finer_pmax_.empty()) {
      driver::Scene finer;
      prepare(finer, {refinement * grid_.lateral, refinement * grid_.longitudinal},
              {"default", finer_tolerance});
      finer.solve();
      for (const std::string& side : driver::sides_of(finer)) {
        finer_pmax_[side] = finer.number(side + ".pmax");
      }
    }
    double error = 0.0;
    for (const auto& [side, pmax] : finer_pmax_) {
      error = std::max(error, std::abs(scene.number(side + ".pmax") / pmax - 1.0));
    }
    return error;
  }

  [[nodiscard]] int wheels() const override { return wheels_; }

private:
  struct Handles {
    driver::Scene scene;
    driver::Solver solver;
  };

  void prepare(driver::Scene& scene, const GridSize& grid, const Settings& settings) const {
    if (case_name_ == "manchester-5") {
      scene.set("track.rail", "UIC60-Manchester");
      scene.set("pose.lateral", 5.0);
      scene.set("pose.roll", 0.0);
    }
    scene.set("solve.side", wheels_ == 1 ? "left" : "both");
    scene.set("solve.grid", std::vector<double>{static_cast<double>(grid.lateral),
                                                static_cast<double>(grid.longitudinal)});
    scene.set("solve.method", settings.method == "paper" ? "paper" : "auto");
    scene.set("solve.tolerance", settings.tolerance);
  }

  /// Whatever takes time beside the three stages is set-up, from the start of the watch.
  static Times solve(Handles& handles, ProcessorStopwatch& watch) {
    const driver::Scene& scene = handles.scene;
    const bool converged = handles.solver.solve(handles.scene);
    const Times times = Times::of(scene, watch.lap());
    if (!converged) {
      std::cerr << "wrc_benchmark: a solution has not converged\n";
    }
    return times;
  }

  /// Against the very distances of this solution, solved by themselves.
  [[nodiscard]] double error_p(const driver::Scene& scene, const std::string& side,
                               const std::string& method) const {
    driver::NormalContact reference;
    reference.set_grid(grid_.lateral, grid_.longitudinal,
                       scene.number(side + ".element_size.lateral"),
                       scene.number(side + ".element_size.longitudinal"));
    // The half-space has the distances times the scales of rows, and the pressures over them.
    const std::vector<double> scale = scene.field(side + ".row_scale");
    std::vector<double> distance = scene.field(side + ".undeformed_distance");
    std::vector<double> pressure = scene.field(side + ".pressure");
    double load = 0.0;
    for (std::size_t i = 0; i < scale.size(); ++i) {
      distance[i] *= scale[i];
      pressure[i] /= scale[i];
      load += pressure[i] * scene.number(side + ".element_size.lateral") *
              scene.number(side + ".element_size.longitudinal");
    }
    reference.set_distance(distance);
    reference.set("normal_load", load);
    reference.set("tolerance", reference_tolerance(grid_));
    reference.set("precision", "double");
    reference.set("elements", method == "paper" ? "constant" : "smooth");
    reference.solve();
    return largest_error(pressure, reference.field("pressure"));
  }

  std::string case_name_;
  GridSize grid_;
  int wheels_;
  std::map<std::string, Handles> handles_;
  std::map<std::string, double> finer_pmax_;
};

} // namespace

const std::vector<CaseDescription>& scene_cases() {
  static const std::vector<CaseDescription> all{
      {"table1", "scene: S1002 on 60E1, centred, 80 kN; one wheel, then both"},
      {"manchester-5", "scene: S1002 on the Manchester UIC60, y = 5 mm without roll, left wheel"}};
  return all;
}

std::unique_ptr<Problem> make_scene_problem(const std::string& case_name, const GridSize& grid,
                                            int wheels) {
  return std::make_unique<SceneCase>(case_name, grid, wheels);
}

} // namespace benchmark
