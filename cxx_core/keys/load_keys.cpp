// Keys of loads: on the normal pressures, on all contact forces of a wheel, along the normal.
#include "keys/key_makers.hpp"
#include "keys/scene_key_table.hpp"

namespace wrc {
namespace {

using namespace dimensions;
using namespace key_makers;

using Sides = std::vector<SceneSide Scene::*>;

constexpr Range range{0.0, 1e12};

/// The load on the pressures of one or both wheels.
Key load_key(std::string_view name, std::string_view meaning, const Sides& sides) {
  Key key = number_key({name, "80000.0", "0 to 1e12 N", meaning}, range, pure,
                       place_of(sides.front(), &SceneSide::load),
                       place_of(sides.back(), &SceneSide::load));
  key.set_number = [sides, set = key.set_number](Scene& scene, double value) {
    set(scene, value);
    scene.normal_load.reset();
    for (SceneSide Scene::*side : sides) {
      (scene.*side).total_load.reset();
    }
  };
  return key;
}

/// The total load of one or both wheels, or none.
Key total_key(std::string_view name, std::string_view meaning, const Sides& sides) {
  Key key;
  key.description = {name, "\"none\"", "\"none\" or 0 to 1e12 N", meaning};
  key.min = range.min;
  key.max = range.max;
  key.get = [sides](const Scene& scene) {
    const std::optional<double>& total = (scene.*sides.front()).total_load;
    if (total != (scene.*sides.back()).total_load) {
      return KeyValue();
    }
    return total ? KeyValue(*total) : KeyValue(std::string("none"));
  };
  key.set_number = [sides](Scene& scene, double value) {
    for (SceneSide Scene::*side : sides) {
      (scene.*side).total_load = value;
    }
    scene.normal_load.reset();
  };
  key.set_text = [sides](Scene& scene, std::string_view value) {
    for (SceneSide Scene::*side : value == "none" ? sides : Sides{}) {
      (scene.*side).total_load.reset();
    }
    return value == "none";
  };
  return key;
}

} // namespace

std::vector<Key> make_load_keys() {
  const Sides both{&Scene::left, &Scene::right};
  Key normal = optional_key(
      {"load.normal", "\"none\"", "\"none\" or 0 to 1e12 N",
       "replaces load.vertical: force on each wheel in the direction of the force on the "
       "patch of first touch; with solve.gap = \"vertical\" along the gap (as in the paper)"},
      range, pure, &Scene::normal_load, "none");
  normal.set_number = [set = normal.set_number](Scene& scene, double value) {
    set(scene, value);
    scene.left.total_load.reset();
    scene.right.total_load.reset();
  };
  return {
      load_key("load.vertical",
               "vertical force that the normal pressures of each wheel carry; creep forces on an "
               "inclined plane add to it",
               both),
      load_key("load.left", "vertical force that the normal pressures of the left wheel carry",
               {&Scene::left}),
      load_key("load.right", "vertical force that the normal pressures of the right wheel carry",
               {&Scene::right}),
      normal,
      total_key("load.total_vertical",
                "replaces load.vertical: vertical force that all contact forces of each wheel "
                "carry, creep forces "
                "included; the load on the pressures is solved for",
                both),
      total_key(
          "load.total_left",
          "replaces load.left: vertical force that all contact forces of the left wheel carry",
          {&Scene::left}),
      total_key(
          "load.total_right",
          "replaces load.right: vertical force that all contact forces of the right wheel carry",
          {&Scene::right}),
  };
}

} // namespace wrc
