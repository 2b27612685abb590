/// What a table holds at a node, from a solution of the scene.
///
/// Left-hand frame of the side. Units mm, N, MPa, rad. Thread rule: one TableNodes, one thread.
#pragma once

#include <array>

#include "geometry/contact_search.hpp"
#include "scene/solve_scene.hpp"
#include "table/contact_table.hpp"

namespace wrc {

/// Throws Error(invalid_argument) that names the key for which there is no table.
void check_scene_of_table(const Scene& scene);
/// Of its left wheel; both must be alike.
TableIdentity identity_of_table(const Scene& scene);
/// FNV-1a over the curves as they are used: shifted, turned, smoothed.
std::uint64_t checksum_of_profiles(const WheelSurface& wheel, const RailSurface& rail);

/// Zero without contact.
inline Vector3 force_of(const WheelResult& wheel) {
  return wheel.total.value_or(WheelForce{}).force;
}

class TableNodes {
public:
  /// The table has its ranges, and soon its dimensions and splines of first touch.
  TableNodes(const Scene& scene, SceneSolver solver, ContactTable& table);

  /// Fills in dimensions of the table, and the checksum of the profiles.
  void measure();
  /// Height of the taping point at first touch.
  double touch_height(double lateral, double roll, double yaw);
  /// Depth at the largest load.
  double depth_at_load(double lateral, double roll, double yaw);
  /// What a node has: the parts of the contact, then those of the place.
  using Parts = std::array<double, table_part_count + place_part_count>;
  /// At a height of the taping point.
  Parts parts(double lateral, double height, double roll, double yaw);
  /// The full theory at a state; valid until the next call.
  SceneWheel& solve_exactly(const TableState& state, bool derivatives, double accuracy);

private:
  [[nodiscard]] Scene posed(double lateral, double roll, double yaw) const;
  SceneWheel& solve(const Scene& scene);

  Scene scene_;
  SceneSolver solver_;
  ContactTable& table_;
  SceneResult result_;
  std::optional<SideSearch> search_;
  std::shared_ptr<const WheelSurface> wheel_; ///< of the search
  std::shared_ptr<const RailSurface> rail_;
};

} // namespace wrc
