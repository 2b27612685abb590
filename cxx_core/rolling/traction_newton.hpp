/// Semi-smooth Newton for the tangential problem on one grid.
///
/// The linearised equations (traction_loops.hpp) are solved by GMRES (Saad & Schultz 1986), right
/// preconditioned by the march (traction_march.hpp), one convolution a step; the step of Newton
/// itself costs none, since the displacements of its parts are known. Safeguards: a step that lets
/// the residual grow is halved (slips are affine in the tractions), stagnation raises the diagonal,
/// the number of steps is limited, the best tractions are returned.
/// Scaled: tractions over the largest bound, slips times G over it, lengths in longitudinal steps.
/// Fields: rows of constant x from the leading edge, `pitch` values each; the x components of all
/// elements come first, then the y components.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "half_space/traction_convolution.hpp"
#include "rolling/scaled_tractions.hpp"
#include "rolling/traction_loops.hpp"
#include "rolling/traction_march.hpp"

namespace wrc {

/// One grid of the cascade.
struct TractionGrid {
  TractionShape shape;
  double step_over_width = 0.0; ///< longitudinal step over half the contact's width
  std::vector<double> angles{}; ///< of columns along a curve, rad; none: a plane
};

struct NewtonLimits {
  double tolerance = 1e-3;
  int iterations = 30;
};

struct NewtonOutcome {
  int iterations = 0;
  int convolutions = 0;
  double residual = 0.0;
  bool converged = false;
};

template <typename Real> class TractionNewton {
public:
  TractionNewton(const TractionGrid& grid, double poisson, const SlipDifferenceWeights& difference,
                 const TractionTable& table, LinePlans& plans);

  [[nodiscard]] const TractionShape& shape() const { return shape_; }
  [[nodiscard]] std::size_t pitch() const { return pitch_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] double upstream() const { return upstream_; }
  /// The bound g of each element; 0 outside the contact and beyond the columns.
  [[nodiscard]] Real* bound() { return fields_.data(); }
  /// What a leading edge within the element adds to its influence on itself, in x and in y
  /// (leading_edge.hpp); 0 to begin with.
  [[nodiscard]] Real* edge() { return fields_.data() + count_; }
  /// The rigid slip; kept.
  [[nodiscard]] Real* rigid_slip() { return vector(rigid); }
  /// The tractions: where the solution starts, and the solution.
  [[nodiscard]] Real* traction() { return vector(tractions); }
  /// Slips of the solution, before its last cut to the bound.
  [[nodiscard]] const Real* slip() { return vector(slips); }

  NewtonOutcome solve(const NewtonLimits& limits);
  /// How the tractions of the solution change with the rigid slip, for a rate of it: the equations
  /// as linearised at the solution, to this relative accuracy. The same layout as tractions; valid
  /// until the next call.
  const Real* solve_rate(const Real* slip_rate, double relative_tolerance);
  /// What tractions displace; fields of two components.
  void convolve(const Real* in, Real* out);

private:
  /// Fields of two components, behind bound and edge's two.
  enum Vector : std::size_t {
    rigid,
    tractions,
    slips,
    changes, ///< that bring tractions to their bound
    right_side,
    steps,
    step_slips,
    best_tractions,
    best_slips,
    vector_count
  };
  [[nodiscard]] Real* vector(Vector which) { return fields_.data() + (3 + 2 * which) * count_; }
  [[nodiscard]] double residual_of(const Real* q, const Real* s) const;
  void solve_linear(double relative_tolerance, Real* step, Real* step_slip);
  void take_step(double residual, const Real* step, const Real* step_slip);

  TractionShape shape_;
  double upstream_; ///< of SlipDifferenceWeights
  std::size_t pitch_;
  std::size_t count_;
  TractionConvolution<Real> convolution_;
  TractionMarch<Real> march_;
  ElementScales scales_;
  double self_influence_;
  AlignedArray<Real> fields_;
  std::vector<AlignedArray<Real>> krylov_;     ///< orthonormal residuals
  std::vector<AlignedArray<Real>> directions_; ///< preconditioned, and what they displace
  LinearisedElements<Real> elements_;
  ConvolutionWorkspace<Real> workspace_;
  int convolutions_ = 0;
};

} // namespace wrc
