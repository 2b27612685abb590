#include <algorithm>

#include "handles.hpp"

namespace {

/// Names of the numbers available; none without a result.
const std::vector<std::string>& number_names_of(wrc::SceneObject& scene) {
  static const std::vector<std::string> none;
  if (!scene.result) {
    return none;
  }
  if (scene.number_names.empty()) {
    scene.number_names = wrc::number_names(*scene.result);
  }
  return scene.number_names;
}

/// Texts by name; none without a result.
const std::vector<std::pair<std::string, std::string>>& texts_of(wrc::SceneObject& scene) {
  static const std::vector<std::pair<std::string, std::string>> none;
  if (!scene.result) {
    return none;
  }
  if (scene.texts.empty()) {
    scene.texts = wrc::text_values(*scene.result, scene.scene.convention);
  }
  return scene.texts;
}

/// One of a list of texts; NULL past its end.
template <class List, class Text>
const char* text_at(const List& list, int64_t index, Text&& text) {
  return index >= 0 && index < static_cast<int64_t>(list.size())
             ? text(list[static_cast<std::size_t>(index)]).c_str()
             : nullptr;
}

[[noreturn]] void throw_unknown(const char* what, const char* name) {
  throw wrc::Error(wrc::ErrorCode::unknown_name,
                   "no " + std::string(what) + " is named \"" + name + '"');
}

/// Runs a body that needs results.
template <class Body> wrc_status with_result(wrc_scene* scene, Body&& body) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) -> wrc_status {
    if (!object.result) {
      object.error = "the scene has not been solved yet";
      return WRC_NO_RESULT;
    }
    return body(object);
  });
}

} // namespace

extern "C" {

wrc_status wrc_scene_number(wrc_scene* scene, const char* name, double* value) {
  return with_result(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const auto found = wrc::number_value(*object.result, name, object.scene.convention);
    if (!found) {
      throw_unknown("result", name);
    }
    *value = *found;
    return WRC_OK;
  });
}

wrc_status wrc_scene_text(wrc_scene* scene, const char* name, const char** value) {
  return with_result(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const auto& texts = texts_of(object);
    const auto found = std::find_if(texts.begin(), texts.end(),
                                    [name](const auto& entry) { return entry.first == name; });
    if (found == texts.end()) {
      throw_unknown("result", name);
    }
    *value = found->second.c_str();
    return WRC_OK;
  });
}

wrc_status wrc_scene_field(wrc_scene* scene, const char* name, double* values, int64_t capacity,
                           int64_t* count) {
  return with_result(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    if (!object.field || object.field->first != name) {
      auto computed = wrc::field_values(*object.result, name, object.scene.convention);
      if (!computed) {
        throw_unknown("field", name);
      }
      object.field.emplace(name, std::move(*computed));
    }
    const std::vector<double>& field = object.field->second;
    return wrc::copy_values(field.data(), field.size(), values, capacity, count, object.error);
  });
}

int64_t wrc_scene_number_count(const wrc_scene* scene) {
  return wrc::look_at<int64_t>(
      scene, 0, [](wrc::SceneObject& object) { return number_names_of(object).size(); });
}

const char* wrc_scene_number_name(const wrc_scene* scene, int64_t index) {
  return wrc::look_at<const char*>(scene, nullptr, [index](wrc::SceneObject& object) {
    return text_at(number_names_of(object), index,
                   [](const std::string& name) -> const std::string& { return name; });
  });
}

int64_t wrc_scene_text_count(const wrc_scene* scene) {
  return wrc::look_at<int64_t>(scene, 0,
                               [](wrc::SceneObject& object) { return texts_of(object).size(); });
}

const char* wrc_scene_text_name(const wrc_scene* scene, int64_t index) {
  return wrc::look_at<const char*>(scene, nullptr, [index](wrc::SceneObject& object) {
    return text_at(texts_of(object), index,
                   [](const auto& text) -> const std::string& { return text.first; });
  });
}
}
