/// Where a straight line meets a rail that varies along the track, by Newton's method.
///
/// In the track frame a sheet (surface_sheet.hpp) is P(u, x) = (x, Y(u, x), Z(u, x)), inclined,
/// placed and displaced with its rail. A step from the residual r = P - base - t d takes
///   dt = r.N / d.N,  N = P_x x P_u,
/// along the line, and what is left of r is in the tangent plane. The first line starts from the
/// highest point of all sheets near it, further ones from the point met last, on the same sheet;
/// where that ends, from the highest point again. The neighbour's sheet is so met where sheets
/// join. Units mm. Not covered: rails of one profile. Thread rule: one object, one thread.
#pragma once

#include <optional>

#include "geometry/frames.hpp"
#include "geometry/rail_surface.hpp"

namespace wrc {

class RailLine {
public:
  /// The rail, which varies, must outlive the line.
  explicit RailLine(const RailSurface& rail);

  /// The next line starts from the highest point near it.
  void restart() { sheet_.reset(); }
  /// Position along the line at which it meets the rail; none where it does not. The next line
  /// starts from there.
  std::optional<double> meet(const Vector3& base, const Vector3& direction);
  /// The point met last: height over (x, y) of the track, with derivatives.
  [[nodiscard]] const GraphPoint& graph() const { return graph_; }

private:
  struct Start {
    double across;
    double along; ///< x of the track
  };
  [[nodiscard]] SheetPoint placed(const SurfaceSheet& sheet, double across, double x) const;
  [[nodiscard]] std::optional<double> newton(std::size_t sheet, Start from, const Vector3& base,
                                             const Vector3& direction);
  [[nodiscard]] std::optional<double> from_highest(const Vector3& base, const Vector3& direction,
                                                   double position);

  const RailSurface& rail_;
  double cosine_;
  double sine_;
  std::optional<std::size_t> sheet_;
  Start last_{};
  GraphPoint graph_;
};

/// Height of a rail's surface at a place of the track, from which its places are clamped; of a rail
/// that varies, where no part of it is, that of its section at the wheelset.
double height_near(const RailSurface& rail, double x, double y);

} // namespace wrc
