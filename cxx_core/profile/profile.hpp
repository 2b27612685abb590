/// A wheel or rail profile: a curve with its name, kind and origin.
///
/// Wheel: lateral s = 0 at the taping line, positive to the field side; height w positive towards
/// larger radius (flange tip about +28). Rail: lateral t = 0 on the symmetry axis of the rail that
/// is not inclined, positive to the field side; height positive upwards, 0 at the top.
/// Units mm. Thread rule: immutable, safe to share.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/deferred.hpp"
#include "base/warning.hpp"
#include "profile/constants.hpp"
#include "profile/curve.hpp"

namespace wrc {

enum class ProfileKind { wheel, rail };

/// What the points of a profile leave open.
struct ProfileDoubt {
  Curve curve; ///< of the profile
  /// Equally likely curves, by whose differences noise makes results uncertain.
  std::vector<Curve> likely;
  /// The curve with its smoothed_waves halved; none if the points cannot be smoothed.
  std::vector<Curve> smoothed;
  /// Whether waves may be noise, so that the smoothed curves are as likely as the profile's.
  bool is_of_waves = false;
};

struct Profile {
  std::string name;
  ProfileKind kind = ProfileKind::wheel;
  std::string title;      ///< one line: what it is, by which standard; says so if a reconstruction
  std::string source;     ///< where the numbers come from
  std::string confidence; ///< how sure they are
  Curve curve;
  /// What the curve was drawn through; none of a built-in profile.
  std::vector<Position> points{};
  Warnings warnings{};            ///< what no wheel or rail has, found when it was read
  Deferred<ProfileDoubt> doubt{}; ///< not valid of exact curves
};

/// Names of the built-in profiles, in the order in which they are listed for users.
std::vector<std::string_view> standard_profile_names(ProfileKind kind);

/// The name of the built-in profile that is meant: in capitals or not, a rail also by its name
/// before EN 13674-1 (UIC60, S49), unless there is a file of that spelling. Empty if there is none
/// of that kind.
std::string_view standard_name(std::string_view name, ProfileKind kind);

/// A built-in profile, by any of its names. Throws Error(unknown_name), listing the permitted
/// names.
Profile standard_profile(std::string_view name);

} // namespace wrc
