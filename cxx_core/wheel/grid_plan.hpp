/// Where the patches of a wheel are solved: planes and grids at a depth.
///
/// The planes are those of the patches of penetration (patches/contact_patches.hpp). A grid spans a
/// patch's penetration with a little room, within its lateral limits: contact cannot leave the
/// penetration, whose ends the scan knows by parabolas between its nodes. In the vertical
/// convention all patches near the main one share one plane and grid. Units mm and rad; left-hand
/// frame of the side. Thread rule: pure functions.
#pragma once

#include <utility>
#include <vector>

#include "accuracy/grid_solution.hpp"
#include "accuracy/resolution.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "wheel/wheel_request.hpp"

namespace wrc {

/// What elements the grids of patches have.
class GridChoice {
public:
  /// As many in each.
  explicit GridChoice(const ElementCounts& counts) : counts_(counts) {}
  /// Of the sizes of the nearest of these.
  explicit GridChoice(std::vector<PatchElements> elements) : elements_(std::move(elements)) {}

  /// Over the potential contact area of a patch.
  [[nodiscard]] Grid grid_of(const ContactPatch& penetration, const PlaneArea& area) const;

private:
  ElementCounts counts_;
  std::vector<PatchElements> elements_;
};

/// The patches and their planes, without grids. `depth` > 0: vertical, from the first touch.
GridSolution plan_patches(const RailSurface& rail, const SideEquilibrium& equilibrium,
                          const WheelRequest& request, double depth);

/// What contacts patches with planes lead to.
std::vector<ExpectedContact> expected_contacts(const GridSolution& patches, const RailSurface& rail,
                                               const ContactScan& scan);

/// Their grids. Nothing is sampled or solved yet.
void set_grids(GridSolution& solution, const RailSurface& rail, const GridChoice& grids);

} // namespace wrc
