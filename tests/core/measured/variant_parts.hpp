/// What the files of variants.hpp have in common.
#pragma once

#include <string>
#include <vector>

#include "variant_texts.hpp"
#include "variants.hpp"

namespace wrc {

void add_faults(std::vector<Variant>& all);
void add_whole_rails(std::vector<Variant>& all);

namespace variant_parts {

inline constexpr ProfileKind kinds[] = {ProfileKind::wheel, ProfileKind::rail};
/// Distance of a taping line from the flange back.
inline constexpr double tape = 70.0;

inline std::string prefix(ProfileKind kind) {
  return kind == ProfileKind::wheel ? "S1002_" : "60E1_";
}

inline ReadOptions options_of(ProfileKind kind) {
  ReadOptions options;
  options.kind = kind;
  return options;
}

inline Variant columns(ProfileKind kind, const std::string& name, const std::string& bytes) {
  Variant variant;
  variant.name = prefix(kind) + name + ".txt";
  variant.bytes = bytes;
  variant.kind = kind;
  variant.options = options_of(kind);
  return variant;
}

} // namespace variant_parts
} // namespace wrc
