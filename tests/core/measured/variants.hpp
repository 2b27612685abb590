/// Files of two known profiles as people have them: in other units, columns, orders, signs,
/// separators and encodings, with faults; each with what a reader has to make of it.
#pragma once

#include <string>
#include <vector>

#include "measured/readers.hpp"

namespace wrc {

/// What is known of a file, and what must come out.
struct Variant {
  std::string name; ///< with the extension of the file
  std::string bytes;
  ProfileKind kind = ProfileKind::wheel; ///< S1002 or 60E1
  ReadOptions options{};
  /// Largest distance of the points read from the standard, and of their extent, mm; 0: the file
  /// cannot be read right, and one of the texts must say so.
  double tolerance = 1e-6;
  std::vector<std::string> corrections{}; ///< parts of lines that must be there
  std::vector<std::string> warnings{};
  std::string refusal{}; ///< part of the error's text; empty: it must be accepted
  bool is_plain = false; ///< strict reading accepts it
};

/// Points of the standard, 0.5 mm apart: flange or gauge side first, height up.
std::vector<Position> standard_points(ProfileKind kind);

/// All files; their texts depend on nothing but the built-in profiles and a fixed seed.
std::vector<Variant> all_variants();

} // namespace wrc
