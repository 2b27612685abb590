#include "scene/scene_warnings.hpp"

#include <string>

namespace wrc {
namespace {

void append(const std::optional<SceneWheel>& wheel, const std::string& side, Warnings& all) {
  if (wheel) {
    for (const Warning& warning : wheel->warnings) {
      all.push_back({warning.kind, side + ": " + warning.text, warning.excess});
    }
  }
}

} // namespace

std::size_t warning_count(const SceneResult& result) {
  return result.key_warnings.count() + result.profile_warnings.count() +
         (result.left ? result.left->warnings.size() : 0) +
         (result.right ? result.right->warnings.size() : 0);
}

Warnings all_warnings(const SceneResult& result) {
  Warnings all;
  result.key_warnings.append_to(all);
  result.profile_warnings.append_to(all);
  append(result.left, "left", all);
  append(result.right, "right", all);
  return all;
}

} // namespace wrc
