#include "rolling/scaled_tractions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "mechanics/cascade.hpp"
#include "rolling/constants.hpp"

namespace wrc {

double step_rate(const RollingProblem& problem) {
  return problem.rolling_share + problem.grid.longitudinal_step / problem.step_length;
}

SlipDifferenceWeights difference_of(const RollingProblem& problem, double times) {
  // origin: derived: 5/16 of the backward difference of second order and 11/16 of the
  // upstream-biased one of third order; the leading edge is then at the end of a whole first
  // element (LeadingEdge.ComesFromTheHalfPlane).
  constexpr DifferenceWeights biased{11.0 / 48.0, 39.0 / 48.0, -63.0 / 48.0, 13.0 / 48.0};
  // origin: published: CONTACT (Vollebregt), which takes spin a sixth of an element ahead.
  constexpr double first_order_place = 1.0 / 6.0;
  if (problem.motion != TangentialMotion::rolling) {
    return {{0.0, times, 0.0, 0.0}, 0.0, 0.0};
  }
  SlipDifferenceWeights result =
      problem.difference == SlipDifference::biased
          ? SlipDifferenceWeights{biased, 0.0}
          : SlipDifferenceWeights{{0.0, 1.0, -1.0, 0.0}, first_order_place};
  if (problem.step_length > 0.0) {
    const double upstream = problem.rolling_share / step_rate(problem);
    for (double& weight : result.weights) {
      weight *= upstream;
    }
    const double own = (1.0 - upstream) * times;
    result.weights[1] += own;
    result.upstream = upstream / (upstream + own);
  }
  return result;
}

double natural_step_of(const TractionShape& shape, std::array<double, 2> self_influence,
                       double upstream) {
  // A shift displaces the whole contact at once: its operator's largest eigenvalue grows with the
  // number of elements across.
  const double of_shift = 0.5 * static_cast<double>(std::min(shape.rows, shape.columns) + 1);
  const double gain = upstream + (1.0 - upstream) * of_shift;
  return natural_step / (std::sqrt(self_influence[0] * self_influence[1]) * gain);
}

ScaledTractions::ScaledTractions(const RollingProblem& problem, LinePlans& plans)
    : problem_(problem), aspect_(problem.grid.lateral_step / problem.grid.longitudinal_step),
      difference_(difference_of(problem)) {
  const double largest = *std::max_element(problem.pressure.begin(), problem.pressure.end());
  bound_ = problem.friction * largest;
  if (!(bound_ > least_bound)) {
    return;
  }
  slip_scale_ = bound_ / problem.shear_modulus;
  if (problem.motion == TangentialMotion::shift) {
    slip_scale_ *= problem.grid.longitudinal_step;
  } else if (problem.step_length > 0.0) {
    slip_scale_ *= step_rate(problem);
  }
  find_box();
  if (!problem.previous_x.empty() && problem.motion != TangentialMotion::rolling) {
    take_in_previous(plans);
  }
  if (problem.difference_parameter != 0.0) {
    take_in_pressure(plans);
  }
  if (!problem.slip_x.empty()) {
    take_in_slip();
  }
  limit_slip();
}

/// Where bodies slide by far more than tractions displace, only the direction counts: a larger unit
/// of slip keeps it within single precision. What is given where there is no pressure, which may be
/// any filler, has no part in the unit and is cut to the largest slip.
void ScaledTractions::limit_slip() {
  const Grid& grid = problem_.grid;
  const Creepages& creepages = problem_.creepages;
  double largest = 0.0;
  for (const double x : {grid.longitudinal_first, grid.longitudinal(grid.longitudinal_count - 1)}) {
    for (const double y : {grid.lateral_first, grid.lateral(grid.lateral_count - 1)}) {
      largest = std::max({largest, std::abs(creepages.longitudinal - creepages.spin * y),
                          std::abs(creepages.lateral + creepages.spin * x)});
    }
  }
  largest /= slip_scale_;
  const std::size_t columns = box_.shape.columns;
  const std::size_t count = box_.shape.rows * columns;
  const auto loaded = [&](std::size_t i) {
    return problem_.pressure[element(i % count / columns, i % columns)] > 0.0;
  };
  for (std::size_t i = 0; i < given_slip_.size(); ++i) {
    largest = loaded(i) ? std::max(largest, std::abs(given_slip_[i])) : largest;
  }
  for (std::size_t i = 0; i < given_slip_.size(); ++i) {
    given_slip_[i] = loaded(i) ? given_slip_[i] : std::clamp(given_slip_[i], -largest, largest);
  }
  if (largest > most_slip) {
    slip_scale_ *= largest / most_slip;
    for (double& slip : given_slip_) {
      slip *= most_slip / largest;
    }
  }
}

void ScaledTractions::find_box() {
  const Grid& grid = problem_.grid;
  std::span<const double> loaded = problem_.pressure;
  std::vector<double> with_previous;
  if (!problem_.previous_x.empty()) {
    with_previous.assign(loaded.begin(), loaded.end());
    for (std::size_t at = 0; at < with_previous.size(); ++at) {
      with_previous[at] += std::abs(problem_.previous_x[at]) + std::abs(problem_.previous_y[at]);
    }
    loaded = with_previous;
  }
  ElementBox box;
  find_pressure_box({grid.lateral_count, grid.longitudinal_count}, loaded, 0, box);
  box_ = {{box.columns(), box.rows()}, box.first_column, box.first_row};
}

void ScaledTractions::take_in_previous(LinePlans& plans) {
  const std::size_t pitch = box_.shape.columns;
  const std::size_t count = box_.shape.rows * pitch;
  std::vector<double> previous(2 * count);
  read_tractions(problem_.previous_x, problem_.previous_y, previous.data(), pitch);
  // A particle that is now at x was at x + h before a step of rolling.
  const DifferenceWeights weights = problem_.motion == TangentialMotion::transient
                                        ? DifferenceWeights{0.0, 0.0, 1.0, 0.0}
                                        : DifferenceWeights{0.0, 1.0, 0.0, 0.0};
  const auto displaced = convolution<double>(pitch, weights, plans);
  given_slip_.resize(2 * count);
  ConvolutionWorkspace<double> workspace;
  displaced.apply(previous.data(), previous.data() + count, given_slip_.data(),
                  given_slip_.data() + count, workspace);
  std::transform(given_slip_.begin(), given_slip_.end(), given_slip_.begin(), std::negate<>());
}

void ScaledTractions::take_in_pressure(LinePlans& plans) {
  const TractionShape& shape = box_.shape;
  const std::size_t count = shape.rows * shape.columns;
  std::vector<double> pressure(2 * count);
  fill_bound(pressure.data(), shape.columns);
  const bool exact = has_edges() && problem_.difference == SlipDifference::biased;
  const TractionConvolution<double> displaced =
      exact ? TractionConvolution<double>(
                  shape, shape.columns, 1.0, {0.0, 1.0, 0.0, 0.0},
                  cross_rate_table(aspect_, shape.table_rows(), shape.table_columns()), plans)
            : TractionConvolution<double>(
                  shape, shape.columns, difference_.weights,
                  cross_table(aspect_, shape.table_rows(), shape.table_columns()), plans);
  given_slip_.resize(2 * count);
  ConvolutionWorkspace<double> workspace;
  displaced.apply(pressure.data(), pressure.data() + count, given_slip_.data(),
                  given_slip_.data() + count, workspace);
  if (exact) {
    lessen_first_elements(pressure);
  }
  const double factor = (exact ? 1.0 : -1.0) * problem_.difference_parameter / problem_.friction;
  for (double& slip : given_slip_) {
    slip *= factor;
  }
}

/// Applies to the elements that strips begin with, as far as the one ahead is not covered.
void ScaledTractions::lessen_first_elements(const std::vector<double>& pressure) {
  const TractionShape& shape = box_.shape;
  const auto covered = [&](std::size_t row, std::size_t column) {
    return pressure[row * shape.columns + column] > 0.0 ? problem_.covered[element(row, column)]
                                                        : 0.0;
  };
  constexpr double of_half_plane = 2.0; // slip of a pressure in the plane problem, over K/G
  for (std::size_t row = 0; row < shape.rows; ++row) {
    for (std::size_t column = 0; column < shape.columns; ++column) {
      const double open = row > 0 ? 1.0 - covered(row - 1, column) : 1.0;
      given_slip_[row * shape.columns + column] -=
          of_half_plane * edge_slip_share * open * pressure[row * shape.columns + column];
    }
  }
}

void ScaledTractions::take_in_slip() {
  const std::size_t count = box_.shape.rows * box_.shape.columns;
  given_slip_.resize(2 * count);
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      const std::size_t to = row * box_.shape.columns + column;
      const std::size_t from = element(row, column);
      given_slip_[to] += problem_.slip_x[from] / slip_scale_;
      given_slip_[count + to] += problem_.slip_y[from] / slip_scale_;
    }
  }
}

std::size_t ScaledTractions::element(std::size_t row, std::size_t column) const {
  const std::size_t longitudinal = box_.first_longitudinal + (box_.shape.rows - 1 - row);
  return (box_.first_lateral + column) * problem_.grid.longitudinal_count + longitudinal;
}

double ScaledTractions::mean_share(std::size_t element, double bound) const {
  return bound > 0.0 ? problem_.friction * problem_.pressure[element] / (bound_ * bound) : 0.0;
}

template <typename Real> void ScaledTractions::fill_bound(Real* bound, std::size_t pitch) const {
  const double scale = problem_.friction / bound_;
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      const double value = scale * problem_.pressure[element(row, column)];
      bound[row * pitch + column] = value >= least_bound_share ? static_cast<Real>(value) : Real{0};
    }
  }
}

template <typename Real>
void ScaledTractions::fill_covered(Real* covered, std::size_t pitch) const {
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      covered[row * pitch + column] = static_cast<Real>(problem_.covered[element(row, column)]);
    }
  }
}

template <typename Real>
void ScaledTractions::fill_rigid_slip(Real* slip, const TractionShape& shape, std::size_t pitch,
                                      std::size_t level) const {
  const Grid& grid = problem_.grid;
  const auto larger = static_cast<double>(std::size_t{1} << level);
  const double leading = grid.longitudinal(box_.first_longitudinal + box_.shape.rows - 1) +
                         0.5 * grid.longitudinal_step;
  const double right = grid.lateral(box_.first_lateral) - 0.5 * grid.lateral_step;
  const Creepages& creepages = problem_.creepages;
  Real* slip_y = slip + shape.rows * pitch;
  for (std::size_t row = 0; row < shape.rows; ++row) {
    const double x = leading - (static_cast<double>(row) + 0.5 - difference_.place) * larger *
                                   grid.longitudinal_step;
    for (std::size_t column = 0; column < shape.columns; ++column) {
      const double y = right + (static_cast<double>(column) + 0.5) * larger * grid.lateral_step;
      const auto [given_x, given_y] = given_slip_at(row, column, level);
      slip[row * pitch + column] =
          static_cast<Real>((creepages.longitudinal - creepages.spin * y) / slip_scale_ + given_x);
      slip_y[row * pitch + column] =
          static_cast<Real>((creepages.lateral + creepages.spin * x) / slip_scale_ + given_y);
    }
  }
}

template <typename Real>
void ScaledTractions::fill_slip_rate(std::size_t creepage, Real* slip, std::size_t pitch) const {
  Real* slip_y = slip + box_.shape.rows * pitch;
  const Grid& grid = problem_.grid;
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      const std::size_t at = element(row, column);
      const double x = grid.longitudinal(at % grid.longitudinal_count) / grid.longitudinal_step +
                       difference_.place;
      const double y = grid.lateral(at / grid.longitudinal_count) / grid.longitudinal_step;
      const std::array<double, 3> along{1.0, 0.0, -y};
      const std::array<double, 3> across{0.0, 1.0, x};
      slip[row * pitch + column] = static_cast<Real>(along[creepage]);
      slip_y[row * pitch + column] = static_cast<Real>(across[creepage]);
    }
  }
}

template <typename Real>
std::array<double, 4> ScaledTractions::force_rates(std::size_t creepage, const Real* rate,
                                                   const Real* bound, std::size_t pitch) const {
  const Grid& grid = problem_.grid;
  const Real* rate_y = rate + box_.shape.rows * pitch;
  std::array<double, 4> sums{};
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      const std::size_t at = element(row, column);
      if (!(problem_.pressure[at] > 0.0)) {
        continue;
      }
      const double share = mean_share(at, static_cast<double>(bound[row * pitch + column]));
      const double x = share * static_cast<double>(rate[row * pitch + column]);
      const double y = share * static_cast<double>(rate_y[row * pitch + column]);
      sums[0] += x;
      sums[1] += y;
      const std::size_t strip = at / grid.longitudinal_count;
      sums[2] += grid.longitudinal(at % grid.longitudinal_count) * y -
                 lever_of(problem_, strip, grid.lateral_first, grid.lateral_step) * x;
      if (!problem_.weight_x.empty()) {
        sums[3] += problem_.weight_x[at] * x + problem_.weight_y[at] * y;
      }
    }
  }
  const double scale =
      bound_ / slip_scale_ * grid.element_area() * (creepage == 2 ? grid.longitudinal_step : 1.0);
  return {scale * sums[0], scale * sums[1], scale * sums[2], scale * sums[3]};
}

/// Mean over the elements that one of a coarser grid is made of.
std::array<double, 2> ScaledTractions::given_slip_at(std::size_t row, std::size_t column,
                                                     std::size_t level) const {
  if (given_slip_.empty()) {
    return {};
  }
  const std::size_t times = std::size_t{1} << level;
  const std::size_t end_row = std::min((row + 1) * times, box_.shape.rows);
  const std::size_t end_column = std::min((column + 1) * times, box_.shape.columns);
  std::array<double, 2> sum{};
  std::size_t count = 0;
  for (std::size_t i = row * times; i < end_row; ++i) {
    for (std::size_t j = column * times; j < end_column; ++j) {
      const std::size_t at = i * box_.shape.columns + j;
      sum[0] += given_slip_[at];
      sum[1] += given_slip_[box_.shape.rows * box_.shape.columns + at];
      ++count;
    }
  }
  return {sum[0] / static_cast<double>(count), sum[1] / static_cast<double>(count)};
}

void ScaledTractions::read_tractions(std::span<const double> x, std::span<const double> y,
                                     double* traction, std::size_t pitch) const {
  double* to_y = traction + box_.shape.rows * pitch;
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      const std::size_t at = element(row, column);
      traction[row * pitch + column] = x[at] / bound_;
      to_y[row * pitch + column] = y[at] / bound_;
    }
  }
}

template <typename Real>
void ScaledTractions::read_back(const Real* traction, const Real* slip, const Real* bound,
                                std::size_t pitch, RollingSolution& solution) const {
  const std::size_t size = box_.shape.rows * pitch;
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      const std::size_t at = element(row, column);
      if (problem_.pressure[at] > 0.0) {
        const std::size_t from = row * pitch + column;
        const double scale = bound_ * mean_share(at, static_cast<double>(bound[from]));
        solution.traction_x[at] = scale * traction[from];
        solution.traction_y[at] = scale * traction[size + from];
        solution.slip_x[at] = slip_scale_ * slip[from];
        solution.slip_y[at] = slip_scale_ * slip[size + from];
      }
    }
  }
}

double ScaledTractions::power_by_pressure(const RollingSolution& solution) const {
  if (problem_.difference_parameter == 0.0) {
    return 0.0;
  }
  double power = 0.0;
  for (std::size_t row = 0; row < box_.shape.rows; ++row) {
    for (std::size_t column = 0; column < box_.shape.columns; ++column) {
      const std::size_t at = element(row, column);
      const auto [x, y] = given_slip_at(row, column, 0);
      power -= solution.traction_x[at] * x + solution.traction_y[at] * y;
    }
  }
  for (std::size_t at = 0; at < problem_.slip_x.size(); ++at) { // part of that slip
    power += (solution.traction_x[at] * problem_.slip_x[at] +
              solution.traction_y[at] * problem_.slip_y[at]) /
             slip_scale_;
  }
  return slip_scale_ * problem_.grid.element_area() * power;
}

double lever_of(const RollingProblem& problem, std::size_t strip, double lateral_first,
                double lateral_step) {
  constexpr double outermost = 11.0 / 12.0; // not a tuning constant
  const std::size_t last = problem.grid.lateral_count - 1;
  const double middle = 0.5 * static_cast<double>(last);
  const bool ends = !problem.covered.empty() && (strip == 0 || strip == last);
  const double steps = middle + (ends ? outermost : 1.0) * (static_cast<double>(strip) - middle);
  return lateral_first + steps * lateral_step;
}

void sum_up(const RollingProblem& problem, double pressure_power, RollingSolution& solution) {
  const Grid& grid = problem.grid;
  const double area = grid.element_area();
  double dissipation = 0.0;
  double given_power = 0.0;
  std::size_t slipping = 0;
  std::size_t contacts = 0;
  for (std::size_t j = 0; j < grid.lateral_count; ++j) {
    const double lever = lever_of(problem, j, grid.lateral_first, grid.lateral_step);
    for (std::size_t i = 0; i < grid.longitudinal_count; ++i) {
      const std::size_t at = j * grid.longitudinal_count + i;
      const double bound = problem.friction * problem.pressure[at];
      if (!(bound > 0.0)) {
        continue;
      }
      const double qx = solution.traction_x[at];
      const double qy = solution.traction_y[at];
      solution.longitudinal_force += area * qx;
      solution.lateral_force += area * qy;
      solution.spin_moment += area * (grid.longitudinal(i) * qy - lever * qx);
      dissipation -= area * (qx * solution.slip_x[at] + qy * solution.slip_y[at]);
      if (!problem.slip_x.empty()) {
        given_power -= area * (qx * problem.slip_x[at] + qy * problem.slip_y[at]);
      }
      if (!problem.weight_x.empty()) {
        solution.weighted_force += area * (qx * problem.weight_x[at] + qy * problem.weight_y[at]);
      }
      ++contacts;
      constexpr double on_bound = 1.0 - off_bound;
      slipping += qx * qx + qy * qy >= on_bound * on_bound * bound * bound ? 1 : 0;
    }
  }
  solution.slip_area = area * static_cast<double>(slipping);
  solution.adhesion_area = area * static_cast<double>(contacts - slipping);
  const Creepages& w = problem.creepages;
  solution.power_of_pressures = pressure_power;
  solution.friction_power = pressure_power + given_power -
                            (solution.longitudinal_force * w.longitudinal +
                             solution.lateral_force * w.lateral + solution.spin_moment * w.spin);
  if (problem.motion == TangentialMotion::rolling && !(problem.step_length > 0.0) &&
      solution.friction_power > 0.0) {
    solution.numerical_loss = 1.0 - dissipation / solution.friction_power;
  }
}

template void ScaledTractions::fill_bound<float>(float*, std::size_t) const;
template void ScaledTractions::fill_covered<float>(float*, std::size_t) const;
template void ScaledTractions::fill_covered<double>(double*, std::size_t) const;
template void ScaledTractions::fill_bound<double>(double*, std::size_t) const;
template void ScaledTractions::fill_rigid_slip<float>(float*, const TractionShape&, std::size_t,
                                                      std::size_t) const;
template void ScaledTractions::fill_rigid_slip<double>(double*, const TractionShape&, std::size_t,
                                                       std::size_t) const;
template void ScaledTractions::fill_slip_rate<float>(std::size_t, float*, std::size_t) const;
template void ScaledTractions::fill_slip_rate<double>(std::size_t, double*, std::size_t) const;
template std::array<double, 4> ScaledTractions::force_rates<float>(std::size_t, const float*,
                                                                   const float*, std::size_t) const;
template std::array<double, 4>
ScaledTractions::force_rates<double>(std::size_t, const double*, const double*, std::size_t) const;
template void ScaledTractions::read_back<float>(const float*, const float*, const float*,
                                                std::size_t, RollingSolution&) const;
template void ScaledTractions::read_back<double>(const double*, const double*, const double*,
                                                 std::size_t, RollingSolution&) const;

} // namespace wrc
