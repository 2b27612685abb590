/// A study: a scene of which some keys have several values, all of them crossed.
///
/// Scenes are numbered from 0; the last axis varies fastest.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "support/scene_file.hpp"

namespace driver {

/// A file that a study reads, as it was when the study began.
struct InputFile {
  std::string path;
  std::string content;
  std::string sha256; ///< of the content, as sha256sum prints it
};

/// Throws Failure if it cannot be read, or is larger than a profile file may be.
InputFile read_input(const std::string& path);
InputFile input_of(const std::string& path, std::string content);

/// A key with the values it goes through.
struct Axis {
  std::string key;
  std::vector<Value> values;
};

/// A line of a panel: a result over the picture's x.
struct LineRequest {
  std::string result;
  std::string title;
};

struct PanelRequest {
  std::string y_label;
  double y_factor = 1.0;
  bool is_joined = true;         ///< lines between the points
  std::string statistic = "max"; ///< ranking: of all scenes of a bar; or "mean", "min"
  std::vector<LineRequest> lines;
};

struct PictureRequest {
  enum class Kind {
    lines,       ///< results over the values of a key
    map,         ///< results over the values of two keys, as colours
    patches,     ///< maps of pressures, one per scene and side
    connections, ///< points of both profiles that touch, joined
    conicity,    ///< rolling radius difference, contact angles and equivalent conicity
    ranking      ///< bars of the largest, mean or smallest results, the largest bar first
  };

  std::string file; ///< beside the results
  Kind kind = Kind::lines;
  std::string title;
  std::string x; ///< key of the axis to the right; patches: of the columns
  std::string x_label;
  double x_factor = 1.0;
  /// Keys with a line, a row of maps or a bar for each combination of their values; map: one key,
  /// upwards. Keys that do not vary are left out.
  std::vector<std::string> series;
  bool series_is_list = false;             ///< of keys: without a label, profiles by name alone
  std::optional<std::string> series_label; ///< {} stands for the values; none: the key
  double series_factor = 1.0;              ///< map
  std::vector<std::string> sides;          ///< patches, connections: "left", "right"
  std::vector<double> x_values;            ///< those drawn; empty: all
  double pressure_max = 0.0; ///< patches: of the darkest colour, MPa; 0: the largest there is
  Values where;              ///< which scenes are drawn
  std::vector<PanelRequest> panels;
  bool is_drawn = true; ///< otherwise only its table is written
};

struct Study {
  std::string name;  ///< of the output files
  std::string title; ///< what it is about
  Values fixed;
  std::set<std::string> assigned; ///< keys of --set: set after those of the file
  std::vector<Axis> axes;
  std::vector<std::string> results; ///< scalars, as of wrc_scene_number
  std::vector<std::string> fields;  ///< of each patch, as of wrc_scene_field
  std::vector<PictureRequest> pictures;
  std::vector<InputFile> inputs; ///< the study file, then profiles
  int digits = 6;                ///< of numbers in tables; 17: all
  bool for_page = false;         ///< rows hold what the page shows

  [[nodiscard]] std::int64_t scene_count() const;
  /// Which value of each axis a scene has.
  [[nodiscard]] std::vector<std::size_t> places(std::int64_t scene) const;
  /// Sets all keys of a scene.
  void apply(std::int64_t index, Scene& scene) const;
  /// Position of a key among the axes, -1 if it has one value only.
  [[nodiscard]] int axis_of(const std::string& key) const;
  /// All keys that have one value in all scenes, defaults included.
  [[nodiscard]] Values constants() const;
  /// All that the rows depend on, in one text: equal texts have equal rows.
  [[nodiscard]] std::string fingerprint() const;
  /// Throws Failure if the content of a profile file is another than when the study began.
  void refuse_changed_inputs() const;
};

} // namespace driver
