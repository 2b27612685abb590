/// Random problems of steady rolling, on ellipses and other patches, for the comparison of models.
///
/// A patch is a function of position, so that it can be put on any grid: the pressures are taken at
/// the centres of elements and scaled to the load.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "rolling/creep_laws.hpp"
#include "rolling/rolling_contact.hpp"

namespace wrc::evidence {

class CaseDraw {
public:
  explicit CaseDraw(std::uint64_t seed) : generator_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }

private:
  std::mt19937_64 generator_;
};

enum class PatchShape { ellipse, lobes_across, lobes_along, banana };

/// Half the sides of the rectangle that holds the contact are `a` and `b`.
struct Patch {
  PatchShape shape = PatchShape::ellipse;
  double a = 5.0;
  double b = 5.0;
  double bend = 0.6;   ///< of a banana
  double second = 1.0; ///< height of the second lobe over that of the first

  /// Square of the pressure over its largest value, with x and y in `a` and `b`; not positive
  /// outside the contact.
  [[nodiscard]] double square(double x, double y) const {
    const auto lobe = [](double along, double across) {
      return 1.0 - (along * along + across * across) / (0.45 * 0.45);
    };
    switch (shape) {
    case PatchShape::lobes_across:
      return y < 0.0 ? lobe(0.45 * x, y + 0.55) : second * lobe(0.45 * x / second, y - 0.55);
    case PatchShape::lobes_along:
      return x < 0.0 ? lobe(x + 0.55, 0.45 * y) : second * lobe(x - 0.55, 0.45 * y / second);
    case PatchShape::banana: {
      const double bent = (x + bend * (0.5 - y * y)) / (1.0 - 0.5 * bend);
      return 1.0 - bent * bent - y * y;
    }
    case PatchShape::ellipse:
      break;
    }
    return 1.0 - x * x - y * y;
  }
};

struct CreepCase {
  Patch patch;
  double load = 80000.0;
  double friction = 0.3;
  double shear_modulus = 82000.0;
  double poisson = 0.28;
  Creepages creepages;
};

/// A problem on a grid, with the pressures it refers to.
struct GriddedCase {
  RollingProblem problem;
  std::vector<double> pressure;
  GriddedCase(const CreepCase& from, std::size_t along, std::size_t across, double tolerance) {
    const auto columns = static_cast<double>(along);
    const auto rows = static_cast<double>(across);
    const Patch& patch = from.patch;
    problem.grid = {across,
                    along,
                    2.0 * patch.b / rows,
                    2.0 * patch.a / columns,
                    -patch.b + patch.b / rows,
                    -patch.a + patch.a / columns};
    pressure.resize(along * across);
    double sum = 0.0;
    for (std::size_t j = 0; j < across; ++j) {
      for (std::size_t i = 0; i < along; ++i) {
        const double square =
            patch.square(problem.grid.longitudinal(i) / patch.a, problem.grid.lateral(j) / patch.b);
        pressure[j * along + i] = square > 0.0 ? std::sqrt(square) : 0.0;
        sum += pressure[j * along + i] * problem.grid.element_area();
      }
    }
    for (double& p : pressure) {
      p *= from.load / sum;
    }
    problem.pressure = pressure;
    problem.friction = from.friction;
    problem.shear_modulus = from.shear_modulus;
    problem.poisson = from.poisson;
    problem.creepages = from.creepages;
    problem.tolerance = tolerance;
  }
  GriddedCase(const GriddedCase&) = delete;
  GriddedCase& operator=(const GriddedCase&) = delete;
  ~GriddedCase() = default;
};

/// The ellipse of the same area and the same ratio of the areas' second moments.
inline RollingEllipse equivalent_ellipse(const CreepCase& from) {
  const GriddedCase fine(from, 128, 128, 1e-3);
  const Grid& grid = fine.problem.grid;
  double count = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double yy = 0.0;
  for (std::size_t element = 0; element < fine.pressure.size(); ++element) {
    if (fine.pressure[element] > 0.0) {
      const double along = grid.longitudinal(element % grid.longitudinal_count);
      const double across = grid.lateral(element / grid.longitudinal_count);
      count += 1.0;
      x += along;
      y += across;
      xx += along * along;
      yy += across * across;
    }
  }
  const double ratio = std::sqrt((xx - x * x / count) / (yy - y * y / count));
  const double square = count * grid.element_area() / 3.14159265358979323846;
  return {std::sqrt(square * ratio),
          std::sqrt(square / ratio),
          from.load,
          from.friction,
          from.shear_modulus,
          from.poisson};
}

/// Sides, and creepages of which the linear forces are 0.1 to 10 mu N in a random direction of
/// longitudinal creepage, lateral creepage and spin.
inline CreepCase draw_case(PatchShape shape, CaseDraw& draw) {
  CreepCase drawn;
  const double ratio = std::sqrt(draw.log_uniform(0.2, 5.0));
  drawn.patch = {shape, 6.0 * ratio, 6.0 / ratio, draw.uniform(0.3, 1.0), draw.uniform(0.5, 1.0)};
  const RollingEllipse ellipse = equivalent_ellipse(drawn);
  const KalkerCoefficients kalker = kalker_coefficients(ellipse);
  double direction[3];
  double length = 0.0;
  do {
    length = 0.0;
    for (double& component : direction) {
      component = draw.uniform(-1.0, 1.0);
      length += component * component;
    }
  } while (length > 1.0 || length < 0.01);
  const double square = ellipse.longitudinal_semi_axis * ellipse.lateral_semi_axis;
  const double size = draw.log_uniform(0.1, 10.0) / std::sqrt(length) * drawn.friction *
                      drawn.load / (drawn.shear_modulus * square);
  drawn.creepages = {size * direction[0] / kalker.c11, size * direction[1] / kalker.c22,
                     size * direction[2] / (kalker.c23 * std::sqrt(square))};
  return drawn;
}

} // namespace wrc::evidence
