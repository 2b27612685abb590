/// Pictures of a study, as its file asks for them.
#pragma once

#include <string>
#include <vector>

#include "support/scene_value.hpp"

namespace driver {

/// A line of a panel: a result over the picture's x.
struct LineRequest {
  std::string result;
  std::string title;
};

struct PanelRequest {
  std::string y_label;
  double y_factor = 1.0;
  std::vector<LineRequest> lines;
};

struct PictureRequest {
  enum class Kind {
    lines,       ///< results over the values of a key
    patches,     ///< maps of pressures, one a scene and side
    connections, ///< points of both profiles that touch, joined
    conicity     ///< rolling radius difference, contact angles and equivalent conicity
  };

  std::string file; ///< beside the results
  Kind kind = Kind::lines;
  std::string title;
  std::string x; ///< key of the axis to the right; patches: of the columns
  std::string x_label;
  double x_factor = 1.0;
  std::string series;       ///< key with a line, or a row of maps, for each value; empty: none
  std::string series_label; ///< {} stands for the value
  std::vector<std::string> sides; ///< patches, connections: "left", "right"
  std::vector<double> x_values;   ///< those drawn; empty: all
  double pressure_max = 0.0;      ///< patches: of the darkest colour, MPa; 0: the largest there is
  Values where;                   ///< which scenes are drawn
  std::vector<PanelRequest> panels;
};

} // namespace driver
