/// A rectangle of the projected CG: its fields, its edges, and the step that keeps pressures from
/// being negative.
///
/// Pressures below 0 become 0 and their displacements are taken out of u: one by one where they are
/// few, by a convolution otherwise. In units of influence_cache.hpp.
/// Thread rule: that of the cache and the workspace.
#pragma once

#include <cstddef>
#include <span>

#include "half_space/box_convolution.hpp"

namespace wrc {

/// One rectangle: the problem there and its fields.
struct IterationBox {
  std::size_t rows = 0;
  std::size_t columns = 0;
  InfluenceKernel kernel;
  double share = 1.0;  ///< a typical s: of the approach, in this box's unit of length
  double weight = 1.0; ///< w: element area times unit of length, in a unit common to all boxes
  /// Which sides have elements of the grid beyond them: contact there ends the iteration, since the
  /// rectangle is too small.
  bool open_first_row = false;
  bool open_last_row = false;
  bool open_first_column = false;
  bool open_last_column = false;
  std::span<double> pressure; ///< start in, answer out
  std::span<const double> distance;
  std::span<const double> shares; ///< s of each element
  std::span<const double> angles; ///< of rows along a curve

  [[nodiscard]] std::size_t count() const { return rows * columns; }
};

/// Contact came up at these open sides.
struct ReachedSides {
  bool first_row = false;
  bool last_row = false;
  bool first_column = false;
  bool last_column = false;
  [[nodiscard]] bool any() const { return first_row || last_row || first_column || last_column; }
};

/// What the iteration keeps on a rectangle.
template <typename Real> struct BoxFields {
  BoxConvolution<Real> convolution;
  BoxConvolution<Real> preconditioner;
  AlignedArray<double> displacement; ///< by the pressures of this box
  AlignedArray<double> distance;     ///< with coupling: h, and what other boxes displace here
  AlignedArray<Real> residual;
  AlignedArray<Real> last_residual;
  AlignedArray<Real> correction; ///< z; with coupling also what p changes by in a step
  AlignedArray<Real> direction;  ///< v
  AlignedArray<Real> response;   ///< K v; also the input of a fresh u = K p
  AlignedArray<Real> contact;    ///< 1 on C, 0 elsewhere
  double cut = 0.0;              ///< number of pressures below 0
  double beta = 0.0;
  double last_z_r = 0.0;       ///< <z, r> of the iteration before; 0: the next direction is z
  double step = 0.0;           ///< along v, and ...
  double factor = 1.0;         ///< ... by which all pressures, and u, grow after it
  AlignedArray<Real> mirrored; ///< K[row * (2 columns - 1) + columns - 1 + offset]
  bool has_mirrored = false;   ///< for this box
};

/// Sides of the box that contact (1 there, else 0) has reached and beyond which there are elements.
template <typename Real> ReachedSides reached_sides(const IterationBox& box, const Real* contact);

/// `fields.cut`: the number of pressures below 0.
template <typename Real>
void clip_negative(const IterationBox& box, BoxFields<Real>& fields, InfluenceCache& cache,
                   ConvolutionWorkspace<Real>& workspace);

} // namespace wrc
