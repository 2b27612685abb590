#include "remesh/ray_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vector_clones.hpp"
#include "remesh/constants.hpp"

namespace wrc {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The tangent of a profile; for a surface of revolution its height is the radius.
struct Tangent {
  double lateral;
  double height;
  double slope;
};

/// Lateral coordinates that a row meets.
struct Reach {
  double first;
  double last;
};

/// What a stretch of a row meets: one polynomial, ...
struct RowStretch {
  HeightFunction::Piece piece;
  double radius;
  double half_curvature; ///< half a bound of the second derivative along the rays
  std::size_t begin;     ///< ... from this column
  std::size_t end;       ///< to before this one
};

WRC_VECTOR_CLONES
Reach start_on_prism(const RowOfRays& rays, const Tangent& tangent, double* __restrict position,
                     double* __restrict lateral) {
  const Vector3 base = rays.base;
  const Vector3 along = rays.along;
  const Vector3 normal = rays.normal;
  const Tangent t = tangent;
  const double* __restrict x = rays.longitudinal;
  const double inverse = 1.0 / (normal.z - t.slope * normal.y);
  double first = infinity;
  double last = -infinity;
#pragma omp simd reduction(min : first) reduction(max : last)
  for (std::size_t i = 0; i < rays.count; ++i) {
    const double y = base.y + x[i] * along.y;
    const double z = base.z + x[i] * along.z;
    const double p = (t.height + t.slope * (y - t.lateral) - z) * inverse;
    const double met = y + p * normal.y;
    position[i] = p;
    lateral[i] = met;
    first = met < first ? met : first;
    last = met > last ? met : last;
  }
  return {first, last};
}

WRC_VECTOR_CLONES
Reach start_on_revolution(const RowOfRays& rays, const Tangent& tangent,
                          double* __restrict position, double* __restrict lateral) {
  const Vector3 base = rays.base;
  const Vector3 along = rays.along;
  const Vector3 normal = rays.normal;
  const Tangent t = tangent;
  const double* __restrict x = rays.longitudinal;
  const double across = t.slope * normal.y;
  const double a = normal.x * normal.x + normal.z * normal.z - across * across;
  double first = infinity;
  double last = -infinity;
#pragma omp simd reduction(min : first) reduction(max : last)
  for (std::size_t i = 0; i < rays.count; ++i) {
    const double bx = base.x + x[i] * along.x;
    const double by = base.y + x[i] * along.y;
    const double bz = base.z + x[i] * along.z;
    const double rho = t.height + t.slope * (by - t.lateral);
    const double b = bx * normal.x + bz * normal.z - rho * across;
    const double c = bx * bx + (bz - rho) * (bz + rho);
    // a p^2 + 2 b p + c = 0; this form of the first root holds for a of any sign.
    const double p = c / (std::sqrt(b * b - a * c) - b);
    const double met = by + p * normal.y;
    position[i] = p;
    lateral[i] = met;
    first = met < first ? met : first;
    last = met > last ? met : last;
  }
  return {first, last};
}

struct HeightSlope {
  double height;
  double slope;
};

WRC_VECTOR_BODY HeightSlope height_slope(const Quintic& c, double s) {
  return {c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5])))),
          c[1] + s * (2.0 * c[2] + s * (3.0 * c[3] + s * (4.0 * c[4] + s * (5.0 * c[5]))))};
}

/// One ray on its way to the surface.
struct Approach {
  double position;
  double step = 0.0;
  double derivative = 0.0; ///< along the ray, positive where the surface faces it
  double facing = 0.0;     ///< the derivative if the ray ran straight up to the surface
};

/// A step of Newton's method on z = h(y).
WRC_VECTOR_BODY Approach step_to_prism(const Approach& ray, const Vector3& base,
                                       const Vector3& normal, const HeightFunction::Piece& piece) {
  const double p = ray.position;
  const HeightSlope profile = height_slope(piece.coefficients, base.y + p * normal.y - piece.start);
  const double derivative = normal.z - profile.slope * normal.y;
  const double step = (profile.height - (base.z + p * normal.z)) / derivative;
  return {p + step, step, derivative, std::sqrt(1.0 + profile.slope * profile.slope)};
}

/// A step of Newton's method on X^2 + Z^2 = rho(Y)^2, halved.
WRC_VECTOR_BODY Approach step_to_revolution(const Approach& ray, const Vector3& base,
                                            const Vector3& normal,
                                            const HeightFunction::Piece& piece, double radius) {
  const double p = ray.position;
  const HeightSlope profile = height_slope(piece.coefficients, base.y + p * normal.y - piece.start);
  const double rho = radius + profile.height;
  const double x = base.x + p * normal.x;
  const double z = base.z + p * normal.z;
  const double derivative = rho * profile.slope * normal.y - x * normal.x - z * normal.z;
  const double step = 0.5 * (x * x + (z - rho) * (z + rho)) / derivative;
  return {p + step, step, derivative, rho};
}

/// Estimated error of a ray; infinite if it left its polynomial or if the surface is too flat.
WRC_VECTOR_BODY double error_of(const Approach& ray, double lateral, const RowStretch& on) {
  const double error = ray.step * ray.step * on.half_curvature * ray.facing / ray.derivative;
  const bool faces = ray.derivative > min_facing_cosine * ray.facing;
  const bool on_piece = (lateral >= on.piece.start) & (lateral <= on.piece.end);
  return (faces & on_piece) ? error : infinity;
}

/// `steps` is 1 or 2: a loop of unknown length would not vectorise.
template <bool is_revolution, int steps>
WRC_VECTOR_BODY double improve(const RowOfRays& rays, const RowStretch& stretch,
                               double* __restrict position, double* __restrict error) {
  const Vector3 base = rays.base;
  const Vector3 along = rays.along;
  const Vector3 normal = rays.normal;
  const RowStretch on = stretch;
  const double* __restrict x = rays.longitudinal;
  double worst = 0.0;
#pragma omp simd reduction(max : worst)
  for (std::size_t i = on.begin; i < on.end; ++i) {
    const Vector3 from{base.x + x[i] * along.x, base.y + x[i] * along.y, base.z + x[i] * along.z};
    Approach ray{position[i]};
    if constexpr (steps == 2) {
      ray = is_revolution ? step_to_revolution(ray, from, normal, on.piece, on.radius)
                          : step_to_prism(ray, from, normal, on.piece);
    }
    ray = is_revolution ? step_to_revolution(ray, from, normal, on.piece, on.radius)
                        : step_to_prism(ray, from, normal, on.piece);
    const double left = error_of(ray, from.y + ray.position * normal.y, on);
    position[i] = ray.position;
    error[i] = left;
    worst = left > worst ? left : worst;
  }
  return worst;
}

WRC_VECTOR_CLONES
double step_once(bool is_revolution, const RowOfRays& rays, const RowStretch& stretch,
                 double* __restrict position, double* __restrict error) {
  return is_revolution ? improve<true, 1>(rays, stretch, position, error)
                       : improve<false, 1>(rays, stretch, position, error);
}

WRC_VECTOR_CLONES
double step_twice(bool is_revolution, const RowOfRays& rays, const RowStretch& stretch,
                  double* __restrict position, double* __restrict error) {
  return is_revolution ? improve<true, 2>(rays, stretch, position, error)
                       : improve<false, 2>(rays, stretch, position, error);
}

} // namespace

RaySurface::RaySurface(const RailSurface& rail, std::size_t row_length)
    : heights_(rail.graph().heights()), is_prismatic_(rail.is_prismatic_along(along_track)),
      position_(row_length), lateral_(row_length), error_(row_length) {}

RaySurface::RaySurface(const WheelSurface& wheel, std::size_t row_length)
    : heights_(wheel.graph().heights()), is_prismatic_(wheel.is_prismatic_along(along_track)),
      radius_(wheel.radius()), position_(row_length), lateral_(row_length), error_(row_length) {}

void RaySurface::meet_none(std::size_t count) {
  std::fill_n(error_.begin(), count, infinity);
}

bool RaySurface::meet(const RowOfRays& rays, double lateral) {
  if (!is_prismatic_) {
    meet_none(rays.count);
    return false;
  }
  const HeightPoint middle = heights_.at(lateral);
  const double radius = radius_.value_or(0.0);
  const Tangent tangent{lateral, radius + middle.height, middle.slope};
  const Reach reach = radius_
                          ? start_on_revolution(rays, tangent, position_.data(), lateral_.data())
                          : start_on_prism(rays, tangent, position_.data(), lateral_.data());
  // How far the profile can be from its tangent, and the derivative along the rays: a wheel's
  // height grows downwards.
  const double farthest = std::max(reach.last - lateral, lateral - reach.first);
  const double rise = radius_ ? -middle.slope : middle.slope;
  const double facing = std::max(rays.normal.z - rise * rays.normal.y, min_facing_cosine);
  const auto meet_stretch = [&](std::size_t piece, std::size_t begin, std::size_t end) {
    const HeightFunction::Piece& polynomial = heights_.pieces()[piece];
    const double second = std::max(std::abs(heights_.at(piece, polynomial.start).second),
                                   std::abs(heights_.at(piece, polynomial.end).second));
    const double half_curvature =
        0.5 * second * rays.normal.y * rays.normal.y + (radius_ ? 0.5 / tangent.height : 0.0);
    double error = 0.5 * second * farthest * farthest / facing;
    int steps = 0;
    while (steps < max_ray_steps && (steps == 0 || error > 0.1 * ray_error)) {
      error = half_curvature * error * error / facing;
      ++steps;
    }
    const RowStretch stretch{polynomial, radius, half_curvature, begin, end};
    for (; steps > 2; steps -= 2) {
      step_twice(radius_.has_value(), rays, stretch, position_.data(), error_.data());
    }
    return (steps == 2 ? step_twice : step_once)(radius_.has_value(), rays, stretch,
                                                 position_.data(), error_.data());
  };
  // Stretches of columns that meet the same polynomial; mostly one.
  double worst = 0.0;
  for (std::size_t begin = 0; begin < rays.count;) {
    const std::size_t piece = heights_.piece_at(lateral_[begin]);
    const double start = heights_.pieces()[piece].start;
    const double stop = heights_.pieces()[piece].end;
    std::size_t end = rays.count;
    if (!(reach.first >= start && reach.last < stop)) {
      end = begin + 1;
      while (end < rays.count && lateral_[end] >= start && lateral_[end] < stop) {
        ++end;
      }
    }
    worst = std::max(worst, meet_stretch(piece, begin, end));
    begin = end;
  }
  return worst <= ray_error;
}

} // namespace wrc
