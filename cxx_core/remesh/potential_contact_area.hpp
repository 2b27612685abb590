/// Where contact is possible when the wheel is lowered by a depth.
///
/// Elastic displacements are positive everywhere under positive pressures, so contact lies within
/// the region in which the undeformed bodies, lowered by the true approach, penetrate each other
/// (virtual penetration; Kik & Piotrowski 1996). The region is an interval of the contact locus;
/// its length along the rail follows from the wheel's curvature in rolling direction,
/// x_l = sqrt(2 R g). Intervals whose mean angles are close belong to one area.
/// Units mm, N, MPa, rad; track frame, left-hand side. Thread rule: pure functions.
#pragma once

#include "geometry/contact_search.hpp"
#include "remesh/contact_frame.hpp"
#include "remesh/grid.hpp"

namespace wrc {

/// The region of virtual penetration around the first contact, in the track frame.
struct PenetrationRegion {
  double y_first = 0.0; ///< its ends on the track side and ...
  double y_last = 0.0;  ///< ... on the field side
  double x_first = 0.0;
  double x_last = 0.0;
  double mean_angle = 0.0;    ///< of the rail, weighted with the penetrated volume, rad
  double mean_y = 0.0;        ///< weighted with the penetrated volume
  double half_length = 0.0;   ///< largest x_l
  bool other_regions = false; ///< penetration also at another angle, which this area leaves out
  double other_wheel_lateral = 0.0; ///< s where that is deepest
};

/// `depth` > 0: how far the wheel is lowered vertically from the first touch.
PenetrationRegion find_penetration_region(const ContactScan& scan, double depth);

/// Rough depth for a load along the normal of the main patch (remesh/depth_estimate.hpp).
double estimate_depth(const ContactScan& scan, double combined_modulus, double normal_load);

/// A rectangle in the plane of a contact frame.
struct PlaneArea {
  double lateral_first = 0.0;
  double lateral_last = 0.0;
  double longitudinal_first = 0.0;
  double longitudinal_last = 0.0;

  [[nodiscard]] double width() const { return lateral_last - lateral_first; }
  [[nodiscard]] double length() const { return longitudinal_last - longitudinal_first; }
  /// Moves each edge outwards by a share of width and length.
  [[nodiscard]] PlaneArea widened(double share) const;
};

/// The rectangle that holds a penetration region, seen along the frame's normal.
PlaneArea area_of(const PenetrationRegion& region, const RailSurface& rail,
                  const ContactFrame& frame);

/// Equally spaced elements that fill an area.
Grid grid_over(const PlaneArea& area, std::size_t lateral_count, std::size_t longitudinal_count);

} // namespace wrc
