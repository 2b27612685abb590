#include "reports/warning_summary.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

#include "support/scene.hpp"

namespace driver {
namespace {

/// Kinds that are printed.
constexpr std::size_t most_kinds = 20;

bool is_number(std::string_view word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return !word.empty() && error == std::errc() && end == word.data() + word.size();
}

/// The text with # for each word that is a number.
std::string without_numbers(std::string_view text) {
  constexpr std::string_view around = " (),;:";
  std::string kept;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of(around), text.size());
    kept += is_number(text.substr(0, length)) ? "#" : text.substr(0, length);
    text.remove_prefix(length);
    if (!text.empty()) {
      kept += text.front();
      text.remove_prefix(1);
    }
  }
  return kept;
}

} // namespace

unsigned warnings_of(const std::vector<std::string>& warnings) {
  unsigned of = 0;
  for (const std::string& warning : warnings) {
    of |= warning.starts_with("left: ")    ? of_left_wheel
          : warning.starts_with("right: ") ? of_right_wheel
                                           : of_profiles;
  }
  return of;
}

unsigned warnings_that_concern(const std::string& result) {
  constexpr unsigned all = of_profiles | of_left_wheel | of_right_wheel;
  return result.starts_with("left.")    ? all & ~of_right_wheel
         : result.starts_with("right.") ? all & ~of_left_wheel
                                        : all;
}

void WarningSummary::add(std::int64_t scene, const std::vector<std::string>& warnings) {
  std::set<std::string> found;
  for (const std::string& warning : warnings) {
    std::string name = without_numbers(warning);
    if (!found.insert(name).second) {
      continue;
    }
    Kind& kind = kinds_[std::move(name)];
    if (kind.scenes++ == 0 || scene < kind.first) {
      kind.first = scene;
      kind.text = warning;
    }
  }
  scenes_ += warnings.empty() ? 0 : 1;
}

std::vector<std::string> WarningSummary::lines() const {
  std::vector<const Kind*> kinds;
  for (const auto& [name, kind] : kinds_) {
    kinds.push_back(&kind);
  }
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const Kind* one, const Kind* other) { return one->scenes > other->scenes; });
  std::vector<std::string> lines;
  for (const Kind* kind : kinds) {
    lines.push_back(std::to_string(kind->scenes) + (kind->scenes == 1 ? " scene: " : " scenes: ") +
                    one_line(kind->text));
  }
  return lines;
}

std::string WarningSummary::text(const std::string& program, std::int64_t all,
                                 const std::string& where) const {
  if (scenes_ == 0) {
    return "";
  }
  std::string text = program + ": " + std::to_string(scenes_) + " of " + std::to_string(all) +
                     (all == 1       ? " scene has"
                      : scenes_ == 1 ? " scenes has"
                                     : " scenes have") +
                     " warnings. All of them are in " + where + "; the first of each kind:\n";
  const std::vector<std::string> kinds = lines();
  for (std::size_t i = 0; i < std::min(kinds.size(), most_kinds); ++i) {
    text += "  " + kinds[i] + '\n';
  }
  if (kinds.size() > most_kinds) {
    text += "  and " + std::to_string(kinds.size() - most_kinds) + " more kinds\n";
  }
  return text;
}

} // namespace driver
