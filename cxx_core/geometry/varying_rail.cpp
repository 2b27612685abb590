#include "geometry/varying_rail.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace wrc {

VaryingRail::VaryingRail(const SlicedProfile& profile, std::optional<double> smoothing_length)
    : smoothing_length_(smoothing_length_of(profile, smoothing_length)),
      sheets_(sheets_of(profile, smoothing_length_, 0.0)) {}

Stretch VaryingRail::along() const {
  Stretch range = sheets_.front().along();
  for (const SurfaceSheet& sheet : sheets_) {
    range.begin = std::min(range.begin, sheet.along().begin);
    range.end = std::max(range.end, sheet.along().end);
  }
  return range;
}

std::optional<GraphPoint> VaryingRail::over(double along, double lateral) const {
  return highest_over(sheets_, along, lateral);
}

} // namespace wrc
