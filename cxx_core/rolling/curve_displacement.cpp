#include "rolling/curve_displacement.hpp"

#include <algorithm>
#include <cmath>

#include "half_space/traction_convolution.hpp"
#include "mechanics/cascade.hpp"
#include "rolling/scaled_tractions.hpp"

namespace wrc {
namespace {

/// Sums over the elements of a problem's grid, lengths in longitudinal steps.
class CurveSums {
public:
  CurveSums(const RollingProblem& problem, std::span<const double> inclinations,
            const DifferenceWeights& weights, LinePlans& plans)
      : problem_(problem), inclinations_(inclinations), weights_(weights),
        plans_(plans), shape_{problem.grid.longitudinal_count, problem.grid.lateral_count},
        table_(traction_table(problem.grid.lateral_step / problem.grid.longitudinal_step,
                              shape_.table_rows(), shape_.table_columns())) {}

  /// sum_j sin(a_i - a_j) m f_j
  std::vector<double> across(std::span<const double> field) {
    return turned(field, TractionPart::turned, 1.0);
  }
  /// sum_j sin((a_i - a_j)/2) A_xs f_j
  std::vector<double> along(std::span<const double> field) {
    return turned(field, TractionPart::mixed, 0.5);
  }

private:
  /// sum_j sin(k (a_i - a_j)) K f_j, as sin a (K cos a) f - cos a (K sin a) f.
  std::vector<double> turned(std::span<const double> field, TractionPart part, double k) {
    const std::size_t count = field.size();
    std::vector<double> cosines;
    std::vector<double> sines;
    cosines.reserve(inclinations_.size());
    sines.reserve(inclinations_.size());
    for (const double inclination : inclinations_) {
      cosines.push_back(std::cos(k * inclination));
      sines.push_back(std::sin(k * inclination));
    }
    std::vector<double> by_cosine(count);
    std::vector<double> by_sine(count);
    for (std::size_t at = 0; at < count; ++at) {
      by_cosine[downstream(at)] = cosines[at / shape_.rows] * field[at];
      by_sine[downstream(at)] = sines[at / shape_.rows] * field[at];
    }
    const TractionConvolution<double> kernel(shape_, shape_.columns, problem_.poisson, weights_,
                                             table_, plans_, part);
    // The mixed part exchanges both components.
    const bool exchanged = part == TractionPart::mixed;
    std::vector<double>& first = exchanged ? by_sine : by_cosine;
    std::vector<double>& second = exchanged ? by_cosine : by_sine;
    kernel.apply(by_cosine.data(), by_sine.data(), first.data(), second.data(), workspace_);
    std::vector<double> sums(count);
    for (std::size_t at = 0; at < count; ++at) {
      const std::size_t row = at / shape_.rows;
      sums[at] = sines[row] * by_cosine[downstream(at)] - cosines[row] * by_sine[downstream(at)];
    }
    return sums;
  }
  /// In rows of constant x from the leading edge.
  [[nodiscard]] std::size_t downstream(std::size_t at) const {
    return (shape_.rows - 1 - at % shape_.rows) * shape_.columns + at / shape_.rows;
  }

  const RollingProblem& problem_;
  std::span<const double> inclinations_;
  DifferenceWeights weights_;
  LinePlans& plans_;
  TractionShape shape_;
  TractionTable table_;
  ConvolutionWorkspace<double> workspace_;
};

} // namespace

SlipByPressures slip_by_pressures(const RollingProblem& problem,
                                  std::span<const double> inclinations, LinePlans& plans) {
  const auto is_level = [](double angle) { return angle == 0.0; };
  if (problem.motion != TangentialMotion::rolling || std::ranges::all_of(inclinations, is_level)) {
    return {};
  }
  RollingProblem steady = problem;
  steady.step_length = 0.0;
  CurveSums sums(problem, inclinations, difference_of(steady).weights, plans);
  SlipByPressures slip{sums.along(problem.pressure), sums.across(problem.pressure)};
  const double unit = 1.0 / problem.shear_modulus;
  for (std::size_t at = 0; at < slip.x.size(); ++at) {
    slip.x[at] *= unit;
    slip.y[at] *= unit;
  }
  return slip;
}

SlipByPressures smooth_slip_by_pressures(const RollingProblem& problem,
                                         std::span<const double> inclinations, LinePlans& plans) {
  const Grid& fine = problem.grid;
  std::vector<double> pressure;
  std::vector<double> angles;
  coarsen_pressure({fine.lateral_count, fine.longitudinal_count}, problem.pressure, pressure);
  coarsen_angles(inclinations, angles);
  RollingProblem coarse = problem;
  coarse.grid = {(fine.lateral_count + 1) / 2,
                 (fine.longitudinal_count + 1) / 2,
                 2.0 * fine.lateral_step,
                 2.0 * fine.longitudinal_step,
                 fine.lateral_first + 0.5 * fine.lateral_step,
                 fine.longitudinal_first + 0.5 * fine.longitudinal_step};
  coarse.pressure = pressure;
  SlipByPressures slip = slip_by_pressures(coarse, angles, plans);
  if (!slip.x.empty()) {
    for (std::vector<double>* component : {&slip.x, &slip.y}) {
      std::vector<double> values = std::move(*component);
      interpolate(coarse.grid, values, fine, *component);
    }
  }
  return slip;
}

} // namespace wrc
