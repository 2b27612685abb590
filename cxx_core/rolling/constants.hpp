/// Constants of behaviour of this room: tangential contact.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

namespace wrc {

/// Decay of the march's memory: the symbol |k| is taken as sqrt(kx^2 + (decay/b)^2), b half the
/// width of the contact.
/// origin: measured (a trial of the method, 40 to 60 ellipses): convolutions vary by 4 % from 2
/// to 5.
inline constexpr double march_decay = 3.0;

/// The march's diagonal over that of its factors.
/// origin: measured (a trial of the method, 40 to 60 ellipses): 1.3 to 2.2 within 5 %; below 1
/// Newton's steps are bad.
inline constexpr double march_scale = 1.5;

/// Exponentials that stand for the fractional power (Gauss-Chebyshev).
/// origin: derived: exact for the first eleven terms of the series.
inline constexpr std::size_t march_terms = 6;

/// The compliance that moves the leading edge by half an element, ...
/// origin: derived: from the half-plane without slip (LeadingEdge.ComesFromTheHalfPlane).
inline constexpr double edge_stiffening = 2.965;

/// ... and the value that stands for the traction of a whole first element, over its mean:
/// leading_edge.hpp.
/// origin: derived: as edge_stiffening.
inline constexpr double edge_traction = 1.08;

/// Distance of an edge that runs obliquely through strips behind its true position, over its slope,
/// times 1 - 2 nu for tractions in x and 1 + 2 nu for those in y: displacements across an oblique
/// edge are not those along it.
/// origin: measured (ellipses 1.27 and 3 times as long as wide, 40 elements against 120): without
/// Poisson's ratio forces are right with 0.04 and 0.06, ratios of 0.28 and 0.5 take 0.10 of
/// themselves from that in x and add 0.05 in y; strips of the half-plane with such an edge give
/// 0.03 to 0.08. With 0.08 in both directions at 0.28, longitudinal forces of round contacts exceed
/// their value by 7e-4 of mu N on 40 elements, now by 1e-4.
inline constexpr double edge_advance = 0.05;

/// Reduction of the slip that pressures of unlike bodies cause in the first element of a strip, as
/// a fraction of its value in the plane problem. The slip has an infinite slope there, which one
/// value per element overstates.
/// origin: measured (ellipses a/b = 0.5 of aluminium on steel, 64 elements): with 0, 0.05 and 0.1
/// forces are off by up to 1.2e-3, 1.0e-3 and 2.4e-3 of mu N. The half-plane without slip needs 0.1
/// on average over the position of the edge in its element.
inline constexpr double edge_slip_share = 0.05;

/// The smallest covered fraction of a first element.
/// origin: reasoned: less carries nothing, and 1/c is bounded. With 30 % more, errors of creep
/// forces at 1e-3 change by up to 3e-3 of themselves (scripts/vary_constant.py).
inline constexpr double min_edge_share = 1e-3;

/// r of the natural residual q - cut(q - r s), over the inverse of an element's self-influence.
/// origin: measured (wrc_benchmark --case rolling): twice as much costs a quarter more
/// convolutions, half as much a tenth.
inline constexpr double natural_step = 0.5;

/// Relative accuracy of a linear solution, ...
/// origin: measured (wrc_benchmark --case service --creep, 1e-3): convolutions times elements are
/// within 4 % from 0.2 to 0.4, on S1002 8 % more with 0.1 and 10 % with 0.5.
inline constexpr double forcing = 0.3;

/// ... but not better than this fraction of the remaining residual of Newton's method.
/// origin: measured (the same): 2 to 4 % fewer than with 0.3; with 0.7, 2 to 5 % fewer still, 1e-3
/// is met on 98.97 instead of 99.04 % of 3023 patches.
inline constexpr double forcing_of_rest = 0.5;

/// Steps of GMRES without restart.
/// origin: bound: of memory; measured (a trial of the method, 40 to 60 ellipses): half a dozen
/// suffice for `forcing`.
inline constexpr std::size_t krylov_limit = 12;

/// A step that lets the residual grow by more is shortened.
/// origin: reasoned: the edge of adhesion moves by several elements without it growing as much.
inline constexpr double allowed_growth = 2.0;

/// Steps without progress after which the diagonal is raised, ...
/// origin: reasoned: an edge of adhesion that moves back and forth shows within a few steps.
inline constexpr int patience = 4;

/// ... by this fraction of the self-influence, ...
/// origin: reasoned: small beside the diagonal, so that a step is shortened by a tenth.
inline constexpr double first_damping = 0.1;

/// ... more each time ...
/// origin: reasoned: it dominates the diagonal after three times.
inline constexpr double damping_growth = 4.0;

/// ... and less after progress.
/// origin: reasoned: forgotten after a few good steps.
inline constexpr double damping_decay = 0.4;

/// Relative accuracy of derivatives of forces, ...
/// origin: measured (compare_jacobian 200 1e-2): with 1e-3 columns of velocities are no closer to
/// differences, 0.2 to 0.3 % in the median, and take 1.6 times as long.
inline constexpr double rate_tolerance = 1e-2;

/// ... and the restarts of GMRES it may take.
/// origin: bound: one or two suffice for rate_tolerance.
inline constexpr int rate_restarts = 10;

/// Shorter side of the coarsest grid of the cascade, at least.
/// origin: measured (a trial of the method, 40 to 60 ellipses): below, what it costs is not saved
/// on finer grids.
inline constexpr std::size_t min_cascade_side = 6;

/// Tolerance on grids that are not the last, at least.
/// origin: measured (wrc_benchmark --case service --creep, 1e-3): convolutions times elements are 4
/// to 6 % more with 0.01 and 2 % with 0.007.
inline constexpr double cascade_tolerance = 0.005;

/// Single precision is used for this tolerance and coarser ones.
/// origin: derived: rounding in single precision leaves a residual of about 1e-6.
inline constexpr double single_precision_tolerance = 1e-4;

/// Elements that span a patch on the grid its flexibilities are computed on, at most: along, ...
/// origin: measured (60 patches of compare_creep_models, against 128 x 64): flexibilities are off
/// by 1.4 to 2.6 % rms, with half the number by 3 to 7 %, which shows beside the springs' own
/// error.
inline constexpr std::size_t flexibility_elements_along = 32;
/// ... and across.
/// origin: derived: half the number along, as in the measurement.
inline constexpr std::size_t flexibility_elements_across = flexibility_elements_along / 2;

/// Tolerance of the solutions without slip that flexibilities are taken from.
/// origin: measured (60 patches of compare_creep_models): flexibilities within 6e-4 rms; 1e-2:
/// 5e-3.
inline constexpr double flexibility_tolerance = 3e-3;

/// Slip of a body over what the largest tractions displace, at most, ...
/// origin: derived: its square is a number in single precision, and so is its ratio to
/// least_bound_share.
inline constexpr double most_slip = 1e15;

/// ... and bounds that count, over the largest.
/// origin: derived: see most_slip.
inline constexpr double least_bound_share = 1e-20;

/// Largest bound, MPa, up to which bodies count as without friction.
/// origin: bound: no force; slips over it are numbers for all creepages and moduli.
inline constexpr double least_bound = 1e-100;

/// Friction under which nothing slips, for creepages of 1, G = 1 and a pressure of 1.
/// origin: derived: tractions without slip are some tens of G times the creepage.
inline constexpr double no_slip_friction = 1e6;

/// Alternations of pressures and tractions between unlike bodies.
/// origin: bound (spheres on 32 elements, tolerance 1e-4): aluminium on steel takes 4 at most,
/// K = 0.5 with mu = 1 takes 9.
inline constexpr int alternation_limit = 12;

/// Tolerance of their normal solutions, at most.
/// origin: reasoned: what tractions change is the difference of two of them, some per cent of each.
inline constexpr double unlike_normal_tolerance = 1e-4;

/// Fraction by which tractions in adhesion are below their bound: the last cut leaves those of slip
/// on it, to rounding, and nothing else near it.
/// origin: derived: above the rounding of single precision.
inline constexpr double off_bound = 1e-6;

/// Speed, mm/s, below which a wheelset starts or stops: its wheels may slide without a warning, and
/// a higher speed of standstill is warned of. origin: reasoned: braking to rest ends with a wheel
/// that slides for some steps; a walking pace.
inline constexpr double slow_speed = 1000.0;

// Closed forms and tables of creep forces.

/// Linear force over the friction at which everything slips.
/// origin: published: Vermeulen & Johnson 1964: where their cubic reaches mu N, with no slope.
inline constexpr double full_slip_ratio = 3.0;

/// Growth of the spin's part with the length of the ellipse, over that of a short one.
/// origin: published: Polach 1999, fitted there to Kalker's tables of pure spin.
inline constexpr double polach_spin_growth = 6.3;

/// The tables' range of ln(a/b), both ways: a/b from 1/50 to 50.
/// origin: derived: where fit_kalker_coefficients places its ellipses; ln 50.
inline constexpr double largest_kalker_log_ratio = 3.912023005428146;

/// Strips that march side by side; more are marched one group after another.
/// origin: derived: two registers of eight doubles, or four of four, hide each other's latency.
inline constexpr std::size_t strip_group = 16;

/// Fields of one value besides the bound: the linearised elements.
/// origin: derived: counted.
inline constexpr std::size_t element_fields = 7;

} // namespace wrc
