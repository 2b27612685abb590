#include "results/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "half_space/displacement_operator.hpp"
#include "mechanics/coupled_influence.hpp"
#include "mechanics/yielding.hpp"
#include "remesh/row_scales.hpp"

namespace wrc {
namespace {

using Fields = std::vector<std::vector<double>>; // one of each patch

/// Displacements of patches by their pressures, each by its own.
Fields displaced(const WheelResult& side, std::span<const PatchResult* const> patches,
                 const Fields& pressures) {
  Fields displacements;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const PatchResult& patch = *patches[k];
    DisplacementOperator(patch.grid, side.details.request.combined_modulus,
                         side.details.request.elements, row_angles(patch.frame, patch.grid))
        .apply(pressures[k], displacements.emplace_back(pressures[k].size()));
  }
  return displacements;
}

/// What the patches cause at each other, as far as there is pressure or the own one leaves overlap:
/// nodes are best on the smallest sufficient rectangle.
std::optional<CoupledInfluence> influence_of(const WheelResult& side,
                                             std::span<const PatchResult* const> patches,
                                             const Fields& pressures, const Fields& displacements) {
  if (!side.details.interaction) {
    return std::nullopt;
  }
  Fields touched = pressures;
  std::vector<SolvedPatch> rectangles;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const PatchResult& patch = *patches[k];
    const std::vector<double> distance =
        times_scales(patch.grid, patch.row_scales, patch.undeformed_distance);
    for (std::size_t i = 0; i < touched[k].size(); ++i) {
      touched[k][i] = std::max(touched[k][i], -distance[i] - displacements[k][i]);
    }
    rectangles.push_back({patch.grid, touched[k]});
  }
  return std::optional<CoupledInfluence>(std::in_place, rectangles, *side.details.interaction,
                                         side.details.request.combined_modulus);
}

/// Adds the indentation of steel that yields.
void add_indentations(const WheelResult& side, std::span<const PatchResult* const> patches,
                      const Fields& pressures, std::optional<CoupledInfluence>& influence,
                      Fields& displacements) {
  std::vector<YieldTerms> terms;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    terms.emplace_back(patches[k]->grid, pressures[k], patches[k]->row_scales,
                       yielding_of(*patches[k], side.details), patches[k]->groove.carried);
  }
  for (std::size_t b = 0; !terms.empty() && b < terms.front().excess.size(); ++b) {
    Fields excess;
    for (const YieldTerms& of_patch : terms) {
      excess.push_back(of_patch.excess[b]);
    }
    Fields by_excess = displaced(side, patches, excess);
    if (influence) {
      influence->add(excess, by_excess);
    }
    for (std::size_t k = 0; k < patches.size(); ++k) {
      terms[k].add_indentation(b, by_excess[k], displacements[k]);
    }
  }
}

} // namespace

Residuals residuals_of(const WheelResult& side) {
  const std::vector<const PatchResult*> patches = solved_patches(side);
  Fields pressures;
  for (const PatchResult* patch : patches) {
    pressures.push_back(over_scales(patch->grid, patch->row_scales, patch->pressure));
  }
  Fields displacements = displaced(side, patches, pressures);
  std::optional<CoupledInfluence> influence = influence_of(side, patches, pressures, displacements);
  if (influence) {
    influence->add(pressures, displacements);
  }
  add_indentations(side, patches, pressures, influence, displacements);
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
        compute_residuals(problem, pressures[k], displacements[k], *problem.approach);
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
