/// A disc in a hole of nearly its radius, in closed form.
///
/// Plane strain, like materials, no friction, a force P per length on the disc, whose other end is
/// far away; clearance dR << R. With e the half angle of contact, b = tan(e/2) and y = tan(phi/2)
/// (A. Persson, On the Stress Distribution of Cylindrical Elastic Bodies in Contact, 1964;
/// M. Ciavarella & P. Decuzzi, International Journal of Solids and Structures 38, 2001, 4507-4523):
///   E* dR / P = (2 - ln(1 + b^2) - 2 b^4) / (2 pi b^2 (1 + b^2)),
///   p R / P = 2/pi r / (s (1 + y^2)) + ln((s + r)/(s - r)) / (2 pi b^2 (1 + b^2)),
///   r = sqrt(b^2 - y^2),  s = sqrt(1 + b^2).
/// E* is that of both bodies. Small e gives Hertz's contact: p_max = 2 P / (pi e R).
/// What this solves (conformal_disc_test.cpp): disc and hole together yield by
///   u(phi) = 2/(pi E*) R int p(t) (-cos(phi - t) ln(2 sin|phi - t|/2) - 1/4) dt + c cos(phi),
/// the sum over n >= 2 of the waves p_n cos(n phi), 2/E* n/(n^2 - 1) R p_n, and R p_0 / E*.
/// Without units: R = P = 1, pressures over P/R, clearances over P/E*; angles in rad from the
/// middle.
///
/// And the same contact by the solver: one column of elements that are long along the disc, across
/// it equal rows of its arc or of the plane of first touch. The approach of a line contact has no
/// limit as elements get longer, so the load is prescribed.
/// Thread rule: pure functions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "mechanics/normal_solver.hpp"
#include "support/contact_cases.hpp"

namespace wrc::test {

struct DiscAnswer {
  double largest_pressure = 0.0; ///< over P/R
  double half_angle = 0.0;       ///< rad
};

class ConformalDisc {
public:
  /// 0 < half angle < 1.48 rad, where no clearance is left.
  explicit ConformalDisc(double half_angle) : b_(std::tan(0.5 * half_angle)) {}

  [[nodiscard]] double clearance() const {
    const double squared = b_ * b_;
    return (2.0 - std::log1p(squared) - 2.0 * squared * squared) /
           (2.0 * std::numbers::pi * squared * (1.0 + squared));
  }
  [[nodiscard]] double pressure(double angle) const {
    const double y = std::tan(0.5 * angle);
    const double r = std::sqrt(std::max(b_ * b_ - y * y, 0.0));
    const double s = std::sqrt(1.0 + b_ * b_);
    return 2.0 / std::numbers::pi * r / (s * (1.0 + y * y)) +
           std::log((s + r) / (s - r)) / (2.0 * std::numbers::pi * b_ * b_ * s * s);
  }
  /// Of a parabola on a half-space with the same clearance.
  [[nodiscard]] DiscAnswer by_hertz() const {
    const double half_angle = std::sqrt(4.0 / (std::numbers::pi * clearance()));
    return {2.0 / (std::numbers::pi * half_angle), half_angle};
  }

private:
  double b_;
};

/// What the rows lie on.
enum class DiscRows {
  curve, ///< the arc; angles between their normals count
  plane  ///< of first touch
};

/// For the clearance at which the closed form has this half angle, with about so many rows in
/// contact; the answer's half angle is right to half a row.
inline DiscAnswer solve_disc(DiscRows kind, double half_angle, std::size_t rows) {
  constexpr double radius = 10.0;         // mm
  constexpr double clearance = 1e-3;      // mm
  constexpr double length = 1e3 * radius; // mm; ends count by the square of width over length
  constexpr double room = 1.3;            // of the expected width
  constexpr double most_of_plane = 0.98;  // of the radius: bodies end there
  const double line_load = steel_modulus * clearance / ConformalDisc(half_angle).clearance();
  const bool curved = kind == DiscRows::curve;
  const double half_width = radius * std::min(room * half_angle, curved ? 10.0 : most_of_plane);
  const double step = 2.0 * radius * half_angle / static_cast<double>(rows);
  const std::size_t count = 2 * static_cast<std::size_t>(half_width / step) + 1;
  const Grid grid{count, 1, step, length, -0.5 * step * static_cast<double>(count - 1), 0.0};
  const auto angle_at = [&](double across) {
    return curved ? across / radius : std::asin(across / radius);
  };
  std::vector<double> angles, distance, shares;
  for (std::size_t row = 0; row < count; ++row) {
    angles.push_back(angle_at(grid.lateral(row)));
    const double cosine = std::cos(angles.back());
    // Along the normals of the arc, or of the plane.
    distance.push_back(clearance * (curved ? 1.0 - cosine : 1.0 / cosine - 1.0));
    shares.push_back(curved ? cosine : 1.0);
  }
  PatchGap patch{grid, distance};
  patch.shares = shares;
  if (curved) {
    patch.angles = angles;
  }
  NormalProblem problem;
  problem.patches = {&patch, 1};
  problem.combined_modulus = steel_modulus;
  problem.load = line_load * length;
  problem.tolerance = 1e-6;
  const NormalSolution found = NormalSolver().solve(problem);
  DiscAnswer answer;
  for (std::size_t row = 0; row < count; ++row) {
    const double pressure = found.patches[0].pressure[row] * radius / line_load;
    answer.largest_pressure = std::max(answer.largest_pressure, pressure);
    if (pressure > 0.0) {
      answer.half_angle = angle_at(grid.lateral(row) + 0.5 * step);
    }
  }
  return answer;
}

} // namespace wrc::test
