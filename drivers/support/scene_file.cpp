#include "support/scene_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <variant>

// toml++ is a well-kept library whose headers do not follow our warning levels.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>
#pragma GCC diagnostic pop

namespace driver {
namespace {

namespace fs = std::filesystem;
using Value = std::variant<double, std::string, std::vector<double>>;

/// A scene file is short: a larger one is something else.
constexpr std::uintmax_t largest_scene_file = 1 << 20;
/// Keys whose value is a built-in name or a file.
constexpr std::array<const char*, 2> profile_keys{"track.rail", "wheelset.wheel"};

std::string text_of(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) { text << value; });
  return text.str();
}

std::optional<double> number_of(const toml::node& node) {
  return node.is_number() ? node.value<double>() : std::nullopt;
}

Value value_of(const std::string& key, const toml::node& node) {
  if (const auto number = number_of(node)) {
    return *number;
  }
  if (const auto text = node.value<std::string>(); text && node.is_string()) {
    return *text;
  }
  if (const toml::array* array = node.as_array()) {
    std::vector<double> numbers;
    for (const toml::node& entry : *array) {
      const auto number = number_of(entry);
      if (!number) {
        throw Failure(key + " = " + text_of(node) + ": allowed in a list are numbers");
      }
      numbers.push_back(*number);
    }
    return numbers;
  }
  throw Failure(key + " = " + text_of(node) +
                ": allowed are a number, a text or a list of numbers");
}

void flatten(const toml::table& table, const std::string& prefix,
             std::map<std::string, Value>& values) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* inner = node.as_table()) {
      flatten(*inner, name + '.', values);
    } else {
      values.insert_or_assign(name, value_of(name, node));
    }
  }
}

void set_all(Scene& scene, const std::map<std::string, Value>& values) {
  const auto set = [&scene](const std::string& key, const Value& value) {
    std::visit([&](const auto& held) { scene.set(key, held); }, value);
  };
  const std::vector<Key> keys = scene_keys();
  for (const auto& [name, value] : values) {
    const auto is_name = [&name = name](const Key& key) { return key.name == name; };
    if (std::none_of(keys.begin(), keys.end(), is_name)) {
      set(name, value); // fails and says which keys there are
    }
  }
  for (const Key& key : keys) {
    if (const auto found = values.find(key.name); found != values.end()) {
      set(key.name, found->second);
    }
  }
}

} // namespace

void apply_scene_file(Scene& scene, const std::string& path) {
  std::error_code trouble;
  const auto size = fs::file_size(path, trouble);
  if (trouble) {
    throw Failure("scene file " + path + ": " + trouble.message());
  }
  if (size > largest_scene_file) {
    throw Failure("scene file " + path + ": " + std::to_string(size) + " bytes; allowed are " +
                  std::to_string(largest_scene_file));
  }
  std::map<std::string, Value> values;
  try {
    flatten(toml::parse_file(path), "", values);
  } catch (const toml::parse_error& error) {
    std::ostringstream text;
    text << "scene file " << path << ", line " << error.source().begin.line << ": "
         << error.description();
    throw Failure(text.str());
  }
  for (const char* key : profile_keys) {
    const auto found = values.find(key);
    if (found != values.end() && std::holds_alternative<std::string>(found->second)) {
      const fs::path beside = fs::path(path).parent_path() / std::get<std::string>(found->second);
      if (fs::is_regular_file(beside, trouble)) {
        found->second = beside.string();
      }
    }
  }
  set_all(scene, values);
}

void apply_assignments(Scene& scene, const std::vector<std::string>& assignments) {
  std::map<std::string, Value> values;
  for (const std::string& assignment : assignments) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw Failure("--set " + assignment + ": allowed is key=value");
    }
    const std::string key = assignment.substr(0, equals);
    const std::string value = assignment.substr(equals + 1);
    const bool is_quoted = value.starts_with('"') || value.starts_with('\'');
    if (std::find(profile_keys.begin(), profile_keys.end(), key) != profile_keys.end() &&
        !is_quoted) {
      values.insert_or_assign(key, value); // 60E1 would be the number 600
      continue;
    }
    try {
      flatten(toml::parse(key + " = " + value), "", values);
    } catch (const toml::parse_error&) {
      values.insert_or_assign(key, value); // a bare word
    }
  }
  set_all(scene, values);
}

} // namespace driver
