#include "keys/profile_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
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

/// Options that hold a number.
/// origin: bound: waves, turns and shifts beyond these change a profile past recognition.
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

using OriginWord = std::pair<std::string_view, WheelOrigin>;
constexpr std::array wheel_origins{OriginWord{"auto", WheelOrigin::by_file},
                                   OriginWord{"tape", WheelOrigin::tape},
                                   OriginWord{"flange-back", WheelOrigin::flange_back}};

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Whether a word and an equal sign come first.
bool is_assignment(std::string_view text) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  const auto skip = [&text](std::string_view these) {
    const std::size_t count = std::min(text.find_first_not_of(these), text.size());
    text.remove_prefix(count);
    return count;
  };
  skip(blanks);
  const bool has_word = skip(letters) > 0;
  skip(blanks);
  return has_word && text.starts_with('=');
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

[[noreturn]] void refuse(const ProfileKey& key, std::string_view option, std::string_view value,
                         const std::string& allowed) {
  throw_invalid_argument(std::string(key.name).append(".").append(option),
                         '"' + std::string(value) + '"', allowed);
}

/// One that holds a number, by its place among them; none for another or none at all.
std::optional<std::size_t> number_option(std::string_view option, ProfileKind kind) {
  const auto* const found = std::ranges::find_if(number_options, [&](const NumberOption& one) {
    return one.name == option && one.kind.value_or(kind) == kind;
  });
  return found == number_options.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - number_options.begin()));
}

/// A name in small letters. Throws if there is no such option.
std::string known_option(std::string_view option, const ProfileKey& key) {
  std::string known = lower_case(option);
  if (!number_option(known, key.kind) && known != "origin" && known != "align_to" &&
      known != "file") {
    throw Error(ErrorCode::unknown_name,
                "unknown option " + std::string(key.name).append(".").append(known) +
                    ": must be smoothing, smoothing_along, rotation, origin, " +
                    (key.kind == ProfileKind::wheel ? "shift, " : "") + "align_to or file");
  }
  return known;
}

/// A value in mm or rad, or nothing for the option's word.
std::optional<double> number_in(std::string_view value, const NumberOption& option,
                                const ProfileKey& key, const Convention& convention) {
  if (value == option.word) {
    return std::nullopt;
  }
  double number = 0.0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), number);
  number = from_caller(number, convention, option.dimension);
  if (fault != std::errc() || end != value.data() + value.size() || !(number >= option.min) ||
      !(number <= option.max)) {
    refuse(key, option.name, value,
           "must be \"" + std::string(option.word) + "\", or " +
               text_of(to_caller(option.min, convention, option.dimension)) + " to " +
               amount_text(option.max, convention.units, option.dimension));
  }
  return number;
}

WheelOrigin origin_in(std::string_view value, const ProfileKey& key) {
  const auto* const found = std::ranges::find(wheel_origins, value, &OriginWord::first);
  if (found == wheel_origins.end()) {
    refuse(key, "origin", value, "must be \"auto\", \"tape\" or \"flange-back\"");
  }
  return found->second;
}

std::string_view word_of(WheelOrigin origin) {
  return std::ranges::find(wheel_origins, origin, &OriginWord::second)->first;
}

} // namespace

void set_profile_option(ProfileChoice& choice, std::string_view option, std::string_view value,
                        const ProfileKey& key, const Convention& convention) {
  const std::string name = known_option(option, key);
  ProfilePlacement& placement = choice.options.placement;
  if (const auto number = number_option(name, key.kind)) {
    *numbers_of(choice.options)[*number] =
        number_in(value, number_options[*number], key, convention);
  } else if (name == "origin") {
    placement.origin = origin_in(value, key);
  } else if (value.empty()) {
    refuse(key, name, value, "must be a built-in profile or a profile file");
  } else if (name == "align_to") {
    placement.align_to = value == "none" ? std::string_view() : value;
  } else {
    const std::string_view standard = standard_name(value, key.kind);
    choice.name = standard.empty() ? value : standard;
    choice.given = nullptr;
    choice.options = {};
  }
}

KeyValue profile_option(const ProfileChoice& choice, std::string_view option, const ProfileKey& key,
                        const Convention& convention) {
  const std::string name = known_option(option, key);
  const ProfilePlacement& placement = choice.options.placement;
  if (const auto number = number_option(name, key.kind)) {
    ProfileOptions options = choice.options;
    const NumberOption& known = number_options[*number];
    const std::optional<double>& value = *numbers_of(options)[*number];
    return value ? KeyValue(to_caller(*value, convention, known.dimension))
                 : KeyValue(std::string(known.word));
  }
  return name == "file"     ? choice.name
         : name == "origin" ? std::string(word_of(placement.origin))
                            : (placement.align_to.empty() ? "none" : placement.align_to);
}

std::string profile_option_unit(std::string_view option, const ProfileKey& key, Units units) {
  const auto number = number_option(known_option(option, key), key.kind);
  return number ? unit_in(units, number_options[*number].dimension.unit) : "";
}

void set_profile_text(ProfileChoice& choice, std::string_view text, const ProfileKey& key,
                      const Convention& convention) {
  const std::vector<std::string_view> parts = parts_of(text);
  std::vector<std::string> before;
  const auto set = [&](std::string_view option, std::string_view value) {
    set_profile_option(choice, option, value, key, convention);
    if (std::ranges::find(before, lower_case(option)) != before.end()) {
      refuse(key, option, value, "must be there once; it is twice in one text");
    }
    before.push_back(lower_case(option));
  };
  if (!parts.front().empty()) {
    set("file", parts.front());
  }
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    set(trimmed(parts[i].substr(0, equals)), trimmed(parts[i].substr(equals + 1)));
  }
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
    add("origin", word_of(options.placement.origin));
  }
  if (!options.placement.align_to.empty()) {
    add("align_to", options.placement.align_to);
  }
  return text;
}

} // namespace wrc
