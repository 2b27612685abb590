/// The rigid slip of each element of a patch, and the three creepages that fit it best.
///
/// On each row of elements the surface is taken at x = 0 for all longitudinal positions x: at
/// lateral position y it lies at the height h(y) over the point where the velocities are given, and
/// rises by the angle b(y) against the plane. With the velocity v and the turning o of the wheel's
/// material against the rail's, over the speed and in the plane's axes (Twist), the slip there is
///
///   w_x = v_x - o_n y + o_y h
///   w_y = (v_y - o_x h) cos b + (v_n + o_x y) sin b + (o_n cos b - o_y sin b) x,
///
/// which is linear in x. The tangent is that of the deformed surface, of like bodies the mean of
/// rail and wheel. The height is that of the wheel before it deforms, whose rolling radius it gives
/// row by row, or of the mean surface (SlipSurface; cxx_core/creep/README.md says which and why).
///
/// Rows along a curve (patches/contact_curve.hpp) have the same formulas, with y, h and b where
/// their rays meet the surface. The creepages' spin counts with the arc
/// there, as the grid does.
///
/// The three creepages are the least-squares fit weighted with the pressures,
///
///   sum p |w - (xi - phi y, eta + phi x)|^2 = min,
///
/// which is linear in the six velocities.
///
/// Left-hand frame of the side. Units mm, MPa, rad. Thread rule: pure functions.
///
/// Not known here: that the wheel is round along x; its second order is that of terms which the
/// half-space leaves out (approach over radius).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/grid.hpp"
#include "records/creep_choice.hpp"
#include "records/motion.hpp"
#include "records/slip_geometry.hpp"
#include "remesh/surface_rays.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// One row for each of the grid's. Rows without pressure continue their neighbours (none without
/// any pressures), and so do those where a ray meets no surface.
std::vector<SlipRow> slip_rows(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
                               std::span<const double> pressure, const SlipChoice& choice);

/// Slip of a row: (along, across + turning x).
struct SlipOfRow {
  double along = 0.0;
  double across = 0.0;
  double turning = 0.0;
};
/// `approach`: depth of the point of the velocities below the plane's origin.
SlipOfRow slip_of_row(const SlipRow& row, const Twist& twist, double approach);

SlipGeometry slip_geometry(std::vector<LoadedRow> rows, double approach);
/// Those that fit the slip best.
Creepages fitted_creepages(const SlipGeometry& geometry, const Twist& twist);
/// Root mean square, weighted with pressures, of the slip that the creepages do not represent.
double slip_variation(const SlipGeometry& geometry, const Twist& twist, const Creepages& creepages);
std::vector<LoadedRow> loaded_rows(const std::vector<SlipRow>& rows, const Grid& grid,
                                   std::span<const double> pressure);
/// Rows that are given from another origin of the same plane, moved; on the grid by `on_grid`,
/// which is `lateral` unless they lie along a curve.
LoadedRow moved_row(LoadedRow row, double longitudinal, double lateral, double height,
                    double on_grid);

/// The slip of each element less that of the creepages that fit it best.
struct SlipField {
  std::vector<double> x;
  std::vector<double> y;
};
SlipField slip_beyond(const SlipGeometry& geometry, const std::vector<SlipRow>& rows,
                      const Grid& grid, const Twist& twist);
/// A velocity of 1 along the normal.
inline constexpr Twist along_the_normal{0.0, 0.0, 1.0, 0.0, 0.0, 0.0}; // not a tuning constant

/// Force and moment from those at the plane's origin; their power is that of the creepages.
Wrench wrench_of(const CreepagesByTwist& by, const std::array<double, 3>& forces);
/// What tractions on rows have beyond that, from the sums of their forces and moment: its power is
/// that of the slip beyond creepages.
Wrench wrench_beyond(const SlipGeometry& geometry, const std::vector<SlipRow>& rows,
                     const Grid& grid, std::span<const double> traction_x,
                     std::span<const double> traction_y);
/// The geometry of three creepages at the point of the velocities.
constexpr CreepagesByTwist creepages_of_planar_slip() {
  return {{{1.0, 0.0, 0.0, 0.0, 0.0, 0.0},
           {0.0, 1.0, 0.0, 0.0, 0.0, 0.0},
           {0.0, 0.0, 0.0, 0.0, 0.0, 1.0}}};
}

} // namespace wrc
