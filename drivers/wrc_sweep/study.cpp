#include "wrc_sweep/study.hpp"

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

} // namespace driver
