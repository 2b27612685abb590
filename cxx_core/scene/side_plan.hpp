/// Where the patches of a side are looked for, and on what grids: before a solution, from the last
/// one at a neighbouring position, and after a trial.
///
/// The planes are those of the patches of penetration at a depth (remesh/contact_patches.hpp);
/// areas hold the penetration, or the contact that a solution has found, and stay in the
/// territories of their patches. In the vertical convention all patches near the main one share one
/// plane and grid. Units mm and rad; left-hand frame of the side. Thread rule: a planner is
/// immutable.
#pragma once

#include <optional>
#include <vector>

#include "geometry/wheelset_equilibrium.hpp"
#include "scene/side_memory.hpp"
#include "scene/side_request.hpp"
#include "scene/trial.hpp"

namespace wrc {

/// Patches at a depth, and where and how finely each is to be solved.
struct SidePlan {
  double depth = 0.0;
  ContactPatches found;
  std::vector<PatchPlan> patches;
  std::optional<double>
      left_out_s; ///< on the wheel: a patch that the vertical convention leaves out
};

class SidePlanner {
public:
  /// References must outlive the planner. With a grid given by hand areas fit the contact as
  /// closely as they can; else columns are kept from trial to trial where that is possible.
  SidePlanner(const RailSurface& rail, const SideEquilibrium& equilibrium,
              const SideRequest& request)
      : rail_(rail), equilibrium_(equilibrium), gap_(request.gap),
        joining_distance_(request.joining_distance), grid_is_given_(request.grid.has_value()) {}

  /// The patches of penetration at a depth.
  [[nodiscard]] ContactPatches patches_at(double depth) const {
    return find_contact_patches(equilibrium_.scan, depth, joining_distance_);
  }

  /// Places and planes at a depth, without areas and meshes.
  [[nodiscard]] SidePlan empty_plan(double depth) const;
  /// From the penetration alone.
  [[nodiscard]] SidePlan first_plan(double depth, const Resolution& resolution) const;
  /// Where contact lay in the penetration the last time; as many patches as then.
  [[nodiscard]] SidePlan remembered_plan(const SideMemory& memory, double depth) const;
  /// The next plan after a trial: at its depth or another one, around the contact found.
  [[nodiscard]] SidePlan next_plan(const Trial& trial, double depth,
                                   const std::vector<Resolution>& resolutions, double growth) const;
  /// The part of an area in the patch's territory; where nothing of it lies there, the patch's
  /// penetration.
  [[nodiscard]] PlaneArea limited(const PlaneArea& area, const PatchPlan& plan) const;
  /// The same rectangle, seen in the plane of another frame; itself in its own, so that areas do
  /// not drift where distances are sampled again and again.
  [[nodiscard]] PlaneArea carried_over(const PlaneArea& area, const ContactFrame& from,
                                       const ContactFrame& to) const;

private:
  void join_in_one_plane(SidePlan& plan) const;
  [[nodiscard]] ContactFrame frame_of(const ContactPatch& patch) const;
  void plan_penetration(PatchPlan& patch, const Resolution& resolution) const;

  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  GapConvention gap_;
  double joining_distance_;
  bool grid_is_given_;
};

} // namespace wrc
