/// Constants of behaviour of this room: how points are cleaned, checked, turned and smoothed.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all. Dimensions of wheels and
/// rails are in plausible_shapes.hpp. Lengths in mm, angles in rad.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "profile/curve.hpp"

namespace wrc {

/// A unit, not a tuning constant.
inline constexpr double degree = std::numbers::pi / 180.0;

// Cleaning and gaps.

/// Neighbours on a line of points are no farther apart than this, ...
/// origin: reasoned: points of measurements and drawings are 0.1 to 2 mm apart, running surfaces 70
/// wide, patches 5 to 20 long; extended side faces are below 10, a row of zeros is 30 away.
inline constexpr double farthest_neighbour = 10.0;
/// ... and where the longest side of a closed outline, or the distance of a few points at an end
/// from the rest, is this many times the median distance, the line does not go on. origin:
/// reasoned: a missing point makes twice the distance.
inline constexpr double farthest_in_spacings = 5.0;
/// Points are out of order if chords longer than the first and than farthest_in_spacings become
/// shorter in all by the second in an order from each point to the nearest.
/// origin: reasoned: branches of a lip are a mm apart and jump at every second point, blocks of
/// scans by tens of mm, and none of these are left; a gap stays as long, and an outlier then jumps
/// from the end.
inline constexpr double least_long_chord = 0.5;
inline constexpr double ordered_share = 0.1;
/// Chords at whose ends an order begins, besides the first point, and the most points for it.
/// origin: bound: of work; a block has two ends.
inline constexpr std::size_t most_begins = 3;
inline constexpr std::size_t most_ordered = 5000;
/// A line is not put in an order in which it lies closer than the second to parts of itself that
/// are farther than the first along it, mm: it is two scans that do not fit.
/// origin: reasoned: lips are up to 5 mm long on both sides, flanges 25 mm thick.
inline constexpr double longest_lip = 15.0;
inline constexpr double farthest_beside = 5.0;
/// Ends of an outline are so close, in median distances and as a fraction of its length, that
/// another point would stand between them if it was open. origin: reasoned: measurements end where
/// they began or 70 mm away.
inline constexpr double opening_ratio = 3.0;
inline constexpr double opening_share = 0.05;
/// A point off the line of its neighbours by more than this, around which the line turns back and
/// forth by more than this angle, is no part of the profile.
/// origin: reasoned: points 0.25 mm apart that scatter by 0.1 mm turn by 90 degrees; the sharpest
/// edges of profiles turn one way only.
inline constexpr double least_outlier = 0.15;
inline constexpr double least_wiggle = 100.0 * degree;
/// Less off than this an outlier is scatter of the instrument, whose removal is no guess.
/// origin: measured: a wheel of the collection has one of 0.4 mm at its flange tip.
inline constexpr double least_spike = 1.0;
/// Largest number of points in a row that may be off a line, and number of steps from point to
/// point that its direction is taken over. origin: reasoned: more points are a step or a second
/// line, which cannot be distinguished from the first; enough to average scatter of a tenth of
/// their distance.
inline constexpr std::size_t steps_of_line = 3;
/// Largest number of outliers that are removed, and points for each of them.
/// origin: reasoned: a line of which more than one point in twenty is off, or more than anybody
/// looks at one by one, is no line with a few faults.
inline constexpr std::size_t most_outliers = 20;
inline constexpr std::size_t points_per_outlier = 20;
/// An end that is off is also farther away than this number of median distances, and around a
/// corner. origin: reasoned: scatter turns the first step of a line by less.
inline constexpr double end_ratio = 10.0;
inline constexpr double end_corner = 45.0 * degree;
/// Up to this number of points at an end do not belong to the line if they are this far from it.
/// origin: measured: an averaged rail of the collection begins with a point 3.6 mm off its side.
inline constexpr std::size_t most_lone = 4;
inline constexpr double lone_distance = 2.0;

/// A gap between neighbours, in mm and in median distances or in those beside it.
/// origin: reasoned: a patch is 5 to 20 mm long, approaches are 0.1 mm; a missing point makes twice
/// the distance of those beside it, a flank among points of equal lateral distances at most 1.5
/// times.
inline constexpr double largest_gap = 3.0;
inline constexpr double gap_ratio = 4.0;
inline constexpr double ratio_beside_gap = 1.75;
/// A step of a line to the side; lines on both sides of it run alike, the chord between them does
/// not.
/// origin: reasoned: a patch is 5 to 20 mm long; a larger angle is a corner, a smaller one the turn
/// of an arc of 13 mm among points 4 mm apart.
inline constexpr double largest_step = 1.0;
inline constexpr double step_angle = 20.0 * degree;
/// Lateral may run back by this.
/// origin: reasoned: scatter on steep flanks is a tenth of this.
inline constexpr double largest_return = 0.3;
/// A curve that leaves the chord of two neighbours by more than this, and by this fraction of the
/// chord, swings.
/// origin: derived: an arc over a chord leaves it by 0.2 of its length where it turns by 87
/// degrees.
inline constexpr double largest_swing = 0.5;
inline constexpr double swing_share = 0.2;
/// Places of slices that are given twice may differ by this fraction of them (of 1, if they are
/// less).
/// origin: bound: below any distance of slices, above the rounding of seven digits.
inline constexpr double place_rounding = 1e-6;

// Scatter.

/// Pressure that flattens the scatter of points, MPa, above which they are smoothed, and of points
/// whose scatter is that of their digits, which is sure to be no shape.
/// origin: measured: pmax of S1002 is 5 % too large with 54 (10,000 points of five digits), 0.6 %
/// with 39 (points 0.25 mm apart, four digits); a measured rail whose pmax changes by 0.7 % has 59.
inline constexpr double notable_pressure = 60.0;
inline constexpr double notable_pressure_of_digits = 40.0;
/// Scatter up to this share of the last digit is that of the digits.
/// origin: derived: rounding alone makes 0.29 of it.
inline constexpr double share_of_digit = 0.5;
/// Last digits that are tried, and how exactly points are multiples of one of them.
/// origin: bound: shifts and mirrors of points leave rounding of 1e-12.
inline constexpr int most_digits = 7;
inline constexpr double digit_tolerance = 1e-4;
/// Pressure amplitude over amplitude of waves two points long, in mean squares, MPa.
/// origin: published: pi E* / wavelength (Johnson, Contact Mechanics, 13.2), E* of steel 115 GPa.
inline constexpr double flattening = std::numbers::pi * 115e3 * std::numbers::sqrt2 / 2.0;
/// Of points farther apart scatter and shape cannot be distinguished.
/// origin: measured: exact standard profiles seem to need 7 MPa at this distance, 50 at 2.5 mm.
inline constexpr double scatter_spacing = 2.0;
/// The median of |e| in standard deviations of the points.
/// origin: derived: e = n[-2]/4 - n[-1] + 1.5 n[0] - n[1] + n[2]/4 has 2.09 of them, its median
/// 0.6745 of that.
inline constexpr double scatter_of_median = 1.41;
/// A wavelength this much shorter than the one of the noise is too short.
/// origin: measured (tests/core/measured/noise_removal_test.cpp): S1002 with noise of 0.02 mm is
/// off by twice as much at this share of its wavelength.
inline constexpr double wavelength_share = 0.7;

// Tilt.

/// A face is straight over this length at least, to this distance, and within this angle of the
/// vertical.
/// origin: measured: backs of three measured wheels are straight over 20 mm to 0.03 mm (rms), field
/// faces of two others over 10 and 16 mm.
inline constexpr double least_face = 10.0;
inline constexpr double straightness = 0.1;
inline constexpr double steepest_face = 10.0 * degree;
/// Points closer than this say nothing more of it.
/// origin: bound: a face then has 100 points, whose scatter averages out.
inline constexpr double face_spacing = 0.1;
/// Share of a face from its end that gives its direction: the rest may belong to the next arc.
/// origin: derived: arcs of 12 to 20 mm leave their tangent by 0.1 mm after 1.5 to 2 mm.
inline constexpr double outer_share = 0.8;
/// Faces that differ by less than this are parallel.
/// origin: reasoned: lines of 10 mm that scatter by 0.03 mm have it.
inline constexpr double parallel_faces = 0.15 * degree;
/// A tilt of one face is a warning from here on, one of parallel faces is turned back.
/// origin: measured: on three measured wheels backs are tilted by 0.0, 0.3 and 0.5 degrees, of the
/// last one the field face, too.
inline constexpr double doubtful_face = 0.7 * degree;
/// A smaller tilt of parallel faces, or of a wheel against a nominal one, is said from here on.
/// origin: measured (tests/core/measured/tilt_test.cpp): the least that is surely no scatter; it
/// changes pmax of S1002 by 20 %.
inline constexpr double notable_tilt = 0.1 * degree;
/// A wheel lies on a nominal one if this share of its points is within the last bound of the
/// alignment. The turn is clear if it moves the wheel's ends by this many times what is left.
/// origin: measured (tests/core/measured/tilt_test.cpp): built-in wheels on each other, and
/// measured wheels on them, have less.
inline constexpr double share_on_nominal = 0.9;
inline constexpr double least_clearness = 5.0;
/// Points that are laid on built-in wheels.
/// origin: bound: the turn is known to 0.01 degrees with noise of 0.02 mm.
inline constexpr std::size_t points_of_search = 120;

// Alignment.

/// Bounds of the distances that count, from the first to the last stage.
/// origin: reasoned: files are a few mm from their place; the last bound is ten times the noise of
/// instruments and below the wear of a used profile.
inline constexpr std::array<double, 7> alignment_bounds{5.0, 3.0, 2.0, 1.0, 0.5, 0.3, 0.2};
/// Steps of a stage before the last, which lead to the last one.
/// origin: bound: of work; only the last stage has to settle.
inline constexpr int steps_of_stage = 4;
/// Steps of the last stage.
/// origin: bound: ten settle to 1e-9 rad.
inline constexpr int last_steps = 12;
/// The bound falls no further if a smaller share of the points is left. Of points far from their
/// place this share must be beside the nominal.
/// origin: reasoned: a smaller part may fit anywhere; half a profile may be measured.
inline constexpr double least_aligned_share = 0.5;
/// Half of the points lie within this distance of their nominal profile; else a warning.
/// origin: reasoned: wear leaves half of a wheel nearer than that.
inline constexpr double usual_bound = 1.0;
/// Turns from which points far from their place are aligned.
/// origin: reasoned: alignments find 5 degrees by themselves, instruments stand within 30.
inline constexpr std::array<double, 7> far_turns{0.0, 0.15, -0.15, 0.3, -0.3, 0.45, -0.45};
/// Points that are looked at, and distance of the nominal's points among which feet begin.
/// origin: bound: others tell nothing new about a rigid motion.
inline constexpr std::size_t aligned_points = 400;
inline constexpr double foot_spacing = 0.5;
/// Fewer points beside the nominal determine nothing.
/// origin: reasoned: seven for each of the three unknowns, so that the scatter of one does not
/// decide.
inline constexpr std::size_t least_aligned_points = 20;
/// Length that makes rotations comparable with shifts.
/// origin: bound: only rounding depends on it.
inline constexpr double lever = 50.0;
/// Smallest share of an unknown that the others do not explain, in squares.
/// origin: reasoned: of S1002 it is 0.1, of a tread without a flange 1e-3, of a line 0.
inline constexpr double least_pivot = 1e-5;

// Removal of noise.

/// Wavelength of the first reference and distance of its points.
/// origin: bound: another reference changes the result in the second order of its distance from it.
inline constexpr double reference_wavelength = 5.0;
inline constexpr double reference_spacing = 0.2;
/// Intervals of the spline.
/// origin: reasoned: a tenth of the shortest waves that matter for contacts.
inline constexpr double interval_length = 0.25;
/// How many there are at least.
/// origin: bound: profiles are 5 mm long or more (ReadLimits), which makes 20.
inline constexpr std::size_t least_intervals = 8;
/// Steps towards the foot of a point on the reference, each at most so long.
/// origin: bound: two settle to 1e-6 mm unless the reference is half a mm away.
inline constexpr int foot_steps = 3;
inline constexpr double longest_foot_step = 0.5;
/// Intervals on each side of a guess that are searched.
/// origin: bound: a curve over a gap of 10 mm may be 3 mm longer than its chord.
inline constexpr int search_steps = 16;
/// An offset by this share of the radius of curvature is too far from the reference.
/// origin: bound: offsets along normals meet at 1.
inline constexpr double greatest_turn = 0.7;
/// Shares of the profile that short_wave and long_wave leave out.
/// origin: reasoned: kinks and ends halve waves that say nothing about the rest.
inline constexpr double left_out = 0.1;
/// Lines that are drawn.
/// origin: reasoned: their deviation is known to 22 %, at a cost of ten solutions.
inline constexpr std::size_t likely_lines = 10;

// Model of noise.

/// Noise that an instrument has filtered is independent at one of these distances.
/// origin: measured (drivers/evidence/core/measure_noise.cpp): of noise with the cut-off 2.5 mm a
/// third is left at 1 mm, which the fit finds. From 1.5 mm on waves of worn wheels are such noise,
/// too: of 0.008 mm for one of them, of 0.0002 mm at 1 mm.
inline constexpr std::array filter_distances{0.5, 0.7, 1.0};
/// A distance that leaves out points is this many of theirs.
/// origin: bound: below it every second point or none is left out.
inline constexpr double spacing_ratio = 1.5;
/// Noise is filtered if there is this many times as much at a larger distance, or if neighbours
/// have the same noise.
/// origin: reasoned: a deviation of 100 points is known to 7 %, of neighbours that are correlated
/// the fit takes more than half for waves.
inline constexpr double more_noise = 1.5;
/// What repeats itself within this many distances, so that it is correlated by more than this, are
/// waves that were made.
/// origin: measured: filtered noise has up to 0.5, a sine, as a tool leaves it, 0.9 to 1; eight
/// distances hold waves of 2 to 8 mm.
inline constexpr std::size_t largest_lag = 8;
inline constexpr double most_repetition = 0.7;
/// Intensities where the data say nothing, mm^-3 and mm^-1; they count as this number of values.
/// origin: measured (drivers/evidence/core/measure_noise.cpp): the treads of five wheels have 4e-7
/// to 2e-4 and 1e-8 to 3e-4 at waves of 7 to 20 mm; 0.2 is less than one halved wave contributes.
inline constexpr double usual_drift = 3e-6;
inline constexpr double usual_waviness = 1e-5;
inline constexpr double prior_count = 0.2;
/// Half the neighbourhood of the drift is a halved wave within this range; twice that, and this at
/// least, is that of waviness.
/// origin: measured (drivers/evidence/core/measure_noise.cpp): 0.75 to 1.2 waves make no difference
/// among 300 samples; half as much leaves 91 instead of 96 of 100 truths within the spread.
inline constexpr Position drift_neighbourhood{2.0, 20.0};
inline constexpr double waviness_neighbourhoods = 2.0;
inline constexpr double least_of_waviness = 6.0;
/// Rounds of the fixed point, of a first fit and of one that begins with a fit.
/// origin: bound: measured: sigma settles to 1 % within 10 rounds, the likelihood within 30.
inline constexpr int first_rounds = 40;
inline constexpr int later_rounds = 12;
/// How often weights follow the residuals.
/// origin: bound: a line with kinks settles in two.
inline constexpr int weightings = 3;
/// Residuals beyond this many medians lose weight.
/// origin: derived: three standard deviations of normal noise.
inline constexpr double influence_limit = 3.0 * 1.4826;
/// Change of logarithms at which it has settled.
/// origin: reasoned: intensities enter wavelengths by their sixth root.
inline constexpr double settled_variance = 0.02;
inline constexpr double settled_intensity = 0.2;
/// First intensities, with all scatter as noise and with a part of it; least variance, mm^2.
/// origin: bound: changes no result that settles; 1e-10 mm is less than any rounding.
inline constexpr double first_intensity = 1e-5;
inline constexpr double rough_drift = 1.0;
inline constexpr double rough_waviness = 1e-2;
inline constexpr double rough_share = 1e-3;
inline constexpr double least_variance = 1e-20;
/// Least share of a point among those that count as one.
/// origin: bound: keeps weights above 0.
inline constexpr double least_point_share = 1e-6;
/// The residual's least share of the squares; the least freedom of the noise, in values.
/// origin: bound: above the rounding of sums, below what a line leaves of any measurement.
inline constexpr double least_residual = 1e-12;
inline constexpr double least_freedom = 0.01;

} // namespace wrc
