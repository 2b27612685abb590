/// Parallel rays of a whole row of elements, met with a surface all at once if that is prismatic
/// along the track.
///
/// A ray is base + x along + p normal, with x the element's longitudinal coordinate and p unknown.
/// The surface is z = h(y), a prism, or X^2 + Z^2 = (R + h(Y))^2, a surface of revolution, with h
/// the profile's table of heights (geometry/height_function.hpp). Start: the profile's tangent line
/// in the middle of the row in place of h gives a linear or a quadratic equation. Then Newton's
/// method on the table's own polynomials, in loops over stretches of a row that meet one
/// polynomial, so that its coefficients stay in registers. The number of steps follows from the
/// distance of the profile from its tangent line: the error e after a step of size d is K d^2 / (2
/// F) with K the curvature and F the derivative along the ray, which bounds the number of steps
/// before and checks the result after. A ray that is not below the tolerance, left its polynomial,
/// or sees the surface at too flat an angle, is reported as not met: single rays
/// (remesh/surface_rays.hpp) decide about it. Units mm. Thread rule: one object, one thread.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/frames.hpp"
#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "remesh/constants.hpp"

namespace wrc {

/// Rays of a row, in a frame in which y is the lateral coordinate of the profile.
struct RowOfRays {
  Vector3 base;
  Vector3 along;
  Vector3 normal;
  const double* longitudinal;
  std::size_t count;
};

class RaySurface {
public:
  /// The surface must outlive the object.
  RaySurface(const RailSurface& rail, std::size_t row_length);
  RaySurface(const WheelSurface& wheel, std::size_t row_length);

  /// Meets all rays of a row, of which one near the middle meets the profile at `lateral`.
  /// Returns false if some are not met; of a surface that is not prismatic none is.
  bool meet(const RowOfRays& rays, double lateral);
  /// Meets no ray: all are left to be decided by single rays.
  void meet_none(std::size_t count);

  [[nodiscard]] bool met(std::size_t column) const { return error_[column] <= ray_error; }
  /// p of a ray that is met.
  [[nodiscard]] double position(std::size_t column) const { return position_[column]; }

private:
  const HeightFunction& heights_;
  const bool is_prismatic_;
  std::optional<double> radius_; ///< of a surface of revolution
  std::vector<double> position_, lateral_, error_;
};

} // namespace wrc
