#include "base/error.hpp"

#include <array>
#include <charconv>

namespace wrc {

std::string text_of(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string short_text_of(double value) {
  constexpr int digits = 4;
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return {buffer.data(), end};
}

void throw_invalid_argument(const std::string& argument, double value, const std::string& allowed) {
  throw_invalid_argument(argument, text_of(value), allowed);
}

void throw_invalid_argument(const std::string& argument, const std::string& value,
                            const std::string& allowed) {
  throw Error(ErrorCode::invalid_argument, argument + " = " + value + ": " + allowed);
}

std::string must_be(std::string_view permitted) {
  constexpr std::string_view between = " to ";
  const auto is_number = [](std::string_view text) {
    double value = 0.0;
    return std::from_chars(text.data(), text.data() + text.size(), value).ptr ==
           text.data() + text.size();
  };
  const std::size_t middle = permitted.find(between);
  if (middle == std::string_view::npos || !is_number(permitted.substr(0, middle))) {
    return "must be " + std::string(permitted);
  }
  return "must be between " + std::string(permitted.substr(0, middle)) + " and " +
         std::string(permitted.substr(middle + between.size()));
}

} // namespace wrc
