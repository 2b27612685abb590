#include "mechanics/projected_cg_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vector_clones.hpp"

namespace wrc {

namespace {

template <typename Real>
WRC_VECTOR_BODY void residual_body(const double* pressure, const double* displacement,
                                   const double* distance, const double* shares, double approach,
                                   Real* residual, Real* contact, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const double r = (shares[i] * approach - distance[i]) - displacement[i];
    const bool inside = (pressure[i] > 0.0) | (r > 0.0);
    residual[i] = inside ? static_cast<Real>(r) : Real{0};
    contact[i] = inside ? Real{1} : Real{0};
  }
}

template <typename Real>
WRC_VECTOR_BODY CorrectionSums correction_body(Real* z, const Real* r, const Real* old_r,
                                               const Real* v, const Real* contact,
                                               const double* shares, std::size_t count) {
  CorrectionSums s;
  double squares = 0.0, sum_z = 0.0, sum_r = 0.0, sum_old = 0.0, z_r = 0.0, z_old = 0.0,
         sum_v = 0.0;
  Real least = std::numeric_limits<Real>::max();
  Real largest = -least;
#pragma omp simd reduction(+ : squares, sum_z, sum_r, sum_old, z_r, z_old, sum_v)                  \
    reduction(min : least) reduction(max : largest)
  for (std::size_t i = 0; i < count; ++i) {
    const Real inside = contact[i];
    const Real zi = z[i] * inside;
    z[i] = zi;
    const double zd = zi;
    const double share = shares[i] * inside;
    squares += share * share;
    sum_z += zd * share;
    sum_r += r[i] * share;
    sum_old += old_r[i] * share;
    z_r += zd * r[i];
    z_old += zd * old_r[i];
    sum_v += v[i] * share;
    least = std::min(least, inside > Real{0} ? zi : least);
    largest = std::max(largest, inside > Real{0} ? zi : largest);
  }
  s.s_s = squares;
  s.s_z = sum_z;
  s.s_r = sum_r;
  s.s_old_r = sum_old;
  s.z_r = z_r;
  s.z_old_r = z_old;
  s.s_v = sum_v;
  s.least_z = least;
  s.largest_z = largest;
  return s;
}

template <typename Real>
WRC_VECTOR_BODY void direction_body(const Real* z, Real* v, const Real* contact,
                                    const double* shares, Real beta, Real shift,
                                    std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    v[i] = contact[i] * (z[i] + beta * v[i] - shift * static_cast<Real>(shares[i]));
  }
}

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

template <typename Real>
WRC_VECTOR_BODY JointStepSums joint_step_body(const double* pressure, const double* displacement,
                                              const Real* r, const Real* v, const Real* q,
                                              const double* shares, std::size_t count) {
  double v_q = 0.0, p_q = 0.0, p_u = 0.0, r_v = 0.0, r_p = 0.0, sum_v = 0.0, sum_p = 0.0,
         load_v = 0.0, load_p = 0.0;
#pragma omp simd reduction(+ : v_q, p_q, p_u, r_v, r_p, sum_v, sum_p, load_v, load_p)
  for (std::size_t i = 0; i < count; ++i) {
    const double p = pressure[i];
    const double ri = r[i];
    const double vi = v[i];
    const double qi = q[i];
    v_q += vi * qi;
    p_q += p * qi;
    p_u += p * displacement[i];
    r_v += ri * vi;
    r_p += ri * p;
    sum_v += vi;
    sum_p += p;
    load_v += shares[i] * vi;
    load_p += shares[i] * p;
  }
  return {v_q, p_q, p_u, r_v, r_p, sum_v, sum_p, load_v, load_p};
}

template <typename Real>
WRC_VECTOR_BODY MoveSums move_body(double* pressure, double* displacement, const Real* v,
                                   const Real* q, const double* shares, double step,
                                   std::size_t count) {
  double sum = 0.0, largest = 0.0, change = 0.0, negative = 0.0;
#pragma omp simd reduction(+ : sum, negative) reduction(max : largest, change)
  for (std::size_t i = 0; i < count; ++i) {
    const double move = step * v[i];
    const double p = pressure[i] + move;
    pressure[i] = p;
    displacement[i] += step * q[i];
    sum += shares[i] * (p > 0.0 ? p : 0.0);
    negative += p < 0.0 ? 1.0 : 0.0;
    largest = std::max(largest, p);
    change = std::max(change, std::abs(move));
  }
  return {sum, largest, change, negative};
}

template <typename Real>
WRC_VECTOR_BODY void change_body(const double* pressure, const Real* v, Real step, Real* change,
                                 std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    change[i] = step * v[i] + static_cast<Real>(std::max(0.0, -pressure[i]));
  }
}

template <typename Real>
WRC_VECTOR_BODY void take_out_body(double* displacement, Real* sum, const Real* const* kernels,
                                   const Real* pressures, std::size_t cuts, std::size_t columns) {
  std::fill_n(sum, columns, Real{0});
  for (std::size_t k = 0; k < cuts; ++k) {
    const Real* kernel = kernels[k];
    const Real pressure = pressures[k];
#pragma omp simd
    for (std::size_t j = 0; j < columns; ++j) {
      sum[j] += pressure * kernel[j];
    }
  }
#pragma omp simd
  for (std::size_t j = 0; j < columns; ++j) {
    displacement[j] -= static_cast<double>(sum[j]);
  }
}

} // namespace

WRC_VECTOR_CLONES ContactMean scale_and_average(double* pressure, double* displacement,
                                                const double* distance, const double* shares,
                                                double factor, double approach, std::size_t count) {
  double sum = 0.0;
  double squares = 0.0;
#pragma omp simd reduction(+ : sum, squares)
  for (std::size_t i = 0; i < count; ++i) {
    const double p = pressure[i] * factor;
    const double u = displacement[i] * factor;
    pressure[i] = p;
    displacement[i] = u;
    const double share = p > 0.0 ? shares[i] : 0.0;
    sum += share * ((distance[i] - share * approach) + u);
    squares += share * share;
  }
  return {sum, squares};
}

WRC_VECTOR_CLONES void form_residual(const double* p, const double* u, const double* h,
                                     const double* s, double approach, float* r, float* contact,
                                     std::size_t n) {
  residual_body(p, u, h, s, approach, r, contact, n);
}

WRC_VECTOR_CLONES void form_residual(const double* p, const double* u, const double* h,
                                     const double* s, double approach, double* r, double* contact,
                                     std::size_t n) {
  residual_body(p, u, h, s, approach, r, contact, n);
}

WRC_VECTOR_CLONES CorrectionSums sum_correction(float* z, const float* r, const float* old_r,
                                                const float* v, const float* contact,
                                                const double* s, std::size_t n) {
  return correction_body(z, r, old_r, v, contact, s, n);
}

WRC_VECTOR_CLONES CorrectionSums sum_correction(double* z, const double* r, const double* old_r,
                                                const double* v, const double* contact,
                                                const double* s, std::size_t n) {
  return correction_body(z, r, old_r, v, contact, s, n);
}

WRC_VECTOR_CLONES void form_direction(const float* z, float* v, const float* contact,
                                      const double* s, double beta, double shift, std::size_t n) {
  direction_body(z, v, contact, s, static_cast<float>(beta), static_cast<float>(shift), n);
}

WRC_VECTOR_CLONES void form_direction(const double* z, double* v, const double* contact,
                                      const double* s, double beta, double shift, std::size_t n) {
  direction_body(z, v, contact, s, beta, shift, n);
}

WRC_VECTOR_CLONES StepSums sum_step(const float* r, const float* v, const float* q, std::size_t n) {
  return step_body(r, v, q, n);
}

WRC_VECTOR_CLONES StepSums sum_step(const double* r, const double* v, const double* q,
                                    std::size_t n) {
  return step_body(r, v, q, n);
}

WRC_VECTOR_CLONES JointStepSums sum_joint_step(const double* p, const double* u, const float* r,
                                               const float* v, const float* q, const double* s,
                                               std::size_t n) {
  return joint_step_body(p, u, r, v, q, s, n);
}

WRC_VECTOR_CLONES JointStepSums sum_joint_step(const double* p, const double* u, const double* r,
                                               const double* v, const double* q, const double* s,
                                               std::size_t n) {
  return joint_step_body(p, u, r, v, q, s, n);
}

WRC_VECTOR_CLONES MoveSums move(double* p, double* u, const float* v, const float* q,
                                const double* s, double step, std::size_t n) {
  return move_body(p, u, v, q, s, step, n);
}

WRC_VECTOR_CLONES MoveSums move(double* p, double* u, const double* v, const double* q,
                                const double* s, double step, std::size_t n) {
  return move_body(p, u, v, q, s, step, n);
}

WRC_VECTOR_CLONES void form_change(const double* p, const float* v, double step, float* change,
                                   std::size_t n) {
  change_body(p, v, static_cast<float>(step), change, n);
}

WRC_VECTOR_CLONES void form_change(const double* p, const double* v, double step, double* change,
                                   std::size_t n) {
  change_body(p, v, step, change, n);
}

WRC_VECTOR_CLONES void take_out(double* u, float* sum, const float* const* kernels,
                                const float* pressures, std::size_t cuts, std::size_t n) {
  take_out_body(u, sum, kernels, pressures, cuts, n);
}

WRC_VECTOR_CLONES void take_out(double* u, double* sum, const double* const* kernels,
                                const double* pressures, std::size_t cuts, std::size_t n) {
  take_out_body(u, sum, kernels, pressures, cuts, n);
}

} // namespace wrc
