/// Constants of behaviour of this room: approximate models of contact.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

namespace wrc {

/// Places to each side at which a gap is compared with its parabola, for the validity alone.
/// origin: reasoned: enough to see a second lobe, or the end of a flat, within a patch.
inline constexpr int compared_places = 4;

/// Nodes of the quadrature over a region, or over its part to either side of the contact point.
/// origin: measured: on Hertzian bodies 12 leave an error of 1e-5 of the load (models_test); on
/// standard profiles 24 change pmax by up to 0.7 %, far below the error of the model.
inline constexpr int penetration_nodes = 12;

/// Accuracy of searches in models: of the ends of penetration, relative to the distance between two
/// nodes of the scan, and of the depth to a load, relative to both.
/// origin: reasoned: far below the error of the quadrature and what anybody reads, above the
/// rounding of a sum.
inline constexpr double model_search_accuracy = 1e-10;

} // namespace wrc
