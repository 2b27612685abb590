#include "keys/scene_key_table.hpp"

#include <algorithm>
#include <cmath>

#include "keys/key_makers.hpp"

namespace wrc {
namespace {

using namespace dimensions;
using namespace key_makers;

std::vector<Key> convention_keys() {
  std::vector<Key> keys;
  keys.push_back(word_key<Units>(
      {"convention.units", "\"mm\"", "\"mm\" or \"SI\"",
       "units of all numbers set or returned by later calls: mm, N, MPa, rad or m, N, Pa, rad"},
      {{"mm", Units::mm}, {"SI", Units::si}}, [](auto& s) -> auto& { return s.convention.units; }));
  keys.push_back(word_key<TrackFrame>(
      {"convention.frame", "\"left-up\"", "\"left-up\" or \"right-down\"",
       "frame of all numbers set or returned by later calls: x forward, y left, z up; or x "
       "forward, y right, z down"},
      {{"left-up", TrackFrame::left_up}, {"right-down", TrackFrame::right_down}},
      [](auto& s) -> auto& { return s.convention.frame; }));
  return keys;
}

constexpr std::string_view yield_range =
    "\"none\", 100 to 1e4 MPa, or one of \"ER6\" to \"ER9\", \"R200\", \"R220\", \"R260\", "
    "\"R320Cr\", \"R350HT\", \"R370CrHT\", \"R400HT\"";

/// A whole number from 1 on.
Key count_key(const KeyDescription& description, double most, int Scene::*place) {
  Key key;
  key.description = description;
  key.min = 1.0;
  key.max = most;
  key.whole = true;
  key.get = [place](const Scene& s) { return KeyValue(static_cast<double>(s.*place)); };
  key.set_number = [place](Scene& s, double v) { s.*place = static_cast<int>(v); };
  return key;
}

Key yield_key(const KeyDescription& description, Steel Scene::*place) {
  Key key = optional_key(
      description, {100.0, 1e4},
      stress, [place](auto& scene) -> auto& { return (scene.*place).yield_stress; }, "none");
  key.set_number = [place](Scene& scene, double value) { scene.*place = {value, {}}; };
  key.set_text = [place](Scene& scene, std::string_view value) {
    const std::optional<Steel> found = value == "none" ? Steel{} : steel_of_grade(value);
    if (found) {
      scene.*place = *found;
    }
    return found.has_value();
  };
  return key;
}

std::vector<Key> material_keys() {
  constexpr std::string_view modulus_range = "1 to 1e9 MPa";
  constexpr std::string_view poisson_range = "0 to 0.5";
  const auto wheel_modulus = [](auto& s) -> auto& {
    return s.wheel_material.youngs_modulus;
  };
  const auto rail_modulus = [](auto& s) -> auto& {
    return s.rail_material.youngs_modulus;
  };
  const auto wheel_poisson = [](auto& s) -> auto& {
    return s.wheel_material.poisson;
  };
  const auto rail_poisson = [](auto& s) -> auto& {
    return s.rail_material.poisson;
  };
  const auto modulus = [&](std::string_view name, std::string_view meaning, auto... places) {
    return number_key({name, "210000.0", modulus_range, meaning}, {1.0, 1e9}, stress, places...);
  };
  const auto poisson = [&](std::string_view name, std::string_view meaning, auto... places) {
    return number_key({name, "0.3", poisson_range, meaning}, {0.0, 0.5}, pure, places...);
  };
  return {
      modulus("material.youngs_modulus", "Young's modulus of wheel and rail", wheel_modulus,
              rail_modulus),
      poisson("material.poisson", "Poisson's ratio of wheel and rail", wheel_poisson, rail_poisson),
      modulus("material.wheel.youngs_modulus", "Young's modulus of the wheel alone", wheel_modulus),
      poisson("material.wheel.poisson", "Poisson's ratio of the wheel alone", wheel_poisson),
      yield_key({"material.wheel.yield_stress", "\"none\"", yield_range,
                 "yield stress of the wheel's steel, by number or by the name of its grade; none: "
                 "it stays elastic"},
                &Scene::wheel_steel),
      modulus("material.rail.youngs_modulus", "Young's modulus of the rail alone", rail_modulus),
      poisson("material.rail.poisson", "Poisson's ratio of the rail alone", rail_poisson),
      yield_key({"material.rail.yield_stress", "\"none\"", yield_range,
                 "yield stress of the rail's steel, by number or by the name of its grade; none: "
                 "it stays elastic"},
                &Scene::rail_steel)};
}

std::vector<Key> pose_keys() {
  std::vector<Key> keys;
  keys.push_back(number_key({"pose.lateral", "0.0", "-1e4 to 1e4 mm",
                             "displacement of the wheelset's centre to the left"},
                            {-1e4, 1e4}, turning_length, &Scene::lateral));
  keys.push_back(
      number_key({"pose.longitudinal", "0.0", "-1e9 to 1e9 mm",
                  "position of the wheelset's centre along the track, from the origin of "
                  "the slices of a rail that varies; no effect on other rails"},
                 {-1e9, 1e9}, length, &Scene::along));
  keys.push_back(
      number_key({"pose.pitch", "0.0", "-1e9 to 1e9 rad",
                  "angle by which the wheelset has turned about its axle, positive when it rolls "
                  "forwards; of a wheel that varies the slice at this angle points down; "
                  "no effect on other wheels"},
                 {-1e9, 1e9}, angle, &Scene::pitch));
  keys.push_back(
      number_key({"pose.yaw", "0.0", "-0.2 to 0.2 rad", "yaw, anticlockwise seen from above"},
                 {-0.2, 0.2}, turning_angle, &Scene::yaw));
  Key roll = optional_key({"pose.roll", "\"solve\"", "\"solve\", \"en15302\" or -0.2 to 0.2 rad",
                           "roll, positive lifts the left wheel; solve: both wheels touch; "
                           "en15302: no roll, each wheel separately"},
                          {-0.2, 0.2}, angle, &Scene::roll, "solve");
  roll.set_text = [solve = roll.set_text](Scene& s, std::string_view v) {
    if (v == "en15302") {
      s.roll = 0.0;
    }
    return v == "en15302" || solve(s, v);
  };
  keys.push_back(roll);
  keys.push_back(optional_key({"pose.vertical", "\"solve\"", "\"solve\" or -1e4 to 2e4 mm",
                               "height of the wheelset's centre above the rail tops; a number "
                               "prescribes the position, and forces are results"},
                              {-1e4, 2e4}, turning_length, &Scene::vertical, "solve"));
  return keys;
}

constexpr double max_count = 8192.0;
constexpr std::string_view by_accuracy = "by accuracy";

Key grid_key() {
  Key key;
  key.description = {"solve.grid", "\"by accuracy\"",
                     "[lateral, longitudinal], each 1 to 8192, or \"by accuracy\"",
                     "number of elements of the potential contact area, instead of an accuracy"};
  key.get = [](const Scene& scene) {
    return scene.grid ? KeyValue(std::vector<double>{static_cast<double>((*scene.grid)[0]),
                                                     static_cast<double>((*scene.grid)[1])})
                      : KeyValue(std::string(by_accuracy));
  };
  key.set_text = [](Scene& scene, std::string_view value) {
    if (value == by_accuracy) {
      scene.grid.reset();
    }
    return value == by_accuracy;
  };
  key.set_numbers = [](Scene& scene, std::span<const double> counts) {
    const auto permitted = [](double count) {
      return count >= 1.0 && count <= max_count && count == std::floor(count);
    };
    if (counts.size() != 2 || !std::all_of(counts.begin(), counts.end(), permitted)) {
      return false;
    }
    scene.grid = {{static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[1])}};
    return true;
  };
  return key;
}

/// As the paper does all three.
Key method_key() {
  Key key = word_key<SolverChoice>(
      {"solve.method", "\"auto\"", "\"auto\" or \"paper\"",
       "method of the half-space; paper, for comparison: gaps in the vertical direction, elements "
       "of constant pressure, and the iteration of Polonsky & Keer 1999 in double precision"},
      {{"auto", SolverChoice::standard}, {"paper", SolverChoice::paper}}, &Scene::solver);
  key.set_text = [set = key.set_text](Scene& scene, std::string_view value) {
    if (!set(scene, value)) {
      return false;
    }
    const bool paper = scene.solver == SolverChoice::paper;
    scene.gap = paper ? GapConvention::vertical : GapConvention::tangent;
    scene.elements = paper ? Elements::constant : Elements::smooth;
    return true;
  };
  return key;
}

std::vector<Key> method_keys() {
  std::vector<Key> keys;
  keys.push_back(word_key<SideChoice>(
      {"solve.side", "\"both\"", "\"both\", \"left\" or \"right\"", "wheels to solve"},
      {{"both", SideChoice::both}, {"left", SideChoice::left}, {"right", SideChoice::right}},
      &Scene::side));
  keys.push_back(word_key<Module>(
      {"solve.until", "\"mechanics\"", "\"geometry\", \"remesh\" or \"mechanics\"",
       "the last module to run: geometry gives contact points; remesh patches, grids and "
       "undeformed distances; mechanics pressures"},
      {{"geometry", Module::geometry},
       {"remesh", Module::remesh},
       {"mechanics", Module::mechanics}},
      &Scene::until));
  keys.push_back(method_key());
  keys.push_back(word_key<CurvedChoice>(
      {"solve.curved", "\"no\"", "\"no\", \"yes\" or \"auto\"",
       "whether contacts of the half-space are solved along the mean curve of wheel and rail "
       "instead of in a plane; auto: where the error of a plane would come near solve.accuracy"},
      {{"no", CurvedChoice::no}, {"yes", CurvedChoice::yes}, {"auto", CurvedChoice::by_accuracy}},
      &Scene::curved));
  keys.push_back(word_key<ModelRequest>(
      {"solve.model", "\"auto\"", "\"auto\", \"half-space\", \"hertz\" or \"kik-piotrowski\"",
       "contact model; auto chooses the half-space"},
      {{"auto", ModelRequest::automatic},
       {"half-space", ModelRequest::half_space},
       {"hertz", ModelRequest::hertz},
       {"kik-piotrowski", ModelRequest::kik_piotrowski}},
      &Scene::model));
  return keys;
}

std::vector<Key> accuracy_keys() {
  std::vector<Key> keys;
  keys.push_back(word_key<AccuracyOf>(
      {"solve.accuracy_of", "\"pressures\"", "\"pressures\" or \"forces\"",
       "results that solve.accuracy applies to; forces: vertical approach, forces, moments and "
       "their points of action; pressures: also the maximum pressure"},
      {{"pressures", AccuracyOf::pressures}, {"forces", AccuracyOf::forces}}, &Scene::accuracy_of));
  Key accuracy = number_key({"solve.accuracy", "1e-3", "1e-5 to 0.1",
                             "requested relative accuracy of the results selected by "
                             "solve.accuracy_of; determines the grid"},
                            {1e-5, 0.1}, pure, &Scene::accuracy);
  accuracy.set_number = [](Scene& s, double v) {
    s.accuracy = v;
    s.grid.reset();
  };
  keys.push_back(accuracy);
  keys.push_back(grid_key());
  keys.push_back(number_key(
      {"solve.tolerance", "1e-5", "1e-13 to 0.1",
       "tolerance of the iteration on a given solve.grid: largest error of a "
       "pressure relative to the maximum pressure (with solve.method = \"paper\" of a gap); "
       "without solve.grid it follows from the accuracy"},
      {1e-13, 0.1}, pure, &Scene::tolerance));
  Key limit = optional_key(
      {"solve.element_limit", "\"auto\"", "\"auto\" or a whole number, 1000 to 67108864",
       "largest number of elements that an accuracy may use for all patches of a "
       "wheel together, and for their creep forces; auto: 16000 at 1e-2 and above, "
       "50000 at 1e-3, at most 100000; if it needs more, elements are larger and a "
       "warning says so; solve.grid has no limit"},
      {1e3, 67108864.0}, pure, &Scene::element_limit, "auto");
  limit.whole = true;
  keys.push_back(limit);
  return keys;
}

std::vector<Key> solution_keys() {
  std::vector<Key> keys;
  keys.push_back(
      number_key({"solve.joining_distance", "4", "0 to 100 mm",
                  "penetrations closer than twice this distance share a plane and count as one "
                  "contact, unless their angles differ greatly; 0: only their widths decide"},
                 {0.0, 100.0}, length, &Scene::joining_distance));
  keys.push_back(number_key(
      {"solve.near_tolerance", "0.1", "0 to 10 mm",
       "further contacts are listed if their distance at first touch is smaller than this"},
      {0.0, 10.0}, length, &Scene::near_tolerance));
  keys.push_back(
      count_key({"solve.passes", "1", "a whole number, 1 to 1000",
                 "how often the wheel has rolled over the same place of the rail, this time "
                 "included; where steel yields, both keep the groove of earlier passes"},
                1000.0, &Scene::passes));
  keys.push_back(count_key({"solve.threads", "1", "a whole number, 1 to 1024",
                            "number of threads; results do not depend on it"},
                           1024.0, &Scene::threads));
  return keys;
}

} // namespace

std::vector<Key> make_scene_keys() {
  std::vector<Key> collected;
  for (auto* part : {convention_keys, make_track_keys, make_wheelset_keys, material_keys, pose_keys,
                     make_load_keys, make_rolling_keys, method_keys, accuracy_keys, solution_keys,
                     make_damage_keys}) {
    for (Key& key : part()) {
      collected.push_back(std::move(key));
    }
  }
  return collected;
}

} // namespace wrc
