/// Makers of the usual keys: a number, a number held twice, a list of three, a word, a number or a
/// word.
///
/// Thread rule: pure functions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "keys/scene_key.hpp"

namespace wrc::key_makers {

/// Permitted, ends included.
struct Range {
  double min;
  double max;
};

/// A number that a scene holds once: a member, or a function of a scene, const or not.
template <class Place>
Key number_key(KeyDescription description, Range range, Dimension dimension, Place place) {
  Key key;
  key.description = description;
  key.dimension = dimension;
  key.min = range.min;
  key.max = range.max;
  key.get = [place](const Scene& scene) { return KeyValue(std::invoke(place, scene)); };
  key.set_number = [place](Scene& scene, double value) { std::invoke(place, scene) = value; };
  return key;
}

/// A number that a scene holds twice, for wheel and rail or left and right.
template <class Place, class Other>
Key number_key(KeyDescription description, Range range, Dimension dimension, Place place,
               Other other) {
  Key key = number_key(description, range, dimension, place);
  key.get = [place, other](const Scene& scene) {
    return std::invoke(place, scene) == std::invoke(other, scene)
               ? KeyValue(std::invoke(place, scene))
               : KeyValue();
  };
  key.set_number = [place, other](Scene& scene, double value) {
    std::invoke(place, scene) = value;
    std::invoke(other, scene) = value;
  };
  return key;
}

/// Where a side has something.
template <class Value> auto place_of(SceneSide Scene::*side, Value SceneSide::*member) {
  return [ side, member ](auto& scene) -> auto& {
    return (scene.*side).*member;
  };
}

using Three = std::array<double, 3>;

/// A list of numbers, each with a limit of its magnitude; `get` and `set` have them in mm, y left,
/// z up.
template <std::size_t count, class Get, class Set>
Key list_key(KeyDescription description, const std::array<double, count>& limits,
             const std::array<Dimension, count>& dimensions_of, Get get, Set set) {
  using List = std::array<double, count>;
  Key key;
  key.description = description;
  key.get = [dimensions_of, get](const Scene& scene) {
    const std::optional<List> inside = get(scene);
    if (!inside) {
      return KeyValue(std::string("none"));
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < inside->size(); ++i) {
      values.push_back(to_caller((*inside)[i], scene.convention, dimensions_of[i]));
    }
    return KeyValue(values);
  };
  key.set_numbers = [limits, dimensions_of, set](Scene& scene, std::span<const double> values) {
    List inside{};
    if (values.size() != inside.size()) {
      return false;
    }
    for (std::size_t i = 0; i < inside.size(); ++i) {
      inside[i] = from_caller(values[i], scene.convention, dimensions_of[i]);
      if (!(std::abs(inside[i]) <= limits[i])) {
        return false;
      }
    }
    set(scene, inside);
    return true;
  };
  return key;
}

template <class Get, class Set>
Key three_key(KeyDescription description, const Three& limits,
              const std::array<Dimension, 3>& dimensions_of, Get get, Set set) {
  return list_key(description, limits, dimensions_of, get, set);
}

/// A word for each value of an enumeration.
template <class Value, class Place>
Key word_key(KeyDescription description, std::vector<std::pair<std::string_view, Value>> words,
             Place place) {
  Key key;
  key.description = description;
  key.get = [words, place](const Scene& scene) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& word) {
      return word.second == std::invoke(place, scene);
    });
    return KeyValue(std::string(found->first));
  };
  key.set_text = [words, place](Scene& scene, std::string_view value) {
    const auto found = std::find_if(words.begin(), words.end(),
                                    [value](const auto& word) { return word.first == value; });
    if (found != words.end()) {
      std::invoke(place, scene) = found->second;
    }
    return found != words.end();
  };
  return key;
}

/// A number that a word unsets.
template <class Place>
Key optional_key(KeyDescription description, Range range, Dimension dimension, Place place,
                 std::string_view word) {
  Key key;
  key.description = description;
  key.dimension = dimension;
  key.min = range.min;
  key.max = range.max;
  key.get = [place, word](const Scene& scene) {
    const std::optional<double>& number = std::invoke(place, scene);
    return number ? KeyValue(*number) : KeyValue(std::string(word));
  };
  key.set_number = [place](Scene& scene, double value) { std::invoke(place, scene) = value; };
  key.set_text = [place, word](Scene& scene, std::string_view value) {
    if (value == word) {
      std::invoke(place, scene).reset();
    }
    return value == word;
  };
  return key;
}

} // namespace wrc::key_makers
