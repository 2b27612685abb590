#include "outcome.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace properties {

Outcome::Outcome(wrc_scene* scene, wrc_status status_, bool with_fields)
    : status(status_), error(wrc_scene_error(scene)) {
  if (!has_results()) {
    return;
  }
  for (std::int64_t i = 0; i < wrc_scene_number_count(scene); ++i) {
    const std::string name = wrc_scene_number_name(scene, i);
    double value = 0.0;
    if (!name.starts_with("time_ms.") && name.find("sensitivities") == std::string::npos &&
        wrc_scene_number(scene, name.c_str(), &value) == WRC_OK) {
      numbers.emplace(name, value);
    }
  }
  for (std::int64_t i = 0; i < wrc_scene_text_count(scene); ++i) {
    const std::string name = wrc_scene_text_name(scene, i);
    const char* value = nullptr;
    if (wrc_scene_text(scene, name.c_str(), &value) == WRC_OK) {
      texts.emplace(name, value);
    }
  }
  constexpr std::string_view told_of_all = ".pmax_element";
  for (auto number = numbers.begin(); with_fields && number != numbers.end(); ++number) {
    const std::string& name = number->first;
    if (name.find(".patches.") == std::string::npos || !name.ends_with(told_of_all)) {
      continue;
    }
    const std::string patch = name.substr(0, name.size() - told_of_all.size());
    std::int64_t count = 0;
    wrc_scene_field(scene, (patch + ".pressure").c_str(), nullptr, 0, &count);
    std::vector<double>& field = pressures[patch];
    field.resize(static_cast<std::size_t>(count));
    wrc_scene_field(scene, (patch + ".pressure").c_str(), field.data(), count, &count);
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
  return warns(side, "not reached") || warns(side, "does not settle");
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
