#include <algorithm>

#include "handles.hpp"

namespace {

/// Names of the numbers at hand; none without a result.
const std::vector<std::string>& number_names_of(const wrc_scene* scene) {
  static const std::vector<std::string> none;
  if (scene == nullptr || !scene->result) {
    return none;
  }
  if (scene->number_names.empty()) {
    scene->number_names = wrc::number_names(*scene->result);
  }
  return scene->number_names;
}

/// Texts by name; none without a result.
const std::vector<std::pair<std::string, std::string>>& texts_of(const wrc_scene* scene) {
  static const std::vector<std::pair<std::string, std::string>> none;
  if (scene == nullptr || !scene->result) {
    return none;
  }
  if (scene->texts.empty()) {
    scene->texts = wrc::text_values(*scene->result);
  }
  return scene->texts;
}

/// A count, or 0 if there is no memory to find it.
template <class Count> int64_t counted(Count&& count) noexcept {
  try {
    return static_cast<int64_t>(count());
  } catch (...) {
    return 0;
  }
}

[[noreturn]] void throw_unknown(const char* what, const char* name) {
  throw wrc::Error(wrc::ErrorCode::unknown_name,
                   "no " + std::string(what) + " is named \"" + name + '"');
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
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const auto found = wrc::number_value(*scene->result, name);
    if (!found) {
      throw_unknown("result", name);
    }
    *value = *found;
    return WRC_OK;
  });
}

wrc_status wrc_scene_text(wrc_scene* scene, const char* name, const char** value) {
  return with_result(scene, [&] {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const auto& texts = texts_of(scene);
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
  return with_result(scene, [&] {
    wrc::require_pointer(name, "name");
    if (!scene->field || scene->field->first != name) {
      auto computed = wrc::field_values(*scene->result, name);
      if (!computed) {
        throw_unknown("field", name);
      }
      scene->field.emplace(name, std::move(*computed));
    }
    const std::vector<double>& field = scene->field->second;
    return wrc::copy_values(field.data(), field.size(), values, capacity, count, scene->error);
  });
}

int64_t wrc_scene_number_count(const wrc_scene* scene) {
  return counted([&] { return number_names_of(scene).size(); });
}

const char* wrc_scene_number_name(const wrc_scene* scene, int64_t index) {
  return index >= 0 && index < wrc_scene_number_count(scene)
             ? scene->number_names[static_cast<std::size_t>(index)].c_str()
             : nullptr;
}

int64_t wrc_scene_text_count(const wrc_scene* scene) {
  return counted([&] { return texts_of(scene).size(); });
}

const char* wrc_scene_text_name(const wrc_scene* scene, int64_t index) {
  return index >= 0 && index < wrc_scene_text_count(scene)
             ? scene->texts[static_cast<std::size_t>(index)].first.c_str()
             : nullptr;
}
}
