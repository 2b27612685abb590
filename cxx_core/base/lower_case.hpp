/// Text in small letters.
///
/// Thread rule: a pure function.
#pragma once

#include <string>
#include <string_view>

namespace wrc {

/// Those of ASCII; all other bytes stay.
inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return result;
}

} // namespace wrc
