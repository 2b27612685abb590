/// Lobes of penetration that carry pressures of their own, so that each has a grid of its own.
///
/// Where lobes share a grid, its elements are large for each of them, and one that comes into
/// contact changes the stiffness of a lobe that is three rows wide by a third. On a grid that
/// follows its lobe the elements in contact stay the same, so that forces have the slope of the
/// solution (docs/evidence/derivatives.md).
///
/// Lobe l overlaps by d_l along the normal. The others displace it as lines along the rail do with
/// the loads N of Hertz's ellipses, semi-axes a along and b across the rail, at a distance r
/// (Boussinesq; Johnson, Contact Mechanics, 1985, eq. 3.22, integrated), with t = r/a:
///   e_l = d_l - u_l,
///   u_l = sum of 3 N/(4 pi E* a) [(2 + t^2) arsinh(1/t) - sqrt(1 + t^2)] (1 + b^2/(5 r^2)).
/// What of the lobe is deeper than d_l - 0.55 e_l, the virtual penetration of Kik and Piotrowski
/// (1996), is measured with the weights of patches/contact_patches.hpp: its mean is where the grid
/// is, and the paraboloid of the same variance has, with the approach e_l, the load N and the
/// semi-axes (models/hertz.hpp). E* cancels. Loads and displacements follow from each other, the
/// deepest lobe first. Below an approach of about least_lobe_approach sizes hardly shrink, and a
/// lobe keeps its grid until it is lifted by lifted_approach; one that carries nearly all the load
/// has the elements of the whole patch: so nothing jumps where a lobe is born or lifts. Two lobes
/// are one where the bodies, so displaced, touch at the saddle between; there forces jump by the
/// error of one grid.
///
/// Units mm; left-hand frame of the side. Thread rule: a pure function. Not known here: how far
/// wheels sink under a load.
#pragma once

#include <span>

#include "patches/contact_patches.hpp"

namespace wrc {

/// Patches with several lobes as lobes that share a plane, where these lie far enough apart.
/// `samples`: of the locus, from which the patches were found, at this depth.
ContactPatches with_own_lobes(const ContactPatches& found, const RailSurface& rail,
                              std::span<const patch_finding::LocusSample<double>> samples);

} // namespace wrc
