/// Tangential displacements under tangential tractions, and their differences along the rolling
/// direction, as one convolution.
///
///   (B q)(x) = sum_m c_m u(x + m h),  m = -1 ... 2,   u = A q
/// with A the displacements of one half-space relative to the other (Cerruti; Johnson, Contact
/// Mechanics, 1985, eq. 3.91), element by element of constant traction. The weights c are taken
/// into the coefficients: no other code depends on the difference. Both components go through one
/// complex transform (z = q_x + i q_y):
///   S(k) = al(k) Z(k) + be(k) conj Z(-k),  al = (K_xx + K_yy)/2,  be = (K_xx - K_yy)/2 + i K_xy.
/// A column of wave number k_y is transformed with one sign of the exponent and that of -k_y with
/// the other, so that Z(k) and conj Z(-k) have the same index.
/// Fields: rows of constant x, counted from the leading edge downstream, each with the lateral
/// index running fastest; `pitch` values from row to row. Units: lengths in longitudinal steps,
/// tractions in units of the combined shear modulus G, 1/G = (1/G1 + 1/G2)/2; nu/G likewise.
/// Columns of a patch that is not plane lie along a curve across the rail, column j at the
/// inclination a_j (box_convolution.hpp). Lateral tractions act along their own column, and with
/// A_nn the coefficients of pressures, A_ss and A_ns those of lateral ones and
///   m = (A_ss + A_nn)/2,
/// the elements i and j influence each other by
///   B_ss = cos(a_i - a_j) m + (A_ss - A_nn)/2,  B_sn = sin(a_i - a_j) m = -B_ns,
///   B_xn = sin((a_i - a_j)/2) A_xs = -B_nx,
/// so that work is reciprocal: B_sn(i, j) = B_ns(j, i), B_xn(i, j) = B_nx(j, i) (the split and
/// symmetric one of the variants of Blanco-Lorenzo et al., 2016). These follow from the half-space
/// along the tangent midway between both normals. A_xx stays as in a plane, and so does A_xs, which
/// loses its product with 1 - cos((a_i - a_j)/2) by that. What couples with the normal is in
/// rolling/curve_displacement.hpp.
/// A second kind of coefficients, (x, y)/(pi r^2), serves what unlike bodies displace across
/// (CrossTable): from a pressure instead of q_x both components, and from tractions, as the first
/// component, the normal one. Does not include friction. Thread rule: as BoxConvolution.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "half_space/box_convolution.hpp"
#include "half_space/constants.hpp"
#include "half_space/fft.hpp"
#include "half_space/influence_cache.hpp"
#include "half_space/influence_coefficients.hpp"

namespace wrc {

/// c_m at index m + 1.
using DifferenceWeights = std::array<double, 4>;

/// A grid of elements as the convolution sees it.
struct TractionShape {
  std::size_t rows = 0;    ///< elements along the rolling direction
  std::size_t columns = 0; ///< elements across
  [[nodiscard]] std::size_t table_rows() const { return columns; }
  [[nodiscard]] std::size_t table_columns() const { return rows + difference_reach; }
};

class WeightedCoefficients;

/// Of the coefficients along a curve.
enum class TractionPart {
  plane,  ///< all of a plane
  fixed,  ///< B_xx, A_xs and (A_ss - A_nn)/2, which do not turn with the columns
  turned, ///< m, in both components
  mixed   ///< A_xs alone
};

template <typename Real> class TractionConvolution {
public:
  TractionConvolution() = default;
  /// `table` has at least table_rows() x table_columns() values; it is not kept. `angles`: of the
  /// columns along a curve, rad; none: a plane.
  TractionConvolution(const TractionShape& shape, std::size_t pitch, double poisson,
                      const DifferenceWeights& weights, const TractionTable& table,
                      LinePlans& plans, std::span<const double> angles = {});

  /// A part of it, which does not turn by itself.
  TractionConvolution(const TractionShape& shape, std::size_t pitch, double poisson,
                      const DifferenceWeights& weights, const TractionTable& table,
                      LinePlans& plans, TractionPart part);

  TractionConvolution(const TractionShape& shape, std::size_t pitch,
                      const DifferenceWeights& weights, const CrossTable& table, LinePlans& plans);

  /// Out may be in. What stands beyond `columns` of a row is not read, and not written.
  void apply(const Real* in_x, const Real* in_y, Real* out_x, Real* out_y,
             ConvolutionWorkspace<Real>& workspace) const;
  /// The coefficients B_xx and B_yy of an element on itself.
  [[nodiscard]] std::array<double, 2> self_influence() const { return self_; }

private:
  using Complex = std::complex<Real>;

  TractionConvolution(const TractionShape& shape, std::size_t pitch,
                      const WeightedCoefficients& coefficients, LinePlans& plans);
  void fill_spectrum(const WeightedCoefficients& coefficients, LinePlans& plans);
  void convolve(const Real* in_x, const Real* in_y, Real* out_x, Real* out_y,
                ConvolutionWorkspace<Real>& workspace) const;
  void transform_columns(Complex* rows, std::size_t row_pitch,
                         ConvolutionWorkspace<Real>& workspace) const;

  TractionShape shape_;
  std::size_t pitch_ = 0;
  std::size_t row_period_ = 0;    ///< length of a line of constant x
  std::size_t column_period_ = 0; ///< length of a line along x
  std::size_t spectrum_pitch_ = 0;
  const LineFft<Real>* row_fft_ = nullptr;
  const LineFft<Real>* column_fft_ = nullptr;
  std::array<double, 2> self_{};
  /// For each k_y from 0 to half the period: al, be(k_x, k_y), be(k_x, -k_y), over k_x.
  AlignedArray<Complex> spectrum_;
  std::unique_ptr<TractionConvolution> turned_; ///< m in both components; none of a plane
  std::vector<Real> cosines_;                   ///< of the columns
  std::vector<Real> sines_;
};

} // namespace wrc
