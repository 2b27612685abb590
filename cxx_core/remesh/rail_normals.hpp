/// The rail's surface under the elements of a patch: which way their pressures push the wheel.
///
/// Without friction the force of a contact is the derivative of an elastic energy: a coordinate q
/// of the wheelset has the force sum p (dh/dq) dA, h the undeformed distance along the plane's
/// normal n. If a body is shifted by d against the other, a distance changes by
///   dh = d . f,  f = n_r / (n . n_r),
/// n_r the normal of the rail's surface at the ray's end (the plane then goes with the wheel; with
/// the wheel's normal it stays in the track, and the sums are the same except for the
/// discretisation, since sum p dh/ds vanishes along the plane). A pressure on dA so pushes with p f
/// dA at that end. Rows along a curve have the normals of the curve. With the surface inclined by
/// beta to the plane f = n - tan(beta) t, t the plane's lateral axis: the plane's own direction
/// has only a second-order effect. A prismatic rail takes no force along itself, one that rises
/// does. Units mm, N, MPa; track frame, left-hand side (geometry/frames.hpp). Thread rule: pure
/// functions. Not known here: friction.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/grid.hpp"
#include "geometry/rail_line.hpp"
#include "patches/contact_frame.hpp"

namespace wrc {

/// A force and its moment about some point.
struct ContactForce {
  Vector3 force;  ///< N
  Vector3 moment; ///< N mm
};

/// How the rail's surface lies to the plane of a patch, over its pressures.
struct SurfaceTurn {
  double weight = 0.0;      ///< sum of the pressures times the area of an element, N
  double mean = 0.0;        ///< of the tangent of its inclination to the rows, by the pressures
  double deviation = 0.0;   ///< its standard deviation, likewise
  double first = 0.0;       ///< least inclination to the plane, rad
  double last = 0.0;        ///< greatest one
  double curve_first = 0.0; ///< of the rows themselves, along a curve
  double curve_last = 0.0;

  [[nodiscard]] double range() const { return last - first; }
  /// Turn of the rows themselves: none in a plane.
  [[nodiscard]] double of_rows() const { return curve_last - curve_first; }
  /// By how much the rail turns more or less.
  [[nodiscard]] double from_rows() const { return std::abs(range() - of_rows()); }
};

class RailNormals {
public:
  /// Normals of the rows of a grid; of each element, where the rail is not the same along the rows.
  RailNormals(const RailSurface& rail, const ContactFrame& frame, const Grid& grid);

  /// The plane goes by so much, with the elements; to first order.
  void shift(const Vector3& by);

  /// Where the ray of an element meets the rail, along the row's normal; none where it does not.
  [[nodiscard]] std::optional<double> position(std::size_t row, std::size_t column) const;
  /// f of an element.
  [[nodiscard]] const Vector3& direction(std::size_t row, std::size_t column) const {
    return places_[index(row, column)].direction;
  }
  /// Tangent of the rail's angle to a row, in its middle.
  [[nodiscard]] double inclination(std::size_t row) const {
    return -dot(direction(row, grid_.longitudinal_count / 2), rows_[row].lateral);
  }
  /// Where its ray meets the rail, along the row's normal.
  [[nodiscard]] double height(std::size_t row, std::size_t column) const;
  /// The row itself.
  [[nodiscard]] const ContactFrame::Row& row(std::size_t index) const { return rows_[index]; }
  /// The end of its ray, from the frame's origin.
  [[nodiscard]] Vector3 arm(std::size_t row, std::size_t column) const;

  /// Changes of the direction and of the end of the ray, as the element moves in the plane.
  struct Rates {
    Vector3 direction;
    Vector3 arm;
  };
  [[nodiscard]] Rates rates(std::size_t row, std::size_t column, double along, double across) const;

  /// `up` . f of each element: its fraction of a shift along `up`. At least 0.02: where the rail
  /// turns upright there is no contact.
  [[nodiscard]] std::vector<double> shares(const Vector3& up) const;
  /// Force of the rail on the wheel, and its moment about the frame's origin.
  [[nodiscard]] ContactForce force(std::span<const double> pressure) const;
  [[nodiscard]] SurfaceTurn turn(std::span<const double> pressure) const;

private:
  struct Place {
    bool met;
    Vector3 foot; ///< from the origin, less what lies along the row
    Vector3 direction;
    SurfaceNormal surface;
  };
  [[nodiscard]] std::size_t index(std::size_t row, std::size_t column) const {
    return by_row_ ? row : row * grid_.longitudinal_count + column;
  }

  ContactFrame frame_;
  Grid grid_;
  bool by_row_;
  std::vector<ContactFrame::Row> rows_;
  std::vector<Place> places_;
};

} // namespace wrc
