#include "results/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "half_space/displacement_operator.hpp"
#include "mechanics/coupled_influence.hpp"
#include "remesh/row_scales.hpp"

namespace wrc {
namespace {

/// Adds to displacements what the other patches cause, as far as there is pressure or the own one
/// leaves overlap: nodes are best on the smallest sufficient rectangle.
void add_displacement_by_others(const WheelResult& side,
                                std::span<const PatchResult* const> patches,
                                std::vector<std::vector<double>>& displacements) {
  std::vector<std::vector<double>> pressures;
  std::vector<std::vector<double>> touched;
  std::vector<SolvedPatch> rectangles;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const PatchResult& patch = *patches[k];
    pressures.push_back(over_scales(patch.grid, patch.row_scales, patch.pressure));
    std::vector<double>& here = touched.emplace_back(pressures.back());
    const std::vector<double> distance =
        times_scales(patch.grid, patch.row_scales, patch.undeformed_distance);
    for (std::size_t i = 0; i < here.size(); ++i) {
      here[i] = std::max(here[i], -distance[i] - displacements[k][i]);
    }
    rectangles.push_back({patch.grid, here});
  }
  CoupledInfluence(rectangles, *side.details.interaction, side.details.request.combined_modulus)
      .add(pressures, displacements);
}

} // namespace

Residuals residuals_of(const WheelResult& side) {
  const std::vector<const PatchResult*> patches = solved_patches(side);
  std::vector<std::vector<double>> displacements;
  for (const PatchResult* patch : patches) {
    const std::vector<double> pressure =
        over_scales(patch->grid, patch->row_scales, patch->pressure);
    DisplacementOperator(patch->grid, side.details.request.combined_modulus,
                         side.details.request.elements, row_angles(patch->frame, patch->grid))
        .apply(pressure, displacements.emplace_back(pressure.size()));
  }
  if (side.details.interaction) {
    add_displacement_by_others(side, patches, displacements);
  }
  Residuals worst;
  double load = 0.0;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const PatchResult& patch = *patches[k];
    // Along its normal by itself.
    const std::vector<double> distance =
        times_scales(patch.grid, patch.row_scales, patch.undeformed_distance);
    const PatchGap gap{patch.grid, distance};
    NormalProblem problem;
    problem.patches = {&gap, 1};
    problem.combined_modulus = side.details.request.combined_modulus;
    problem.approach = 0.0;
    const Residuals residuals =
        compute_residuals(problem, over_scales(patch.grid, patch.row_scales, patch.pressure),
                          displacements[k], *problem.approach);
    worst.least_gap = std::min(worst.least_gap, residuals.least_gap);
    worst.complementarity = std::max(worst.complementarity, residuals.complementarity);
    load += patch.force.z;
  }
  if (side.details.load && !side.patches.empty()) {
    worst.load_balance = std::abs(load - *side.details.load) / *side.details.load;
  }
  return worst;
}

} // namespace wrc
