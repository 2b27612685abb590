/// Numbers as texts, and texts as words.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace driver {

/// With this number of digits after the point; never -0.
inline std::string fixed(double value, int decimals) {
  std::array<char, 512> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, decimals);
  const std::string text(buffer.data(), end.ptr);
  return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos
             ? text.substr(1)
             : text;
}

/// With this number of significant digits, as streams write it.
inline std::string general(double value, int digits = 6) {
  std::array<char, 64> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

/// As a power of ten with this number of digits after the point, "-" for none.
inline std::string power(const std::optional<double>& value, int decimals) {
  std::array<char, 64> buffer{};
  const int length =
      value ? std::snprintf(buffer.data(), buffer.size(), "%.*e", decimals, *value) : 0;
  return value ? std::string(buffer.data(), static_cast<std::size_t>(length)) : "-";
}

/// Shortest text that reads back as the same number; NaN has none.
inline std::string text_of(double number) {
  if (std::isnan(number)) {
    return "";
  }
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr};
}

/// With this number of significant digits, from 17 on the shortest that reads back the same.
inline std::string table_text(double number, int digits) {
  return digits >= 17 || std::isnan(number) ? text_of(number) : general(number, digits);
}

/// The words of a text, between blanks.
inline std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string word; in >> word;) {
    all.push_back(word);
  }
  return all;
}

} // namespace driver
