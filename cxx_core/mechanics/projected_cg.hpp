/// Projected, preconditioned conjugate gradients for contact on rectangles of elements, one or
/// several that share one approach.
///
/// Find p >= 0 with r = s approach - h - K p <= 0, p r = 0 on every box k, and the load,
/// sum_k w_k sum s p, given, or the approach given. s and w_k: each element's share of the approach
/// and the box's weight in the energy, both in the box's own unit of length. Each iteration, with
/// one application of K:
///   contact C = {p > 0 or r > 0}
///   approach: least squares of r over p > 0 (if the load is given)
///   z = M r on C, M the inverse of the periodic convolution on each rectangle
///   v = z + beta_k v, beta_k = max(0, <z, r - r_old>_k / <z_old, r_old>_k) (Polak & Ribiere), on C
///   p = max(0, (1 + gamma_k) p + alpha_k v), and what this cut off is added to u directly
/// with <a, b>_k = sum a b over box k. One box: gamma = 0, alpha = <r, v>/<v, K v>; several: both
/// for each box by joint_step.hpp. With the load given, z and v carry none in sum over the boxes (a
/// multiple of s on C is taken off), which keeps the load inside the iteration, and p and u are
/// scaled to it after the cut. No gamma goes beyond -0.5 and 1: all go the same part of the way
/// then. Where z leads to no less energy, which happens far from the answer, r replaces it. The
/// method is that of Vollebregt (J. Comput. Phys. 257, 2014, bound-constrained CG with FFT
/// preconditioner) with the load constraint taken in and the boxes joined.
///
/// z approximates the error of p; iteration stops at max|z| <= tolerance max p and takes one free
/// step p = max(0, p + z).
///
/// With coupling (patch_coupling.hpp), what boxes displace at each other is kept at their nodes and
/// counts as part of h: loads there are followed through steps, cuts and scaling, and the change of
/// displacement is interpolated to the elements, once an iteration.
///
/// In units of influence_cache.hpp. Directions are kept in `Real`; p and u always in double. u is
/// carried along, and recomputed when its accumulated rounding could matter, so `float` reaches
/// any tolerance that double does.
/// Thread rule: one object serves one thread at a time.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/iteration_box.hpp"
#include "mechanics/joint_step.hpp"
#include "mechanics/normal_contact.hpp"
#include "mechanics/patch_coupling.hpp"
#include "mechanics/projected_cg_loops.hpp"

namespace wrc {

struct IterationRequest {
  std::span<const IterationBox> boxes;
  std::optional<double> load;  ///< sum of w s p; or else
  double approach = 0.0;       ///< the approach
  double tolerance = 1e-4;     ///< of max|z|, relative to the largest pressure
  double rounding_share = 0.1; ///< of the tolerance: what rounding may take
  int maximum_iterations = 5000;
  PatchCoupling* coupling = nullptr;
};

struct IterationOutcome {
  double approach = 0.0;
  double largest_pressure = 0.0;
  double error = 0.0; ///< max|z| / max p before the free step
  int iterations = 0;
  int convolutions = 0;
  /// By box. If any: the pressures are those of before the iteration ended.
  std::vector<ReachedSides> reached;
  bool reached_any = false;
  StopReason stop_reason = StopReason::iteration_limit;
};

/// Everything the iteration needs, kept between calls.
template <typename Real> class ProjectedCg {
public:
  explicit ProjectedCg(InfluenceCache& cache) : cache_(cache) {}

  IterationOutcome solve(const IterationRequest& request);

  ConvolutionWorkspace<Real>& workspace() { return workspace_; }

private:
  using Fields = BoxFields<Real>;
  static constexpr bool is_single = sizeof(Real) < sizeof(double);

  struct Progress {
    IterationOutcome outcome;
    double drift_rate = 0.0;      ///< relative error of p by rounding in u
    double least_drift = 0.0;     ///< the same for u computed in double precision
    double permitted_drift = 0.0; ///< what of it may stay
    double rounding =
        0.0;            ///< as a pressure: pressures may fall by orders of magnitude, it does not
    double drift = 0.0; ///< relative to the largest pressure
    double best_error = std::numeric_limits<double>::infinity();
    int best_iteration = 0;
    int idle = 0; ///< iterations without a step, one after the other

    [[nodiscard]] bool met(double tolerance) const { return outcome.error <= tolerance; }
    [[nodiscard]] bool stuck() const;
  };
  /// Over contact, 0 without a load to keep.
  struct Correction {
    double z_mean = 0.0;   ///< the multiple of s that carries the load of z
    double contacts = 0.0; ///< sum w s^2
  };

  void prepare(const IterationBox& box, Fields& fields);
  void refresh_displacement(bool in_double);
  void respond();
  void choose_steps();
  void add_coupled_energies();
  void gather_change(std::size_t k);
  void advance_coupling();
  Progress begin();
  void update_approach(Progress& progress);
  void form_residuals(IterationOutcome& outcome);
  /// z = M r on contact, and the error that it shows.
  Correction precondition(Progress& progress);
  /// Whether u was recomputed because its rounding may hide the remaining error.
  bool refreshed(Progress& progress);
  void choose_directions(const Correction& correction, bool steepest);
  void move_pressures(Progress& progress);
  void final_correction(double z_mean);

  /// Over contact; 0 without a load to keep.
  [[nodiscard]] double mean_over(double contacts, double sum) const {
    return request_->load && contacts > 0.0 ? sum / contacts : 0.0;
  }
  /// h of a box, and with coupling what the other boxes displace there.
  [[nodiscard]] const double* distance_of(std::size_t k) const {
    return request_->coupling != nullptr ? fields_[k]->distance.data()
                                         : request_->boxes[k].distance.data();
  }

  InfluenceCache& cache_;
  ConvolutionWorkspace<Real> workspace_;
  ConvolutionWorkspace<double> double_workspace_;
  std::vector<std::unique_ptr<Fields>> fields_; ///< at least one per box
  const IterationRequest* request_ = nullptr;
  std::vector<CorrectionSums> sums_; ///< by box
  JointStep joint_step_;
  std::vector<JointStepSums> step_sums_; ///< by box
  // With coupling: at the nodes.
  NodeField pressure_nodes_;
  NodeLoads load_change_; ///< in a step, before pressures are scaled
  std::vector<double> node_change_;
  std::vector<std::vector<double>> others_; ///< by box: displacement of its nodes by all others
  int convolutions_ = 0;
};

} // namespace wrc
