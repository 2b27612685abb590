/// What contact a penetration leads to, before it is solved.
///
/// The penetration by more than a fraction of the deepest, the virtual penetration of Kik and
/// Piotrowski (1996), is about as wide and long as contact. Its rows along the rail are parabolas,
///   g(x) = g - k (x - x_0)^2/2,
/// with the wheel's curvature k, and count by g^2 times their length, with which the planes of
/// contact are weighted, too (patches/contact_patches.hpp): a row that contact hardly reaches shows
/// in nothing. The scale of these rows is that of Hertz's pressures on a paraboloid, and predicts
/// errors of any contact as well as the scale of its pressures does. It is a smooth function of the
/// scene, which that of the pressures on few elements is not: their rows in contact come and go.
///
/// Units mm. Thread rule: a pure function. Not known here: how far wheels sink under a load.
#pragma once

#include <span>

#include "patches/contact_patches.hpp"
#include "pressure/contact_scale.hpp"

namespace wrc {

struct ExpectedContact {
  double mean_x = 0.0; ///< of the patch's penetration, and ...
  double mean_y = 0.0; ///< ... across the rail
  double width = 0.0;  ///< of its potential contact area, across the rail
  double length = 0.0;
  ContactScale scale;
  double middle = 0.5; ///< of the forces across the rail, relative to the width
  double bend = 0.0;   ///< Patch::bend
};

/// In the potential contact area of a patch. `samples`: of the locus, at the patch's depth. Where
/// no row penetrates, contact is as wide and long as a row.
ExpectedContact expected_contact(const ContactPatch& penetration, const ContactFrame& frame,
                                 const PlaneArea& area,
                                 std::span<const patch_finding::LocusSample<double>> samples);

/// The same of a lobe whose semi-axes are known.
ExpectedContact expected_contact(const ContactPatch& lobe, const PlaneArea& area);

} // namespace wrc
