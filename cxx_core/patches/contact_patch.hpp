/// Patches of virtual penetration, as patches/contact_patches.hpp finds them.
///
/// Units mm and rad; track frame, left-hand side (geometry/frames.hpp). Thread rule: plain values.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace wrc {

/// A region of penetration that shares one plane.
struct ContactPatch {
  double y_first = 0.0; ///< ends of penetration, track side and ...
  double y_last = 0.0;  ///< ... field side
  double x_first = 0.0;
  double x_last = 0.0;
  double half_length = 0.0;    ///< largest x_l
  double deepest = 0.0;        ///< largest vertical penetration
  double deepest_y = 0.0;      ///< its position in the track frame and ...
  double deepest_s = 0.0;      ///< ... on the wheel's profile
  double weight = 1.0;         ///< fraction of the weight W of all patches of the wheel
  double angle_unturned = 0.0; ///< of the rail's mean normal in this patch by itself
  double deviation = 0.0;      ///< of the rail's angle from it, standard, weighted like the angle
  double angle = 0.0;          ///< of its plane, turned towards close neighbours
  double rise = 0.0;           ///< of the rail along the track over its plane across, likewise
  double ahead = 0.0;          ///< of where it is under a round wheel on a prismatic rail, likewise
  double mean_x = 0.0;         ///< mean position, weighted like the angle
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
  int lobes = 1;        ///< joined in it
  std::size_t scan = 0; ///< that it was found in, of several
  bool shares_plane_with_previous =
      false;                ///< shares its plane with the patch before: both are one contact
  bool joins_scans = false; ///< found in several, of which `scan` has the deepest point

  /// Whether the deepest point of another patch, at another depth, lies in this one.
  [[nodiscard]] bool holds(const ContactPatch& other) const {
    return y_first <= other.deepest_y && other.deepest_y <= y_last;
  }
};

/// Which patches of a wheel displace each other.
enum class Interaction {
  all, ///< in proportion to the cosine between their planes
  near ///< those close to each other, by their links
};

/// How patches are found, and which of them interact.
struct PatchOptions {
  /// d_j of contact_patches.hpp, mm; 0: patches are close by their own widths alone.
  double joining_distance = 4.0;
  Interaction interaction = Interaction::all;
};

struct ContactPatches {
  std::vector<ContactPatch> patches; ///< ordered by y, never empty
  std::vector<double> links;         ///< how close each one and the next are: 0 to 1, joined
  std::size_t main = 0;              ///< the one that holds the first contact
  double weight = 0.0;               ///< W of all, over a power of the depth

  /// 0: no interaction; 1: in full.
  [[nodiscard]] double coupling_weight(std::size_t i, std::size_t j, Interaction interaction) const;
};

} // namespace wrc
