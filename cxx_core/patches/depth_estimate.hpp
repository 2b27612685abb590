/// How far a wheel sinks under a load: a start for half-space solutions and nothing else.
///
/// Each patch (patches/contact_patches.hpp) carries what Hertz's law gives for an ellipse with the
/// axis ratio of its virtual penetration, the region in which penetration exceeds 0.45 of the
/// patch's own deepest (Piotrowski & Kik 2008). With the deepest normal penetration d, the longer
/// semi-axis a and the eccentricity e of the ellipse: N = 2/3 pi E* a d / K(e).
/// The patches do not interact here.
/// Units mm, N, MPa. Thread rule: pure functions.
#pragma once

#include "geometry/contact_search.hpp"
#include "patches/constants.hpp"

namespace wrc {

enum class LoadDirection {
  vertical,   ///< sum of cos(angle) N
  main_normal ///< along the normal of the main patch: sum of cos(angle - angle of main) N
};

/// Load of all patches together when the wheel is lowered by `depth` > 0.
double estimate_load(const ContactScan& scan, double combined_modulus, double depth,
                     LoadDirection direction);

/// Depth, to about one per cent of this estimate and at most 50 mm, that carries the load > 0.
double estimate_depth(const ContactScan& scan, double combined_modulus, double load,
                      LoadDirection direction);

} // namespace wrc
