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
#include "scene/trial.hpp"

namespace wrc {

/// What a solution leaves for the next one at a neighbouring position: a start, never an answer.
struct SideMemory {
  /// Where contact lay in a patch's rectangle of virtual penetration, as shares of its sides, and
  /// how many elements were enough.
  struct Patch {
    double lateral_first = 0.0, lateral_last = 1.0;
    double longitudinal_first = 0.0, longitudinal_last = 1.0;
    Resolution resolution;
    /// Pressures found, which move along with the plane: a start for the next ones.
    Grid grid;
    std::vector<double> pressure;
    /// When the error was estimated: ends of the penetration, and the largest pressure.
    double y_first = 0.0, y_last = 0.0;
    double peak_pressure = 0.0;
  };
  bool valid = false;
  double depth = 0.0;
  double load = 0.0; ///< the one prescribed, N
  double accuracy = 0.0;
  std::vector<Patch> patches; ///< ordered by y
  /// Estimated on two grids; none if it was not met, or if the grid was given by hand. Without it
  /// the pressures are not those of the last solution.
  std::optional<double> error_estimate;
};

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
  SidePlanner(const RailSurface& rail, const SideEquilibrium& equilibrium, GapConvention gap,
              bool grid_is_given)
      : rail_(rail), equilibrium_(equilibrium), gap_(gap), grid_is_given_(grid_is_given) {}

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
  /// The same rectangle of the track, seen in the plane of another frame.
  [[nodiscard]] PlaneArea carried_over(const PlaneArea& area, const ContactFrame& from,
                                       const ContactFrame& to) const;

private:
  void join_in_one_plane(SidePlan& plan) const;
  [[nodiscard]] ContactFrame frame_of(const ContactPatch& patch) const;
  void plan_penetration(PatchPlan& patch, const Resolution& resolution) const;

  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  GapConvention gap_;
  bool grid_is_given_;
};

} // namespace wrc
