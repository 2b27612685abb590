/// One key of a scene: what is said of it, and how it is read and set.
///
/// Here text ends: words become enumerators, and the scene holds no other strings than names of
/// profiles. Thread rule: plain values.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "keys/scene.hpp"

namespace wrc {

/// What users learn about a key.
struct KeyDescription {
  std::string_view name;          ///< for example "track.gauge"
  std::string_view default_value; ///< as in a scene file
  std::string_view allowed;       ///< permitted values, with the unit
  std::string_view meaning;
};

/// A value of a key: none if it is not set, or if it has no single value (load.both with
/// different loads on the two wheels).
using KeyValue = std::variant<std::monostate, double, std::string, std::vector<double>>;

struct Key {
  KeyDescription description;
  Dimension dimension;
  double min = 0.0; ///< range of a number in mm, y left, z up, ends included
  double max = 0.0;
  bool whole = false;             ///< whole numbers only
  std::optional<double> usual;    ///< a number that is the default, in mm, y left, z up
  std::vector<double> usual_list; ///< a list that is: zeros in any units
  /// Numbers in mm, y left, z up. Setting returns false for what is not permitted.
  std::function<KeyValue(const Scene&)> get;
  std::function<void(Scene&, double)> set_number;
  std::function<bool(Scene&, std::string_view)> set_text;
  std::function<bool(Scene&, std::span<const double>)> set_numbers;
  std::function<bool(Scene&, const Profile&)> set_profile;
  /// Options of a profile, as the caller has them (keys/profile_text.hpp).
  std::function<KeyValue(const Scene&, std::string_view)> get_option;
  std::function<void(Scene&, std::string_view, std::string_view)> set_option;
  std::function<std::string(std::string_view, Units)> option_unit;
};

} // namespace wrc
