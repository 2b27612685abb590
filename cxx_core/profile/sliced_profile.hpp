/// A profile that varies along the track or around the wheel: its slices as curves.
///
/// Places: mm along the rail, or rad around the wheel. Curves in the frame of profile.hpp, mm;
/// those of a wheel have height 0 at the nominal radius. Features are arc lengths of the curves,
/// which ascend from the flange (gauge) side. Thread rule: plain values, no state.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profile/profile.hpp"

namespace wrc {

struct ProfileSlice {
  double place = 0.0; ///< mm along the rail, rad around the wheel
  Curve curve;
  /// Arc lengths, the same number in each slice; none: absent from it.
  std::vector<std::optional<double>> features{};
};

struct SlicedProfile {
  std::string name;
  ProfileKind kind = ProfileKind::rail;
  std::vector<ProfileSlice> slices; ///< in ascending order
  bool is_smoothed = false;         ///< along, as the list requests
  std::vector<std::string> corrections{};
};

/// Whether all slices are the same, to the last bit, and whole.
bool has_equal_slices(const SlicedProfile& profile);

} // namespace wrc
