/// The frames of rolling contact and all signs between them.
///
/// Creep forces pass through three frames. Each has z along the normal, from the rail to the wheel.
///  - Track frame: x forward, y to the left along the patch's plane. Requests and results.
///  - Left-hand frame of the side: the track frame on the left, its mirror image y -> -y on the
///    right. A patch's plane, grid and fields (geometry/frames.hpp).
///  - Rolling frame: the left-hand frame, turned by half a turn about the normal if the wheel rolls
///    backwards, so that x always points where the contact goes. The problems of rolling/.
///
///                              x component   y component   about or along z
///     vector, mirrored              +             -               +
///     moment, spin, mirrored        -             +               -
///     vector, turned                -             -               +
///     moment, spin, turned          -             -               +
///
/// Mirror and turn are their own inverses: `mirrored` goes from the track frame to the left-hand
/// frame and back, `turned` from there to the rolling frame and back. A derivative changes with the
/// product of the signs of its row and its column. Left wheels that roll forwards keep all bits.
/// Units: any. Thread rule: plain values.
#pragma once

#include <vector>

#include "base/grid.hpp"
#include "creep/kinematics.hpp"
#include "creep/rigid_slip.hpp"
#include "damage/element_stress.hpp"
#include "geometry/rail_surface.hpp"
#include "geometry/side_frame.hpp"
#include "records/creep_result.hpp"
#include "records/rates.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

class RollingFrame : public SideFrame {
public:
  RollingFrame() = default;
  /// `mirror`: 1 on the left, -1 on the right (WheelDetails).
  explicit RollingFrame(double mirror, bool backwards = false)
      : SideFrame(mirror), turn_(backwards ? -1.0 : 1.0) {}

  using SideFrame::mirrored;
  [[nodiscard]] Creepages mirrored(const Creepages& creepages) const;
  [[nodiscard]] CreepForces mirrored(const CreepForces& forces) const;
  [[nodiscard]] Stress mirrored(Stress stress) const;
  [[nodiscard]] Motion mirrored(const Motion& motion) const;
  [[nodiscard]] RailDisplacement mirrored(const RailDisplacement& displacement) const;
  /// By creepages, load and friction; the others stay in the left-hand frame (creep_result.hpp).
  [[nodiscard]] CreepDerivatives mirrored(CreepDerivatives derivatives) const;
  [[nodiscard]] ForceRates mirrored(const ForceRates& rates) const;
  [[nodiscard]] ForceJacobian mirrored(ForceJacobian jacobian) const;

  [[nodiscard]] Creepages turned(const Creepages& creepages) const;
  [[nodiscard]] CreepForces turned(const CreepForces& forces) const;
  [[nodiscard]] Grid turned(Grid grid) const;
  /// A number per element, or a component along the plane per element.
  [[nodiscard]] std::vector<double> turned_numbers(std::vector<double> field) const;
  [[nodiscard]] std::vector<double> turned_components(std::vector<double> field) const;
  [[nodiscard]] SlipField turned(SlipField slip) const;
  /// Fields, forces and derivatives; not rates by quantities that do not turn
  /// (RollingProblem::rates).
  [[nodiscard]] RollingSolution turned(RollingSolution solution) const;

private:
  [[nodiscard]] bool backwards() const { return turn_ < 0.0; }

  double turn_ = 1.0;
};

/// A motion and what moves with it, seen in the mirror.
inline Motion mirrored(const Motion& motion) {
  return RollingFrame(-1.0).mirrored(motion);
}

} // namespace wrc
