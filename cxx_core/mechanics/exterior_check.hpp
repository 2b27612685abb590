/// Whether contact was missed outside the rectangle that the iteration worked on.
///
/// A solution on a rectangle of elements is one of the whole grid if no element outside overlaps:
/// g = h + u - s delta >= 0 there. Displacements are positive, so only elements in the penetration,
/// h < s delta, can; u there takes one convolution, in single precision where the tolerance allows.
/// Lengths without dimension (scaled_problem.hpp). Thread rule: that of the cache and workspaces.
#pragma once

#include <cstddef>
#include <optional>

#include "half_space/box_convolution.hpp"
#include "mechanics/scaled_problem.hpp"

namespace wrc {

struct ExteriorCheck {
  InfluenceCache& cache;
  ConvolutionWorkspace<float>& single_workspace;
  ConvolutionWorkspace<double>& double_workspace;

  /// The box of patch `k` enlarged by the overlap found outside, or none. `approach`: that of the
  /// solution; `permitted_error`: of a pressure.
  [[nodiscard]] std::optional<ElementBox> larger_box(const ScaledProblem& problem, std::size_t k,
                                                     double approach, double permitted_error) const;
};

} // namespace wrc
