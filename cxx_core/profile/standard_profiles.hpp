/// The segments behind the built-in profiles, for junction reports and checks.
///
/// Units mm. Frame of profile.hpp; rails are complete (both halves).
/// Thread rule: constant data, safe everywhere.
#pragma once

#include <string_view>
#include <vector>

#include "profile/profile.hpp"
#include "profile/segments.hpp"

namespace wrc {

/// Segments of a built-in profile. Throws Error(unknown_name), listing the permitted names.
std::vector<Segment> standard_profile_segments(std::string_view name);

} // namespace wrc
