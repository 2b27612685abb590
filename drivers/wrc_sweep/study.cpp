#include "wrc_sweep/study.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace driver {

std::int64_t Study::scene_count() const {
  std::int64_t count = 1;
  for (const Axis& axis : axes) {
    count *= static_cast<std::int64_t>(axis.values.size());
  }
  return count;
}

std::vector<std::size_t> Study::places(std::int64_t scene) const {
  std::vector<std::size_t> places(axes.size());
  auto rest = static_cast<std::size_t>(scene);
  for (std::size_t i = axes.size(); i-- > 0;) {
    places[i] = rest % axes[i].values.size();
    rest /= axes[i].values.size();
  }
  return places;
}

void Study::apply(std::int64_t index, Scene& scene) const {
  Values values = fixed;
  const std::vector<std::size_t> at = places(index);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    values.insert_or_assign(axes[i].key, axes[i].values[at[i]]);
  }
  set_values(scene, values);
}

int Study::axis_of(const std::string& key) const {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].key == key) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::string Study::fingerprint() const {
  std::string text = wrc_version();
  for (const auto& [key, value] : fixed) {
    text += '\n' + key + " = " + text_of(value);
  }
  for (const Axis& axis : axes) {
    text += '\n' + axis.key + " in";
    for (const Value& value : axis.values) {
      text += ' ' + text_of(value);
    }
  }
  for (const auto* names : {&results, &fields}) {
    text += '\n';
    for (const std::string& one : *names) {
      text += one + ' ';
    }
  }
  return text;
}

std::string text_of(double number) {
  if (std::isnan(number)) {
    return "";
  }
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

std::string text_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value)) {
    return text_of(*number);
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    std::string text;
    for (const double number : *numbers) {
      text += (text.empty() ? "[" : ", ") + text_of(number);
    }
    return text + ']';
  }
  if (const Bare* bare = std::get_if<Bare>(&value)) {
    return bare->text;
  }
  return std::get<std::string>(value);
}

} // namespace driver
