/// One patch of a wheel by an approximate contact model, at any depth of the wheel.
///
/// `HertzPatch`: the ellipse of the curvatures at the point of deepest penetration, in the tangent
/// plane there, taken from the profiles themselves. With the least gap of a strip S y^2/2 at x_c =
/// c y (models/contact_strips.hpp) the gap has the second derivatives h_xx = kappa, h_xy = -c
/// kappa, h_yy = S + c^2 kappa; the ellipse lies along the principal axes. Where bodies do not part
/// by curvature (a kink), S is that of the parabola over the width of virtual penetration.
/// `KikPiotrowskiPatch`: Kik & Piotrowski's virtual penetration (models/kik_piotrowski.hpp) in the
/// plane that the half-space solution has. Normal penetration of a strip: the vertical one over
/// n . (-p, -q, 1), n the plane's normal, p and q the rail's slopes. The part of a patch that
/// penetrates by more than 0.45 of the maximum is its contact, whether connected or not.
///
/// Validity, between 0 and 1: 1 less the largest difference between the shape found and the one
/// that the model's half-space solution assumes, relative to that:
///   Hertz: |gap - S y^2/2| over S b^2/2 within the ellipse, |y| <= b; and at both ends of virtual
///   penetration, of which one lies in another lobe if there is one, gap and S y^2/2, the smaller
///   one against the larger;
///   Kik & Piotrowski: |l^2/l_max^2 - (1 - (y/w)^2)|, against the ellipse of the same area and
///   length about the same centre, at the strips and at both ends;
///   both, of profiles that vary: |gap - kappa x^2/2| over kappa a^2/2 along the rail through the
///   deepest point, within the length a of contact, or of virtual penetration, to each side.
/// 0 if several regions make up the patch, of which models know only that of the deepest point
/// where it is of several scans (both ends of a flat or of a gap), or if contact ends at the end of
/// a profile or at the border to a neighbour; times 1 - coupling weight to that neighbour, since
/// models do not couple patches. Units mm, N, MPa, rad; left-hand frame of the side. Thread rule:
/// one object, one thread.
#pragma once

#include <memory>
#include <vector>

#include "base/grid.hpp"
#include "geometry/contact_search.hpp"
#include "models/contact_strips.hpp"
#include "patches/contact_frame.hpp"
#include "patches/contact_patches.hpp"
#include "patches/plane_area.hpp"

namespace wrc {

/// What all patches of a scan have in common.
struct ModelWheel {
  const ContactScan& scan; ///< on which the patches were found
  ContactStrips strips;
  double first_touch; ///< height of the wheelset's centre
  double combined_modulus;
};

struct ModelledPatch {
  double normal_force = 0.0;
  double peak_pressure = 0.0;
  double area = 0.0;
  double approach = 0.0; ///< deepest penetration along the normal
  double validity = 0.0;
  /// Centre of pressure in the patch's frame.
  double centroid_longitudinal = 0.0;
  double centroid_lateral = 0.0;
  /// Semi-axis of the Hertzian ellipse with the same second moments of pressure.
  double semi_axis_longitudinal = 0.0;
  double semi_axis_lateral = 0.0;
  PlaneArea extent; ///< of the contact
};

class PatchModel {
public:
  virtual ~PatchModel() = default;
  PatchModel(const PatchModel&) = delete;
  PatchModel& operator=(const PatchModel&) = delete;

  [[nodiscard]] const ContactFrame& frame() const { return frame_; }
  /// Normal force at a depth of the wheel > 0; 0 where the patch does not penetrate.
  virtual double load(double depth) = 0;
  /// All of the patch at a depth with a load.
  virtual ModelledPatch solve(double depth) = 0;
  /// Pressure at the element centres, of the depth solved last.
  virtual std::vector<double> sample(const Grid& grid) const = 0;

protected:
  explicit PatchModel(const ContactFrame& frame) : frame_(frame) {}
  /// Along the frame's normal, of a vertical distance over the rail with these slopes.
  [[nodiscard]] double along_normal(double distance, double slope, double rise) const {
    return distance / (frame_.normal.z - slope * frame_.normal.y - rise * frame_.normal.x);
  }
  ContactFrame frame_;
};

/// Both kinds, of a patch found at a depth. `side` must outlive them; `frame`: the patch's plane.
std::unique_ptr<PatchModel> make_hertz_patch(const ModelWheel& side, const ContactPatch& place);
std::unique_ptr<PatchModel> make_kik_piotrowski_patch(const ModelWheel& side,
                                                      const ContactPatch& place,
                                                      const ContactFrame& frame);

} // namespace wrc
