#include "support/scene_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
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

/// Throws Failure naming file and line if a table has a key that the library does not know.
void refuse_unknown_keys(const Scene& scene, const std::string& path, const toml::table& table,
                         const std::string& prefix) {
  for (const auto& [key, node] : table) {
    const std::string name = name_within(prefix, key);
    if (const toml::table* inner = node.as_table()) {
      if (allowed(name).empty()) { // a range of values is refused as such
        refuse_unknown_keys(scene, path, *inner, name + '.');
      }
      continue;
    }
    try {
      (void)scene.key_id(name);
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
      *name = beside(path, *name);
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

void set_values(Scene& scene, const Values& values) {
  for (const auto& [key, value] : values) {
    if (allowed(key).empty()) {
      const std::string parent = key.substr(0, key.rfind('.'));
      if (!allowed(parent).empty()) {
        throw Failure(parent + ": must be one value; wrc_sweep takes ranges and lists of values");
      }
      set_value(scene, key, value); // fails and says which keys there are
    }
  }
  for (const wrcontact::SceneKey& key : keys()) {
    if (const auto found = values.find(key.name); found != values.end()) {
      set_value(scene, key.name, found->second);
    }
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

ProfileText::ProfileText(const std::string& text) {
  constexpr std::string_view blanks = " \t";
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  std::string* value = &name;
  std::size_t begin = 0;
  const auto take_until = [&](std::size_t end) {
    *value = text.substr(begin, end - begin);
    if (begin > 0 || end < text.size()) {
      value->erase(value->find_last_not_of(blanks) + 1);
    }
    if (begin > 0) {
      value->erase(0, std::min(value->find_first_not_of(blanks), value->size()));
    }
  };
  for (std::size_t at = text.find(';'); at != std::string::npos; at = text.find(';', at + 1)) {
    const std::size_t word = text.find_first_not_of(blanks, at + 1);
    const std::size_t end = text.find_first_not_of(letters, word);
    const std::size_t equals = text.find_first_not_of(blanks, end);
    if (equals != std::string::npos && end > word && text[equals] == '=') {
      take_until(at);
      value = &options.emplace_back(lower_case(text.substr(word, end - word)), "").second;
      begin = equals + 1;
    }
  }
  take_until(text.size());
}

std::string ProfileText::option(const std::string& wanted, const std::string& otherwise) const {
  std::string value = otherwise;
  for (const auto& [key, text] : options) {
    value = key == wanted ? text : value;
  }
  return value;
}

std::string ProfileText::text() const {
  std::string all = name;
  for (const auto& [key, value] : options) {
    all.append("; ").append(key).append(" = ").append(value);
  }
  return all;
}

std::string file_of(const std::string& profile) {
  const std::string name = ProfileText(profile).name;
  return is_standard(name) ? "" : name;
}

bool is_profile_file(const std::string& profile) {
  const std::string name = ProfileText(profile).name;
  std::error_code trouble;
  return !is_standard(name) && std::filesystem::is_regular_file(name, trouble);
}

std::vector<std::string> profile_files(const Scene& scene) {
  std::set<std::string> files;
  for (const auto& [key, value] : values_in_force(scene)) {
    if (names_profile(key) && is_profile_file(text_of(value))) {
      files.insert(ProfileText(text_of(value)).name);
    }
  }
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
    if (waves || (names_profile(key) && is_slices_file(ProfileText(text_of(value)).name))) {
      throw Failure(key + " = " + text_of(value) + ": " + what +
                    " rails do not vary along the track, nor wheels around their circumference");
    }
  }
}

Profile load_profile(const Scene& scene, std::int32_t kind, const std::string& text) {
  const bool wheel = kind == WRC_WHEEL;
  Scene checked; // refuses wrong options
  set_value(checked, wheel ? "wheelset.wheel" : "track.rail", text);
  const ProfileText parts(text);
  const std::string& name = parts.name;
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
  const auto number = [&parts](const char* option, double otherwise) {
    const std::string word = parts.option(option, "");
    double value = otherwise;
    std::from_chars(word.data(), word.data() + word.size(), value); // not of a word
    return value;
  };
  wrc_read_options options{};
  options.struct_size = sizeof options;
  options.kind_given = 1;
  options.kind = kind;
  const double length = number("smoothing", WRC_SMOOTHING_AUTO);
  options.smoothing_wavelength = length == 0.0 ? WRC_SMOOTHING_NONE : length;
  const double unset = std::numeric_limits<double>::quiet_NaN();
  const double rotation = number("rotation", unset);
  options.rotation_given = std::isnan(rotation) ? 0 : 1;
  options.rotation = options.rotation_given != 0 ? rotation : 0.0;
  const std::string nominal = parts.option("align_to", "none");
  options.align_to = nominal == "none" ? nullptr : nominal.c_str();
  if (wheel) {
    options.tape_offset = scene.get_number("wheelset.tape_offset");
    options.lateral_shift = number("shift", 0.0);
    const std::string origin = parts.option("origin", "auto");
    options.origin = origin == "tape"          ? WRC_ORIGIN_TAPE
                     : origin == "flange-back" ? WRC_ORIGIN_FLANGE_BACK
                                               : 0;
  }
  profile.load_file(name, &options);
  return profile;
}

void use_profile(Scene& scene, const std::string& key, const Profile& profile,
                 const std::string& text) {
  scene.set(key, profile);
  const std::string origin = ProfileText(text).option("origin", "gauge");
  if (profile.kind() == WRC_RAIL && origin != "gauge") {
    scene.set(key, "; origin = " + origin);
  }
}

std::string beside(const std::string& file, const std::string& profile) {
  const auto found = [&](const std::string& name) {
    // A built-in profile is not hidden by a file of its name.
    std::error_code trouble;
    const auto path = std::filesystem::path(file).parent_path() / name;
    return !is_standard(name) && std::filesystem::is_regular_file(path, trouble) ? path.string()
                                                                                 : name;
  };
  ProfileText parts(profile);
  if (!parts.name.empty()) {
    parts.name = found(parts.name);
  }
  for (auto& [option, value] : parts.options) {
    value = option == "align_to" ? found(value) : value;
  }
  return parts.text();
}

bool names_profile(const std::string& key) {
  return allowed(key).starts_with("a text");
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
