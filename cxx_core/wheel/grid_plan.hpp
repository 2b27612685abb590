/// Where the patches of a wheel are solved: planes and grids at a depth.
///
/// The planes are those of the patches of penetration (patches/contact_patches.hpp). A grid spans a
/// patch's penetration with a little room, within its lateral limits: contact cannot leave the
/// penetration, whose ends the scan knows by cubics between its nodes. Along a curve its width
/// is that of the arc. In the vertical convention all patches near the main one have one plane and
/// grid. Units mm and rad; left-hand frame of the side. Thread rule: pure functions.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "accuracy/grid_solution.hpp"
#include "accuracy/resolution.hpp"
#include "geometry/wheelset_equilibrium.hpp"
#include "records/wheel_request.hpp"

namespace wrc {

/// What elements the grids of patches have.
class GridChoice {
public:
  /// The same number in each patch.
  explicit GridChoice(const ElementCounts& counts) : counts_(counts) {}
  /// With element sizes of the nearest of these patches.
  explicit GridChoice(std::vector<PatchElements> elements) : elements_(std::move(elements)) {}

  /// Over the potential contact area of a patch, which is that in its plane.
  [[nodiscard]] Grid grid_of(const Patch& patch, const PlaneArea& area) const;
  /// With elements this many times longer and wider; numbers of elements stay.
  [[nodiscard]] GridChoice coarser(double times) const;
  [[nodiscard]] bool by_size() const { return !elements_.empty(); }

private:
  [[nodiscard]] const PatchElements& nearest(const ContactPatch& penetration) const;

  ElementCounts counts_;
  std::vector<PatchElements> elements_;
};

/// Number of iterations after which a solution on this number of elements ends, at least 1.
int affordable_iterations(double elements, double limit);

/// The patches and their planes, without grids. `depth` > 0: vertical, from the first touch.
GridSolution plan_patches(const RailSurface& rail, const SideEquilibrium& equilibrium,
                          const WheelRequest& request, double depth);

/// Patch::bend, of patches without grids; 0 of a round wheel on a rail that does not vary.
void set_bends(GridSolution& patches, const PosedPair& pair);

/// What contacts patches with planes lead to.
std::vector<ExpectedContact> expected_contacts(const GridSolution& patches, const RailSurface& rail,
                                               const SideEquilibrium& equilibrium);

/// Curves in place of the planes (remesh/mean_curve.hpp), one for all patches of a plane; as far as
/// the request's accuracy needs them (accuracy/model_error.hpp).
void set_curves(GridSolution& solution, const PosedPair& pair, const WheelRequest& request);

/// Their grids. Nothing is sampled or solved yet. Elements that follow from an accuracy are as much
/// larger in all patches as makes them `limit` together at most; returned is how many they would be
/// without.
double set_grids(GridSolution& solution, const RailSurface& rail, const GridChoice& grids,
                 double limit);

/// A patch just born: its penetration at a depth less than the one found is too small for it.
bool outgrows_grid(const GridSolution& solution);

} // namespace wrc
