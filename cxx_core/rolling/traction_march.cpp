#include "rolling/traction_march.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector_clones.hpp"

namespace wrc {

namespace {

template <typename Real> struct MarchTerms {
  Real rho;
  std::array<Real, march_terms> factors;
  std::array<Real, march_terms> memories;
};

/// One row of y = (1 - rho/E)^1/2 r = (1 - rho/E) (1 - rho/E)^-1/2 r, from the row behind it.
template <typename Real>
WRC_VECTOR_BODY void sweep_row(const MarchTerms<Real>& terms, const Real* r, Real* state,
                               Real* behind, Real* y, std::size_t pitch) {
#pragma omp simd
  for (std::size_t j = 0; j < pitch; ++j) {
    Real sum = 0;
    for (std::size_t k = 0; k < march_terms; ++k) {
      const Real memory = terms.factors[k] * state[k * pitch + j] + r[j];
      state[k * pitch + j] = memory;
      sum += memory;
    }
    const Real root = sum * (Real{1} / static_cast<Real>(march_terms));
    y[j] = root - terms.rho * behind[j];
    behind[j] = root;
  }
}

template <typename Real>
WRC_VECTOR_BODY void march_row(const MarchTerms<Real>& terms, const LinearisedElements<Real>& at,
                               std::size_t first, Real dx, Real dy, Real* state_x, Real* state_y,
                               Real* zx, Real* zy, std::size_t pitch) {
#pragma omp simd
  for (std::size_t j = 0; j < pitch; ++j) {
    Real x = 0;
    Real y = 0;
    for (std::size_t k = 0; k < march_terms; ++k) {
      x += terms.memories[k] * state_x[k * pitch + j];
      y += terms.memories[k] * state_y[k * pitch + j];
    }
    const std::size_t i = first + j;
    x = zx[j] - dx * x;
    y = zy[j] - dy * y;
    const Real out_x = at.inverse_xx[i] * x + at.inverse_xy[i] * y;
    const Real out_y = at.inverse_xy[i] * x + at.inverse_yy[i] * y;
    zx[j] = out_x;
    zy[j] = out_y;
    for (std::size_t k = 0; k < march_terms; ++k) {
      state_x[k * pitch + j] = terms.factors[k] * state_x[k * pitch + j] + out_x;
      state_y[k * pitch + j] = terms.factors[k] * state_y[k * pitch + j] + out_y;
    }
  }
}

template <typename Real>
WRC_VECTOR_BODY void march_body(const MarchTerms<Real>& terms, const LinearisedElements<Real>& at,
                                Real dx, Real dy, const Real* r, Real* z, Real* state,
                                std::size_t rows, std::size_t pitch) {
  const std::size_t count = rows * pitch;
  Real* state_x = state;
  Real* state_y = state + march_terms * pitch;
  Real* behind = state + 2 * march_terms * pitch;
  std::fill_n(state, (2 * march_terms + 2) * pitch, Real{0});
  for (std::size_t i = rows; i-- > 0;) {
    sweep_row(terms, r + i * pitch, state_x, behind, z + i * pitch, pitch);
    sweep_row(terms, r + count + i * pitch, state_y, behind + pitch, z + count + i * pitch, pitch);
  }
  std::fill_n(state, 2 * march_terms * pitch, Real{0});
  for (std::size_t i = 0; i < rows; ++i) {
    march_row(terms, at, i * pitch, dx, dy, state_x, state_y, z + i * pitch, z + count + i * pitch,
              pitch);
  }
}

WRC_VECTOR_CLONES void march(const MarchTerms<float>& terms, const LinearisedElements<float>& at,
                             float dx, float dy, const float* r, float* z, float* state,
                             std::size_t rows, std::size_t pitch) {
  march_body(terms, at, dx, dy, r, z, state, rows, pitch);
}
WRC_VECTOR_CLONES void march(const MarchTerms<double>& terms, const LinearisedElements<double>& at,
                             double dx, double dy, const double* r, double* z, double* state,
                             std::size_t rows, std::size_t pitch) {
  march_body(terms, at, dx, dy, r, z, state, rows, pitch);
}

} // namespace

template <typename Real>
TractionMarch<Real>::TractionMarch(std::size_t rows, std::size_t pitch, double step_over_width,
                                   double upstream)
    : rows_(rows), pitch_(pitch), state_((2 * march_terms + 2) * pitch) {
  const double rho = std::exp(-march_decay * step_over_width);
  decay_ = static_cast<Real>(rho);
  for (std::size_t k = 0; k < march_terms; ++k) {
    const double root = std::cos((2.0 * static_cast<double>(k) + 1.0) * std::numbers::pi /
                                 (4.0 * static_cast<double>(march_terms)));
    const double factor = rho * root * root;
    factors_[k] = static_cast<Real>(factor);
    memories_[k] = static_cast<Real>((factor - upstream) / static_cast<double>(march_terms));
  }
  // The product of both factors has sum_m l_m f_m on its diagonal.
  double diagonal = 1.0;
  double f = 1.0;
  for (std::size_t m = 1; m < rows; ++m) {
    const double before = f;
    f *= rho * (static_cast<double>(m) - 0.5) / static_cast<double>(m);
    diagonal += (f - upstream * before) * f;
  }
  diagonal_ = march_scale / diagonal;
}

template <typename Real>
void TractionMarch<Real>::apply(const LinearisedElements<Real>& elements,
                                const ElementScales& scales, const Real* r, Real* z) {
  march(MarchTerms<Real>{decay_, factors_, memories_}, elements,
        static_cast<Real>(scales.diagonal_x), static_cast<Real>(scales.diagonal_y), r, z,
        state_.data(), rows_, pitch_);
}

template class TractionMarch<float>;
template class TractionMarch<double>;

} // namespace wrc
