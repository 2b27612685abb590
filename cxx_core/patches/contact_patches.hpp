/// All patches of virtual penetration of one wheel, each with its own contact plane.
///
/// When the wheel is lowered by a depth, wheel and rail interpenetrate over stretches of the
/// contact locus; along the rail a place with the normal penetration g reaches over x_l = sqrt(2 R
/// g), 1/R the curvature there (patches/locus_samples.hpp). Every local maximum of penetration is a
/// lobe. Lobes that are close are joined, others are patches.
///
/// Plane: every place counts with the integral of the squared vertical penetration over the track
/// plane, along the rail in closed form, W = int int g^2 dx dy = 16/15 int g^2 x_l dy. The plane's
/// normal is the mean of the rail's normals and its place the mean place, both weighted so. In 23
/// wheel/rail cases this meets the contact reference of CONTACT to 0.1 mrad and 0.01 mm; the
/// penetrated volume, int int g dx dy, is up to 10 mrad off. The angle weighted with
/// the pressures of a half-space solution differs by 0.4 mrad in the median, up to 13 mrad with two
/// lobes.
///
/// Separation of two neighbours, without dimension:
///   D = gap / larger width                                 if they are apart,
///   D = -(least penetration between) / (deepest of the shallower one)      if they are connected.
/// Coupling weight w = 1 for D <= D_join, 0 for D >= D_apart, smooth in between; both limits fall
/// as the planes of the two differ more. w = 1: joined, on one grid. 0 < w < 1: planes turned
/// towards each other by the share w, so that nothing jumps on the way from two patches to one.
///
/// Where planes differ little, the distance d of the penetrations in the cross-section counts, too,
/// with a joining distance d_j in mm, as in CONTACT (Vollebregt, User guide for CONTACT, where d_j,
/// 2 d_j and 3 d_j are D_COMB, D_SEP and D_TURN): planes turn towards each other from 3 d_j on and
/// are one from 2 d_j on; patches interact from 2 d_j on, in full from d_j on, all linearly.
/// Two in one plane are one contact, on grids of their own until they are joined. The greater share
/// counts, by width or by distance.
///
/// Patches further on are as close as the weakest link between: such an (ultrametric) matrix has no
/// negative eigenvalue. The angle of a plane is the mean over all levels between 0 and 1 of the
/// plane of the patches that turn at least that far towards each other, which for two is
/// angle = own + turn (mean of both - own).
///
/// Between nodes of the scan penetration is a parabola: next to a local maximum with its top there,
/// elsewhere with the curvature of the nodes around. The top is the candidate of the scan that lies
/// there. Integrals by Simpson's rule. Everything is thus continuous in the depth, except for what
/// a patch just born between two others changes in their coupling weight, and has a limit for depth
/// -> 0. Units mm and rad; track frame, left-hand side (geometry/frames.hpp). Thread rule: pure
/// functions. Not known here: elasticity.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "geometry/contact_search.hpp"
#include "patches/contact_frame.hpp"
#include "patches/locus_samples.hpp"
#include "patches/plane_area.hpp"

namespace wrc {

/// A region of penetration that shares one plane.
struct ContactPatch {
  double y_first = 0.0; ///< ends of penetration, track side and ...
  double y_last = 0.0;  ///< ... field side
  double x_first = 0.0;
  double x_last = 0.0;
  double half_length = 0.0;    ///< largest x_l
  double deepest = 0.0;        ///< largest vertical penetration
  double deepest_y = 0.0;      ///< its place in the track frame and ...
  double deepest_s = 0.0;      ///< ... on the wheel's profile
  double weight = 1.0;         ///< share of the weight W of all patches of the wheel
  double angle_unturned = 0.0; ///< of the rail's mean normal in this patch by itself
  double angle = 0.0;          ///< of its plane, turned towards close neighbours
  double mean_x = 0.0;         ///< mean place, weighted like the angle
  double mean_y = 0.0;
  double mean_s = 0.0;
  /// Ends of the region that approximates the contact itself, where penetration exceeds 0.45 of the
  /// deepest (virtual penetration after Kik & Piotrowski), and the rail's angles there.
  double contact_first = 0.0;
  double contact_last = 0.0;
  double angle_first = 0.0;
  double angle_last = 0.0;
  /// Limits in y for its potential contact area: the valley or the middle of the gap towards a
  /// neighbour, infinite on the outside.
  double limit_first = -std::numeric_limits<double>::infinity();
  double limit_last = std::numeric_limits<double>::infinity();
  int lobes = 1; ///< joined in it
  bool shares_plane_with_previous =
      false; ///< shares its plane with the patch before: both are one contact

  /// Whether the deepest place of another patch, at another depth, lies in this one.
  [[nodiscard]] bool holds(const ContactPatch& other) const {
    return y_first <= other.deepest_y && other.deepest_y <= y_last;
  }
};

struct ContactPatches {
  std::vector<ContactPatch> patches; ///< ordered by y, never empty
  std::vector<double> links;         ///< coupling weight of each one and the next
  std::size_t main = 0;              ///< the one that holds the first contact

  /// 0: no interaction; 1: in full.
  [[nodiscard]] double coupling_weight(std::size_t i, std::size_t j) const;
};

/// `depth` > 0: how far the wheel is lowered vertically from the first touch. The scan's nearest
/// candidate must be there; without samples nothing else is seen. `joining_distance`: d_j in mm; 0:
/// patches are close by their own widths alone.
ContactPatches find_contact_patches(const ContactScan& scan, double depth,
                                    double joining_distance = 0.0);

/// What these are found from.
std::vector<patch_finding::LocusSample<double>> locus_samples(const ContactScan& scan,
                                                              double depth);

/// The rectangle that holds a patch's penetration, seen along the frame's normal.
PlaneArea area_of(const ContactPatch& patch, const RailSurface& rail, const ContactFrame& frame);
/// The part of an area that lies in the patch's territory, at least a thousandth as wide as long.
PlaneArea within_limits(const PlaneArea& area, const ContactPatch& patch, const RailSurface& rail,
                        const ContactFrame& frame);

} // namespace wrc
