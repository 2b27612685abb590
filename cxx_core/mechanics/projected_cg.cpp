#include "mechanics/projected_cg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "vector_clones.hpp"

namespace wrc {

namespace {

/// Rounding in u stands for an error of p relative to the largest p, of about this much times
/// N^1.15, N elements along the rectangle's longer side: the ratio of the operator's extreme
/// eigenvalues grows with it. Measured with directions in single precision: 8.9e-6 for 78 elements,
/// 2.6e-5 for 156, 6.1e-5 for 306, 1.4e-4 for 614, 2.9e-4 for 1228.
constexpr double single_drift = 8.5e-8;
constexpr double double_drift = 2e-16;
constexpr double drift_exponent = 1.15;
/// Share of the tolerance that rounding may take; by about so much results differ between
/// instruction sets.
constexpr double drift_share = 0.1;
/// Iterations without a smaller error after which no more is to be had.
constexpr int stagnation_window = 60;

struct ContactMean {
  double sum;
  double count;
};

/// Scales p and u; sums h + u - level over the contact. With a level near the answer nothing is
/// lost to rounding, however many elements there are.
WRC_VECTOR_CLONES ContactMean scale_and_average(double* pressure, double* displacement,
                                                const double* distance, double factor, double level,
                                                std::size_t count) {
  double sum = 0.0;
  double contacts = 0.0;
#pragma omp simd reduction(+ : sum, contacts)
  for (std::size_t i = 0; i < count; ++i) {
    const double p = pressure[i] * factor;
    const double u = displacement[i] * factor;
    pressure[i] = p;
    displacement[i] = u;
    const double inside = p > 0.0 ? 1.0 : 0.0;
    sum += inside * ((distance[i] - level) + u);
    contacts += inside;
  }
  return {sum, contacts};
}

template <typename Real>
WRC_VECTOR_BODY void residual_body(const double* pressure, const double* displacement,
                                   const double* distance, double approach, Real* residual,
                                   Real* contact, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const double r = (approach - distance[i]) - displacement[i];
    const bool inside = (pressure[i] > 0.0) | (r > 0.0);
    residual[i] = inside ? static_cast<Real>(r) : Real{0};
    contact[i] = inside ? Real{1} : Real{0};
  }
}

/// Sums over C from which the mean of z, the coefficient beta and the error follow.
struct CorrectionSums {
  double contacts = 0.0;
  double z = 0.0;
  double r = 0.0;
  double old_r = 0.0;
  double z_r = 0.0;
  double z_old_r = 0.0;
  double v = 0.0;
  double least_z = 0.0;
  double largest_z = 0.0;
};

template <typename Real>
WRC_VECTOR_BODY CorrectionSums correction_body(Real* z, const Real* r, const Real* old_r,
                                               const Real* v, const Real* contact,
                                               std::size_t count) {
  CorrectionSums s;
  double contacts = 0.0, sum_z = 0.0, sum_r = 0.0, sum_old = 0.0, z_r = 0.0, z_old = 0.0,
         sum_v = 0.0;
  Real least = std::numeric_limits<Real>::max();
  Real largest = -least;
#pragma omp simd reduction(+ : contacts, sum_z, sum_r, sum_old, z_r, z_old, sum_v)                 \
    reduction(min : least) reduction(max : largest)
  for (std::size_t i = 0; i < count; ++i) {
    const Real inside = contact[i];
    const Real zi = z[i] * inside;
    z[i] = zi;
    const double zd = zi;
    contacts += inside;
    sum_z += zd;
    sum_r += r[i];
    sum_old += old_r[i] * inside;
    z_r += zd * r[i];
    z_old += zd * old_r[i];
    sum_v += v[i] * inside;
    least = std::min(least, inside > Real{0} ? zi : least);
    largest = std::max(largest, inside > Real{0} ? zi : largest);
  }
  s.contacts = contacts;
  s.z = sum_z;
  s.r = sum_r;
  s.old_r = sum_old;
  s.z_r = z_r;
  s.z_old_r = z_old;
  s.v = sum_v;
  s.least_z = least;
  s.largest_z = largest;
  return s;
}

template <typename Real>
WRC_VECTOR_BODY void direction_body(const Real* z, Real* v, const Real* contact, Real beta,
                                    Real shift, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    v[i] = contact[i] * (z[i] + beta * v[i] - shift);
  }
}

struct StepSums {
  double r_v;
  double v_q;
};

template <typename Real>
WRC_VECTOR_BODY StepSums step_body(const Real* r, const Real* v, const Real* q, std::size_t count) {
  double r_v = 0.0;
  double v_q = 0.0;
#pragma omp simd reduction(+ : r_v, v_q)
  for (std::size_t i = 0; i < count; ++i) {
    const double vi = v[i];
    r_v += vi * r[i];
    v_q += vi * q[i];
  }
  return {r_v, v_q};
}

struct MoveSums {
  double pressure = 0.0; ///< of the positive ones
  double largest = 0.0;
  double largest_change = 0.0;
  double negative_count = 0.0;
};

template <typename Real>
WRC_VECTOR_BODY MoveSums move_body(double* pressure, double* displacement, const Real* v,
                                   const Real* q, double step, std::size_t count) {
  double sum = 0.0, largest = 0.0, change = 0.0, negative = 0.0;
#pragma omp simd reduction(+ : sum, negative) reduction(max : largest, change)
  for (std::size_t i = 0; i < count; ++i) {
    const double move = step * v[i];
    const double p = pressure[i] + move;
    pressure[i] = p;
    displacement[i] += step * q[i];
    sum += p > 0.0 ? p : 0.0;
    negative += p < 0.0 ? 1.0 : 0.0;
    largest = std::max(largest, p);
    change = std::max(change, std::abs(move));
  }
  return {sum, largest, change, negative};
}

WRC_VECTOR_CLONES void form_residual(const double* p, const double* u, const double* h,
                                     double approach, float* r, float* contact, std::size_t n) {
  residual_body(p, u, h, approach, r, contact, n);
}
WRC_VECTOR_CLONES void form_residual(const double* p, const double* u, const double* h,
                                     double approach, double* r, double* contact, std::size_t n) {
  residual_body(p, u, h, approach, r, contact, n);
}
WRC_VECTOR_CLONES CorrectionSums sum_correction(float* z, const float* r, const float* old_r,
                                                const float* v, const float* contact,
                                                std::size_t n) {
  return correction_body(z, r, old_r, v, contact, n);
}
WRC_VECTOR_CLONES CorrectionSums sum_correction(double* z, const double* r, const double* old_r,
                                                const double* v, const double* contact,
                                                std::size_t n) {
  return correction_body(z, r, old_r, v, contact, n);
}
WRC_VECTOR_CLONES void form_direction(const float* z, float* v, const float* contact, double beta,
                                      double shift, std::size_t n) {
  direction_body(z, v, contact, static_cast<float>(beta), static_cast<float>(shift), n);
}
WRC_VECTOR_CLONES void form_direction(const double* z, double* v, const double* contact,
                                      double beta, double shift, std::size_t n) {
  direction_body(z, v, contact, beta, shift, n);
}
WRC_VECTOR_CLONES StepSums sum_step(const float* r, const float* v, const float* q, std::size_t n) {
  return step_body(r, v, q, n);
}
WRC_VECTOR_CLONES StepSums sum_step(const double* r, const double* v, const double* q,
                                    std::size_t n) {
  return step_body(r, v, q, n);
}
WRC_VECTOR_CLONES MoveSums move(double* p, double* u, const float* v, const float* q, double step,
                                std::size_t n) {
  return move_body(p, u, v, q, step, n);
}
WRC_VECTOR_CLONES MoveSums move(double* p, double* u, const double* v, const double* q, double step,
                                std::size_t n) {
  return move_body(p, u, v, q, step, n);
}

/// u += pressure * K around one element of a row.
WRC_VECTOR_CLONES void add_to_row(double* displacement, const double* kernel, double pressure,
                                  std::size_t column, std::size_t columns) {
  for (std::size_t j = 0; j < column; ++j) {
    displacement[j] += pressure * kernel[column - j];
  }
  for (std::size_t j = column; j < columns; ++j) {
    displacement[j] += pressure * kernel[j - column];
  }
}

} // namespace

/// u = K p. In the precision of the directions, or in double if they are single and it matters.
template <typename Real> void BoxIteration<Real>::refresh_displacement(bool in_double) {
  if (in_double) {
    const BoxConvolution<double> convolution = BoxConvolution<double>::linear(
        {request_->rows, request_->columns, request_->rows, request_->columns, 0, 0},
        request_->aspect, cache_);
    convolution.apply(pressure_, displacement_.data(), double_workspace_);
    return;
  }
  std::transform(pressure_, pressure_ + count_, response_.data(),
                 [](double p) { return static_cast<Real>(p); });
  convolution_.apply(response_.data(), response_.data(), workspace_);
  std::copy_n(response_.data(), count_, displacement_.data());
}

/// Sets negative pressures to 0 and takes their displacement out of u.
template <typename Real> void BoxIteration<Real>::cut_negative(std::size_t negative_count) {
  // About what a convolution costs in additions.
  constexpr std::size_t most_single_additions = 32;
  if (negative_count <= most_single_additions) {
    struct Cut {
      std::size_t row;
      std::size_t column;
      double pressure;
    };
    std::array<Cut, most_single_additions> cuts{};
    std::size_t cut_count = 0;
    for (std::size_t index = 0; index < count_; ++index) {
      if (pressure_[index] < 0.0) {
        cuts[cut_count++] = {index / request_->columns, index % request_->columns,
                             pressure_[index]};
        pressure_[index] = 0.0;
      }
    }
    const InfluenceTable& kernel =
        cache_.table(request_->aspect, request_->rows, request_->columns);
    for (std::size_t i = 0; i < request_->rows; ++i) {
      double* displacement = displacement_.data() + i * request_->columns;
      for (std::size_t k = 0; k < cut_count; ++k) {
        const Cut& cut = cuts[k];
        add_to_row(displacement, kernel.row(i > cut.row ? i - cut.row : cut.row - i), -cut.pressure,
                   cut.column, request_->columns);
      }
    }
    return;
  }
  for (std::size_t index = 0; index < count_; ++index) {
    const double p = pressure_[index];
    response_.data()[index] = static_cast<Real>(std::max(0.0, -p));
    pressure_[index] = std::max(0.0, p);
  }
  convolution_.apply(response_.data(), response_.data(), workspace_);
  for (std::size_t index = 0; index < count_; ++index) {
    displacement_.data()[index] += response_.data()[index];
  }
}

template <typename Real> bool BoxIteration<Real>::note_reached_sides(BoxOutcome& outcome) const {
  const std::size_t columns = request_->columns;
  const Real* contact = contact_.data();
  const auto row_touched = [&](std::size_t row) {
    return std::any_of(contact + row * columns, contact + (row + 1) * columns,
                       [](Real value) { return value > Real{0}; });
  };
  const auto column_touched = [&](std::size_t column) {
    for (std::size_t index = column; index < count_; index += columns) {
      if (contact[index] > Real{0}) {
        return true;
      }
    }
    return false;
  };
  outcome.reached_first_row = request_->open_first_row && row_touched(0);
  outcome.reached_last_row = request_->open_last_row && row_touched(request_->rows - 1);
  outcome.reached_first_column = request_->open_first_column && column_touched(0);
  outcome.reached_last_column = request_->open_last_column && column_touched(columns - 1);
  return outcome.reached_first_row || outcome.reached_last_row || outcome.reached_first_column ||
         outcome.reached_last_column;
}

/// p = max(0, p + z): z estimates the error, so this removes most of what is left of it.
template <typename Real> void BoxIteration<Real>::take_free_step(double z_mean) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double z = correction_.data()[i] - z_mean * contact_.data()[i];
    pressure_[i] = std::max(0.0, pressure_[i] + z);
    sum += pressure_[i];
  }
  if (request_->pressure_sum) {
    const double factor = *request_->pressure_sum / sum;
    for (std::size_t i = 0; i < count_; ++i) {
      pressure_[i] *= factor;
    }
  }
}

template <typename Real>
BoxOutcome BoxIteration<Real>::solve(const BoxRequest& request, std::span<double> pressure,
                                     std::span<const double> distance) {
  request_ = &request;
  count_ = pressure.size();
  pressure_ = pressure.data();
  distance_ = distance.data();
  const std::size_t rows = request.rows;
  const std::size_t columns = request.columns;
  convolution_ =
      BoxConvolution<Real>::linear({rows, columns, rows, columns, 0, 0}, request.aspect, cache_);
  preconditioner_ = BoxConvolution<Real>::inverse_periodic(rows, columns, request.aspect, cache_);
  provide(displacement_, count_);
  for (AlignedArray<Real>* array :
       {&residual_, &last_residual_, &correction_, &direction_, &response_, &contact_}) {
    provide(*array, count_);
  }
  std::fill_n(direction_.data(), count_, Real{0});
  std::fill_n(last_residual_.data(), count_, Real{0});

  const bool load_given = request.pressure_sum.has_value();
  constexpr bool is_single = sizeof(Real) < sizeof(double);
  const double amplification =
      std::pow(static_cast<double>(std::max(rows, columns)), drift_exponent);
  const double least_drift = double_drift * amplification;
  const double drift_rate = is_single ? single_drift * amplification : least_drift;
  BoxOutcome outcome;
  outcome.largest_pressure = *std::max_element(pressure.begin(), pressure.end());
  double sum = 0.0;
  for (const double p : pressure) {
    sum += p;
  }
  double factor = load_given ? *request.pressure_sum / sum : 1.0;
  // The error of p that rounding in u stands for, relative to the largest pressure.
  double drift = drift_rate;
  const double permitted_drift = drift_share * request.tolerance;
  if (is_single && drift > permitted_drift) {
    refresh_displacement(true);
    drift = least_drift;
  } else {
    refresh_displacement(false);
  }
  outcome.approach = load_given ? displacement_.data()[0] + distance_[0] : request.approach;
  // The same as a pressure: pressures may fall by orders of magnitude, rounding in u does not.
  double rounding = drift * outcome.largest_pressure;

  double last_z_r = 0.0;
  double best_error = std::numeric_limits<double>::infinity();
  int best_iteration = 0;
  for (;; ++outcome.iterations) {
    const ContactMean mean = scale_and_average(pressure_, displacement_.data(), distance_, factor,
                                               outcome.approach, count_);
    outcome.largest_pressure *= factor;
    rounding *= factor;
    drift = rounding / std::max(outcome.largest_pressure, 1e-300);
    factor = 1.0;
    if (load_given) {
      outcome.approach += mean.sum / mean.count;
    }

    std::swap(residual_, last_residual_);
    form_residual(pressure_, displacement_.data(), distance_, outcome.approach, residual_.data(),
                  contact_.data(), count_);
    if (note_reached_sides(outcome)) {
      return outcome;
    }
    preconditioner_.apply(residual_.data(), correction_.data(), workspace_);
    const CorrectionSums sums =
        sum_correction(correction_.data(), residual_.data(), last_residual_.data(),
                       direction_.data(), contact_.data(), count_);
    const double z_mean = load_given && sums.contacts > 0.0 ? sums.z / sums.contacts : 0.0;
    const double largest_z =
        sums.contacts > 0.0 ? std::max(sums.largest_z - z_mean, z_mean - sums.least_z) : 0.0;
    outcome.error = outcome.largest_pressure > 0.0 ? largest_z / outcome.largest_pressure
                                                   : (largest_z > 0.0 ? 1.0 : 0.0);
    if (outcome.error < best_error) {
      best_error = outcome.error;
      best_iteration = outcome.iterations;
    }
    const bool met = outcome.error <= request.tolerance;
    const bool stuck = outcome.iterations - best_iteration >= stagnation_window;
    if ((met || stuck) && drift > permitted_drift && drift > 2.0 * least_drift) {
      // Rounding in u may hide what is left: compute it anew and go on from here.
      refresh_displacement(is_single);
      rounding = least_drift * outcome.largest_pressure;
      best_error = std::numeric_limits<double>::infinity();
      best_iteration = outcome.iterations;
      last_z_r = 0.0;
      std::fill_n(direction_.data(), count_, Real{0});
      continue;
    }
    if (met || stuck || outcome.iterations >= request.maximum_iterations) {
      outcome.stop_reason = met ? StopReason::tolerance_met
                                : (stuck ? StopReason::stagnation : StopReason::iteration_limit);
      take_free_step(z_mean);
      return outcome;
    }

    const double z_r = sums.z_r - z_mean * sums.r;
    const double z_old_r = sums.z_old_r - z_mean * sums.old_r;
    double beta = last_z_r > 0.0 ? std::max(0.0, (z_r - z_old_r) / last_z_r) : 0.0;
    last_z_r = z_r;
    const double v_mean = load_given ? sums.v / sums.contacts : 0.0;
    form_direction(correction_.data(), direction_.data(), contact_.data(), beta,
                   z_mean + beta * v_mean, count_);
    convolution_.apply(direction_.data(), response_.data(), workspace_);
    const StepSums step_sums =
        sum_step(residual_.data(), direction_.data(), response_.data(), count_);
    const double step =
        step_sums.v_q > 0.0 && step_sums.r_v > 0.0 ? step_sums.r_v / step_sums.v_q : 0.0;
    const MoveSums moved =
        move(pressure_, displacement_.data(), direction_.data(), response_.data(), step, count_);
    if (step == 0.0) {
      last_z_r = 0.0; // no descent along this direction: steepest descent next
    }
    if (moved.negative_count > 0.0) {
      cut_negative(static_cast<std::size_t>(moved.negative_count));
    }
    rounding += drift_rate * moved.largest_change;
    outcome.largest_pressure = moved.largest;
    if (load_given) {
      factor = *request.pressure_sum / moved.pressure;
    }
  }
}

template class BoxIteration<float>;
template class BoxIteration<double>;

} // namespace wrc
