/// The left rail in the track frame: inclined by the cant, then placed by the gauge.
///
/// The profile (lateral t to the field side, height up) is turned inward by the cant about the
/// rail's longitudinal axis: y = t cos(cant) - v sin(cant), z = t sin(cant) + v cos(cant), which
/// raises the field side. It is then shifted so that its highest point lies at z = 0 and its gauge
/// face, at `gauge_height` below the top, at y = gauge / 2 (the paper, equations 3 and 4, with the
/// cant as a rotation about x, see docs/paper_misprints.md). The rail is prismatic along x.
/// Units mm and rad. Thread rule: immutable, safe to share.
#pragma once

#include "geometry/curve_graph.hpp"
#include "profile/profile.hpp"

namespace wrc {

struct TrackDimensions {
  double gauge = 1435.0;
  double gauge_height = 14.0; ///< below the top of the inclined rail (16 in China)
  double cant = 0.025;        ///< rad, > 0 leans the rail towards the track centre
  bool operator==(const TrackDimensions&) const = default;
};

class RailSurface {
public:
  /// Throws Error(invalid_argument) if the profile has no gauge face at the gauge height.
  RailSurface(const Profile& profile, const TrackDimensions& track);

  /// The part seen from above: lateral = y, height = z of the track frame.
  [[nodiscard]] const CurveGraph& graph() const { return graph_; }
  /// A place of the track frame in the profile's own frame (t, height).
  void to_profile_frame(double y, double z, double& lateral, double& height) const;

private:
  struct Placed {
    CurveGraph graph;
    double lateral_shift;
    double height_shift;
  };
  static Placed place(const Profile& profile, const TrackDimensions& track);
  RailSurface(Placed placed, double cant);

  CurveGraph graph_;
  double cant_;
  double lateral_shift_;
  double height_shift_;
};

} // namespace wrc
