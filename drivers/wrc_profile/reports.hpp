/// What wrc_profile prints of a profile.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "reports/profile_measures.hpp"

namespace driver {

/// A file that was written, and what a reader gets back from it.
struct Conversion {
  std::string path;
  double spacing = 0.0;
  Comparison difference; ///< between the file read back and the profile
};

/// Everything there is to report; what was not requested is absent.
struct ProfileReport {
  Profile profile;
  Measures measures;
  std::optional<std::string> other_name;
  std::optional<Comparison> comparison;
  std::optional<Conversion> conversion;
  std::vector<ProfilePoint> points;
  std::vector<double> distances;  ///< from these points to the other profile, NaN beyond its ends
  std::optional<Scene> contact{}; ///< solved with a built-in mate; of a profile of points
};

/// A table for people.
void print_table(const ProfileReport& report, std::ostream& out);
/// One object; absent quantities are null.
void print_json(const ProfileReport& report, std::ostream& out);
/// The built-in profiles, a line or an object each.
void print_list(bool as_json, std::ostream& out);

/// What the slices of a file make, in lines or as an object.
void print_surface(const Profile& profile, bool as_json, std::ostream& out);
/// Draws the sheets of a surface in space, to a .png or .svg file.
void draw_surface(const Profile& profile, std::int64_t sheets, const std::string& name,
                  bool is_wheel, const std::filesystem::path& path);

} // namespace driver
