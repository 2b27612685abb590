#include "handles.hpp"
#include "scene/scene_keys.hpp"

wrc_status wrc_scene::take_result(wrc::SceneResult&& new_result) {
  bool converged = true;
  for (const auto* side : {&new_result.left, &new_result.right}) {
    converged = converged && (!*side || (*side)->stop_reason == wrc::StopReason::tolerance_met);
  }
  std::string text = converged ? "" : "not converged: see left.stop_reason and right.stop_reason";
  // From here on nothing fails: the handle has the old results or all of the new ones.
  result = std::move(new_result);
  number_names.clear();
  texts.clear();
  field.reset();
  error.swap(text);
  return converged ? WRC_OK : WRC_NOT_CONVERGED;
}

extern "C" {

wrc_status wrc_scene_create(wrc_scene** scene) {
  return wrc::create(scene);
}

void wrc_scene_destroy(wrc_scene* scene) {
  delete scene;
}

const char* wrc_scene_error(const wrc_scene* scene) {
  return scene == nullptr ? "scene = NULL: a handle must be given" : scene->error.c_str();
}

wrc_status wrc_scene_set_number(wrc_scene* scene, const char* key, double value) {
  return wrc::guard(scene, [&] {
    wrc::require_pointer(key, "key");
    wrc::set_number(scene->scene, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_scene_set_text(wrc_scene* scene, const char* key, const char* value) {
  return wrc::guard(scene, [&] {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    wrc::set_text(scene->scene, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_scene_set_numbers(wrc_scene* scene, const char* key, const double* values,
                                 int64_t count) {
  return wrc::guard(scene, [&] {
    wrc::require_pointer(key, "key");
    if (count < 0) {
      wrc::throw_invalid_argument("count", static_cast<double>(count), "0 or more");
    }
    if (count > 0) {
      wrc::require_pointer(values, "values");
    }
    wrc::set_numbers(scene->scene, key, {values, static_cast<std::size_t>(count)});
    return WRC_OK;
  });
}

int64_t wrc_scene_key_count(void) {
  return static_cast<int64_t>(wrc::scene_keys().size());
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
  return wrc::guard(scene, [&] { return scene->take_result(wrc::solve_scene(scene->scene)); });
}
}
