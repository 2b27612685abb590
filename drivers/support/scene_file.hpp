/// Values of a scene's keys, from TOML files and from the command line. Keys are those of the
/// library (wrc_scene_key).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/numbers.hpp"
#include "support/scene.hpp"
#include "support/values.hpp"

namespace driver {

/// Shortest text that reads back as the same value; texts as they are.
std::string text_of(const Value& value);

/// Sets one key. Throws Failure naming key, value and what is allowed.
void set_value(Scene& scene, const std::string& key, const Value& value);
/// Sets keys in the library's order, the general before the special (load.both before
/// load.left).
void set_values(Scene& scene, const Values& values);

/// A text that names a profile, taken apart as the library does: "worn.txt; smoothing = 5".
struct ProfileText {
  std::string name;
  std::vector<std::pair<std::string, std::string>> options;

  explicit ProfileText(const std::string& text);
  [[nodiscard]] std::string option(const std::string& name, const std::string& otherwise) const;
  [[nodiscard]] std::string text() const;
};
/// The file that such a text names; empty for a built-in profile.
std::string file_of(const std::string& profile);

/// All keys of a scene with their values. Keys of both sides that differ have none.
Values values_in_force(const Scene& scene);
/// Whether the text of a key that names a profile is that of a file, which is there.
bool is_profile_file(const std::string& profile);
/// The files among the profiles of a scene, each once.
std::vector<std::string> profile_files(const Scene& scene);

/// Profile files named in a scene file, also in the option align_to, are looked up beside it: the
/// path if one is there, or else the name as it is.
std::string beside(const std::string& file, const std::string& profile);
/// Whether the key's text names a profile, and whether a list is one value of the key, as the
/// library's table of keys has it.
bool names_profile(const std::string& key);
bool takes_list(const std::string& key);

/// Whether a file's name is that of a list of slices (.slcs, .slcw), in any case.
bool is_slices_file(const std::string& name);

/// Throws Failure, naming the key, if a rail or wheel of the scene varies along the track or around
/// the wheel; `what` says where profiles do not: "in a mission".
void refuse_varying(const Scene& scene, const std::string& what);

/// A profile by its built-in name or from a file, with its options, as a scene with these keys
/// reads it: the taping line of a wheel is that of the scene. Throws Failure if it is of the other
/// kind, or one that varies.
Profile load_profile(const Scene& scene, std::int32_t kind, const std::string& profile);
/// Lets a scene use a profile loaded from this text; a rail is where its option origin says.
void use_profile(Scene& scene, const std::string& key, const Profile& profile,
                 const std::string& text);

/// "key=value" taken apart; throws Failure if there is no key.
struct Assignment {
  std::string key;
  std::string value;
  /// Texts in quotes, lists and tables are TOML, the rest stands for itself.
  [[nodiscard]] bool is_toml() const { return value.find_first_of("\"'[{") == 0; }
};
Assignment split_assignment(const std::string& assignment);

/// Sets a scene from a file, from the text of one, or from assignments "key=value", in which texts
/// need no quotes. Keys are applied in the library's order, the general before the special
/// (load.both before load.left). Profile files named in a scene file are looked up beside it.
/// Throws Failure naming file and line, or key, value and what is allowed.
void apply_scene_file(Scene& scene, const std::string& path);
void apply_scene_text(Scene& scene, const std::string& path, const std::string& text);
void apply_assignments(Scene& scene, const std::vector<std::string>& assignments);

} // namespace driver
