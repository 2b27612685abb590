#include "scene/scene_keys.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <utility>

#include "base/error.hpp"

namespace wrc {
namespace {

using namespace dimensions;

struct Key {
  KeyDescription description;
  Dimension dimension;
  double least = 0.0; ///< range of a number in mm, y left, z up, ends included
  double greatest = 0.0;
  bool whole = false; ///< whole numbers only
  /// Numbers in mm, y left, z up. Setting returns false for what is not permitted.
  std::function<KeyValue(const Scene&)> get;
  std::function<void(Scene&, double)> set_number;
  std::function<bool(Scene&, std::string_view)> set_text;
  std::function<bool(Scene&, std::span<const double>)> set_numbers;
};

struct Range {
  double least;
  double greatest;
};

/// A number with one place in the scene; `place` takes scenes that are const and others.
template <class Place>
Key number_key(KeyDescription description, Range range, Dimension dimension, Place place) {
  Key key;
  key.description = description;
  key.dimension = dimension;
  key.least = range.least;
  key.greatest = range.greatest;
  key.get = [place](const Scene& scene) { return KeyValue(place(scene)); };
  key.set_number = [place](Scene& scene, double value) { place(scene) = value; };
  return key;
}

/// A number that is held in two places, of wheel and rail or left and right.
template <class Place, class Other>
Key number_key(KeyDescription description, Range range, Dimension dimension, Place place,
               Other other) {
  Key key = number_key(description, range, dimension, place);
  key.get = [place, other](const Scene& scene) {
    return place(scene) == other(scene) ? KeyValue(place(scene)) : KeyValue();
  };
  key.set_number = [place, other](Scene& scene, double value) {
    place(scene) = value;
    other(scene) = value;
  };
  return key;
}

/// A word for each value of a place.
template <class Value, class Place>
Key word_key(KeyDescription description, std::vector<std::pair<std::string_view, Value>> words,
             Place place) {
  Key key;
  key.description = description;
  key.get = [words, place](const Scene& scene) {
    const auto found = std::find_if(words.begin(), words.end(),
                                    [&](const auto& word) { return word.second == place(scene); });
    return KeyValue(std::string(found->first));
  };
  key.set_text = [words, place](Scene& scene, std::string_view value) {
    const auto found = std::find_if(words.begin(), words.end(),
                                    [value](const auto& word) { return word.first == value; });
    if (found != words.end()) {
      place(scene) = found->second;
    }
    return found != words.end();
  };
  return key;
}

using StringWords = std::vector<std::pair<std::string_view, std::string>>;

/// The name of a profile, which takes the place of a profile given by hand.
Key profile_key(KeyDescription description, std::string Scene::*name,
                std::shared_ptr<const Profile> Scene::*profile) {
  Key key;
  key.description = description;
  key.get = [name](const Scene& scene) { return KeyValue(scene.*name); };
  key.set_text = [name, profile](Scene& scene, std::string_view value) {
    if (value.empty()) {
      return false;
    }
    scene.*name = value; // may fail for want of memory: first
    (scene.*profile).reset();
    return true;
  };
  return key;
}

/// A number that a word unsets.
Key optional_key(KeyDescription description, Range range, Dimension dimension,
                 std::optional<double> Scene::*member, std::string_view word) {
  Key key;
  key.description = description;
  key.dimension = dimension;
  key.least = range.least;
  key.greatest = range.greatest;
  key.get = [member, word](const Scene& scene) {
    return scene.*member ? KeyValue(*(scene.*member)) : KeyValue(std::string(word));
  };
  key.set_number = [member](Scene& scene, double value) { scene.*member = value; };
  key.set_text = [member, word](Scene& scene, std::string_view value) {
    if (value == word) {
      (scene.*member).reset();
    }
    return value == word;
  };
  return key;
}

/// "1:n" as the angle atan(1/n).
bool parse_cant(std::string_view text, double& cant) {
  const bool negative = text.starts_with('-');
  if (negative) {
    text.remove_prefix(1);
  }
  if (!text.starts_with("1:")) {
    return false;
  }
  text.remove_prefix(2);
  double n = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), n);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || !(n >= 5.0) ||
      !std::isfinite(n)) {
    return false;
  }
  cant = (negative ? -1.0 : 1.0) * std::atan(1.0 / n);
  return true;
}

std::vector<Key> convention_keys() {
  std::vector<Key> keys;
  keys.push_back(word_key<Units>(
      {"convention.units", "\"mm\"", "\"mm\" or \"SI\"",
       "units of all numbers set and told after this: mm, N, MPa, rad "
       "or m, N, Pa, rad"},
      {{"mm", Units::mm}, {"SI", Units::si}}, [](auto& s) -> auto& { return s.convention.units; }));
  keys.push_back(word_key<TrackFrame>(
      {"convention.frame", "\"left-up\"", "\"left-up\" or \"right-down\"",
       "frame of all numbers set and told after this: x forward, y left, z up or x forward, y "
       "right, z down"},
      {{"left-up", TrackFrame::left_up}, {"right-down", TrackFrame::right_down}},
      [](auto& s) -> auto& { return s.convention.frame; }));
  return keys;
}

std::vector<Key> track_keys() {
  std::vector<Key> keys;
  keys.push_back(number_key(
      {"track.gauge", "1435.0", "600 to 1700 mm",
       "distance of the gauge faces at the gauge height"},
      {600.0, 1700.0}, length, [](auto& s) -> auto& { return s.track.gauge; }));
  keys.push_back(number_key(
      {"track.gauge_height", "14.0", "1 to 30 mm",
       "where the gauge is measured, below the top of the inclined rail"},
      {1.0, 30.0}, length, [](auto& s) -> auto& { return s.track.gauge_height; }));
  Key cant = number_key(
      {"track.cant", "\"1:40\"", "\"1:n\" or \"-1:n\" with n >= 5, or -0.2 to 0.2 rad",
       "inclination of the rails towards the track centre"},
      {-0.2, 0.2}, pure, [](auto& s) -> auto& { return s.track.cant; });
  cant.set_text = [](Scene& s, std::string_view v) { return parse_cant(v, s.track.cant); };
  keys.push_back(cant);
  keys.push_back(profile_key(
      {"track.rail", "\"60E1\"", "a text: a built-in rail or a profile file", "rail profile"},
      &Scene::rail, &Scene::rail_profile));
  keys.push_back(number_key(
      {"track.rail_smoothing", "0.0", "0 (none) to 100 mm",
       "smoothing wavelength of a rail profile read from a file"},
      {0.0, 100.0}, length, [](auto& s) -> auto& { return s.rail_smoothing; }));
  return keys;
}

std::vector<Key> wheelset_keys() {
  std::vector<Key> keys;
  keys.push_back(profile_key({"wheelset.wheel", "\"S1002\"",
                              "a text: a built-in wheel or a profile file", "wheel profile"},
                             &Scene::wheel, &Scene::wheel_profile));
  keys.push_back(number_key(
      {"wheelset.wheel_smoothing", "0.0", "0 (none) to 100 mm",
       "smoothing wavelength of a wheel profile read from a file"},
      {0.0, 100.0}, length, [](auto& s) -> auto& { return s.wheel_smoothing; }));
  keys.push_back(number_key(
      {"wheelset.back_to_back", "1360.0", "500 to 1650 mm",
       "distance of the inner faces of the wheels"},
      {500.0, 1650.0}, length, [](auto& s) -> auto& { return s.wheelset.back_to_back; }));
  keys.push_back(number_key(
      {"wheelset.tape_offset", "70.0", "20 to 120 mm",
       "distance from the inner face to the taping line"},
      {20.0, 120.0}, length, [](auto& s) -> auto& { return s.wheelset.tape_offset; }));
  keys.push_back(number_key(
      {"wheelset.radius", "460.0", "50 to 5000 mm", "nominal rolling radius, at the taping line"},
      {50.0, 5000.0}, length, [](auto& s) -> auto& { return s.wheelset.radius; }));
  return keys;
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
      modulus("material.rail.youngs_modulus", "Young's modulus of the rail alone", rail_modulus),
      poisson("material.rail.poisson", "Poisson's ratio of the rail alone", rail_poisson)};
}

std::vector<Key> pose_keys() {
  std::vector<Key> keys;
  keys.push_back(number_key(
      {"pose.lateral", "0.0", "-100 to 100 mm",
       "displacement of the wheelset's centre to the left"},
      {-100.0, 100.0}, turning_length, [](auto& s) -> auto& { return s.lateral; }));
  keys.push_back(number_key(
      {"pose.yaw", "0.0", "-0.2 to 0.2 rad", "anticlockwise seen from above"}, {-0.2, 0.2},
      turning_angle, [](auto& s) -> auto& { return s.yaw; }));
  Key roll = optional_key({"pose.roll", "\"solve\"", "\"solve\", \"en15302\" or -0.2 to 0.2 rad",
                           "lifts the left wheel; solved: both wheels touch; en15302: none, each "
                           "wheel by itself"},
                          {-0.2, 0.2}, pure, &Scene::roll, "solve");
  roll.set_text = [solve = roll.set_text](Scene& s, std::string_view v) {
    if (v == "en15302") {
      s.roll = 0.0;
    }
    return v == "en15302" || solve(s, v);
  };
  keys.push_back(roll);
  keys.push_back(optional_key({"pose.vertical", "\"solve\"", "\"solve\" or 0 to 6000 mm",
                               "height of the wheelset's centre above the rail tops; a number "
                               "prescribes the position, and forces come out"},
                              {0.0, 6000.0}, turning_length, &Scene::vertical, "solve"));
  return keys;
}

std::vector<Key> load_keys() {
  constexpr Range range{0.0, 1e12};
  constexpr std::string_view allowed = "0 to 1e12 N";
  const auto left = [](auto& s) -> auto& {
    return s.left_load;
  };
  const auto right = [](auto& s) -> auto& {
    return s.right_load;
  };
  std::vector<Key> keys{
      number_key({"load.vertical", "80000.0", allowed, "vertical force on each wheel"}, range, pure,
                 left, right),
      number_key({"load.left", "80000.0", allowed, "vertical force on the left wheel"}, range, pure,
                 left),
      number_key({"load.right", "80000.0", allowed, "vertical force on the right wheel"}, range,
                 pure, right)};
  for (Key& key : keys) {
    key.set_number = [set = key.set_number](Scene& s, double v) {
      set(s, v);
      s.normal_load.reset();
    };
  }
  keys.push_back(optional_key({"load.normal", "\"none\"", "\"none\" or 0 to 1e12 N",
                               "instead: force along the gap's direction on each wheel (the "
                               "paper)"},
                              range, pure, &Scene::normal_load, "none"));
  return keys;
}

constexpr double max_count = 8192.0;
constexpr std::string_view by_accuracy = "by accuracy";

Key grid_key() {
  Key key;
  key.description = {"solve.grid", "\"by accuracy\"",
                     "[lateral, longitudinal], each 1 to 8192, or \"by accuracy\"",
                     "number of elements of the potential contact area, by hand"};
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

std::vector<Key> solve_keys() {
  std::vector<Key> keys;
  keys.push_back(word_key<SideChoice>(
      {"solve.side", "\"both\"", "\"both\", \"left\" or \"right\"", "wheels to solve"},
      {{"both", SideChoice::both}, {"left", SideChoice::left}, {"right", SideChoice::right}},
      [](auto& s) -> auto& { return s.side; }));
  keys.push_back(word_key<Module>(
      {"solve.until", "\"mechanics\"", "\"geometry\", \"remesh\" or \"mechanics\"",
       "the last module to run: contact points; patches, grids and undeformed distances; "
       "pressures"},
      {{"geometry", Module::geometry},
       {"remesh", Module::remesh},
       {"mechanics", Module::mechanics}},
      [](auto& s) -> auto& { return s.until; }));
  keys.push_back(word_key<GapConvention>(
      {"solve.gap", "\"tangent\"", "\"tangent\" or \"vertical\"",
       "direction in which distances are measured; vertical as in the paper"},
      {{"tangent", GapConvention::tangent}, {"vertical", GapConvention::vertical}},
      [](auto& s) -> auto& { return s.gap; }));
  keys.push_back(word_key(
      {"solve.model", "\"auto\"", "\"auto\", \"half-space\", \"hertz\" or \"kik-piotrowski\"",
       "contact model; auto takes the half-space"},
      StringWords{{"auto", "auto"},
                  {"half-space", "half-space"},
                  {"hertz", "hertz"},
                  {"kik-piotrowski", "kik-piotrowski"}},
      [](auto& s) -> auto& { return s.model; }));
  keys.push_back(word_key(
      {"solve.solver", "\"default\"", "\"default\" or \"paper\"",
       "solver of the half-space: paper is Polonsky & Keer 1999, for comparison"},
      StringWords{{"default", "default"}, {"paper", "paper"}},
      [](auto& s) -> auto& { return s.solver; }));
  keys.push_back(word_key<std::optional<Elements>>(
      {"solve.elements", "\"auto\"", "\"auto\", \"smooth\" or \"constant\"",
       "pressure on an element: smooth through the values at the centres, for more accuracy; or "
       "constant on each, as other programs have it and solver paper in auto"},
      {{"auto", std::nullopt}, {"smooth", Elements::smooth}, {"constant", Elements::constant}},
      [](auto& s) -> auto& { return s.elements; }));
  keys.push_back(word_key<AccuracyOf>(
      {"solve.accuracy_of", "\"pressures\"", "\"pressures\" or \"forces\"",
       "what solve.accuracy is of: forces are depth, forces, moments and their place; pressures "
       "the "
       "largest pressure as well"},
      {{"pressures", AccuracyOf::pressures}, {"forces", AccuracyOf::forces}},
      [](auto& s) -> auto& { return s.accuracy_of; }));
  Key accuracy = number_key(
      {"solve.accuracy", "1e-3", "1e-5 to 0.1",
       "requested relative error of what solve.accuracy_of names; chooses the grid"},
      {1e-5, 0.1}, pure, [](auto& s) -> auto& { return s.accuracy; });
  accuracy.set_number = [](Scene& s, double v) {
    s.accuracy = v;
    s.grid.reset();
  };
  keys.push_back(accuracy);
  keys.push_back(grid_key());
  keys.push_back(number_key(
      {"solve.tolerance", "1e-5", "1e-13 to 0.1",
       "of the iteration on a grid given by hand: largest error of a pressure "
       "relative to the largest (solver paper: of the gaps); else it follows "
       "from the accuracy"},
      {1e-13, 0.1}, pure, [](auto& s) -> auto& { return s.tolerance; }));
  keys.push_back(word_key<Precision>(
      {"solve.precision", "\"mixed\"", "\"mixed\" or \"double\"",
       "of the iteration; mixed is faster and meets the same tolerance"},
      {{"mixed", Precision::mixed}, {"double", Precision::double_only}},
      [](auto& s) -> auto& { return s.precision; }));
  keys.push_back(word_key<PlannerRigor>(
      {"solve.planner", "\"estimate\"", "\"estimate\" or \"measure\"",
       "how FFTW chooses its algorithms: by rule, or by trying them once"},
      {{"estimate", PlannerRigor::estimate}, {"measure", PlannerRigor::measure}},
      [](auto& s) -> auto& { return s.planner; }));
  keys.push_back(word_key<bool>(
      {"solve.interaction", "\"near\"", "\"near\" or \"all\"",
       "which patches of a wheel feel each other elastically: those "
       "that are close, or all, as if in one plane"},
      {{"near", false}, {"all", true}}, [](auto& s) -> auto& { return s.interaction; }));
  keys.push_back(number_key(
      {"solve.joining_distance", "4", "0 to 100 mm",
       "patches whose penetrations are closer than twice this share one plane and are one contact, "
       "unless their angles differ much; 0: by their own widths alone"},
      {0.0, 100.0}, length, [](auto& s) -> auto& { return s.joining_distance; }));
  keys.push_back(number_key(
      {"solve.near_tolerance", "0.1", "0 to 10 mm",
       "further contacts listed whose distance is less at the first touch"},
      {0.0, 10.0}, length, [](auto& s) -> auto& { return s.near_tolerance; }));
  Key threads;
  threads.description = {"solve.threads", "1", "a whole number, 1 to 1024",
                         "threads; the result does not depend on them"};
  threads.least = 1.0;
  threads.greatest = 1024.0;
  threads.whole = true;
  threads.get = [](const Scene& s) { return KeyValue(static_cast<double>(s.threads)); };
  threads.set_number = [](Scene& s, double v) { s.threads = static_cast<int>(v); };
  keys.push_back(threads);
  return keys;
}

const std::vector<Key>& keys() {
  static const std::vector<Key> all = [] {
    std::vector<Key> collected;
    for (auto* part : {convention_keys, track_keys, wheelset_keys, material_keys, pose_keys,
                       load_keys, solve_keys}) {
      for (Key& key : part()) {
        collected.push_back(std::move(key));
      }
    }
    return collected;
  }();
  return all;
}

const Key& find_key(std::string_view name) {
  const auto found = std::find_if(keys().begin(), keys().end(),
                                  [name](const Key& key) { return key.description.name == name; });
  if (found == keys().end()) {
    std::string text = "unknown key " + std::string(name) + "; known keys:";
    for (const Key& key : keys()) {
      text += ' ';
      text += key.description.name;
    }
    throw Error(ErrorCode::unknown_name, text);
  }
  return *found;
}

[[noreturn]] void refuse(const Key& key, const std::string& value) {
  throw_invalid_argument(std::string(key.description.name), value,
                         "allowed is " + std::string(key.description.allowed));
}

/// Ranges are told in mm, y left, z up: so is the value then.
[[noreturn]] void refuse_number(const Key& key, const Convention& convention, double given,
                                double inside) {
  if (convention == Convention{} || key.dimension.quantity == pure.quantity) {
    refuse(key, text_of(given));
  }
  refuse(key, text_of(given) + " (in mm, N, MPa, y left, z up: " + text_of(inside) + ')');
}

} // namespace

std::span<const KeyDescription> scene_keys() {
  static const std::vector<KeyDescription> descriptions = [] {
    std::vector<KeyDescription> all;
    for (const Key& key : keys()) {
      all.push_back(key.description);
    }
    return all;
  }();
  return descriptions;
}

KeyValue key_value(const Scene& scene, std::string_view name) {
  const Key& key = find_key(name);
  KeyValue value = key.get(scene);
  if (double* number = std::get_if<double>(&value)) {
    *number = to_caller(*number, scene.convention, key.dimension);
  }
  return value;
}

void set_number(Scene& scene, std::string_view name, double value) {
  const Key& key = find_key(name);
  const double inside = from_caller(value, scene.convention, key.dimension);
  const bool permitted =
      inside >= key.least && inside <= key.greatest && (!key.whole || inside == std::floor(inside));
  if (!key.set_number || !permitted) {
    refuse_number(key, scene.convention, value, inside);
  }
  key.set_number(scene, inside);
}

void set_text(Scene& scene, std::string_view name, std::string_view value) {
  const Key& key = find_key(name);
  if (!key.set_text || !key.set_text(scene, value)) {
    refuse(key, '"' + std::string(value) + '"');
  }
}

void set_numbers(Scene& scene, std::string_view name, std::span<const double> values) {
  const Key& key = find_key(name);
  if (!key.set_numbers || !key.set_numbers(scene, values)) {
    // Of a list of any length only the start is read.
    constexpr std::size_t most_named = 4;
    std::string text = "[";
    for (const double value : values.first(std::min(values.size(), most_named))) {
      text += (text.size() > 1 ? ", " : "") + text_of(value);
    }
    refuse(key, text + (values.size() > most_named
                            ? ", ...], " + std::to_string(values.size()) + " values"
                            : "]"));
  }
}

void set_profile(Scene& scene, std::string_view name, const Profile& profile) {
  const Key& key = find_key(name);
  const bool is_wheel = name == "wheelset.wheel";
  const ProfileKind kind = is_wheel ? ProfileKind::wheel : ProfileKind::rail;
  if ((!is_wheel && name != "track.rail") || profile.kind != kind) {
    throw_invalid_argument(std::string(name), "profile \"" + profile.name + '"',
                           "allowed are a wheel for wheelset.wheel and a rail for track.rail");
  }
  auto given = std::make_shared<const Profile>(profile);
  key.set_text(scene, profile.name);
  if (!profile.points.empty()) { // or else it is built in
    (is_wheel ? scene.wheel_profile : scene.rail_profile) = std::move(given);
  }
}

} // namespace wrc
