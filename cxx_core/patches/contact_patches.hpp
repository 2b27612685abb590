/// All patches of virtual penetration of one wheel, each with its own contact plane.
///
/// When the wheel is lowered by a depth, wheel and rail interpenetrate over stretches of the
/// contact locus; along the rail a point with the normal penetration g reaches over x_l = sqrt(2 R
/// g), 1/R the curvature there (patches/locus_samples.hpp). Every local maximum of penetration is a
/// lobe. Lobes that are close are joined, others are patches.
///
/// Plane: every point counts with the integral of the squared penetration g along the rail's
/// normal, along the rail in closed form, W = int int g^2 dx ds = 16/15 int g^2 x_l ds. That normal
/// meets the rail at another point than the vertical does, since a wheel that sinks under a contact
/// angle slides along the tangent; by that the rail's slope there is extrapolated. The plane's
/// normal is the mean of the rail's normals and its position the mean position, both weighted so.
/// The direction of the force differs by 1 mrad on treads and flanges, and by 10 to 15 mrad with
/// two lobes.
///
/// Separation of two neighbours, without dimension:
///   D = gap / larger width                                 if they are apart,
///   D = -(least penetration between) / (deepest of the shallower one)      if they are connected.
/// The coupling weight is w = 1 for D <= D_join, 0 for D >= D_apart, smooth in between; both limits
/// fall as the planes of the two differ more. w = 1: joined, on one grid. 0 < w < 1: planes turned
/// towards each other by the fraction w, so that nothing jumps as two patches become one.
///
/// Where planes differ little, the distance d of the penetrations in the cross-section counts, too,
/// with a joining distance d_j in mm, as in CONTACT (Vollebregt, User guide for CONTACT, where d_j,
/// 2 d_j and 3 d_j are D_COMB, D_SEP and D_TURN): planes turn towards each other from 3 d_j on and
/// are one from 2 d_j on; w grows from 2 d_j on and is 1 from d_j on, all linearly. Two in one
/// plane are one contact, on grids of their own until they are joined. The greater fraction counts,
/// by width or by distance.
///
/// Which patches displace each other does not depend on which share a plane. All patches press on
/// the same two bodies, so a patch displaces every other one as a half-space does along its normal
/// at their distance, times the cosine between both normals: along the tangent like bodies move by
/// the same amount. This is C A C + S A S with the cosines and sines of their angles, positive
/// definite. On a convex rail the true displacement is larger, on a concave wheel smaller; together
/// they are within 4 % at 8 mm (docs/evidence/half-space.md). Interaction::near takes w instead, as
/// CONTACT does, which leaves patches beyond 2 d_j uncoupled. In its case extreme-160, two
/// patches 10.5 mm apart in planes 0.04 rad apart, the small one then carries 64 % more. The
/// coupling of distant patches is that of the weakest link between them: such an (ultrametric)
/// matrix has no negative eigenvalue.
///
/// The angle of a plane is the mean over all levels between 0 and 1 of the plane of the patches
/// that turn at least that far towards each other, which for two is angle = own + turn (mean of
/// both - own).
///
/// Between nodes of the scan and its locally least distances, the tops, penetration is a cubic with
/// their slopes. Integrals by Simpson's rule. Everything is thus continuous in the depth, except
/// for how a patch just born between two others changes their coupling weight, and has a limit for
/// depth -> 0. In the position it is, too, except for what a cubic leaves where a top appears
/// between two nodes: on treads forces step by up to 2e-5 of the load where the rail's curvature
/// jumps there, at the flange's root by up to 1.2e-4. Units mm and rad; track frame, left-hand side
/// (geometry/frames.hpp). Thread rule: pure functions. Not known here: elasticity.
#pragma once

#include <span>
#include <vector>

#include "geometry/contact_search.hpp"
#include "patches/contact_frame.hpp"
#include "patches/contact_patch.hpp"
#include "patches/locus_samples.hpp"
#include "patches/plane_area.hpp"

namespace wrc {

/// `depth` > 0: how far the wheel is lowered vertically from the first touch. The scan's nearest
/// candidate must be there; without samples nothing else is seen.
ContactPatches find_contact_patches(const ContactScan& scan, double depth,
                                    const PatchOptions& options = {0.0});

/// The same for several scans, that of the first contact first. Patches of different scans that
/// overlap, seen from above, are one.
ContactPatches find_contact_patches(std::span<const ContactScan* const> scans, double depth,
                                    const PatchOptions& options);

/// Both as one, with one plane; the weights of both count.
ContactPatch joined(const ContactPatch& one, const ContactPatch& other);

/// What these are found from.
std::vector<patch_finding::LocusSample<double>> locus_samples(const ContactScan& scan,
                                                              double depth);

/// The rectangle that holds a patch's penetration, seen along the frame's normal.
PlaneArea area_of(const ContactPatch& patch, const RailSurface& rail, const ContactFrame& frame);
/// The part of an area that lies in the patch's territory, at least a thousandth as wide as long.
PlaneArea within_limits(const PlaneArea& area, const ContactPatch& patch, const RailSurface& rail,
                        const ContactFrame& frame);

} // namespace wrc
