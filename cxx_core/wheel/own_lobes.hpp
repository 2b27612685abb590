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
/// lobe keeps its grid until it is lifted by lifted_approach. Grids end at the saddles, and stay
/// when pressures join there. Forces pass to those on one grid for the patch where one lobe bears
/// nearly all, and while a valley is shallower than vanishing_valley: so nothing jumps where a lobe
/// is born, lifts, or a valley appears. Its depth is that of the nodes of the scan, since a top is
/// placed only once there is one.
///
/// Units mm; left-hand frame of the side. Thread rule: a pure function. Not known here: how far
/// wheels sink under a load.
#pragma once

#include <span>
#include <vector>

#include "patches/contact_patches.hpp"

namespace wrc {

/// Patches on grids of one kind, and the share of their solution in the forces.
struct GridWay {
  ContactPatches patches;
  double share = 1.0;
};

/// Ways to give patches with several lobes grids: those with most grids first, the last with one
/// grid for each patch; shares add up to 1. `samples`: of the locus, from which the patches were
/// found, at this depth.
std::vector<GridWay>
ways_with_own_lobes(const ContactPatches& found,
                    std::span<const patch_finding::LocusSample<double>> samples);

} // namespace wrc
