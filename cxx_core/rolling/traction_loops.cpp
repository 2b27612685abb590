#include "rolling/traction_loops.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector_clones.hpp"
#include "rolling/constants.hpp"

namespace wrc {

namespace {

/// q - r s of one element, cut onto its bound.
template <typename Real> struct Cut {
  Real x, y;     ///< cut
  Real nx, ny;   ///< direction of q - r s
  Real excess;   ///< |q - r s| - g
  bool slipping; ///< excess > 0
};

template <typename Real>
WRC_VECTOR_BODY Cut<Real> cut_of(Real qx, Real qy, Real sx, Real sy, Real g, Real r) {
  const Real dx = qx - r * sx;
  const Real dy = qy - r * sy;
  const Real length = std::sqrt(dx * dx + dy * dy);
  const Real inverse = length > Real{0} ? Real{1} / length : Real{0};
  Cut<Real> cut;
  cut.nx = dx * inverse;
  cut.ny = dy * inverse;
  cut.excess = length - g;
  cut.slipping = cut.excess > Real{0};
  cut.x = cut.slipping ? g * cut.nx : dx;
  cut.y = cut.slipping ? g * cut.ny : dy;
  return cut;
}

/// r of an element whose edge adds to its influence on itself.
template <typename Real> WRC_VECTOR_BODY Real step_at(Real inverse_r, Real edge) {
  return Real{1} / (inverse_r + Real(1.0 / natural_step) * edge);
}

/// Factor that brings a vector of this square within the bound.
template <typename Real> WRC_VECTOR_BODY Real factor_within(Real square, Real g) {
  return square > g * g ? g / std::sqrt(square) : Real{1};
}

template <typename Real>
WRC_VECTOR_BODY ResidualSums residual_body(const Real* q, const Real* s, const Real* g,
                                           const Real* edge, Real inverse_r, std::size_t n) {
  double change = 0.0;
  double size = 0.0;
#pragma omp simd reduction(+ : change, size)
  for (std::size_t i = 0; i < n; ++i) {
    const Cut<Real> cut =
        cut_of(q[i], q[n + i], s[i], s[n + i], g[i], step_at(inverse_r, edge[n + i]));
    const Real x = q[i] - cut.x;
    const Real y = q[n + i] - cut.y;
    const bool inside = g[i] > Real{0};
    change += inside ? std::sqrt(x * x + y * y) : Real{0};
    size += inside ? std::sqrt(cut.x * cut.x + cut.y * cut.y) : Real{0};
  }
  return {change, size};
}

template <typename Real>
WRC_VECTOR_BODY void linearise_body(const Real* q, const Real* s, const Real* g, const Real* edge,
                                    const ElementScales& scales, const LinearisedElements<Real>& at,
                                    Real* change, std::size_t n) {
  const auto inverse_r = static_cast<Real>(1.0 / scales.step);
  const auto damping = static_cast<Real>(scales.damping);
  const auto diagonal_x = static_cast<Real>(scales.diagonal_x);
  const auto diagonal_y = static_cast<Real>(scales.diagonal_y);
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const Real bound = g[i];
    const Real dx = diagonal_x + edge[i];
    const Real dy = diagonal_y + edge[n + i];
    const Real r = step_at(inverse_r, edge[n + i]);
    const Real qx = q[i];
    const Real qy = q[n + i];
    const Cut<Real> cut = cut_of(qx, qy, s[i], s[n + i], bound, r);
    const bool inside = bound > Real{0};
    const bool slips = cut.slipping;
    const Real tx = -cut.ny;
    const Real ty = cut.nx;
    const Real sticks = slips ? Real{0} : Real{1};
    const Real exists = inside ? Real{1} : Real{0};
    at.projector_xx[i] = exists * (slips ? tx * tx : Real{1});
    at.projector_yy[i] = exists * (slips ? ty * ty : Real{1});
    at.projector_xy[i] = exists * (slips ? tx * ty : Real{0});
    const Real ratio = damping + (slips ? cut.excess / r / (inside ? bound : Real{1}) : Real{0});
    at.ratio[i] = exists * ratio;
    const Real along = exists / (tx * tx * dx + ty * ty * dy + ratio + sticks * dx);
    at.inverse_xx[i] = slips ? tx * tx * along : exists / (dx + ratio);
    at.inverse_yy[i] = slips ? ty * ty * along : exists / (dy + ratio);
    at.inverse_xy[i] = slips ? tx * ty * along : Real{0};
    const Real within = factor_within(qx * qx + qy * qy, bound);
    change[i] = inside ? (slips ? cut.x : within * qx) - qx : -qx;
    change[n + i] = inside ? (slips ? cut.y : within * qy) - qy : -qy;
  }
}

template <typename Real>
WRC_VECTOR_BODY void project_body(const LinearisedElements<Real>& at, const Real* in, const Real* z,
                                  Real* out, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const Real x = in[i];
    const Real y = in[n + i];
    out[i] = at.projector_xx[i] * x + at.projector_xy[i] * y + at.ratio[i] * z[i];
    out[n + i] = at.projector_xy[i] * x + at.projector_yy[i] * y + at.ratio[i] * z[n + i];
  }
}

template <typename Real>
WRC_VECTOR_BODY void edges_body(const Real* edge, const Real* z, Real* out, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < 2 * n; ++i) {
    out[i] += edge[i] * z[i];
  }
}

template <typename Real>
WRC_VECTOR_BODY void cut_body(Real* q, const Real* s, const Real* g, const Real* edge,
                              Real inverse_r, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const Cut<Real> cut =
        cut_of(q[i], q[n + i], s[i], s[n + i], g[i], step_at(inverse_r, edge[n + i]));
    const Real within = factor_within(q[i] * q[i] + q[n + i] * q[n + i], g[i]);
    q[i] = cut.slipping ? cut.x : within * q[i];
    q[n + i] = cut.slipping ? cut.y : within * q[n + i];
  }
}

} // namespace

// Both precisions of each loop: the attribute does not work on templates themselves.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define TRACTION_LOOPS(Real)                                                                       \
  template <>                                                                                      \
  WRC_VECTOR_CLONES ResidualSums natural_residual(const Real* q, const Real* s, const Real* g,     \
                                                  const Real* edge, double step, std::size_t n) {  \
    return residual_body(q, s, g, edge, static_cast<Real>(1.0 / step), n);                         \
  }                                                                                                \
  template <>                                                                                      \
  WRC_VECTOR_CLONES void linearise(                                                                \
      const Real* q, const Real* s, const Real* g, const Real* edge, const ElementScales& scales,  \
      const LinearisedElements<Real>& elements, Real* change, std::size_t n) {                     \
    linearise_body(q, s, g, edge, scales, elements, change, n);                                    \
  }                                                                                                \
  template <>                                                                                      \
  WRC_VECTOR_CLONES void project(const LinearisedElements<Real>& elements, const Real* in,         \
                                 const Real* z, Real* out, std::size_t n) {                        \
    project_body(elements, in, z, out, n);                                                         \
  }                                                                                                \
  template <>                                                                                      \
  WRC_VECTOR_CLONES void add_edges(const Real* edge, const Real* z, Real* out, std::size_t n) {    \
    edges_body(edge, z, out, n);                                                                   \
  }                                                                                                \
  template <>                                                                                      \
  WRC_VECTOR_CLONES void cut_to_bound(Real* q, const Real* s, const Real* g, const Real* edge,     \
                                      double step, std::size_t n) {                                \
    cut_body(q, s, g, edge, static_cast<Real>(1.0 / step), n);                                     \
  }

TRACTION_LOOPS(float)
TRACTION_LOOPS(double)
#undef TRACTION_LOOPS
// NOLINTEND(bugprone-macro-parentheses)

} // namespace wrc
