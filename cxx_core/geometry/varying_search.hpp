/// Where a left wheel meets a left rail when either varies along the track or around the wheel.
///
/// Rows of equal y lie where the nodes of the profile below the axle have their contact locus, at
/// most 0.5 mm apart. On each the vertical distance g(x, y) (gap_field.hpp) has one or more least
/// values, where g_x = 0: on a nose and a wing, or at both ends of a flat. A coarse scan over x and
/// y finds them, Newton's method settles them and follows each from row to row: a chain plays the
/// role of the contact locus for varying bodies. Its local minima, where g_y = 0 as well, are the
/// candidates of contact.
///
/// A sample's curvature and place come from the two places on its row where the distance is larger
/// by a typical depth, since the distance itself is no parabola at the end of a flat. They are
/// compared with those of the round wheel and the prismatic rail of the sections below the axle:
/// where nothing varies, samples are those of contact_search.hpp.
/// Units mm and rad; track frame, left side (frames.hpp). Not covered: minima narrower than the
/// coarse scan (5 mm along, 2 mm across) beside deeper ones. Thread rule: one search, one thread.
#pragma once

#include <optional>
#include <vector>

#include "geometry/contact_search.hpp"
#include "geometry/gap_field.hpp"

namespace wrc {

class VaryingSearch {
public:
  /// Both must outlive the search.
  VaryingSearch(const WheelSurface& wheel, const RailSurface& rail);

  /// A least distance along x.
  struct Spot {
    double x = 0.0;
    double y = 0.0;
    GapPoint point;
    bool at_end = false;      ///< where the rail or the wheel ends
    bool at_part_end = false; ///< along x
  };

  /// False if no part of the wheel is over the rail.
  [[nodiscard]] bool try_scan(const Pose& pose);
  /// Of the pose scanned last.
  [[nodiscard]] const Spot& least() const { return least_; }
  /// One scan a chain, that of the least distance first. `near_tolerance`: of the candidates over
  /// the least distance, mm.
  [[nodiscard]] std::vector<ContactScan> scans(double near_tolerance);

  /// Goes to another pose without a scan, and down to the nearest least distance; none if that
  /// leaves the bodies.
  [[nodiscard]] std::optional<Spot> follow(const Pose& pose, const Spot& from);
  /// Derivative of the distance at a least one by the roll of this side's pose.
  [[nodiscard]] double by_roll(const Spot& spot) const;

private:
  struct Chain {
    std::vector<Spot> rows; ///< ascending in y
    /// Whether its first row and its last one are not where a body ends, but where the minimum
    /// comes to an end: the locus turns back.
    bool turns_first = false;
    bool turns_last = false;
  };

  /// How far it is from a least distance to where the distance is larger by a typical depth.
  struct HalfLengths {
    double before = 0.0;
    double after = 0.0;
    [[nodiscard]] double mean() const { return 0.5 * (before + after); }
    [[nodiscard]] double shift() const { return 0.5 * (after - before); }
  };

  void place_rows();
  [[nodiscard]] std::vector<Spot> coarse_minima();
  [[nodiscard]] static std::optional<Spot> least_in_row(GapField& field, double x, double y);
  [[nodiscard]] std::optional<Spot> followed(const Spot& from, const Spot& found, int halvings);
  [[nodiscard]] std::optional<Spot> track(Chain& chain, std::size_t from, int direction,
                                          double highest);
  [[nodiscard]] bool is_known(const Spot& spot) const;
  [[nodiscard]] std::vector<Spot> minima_of(const Chain& chain);
  [[nodiscard]] Spot between(const Spot& low, const Spot& high);
  [[nodiscard]] static HalfLengths half_lengths(GapField& field, const Spot& spot);
  [[nodiscard]] DistanceSample sample(const Spot& spot, bool is_near);
  [[nodiscard]] ContactCandidate candidate(const Spot& spot) const;

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  WheelSurface round_; ///< of the section below the axle
  RailSurface prism_;
  Pose pose_;
  std::vector<double> rows_; ///< y of the pose scanned last, ascending
  std::optional<GapField> field_;
  std::optional<GapField> plain_;         ///< of the round wheel and the prismatic rail
  std::vector<Chain> chains_;             ///< that of the least distance first
  std::vector<std::vector<Spot>> minima_; ///< of the chains, least first
  Spot least_;
};

} // namespace wrc
