/// A rail that varies along the track: its sheets (surface_sheet.hpp), which begin and end where
/// its parts do.
///
/// Frame of the rail's profile: lateral to the field side, height upwards, along forward from the
/// origin of the slices file, not yet inclined or placed in the track. Units mm.
/// Not covered: what is before the first and beyond the last slice: no rail is there.
/// Thread rule: immutable after construction, safe to share.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/sliced_sheets.hpp"

namespace wrc {

class VaryingRail {
public:
  /// `smoothing_length`: waves along the track of this length in mm are halved, 0: the surface
  /// passes through the slices; none: as the list says. Throws Error(invalid_argument), for a
  /// folded surface with the numbers of the slices.
  explicit VaryingRail(const SlicedProfile& profile, std::optional<double> smoothing_length = {});

  [[nodiscard]] std::span<const SurfaceSheet> sheets() const { return sheets_; }
  [[nodiscard]] double smoothing_length() const { return smoothing_length_; }
  /// From the begin of the first sheet to the end of the last.
  [[nodiscard]] Stretch along() const;
  /// The highest point over a place in the plane, of all sheets; none in a gap.
  [[nodiscard]] std::optional<GraphPoint> over(double along, double lateral) const;

private:
  double smoothing_length_;
  std::vector<SurfaceSheet> sheets_;
};

} // namespace wrc
