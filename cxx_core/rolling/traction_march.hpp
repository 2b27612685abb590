/// A march from the leading edge that nearly inverts the tangential influence of a row: the
/// preconditioner of the linear solutions.
///
/// Along x the symbol of -d/dx A is (1 - E)/|k|, that of A is 1/|k|; with |k| replaced by
/// sqrt(kx^2 + (decay/b)^2), b half the contact's width, and split in two factors as by Wiener and
/// Hopf,
///   1/|k| ~ (1 - rho E)^-1/2 (1 - rho/E)^-1/2,  E: one element upstream, rho = exp(-decay hx/b).
/// The downstream factor is inverted by a sweep from the trailing edge, the upstream one by a march
/// from the leading edge that knows whether each element sticks or slips:
///   y = (1 - rho/E)^1/2 r,   z_i = M_i (y_i - D sum_{m >= 1} l_m z_{i-m}),
///   l(E) = (1 - k E)(1 - rho E)^-1/2,  k = 1 in rolling, 0 in a shift, between them in a step.
/// The fractional power is a mean of exponentials (Gauss-Chebyshev):
///   (1 - rho E)^-1/2 = mean_k 1/(1 - rho t_k E),  t_k = cos^2((2k - 1) pi/(4 K)),
/// so that an element costs the same on any grid. Kalker's FASTSIM is the limit of large decay.
#pragma once

#include <array>
#include <cstddef>

#include "half_space/fft.hpp"
#include "rolling/constants.hpp"
#include "rolling/traction_loops.hpp"

namespace wrc {

template <typename Real> class TractionMarch {
public:
  TractionMarch() = default;
  /// `step_over_width`: element length along x over half the contact's width.
  /// `upstream`: k.
  TractionMarch(std::size_t rows, std::size_t pitch, double step_over_width, double upstream);

  /// What the march's diagonal is for a self-influence of 1.
  [[nodiscard]] double diagonal() const { return diagonal_; }
  /// z from r, both of 2 rows pitch values.
  void apply(const LinearisedElements<Real>& elements, const ElementScales& scales, const Real* r,
             Real* z);

private:
  std::size_t rows_ = 0;
  std::size_t pitch_ = 0;
  double diagonal_ = 1.0;
  Real decay_ = 0;                           ///< rho
  std::array<Real, march_terms> factors_{};  ///< rho t_k
  std::array<Real, march_terms> memories_{}; ///< their weight in l, over the number of terms
  AlignedArray<Real> state_;
};

} // namespace wrc
