#include <algorithm>

#include "handles.hpp"
#include "keys/scene_keys.hpp"

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

[[noreturn]] void throw_unknown_result(wrc::SceneObject& scene, const char* name) {
  scene.unknown_result = name;
  throw_unknown("result", name);
}

/// The number with the id ids[place]; not-a-number if the scene has none.
double number_by_id(wrc::SceneObject& scene, const int32_t* ids, std::size_t place) {
  const auto id = wrc::unpack(ids[place]);
  if (!id) {
    wrc::throw_invalid_argument("ids[" + std::to_string(place) + ']', ids[place],
                                "must be an id of wrc_scene_number_id");
  }
  return wrc::number_value(*scene.result, *id, scene.scene.convention);
}

} // namespace

extern "C" {

wrc_status wrc_scene_number(wrc_scene* scene, const char* name, double* value) {
  return wrc::with_result(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const auto found = wrc::number_value(*object.result, name, object.scene.convention);
    if (!found) {
      throw_unknown_result(object, name);
    }
    *value = *found;
    return WRC_OK;
  });
}

wrc_status wrc_scene_number_id(wrc_scene* scene, const char* name, int32_t* id) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(id, "id");
    const auto found = wrc::number_id(name);
    if (!found) {
      throw_unknown_result(object, name);
    }
    const auto packed = wrc::pack(*found);
    if (!packed) {
      wrc::throw_invalid_argument("name", name,
                                  "indices in it are allowed up to " +
                                      std::to_string(wrc::max_packed_index) + ", of parts " +
                                      std::to_string(wrc::max_packed_part));
    }
    *id = *packed;
    return WRC_OK;
  });
}

wrc_status wrc_scene_number_unit(wrc_scene* scene, const char* name, const char** unit) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(unit, "unit");
    const auto found = wrc::number_id(name);
    if (!found) {
      throw_unknown_result(object, name);
    }
    object.unit = wrc::number_unit(*found, object.scene.convention.units);
    *unit = object.unit.c_str();
    return WRC_OK;
  });
}

wrc_status wrc_scene_key_unit(wrc_scene* scene, const char* key, const char** unit) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(unit, "unit");
    object.unit = wrc::key_unit(key, object.scene.convention.units);
    *unit = object.unit.c_str();
    return WRC_OK;
  });
}

wrc_status wrc_scene_numbers_by_id(wrc_scene* scene, const int32_t* ids, double* values,
                                   int64_t count) {
  return wrc::with_result(scene, [&](wrc::SceneObject& object) {
    wrc::require_list(ids, "ids", count);
    wrc::require_list(values, "values", count);
    std::vector<double>& numbers = object.numbers; // apart, since computing one may fail
    numbers.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = number_by_id(object, ids, i);
    }
    std::copy(numbers.begin(), numbers.end(), values);
    return WRC_OK;
  });
}

wrc_status wrc_scene_text(wrc_scene* scene, const char* name, const char** value) {
  return wrc::with_result(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const auto& texts = texts_of(object);
    const auto found = std::find_if(texts.begin(), texts.end(),
                                    [name](const auto& entry) { return entry.first == name; });
    if (found == texts.end()) {
      throw_unknown_result(object, name);
    }
    *value = found->second.c_str();
    return WRC_OK;
  });
}

wrc_status wrc_scene_field(wrc_scene* scene, const char* name, double* values, int64_t capacity,
                           int64_t* count) {
  return wrc::with_result(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(name, "name");
    if (!object.field || object.field->first != name) {
      auto computed = wrc::field_values(*object.result, name, object.scene.convention);
      if (!computed) {
        object.unknown_result = name;
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

const char* wrc_result_name(int64_t index) {
  try {
    static const std::vector<std::string> names = wrc::possible_number_names();
    return text_at(names, index,
                   [](const std::string& name) -> const std::string& { return name; });
  } catch (...) { // no memory for the table
    return nullptr;
  }
}

const char* wrc_scene_warning(const wrc_scene* scene, int64_t index) {
  return wrc::look_at<const char*>(scene, nullptr, [index](wrc::SceneObject& object) {
    if (!object.warnings && object.result) {
      object.warnings = wrc::all_warnings(*object.result);
    }
    return object.warnings ? text_at(*object.warnings, index,
                                     [](const wrc::Warning& warning) -> const std::string& {
                                       return warning.text;
                                     })
                           : nullptr;
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
