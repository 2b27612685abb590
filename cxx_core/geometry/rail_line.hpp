/// Where lines meet a rail and how its surface lies there, by Newton's method from the point met
/// last; and the rail's heights.
///
/// A prismatic rail is a plane curve, so a line is solved on the profile's arc length, overhanging
/// parts included. At a kink or a step steps are halved after a while, and a point within the step
/// is accepted. A rail through slices has sheets (surface_sheet.hpp), in the track frame
///   P(u, x) = (x, Y(u, x), Z(u, x)),
/// inclined, placed and displaced with it. A step from the residual r = P - base - t d takes
///   dt = r.N / d.N,  N = P_x x P_u,
/// along the line, and what is left of r is in the tangent plane. The first line starts from the
/// highest point of all sheets near it, further ones from the point met last, on the same sheet;
/// where that ends, from the highest point again. The neighbour's sheet is so met where sheets
/// join. Units mm; track frame, left-hand side. Thread rule: one object, one thread.
#pragma once

#include <optional>
#include <span>

#include "geometry/frames.hpp"
#include "geometry/rail_surface.hpp"

namespace wrc {

/// The normal of a surface at a point, of any length and upwards. By a way d over the surface it
/// changes by dot(across, d) by_across + d.x by_along.
struct SurfaceNormal {
  Vector3 normal;
  Vector3 across;
  Vector3 by_across;
  Vector3 by_along;
};

class RailLine {
public:
  /// The rail must outlive the line. The first line on a curve starts from the point over a
  /// lateral place.
  explicit RailLine(const RailSurface& rail, double lateral = 0.0);

  /// The next line starts from where the first one did.
  void restart();
  /// Position along the line at which it meets the rail; none where it does not. The next line
  /// starts from there.
  std::optional<double> meet(const Vector3& base, const Vector3& direction);
  /// Height over (x, y) of the track, with derivatives; none where no part of the rail is.
  std::optional<GraphPoint> height(double x, double y);
  /// Heights over lateral places in ascending order, for scans: on an inclined rail through slices
  /// the height counts as 0 in where the profile is; minus infinity where no part of the rail is.
  void heights(double x, std::span<const double> laterals, std::span<double> heights) const;

  /// Lateral place of the point met last, and whether it is one of the rail's graph, seen from
  /// above.
  [[nodiscard]] double lateral() const { return point_.lateral; }
  [[nodiscard]] bool is_on_graph() const;
  /// Of the section across the track there, about x, rad.
  [[nodiscard]] double angle() const;
  [[nodiscard]] SurfaceNormal normal() const;
  /// Tangent of the surface's angle there to a plane, across it: to its lateral axis.
  [[nodiscard]] double inclination(const Vector3& lateral, const Vector3& normal) const;

private:
  struct Start {
    double across;
    double along; ///< x of the track
  };
  [[nodiscard]] CurvePoint on_curve(double arc);
  std::optional<double> meet_curve(const Vector3& base, const Vector3& direction);
  [[nodiscard]] SheetPoint placed(const SurfaceSheet& sheet, double across, double x) const;
  std::optional<double> meet_sheet(std::size_t index, Start from, const Vector3& base,
                                   const Vector3& direction);
  std::optional<double> meet_highest(const Vector3& base, const Vector3& direction);

  const RailSurface& rail_;
  const bool is_prismatic_;
  CurvePoint point_;
  // On a curve:
  double first_arc_ = 0.0;
  double arc_ = 0.0; ///< where the next line starts
  double arc_of_point_ = 0.0;
  std::size_t piece_ = 0;
  // On a sheet:
  double cosine_;
  double sine_;
  std::optional<std::size_t> sheet_;
  Start last_{};
  GraphPoint graph_;
};

/// Height of a rail's surface at a place of the track, from which its lateral place is clamped;
/// where no part of the rail is, that of its section at the wheelset.
double height_near(const RailSurface& rail, double x, double y);
/// The same with derivatives, from the table of heights where the rail is prismatic.
GraphPoint graph_near(const RailSurface& rail, double x, double y);

} // namespace wrc
