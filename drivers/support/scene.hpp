/// Scenes and profiles as the drivers have them: those of wrcontact.hpp, and what the command line
/// asks of them.
#pragma once

#include <algorithm>
#include <array>
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

/// Warnings of the keys and profiles a scene was solved with; those of the wheels follow.
inline std::vector<std::string> warnings_of_profiles(const Scene& scene) {
  std::vector<std::string> warnings = scene.warnings();
  for (const char* side : side_names) {
    warnings.resize(warnings.size() - static_cast<std::size_t>(scene.number_or(
                                          std::string(side) + ".warning_count", 0.0)));
  }
  return warnings;
}

/// Warnings in one cell of a table.
inline std::string joined_warnings(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) {
    text += (text.empty() ? "" : " | ") + warning;
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

/// Whether a profile of this name is built in.
inline bool is_standard(const std::string& name) {
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    const auto names = wrcontact::standard_profile_names(kind);
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      return true;
    }
  }
  return false;
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
