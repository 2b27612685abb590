/// What contact remembers from one step of time to the next: displacements under its tractions, and
/// where the patches of a wheel find them again.
///
/// A step of time is solved with the slip that adhesion has not undone
/// (rolling/rolling_problem.hpp),
///   s = w - f du/dx + (u - u')/d,   d = slip speed times the step, f = |V_ref|/slip speed,
/// u' the displacement at the same place: fixed to the rail laterally and to the wheelset along the
/// track, since f du/dx accounts for rolling. u' is
/// interpolated between elements, and beyond them taken from the nearest one. A patch continues the
/// one whose rectangle holds its middle; a new one begins without displacement.
/// Left-hand frame of the side, mm. Thread rule: plain values and pure functions.
///
/// Not known here: that planes turn between the steps.
#pragma once

#include <array>
#include <vector>

#include "base/grid.hpp"
#include "creep/rigid_slip.hpp"
#include "patches/contact_frame.hpp"

namespace wrc {

class RailSurface;
struct WheelResult;

/// Displacements of the wheel relative to the rail at the elements of a patch, in its plane, whose
/// origin is given from the rail's.
struct PatchHistory {
  ContactFrame frame;
  Grid grid;
  std::vector<double> x;
  std::vector<double> y;
};

using WheelHistory = std::vector<PatchHistory>;

struct ContactHistory {
  std::array<WheelHistory, 2> wheels; ///< left and right; no patches: no tractions before
};

/// Adds -u'/d on the elements of a plane to a slip, which may be empty.
void add_history(const WheelHistory& history, const RailSurface& rail, const ContactFrame& frame,
                 const Grid& grid, double step_length, SlipField& slip);

/// Of the patches whose creep forces are those of a step of time.
WheelHistory history_of(const WheelResult& wheel);

} // namespace wrc
