/// What wrc_profile prints of a profile.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "wrc_profile/measures.hpp"

namespace driver {

/// A file that was written, and what a reader gets back from it.
struct Conversion {
  std::string path;
  double spacing = 0.0;
  Comparison difference; ///< of what was read back to the profile
};

/// Everything there is to report; what was not asked for is absent.
struct ProfileReport {
  Profile profile;
  Measures measures;
  std::optional<std::string> other_name;
  std::optional<Comparison> comparison;
  std::optional<Conversion> conversion;
  std::vector<ProfilePoint> points;
};

/// A table for people.
void print_table(const ProfileReport& report, std::ostream& out);
/// One JSON object, 17 digits; absent quantities are null.
void print_json(const ProfileReport& report, std::ostream& out);
/// The built-in profiles, a line or an object each.
void print_list(bool json, std::ostream& out);

} // namespace driver
