/// How a patch moves: its creepages from the motion of the wheelset or as given, the slip of its
/// elements beyond them, and both a little later.
///
/// Left-hand frame of the side. Units mm, s, rad. Thread rule: pure functions, except for
/// find_slip_geometry, which fills in its argument.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "creep/creep_rates.hpp"
#include "creep/creep_request.hpp"
#include "creep/rigid_slip.hpp"
#include "creep/rolling_frame.hpp"

namespace wrc {

struct PatchRates;
struct PatchResult;
struct WheelResult;

/// Motion of a patch, or of patches of one plane together.
struct PatchMotion {
  Creepages creepages; ///< at the plane's origin
  RollingFrame frame;
  double slip_speed = 0.0; ///< of a creepage of 1, mm/s
  double friction = 0.0;   ///< coefficient
  /// If slip varies within the patch as the wheelset moves.
  std::optional<Twist> twist{};
  double step_length = 0.0;   ///< of a step of time (rolling_problem.hpp); 0: steady rolling
  double rolling_share = 1.0; ///< |V_ref| over `slip_speed`: below 1 near standstill
  double slip_scale = 1.0;    ///< of the creepages, which slip by pressures follows
};

/// Creepages at a point of a patch's plane from those at its reference.
Creepages creepages_at(const Creepages& reference, double longitudinal, double lateral);

/// That of the request in the left-hand frame of the side.
WheelsetMotion wheelset_motion(const WheelResult& wheel, const CreepRequest& request);

/// Fills in PatchResult::slip of all patches and their parts, once; none of slip that is planar.
void find_slip_geometry(WheelResult& wheel, const CreepRequest& request);

/// From the wheelset's motion, or as given at the reference of `whole`.
PatchMotion motion_of(const PatchResult& patch, const PatchResult& whole, const WheelResult& wheel,
                      const CreepRequest& request);

/// The surface on the rows of a grid of the patch's plane.
std::vector<SlipRow> rows_on(const WheelResult& wheel, const PatchResult& patch, const Grid& grid,
                             const SlipChoice& choice);

/// A patch that the wheelset has moved by lateral position, height, roll or yaw, with its plane.
class MovedContact {
public:
  MovedContact(const WheelResult& wheel, const PatchResult& patch, const PatchRates& rates,
               std::size_t position, double step);

  [[nodiscard]] SlipGeometry geometry(const Grid& grid, std::span<const double> pressure,
                                      const SlipChoice& choice) const;
  [[nodiscard]] std::vector<SlipRow> rows(const Grid& grid, const SlipChoice& choice) const;
  [[nodiscard]] Twist twist() const;
  [[nodiscard]] const ContactFrame& frame() const { return frame_; }

private:
  [[nodiscard]] PosedPair pair() const;

  const WheelResult& wheel_;
  Pose pose_;
  double height_; ///< of the wheelset's centre
  ContactFrame frame_;
  double approach_;
  double ahead_;
};

/// How SlipGeometry::creepages_by_twist changes with positions.
std::array<CreepagesByTwist, position_count> slip_rates(const WheelResult& wheel,
                                                        const PatchResult& patch,
                                                        const PatchRates& rates,
                                                        const SlipChoice& choice);

} // namespace wrc
