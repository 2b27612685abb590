#include "support/scene_file.hpp"

#include "support/toml.hpp"

namespace driver {

namespace {

void apply_table(Scene& scene, const std::string& path, const toml::table& table) {
  Values values;
  flatten(table, "", values);
  for (auto& [key, value] : values) {
    if (std::string* name = std::get_if<std::string>(&value); name && names_profile(key)) {
      *name = beside(path, *name);
    }
  }
  set_values(scene, values);
}

constexpr const char* scene_file = "scene file";

} // namespace

void apply_scene_file(Scene& scene, const std::string& path) {
  apply_table(scene, path, read_toml(scene_file, path));
}

void apply_scene_text(Scene& scene, const std::string& path, const std::string& text) {
  apply_table(scene, path, parse_toml(scene_file, path, text));
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
