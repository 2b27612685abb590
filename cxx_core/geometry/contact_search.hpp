/// Where a left wheel meets a left rail when it is lowered without turning.
///
/// The vertical distance between the wheel's contact locus and the rail,
///   d(s) = z_locus(s) - z_rail(y_locus(s)),
/// is scanned over all nodes of the wheel profile (geometry/locus_scan.hpp) and where the rail
/// begins and ends below it; each local minimum is then refined to the root of the sine of the
/// angle between wheel and rail tangent (the paper, equations 1 to 8, here one-dimensional). Under
/// yaw the locus runs along a ridge of the wheel from the slope of one flank to that of the other
/// and may have a minimum there. The scan is global: no contact is missed that is wider than the
/// node distance of the profile curve (at most 0.5 mm). Between two scans a contact can be followed
/// to a pose nearby, which costs little but sees nothing else.
///
/// Units mm and rad; track frame, left side (geometry/frames.hpp).
/// Thread rule: search_contacts is a pure function; one SideSearch, one thread.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "geometry/locus_scan.hpp"
#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"

namespace wrc {

/// A locally least distance of wheel and rail, with the wheelset's centre at height 0.
struct ContactCandidate {
  LocusPoint wheel;
  double distance = 0.0;   ///< vertical, z_wheel - z_rail; the wheel touches at height -distance
  double rail_angle = 0.0; ///< of the rail's tangent about x, rad, > 0: rises to the left
  bool at_profile_end = false;
  double rail_rise = 0.0;   ///< slope along the track, of a rail that varies
  double ahead = 0.0;       ///< of where a round wheel is nearest on a prismatic rail, mm
  bool at_part_end = false; ///< where a part of such a rail begins or ends along the track
};

/// One sample of the scan.
struct DistanceSample {
  LocusPlace wheel;
  double distance = 0.0;   ///< vertical
  double rail_slope = 0.0; ///< tangent of the rail's angle about x
  double rail_rise = 0.0;  ///< slope along the track, of a rail that varies
  double ahead = 0.0;      ///< as of ContactCandidate
  double by_y = 0.0;       ///< derivative of the distance, along the locus as at its x

  [[nodiscard]] double rail_angle() const { return std::atan(rail_slope); }
};

struct ContactScan {
  std::vector<DistanceSample> samples;      ///< over the rail only, from flange to field side
  std::vector<ContactCandidate> candidates; ///< least distance first
  double yaw_tangent = 0.0;                 ///< of the pose
};

/// By how much the least distance of a scan exceeds that of another.
inline double behind(const ContactScan& scan, const ContactScan& first) {
  return scan.candidates.front().distance - first.candidates.front().distance;
}

/// A point between the nodes of the wheel's profile.
struct LocusSpot {
  std::size_t piece = 0; ///< of the wheel's graph
  double along = 0.0;    ///< arc from the piece's begin
  double distance = std::numeric_limits<double>::infinity();
  double turned = 1.0; ///< fraction of a ridge's turn at the start of the piece; 1: past it
};

class SideSearch {
public:
  /// Both surfaces must outlive the search. Buffers are kept from one pose to the next.
  SideSearch(const WheelSurface& wheel, const RailSurface& rail);

  /// Scans all nodes. Throws Error(no_contact) if no part of the wheel is over the rail.
  void scan(const Pose& pose);
  /// The same, but returns false instead of throwing.
  [[nodiscard]] bool try_scan(const Pose& pose);
  /// All local minima of the pose scanned last that exceed the smallest by no more than
  /// `near_tolerance` (mm, >= 0), smallest first.
  [[nodiscard]] std::vector<LocusSpot> least_spots(double near_tolerance) const;
  /// All nodes over the rail, points of ridges under yaw and the ends of the rail, at the pose
  /// scanned last.
  [[nodiscard]] std::vector<DistanceSample> samples() const;

  /// Goes to another pose without a scan, and from a spot down to the nearest least distance; none
  /// if that leaves the profile or the rail.
  std::optional<LocusSpot> follow(const Pose& pose, const LocusSpot& from);

  [[nodiscard]] double yaw_tangent() const {
    return pose_.rotation.sin_yaw / pose_.rotation.cos_yaw;
  }
  /// All that is known of a spot, at the pose of the last scan or follow.
  [[nodiscard]] ContactCandidate candidate(const LocusSpot& spot) const;

private:
  /// Wheel and rail at one point of the wheel profile.
  struct Meeting {
    double sine = 0.0; ///< of the angle from the rail's to the wheel's tangent; rising root: least
    double distance = std::numeric_limits<double>::infinity();
    bool exists = false;
  };
  /// Along a ridge, by the fraction of its turn.
  struct RidgePlace {
    double turned = 0.0;
    Meeting meeting;
  };
  /// The end of a piece's part that is over the rail.
  struct Edge {
    std::size_t node; ///< the one over the rail
    LocusSpot spot;
  };

  [[nodiscard]] CurvePoint profile_at(std::size_t piece, double along) const;
  [[nodiscard]] CurvePoint on_ridge(const Ridge& ridge, double turned) const;
  [[nodiscard]] double length_of(std::size_t piece) const;
  [[nodiscard]] Meeting meet(const CurvePoint& point) const;
  [[nodiscard]] Meeting meet(std::size_t piece, double along) const;
  [[nodiscard]] double inside_by(std::size_t piece, double along) const;
  [[nodiscard]] double edge_along(std::size_t piece, double inside, double outside) const;
  [[nodiscard]] LocusSpot refine(std::size_t piece, double low, double high) const;
  [[nodiscard]] RidgePlace ridge_end(const Ridge& ridge, RidgePlace inside, double outside) const;
  [[nodiscard]] std::vector<RidgePlace> ridge_places(const Ridge& ridge, int count) const;
  [[nodiscard]] int searched_places(const Ridge& ridge) const;
  [[nodiscard]] std::optional<LocusSpot> least_on_ridge(std::size_t node) const;
  void refine_around(std::size_t node, std::vector<LocusSpot>& spots) const;
  void find_edges();
  [[nodiscard]] const Edge* edge_at(std::size_t node, std::size_t piece) const;
  [[nodiscard]] DistanceSample sample(const LocusSpot& spot) const;
  [[nodiscard]] const Ridge* ridge_at(std::size_t node) const;
  void add_ridge(const Ridge& ridge, std::vector<DistanceSample>& samples) const;

  const WheelSurface& wheel_;
  const HeightFunction& rail_;
  LocusScan scan_;
  LocusPose pose_;
  std::vector<Edge> edges_; ///< ascending
  double least_ = 0.0;      ///< of nodes and edges
};

/// Throws Error(no_contact) for a pose at which no part of the wheel is over the rail; `hint` ends
/// its text.
[[noreturn]] void throw_off_the_rail(const Pose& pose, const std::string& hint = {});
/// The result of a search whose pose has been scanned. `near_tolerance` (mm, >= 0): a candidate is
/// kept if its distance exceeds the least one by no more.
ContactScan contacts_of(const SideSearch& search, double near_tolerance);
/// Scans one pose first. Throws Error(no_contact) if no part of the wheel is over the rail.
ContactScan search_contacts(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose,
                            double near_tolerance);

} // namespace wrc
