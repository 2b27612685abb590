/// Vertical distances of the nodes of a wheel's profile from the rail below them, for one pose.
///
/// For each node of the wheel's profile curve the point of the contact locus (closed form,
/// geometry/wheel_surface.hpp) is found, and the rail's height below it from the table of
/// geometry/height_function.hpp. Only nodes that can lie over the rail are computed: a node's
/// lateral position is
///   y = y_w + cos(yaw) (cos(roll) (L/2 + l1 + s) + sin(roll) rho cos t) + sin(yaw) rho sin t,
/// so it differs from the first product by at most rho (|sin(roll)| + |sin(yaw)|).
/// Units mm; track frame, left side. Thread rule: one object, one thread.
/// Not known here: what lies between the nodes, which geometry/contact_search.hpp looks into.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"

namespace wrc {

class LocusScan {
public:
  /// Both surfaces must outlive the scan. Buffers are kept from one pose to the next.
  LocusScan(const WheelSurface& wheel, const RailSurface& rail);

  void run(const LocusPose& pose);

  /// Nodes first to last - 1 have been computed; all others are not over the rail.
  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t last() const { return last_; }
  /// Infinite where the node is not over the rail; `node` may be any number.
  [[nodiscard]] double distance(std::size_t node) const {
    return node >= first_ && node < last_ ? distance_[node]
                                          : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] bool over_rail(std::size_t node) const {
    return distance(node) < std::numeric_limits<double>::infinity();
  }
  /// The least distance of all nodes; infinite if none is over the rail.
  [[nodiscard]] double least() const { return least_; }

  /// Position of a node over the rail.
  [[nodiscard]] Vector3 position(std::size_t node) const { return {x_[node], y_[node], z_[node]}; }
  [[nodiscard]] double rail_slope(std::size_t node) const;

private:
  void choose_nodes(const LocusPose& pose);

  const WheelSurface& wheel_;
  const HeightFunction& rail_;
  std::vector<double> x_, y_, z_, distance_;
  std::vector<std::int32_t> piece_; ///< of the rail's table
  std::size_t first_ = 0;
  std::size_t last_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
};

} // namespace wrc
