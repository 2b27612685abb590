/// Names of results, taken apart from the front: "patches.12.pmax".
///
/// Thread rule: pure functions.
#pragma once

#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace wrc {

/// Takes a prefix off a name.
inline bool strip_prefix(std::string_view& name, std::string_view prefix) {
  if (!name.starts_with(prefix)) {
    return false;
  }
  name.remove_prefix(prefix.size());
  return true;
}

/// Takes "12." off a name, as an index below `count`.
inline bool strip_index(std::string_view& name, std::size_t count, std::size_t& index) {
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  if (error != std::errc() || index >= count) {
    return false;
  }
  name.remove_prefix(static_cast<std::size_t>(end - name.data()));
  return strip_prefix(name, ".");
}

} // namespace wrc
