/// A study: a scene of which some keys have several values, all of them crossed.
///
/// Scenes are numbered from 0; the last axis varies fastest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/scene_value.hpp"
#include "wrc_sweep/picture_request.hpp"

namespace driver {

/// A key with the values it goes through.
struct Axis {
  std::string key;
  std::vector<Value> values;
};

struct Study {
  std::string name;  ///< of the output files
  std::string title; ///< what it is about
  Values fixed;
  std::vector<Axis> axes;
  std::vector<std::string> results; ///< scalars, as of wrc_scene_number, and "left.patch_count"
  std::vector<std::string> fields;  ///< of each patch, as of wrc_scene_field
  std::vector<PictureRequest> pictures;

  [[nodiscard]] std::int64_t scene_count() const;
  /// Which value of each axis a scene has.
  [[nodiscard]] std::vector<std::size_t> places(std::int64_t scene) const;
  /// Sets all keys of a scene.
  void apply(std::int64_t index, Scene& scene) const;
  /// Position of a key among the axes, -1 if it has one value only.
  [[nodiscard]] int axis_of(const std::string& key) const;
  /// All that the rows depend on, in one text: equal texts have equal rows.
  [[nodiscard]] std::string fingerprint() const;
};

/// Shortest text that reads back as the same value; texts as they are.
std::string text_of(const Value& value);
/// The same of a number; "nan" has no text.
std::string text_of(double number);

} // namespace driver
