#include "support/scene_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

#include "support/toml.hpp"

namespace driver {
namespace {

const std::vector<wrcontact::SceneKey>& keys() {
  static const std::vector<wrcontact::SceneKey> all = wrcontact::scene_keys();
  return all;
}

/// Allowed values of a key, as the library states them; empty for an unknown key.
std::string_view allowed(const std::string& key) {
  const auto found = std::find_if(keys().begin(), keys().end(),
                                  [&key](const auto& known) { return known.name == key; });
  return found == keys().end() ? "" : found->allowed;
}

/// A number, unless it names a profile (the rail 60E1 looks like one) or is not one.
void set_bare(Scene& scene, const std::string& key, const std::string& text) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  if (!names_profile(key) && parsed.ec == std::errc() && parsed.ptr == end) {
    scene.set(key, number);
  } else {
    scene.set(key, text);
  }
}

constexpr const char* scene_file = "scene file";
constexpr const char* file_option = ".file";
constexpr const char* nominal_option = ".align_to";

/// Whether the key's text is a profile with its options.
bool is_profile(const std::string& key) {
  return allowed(key).starts_with("a text");
}

double number_or(const Scene& scene, const std::string& key, double otherwise) {
  try {
    return scene.get_number(key);
  } catch (const wrcontact::Error&) { // a word
    return otherwise;
  }
}

/// Throws Failure naming file and line if a table has a key that the library does not know.
void refuse_unknown_keys(const Scene& scene, const std::string& path, const toml::table& table,
                         const std::string& prefix) {
  for (const auto& [key, node] : table) {
    const std::string name = name_within(prefix, key);
    if (const toml::table* inner = node.as_table()) {
      if (allowed(name).empty() || is_profile(name)) { // a range of values is refused as such
        refuse_unknown_keys(scene, path, *inner, name + '.');
      }
      continue;
    }
    try {
      (void)scene.key_unit(name);
    } catch (const wrcontact::Error& error) {
      throw Failure(std::string(scene_file) + ' ' + path + ", line " +
                    std::to_string(key.source().begin.line) + ": " + error.what());
    }
  }
}

void apply_table(Scene& scene, const std::string& path, const toml::table& table) {
  refuse_unknown_keys(scene, path, table, "");
  Values values;
  flatten(table, "", values);
  for (auto& [key, value] : values) {
    if (std::string* name = std::get_if<std::string>(&value); name && names_profile(key)) {
      *name = beside(path, key, *name);
    }
  }
  set_values(scene, values);
}

} // namespace

std::string text_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value)) {
    return text_of(*number);
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    std::string text;
    for (const double number : *numbers) {
      text += (text.empty() ? "[" : ", ") + text_of(number);
    }
    return text + ']';
  }
  const Bare* bare = std::get_if<Bare>(&value);
  return bare != nullptr ? bare->text : std::get<std::string>(value);
}

void set_value(Scene& scene, const std::string& key, const Value& value) {
  try {
    if (const Bare* bare = std::get_if<Bare>(&value)) {
      set_bare(scene, key, bare->text);
    } else if (const double* number = std::get_if<double>(&value)) {
      scene.set(key, *number);
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      scene.set(key, *numbers);
    } else {
      scene.set(key, std::get<std::string>(value));
    }
  } catch (const wrcontact::Error& error) {
    throw Failure(error.what());
  }
}

std::string profile_of(const std::string& key) {
  const std::string parent = key.substr(0, key.rfind('.'));
  return parent != key && is_profile(parent) ? parent : "";
}

void set_values(Scene& scene, const Values& values) {
  for (const auto& [key, value] : values) {
    if (allowed(key).empty() && profile_of(key).empty()) {
      const std::string parent = key.substr(0, key.rfind('.'));
      if (!allowed(parent).empty()) {
        throw Failure(parent + ": must be one value; wrc_sweep takes ranges and lists of values");
      }
      set_value(scene, key, value); // fails and says which keys there are
    }
  }
  const auto set = [&](const std::string& key) {
    const auto found = values.find(key);
    if (found != values.end()) {
      set_value(scene, key, found->second);
    }
    return found != values.end();
  };
  const auto set_options = [&](const std::string& profile) {
    for (auto option = values.lower_bound(profile + '.');
         option != values.end() && profile_of(option->first) == profile; ++option) {
      if (option->first != profile + file_option) {
        set_value(scene, option->first, option->second);
      }
    }
  };
  std::vector<std::string> only_options; // of profiles that other keys name
  for (const wrcontact::SceneKey& key : keys()) {
    const bool named = set(key.name);
    if (!is_profile(key.name)) {
      continue;
    }
    if (set(key.name + std::string(file_option)) || named) {
      set_options(key.name);
    } else {
      only_options.emplace_back(key.name);
    }
  }
  for (const std::string& profile : only_options) {
    set_options(profile);
  }
}

Values values_in_force(const Scene& scene) {
  Values values;
  const auto take = [&](const char* key, auto&& get) {
    try {
      values.insert_or_assign(key, get(key));
    } catch (const wrcontact::Error&) { // of another type
    }
  };
  for (const wrcontact::SceneKey& key : keys()) {
    take(key.name, [&](const char* name) { return scene.get_number(name); });
    take(key.name, [&](const char* name) { return scene.get_text(name); });
    take(key.name, [&](const char* name) { return scene.get_numbers(name); });
  }
  return values;
}

std::string profile_name(const std::string& key, const std::string& text) {
  Scene scene;
  set_value(scene, key, text);
  return scene.get_text(key + file_option);
}

std::set<std::string> profile_files(const Scene& scene) {
  std::set<std::string> files;
  for (const wrcontact::SceneKey& key : keys()) {
    for (const char* option : {file_option, nominal_option}) {
      try {
        const std::string name =
            is_profile(key.name) ? scene.get_text(std::string(key.name) + option) : "";
        std::error_code trouble;
        if (!is_standard(name) && std::filesystem::is_regular_file(name, trouble)) {
          files.insert(name);
        }
      } catch (const wrcontact::Error&) { // the keys of the sides tell
      }
    }
  }
  return files;
}

std::vector<std::filesystem::path> files_of(const std::string& wheel, const std::string& rail) {
  Scene scene;
  set_value(scene, "wheelset.wheel", wheel);
  if (!rail.empty()) {
    set_value(scene, "track.rail", rail);
  }
  const std::set<std::string> files = profile_files(scene);
  return {files.begin(), files.end()};
}

bool is_slices_file(const std::string& name) {
  const std::string extension = lower_case(std::filesystem::path(name).extension().string());
  return extension == ".slcs" || extension == ".slcw";
}

void refuse_varying(const Scene& scene, const std::string& what) {
  for (const auto& [key, value] : values_in_force(scene)) {
    const std::vector<double>* list = std::get_if<std::vector<double>>(&value);
    const bool waves = key.ends_with("harmonics") && list != nullptr && !list->empty();
    if (waves || (is_profile(key) && is_slices_file(scene.get_text(key + file_option)))) {
      throw Failure(key + " = " + text_of(value) + ": " + what +
                    " rails do not vary along the track, nor wheels around their circumference");
    }
  }
}

Profile load_profile(const Scene& scene, std::int32_t kind, const std::string& text) {
  const bool wheel = kind == WRC_WHEEL;
  const std::string key = wheel ? "wheelset.wheel" : "track.rail";
  Scene chosen;
  set_value(chosen, key, text);
  const std::string name = chosen.get_text(key + file_option);
  Profile profile;
  if (is_standard(name)) {
    profile.load_standard(name);
    if (profile.kind() != kind) {
      throw Failure(name + ": must be a " + (wheel ? "wheel" : "rail"));
    }
    return profile;
  }
  if (std::error_code ignored; !std::filesystem::exists(name, ignored)) {
    throw Failure(name +
                  ": no such file; must be a file or one of the built-in names, which wrc_profile "
                  "--list lists");
  }
  if (is_slices_file(name)) {
    throw Failure(name + ": must be a file of one profile here, not one of slices " +
                  (wheel ? "around the wheel" : "along the track") + "; wrc_profile " + name +
                  " --slice N --convert FILE makes one of a slice");
  }
  wrc_read_options options{};
  options.struct_size = sizeof options;
  options.kind_given = 1;
  options.kind = kind;
  const double length = number_or(chosen, key + ".smoothing", WRC_SMOOTHING_AUTO);
  options.smoothing_wavelength = length == 0.0 ? WRC_SMOOTHING_NONE : length;
  const double unset = std::numeric_limits<double>::quiet_NaN();
  const double rotation = number_or(chosen, key + ".rotation", unset);
  options.rotation_given = std::isnan(rotation) ? 0 : 1;
  options.rotation = options.rotation_given != 0 ? rotation : 0.0;
  const std::string nominal = chosen.get_text(key + nominal_option);
  options.align_to = nominal == "none" ? nullptr : nominal.c_str();
  if (wheel) {
    options.tape_offset = scene.get_number("wheelset.tape_offset");
    options.lateral_shift = number_or(chosen, key + ".shift", 0.0);
    const std::string origin = chosen.get_text(key + ".origin");
    options.origin = origin == "tape"          ? WRC_ORIGIN_TAPE
                     : origin == "flange-back" ? WRC_ORIGIN_FLANGE_BACK
                                               : 0;
  }
  profile.load_file(name, &options);
  return profile;
}

void use_rail(Scene& scene, const Profile& rail, const std::string& text) {
  scene.set("track.rail", rail);
  Scene chosen;
  set_value(chosen, "track.rail", text);
  const double unset = std::numeric_limits<double>::quiet_NaN();
  if (const double origin = number_or(chosen, "track.rail.origin", unset); !std::isnan(origin)) {
    scene.set("track.rail.origin", origin);
  }
}

std::string beside(const std::string& file, const std::string& key, const std::string& value) {
  const auto found = [&](const std::string& name) {
    // A built-in profile is not hidden by a file of its name.
    std::error_code trouble;
    const auto path = std::filesystem::path(file).parent_path() / name;
    return !is_standard(name) && std::filesystem::is_regular_file(path, trouble) ? path.string()
                                                                                 : name;
  };
  if (!is_profile(key)) {
    return found(value);
  }
  Scene scene;
  const std::string none = "?"; // of a text that has options alone
  scene.set(key + file_option, none);
  set_value(scene, key, value);
  const std::string name = scene.get_text(key + file_option);
  scene.set(key + nominal_option, found(scene.get_text(key + nominal_option)));
  return (name == none ? "" : found(name)) + scene.get_text(key).substr(name.size());
}

bool names_profile(const std::string& key) {
  return is_profile(key) || (!profile_of(key).empty() &&
                             (key.ends_with(file_option) || key.ends_with(nominal_option)));
}

bool takes_list(const std::string& key) {
  return allowed(key).starts_with('[');
}

void apply_scene_file(Scene& scene, const std::string& path) {
  apply_table(scene, path, read_toml(scene_file, path));
}

void apply_scene_text(Scene& scene, const std::string& path, const std::string& text) {
  apply_table(scene, path, parse_toml(scene_file, path, text));
}

Assignment split_assignment(const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw Failure("--set " + assignment + ": must be key=value");
  }
  return {lower_case(assignment.substr(0, equals)), assignment.substr(equals + 1)};
}

void apply_assignments(Scene& scene, const std::vector<std::string>& assignments) {
  Values values;
  for (const std::string& text : assignments) {
    const Assignment assignment = split_assignment(text);
    if (assignment.is_toml()) {
      flatten(parse_assignment(text, assignment.key, assignment.value), "", values);
    } else {
      values.insert_or_assign(assignment.key, Bare{assignment.value});
    }
  }
  set_values(scene, values);
}

} // namespace driver
