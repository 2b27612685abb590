#include "outcome.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace properties {

Outcome::Outcome(const wrcontact::Scene& scene, wrc_status status_, bool with_fields)
    : status(status_), error(wrc_scene_error(scene.handle())) {
  if (!has_results()) {
    return;
  }
  constexpr std::string_view told_of_all = ".pmax_element";
  for (const std::string& name : scene.number_names()) {
    if (name.starts_with("time_ms.") || name.find("sensitivities") != std::string::npos) {
      continue;
    }
    numbers.emplace(name, scene.number(name));
    if (with_fields && name.find(".patches.") != std::string::npos && name.ends_with(told_of_all)) {
      const std::string patch = name.substr(0, name.size() - told_of_all.size());
      pressures[patch] = scene.field(patch + ".pressure");
    }
  }
  for (const std::string& name : scene.text_names()) {
    texts.emplace(name, scene.text(name));
  }
}

std::vector<std::string> Outcome::sides() const {
  std::vector<std::string> sides;
  for (const char* side : {"left", "right"}) {
    if (has(std::string(side) + ".pmax")) {
      sides.emplace_back(side);
    }
  }
  return sides;
}

bool Outcome::warns(const std::string& side, const std::string& words) const {
  return std::any_of(texts.begin(), texts.end(), [&](const auto& text) {
    return text.first.starts_with(side + ".warnings.") &&
           text.second.find(words) != std::string::npos;
  });
}

bool Outcome::is_told_inaccurate(const std::string& side) const {
  return warns(side, "not reached") || warns(side, "does not settle") ||
         warns(side, "pressures have no bound");
}

std::string Outcome::difference_to(const Outcome& other) const {
  if (status != other.status) {
    return "status";
  }
  for (const auto& [name, value] : numbers) {
    const auto found = other.numbers.find(name);
    if (found == other.numbers.end() ||
        std::bit_cast<std::uint64_t>(found->second) != std::bit_cast<std::uint64_t>(value)) {
      return name;
    }
  }
  return numbers.size() == other.numbers.size() ? "" : "a result that only the other has";
}

} // namespace properties
