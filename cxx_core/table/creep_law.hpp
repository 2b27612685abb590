/// Creep forces of an elliptic contact by the full theory, as a table.
///
/// With the linear forces over mu N that the creepages xi, eta and the spin phi have without slip,
///   fx = C11 G c^2 xi/(mu N),  fy = C22 G c^2 eta/(mu N),  fp = C23 G c^3 phi/(mu N),
/// Fx, Fy over mu N and Mz over c mu N depend on these and on a/b alone (c^2 = a b; Poisson's ratio
/// is fixed). All creepages, up to full slip, are a box of the coordinates
///   R^2 = 1 + fp^2,  v = (fx, fy)/R,  g = v/(k + |v|^2/4)^(1/2),  m = (2/pi) atan (q fp), ln(a/b),
/// whose scales k and q (constants.hpp) bring the nodes together at rest, where slopes turn.
/// A spline over them has what the forces differ by from the cubic of Vermeulen and Johnson, which
/// has their kink at rest: for t = |(fx, fy + fp)| < 3
///   F = (t - t^2/3 + t^3/27) along the linear force, else 1.
/// A patch that is no ellipse is put in with linear forces of its own; errors are those of
/// docs/table.md.
/// Frame and signs of rolling/rolling_problem.hpp. Thread rule: `forces` is pure and allocates
/// nothing.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/value_with_rates.hpp"
#include "base/worker_threads.hpp"
#include "table/constants.hpp"
#include "table/tensor_spline.hpp"

namespace wrc {

/// What a law is made with.
struct CreepLawNodes {
  std::size_t translation = 29; ///< of g in each direction; odd
  std::size_t spin = 29;        ///< of m; odd
  std::size_t ratio = 9;        ///< of ln(a/b)
  std::size_t elements = 32;    ///< along and across the ellipse
};

class CreepLaw {
public:
  using Spline = TensorSpline<4, 4, float>; // Fx, Fy, Mz, nothing

  CreepLaw() = default;
  explicit CreepLaw(Spline spline) : spline_(std::move(spline)) {}
  static CreepLaw make(double poisson, const CreepLawNodes& nodes, int threads,
                       const Progress& progress);
  static Spline::Axes axes_of(const CreepLawNodes& nodes);

  /// Fx, Fy, Mz as above.
  template <class Real>
  WRC_VECTOR_BODY std::array<Real, 3> forces(const Real& fx, const Real& fy, const Real& fp,
                                             const Real& log_ratio) const {
    using std::atan, std::sqrt;
    const Real root = sqrt(Real(1.0) + fp * fp);
    const Real vx = fx / root;
    const Real vy = fy / root;
    const Real length = sqrt(Real(law_slip_scale) + Real(0.25) * (vx * vx + vy * vy));
    const std::array<Real, 4> place{vx / length, vy / length,
                                    Real(2.0 / std::numbers::pi) * atan(Real(law_spin_scale) * fp),
                                    log_ratio};
    Spline::Values found;
    spline_.evaluate(
        {value_of(place[0]), value_of(place[1]), value_of(place[2]), value_of(place[3])}, found);
    std::array<Real, 3> forces;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      forces[i] = part_of(found, i, place);
    }
    const Real factor = cubic_factor(fx, fy + fp);
    forces[0] = forces[0] - factor * fx;
    forces[1] = forces[1] - factor * (fy + fp);
    return forces;
  }

  /// F over t of the cubic.
  template <class Real>
  WRC_VECTOR_BODY static Real cubic_factor(const Real& along, const Real& across) {
    using std::sqrt;
    const Real t = sqrt(along * along + across * across);
    return t < Real(3.0) ? Real(1.0) - t * (Real(1.0 / 3.0) - t * Real(1.0 / 27.0)) : Real(1.0) / t;
  }

  [[nodiscard]] const Spline& spline() const { return spline_; }

private:
  Spline spline_;
};

} // namespace wrc
