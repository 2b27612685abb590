#include "table/creep_law.hpp"

#include <algorithm>
#include <numbers>

#include "rolling/rolling_contact.hpp"
#include "table/constants.hpp"

namespace wrc {
namespace {

using Forces = std::array<double, 3>;

/// An ellipse of a b = 1 under mu N = 1, G = 1.
class EllipseProblem {
public:
  EllipseProblem(double log_ratio, double poisson, std::size_t elements, RollingSolver& solver)
      : solver_(solver), pressure_(elements * elements) {
    const double a = std::exp(0.5 * log_ratio);
    const double b = 1.0 / a;
    const double step = 2.0 / static_cast<double>(elements);
    problem_.grid = {
        elements, elements, b * step, a * step, b * (0.5 * step - 1.0), a * (0.5 * step - 1.0)};
    double sum = 0.0;
    for (std::size_t row = 0; row < elements; ++row) {
      for (std::size_t i = 0; i < elements; ++i) {
        const double x = problem_.grid.longitudinal(i) / a;
        const double y = problem_.grid.lateral(row) / b;
        double& pressure = pressure_[row * elements + i];
        pressure = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
        sum += pressure * problem_.grid.element_area();
      }
    }
    for (double& pressure : pressure_) {
      pressure /= sum;
    }
    problem_.pressure = pressure_;
    problem_.friction = 1.0;
    problem_.shear_modulus = 1.0;
    problem_.poisson = poisson;
    problem_.tolerance = node_accuracy;
    problem_.derivatives = true;
    const std::array<double, 9> by = solver_.solve(problem_).by_creepage;
    problem_.derivatives = false;
    linear_ = {-by[0], -by[4], -by[5]};
  }

  /// At linear forces fx, fy, fp.
  Forces forces(const Forces& linear) {
    problem_.creepages = {linear[0] / linear_[0], linear[1] / linear_[1], linear[2] / linear_[2]};
    const RollingSolution solution = solver_.solve(problem_);
    return {solution.longitudinal_force, solution.lateral_force, solution.spin_moment};
  }
  /// As |v| goes to infinity in this direction.
  [[nodiscard]] Forces full_slip(double vx, double vy) const {
    const double x = vx / linear_[0];
    const double y = vy / linear_[1];
    const double length = std::hypot(x, y);
    return {-x / length, -y / length, 0.0};
  }

private:
  RollingSolver& solver_;
  std::vector<double> pressure_;
  RollingProblem problem_;
  Forces linear_{}; ///< of unit creepages
};

/// What forces differ by from the cubic.
Forces beyond_cubic(Forces forces, const Forces& linear) {
  const double across = linear[1] + linear[2];
  const double factor = CreepLaw::cubic_factor(linear[0], across);
  forces[0] += factor * linear[0];
  forces[1] += factor * across;
  return forces;
}

/// At a node of g and m. Beyond |g| = 2, which is no creepage, continued with the same slope.
Forces node_of(EllipseProblem& ellipse, double gx, double gy, double m) {
  constexpr double without_end = 1e9; // linear forces that slide everywhere
  const double length = std::hypot(gx, gy);
  const double inside = std::min(length, 4.0 - length);
  const double fp = std::clamp(std::tan(0.5 * std::numbers::pi * m) / law_spin_scale,
                               -largest_spin_node, largest_spin_node);
  const double root = std::sqrt(1.0 + fp * fp);
  Forces limit{};
  if (length > 0.0) {
    const double scale = without_end / length;
    limit = beyond_cubic(ellipse.full_slip(gx, gy), {scale * gx, scale * gy, fp});
  }
  const double square = 1.0 - 0.25 * inside * inside;
  Forces forces = limit;
  if (square > 1e-12) { // else it is the limit
    const double scale =
        length > 0.0 ? std::sqrt(law_slip_scale) * inside / (length * std::sqrt(square)) * root
                     : 0.0;
    const Forces linear{scale * gx, scale * gy, fp};
    forces = beyond_cubic(ellipse.forces(linear), linear);
  }
  for (std::size_t i = 0; i < forces.size() && length > 2.0; ++i) {
    forces[i] = 2.0 * limit[i] - forces[i];
  }
  return forces;
}

} // namespace

CreepLaw::Spline::Axes CreepLaw::axes_of(const CreepLawNodes& nodes) {
  return {SplineAxis(-2.0, 2.0, nodes.translation), SplineAxis(-2.0, 2.0, nodes.translation),
          SplineAxis(-1.0, 1.0, nodes.spin),
          SplineAxis(-largest_law_log_ratio, largest_law_log_ratio, nodes.ratio)};
}

CreepLaw CreepLaw::make(double poisson, const CreepLawNodes& nodes, int threads,
                        const Progress& progress) {
  const Spline::Axes axes = axes_of(nodes);
  std::vector<double> values(Spline::size_of(axes));
  const auto put = [&](std::size_t x, std::size_t y, std::size_t m, std::size_t ratio,
                       const Forces& forces) {
    const std::size_t at = ((x * axes[1].count + y) * axes[2].count + m) * axes[3].count + ratio;
    std::copy(forces.begin(), forces.end(), values.begin() + static_cast<std::ptrdiff_t>(4 * at));
  };
  // The mirror images x -> -x, and both y and the spin, are exact.
  const std::size_t middle = nodes.translation / 2;
  const std::size_t no_spin = nodes.spin / 2;
  const std::size_t spins = nodes.spin - no_spin;
  run_tasks(spins * nodes.ratio, threads, progress, [&] {
    return [&, solver = RollingSolver()](std::size_t task) mutable {
      const std::size_t ratio = task / spins;
      const std::size_t m = no_spin + task % spins;
      EllipseProblem ellipse(axes[3].node(ratio), poisson, nodes.elements, solver);
      for (std::size_t x = middle; x < axes[0].count; ++x) {
        for (std::size_t y = 0; y < axes[1].count; ++y) {
          if (m == no_spin && y < middle) {
            continue;
          }
          const Forces f = node_of(ellipse, axes[0].node(x), axes[1].node(y), axes[2].node(m));
          const std::size_t other_x = axes[0].count - 1 - x;
          const std::size_t other_y = axes[1].count - 1 - y;
          const std::size_t other_m = axes[2].count - 1 - m;
          put(x, y, m, ratio, f);
          put(other_x, y, m, ratio, {-f[0], f[1], f[2]});
          put(x, other_y, other_m, ratio, {f[0], -f[1], -f[2]});
          put(other_x, other_y, other_m, ratio, {-f[0], -f[1], -f[2]});
        }
      }
    };
  });
  return CreepLaw(Spline(axes, std::move(values)));
}

} // namespace wrc
