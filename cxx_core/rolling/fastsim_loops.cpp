#include "rolling/fastsim_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vector_clones.hpp"

namespace wrc {

namespace {

/// Factor that brings a vector of this square within the bound. No branch: the root is taken of
/// all.
WRC_VECTOR_BODY double factor_within(double square, double bound) {
  constexpr double least = std::numeric_limits<double>::min(); // 0 of 0 within 0
  return bound / std::max(std::sqrt(square), std::max(bound, least));
}

} // namespace

WRC_VECTOR_CLONES StripSums march_ellipse(const EllipseStrips& strips, const double* place,
                                          std::size_t slices) {
  double qx[strip_group] = {};
  double qy[strip_group] = {};
  double x[strip_group] = {};
  double y[strip_group] = {};
  double moment[strip_group] = {};
  double slipping[strip_group] = {};
  const double step = 2.0 / static_cast<double>(slices);
  double share = 0.5; // of a step: the first leads from the edge to the middle of a slice
  for (std::size_t i = 0; i < slices; ++i) {
    const double u = 1.0 - (static_cast<double>(i) + 0.5) * step;
    const double middle = u + 0.5 * share * step;
    const double height = 1.0 - u * u;
#pragma omp simd
    for (std::size_t j = 0; j < strip_group; ++j) {
      const double length = strips.half_length[j];
      const double tx = qx[j] - share * strips.change_x[j];
      const double ty = qy[j] - share * (strips.change_y[j] + middle * strips.change_y_by_spin[j]);
      const double factor = factor_within(tx * tx + ty * ty, height * length * length);
      qx[j] = factor * tx;
      qy[j] = factor * ty;
      x[j] += qx[j];
      y[j] += qy[j];
      moment[j] += u * qy[j];
      slipping[j] += factor < 1.0 ? 1.0 : 0.0;
    }
    share = 1.0;
  }
  StripSums sums;
  for (std::size_t j = 0; j < strip_group; ++j) {
    const double length = strips.half_length[j];
    sums.x += length * x[j];
    sums.y += length * y[j];
    sums.moment += length * length * moment[j];
    sums.moment_x += length * place[j] * x[j];
    sums.slipping += length * slipping[j];
  }
  return sums;
}

WRC_VECTOR_CLONES void march_elements(const MarchedElements& elements, double* traction_x,
                                      double* traction_y, double* cut_x, double* cut_y,
                                      double* state) {
  const std::size_t pitch = elements.pitch;
  double* qx = state;
  double* qy = state + pitch;
  double* share = state + 2 * pitch; // of an element, to its centre from where the march stands
  std::fill_n(state, 2 * pitch, 0.0);
  std::fill_n(share, pitch, 0.5);
  for (std::size_t i = 0; i < elements.rows; ++i) {
    const std::size_t first = i * pitch;
#pragma omp simd
    for (std::size_t j = 0; j < pitch; ++j) {
      const double bound = elements.bound[first + j];
      const double part = share[j];
      // The middle of a step lies half a step upstream of its end.
      const double change_y =
          part * (elements.change_y[first + j] - 0.5 * part * elements.change_y_by_row);
      const double tx = qx[j] - part * elements.change_x[first + j];
      const double ty = qy[j] - change_y;
      const bool inside = bound > 0.0;
      const double factor = factor_within(tx * tx + ty * ty, bound);
      qx[j] = factor * tx;
      qy[j] = factor * ty;
      share[j] = inside ? 1.0 : 0.5;
      traction_x[first + j] = qx[j];
      traction_y[first + j] = qy[j];
      cut_x[first + j] = inside ? (tx - qx[j]) / part : 0.0;
      cut_y[first + j] = inside ? (ty - qy[j]) / part : 0.0;
    }
  }
}

} // namespace wrc
