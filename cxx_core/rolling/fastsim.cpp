#include "rolling/fastsim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "rolling/fastsim_loops.hpp"
#include "rolling/scaled_tractions.hpp"

namespace wrc {

namespace {

/// Strips of an ellipse at most; not a tuning constant: the permitted range.
constexpr std::size_t max_strips = 256;

void check_flexibilities(const Flexibilities& flexibilities) {
  for (const auto& [name, value] :
       {std::pair{"longitudinal_flexibility", flexibilities.longitudinal},
        std::pair{"lateral_flexibility", flexibilities.lateral},
        std::pair{"spin_flexibility", flexibilities.spin}}) {
    if (!(value > 0.0)) {
      throw_invalid_argument(name, value, "must be greater than 0");
    }
  }
  if (!std::isfinite(flexibilities.spin_lead)) {
    throw_invalid_argument("spin_lead", flexibilities.spin_lead, "must be finite");
  }
}

void check_fastsim_grid(const FastsimGrid& grid) {
  if (grid.strips < 1 || grid.strips > max_strips) {
    throw_invalid_argument("strips", static_cast<double>(grid.strips),
                           "must be between 1 and " + std::to_string(max_strips));
  }
  if (grid.slices < 1) {
    throw_invalid_argument("slices", static_cast<double>(grid.slices), "must be at least 1");
  }
}

/// Fields of a march over the problem's grid, in rows of constant x from the leading edge.
class StripFields {
public:
  StripFields(const RollingProblem& problem, const Flexibilities& flexibilities)
      : grid_(problem.grid), rows_(grid_.longitudinal_count), pitch_(grid_.lateral_count),
        count_(rows_ * pitch_), values_(7 * count_ + 3 * pitch_) {
    for (std::size_t strip = 0; strip < pitch_; ++strip) {
      fill_strip(problem, flexibilities, strip);
    }
    turning_ = grid_.longitudinal_step * problem.creepages.spin / flexibilities.spin;
  }

  void march() {
    double* const fields = values_.data();
    double* const change_x = fields + 6 * count_;
    double* const state = fields + 7 * count_;
    march_elements(
        {rows_, pitch_, fields, change_x, fields + count_, -grid_.longitudinal_step * turning_},
        fields + 2 * count_, fields + 3 * count_, fields + 4 * count_, fields + 5 * count_, state);
  }

  /// Tractions, and slips from what was cut of them.
  void read_back(const Flexibilities& flexibilities, RollingSolution& solution) const {
    const auto slip_of = [&](double cut, double flexibility) {
      return cut == 0.0 ? 0.0 : -cut * flexibility / grid_.longitudinal_step;
    };
    for (std::size_t strip = 0; strip < pitch_; ++strip) {
      for (std::size_t row = 0; row < rows_; ++row) {
        const double* const from = values_.data() + row * pitch_ + strip;
        const std::size_t to = strip * rows_ + (rows_ - 1 - row);
        solution.traction_x[to] = from[2 * count_];
        solution.traction_y[to] = from[3 * count_];
        solution.slip_x[to] = slip_of(from[4 * count_], flexibilities.longitudinal);
        solution.slip_y[to] = slip_of(from[5 * count_], flexibilities.lateral);
      }
    }
  }

private:
  /// Bounds, and what a step changes in adhesion, about the middle of each stretch in contact.
  void fill_strip(const RollingProblem& problem, const Flexibilities& flexibilities,
                  std::size_t strip) {
    const double* const pressure = problem.pressure.data() + strip * rows_;
    const double step = grid_.longitudinal_step;
    const Creepages& w = problem.creepages;
    const double along = step * (w.longitudinal - w.spin * grid_.lateral(strip));
    for (std::size_t end = rows_; end > 0; --end) {
      std::size_t first = end;
      while (first > 0 && pressure[first - 1] > 0.0) {
        --first;
      }
      if (first == end) {
        continue;
      }
      const double middle = 0.5 * (grid_.longitudinal(first) + grid_.longitudinal(end - 1));
      const double creepage = w.lateral + w.spin * (middle + flexibilities.spin_lead);
      for (std::size_t i = first; i < end; ++i) {
        const std::size_t at = (rows_ - 1 - i) * pitch_ + strip;
        values_[at] = problem.friction * pressure[i];
        values_[count_ + at] =
            step * (creepage / flexibilities.lateral +
                    w.spin * (grid_.longitudinal(i) - middle) / flexibilities.spin);
        values_[6 * count_ + at] = along / flexibilities.longitudinal;
        if (!problem.slip_x.empty()) {
          const std::size_t from = strip * rows_ + i;
          values_[count_ + at] += step * problem.slip_y[from] / flexibilities.lateral;
          values_[6 * count_ + at] += step * problem.slip_x[from] / flexibilities.longitudinal;
        }
      }
      end = first + 1;
    }
  }

  Grid grid_;
  std::size_t rows_;
  std::size_t pitch_;
  std::size_t count_;
  /// Bound, change of y, tractions and cuts in x and y, change of x; then the march's state.
  std::vector<double> values_;
  double turning_ = 0.0; ///< change of the change of y over a step, over the step
};

} // namespace

Flexibilities flexibilities_of(const RollingEllipse& ellipse,
                               const KalkerCoefficients& coefficients) {
  const double a = ellipse.longitudinal_semi_axis;
  const double length = a / ellipse.shear_modulus;
  return {8.0 / 3.0 * length / coefficients.c11, 8.0 / 3.0 * length / coefficients.c22,
          std::numbers::pi / 4.0 * length * std::sqrt(a / ellipse.lateral_semi_axis) /
              coefficients.c23};
}

FastsimForces fastsim_forces(const RollingEllipse& ellipse, const Flexibilities& flexibilities,
                             const Creepages& creepages, const FastsimGrid& grid) {
  FastsimForces result;
  const double a = ellipse.longitudinal_semi_axis;
  const double b = ellipse.lateral_semi_axis;
  const auto strips = static_cast<double>(grid.strips);
  const auto slices = static_cast<double>(grid.slices);
  check_fastsim_grid(grid);
  if (!(ellipse.friction * ellipse.load > 0.0)) {
    return result;
  }
  std::array<double, max_strips> places;
  std::array<double, max_strips> halves; // of the strips' lengths
  double lengths = 0.0;
  double cubes = 0.0;
  for (std::size_t strip = 0; strip < grid.strips; ++strip) {
    const double place = (2.0 * static_cast<double>(strip) + 1.0) / strips - 1.0;
    const double square = 1.0 - place * place;
    places[strip] = place;
    halves[strip] = std::sqrt(square);
    lengths += halves[strip];
    cubes += square * halves[strip];
  }
  const double area = 4.0 * a * b / (strips * slices);
  // mu times the largest pressure, such that the slices together carry the load: the sum of
  // 1 - u^2 over the middles of n slices is 2n/3 + 1/(3n).
  const double bound = ellipse.friction * ellipse.load /
                       (area * cubes * (2.0 * slices / 3.0 + 1.0 / (3.0 * slices)));
  const double turning = creepages.spin / flexibilities.spin;
  const double step = 2.0 * a / (slices * bound);
  double slipping = 0.0;
  CreepForces& forces = result.forces;
  for (std::size_t first = 0; first < grid.strips; first += strip_group) {
    EllipseStrips group{};
    double place[strip_group] = {};
    for (std::size_t j = 0; j < std::min(strip_group, grid.strips - first); ++j) {
      const double half = halves[first + j];
      const double across = b * places[first + j];
      place[j] = places[first + j];
      group.half_length[j] = half;
      group.change_x[j] =
          step * half * (creepages.longitudinal / flexibilities.longitudinal - turning * across);
      group.change_y[j] = step * half * creepages.lateral / flexibilities.lateral;
      group.change_y_by_spin[j] = step * half * half * a * turning;
    }
    const StripSums sums = march_ellipse(group, place, grid.slices);
    forces.longitudinal += sums.x;
    forces.lateral += sums.y;
    forces.spin_moment += a * sums.moment - b * sums.moment_x;
    slipping += sums.slipping;
  }
  forces.longitudinal *= area * bound;
  forces.lateral *= area * bound;
  forces.spin_moment *= area * bound;
  result.slip_area = area * slipping;
  result.adhesion_area = area * (slices * lengths - slipping);
  result.friction_power =
      -(forces.longitudinal * creepages.longitudinal + forces.lateral * creepages.lateral +
        forces.spin_moment * creepages.spin);
  return result;
}

RollingSolution solve_with_fastsim(const RollingProblem& problem,
                                   const Flexibilities& flexibilities) {
  check_problem(problem);
  check_flexibilities(flexibilities);
  if (problem.motion != TangentialMotion::rolling) {
    throw_invalid_argument("motion", static_cast<double>(problem.motion),
                           "must be steady rolling for FASTSIM");
  }
  if (problem.step_length != 0.0) {
    throw_invalid_argument("step_length", problem.step_length, "must be 0 for FASTSIM");
  }
  if (problem.difference_parameter != 0.0) {
    throw_invalid_argument("difference_parameter", problem.difference_parameter,
                           "must be 0 for FASTSIM");
  }
  StripFields fields(problem, flexibilities);
  fields.march();
  const std::size_t count = problem.grid.element_count();
  RollingSolution solution;
  solution.traction_x.resize(count);
  solution.traction_y.resize(count);
  solution.slip_x.resize(count);
  solution.slip_y.resize(count);
  fields.read_back(flexibilities, solution);
  sum_up(problem, 0.0, solution);
  return solution;
}

} // namespace wrc
