/// Height and roll of a rigid wheelset that stands on both rails.
///
/// The two unknowns, roll and height, follow from min d_left = min d_right = 0 (the paper,
/// equation 1). The height enters both distances alike, so the roll is the root of
///   f(roll) = min d_left - min d_right,
/// whose derivative is the difference of the contacts' lever arms (envelope theorem); safeguarded
/// Newton. The global search of both wheels is costly, so Newton's method first runs on the two
/// contacts found last, followed from roll to roll; its result stands only if the global search at
/// that roll confirms it, so no contact is missed, however far it jumps. With a prescribed roll
/// each wheel stands by itself at a height of its own.
/// Units mm and rad; track frame. Thread rule: pure functions.
#pragma once

#include <optional>
#include <vector>

#include "geometry/contact_search.hpp"

namespace wrc {

/// Equilibrium of one side; all in the left-hand frame of that side (mirrored for the right).
struct SideEquilibrium {
  Pose pose;             ///< with the roll found, mirrored for the right side
  double vertical = 0.0; ///< z of the wheelset's centre at which this wheel touches
  ContactScan scan;      ///< candidates: least distance first; samples of the scan
  /// Of bodies that vary, the other chains of least distances (varying_search.hpp).
  std::vector<ContactScan> further;
  std::size_t near_count = 1; ///< of the candidates, those within the near tolerance

  /// All, that of the first contact first.
  [[nodiscard]] std::vector<const ContactScan*> scans() const {
    std::vector<const ContactScan*> all{&scan};
    for (const ContactScan& other : further) {
      all.push_back(&other);
    }
    return all;
  }
};

struct WheelsetEquilibrium {
  double roll = 0.0;     ///< rad
  double vertical = 0.0; ///< z of the wheelset's centre at the first touch of either wheel
  std::optional<SideEquilibrium> left;
  std::optional<SideEquilibrium> right;
};

struct EquilibriumRequest {
  double lateral = 0.0;
  double yaw = 0.0;
  std::optional<double> roll; ///< prescribed; solved if not set
  bool left = true;           ///< wheels to solve; a solved roll needs both in any case
  bool right = true;
  double near_tolerance = 0.1; ///< mm
};

/// A wheel and the rail below it, in the left-hand frame of its side; both outlive their use.
struct WheelAndRail {
  const WheelSurface& wheel;
  const RailSurface& rail;

  /// Whether neither changes as the wheel rolls in a direction: along the track it then keeps its
  /// height, and touches on its contact locus only (geometry/wheel_surface.hpp).
  [[nodiscard]] bool is_prismatic_along(const Vector3& direction) const {
    return wheel.is_prismatic_along(direction) && rail.is_prismatic_along(direction);
  }
};

/// Throws Error(no_contact) if a wheel is off its rail or no roll within +-0.2 rad sets both wheels
/// on the rails.
WheelsetEquilibrium find_equilibrium(const WheelAndRail& left, const WheelAndRail& right,
                                     const EquilibriumRequest& request);

} // namespace wrc
