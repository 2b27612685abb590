/// Loops over the elements of one rectangle, of which projected_cg.hpp consists: each goes through
/// the fields once. Names are those there: p pressure, u displacement, h distance, r residual, z
/// correction, v direction, q = K v, s share of the approach, `contact` 1 on C and 0 elsewhere.
/// Directions are in single or double precision, sums always in double; their order is fixed by the
/// instruction set, so that the same machine gives the same bits. In units of influence_cache.hpp.
/// Thread rule: pure functions of their arguments.
#pragma once

#include <cstddef>

namespace wrc {

struct ContactMean {
  double sum;
  double squares;
};

/// Scales p and u by a factor; sums s (h + u - s approach) and s^2 over p > 0. With an approach
/// near the answer nothing is lost to rounding, however many elements there are.
ContactMean scale_and_average(double* p, double* u, const double* h, const double* s, double factor,
                              double approach, std::size_t n);

/// r = s approach - h - u on C = {p > 0 or r > 0}, 0 elsewhere.
void form_residual(const double* p, const double* u, const double* h, const double* s,
                   double approach, float* r, float* contact, std::size_t n);
void form_residual(const double* p, const double* u, const double* h, const double* s,
                   double approach, double* r, double* contact, std::size_t n);

/// Sums over C from which the load of z, the coefficient beta and the error follow.
struct CorrectionSums {
  double s_s = 0.0;
  double s_z = 0.0;
  double s_r = 0.0;
  double s_old_r = 0.0;
  double z_r = 0.0;
  double z_old_r = 0.0;
  double s_v = 0.0;
  double least_z = 0.0;
  double largest_z = 0.0;
};

/// Sets z to 0 outside C.
CorrectionSums sum_correction(float* z, const float* r, const float* old_r, const float* v,
                              const float* contact, const double* s, std::size_t n);
CorrectionSums sum_correction(double* z, const double* r, const double* old_r, const double* v,
                              const double* contact, const double* s, std::size_t n);

/// v = z + beta v - shift s on C.
void form_direction(const float* z, float* v, const float* contact, const double* s, double beta,
                    double shift, std::size_t n);
void form_direction(const double* z, double* v, const double* contact, const double* s, double beta,
                    double shift, std::size_t n);

/// <r, v> and <v, q>.
struct StepSums {
  double r_v;
  double v_q;
};
StepSums sum_step(const float* r, const float* v, const float* q, std::size_t n);
StepSums sum_step(const double* r, const double* v, const double* q, std::size_t n);

/// What a joint step (joint_step.hpp) needs of one box.
struct JointStepSums {
  double v_q;
  double p_q;
  double p_u;
  double r_v;
  double r_p;
  double v;
  double p;
  double s_v;
  double s_p;
};
JointStepSums sum_joint_step(const double* p, const double* u, const float* r, const float* v,
                             const float* q, const double* s, std::size_t n);
JointStepSums sum_joint_step(const double* p, const double* u, const double* r, const double* v,
                             const double* q, const double* s, std::size_t n);

struct MoveSums {
  double load = 0.0; ///< sum s p of the positive ones
  double largest = 0.0;
  double largest_change = 0.0;
  double negative_count = 0.0;
};
/// p += step v, u += step q.
MoveSums move(double* p, double* u, const float* v, const float* q, const double* s, double step,
              std::size_t n);
MoveSums move(double* p, double* u, const double* v, const double* q, const double* s, double step,
              std::size_t n);

/// What p has changed by, when it is cut at 0 after the step: step v + max(0, -p).
void form_change(const double* p, const float* v, double step, float* change, std::size_t n);
void form_change(const double* p, const double* v, double step, double* change, std::size_t n);

/// u -= sum_k pressures[k] kernels[k] in a row of n elements, each kernel starting at its first
/// element. `sum` is for scratch.
void take_out(double* u, float* sum, const float* const* kernels, const float* pressures,
              std::size_t cuts, std::size_t n);
void take_out(double* u, double* sum, const double* const* kernels, const double* pressures,
              std::size_t cuts, std::size_t n);

} // namespace wrc
