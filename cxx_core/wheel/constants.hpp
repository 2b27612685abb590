/// Constants of behaviour of this room: one wheel, from the first depth to its solution.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <cstddef>

#include "accuracy/constants.hpp"

namespace wrc {

/// Tolerance of solutions that only give the depth for the next one: it must be a smooth function
/// of the scene.
/// origin: measured (smoothness, the depth from the final elements): lateral forces leave their
/// slope by 5.2e-7 of the load as with 1e-4, which takes 1.3 % more time; with 1e-3, for 1 % less
/// time, by 8.9e-7.
inline constexpr double coarse_tolerance = 3e-4;

/// Solutions at other depths or on finer grids before it gives up.
/// origin: bound: measured (wrc_benchmark --case service): 7 at most are taken.
inline constexpr int max_attempts = 20;

/// Smallest fraction of the depth kept by one step.
/// origin: bound: keeps a first depth far too large from a step to below the first touch.
inline constexpr double min_depth_ratio = 0.1;

/// Turn of the rail from one end of a contact to the other, over the deviation of its angle in the
/// penetration.
/// origin: derived: with a penetration that is a parabola of half width a and weights (1 -
/// y^2/a^2)^2.5 (penetration_lobes.hpp) the deviation of y is a/sqrt(8), and Hertz's contact is 2
/// a/sqrt(2) wide.
inline constexpr double turn_over_deviation = 4.0;

/// Rows and columns over the penetration on which its bend is found (remesh/bend_along.hpp).
/// origin: reasoned: half of the columns show the contact, three times as many as a parabola needs.
inline constexpr std::size_t bend_rows = 3;
inline constexpr std::size_t bend_columns = 33;

/// Contact angle above which distances along the wheelset's axis mislead, rad.
/// origin: derived: they are longer than normal ones by 1 - cos = 1 % there.
inline constexpr double vertical_convention_limit = 0.15;

/// Fraction of the accuracy that the iteration may take in a pressure.
/// origin: reasoned: with share_of_law and max_rounding it stays within the accuracy.
inline constexpr double iteration_share = 0.2;

/// The same in forces, which must also be smooth to a thousandth of the accuracy: with the load
/// prescribed the iteration's error shows only in its distribution over patches, ...
/// origin: measured: with 0.2 slopes are as smooth for 4 % less time, but the depth of a wheelset
/// that hunts between the flanges does not settle (legacy_vehicle), and 1e-3 of creep forces is met
/// on 98.7 instead of 99.4 % of patches (wrc_tradeoff --creep 500); 0.02 takes 2 % more.
inline constexpr double smooth_load_share = 5e-2;

/// ... at a prescribed position at once.
/// origin: measured (smoothness): with 3e-3 forces leave the line of the stiffness by 8.9e-7
/// instead of 7.6e-7.
inline constexpr double smooth_position_share = 2e-3;

/// Fraction of the accuracy that rounding may take in a pressure; forces are sums, in which it
/// averages out.
/// origin: reasoned: with share_of_law and iteration_share it stays within the accuracy.
inline constexpr double max_rounding = 0.1;

/// Fraction of the accuracy above which position rounding raises a warning.
/// origin: derived: what share_of_law and iteration_share leave of it. With the whole accuracy pmax
/// of a flange under 1e-5 N is 1.15e-3 off without a warning (wrc_extremes).
inline constexpr double warned_rounding = 1.0 - share_of_law - iteration_share;

/// Stated errors where steel yields: of pmax, up to an elastic pmax of yield_well_known yield
/// stresses and beyond, of the area, and of forces over the load. At a prescribed position forces
/// err as pmax.
/// origin: measured (finite elements, docs/evidence/half-space.md): pmax 10 % at most and 16 %,
/// area 12.5 %, lateral force 0.44 % of the load; the largest elastic pmax compared is 6.6 yield
/// stresses.
inline constexpr double yield_error_of_pmax = 0.10;
inline constexpr double yield_error_far_beyond = 0.20;
inline constexpr double yield_well_known = 5.0;
inline constexpr double yield_compared = 7.0;
inline constexpr double yield_error_of_area = 0.12;
inline constexpr double yield_error_of_forces = 0.005;

/// Elastic pmax over the onset of yield from which ends of rows bear what their elements do.
/// origin: measured (S1002 on 60E1 at five places, 0.1 % creepage, 480 MPa, 1e-2): Fx is off by up
/// to 1.8 % instead of 9. Nearer to the onset it hardly matters: up to 1.5 on the gauge corner Fx
/// is within 0.3 % with either.
inline constexpr double yield_rim_whole = 1.25;

/// Relative error of later passes, besides that of the law: of pmax of a contact pressed again.
/// origin: measured (gauge corner, 500 MPa, 8, 40 and 80 kN after 80 kN, by finite elements): 8 %
/// at most, and 14 % in a trial of the law on other gaps. With rolling nothing was compared.
inline constexpr double yield_error_of_passes = 0.14;

/// Passes end where one deepens the groove by no more than this part of its depth.
/// origin: reasoned: far less than the law knows.
inline constexpr double settled_groove = 1e-4;

/// Length over width of an element where steel yields, at most.
/// origin: measured (401 wheels, 350 to 900 MPa, accuracies of pressures from 5e-2 to 1e-3): with
/// 6, 8 or 10 all converge, with 16 one does not, and without a bound, where crests have elements
/// of 33, 31 do not.
inline constexpr double longest_yielding_element = 8.0;

/// Relative error of pmax where steel yields, over the square of the rise that a parabola through
/// the largest elements gives a crest, relative as well: crests of yielded pressures are flat.
/// origin: measured (S1002 on 56E1 at -4 mm, ER8 on R350HT): of 6.5 % at 1e-2 4.8 are too much, of
/// 0.3 % at 1e-3 less than 0.01.
inline constexpr double yield_error_of_crest = 11.0;

/// In the vertical convention, patches that turn by less than same_plane_angle
/// (patches/constants.hpp) from the main patch and lie within this distance of it, mm, share its
/// grid.
/// origin: reasoned: the width of the tread's contact band.
inline constexpr double one_grid_distance = 20.0;

/// Iterations times elements of one solution whose elements follow from the accuracy; a limit of
/// elements above the default permits more in the same ratio.
/// origin: bound: measured (bounded_scenes loaded, seed 22): 1.6e8 take solve.method = "paper" 3.6
/// s; the default solver ends after a hundredth of it.
inline constexpr double most_work = 5e7;

/// Elements grow by this at least in each round that coarsens grids to the limit, since whole
/// numbers of rows may hide a smaller growth, ...
/// origin: bound: two more rows of a hundred.
inline constexpr double least_coarsening = 1.02;

/// ... and the rounds end here: the fewest elements of many patches may exceed a small limit.
/// origin: bound: most grids take one or two rounds, those that reach two elements across ten.
inline constexpr int coarsening_rounds = 60;

/// Smallest depth that positions resolve, mm. On steel it takes about 2e-7 N.
/// origin: derived: the rounding of positions, 1e-13 mm, is 1e-4 of it.
inline constexpr double min_depth = 1e-9;

/// Standard deviation of a coordinate that some sums and products have rounded, in roundings.
/// origin: measured: fields of distance show 0.2 (from element to element) to 0.36 (from row to
/// row).
inline constexpr double coordinate_deviation = 0.5;

/// Standard deviations that the largest pressure may be off by.
/// origin: measured: 99 of 100 of 1983 solutions keep to two.
inline constexpr double pressure_deviations = 2.0;

/// Response of pressures to white noise of the distances, law of depth_checks.hpp.
/// origin: derived: pi / (2 sqrt(3)).
inline constexpr double noise_response = 0.9069;

/// What tables of heights may add to the overlap.
/// origin: derived: those of wheel and rail are accurate to 1e-12 mm each.
inline constexpr double table_difference = 2e-12;

/// Elements each way on which pressures of an approximate model are sampled.
/// Enough to draw, figures are in closed form: the size of a picture, not a tuning constant.
inline constexpr std::size_t sampled_count = 32;

/// Room around the contact on that grid, as a fraction of it.
/// origin: derived: one element.
inline constexpr double sampled_margin = 1.0 / static_cast<double>(sampled_count);

/// Steps of that search.
/// origin: bound: secants and halvings of a bracket need ten to twenty.
inline constexpr int load_steps = 80;

/// Relative change of the depth below which patches and planes are kept.
/// origin: derived: planes turn by less than this fraction of the contact angles' spread.
inline constexpr double settled_share = 1e-3;

/// Times that patches are found again at the depth of the load.
/// origin: bound: two or three as a rule; where patches join or part, the two may alternate for
/// ever.
inline constexpr int settling_steps = 20;

/// Validity below which a warning is due.
/// origin: measured (wrc_tradeoff): from there on errors of pmax reach tens of per cent in both
/// models.
inline constexpr double good_validity = 0.8;

/// The least of Hertz's lateral curvature, in longitudinal ones, that a first depth is taken
/// from.
/// origin: bound: flatter contacts are not elliptic.
inline constexpr double min_curvature_share = 1e-3;

/// Error of the greatest stress, by the part of the largest pressure that no element has.
/// origin: measured (compare_stress): errors up to 2.5 times as large, on crests.
inline constexpr double stress_error_by_crest = 2.5;

/// Fraction of an error estimate above which a warning names its cause.
/// origin: reasoned: less does not show in the three digits that are printed.
inline constexpr double least_share_said = 0.01;

} // namespace wrc
