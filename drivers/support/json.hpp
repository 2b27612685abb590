/// JSON as the drivers print it.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

namespace driver {

using nlohmann::json;

/// null for none.
inline json json_of(const std::optional<double>& value) {
  return value ? json(*value) : json();
}

/// Adds a value only if there is one.
inline void add_if(json& object, const char* key, const std::optional<double>& value) {
  if (value) {
    object[key] = *value;
  }
}
inline void add_if(json& object, const char* key, const std::string& text) {
  if (!text.empty()) {
    object[key] = text;
  }
}

/// One object, 17 digits.
inline void print_json(const json& object, std::ostream& out, int indent = 2) {
  out << object.dump(indent) << '\n';
}

} // namespace driver
