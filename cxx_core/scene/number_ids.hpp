/// Numbers of a result by id: a name is taken apart once, and values are read without it.
///
/// "left.patches.1.parts.0.pmax" says to what a number belongs (left wheel, patch 1, its part 0),
/// in which group of names it is (those of a patch) and which one of them it is (an entry of the
/// table in scene/number_tables.hpp). An id is that, and packed the same as one integer: the same
/// in every process, for every scene, solved or not, with one version of the library. Thread rule:
/// pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/number_group.hpp"

namespace wrc {

struct NumberId {
  NumberGroup group = NumberGroup::scene;
  std::size_t entry = 0;
  bool right = false;    ///< of a wheel: the right one
  std::size_t index = 0; ///< of the near contact or patch
  std::size_t part = 0;  ///< of the part of a patch, from 1; 0: the patch itself
};

/// What a name stands for, whether or not a result has it; none if no result ever has.
std::optional<NumberId> number_id(std::string_view name);

/// The text of an error that names the successor of a result that earlier versions had; none if
/// they had no such result.
std::optional<std::string> removed_number(std::string_view name);

/// Names that results may have: all of a scene and both wheels, those of near contacts, patches and
/// their parts with index 0.
std::vector<std::string> possible_number_names();

/// Indices that a packed id has room for.
inline constexpr std::size_t max_packed_index = 1023; // not a tuning constant
inline constexpr std::size_t max_packed_part = 254;   // not a tuning constant

/// As one positive integer, which no index of a key is; none if an index is beyond those above.
std::optional<std::int32_t> pack(const NumberId& id);
/// None if it is not what pack has given.
std::optional<NumberId> unpack(std::int32_t packed);

} // namespace wrc
