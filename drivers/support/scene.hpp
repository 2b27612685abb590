/// Scenes and profiles as the drivers have them: those of wrcontact.hpp, and what the command line
/// asks of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "wrcontact.hpp"

namespace driver {

using wrcontact::NormalContact;
using wrcontact::Profile;
using wrcontact::Scene;
using wrcontact::Solver;

/// What a file or a user quotes may hold line ends and other control characters: they become
/// blanks.
inline std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](unsigned char letter) { return letter < 0x20 || letter == 0x7F; }, ' ');
  return text;
}

/// A failure that ends the program with one line on stderr.
class Failure : public std::runtime_error {
public:
  explicit Failure(const std::string& text) : std::runtime_error(one_line(text)) {}
};

inline constexpr std::array side_names{"left", "right"};

/// The texts of a list of results, for example of "left.warnings".
inline std::vector<std::string> texts_of(const Scene& scene, const std::string& list) {
  std::vector<std::string> texts;
  const int count = scene.count_of(list);
  for (int i = 0; i < count; ++i) {
    texts.push_back(scene.text(list + '.' + std::to_string(i)));
  }
  return texts;
}

/// A warning and its grade: WRC_FINE, WRC_SLIGHTLY_OVER or WRC_DO_NOT_USE.
struct Warning {
  std::string text;
  std::int32_t grade = WRC_FINE;
};

/// Names of the grades in the results warning_grades.N.
inline constexpr std::array grade_names{"fine", "a little over", "do not use"};

/// All warnings of a solved scene.
inline std::vector<Warning> warnings_of(const Scene& scene) {
  std::vector<Warning> warnings;
  const std::vector<std::string> grades = texts_of(scene, "warning_grades");
  for (const std::string& text : scene.warnings()) {
    const auto* const name =
        std::find(grade_names.begin(), grade_names.end(), grades[warnings.size()]);
    warnings.push_back({text, static_cast<std::int32_t>(name - grade_names.begin())});
  }
  return warnings;
}

/// Whether a warning is of the other wheel than `side`, which is empty for the whole scene.
inline bool is_of_other_wheel(const Warning& warning, const std::string& side) {
  return (side == "left" && warning.text.starts_with("right: ")) ||
         (side == "right" && warning.text.starts_with("left: "));
}

/// The worst grade of those that concern a side, or all.
inline std::int32_t grade_of(const std::vector<Warning>& warnings, const std::string& side = "") {
  std::int32_t worst = WRC_FINE;
  for (const Warning& warning : warnings) {
    worst = is_of_other_wheel(warning, side) ? worst : std::max(worst, warning.grade);
  }
  return worst;
}

/// Warnings in one cell of a table.
inline std::string joined_warnings(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) {
    text += (text.empty() ? "" : " | ") + warning.text;
  }
  return text;
}

/// Those sides that were solved.
inline std::vector<std::string> sides_of(const Scene& scene) {
  std::vector<std::string> sides(side_names.begin(), side_names.end());
  std::erase_if(sides,
                [&scene](const std::string& side) { return !scene.has_number(side + ".pmax"); });
  return sides;
}

/// Whether a profile of this name is built in; in another spelling a file of that name comes first.
inline bool is_standard(const std::string& name) {
  const Profile profile;
  return wrc_profile_load_standard(profile.handle(), name.c_str()) == WRC_OK;
}

/// "Built-in wheels: ...\nBuilt-in rails: ...\n".
inline std::string standard_names_text() {
  std::string text;
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    text += kind == WRC_WHEEL ? "Built-in wheels:" : "\nBuilt-in rails: ";
    for (const std::string& name : wrcontact::standard_profile_names(kind)) {
      text += ' ' + name;
    }
  }
  return text + '\n';
}

/// Makes the folder of an option, unless it is there.
inline void make_folder(const std::string& option, const std::string& path) {
  std::error_code trouble;
  std::filesystem::create_directories(path, trouble);
  if (trouble) {
    throw Failure(option + ' ' + path + ": " + trouble.message());
  }
}

} // namespace driver
