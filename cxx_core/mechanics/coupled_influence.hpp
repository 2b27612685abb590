/// The influence of the patches of a normal problem on each other, for its stiffness and residuals.
///
/// The same operator as in the solution (normal_contact.hpp, patch_coupling.hpp): all patches in
/// their mean plane, each pair counted with its coupling weight; on boxes around the pressures.
/// With the rates of the coupling weight instead it is the rate of that operator. Units mm, MPa.
/// Thread rule: one object serves one thread at a time.
#pragma once

#include <span>
#include <vector>

#include "mechanics/cascade.hpp"
#include "mechanics/normal_contact.hpp"
#include "mechanics/patch_coupling.hpp"

namespace wrc {

/// A patch as it was solved; only where the pressure is positive counts.
struct SolvedPatch {
  Grid grid;
  std::span<const double> pressure;
  Elements elements = Elements::constant;
  std::span<const double> angles = {};     ///< of rows along a curve
  std::span<const double> row_scales = {}; ///< of these pressures over those of solvers
};

/// What patches do to each other, if anything. One field a patch, in the order of its grid.
class PatchInfluence {
public:
  PatchInfluence() = default;
  PatchInfluence(const PatchInfluence&) = delete;
  PatchInfluence& operator=(const PatchInfluence&) = delete;
  virtual ~PatchInfluence() = default;
  /// Adds to each patch's displacement, mm, what the pressures of all others, MPa, cause there.
  /// Symmetric: element i of one patch displaces element j of another, per force, as j does i.
  virtual void add(std::span<const std::vector<double>> pressure,
                   std::span<std::vector<double>> displacement) = 0;
};

/// A box of a patch's elements in the mean plane.
Grid grid_in_mean_plane(const Grid& grid, const PatchInteraction::Place& place,
                        const ElementBox& box);

class CoupledInfluence : public PatchInfluence {
public:
  /// On boxes around the positive values of the patches, of which each must have some.
  CoupledInfluence(std::span<const SolvedPatch> patches, const PatchInteraction& interaction,
                   double combined_modulus);

  void add(std::span<const std::vector<double>> pressure,
           std::span<std::vector<double>> displacement) override;

private:
  struct Box {
    LevelSize size; ///< of the grid
    ElementBox elements;
    double unit = 1.0; ///< mm per MPa and unit of the coupling
    std::vector<double> values;
  };
  static std::vector<Grid> coupled_boxes(std::span<const SolvedPatch> patches,
                                         const PatchInteraction& interaction,
                                         const std::vector<Box>& boxes);
  static std::vector<Box> boxes_of(std::span<const SolvedPatch> patches, double combined_modulus);

  std::vector<Box> boxes_;
  PatchCoupling coupling_;
  NodeField field_;
  std::vector<double> sum_; ///< over a box
};

} // namespace wrc
