#include "reports/warning_summary.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>
#include <utility>

namespace driver {
namespace {

/// What a line begins with, by its grade.
constexpr std::array grade_leads{"Note: ", "A little over: ", "Do not use: "};

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

std::vector<std::string> lines_of(const std::vector<Warning>& warnings) {
  const bool quiet = grade_of(warnings) == WRC_SLIGHTLY_OVER;
  bool is_told = false;
  std::vector<std::string> lines;
  for (const Warning& warning : warnings) {
    const bool is_over = warning.grade == WRC_SLIGHTLY_OVER;
    if (!(quiet && is_over && is_told)) {
      lines.push_back(grade_leads.at(static_cast<std::size_t>(warning.grade)) +
                      one_line(warning.text));
    }
    is_told = is_told || is_over;
  }
  return lines;
}

void WarningSummary::add(std::int64_t scene, const std::vector<Warning>& warnings) {
  std::set<std::pair<std::int32_t, std::string>> found;
  for (const Warning& warning : warnings) {
    std::string name = without_numbers(warning.text);
    if (!found.emplace(warning.grade, name).second) {
      continue;
    }
    Kind& kind = kinds_[static_cast<std::size_t>(warning.grade)][std::move(name)];
    if (kind.scenes++ == 0 || scene < kind.first) {
      kind.first = scene;
      kind.text = warning.text;
    }
  }
  scenes_[static_cast<std::size_t>(grade_of(warnings))] += warnings.empty() ? 0 : 1;
}

std::string WarningSummary::brief(std::int64_t all, const std::string& marks) const {
  const std::string of_all = " of " + std::to_string(all) + (all == 1 ? " scene" : " scenes");
  std::string text;
  const auto add = [&](std::int64_t count, const std::string& what) {
    if (count > 0) {
      text +=
          (text.empty() ? "" : "; ") + std::to_string(count) + (text.empty() ? of_all : "") + what;
    }
  };
  add(scenes(WRC_DO_NOT_USE), ": do not use" + (marks.empty() ? "" : ", shown " + marks));
  add(scenes(WRC_SLIGHTLY_OVER), " a little over the accuracy");
  add(scenes(WRC_FINE), " with notes");
  return text;
}

std::vector<std::string> WarningSummary::lines(std::int32_t grade) const {
  std::vector<const Kind*> kinds;
  for (const auto& [name, kind] : kinds_[static_cast<std::size_t>(grade)]) {
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
  const std::string counts = brief(all);
  if (counts.empty()) {
    return "";
  }
  std::string text =
      program + ": " + counts + (where.empty() ? "" : ". All warnings are in " + where) + '\n';
  for (const std::int32_t grade : {WRC_DO_NOT_USE, WRC_SLIGHTLY_OVER, WRC_FINE}) {
    const std::vector<std::string> kinds = lines(grade);
    const std::size_t shown =
        std::min(kinds.size(), grade == WRC_SLIGHTLY_OVER ? std::size_t{1} : most_kinds);
    for (std::size_t i = 0; i < shown; ++i) {
      text += "  " + std::string(grade_leads.at(static_cast<std::size_t>(grade))) + kinds[i] + '\n';
    }
    if (kinds.size() > most_kinds && shown == most_kinds) {
      text += "  and " + std::to_string(kinds.size() - most_kinds) + " more kinds\n";
    }
  }
  return text;
}

} // namespace driver
