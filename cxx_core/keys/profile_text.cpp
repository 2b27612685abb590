#include "keys/profile_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/lower_case.hpp"

namespace wrc {
namespace {

using namespace dimensions;

/// A number, or a word for none.
struct NumberOption {
  std::string_view name;
  std::string_view word;
  double min; ///< mm or rad, ends included
  double max;
  Dimension dimension;
  std::optional<ProfileKind> kind; ///< of these only
};

constexpr std::array number_options{
    NumberOption{"smoothing", "auto", 0.0, 100.0, length, {}},
    NumberOption{"smoothing_along", "auto", 0.0, 1e6, length, {}},
    NumberOption{"rotation", "auto", -0.5, 0.5, angle, {}},
    NumberOption{"origin", "gauge", -2000.0, 2000.0, length, ProfileKind::rail},
    NumberOption{"shift", "none", -500.0, 500.0, length, ProfileKind::wheel}};

/// Where the options have them.
std::array<std::optional<double>*, number_options.size()> numbers_of(ProfileOptions& options) {
  return {&options.smoothing, &options.smoothing_along, &options.placement.rotation,
          &options.rail_origin, &options.placement.lateral_shift};
}

constexpr std::array wheel_origins{
    std::pair{std::string_view("auto"), WheelOrigin::by_file},
    std::pair{std::string_view("tape"), WheelOrigin::tape},
    std::pair{std::string_view("flange-back"), WheelOrigin::flange_back}};

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Whether a word and an equal sign come first.
bool is_assignment(std::string_view text) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_not_of(letters), text.size());
  return end > 0 && trimmed(text.substr(end)).starts_with('=');
}

/// The name, in which only blanks before an option do not count, then the options.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t at = text.find(';'); at != std::string_view::npos; at = text.find(';', at + 1)) {
    if (is_assignment(text.substr(at + 1))) {
      const std::string_view part = text.substr(begin, at - begin);
      parts.push_back(part.substr(0, part.find_last_not_of(blanks) + 1));
      begin = at + 1;
    }
  }
  parts.push_back(begin == 0 ? text : trimmed(text.substr(begin)));
  return parts;
}

/// A value in mm or rad, or nothing for the option's word; `what` is named in errors.
std::optional<double> number_in(std::string_view value, const NumberOption& option,
                                const std::string& what, const Convention& convention) {
  if (value == option.word) {
    return std::nullopt;
  }
  double number = 0.0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), number);
  number = from_caller(number, convention, option.dimension);
  if (fault != std::errc() || end != value.data() + value.size() || !(number >= option.min) ||
      !(number <= option.max)) {
    throw_invalid_argument(what, '"' + std::string(value) + '"',
                           "must be \"" + std::string(option.word) + "\", or " +
                               text_of(to_caller(option.min, convention, option.dimension)) +
                               " to " +
                               amount_text(option.max, convention.units, option.dimension));
  }
  return number;
}

} // namespace

ProfileChoice profile_choice(std::string_view text, ProfileKind kind, std::string_view key,
                             const Convention& convention) {
  const std::vector<std::string_view> parts = parts_of(text);
  ProfileChoice choice{std::string(parts.front())};
  ProfilePlacement& placement = choice.options.placement;
  for (const std::string_view part : std::span(parts).subspan(1)) {
    const std::string name = lower_case(trimmed(part.substr(0, part.find('='))));
    const std::string_view value = trimmed(part.substr(part.find('=') + 1));
    const std::string what = name + " of " + std::string(key);
    const auto* const number = std::ranges::find_if(number_options, [&](const NumberOption& one) {
      return one.name == name && one.kind.value_or(kind) == kind;
    });
    if (number != number_options.end()) {
      *numbers_of(choice.options)[static_cast<std::size_t>(number - number_options.begin())] =
          number_in(value, *number, what, convention);
    } else if (name == "align_to" && !value.empty()) {
      placement.align_to = value == "none" ? std::string_view() : value;
    } else if (name == "origin") {
      const auto* const found =
          std::ranges::find(wheel_origins, value, [](const auto& origin) { return origin.first; });
      if (found == wheel_origins.end()) {
        throw_invalid_argument(what, '"' + std::string(value) + '"',
                               "must be \"auto\", \"tape\" or \"flange-back\"");
      }
      placement.origin = found->second;
    } else {
      throw_invalid_argument(
          std::string(key), '"' + std::string(part) + '"',
          "options must be among smoothing, smoothing_along, rotation, origin, " +
              std::string(kind == ProfileKind::wheel ? "shift, " : "") + "align_to");
    }
  }
  return choice;
}

std::string profile_text(const ProfileChoice& choice, const Convention& convention) {
  std::string text = choice.name;
  const auto add = [&text](std::string_view name, std::string_view value) {
    text.append("; ").append(name).append(" = ").append(value);
  };
  ProfileOptions options = choice.options;
  for (std::size_t i = 0; i < number_options.size(); ++i) {
    if (const std::optional<double>& number = *numbers_of(options)[i]) {
      const NumberOption& option = number_options[i];
      add(option.name, text_of(to_caller(*number, convention, option.dimension)));
    }
  }
  if (options.placement.origin != WheelOrigin::by_file) {
    add("origin", options.placement.origin == WheelOrigin::tape ? "tape" : "flange-back");
  }
  if (!options.placement.align_to.empty()) {
    add("align_to", options.placement.align_to);
  }
  return text;
}

} // namespace wrc
