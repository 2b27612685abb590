/// The left rail in the track frame: inclined by the inclination, then placed by the gauge.
///
/// The profile (lateral t to the field side, height up) is turned inward by the inclination about
/// the rail's longitudinal axis: y = t cos(inclination) - v sin(inclination), z = t
/// sin(inclination) + v cos(inclination), which raises the field side. It is then shifted so that
/// its highest point lies at z = 0 and its gauge face, at `gauge_height` below the top, at y =
/// gauge / 2 (the paper, equations 3 and 4, with the inclination as a rotation about x, see
/// docs/evidence/validation.md). The rail is prismatic along x, or has the surface through a list
/// of slices (geometry/sliced_surface.hpp); rail_line.hpp meets either. A roller or disc, which
/// does not fall to the gauge side by 45 degrees, has no gauge face: its lateral 0 is put 32.5 mm
/// beside gauge / 2, where the taping line of a wheel is. Irregularities of the track displace it
/// from there. Units mm and rad. Thread rule: immutable, safe to share.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/curve_graph.hpp"
#include "geometry/frames.hpp"
#include "geometry/sliced_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "profile/profile.hpp"

namespace wrc {

struct TrackDimensions {
  double gauge = 1435.0;
  double gauge_height = 14.0; ///< below the top of the inclined rail (16 in China)
  double inclination = 0.025; ///< rad, > 0 leans the rail towards the track centre
  /// Of the profile's origin from the track centre, to the field side, at the height z = 0; none:
  /// by the gauge and the rail's top.
  std::optional<double> origin{};
  bool operator==(const TrackDimensions&) const = default;
};

/// Displacement of a rail from its nominal position, or its velocity, per s. That of a right rail
/// is used as its mirror image.
struct RailDisplacement {
  double lateral = 0.0; ///< to the left, mm
  double height = 0.0;  ///< upwards, mm
  /// About the x axis through the profile's origin, rad, > 0 raises the left side.
  double roll = 0.0;
  bool operator==(const RailDisplacement&) const = default;
};

inline RailDisplacement mirrored(const RailDisplacement& displacement) {
  return {-displacement.lateral, displacement.height, -displacement.roll};
}

class RailSurface {
public:
  /// Throws Error(invalid_argument) if the profile's gauge face ends above the gauge height.
  RailSurface(const Profile& profile, const TrackDimensions& track);
  /// A rail through slices, with the wheelset at the begin of them. It is placed as a whole, by the
  /// gauge face of its first slice (`first`). Throws also as that does.
  RailSurface(std::shared_ptr<const SlicedSurface> slices, const Curve& first,
              const TrackDimensions& track);

  /// Whether it is the same all along a direction.
  [[nodiscard]] bool is_prismatic_along(const Vector3& direction) const {
    return slices_ == nullptr && direction.y == 0.0 && direction.z == 0.0;
  }
  /// Where along the track the wheelset is, mm from the origin of the rail's slices: x = 0 of the
  /// track frame. The graph is the section there.
  [[nodiscard]] double along() const { return along_; }
  /// Throws Error(no_contact) for a wheelset before the first slice of the rail, or beyond the
  /// last.
  void refuse_beyond_slices(double along) const;
  /// How far it is along the track from the wheelset to the rail; more than 0 in a gap.
  [[nodiscard]] double distance_along() const;
  /// The end of a part along the track that is nearest to x; none of a rail without ends.
  [[nodiscard]] std::optional<PartEnd> nearest_end(double x) const;
  /// The curves of all its parts at the wheelset, from the track's middle outwards.
  [[nodiscard]] std::vector<Curve> sections() const;

  /// The same rail somewhere else, with the wheelset somewhere along it: 1 us without roll, which
  /// takes a new table of heights, 40 us, as slices do. In a gap the graph is the nearest section:
  /// a wheel may stand on both sides.
  [[nodiscard]] RailSurface posed(const RailDisplacement& displacement, double along) const;
  /// The prismatic rail that a wheel meets at a place along; none where it varies within reach.
  [[nodiscard]] const RailSurface* prism_at(double along, const WheelSurface& wheel,
                                            double yaw) const;
  /// The prismatic rail with the section at the wheelset.
  [[nodiscard]] RailSurface as_prism() const;
  [[nodiscard]] RailSurface displaced(const RailDisplacement& displacement) const {
    return posed(displacement, along_);
  }

  /// The part seen from above: lateral = y, height = z of the track frame.
  [[nodiscard]] const CurveGraph& graph() const { return graph_; }
  /// The whole curve before any displacement.
  [[nodiscard]] const Curve& nominal() const { return *nominal_; }
  /// The profile's origin in the track frame.
  [[nodiscard]] double origin_y() const { return lateral_shift_; }
  [[nodiscard]] double origin_z() const { return height_shift_; }
  /// Of the profile's frame in the track frame, rad.
  [[nodiscard]] double angle() const { return angle_; }
  /// Whether it was placed without a gauge face, before the displacement.
  [[nodiscard]] bool is_placed_by_axis() const { return is_placed_by_axis_; }
  /// Converts a point of the track frame into the profile's frame (t, height).
  void to_profile_frame(double y, double z, double& lateral, double& height) const;

private:
  friend class RailLine;
  RailSurface(CurveGraph graph, std::shared_ptr<const Curve> nominal, double top_arc, double angle,
              double lateral_shift, double height_shift)
      : graph_(std::move(graph)), nominal_(std::move(nominal)), top_arc_(top_arc), angle_(angle),
        lateral_shift_(lateral_shift), height_shift_(height_shift) {}
  static RailSurface place(const Curve& profile, const TrackDimensions& track);

  CurveGraph graph_;
  std::shared_ptr<const Curve> nominal_;
  double top_arc_; ///< before the displacement
  double angle_;   ///< of the profile's frame in the track frame
  double lateral_shift_;
  double height_shift_;
  bool is_placed_by_axis_ = false;
  std::shared_ptr<const SlicedSurface> slices_; ///< none: prismatic
  double along_ = 0.0;
  struct Prism;
  std::shared_ptr<const std::vector<Prism>> prisms_; ///< where slices are the same
};

/// The rail as a wheel meets it under a yaw: displaced, with the wheelset somewhere along it; a
/// prismatic one where that is all it meets, the rail itself where nothing changes.
std::shared_ptr<const RailSurface> posed(const std::shared_ptr<const RailSurface>& rail,
                                         const RailDisplacement& displacement, double along,
                                         const WheelSurface& wheel, double yaw);

} // namespace wrc
