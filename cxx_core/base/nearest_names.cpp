#include "base/nearest_names.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace wrc {
namespace {

std::size_t edit_distance(std::string_view one, std::string_view other) {
  std::vector<std::size_t> row(other.size() + 1); // from what was read of `one` to parts of `other`
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : one) {
    std::size_t diagonal = row[0]++;
    for (std::size_t i = 0; i < other.size(); ++i) {
      const bool same = letter == other[i] || (letter == '_' && other[i] == '.');
      const std::size_t replaced = diagonal + (same ? 0 : 1);
      diagonal = row[i + 1];
      row[i + 1] = std::min({replaced, diagonal + 1, row[i] + 1});
    }
  }
  return row.back();
}

std::size_t after_point(std::string_view name, std::size_t begin) {
  return std::min(name.find('.', begin), name.size()) + 1;
}

} // namespace

std::string nearest_names(std::string_view word, std::span<const std::string> names) {
  constexpr std::size_t longest_word =
      64;                 // origin: derived: more than any name has, so that it ends
  constexpr int most = 4; // origin: reasoned: a line holds them
  std::size_t least = std::numeric_limits<std::size_t>::max();
  std::string text;
  int count = 0;
  for (const std::string_view name : names) {
    std::size_t distance = std::numeric_limits<std::size_t>::max();
    for (std::size_t begin = 0; begin <= name.size(); begin = after_point(name, begin)) {
      for (std::size_t end = begin; end <= name.size();) {
        end = after_point(name, end);
        const std::string_view part = name.substr(begin, end - begin - 1);
        distance = std::min(distance, edit_distance(word.substr(0, longest_word), part));
      }
    }
    if (distance < least) {
      least = distance;
      text = name;
      count = 1;
    } else if (distance == least && count++ < most) {
      text.append(" ").append(name);
    }
  }
  return text;
}

} // namespace wrc
