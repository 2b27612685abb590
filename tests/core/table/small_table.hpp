/// A table that is made in a second, for all tests of this room.
#pragma once

#include "keys/scene.hpp"
#include "table/table_build.hpp"

namespace wrc::test {

inline Scene scene_of_small_table() {
  Scene scene;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  return scene;
}

inline TableOptions options_of_small_table() {
  TableOptions options;
  options.ranges = {1.0, 0.003, 0.01, 120000.0};
  options.fineness = 0.2;
  return options;
}

inline const ContactTable& small_table() {
  static const ContactTable table =
      build_table(scene_of_small_table(), options_of_small_table(), SceneSolver());
  return table;
}

} // namespace wrc::test
