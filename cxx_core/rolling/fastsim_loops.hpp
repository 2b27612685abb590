/// The marches of FASTSIM from the leading edge, vectorised across strips.
///
/// A step downstream changes the traction by the force of the bed of springs in adhesion; where
/// that exceeds the bound it is cut back, against the slip (Kalker 1982):
///   t = q_upstream - (integral of w/L over the step),  q = t or g t/|t|.
/// Does not handle creepages and grids.
/// Thread rule: pure functions. Order of sums is fixed by the instruction set.
#pragma once

#include <cstddef>

#include "rolling/constants.hpp"

namespace wrc {

/// A group of strips of an ellipse: lengths in its semi-axes, tractions over mu times the largest
/// pressure. A step is as long as a slice; the first ends in the middle of the first slice.
struct EllipseStrips {
  double half_length[strip_group]; ///< 0: no strip
  double change_x[strip_group];    ///< of the traction over a step in adhesion
  double change_y[strip_group];
  double change_y_by_spin[strip_group]; ///< times the position between -1 and 1 along the strip
};

/// Sums over the slices of each strip of a group, added up over the strips with their areas.
struct StripSums {
  double x = 0.0;        ///< tractions, weighted with half the strip's length
  double y = 0.0;        ///< likewise
  double moment = 0.0;   ///< of the lateral tractions about the middle, with its square
  double moment_x = 0.0; ///< of the longitudinal tractions, by the strip's lateral position
  double slipping = 0.0; ///< number of slices on the bound, weighted with half the length
};

/// `place`: lateral position of each strip across the ellipse, in lateral semi-axes.
StripSums march_ellipse(const EllipseStrips& strips, const double* place, std::size_t slices);

/// What a march over a rectangle of elements is given.
struct MarchedElements {
  std::size_t rows = 0;             ///< elements along a strip, from the leading edge downstream
  std::size_t pitch = 0;            ///< strips
  const double* bound = nullptr;    ///< g, rows times pitch; 0 outside the contact
  const double* change_x = nullptr; ///< of the traction over one element in adhesion, likewise
  const double* change_y = nullptr; ///< likewise about each element's centre
  double change_y_by_row = 0.0;     ///< what it grows by from row to row
};

/// Tractions at the centres of elements, and by how much each was cut over the step's length in
/// elements: rows times pitch values.
/// The leading edge is the upstream side of the first element in contact. `state` holds 3 pitch
/// values. Each stretch of elements in contact has a leading edge of its own.
void march_elements(const MarchedElements& elements, double* traction_x, double* traction_y,
                    double* cut_x, double* cut_y, double* state);

} // namespace wrc
