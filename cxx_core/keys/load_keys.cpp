// Keys of loads: how large, and which forces carry them.
#include "keys/key_makers.hpp"
#include "keys/scene_key_table.hpp"

namespace wrc {

using namespace dimensions;
using namespace key_makers;

std::vector<Key> make_load_keys() {
  constexpr Range range{0.0, 1e12};
  const auto left = place_of(&Scene::left, &SceneSide::load);
  const auto right = place_of(&Scene::right, &SceneSide::load);
  return {
      number_key({"load.both", "80000.0", "0 to 1e12 N",
                  "load of each wheel; load.of selects what carries it"},
                 range, force, left, right),
      number_key({"load.left", "80000.0", "0 to 1e12 N", "load of the left wheel"}, range, force,
                 left),
      number_key({"load.right", "80000.0", "0 to 1e12 N", "load of the right wheel"}, range, force,
                 right),
      word_key<LoadOf>(
          {"load.of", "\"pressures\"", "\"pressures\", \"total\" or \"normal\"",
           "what carries the load; pressures: their vertical force, to which creep forces on an "
           "inclined plane add; total: the vertical force of all contact forces, creep forces "
           "included; normal: the force of the pressures in the direction of that on the patch of "
           "first touch, with solve.method = \"paper\" along the gap"},
          {{"pressures", LoadOf::pressures}, {"total", LoadOf::total}, {"normal", LoadOf::normal}},
          &Scene::load_of),
  };
}

} // namespace wrc
