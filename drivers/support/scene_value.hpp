/// Values of a scene's keys before they are set: numbers, texts, lists.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// A value that stands for itself, without quotes: a word or a number, as the key needs it.
struct Bare {
  std::string text;
};
using Value = std::variant<double, std::string, std::vector<double>, Bare>;
using Values = std::map<std::string, Value>;

/// Sets one key. A bare value is a text if the key takes it as one (the rail 60E1 looks like a
/// number), or else a number. Throws Failure naming key, value and what is allowed.
void set_value(Scene& scene, const std::string& key, const Value& value);
/// Sets keys in the library's order, the general before the special (load.vertical before
/// load.left).
void set_values(Scene& scene, const Values& values);

/// Profile files named in a scene file are looked up beside it: the path if one is there, or else
/// the name as it is.
std::string beside(const std::string& file, const std::string& profile);
/// Whether the key's text names a profile.
bool names_profile(const std::string& key);

} // namespace driver
