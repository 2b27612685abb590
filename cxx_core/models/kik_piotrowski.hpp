/// Contact by virtual penetration: a load and semi-elliptic pressures without iteration.
///
/// Bodies that approach each other by delta are laid over each other by 0.55 delta only; the region
/// of that virtual penetration g(y) replaces the contact area. A strip along the rail reaches over
/// x_c(y) +- l(y), l = sqrt(2 R g), and carries p = c sqrt(l^2 - (x - x_c)^2). At the contact point
/// the half-space sinks by the approach (Boussinesq):
///   c = pi E* delta / I2,  N = c I1,
///   I1 = int int sqrt(l^2 - (x - x_c)^2) dx dy = pi/2 int l^2 dy,
///   I2 = int int sqrt(l^2 - (x - x_c)^2) / sqrt(x^2 + y^2) dx dy
/// (Piotrowski & Kik, Vehicle System Dynamics 46, 2008, pp. 27-48, there with E/(2 (1 - nu^2)) for
/// E* of equal bodies). A strip through the contact point's column has
///   int sqrt(l^2 - x^2)/sqrt(x^2 + y^2) dx = 2 l^2/sqrt(l^2 + y^2) D(k = |y|/sqrt(l^2 + y^2)),
/// and one beside it (the yawed wheel: Liu, Bruni & Vollebregt, VSD 54, 2016, have strips centred
/// at x_c(y)) is integrated after x = |y| sinh t, which takes the singularity away.
/// Shape correction (2008 paper): the region has the axis ratio sqrt(B/A) of its
/// curvatures, an elastic ellipse the one that Hertz gives for B/A; x is stretched and y shortened
/// to that ratio at equal area. The half width is that of the ellipse with the region's area and
/// greatest half length, so that nothing jumps when a further lobe begins to penetrate.
/// For an ellipse with A x^2 + B y^2 this gives N = 2/3 pi E* a delta/K(e), Hertz's law, on an area
/// of 0.55 pi delta/sqrt(A B). Hertz's own area is 0.5 of that for a circle and less for others.
/// Units mm, N, MPa; x along the rail, y across it, from the contact point. Thread rule: pure.
/// Not known here: how the strips were found; that other patches displace the surface.
#pragma once

#include <span>

#include "models/constants.hpp"
#include "patches/constants.hpp"

namespace wrc {

/// A strip of the virtual penetration, and what it counts in an integral over y.
struct KikPiotrowskiStrip {
  double lateral = 0.0;
  double weight = 0.0; ///< mm
  double half_length_square = 0.0;
  double centre = 0.0; ///< x_c
};

struct KikPiotrowskiContact {
  double normal_force = 0.0;
  double peak_pressure = 0.0;
  double area = 0.0;
  /// x is stretched by this factor, y shortened; centres of strips stay.
  double stretch = 1.0;
  double pressure_factor = 0.0; ///< c, of the stretched half lengths
  double centroid_longitudinal = 0.0;
  double centroid_lateral = 0.0;
  /// Semi-axis of the Hertzian ellipse with the same second moments of pressure.
  double semi_axis_longitudinal = 0.0;
  double semi_axis_lateral = 0.0;
};

/// `strips` are the nodes of a quadrature rule that bears a logarithmic singularity at y = 0, where
/// no node may lie. `greatest_half_length`: over all y, nodes or not. Approach and half length > 0.
/// Throws no_contact where the strips have no area.
KikPiotrowskiContact solve_virtual_penetration(std::span<const KikPiotrowskiStrip> strips,
                                               double greatest_half_length, double combined_modulus,
                                               double approach);

} // namespace wrc
