/// Features of a list of slices that has none: which stretches of neighbouring slices correspond.
///
/// Where the slices vary gradually, places at the same share of their lengths correspond, as
/// without this. Where parts of a rail begin or end, or the slices are cut at other places, one of
/// two neighbours reaches beyond the other: an end of one lies within the other. There the
/// stretches that both have correspond, at equal shares, and what one has in addition begins or
/// ends with it. An end lies at the nearest place of the other slice where that runs the same way
/// within 90 degrees, and counts as within it if more than 0.05 of the shorter slice is beyond. A
/// common stretch that is shorter than that is none: there the surface is interrupted.
/// The ends of slices at such joints are then followed along the list, at their shares of the
/// slices and through the joints, as far as they lie in common stretches, and become features.
///
/// Where a rail rises, the lower slice reaches beyond the higher one too, but nothing ends. The
/// stretch of it that lies within the higher one is then shorter than that slice, by more than the
/// slices differ in length, and both correspond as a whole.
///
/// Units mm. Thread rule: no state. Not covered: parts that begin or end within slices whose ends
/// go on as they are.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "profile/curve.hpp"

namespace wrc {

/// The common stretches of two neighbouring slices, as arc lengths.
struct SliceMatch {
  double begin = 0.0;
  double end = 0.0;
  double next_begin = 0.0;
  double next_end = 0.0;
  /// Whether neither slice reaches beyond the other.
  bool is_whole = true;
  /// Whether there is nothing common.
  [[nodiscard]] bool is_empty() const { return !(end > begin && next_end > next_begin); }
};

SliceMatch match_slices(const Curve& slice, const Curve& next);

struct FoundFeatures {
  /// Arc lengths by slices, the same number in each; none: absent from it. Empty if all neighbours
  /// correspond as a whole.
  std::vector<std::vector<std::optional<double>>> of_slices{};
  std::vector<std::string> notes{}; ///< what begins and ends between which slices
};

/// Of slices in their order. Throws Error(invalid_argument) for more than
/// SliceLimits::max_features.
FoundFeatures find_features(std::span<const Curve* const> slices);

} // namespace wrc
