#include "support/scene_value.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace driver {
namespace {

namespace fs = std::filesystem;

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

} // namespace

void set_value(Scene& scene, const std::string& key, const Value& value) {
  if (const Bare* bare = std::get_if<Bare>(&value)) {
    set_bare(scene, key, bare->text);
  } else if (const double* number = std::get_if<double>(&value)) {
    scene.set(key, *number);
  } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    scene.set(key, *numbers);
  } else {
    scene.set(key, std::get<std::string>(value));
  }
}

void set_values(Scene& scene, const Values& values) {
  static const std::vector<Key> keys = scene_keys();
  for (const auto& [name, value] : values) {
    const auto is_name = [&name = name](const Key& key) { return key.name == name; };
    if (std::none_of(keys.begin(), keys.end(), is_name)) {
      set_value(scene, name, value); // fails and says which keys there are
    }
  }
  for (const Key& key : keys) {
    if (const auto found = values.find(key.name); found != values.end()) {
      set_value(scene, key.name, found->second);
    }
  }
}

std::string beside(const std::string& file, const std::string& profile) {
  std::error_code trouble;
  // A built-in profile is not hidden by a file of its name.
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    for (std::int64_t i = 0; const char* known = wrc_profile_standard_name(kind, i); ++i) {
      if (profile == known) {
        return profile;
      }
    }
  }
  const fs::path path = fs::path(file).parent_path() / profile;
  return fs::is_regular_file(path, trouble) ? path.string() : profile;
}

bool names_profile(const std::string& key) {
  return key == "track.rail" || key == "wheelset.wheel";
}

} // namespace driver
