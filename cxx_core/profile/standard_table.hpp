/// The built-in profiles as constant tables, generated at build time from the files in profiles/.
///
/// Units mm. Frame of curve.hpp; rails are complete (both halves). Internal to the profile folder
/// and to the generator. Thread rule: constant data.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "profile/profile.hpp"

namespace wrc {

struct TableSegment {
  enum class Type { line, arc, polynomial };
  static constexpr std::size_t max_coefficients = 12;

  std::string_view label;
  Type type;
  std::array<double, 2> start; ///< a polynomial uses the lateral coordinates only
  std::array<double, 2> end;
  std::array<double, 2> centre;
  double radius;
  double expansion_point;
  std::size_t coefficient_count;
  std::array<double, max_coefficients> coefficients;
};

struct TableProfile {
  std::string_view name;
  ProfileKind kind;
  std::string_view title;
  std::string_view source;
  std::string_view confidence;
  std::span<const TableSegment> segments;
};

/// All built-in profiles, in the order in which they are listed for users.
std::span<const TableProfile> standard_table();

} // namespace wrc
