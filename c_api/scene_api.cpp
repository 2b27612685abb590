#include <utility>

#include "base/nearest_names.hpp"
#include "handles.hpp"
#include "keys/scene_file.hpp"
#include "keys/scene_keys.hpp"
#include "scene/number_ids.hpp"

wrc_status wrc::SceneObject::take_result(wrc::SceneResult&& new_result) {
  bool converged = true;
  for (const auto* side : {&new_result.left, &new_result.right}) {
    converged = converged && (!*side || (*side)->stop_reason == wrc::StopReason::tolerance_met);
  }
  std::string text = converged ? "" : "not converged: see left.stop_reason and right.stop_reason";
  if (converged && new_result.pitch_is_saturated) {
    converged = false;
    text = "motion.torque: more than friction can transmit; the wheels slide";
  }
  // From here on nothing fails: the handle has the old results or all of the new ones.
  result = std::move(new_result);
  number_names.clear();
  texts.clear();
  warnings.reset();
  field.reset();
  error.swap(text);
  return converged ? WRC_OK : WRC_NOT_CONVERGED;
}

namespace {

/// The value of a key that has one of a type. Throws Error(unknown_name, invalid_argument).
template <class Type>
Type value_of_type(const wrc::Scene& scene, const char* key, const char* type) {
  wrc::KeyValue value = wrc::key_value(scene, key);
  if (Type* found = std::get_if<Type>(&value)) {
    return std::move(*found);
  }
  throw wrc::Error(wrc::ErrorCode::invalid_argument,
                   std::string(key) + (std::holds_alternative<std::monostate>(value)
                                           ? ": has no single value, since its parts differ; read "
                                             "the key of each wheel, side or body"
                                           : std::string(": its value is not a ") + type));
}

constexpr const char* known_but_absent = ": the name is known, but this solution has no such ";

/// The text of an error about the name of a field.
std::string unknown_field(wrc::SceneObject& scene, const std::string& name) {
  if (wrc::number_value(*scene.result, name)) {
    return '"' + name + "\" is a number, not a field";
  }
  return scene.error +
         (wrc::names_field(name)
              ? std::string(known_but_absent) + "field"
              : "; nearest: " + wrc::nearest_names(name, wrc::possible_field_names()));
}

/// The text of an error about the name of a number or text.
std::string unknown_result(wrc::SceneObject& scene, const std::string& name) {
  if (scene.result && wrc::number_value(*scene.result, name)) {
    return '"' + name + "\" is a number, not a text";
  }
  if (wrc::number_id(name)) {
    return scene.error + known_but_absent + "number";
  }
  if (auto removed = wrc::removed_number(name)) {
    return *std::move(removed);
  }
  std::vector<std::string> names = wrc::possible_number_names();
  if (scene.result) {
    for (auto& [text, value] : wrc::text_values(*scene.result)) {
      if (text == name) {
        return '"' + name + "\" is a text, not a number";
      }
      names.push_back(text);
    }
  }
  if (wrc::names_field(name)) {
    return '"' + name + "\" names a field, not a number or a text";
  }
  for (const std::string& field : wrc::possible_field_names()) {
    if (!wrc::number_id(field)) {
      names.push_back(field); // Python reads all by one function
    }
  }
  return scene.error + "; nearest: " + wrc::nearest_names(name, names);
}

/// Completes the text of an error that is about the name of a result.
void complete_error(wrc::SceneObject& scene) {
  const std::optional<std::string> name = std::exchange(scene.unknown_result, std::nullopt);
  if (!name) {
    return;
  }
  if (scene.error == "no field is named \"" + *name + '"') {
    scene.error = unknown_field(scene, *name);
  } else if (scene.error == "no result is named \"" + *name + '"') {
    scene.error = unknown_result(scene, *name);
  }
}

} // namespace

extern "C" {

wrc_status wrc_scene_create_0_4(wrc_scene** scene) {
  return wrc::create(scene);
}

void wrc_scene_destroy(wrc_scene* scene) {
  wrc::destroy(scene);
}

const char* wrc_scene_error(const wrc_scene* scene) {
  wrc::look_at<bool>(scene, false, [](wrc::SceneObject& object) {
    complete_error(object);
    return true;
  });
  return wrc::error_of(scene);
}

wrc_status wrc_scene_set_number(wrc_scene* scene, const char* key, double value) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    wrc::set_number(object.scene, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_scene_set_text(wrc_scene* scene, const char* key, const char* value) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    const wrc::Convention before = object.scene.convention;
    wrc::set_text(object.scene, key, value);
    if (object.scene.convention != before) { // present results are returned in the new one
      object.texts.clear();
      object.field.reset();
    }
    return WRC_OK;
  });
}

wrc_status wrc_scene_set_numbers(wrc_scene* scene, const char* key, const double* values,
                                 int64_t count) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    if (count < 0) {
      wrc::throw_invalid_argument("count", static_cast<double>(count), "0 or more");
    }
    if (count > 0) {
      wrc::require_pointer(values, "values");
    }
    wrc::set_numbers(object.scene, key, {values, static_cast<std::size_t>(count)});
    return WRC_OK;
  });
}

wrc_status wrc_scene_key_id(wrc_scene* scene, const char* key, int32_t* id) {
  return wrc::guard(scene, [&](wrc::SceneObject&) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(id, "id");
    *id = wrc::key_id(key);
    return WRC_OK;
  });
}

wrc_status wrc_scene_set_numbers_by_id(wrc_scene* scene, const int32_t* ids, const double* values,
                                       int64_t count) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_list(ids, "ids", count);
    wrc::require_list(values, "values", count);
    const auto length = static_cast<std::size_t>(count);
    wrc::set_numbers_by_id(object.scene, {ids, length}, {values, length});
    return WRC_OK;
  });
}

wrc_status wrc_scene_set_profile(wrc_scene* scene, const char* key, wrc_profile* profile) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(profile, "profile");
    const auto given = wrc::use(profile);
    if (!given.held()) {
      object.error = std::string("profile: ") + wrc::reason_of(given);
      return given.exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
    if (!given.object().profile) {
      object.error = "no profile has been loaded into the handle";
      return WRC_NO_RESULT;
    }
    wrc::set_profile(object.scene, key, *given.object().profile);
    return WRC_OK;
  });
}

wrc_status wrc_scene_get_number(wrc_scene* scene, const char* key, double* value) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    *value = value_of_type<double>(object.scene, key, "number");
    return WRC_OK;
  });
}

wrc_status wrc_scene_get_text(wrc_scene* scene, const char* key, const char** value) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    object.input_text = value_of_type<std::string>(object.scene, key, "text");
    *value = object.input_text.c_str();
    return WRC_OK;
  });
}

wrc_status wrc_scene_get_numbers(wrc_scene* scene, const char* key, double* values,
                                 int64_t capacity, int64_t* count) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(key, "key");
    const auto list = value_of_type<std::vector<double>>(object.scene, key, "list of numbers");
    return wrc::copy_values(list.data(), list.size(), values, capacity, count, object.error);
  });
}

wrc_status wrc_scene_write(wrc_scene* scene, const char* path) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    wrc::require_pointer(path, "path");
    wrc::write_scene(object.scene, path);
    return WRC_OK;
  });
}

int64_t wrc_scene_key_count(void) {
  try {
    return static_cast<int64_t>(wrc::scene_keys().size());
  } catch (...) { // no memory for the table
    return 0;
  }
}

wrc_status wrc_scene_key(int64_t index, const char** name, const char** default_value,
                         const char** allowed, const char** meaning) {
  if (index < 0 || index >= wrc_scene_key_count() || name == nullptr || default_value == nullptr ||
      allowed == nullptr || meaning == nullptr) {
    return WRC_INVALID_ARGUMENT;
  }
  // The table is made of string literals, so each view ends with a zero byte.
  const wrc::KeyDescription& key = wrc::scene_keys()[static_cast<std::size_t>(index)];
  *name = key.name.data();
  *default_value = key.default_value.data();
  *allowed = key.allowed.data();
  *meaning = key.meaning.data();
  return WRC_OK;
}

wrc_status wrc_scene_solve(wrc_scene* scene) {
  return wrc::guard(scene, [&](wrc::SceneObject& object) {
    if (!object.surfaces) {
      object.surfaces = std::make_shared<wrc::SurfaceCache>(wrc::SurfaceCache::For::one_scene);
    }
    return object.take_result(wrc::SceneSolver(object.surfaces).solve(object.scene));
  });
}
}
