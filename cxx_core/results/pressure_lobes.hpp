/// The lobes of a contact: force, place and angle of each crest of its pressures.
///
/// A patch has a lobe for each crest of its rows' forces, smooth in the pose
/// (pressure/lobe_shares.hpp), and one with parts those of all parts. Their forces add up to that
/// of the patch. Units mm, N, rad; track frame. Thread rule: a pure function.
#pragma once

#include <vector>

#include "records/wheel_result.hpp"

namespace wrc {

struct PressureLobe {
  Vector3 force;         ///< of the rail on the wheel, by the pressures
  double angle = 0.0;    ///< about x, of the tangent across the force; > 0: rises to the left
  ContactPoint centroid; ///< centre of its pressures, on the rail's surface
  double semi_axis_longitudinal = 0.0; ///< of the Hertzian ellipse with its second moments
  double semi_axis_lateral = 0.0;
};

/// In the order of the rows, from the track's centre to the field side; none without pressures.
std::vector<PressureLobe> pressure_lobes(const PatchResult& patch, const WheelDetails& side);

} // namespace wrc
