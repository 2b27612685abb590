#include "creep/patch_coefficients.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "records/wheel_result.hpp"
#include "rolling/constants.hpp"
#include "rolling/kalker_coefficients.hpp"

namespace wrc {
namespace {

/// Of elements in contact (above 0), about the origin of their grid; `area`: a b.
KalkerCoefficients coefficients_of(const Grid& grid, std::vector<double> contact, double area,
                                   double poisson, RollingSolver& solver) {
  RollingProblem problem;
  problem.grid = grid;
  problem.pressure = std::move(contact);
  problem.friction = no_slip_friction;
  problem.shear_modulus = 1.0;
  problem.poisson = poisson;
  problem.tolerance = flexibility_tolerance;
  const double size = std::sqrt(area);
  problem.creepages = {1.0, 0.0, 0.0};
  const double along = solver.solve(problem).longitudinal_force;
  problem.creepages = {0.0, 1.0, 0.0};
  const RollingSolution across = solver.solve(problem);
  problem.creepages = {0.0, 0.0, 1.0 / size};
  const RollingSolution spin = solver.solve(problem);
  return {-along / area, -across.lateral_force / area,
          0.5 * (across.spin_moment / size - spin.lateral_force) / area,
          -spin.spin_moment / (size * area)};
}

std::optional<KalkerCoefficients> coefficients_of(const PatchResult& patch, double poisson,
                                                  RollingSolver& solver) {
  const double a = patch.semi_axis_longitudinal;
  const double b = patch.semi_axis_lateral;
  if (!(patch.normal_force > 0.0 && a > 0.0 && b > 0.0) || patch.pressure.empty()) {
    return std::nullopt;
  }
  Grid grid = patch.grid;
  grid.longitudinal_first -= patch.contact.centroid_longitudinal;
  grid.lateral_first -= patch.contact.centroid_lateral;
  std::vector<double> contact;
  std::vector<double> in_ellipse;
  bool some = false;
  for (std::size_t i = 0; i < grid.element_count(); ++i) {
    const double x = grid.longitudinal(i % grid.longitudinal_count) / a;
    const double y = grid.lateral(i / grid.longitudinal_count) / b;
    contact.push_back(patch.pressure[i] > 0.0 ? 1.0 : 0.0);
    in_ellipse.push_back(x * x + y * y < 1.0 ? 1.0 : 0.0);
    some = some || in_ellipse.back() > 0.0;
  }
  if (!some) {
    return std::nullopt;
  }
  const KalkerCoefficients found =
      coefficients_of(grid, std::move(contact), a * b, poisson, solver);
  const KalkerCoefficients ellipse =
      coefficients_of(grid, std::move(in_ellipse), a * b, poisson, solver);
  const KalkerCoefficients exact = kalker_coefficients(a / b, poisson);
  return KalkerCoefficients{
      exact.c11 * found.c11 / ellipse.c11, exact.c22 * found.c22 / ellipse.c22,
      exact.c23 * found.c23 / ellipse.c23, exact.c33 * found.c33 / ellipse.c33};
}

} // namespace

void find_patch_coefficients(WheelResult& wheel, double poisson, RollingSolver& solver) {
  for (PatchResult& patch : wheel.patches) {
    if (patch.parts.empty()) {
      patch.kalker = coefficients_of(patch, poisson, solver);
    }
    for (PatchResult& part : patch.parts) {
      part.kalker = coefficients_of(part, poisson, solver);
    }
  }
}

} // namespace wrc
