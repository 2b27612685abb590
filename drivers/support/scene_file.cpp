#include "support/scene_file.hpp"

#include <algorithm>
#include <charconv>
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
/// A value that stands for itself, without quotes: a word or a number, as the key needs it.
struct Bare {
  std::string text;
};
using Value = std::variant<double, std::string, std::vector<double>, Bare>;

/// A scene file is short: a larger one is something else.
constexpr std::uintmax_t largest_scene_file = 1 << 20;

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

/// Sets a bare value: a text if the key takes it as one (the rail 60E1 looks like a number), or
/// else a number.
void set_bare(Scene& scene, const std::string& key, const std::string& text) {
  double number = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
  try {
    scene.set(key, text);
  } catch (const Failure&) {
    if (!is_number) {
      throw;
    }
    scene.set(key, number);
  }
}

void set_all(Scene& scene, const std::map<std::string, Value>& values) {
  const auto set = [&scene](const std::string& key, const Value& value) {
    if (const Bare* bare = std::get_if<Bare>(&value)) {
      set_bare(scene, key, bare->text);
    } else if (const double* number = std::get_if<double>(&value)) {
      scene.set(key, *number);
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      scene.set(key, *numbers);
    } else {
      scene.set(key, std::get<std::string>(value));
    }
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

namespace {

bool is_standard(const std::string& name, std::int32_t kind) {
  for (std::int64_t i = 0; const char* known = wrc_profile_standard_name(kind, i); ++i) {
    if (name == known) {
      return true;
    }
  }
  return false;
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
  for (const auto& [key, kind] :
       {std::pair("track.rail", WRC_RAIL), std::pair("wheelset.wheel", WRC_WHEEL)}) {
    const auto found = values.find(key);
    if (found != values.end() && std::holds_alternative<std::string>(found->second) &&
        !is_standard(std::get<std::string>(found->second), kind)) {
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
    // Texts in quotes, lists and tables are TOML, the rest stands for itself.
    if (value.find_first_of("\"'[{") == 0) {
      try {
        flatten(toml::parse(key + " = " + value), "", values);
      } catch (const toml::parse_error& error) {
        throw Failure("--set " + assignment + ": " + std::string(error.description()));
      }
    } else {
      values.insert_or_assign(key, Bare{value});
    }
  }
  set_all(scene, values);
}

} // namespace driver
