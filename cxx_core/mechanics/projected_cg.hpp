/// Projected, preconditioned conjugate gradients for contact on one rectangle of elements.
///
/// Find p >= 0 with r = approach - h - K p <= 0, p r = 0, and sum p given, or the approach given.
/// Each iteration, with one application of K:
///   contact C = {p > 0 or r > 0};  approach = mean of h + u over p > 0 (if the load is given)
///   z = M r on C, M the inverse of the periodic convolution on the rectangle
///   v = z + beta v, beta = max(0, <z, r - r_old> / <z_old, r_old>) (Polak & Ribiere), on C
///   step <r, v>/<v, K v>;  p = max(0, p + step v), and what this cut off is added to u directly
/// With the load given z and v are mean-free over C, which keeps the load inside the iteration, and
/// p and u are scaled to it after the cut. The method is that of Vollebregt (J. Comput. Phys. 257,
/// 2014, bound-constrained CG with FFT preconditioner) with the load constraint taken in.
/// z approximates the error of p; iteration stops at max|z| <= tolerance max p and takes one free
/// step p = max(0, p + z).
/// In units of influence_cache.hpp. Directions are kept in `Real`; p and u always in double. u is
/// carried along, and computed anew when its accumulated rounding could matter, so `float` reaches
/// any tolerance that double does.
/// Thread rule: one object serves one thread at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "mechanics/box_convolution.hpp"
#include "mechanics/normal_contact.hpp"

namespace wrc {

/// What is asked of the pressures on a rectangle.
struct BoxRequest {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double aspect = 1.0;
  std::optional<double> pressure_sum; ///< the load in element areas; or else
  double approach = 0.0;              ///< the approach
  double tolerance = 1e-4;            ///< of max|z|, relative to the largest pressure
  int maximum_iterations = 5000;
  /// Which sides of the rectangle have elements of the grid beyond them: contact there ends the
  /// iteration, since the rectangle is too small.
  bool open_first_row = false;
  bool open_last_row = false;
  bool open_first_column = false;
  bool open_last_column = false;
};

struct BoxOutcome {
  double approach = 0.0;
  double largest_pressure = 0.0;
  double largest_displacement = 0.0;
  double error = 0.0; ///< max|z| / max p before the free step
  int iterations = 0;
  /// Contact came up at these open sides; the pressures are those of before the iteration ended.
  bool reached_first_row = false;
  bool reached_last_row = false;
  bool reached_first_column = false;
  bool reached_last_column = false;
  [[nodiscard]] bool reached_edge() const {
    return reached_first_row || reached_last_row || reached_first_column || reached_last_column;
  }
  StopReason stop_reason = StopReason::iteration_limit;
};

/// Everything a rectangle's iteration needs, kept between calls.
template <typename Real> class BoxIteration {
public:
  explicit BoxIteration(InfluenceCache& cache) : cache_(cache) {}

  /// `pressure` (start in, answer out) and `distance`: rows * columns values.
  BoxOutcome solve(const BoxRequest& request, std::span<double> pressure,
                   std::span<const double> distance);

  ConvolutionWorkspace<Real>& workspace() { return workspace_; }

private:
  struct Sums;
  void refresh_displacement(bool in_double);
  void cut_negative(std::size_t negative_count);
  /// Notes the open sides that contact has reached; whether there are any.
  bool note_reached_sides(BoxOutcome& outcome) const;
  void take_free_step(double z_mean);

  InfluenceCache& cache_;
  ConvolutionWorkspace<Real> workspace_;
  ConvolutionWorkspace<double> double_workspace_;
  BoxConvolution<Real> convolution_;
  BoxConvolution<Real> preconditioner_;
  const BoxRequest* request_ = nullptr;
  std::size_t count_ = 0;
  double* pressure_ = nullptr;
  const double* distance_ = nullptr;
  AlignedArray<double> displacement_;
  AlignedArray<Real> residual_;
  AlignedArray<Real> last_residual_;
  AlignedArray<Real> correction_; ///< z
  AlignedArray<Real> direction_;  ///< v
  AlignedArray<Real> response_;   ///< K v; also the input of a fresh u = K p
  AlignedArray<Real> contact_;    ///< 1 on C, 0 elsewhere
};

} // namespace wrc
