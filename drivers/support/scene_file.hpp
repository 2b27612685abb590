/// Values of a scene's keys, from TOML files and from the command line. Keys are those of the
/// library (wrc_scene_key).
#pragma once

#include <filesystem>
#include <set>
#include <string>
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

/// All keys of a scene with their values. Keys of both sides that differ have none.
Values values_in_force(const Scene& scene);
/// The name in the text of a profile, which is that of a key: of "worn.txt; smoothing = 5" it is
/// "worn.txt".
std::string profile_name(const std::string& key, const std::string& text);
/// The files that the profiles of a scene are read from, and those they are aligned to.
std::set<std::string> profile_files(const Scene& scene);
/// Likewise of two profiles; no rail if it is empty.
std::vector<std::filesystem::path> files_of(const std::string& wheel, const std::string& rail);

/// Profile files named in a scene file, also in the option align_to, are looked up beside it: the
/// path if one is there, or else the name as it is, with the other options of the value.
std::string beside(const std::string& file, const std::string& key, const std::string& value);
/// The key of the profile of which this is an option, or ".file"; empty for others.
std::string profile_of(const std::string& key);
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
/// Lets a scene use a rail loaded from this text, whose option origin says where it is.
void use_rail(Scene& scene, const Profile& rail, const std::string& text);

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
