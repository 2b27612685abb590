#include "keys/scene_keys.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/lower_case.hpp"
#include "base/nearest_names.hpp"
#include "keys/removed_names.hpp"
#include "keys/scene_key_table.hpp"

namespace wrc {
namespace {

const std::vector<Key>& keys() {
  static const std::vector<Key> all = [] {
    std::vector<Key> made = make_scene_keys();
    if (made.size() > KeySet().size()) {
      throw Error(ErrorCode::internal, "KeySet is smaller than the number of keys");
    }
    const Scene usual;
    for (Key& key : made) {
      const KeyValue value = key.get(usual);
      if (const auto* number = std::get_if<double>(&value)) {
        key.usual = *number;
      } else if (const auto* list = std::get_if<std::vector<double>>(&value)) {
        key.usual_list = *list;
      }
    }
    return made;
  }();
  return all;
}

std::vector<std::string> names_of_keys() {
  std::vector<std::string> names;
  for (const Key& key : keys()) {
    names.emplace_back(key.description.name);
  }
  return names;
}

/// Also as Python writes it: with _ for each point, and without the first groups.
const RemovedName* removed_key(std::string_view name) {
  const auto letter = [](char c) { return c == '.' ? '_' : c; };
  const auto* const found = std::ranges::find_if(removed_names, [&](const RemovedName& removed) {
    const std::string_view old = removed.name;
    return removed.kind == NameOf::key && name.size() <= old.size() &&
           (name.size() == old.size() || old[old.size() - name.size() - 1] == '.') &&
           std::ranges::equal(old.substr(old.size() - name.size()), name, {}, letter, letter);
  });
  return found == removed_names.end() ? nullptr : found;
}

/// Of "track.rail.smoothing" the option of a profile, "smoothing", and the profile's key.
struct OptionName {
  const Key& key;
  std::string_view option;
};
std::optional<OptionName> option_named(std::string_view name) {
  for (const Key& key : keys()) {
    const std::size_t size = key.description.name.size();
    if (key.set_option && name.size() > size && name[size] == '.' &&
        lower_case(name.substr(0, size)) == key.description.name) {
      return OptionName{key, name.substr(size + 1)};
    }
  }
  return std::nullopt;
}

const Key& find_key(std::string_view name) {
  const auto find = [](std::string_view spelled) {
    return std::ranges::find(keys(), spelled, [](const Key& key) { return key.description.name; });
  };
  if (const auto found = find(name); found != keys().end()) {
    return *found;
  }
  const std::string spelled = lower_case(name); // as all keys are
  if (const auto found = find(spelled); found != keys().end()) {
    return *found;
  }
  if (const auto named = option_named(name)) {
    (void)named->key.option_unit(named->option, Units::mm);
    throw Error(ErrorCode::invalid_argument,
                spelled +
                    " is an option of a profile: it must be one number or a text, by its name");
  }
  if (const RemovedName* removed = removed_key(spelled)) {
    throw Error(ErrorCode::unknown_name, std::string(removed->name) + " is not a key any more: " +
                                             std::string(removed->successor));
  }
  throw Error(ErrorCode::unknown_name,
              "unknown key " + std::string(name) +
                  "; nearest: " + nearest_names(name, names_of_keys()) +
                  "; all are listed by wrc_scene_key, wrc_case --help, wrcontact.keys() in "
                  "Python, wrc_keys in Octave");
}

[[noreturn]] void refuse(const Key& key, const std::string& value, const char* remark = "") {
  throw_invalid_argument(std::string(key.description.name), value,
                         must_be(key.description.allowed) + remark);
}

/// The number that a text is, or none.
std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

/// What a key allows, with its range in the caller's units and frame: "-100 to 100 mm" is "-0.1 to
/// 0.1 m". None if the text does not give the key's range in this way.
std::optional<std::string> allowed_for(const Key& key, const Convention& convention) {
  constexpr std::string_view between = " to ";
  const std::string_view text = key.description.allowed;
  const std::size_t middle = text.find(between);
  if (middle == std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t first = text.rfind(' ', middle - 1) + 1; // also where there is no blank
  const std::size_t second = middle + between.size();
  const std::size_t unit = std::min(text.find(' ', second), text.size());
  if (number_of(text.substr(first, middle - first)) != key.min ||
      number_of(text.substr(second, unit - second)) != key.max) {
    return std::nullopt;
  }
  const auto [low, high] = std::minmax({to_caller(key.min, convention, key.dimension),
                                        to_caller(key.max, convention, key.dimension)});
  std::string rest(text.substr(unit));
  if (convention.units == Units::si) {
    for (const auto& [ours, theirs] : {std::pair("mm", "m"), std::pair("MPa", "Pa")}) {
      for (std::size_t at = rest.find(ours); at != std::string::npos;
           at = rest.find(ours, at + 1)) {
        rest.replace(at, std::string_view(ours).size(), theirs);
      }
    }
  }
  return std::string(text.substr(0, first)) + text_of(low) + std::string(between) + text_of(high) +
         rest;
}

/// A text where a key takes no such word. A number in quotes, or with a unit or a decimal comma, is
/// reported as such.
[[noreturn]] void refuse_text(const Key& key, const Convention& convention,
                              std::string_view value) {
  const std::string text = '"' + std::string(value) + '"';
  const bool begins_as_number =
      value.find_first_of("0123456789") == std::min(value.find_first_not_of("+-."), value.size());
  const bool is_ratio = value.find(':') != std::string_view::npos;
  if (!key.set_number || !begins_as_number || is_ratio) {
    refuse(key, text);
  }
  const std::optional<std::string> theirs =
      convention == Convention{} ? std::nullopt : allowed_for(key, convention);
  throw_invalid_argument(
      std::string(key.description.name), text,
      (number_of(value) ? "a text; write the number without quotes; " : "not a number; ") +
          must_be(theirs.value_or(std::string(key.description.allowed))));
}

/// Permitted ranges are declared in mm, y left, z up, and stated as the value was given.
[[noreturn]] void refuse_number(const Key& key, const Convention& convention, double given) {
  const std::string allowed(key.description.allowed);
  throw_invalid_argument(
      std::string(key.description.name), text_of(given),
      must_be(convention == Convention{} || key.dimension.quantity == Quantity::number
                  ? allowed
                  : allowed_for(key, convention).value_or(allowed)));
}

/// A value as the key takes it. Throws Error(invalid_argument).
double checked_number(const Key& key, const Convention& convention, double value) {
  const double inside = from_caller(value, convention, key.dimension);
  const bool permitted =
      inside >= key.min && inside <= key.max && (!key.whole || inside == std::floor(inside));
  if (!key.set_number || !permitted) {
    refuse_number(key, convention, value);
  }
  return inside;
}

void mark_given(Scene& scene, const Key& key, bool given = true) {
  scene.given[static_cast<std::size_t>(&key - keys().data())] = given;
}

void set_checked_number(Scene& scene, const Key& key, double value) {
  key.set_number(scene, value);
  mark_given(scene, key, key.usual != value);
}

} // namespace

std::span<const KeyDescription> scene_keys() {
  static const std::vector<KeyDescription> descriptions = [] {
    std::vector<KeyDescription> all;
    for (const Key& key : keys()) {
      all.push_back(key.description);
    }
    return all;
  }();
  return descriptions;
}

KeyValue key_value(const Scene& scene, std::string_view name) {
  if (const auto named = option_named(name)) {
    return named->key.get_option(scene, named->option);
  }
  const Key& key = find_key(name);
  KeyValue value = key.get(scene);
  if (double* number = std::get_if<double>(&value)) {
    *number = to_caller(*number, scene.convention, key.dimension);
  }
  return value;
}

void set_number(Scene& scene, std::string_view name, double value) {
  if (const auto named = option_named(name)) {
    named->key.set_option(scene, named->option, text_of(value));
    return;
  }
  const Key& key = find_key(name);
  set_checked_number(scene, key, checked_number(key, scene.convention, value));
}

std::string key_unit(std::string_view name, Units units) {
  if (const auto named = option_named(name)) {
    return named->key.option_unit(named->option, units);
  }
  const Key& key = find_key(name);
  return key.set_number ? unit_in(units, key.dimension.unit) : "";
}

std::int32_t key_id(std::string_view name) {
  return static_cast<std::int32_t>(&find_key(name) - keys().data());
}

void set_numbers_by_id(Scene& scene, std::span<const std::int32_t> ids,
                       std::span<const double> values) {
  const std::vector<Key>& all = keys();
  const auto key_of = [&](std::size_t i) -> const Key& {
    return all[static_cast<std::size_t>(ids[i])];
  };
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] < 0 || static_cast<std::size_t>(ids[i]) >= all.size()) {
      throw_invalid_argument("ids[" + std::to_string(i) + ']', ids[i], "must be the id of a key");
    }
    checked_number(key_of(i), scene.convention, values[i]);
  }
  // Nothing fails from here on: numbers change no convention, and setting one takes no memory.
  for (std::size_t i = 0; i < ids.size(); ++i) {
    set_checked_number(scene, key_of(i),
                       from_caller(values[i], scene.convention, key_of(i).dimension));
  }
}

void set_text(Scene& scene, std::string_view name, std::string_view value) {
  if (const auto named = option_named(name)) {
    named->key.set_option(scene, named->option, value);
    return;
  }
  const Key& key = find_key(name);
  if (!key.set_text || !key.set_text(scene, value)) {
    refuse_text(key, scene.convention, value);
  }
  const std::string_view usual = key.description.default_value; // a word is in quotes
  mark_given(scene, key, usual.size() < 2 || usual.substr(1, usual.size() - 2) != value);
}

void set_numbers(Scene& scene, std::string_view name, std::span<const double> values) {
  const Key& key = find_key(name);
  if (!key.set_numbers || !key.set_numbers(scene, values)) {
    // Largest number of entries shown of a list of any length.
    constexpr std::size_t max_named = 4;
    std::string text = "[";
    for (const double value : values.first(std::min(values.size(), max_named))) {
      text += (text.size() > 1 ? ", " : "") + text_of(value);
    }
    text +=
        values.size() > max_named ? ", ...], " + std::to_string(values.size()) + " values" : "]";
    refuse(key, text,
           scene.convention == Convention{} ? "" : "; stated in mm, N, MPa, y left, z up");
  }
  mark_given(scene, key, !std::ranges::equal(values, key.usual_list));
}

void set_profile(Scene& scene, std::string_view name, const Profile& profile) {
  const Key& key = find_key(name);
  if (!key.set_profile || !key.set_profile(scene, profile)) {
    throw_invalid_argument(std::string(name), "profile \"" + profile.name + '"',
                           "must be a wheel for wheelset.wheel and a rail for track.rail, or "
                           "those of one side");
  }
}

} // namespace wrc
