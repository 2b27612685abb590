/// A wheel or rail profile: a curve with its name, kind and origin.
///
/// Wheel: lateral s = 0 at the taping line, positive to the field side; height w positive towards
/// larger radius (flange tip about +28). Rail: lateral t = 0 on the symmetry axis of the rail that
/// is not inclined, positive to the field side; height positive upwards, 0 at the top.
/// Units mm. Thread rule: immutable, safe to share.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/warning.hpp"
#include "profile/curve.hpp"

namespace wrc {

enum class ProfileKind { wheel, rail };

struct Profile {
  std::string name;
  ProfileKind kind = ProfileKind::wheel;
  std::string title;      ///< one line: what it is, by which standard; says so if a reconstruction
  std::string source;     ///< where the numbers come from
  std::string confidence; ///< how sure they are
  Curve curve;
  /// What the curve was drawn through; none of a built-in profile.
  std::vector<Position> points{};
  Warnings warnings{}; ///< what no wheel or rail has, found when it was read
  /// Of noisy points: curves that are equally likely, by whose differences results are uncertain.
  std::shared_ptr<const std::vector<Curve>> likely{};
};

/// Names of the built-in profiles, in the order in which they are listed for users.
std::vector<std::string_view> standard_profile_names(ProfileKind kind);

/// A built-in profile. Throws Error(unknown_name), listing the permitted names.
Profile standard_profile(std::string_view name);

} // namespace wrc
