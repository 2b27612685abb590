/// Where the patches of a side are solved: planes and potential contact areas at a depth.
///
/// The planes are those of the patches of penetration (patches/contact_patches.hpp). An area spans
/// a patch's penetration with a little room, within its territory: contact cannot leave the
/// penetration, whose ends the scan knows by parabolas between its nodes. In the vertical
/// convention all patches near the main one share one plane and grid. Units mm and rad; left-hand
/// frame of the side. Thread rule: a planner is immutable.
#pragma once

#include <optional>
#include <vector>

#include "geometry/wheelset_equilibrium.hpp"
#include "patches/contact_frame.hpp"
#include "patches/contact_patches.hpp"
#include "wheel/wheel_request.hpp"

namespace wrc {

struct PlannedPatch {
  ContactPatch place;
  ContactFrame frame;
  PlaneArea area;
};

struct GridPlan {
  double depth = 0.0;
  ContactPatches found;
  std::vector<PlannedPatch> patches;
  std::optional<double>
      left_out_s; ///< on the wheel: a patch that the vertical convention leaves out
};

class GridPlanner {
public:
  /// References must outlive the planner.
  GridPlanner(const RailSurface& rail, const SideEquilibrium& equilibrium,
              const WheelRequest& request)
      : rail_(rail), equilibrium_(equilibrium), gap_(request.gap),
        joining_distance_(request.joining_distance) {}

  [[nodiscard]] GridPlan plan(double depth) const;

private:
  void join_in_one_plane(GridPlan& plan) const;
  [[nodiscard]] ContactFrame frame_of(const ContactPatch& patch) const;

  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  GapConvention gap_;
  double joining_distance_;
};

} // namespace wrc
