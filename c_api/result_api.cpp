#include <algorithm>

#include "handles.hpp"

namespace {

/// The value of a name in a list of pairs; throws Error(unknown_name).
template <class Value>
const Value& find_value(const std::vector<std::pair<std::string, Value>>& values,
                        const char* name) {
  wrc::require_pointer(name, "name");
  const auto found = std::find_if(values.begin(), values.end(),
                                  [name](const auto& entry) { return entry.first == name; });
  if (found == values.end()) {
    throw wrc::Error(wrc::ErrorCode::unknown_name,
                     "no result is named \"" + std::string(name) + '"');
  }
  return found->second;
}

template <class Value>
const char* name_at(const std::vector<std::pair<std::string, Value>>& values, int64_t index) {
  return index >= 0 && index < static_cast<int64_t>(values.size())
             ? values[static_cast<std::size_t>(index)].first.c_str()
             : nullptr;
}

/// Runs a body that needs results.
template <class Body> wrc_status with_result(wrc_scene* scene, Body&& body) {
  return wrc::guard(scene, [&]() -> wrc_status {
    if (!scene->result) {
      scene->error = "the scene has not been solved yet";
      return WRC_NO_RESULT;
    }
    return body();
  });
}

} // namespace

extern "C" {

wrc_status wrc_scene_number(wrc_scene* scene, const char* name, double* value) {
  return with_result(scene, [&] {
    wrc::require_pointer(value, "value");
    *value = find_value(scene->numbers, name);
    return WRC_OK;
  });
}

wrc_status wrc_scene_text(wrc_scene* scene, const char* name, const char** value) {
  return with_result(scene, [&] {
    wrc::require_pointer(value, "value");
    *value = find_value(scene->texts, name).c_str();
    return WRC_OK;
  });
}

wrc_status wrc_scene_field(wrc_scene* scene, const char* name, double* values, int64_t capacity,
                           int64_t* count) {
  return with_result(scene, [&] {
    wrc::require_pointer(name, "name");
    const std::string_view asked = name;
    const auto known = wrc::field_names();
    const auto dot = asked.find('.');
    const bool is_field =
        dot != std::string_view::npos &&
        std::find(known.begin(), known.end(), asked.substr(dot + 1)) != known.end();
    const std::string_view side = asked.substr(0, std::min(dot, asked.size()));
    const bool has_side =
        (side == "left" && scene->result->left) || (side == "right" && scene->result->right);
    if (!is_field || !has_side) {
      throw wrc::Error(wrc::ErrorCode::unknown_name,
                       "no field is named \"" + std::string(asked) + '"');
    }
    const auto field = wrc::field_values(*scene->result, asked);
    return wrc::copy_values(field.data(), field.size(), values, capacity, count, scene->error);
  });
}

int64_t wrc_scene_number_count(const wrc_scene* scene) {
  return scene == nullptr ? 0 : static_cast<int64_t>(scene->numbers.size());
}

const char* wrc_scene_number_name(const wrc_scene* scene, int64_t index) {
  return scene == nullptr ? nullptr : name_at(scene->numbers, index);
}

int64_t wrc_scene_text_count(const wrc_scene* scene) {
  return scene == nullptr ? 0 : static_cast<int64_t>(scene->texts.size());
}

const char* wrc_scene_text_name(const wrc_scene* scene, int64_t index) {
  return scene == nullptr ? nullptr : name_at(scene->texts, index);
}
}
