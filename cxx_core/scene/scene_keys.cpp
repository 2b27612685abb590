#include "scene/scene_keys.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <vector>

#include "error.hpp"

namespace wrc {
namespace {

using SetNumber = std::function<void(Scene&, double)>;
/// Takes a word; false if the word is not one of those permitted.
using SetText = std::function<bool(Scene&, std::string_view)>;
using SetNumbers = std::function<bool(Scene&, std::span<const double>)>;

struct Key {
  KeyDescription description;
  double least = 0.0; ///< range of a number, ends included
  double greatest = 0.0;
  bool whole = false; ///< whole numbers only
  SetNumber set_number;
  SetText set_text;
  SetNumbers set_numbers;
};

constexpr double largest_grid_count = 8192.0;

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

Key number_key(KeyDescription description, double least, double greatest, SetNumber set) {
  return {description, least, greatest, false, std::move(set), {}, {}};
}

Key word_key(KeyDescription description, SetText set) {
  return {description, 0.0, 0.0, false, {}, std::move(set), {}};
}

SetText one_of(std::vector<std::string_view> words, std::string Scene::*member) {
  return [words = std::move(words), member](Scene& scene, std::string_view value) {
    if (std::find(words.begin(), words.end(), value) == words.end()) {
      return false;
    }
    scene.*member = value;
    return true;
  };
}

SetText profile_name(std::string Scene::*member) {
  return [member](Scene& scene, std::string_view value) {
    if (value.empty()) {
      return false;
    }
    scene.*member = value;
    return true;
  };
}

std::vector<Key> track_keys() {
  std::vector<Key> keys;
  keys.push_back(number_key({"track.gauge", "1435.0", "600 to 1700 mm",
                             "distance of the gauge faces at the gauge height"},
                            600.0, 1700.0, [](Scene& s, double v) { s.track.gauge = v; }));
  keys.push_back(number_key({"track.gauge_height", "14.0", "1 to 30 mm",
                             "where the gauge is measured, below the top of the inclined rail"},
                            1.0, 30.0, [](Scene& s, double v) { s.track.gauge_height = v; }));
  Key cant =
      number_key({"track.cant", "\"1:40\"", "\"1:n\" or \"-1:n\" with n >= 5, or -0.2 to 0.2 rad",
                  "inclination of the rails towards the track centre"},
                 -0.2, 0.2, [](Scene& s, double v) { s.track.cant = v; });
  cant.set_text = [](Scene& s, std::string_view v) { return parse_cant(v, s.track.cant); };
  keys.push_back(cant);
  keys.push_back(word_key(
      {"track.rail", "\"60E1\"", "a text: a built-in rail or a profile file", "rail profile"},
      profile_name(&Scene::rail)));
  keys.push_back(number_key({"track.rail_smoothing", "0.0", "0 (none) to 100 mm",
                             "smoothing wavelength of a rail profile read from a file"},
                            0.0, 100.0, [](Scene& s, double v) { s.rail_smoothing = v; }));
  return keys;
}

std::vector<Key> wheelset_keys() {
  std::vector<Key> keys;
  keys.push_back(word_key({"wheelset.wheel", "\"S1002\"",
                           "a text: a built-in wheel or a profile file", "wheel profile"},
                          profile_name(&Scene::wheel)));
  keys.push_back(number_key({"wheelset.wheel_smoothing", "0.0", "0 (none) to 100 mm",
                             "smoothing wavelength of a wheel profile read from a file"},
                            0.0, 100.0, [](Scene& s, double v) { s.wheel_smoothing = v; }));
  keys.push_back(number_key({"wheelset.back_to_back", "1360.0", "500 to 1650 mm",
                             "distance of the inner faces of the wheels"},
                            500.0, 1650.0,
                            [](Scene& s, double v) { s.wheelset.back_to_back = v; }));
  keys.push_back(number_key({"wheelset.tape_offset", "70.0", "20 to 120 mm",
                             "distance from the inner face to the taping line"},
                            20.0, 120.0, [](Scene& s, double v) { s.wheelset.tape_offset = v; }));
  keys.push_back(number_key(
      {"wheelset.radius", "460.0", "50 to 5000 mm", "nominal rolling radius, at the taping line"},
      50.0, 5000.0, [](Scene& s, double v) { s.wheelset.radius = v; }));
  return keys;
}

std::vector<Key> material_keys() {
  constexpr std::string_view modulus_range = "1 to 1e9 MPa";
  constexpr std::string_view poisson_range = "0 to 0.5";
  std::vector<Key> keys;
  const auto modulus = [&](std::string_view name, std::string_view meaning, SetNumber set) {
    keys.push_back(
        number_key({name, "210000.0", modulus_range, meaning}, 1.0, 1e9, std::move(set)));
  };
  const auto poisson = [&](std::string_view name, std::string_view meaning, SetNumber set) {
    keys.push_back(number_key({name, "0.3", poisson_range, meaning}, 0.0, 0.5, std::move(set)));
  };
  modulus("material.youngs_modulus", "Young's modulus of wheel and rail", [](Scene& s, double v) {
    s.wheel_material.youngs_modulus = s.rail_material.youngs_modulus = v;
  });
  poisson("material.poisson", "Poisson's ratio of wheel and rail",
          [](Scene& s, double v) { s.wheel_material.poisson = s.rail_material.poisson = v; });
  modulus("material.wheel.youngs_modulus", "Young's modulus of the wheel alone",
          [](Scene& s, double v) { s.wheel_material.youngs_modulus = v; });
  poisson("material.wheel.poisson", "Poisson's ratio of the wheel alone",
          [](Scene& s, double v) { s.wheel_material.poisson = v; });
  modulus("material.rail.youngs_modulus", "Young's modulus of the rail alone",
          [](Scene& s, double v) { s.rail_material.youngs_modulus = v; });
  poisson("material.rail.poisson", "Poisson's ratio of the rail alone",
          [](Scene& s, double v) { s.rail_material.poisson = v; });
  return keys;
}

std::vector<Key> pose_keys() {
  std::vector<Key> keys;
  keys.push_back(number_key({"pose.lateral", "0.0", "-100 to 100 mm",
                             "displacement of the wheelset's centre to the left"},
                            -100.0, 100.0, [](Scene& s, double v) { s.lateral = v; }));
  keys.push_back(number_key({"pose.yaw", "0.0", "-0.2 to 0.2 rad", "anticlockwise seen from above"},
                            -0.2, 0.2, [](Scene& s, double v) { s.yaw = v; }));
  Key roll = number_key({"pose.roll", "\"solve\"", "\"solve\", \"en15302\" or -0.2 to 0.2 rad",
                         "lifts the left wheel; solved: both wheels touch; en15302: none, each "
                         "wheel by itself"},
                        -0.2, 0.2, [](Scene& s, double v) { s.roll = v; });
  roll.set_text = [](Scene& s, std::string_view v) {
    if (v == "solve") {
      s.roll.reset();
    } else if (v == "en15302") {
      s.roll = 0.0;
    }
    return v == "solve" || v == "en15302";
  };
  keys.push_back(roll);
  Key vertical = number_key({"pose.vertical", "\"solve\"", "\"solve\" or 0 to 6000 mm",
                             "height of the wheelset's centre above the rail tops; a number "
                             "prescribes the position, and forces come out"},
                            0.0, 6000.0, [](Scene& s, double v) { s.vertical = v; });
  vertical.set_text = [](Scene& s, std::string_view v) {
    if (v == "solve") {
      s.vertical.reset();
    }
    return v == "solve";
  };
  keys.push_back(vertical);
  return keys;
}

std::vector<Key> load_keys() {
  constexpr double greatest_load = 1e12;
  constexpr std::string_view range = "0 to 1e12 N";
  std::vector<Key> keys;
  keys.push_back(number_key({"load.vertical", "80000.0", range, "vertical force on each wheel"},
                            0.0, greatest_load, [](Scene& s, double v) {
                              s.left_load = s.right_load = v;
                              s.normal_load.reset();
                            }));
  keys.push_back(number_key({"load.left", "80000.0", range, "vertical force on the left wheel"},
                            0.0, greatest_load, [](Scene& s, double v) {
                              s.left_load = v;
                              s.normal_load.reset();
                            }));
  keys.push_back(number_key({"load.right", "80000.0", range, "vertical force on the right wheel"},
                            0.0, greatest_load, [](Scene& s, double v) {
                              s.right_load = v;
                              s.normal_load.reset();
                            }));
  keys.push_back(number_key({"load.normal", "none", range,
                             "instead: force along the gap's direction on each wheel (the paper)"},
                            0.0, greatest_load, [](Scene& s, double v) { s.normal_load = v; }));
  return keys;
}

bool set_grid(Scene& scene, std::span<const double> counts) {
  const auto permitted = [](double count) {
    return count >= 1.0 && count <= largest_grid_count && count == std::floor(count);
  };
  if (counts.size() != 2 || !std::all_of(counts.begin(), counts.end(), permitted)) {
    return false;
  }
  scene.grid = {{static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[1])}};
  return true;
}

std::vector<Key> solve_keys() {
  std::vector<Key> keys;
  keys.push_back(
      word_key({"solve.side", "\"both\"", "\"both\", \"left\" or \"right\"", "wheels to solve"},
               [](Scene& s, std::string_view v) {
                 if (v == "both") {
                   s.side = SideChoice::both;
                 } else if (v == "left") {
                   s.side = SideChoice::left;
                 } else if (v == "right") {
                   s.side = SideChoice::right;
                 } else {
                   return false;
                 }
                 return true;
               }));
  keys.push_back(word_key({"solve.gap", "\"tangent\"", "\"tangent\" or \"vertical\"",
                           "direction in which distances are measured; vertical as in the paper"},
                          [](Scene& s, std::string_view v) {
                            if (v == "tangent") {
                              s.gap = GapConvention::tangent;
                            } else if (v == "vertical") {
                              s.gap = GapConvention::vertical;
                            } else {
                              return false;
                            }
                            return true;
                          }));
  keys.push_back(word_key(
      {"solve.model", "\"auto\"", "\"auto\", \"half-space\", \"hertz\" or \"kik-piotrowski\"",
       "contact model; auto takes the half-space"},
      one_of({"auto", "half-space", "hertz", "kik-piotrowski"}, &Scene::model)));
  keys.push_back(
      word_key({"solve.solver", "\"default\"", "\"default\" or \"paper\"",
                "solver of the half-space: paper is Polonsky & Keer 1999, for comparison"},
               one_of({"default", "paper"}, &Scene::solver)));
  keys.push_back(number_key({"solve.accuracy", "1e-3", "1e-5 to 0.1",
                             "relative error asked of pmax and approach; chooses the grid"},
                            1e-5, 0.1, [](Scene& s, double v) {
                              s.accuracy = v;
                              s.grid.reset();
                            }));
  Key grid{{"solve.grid", "chosen by accuracy", "[lateral, longitudinal], each 1 to 8192",
            "number of elements of the potential contact area, by hand"},
           0.0,
           0.0,
           false,
           {},
           {},
           set_grid};
  keys.push_back(grid);
  keys.push_back(
      number_key({"solve.tolerance", "1e-5", "1e-13 to 0.1",
                  "of the iteration on a grid given by hand: largest error of a pressure "
                  "relative to the largest (solver paper: of the gaps); else it follows "
                  "from the accuracy"},
                 1e-13, 0.1, [](Scene& s, double v) { s.tolerance = v; }));
  keys.push_back(word_key({"solve.precision", "\"mixed\"", "\"mixed\" or \"double\"",
                           "of the iteration; mixed is faster and meets the same tolerance"},
                          [](Scene& s, std::string_view v) {
                            s.precision = v == "double" ? Precision::double_only : Precision::mixed;
                            return v == "double" || v == "mixed";
                          }));
  keys.push_back(word_key({"solve.planner", "\"estimate\"", "\"estimate\" or \"measure\"",
                           "how FFTW chooses its algorithms: by rule, or by trying them once"},
                          [](Scene& s, std::string_view v) {
                            s.planner =
                                v == "measure" ? PlannerRigor::measure : PlannerRigor::estimate;
                            return v == "measure" || v == "estimate";
                          }));
  keys.push_back(word_key({"solve.interaction", "\"near\"", "\"near\" or \"all\"",
                           "which patches of a wheel feel each other elastically: those about to "
                           "join, or all, as if in one plane"},
                          [](Scene& s, std::string_view v) {
                            s.interaction = v == "all";
                            return v == "all" || v == "near";
                          }));
  keys.push_back(number_key({"solve.near_tolerance", "0.1", "0 to 10 mm",
                             "further contacts listed whose distance is less at the first touch"},
                            0.0, 10.0, [](Scene& s, double v) { s.near_tolerance = v; }));
  Key threads =
      number_key({"solve.threads", "1", "a whole number, 1 to 1024",
                  "threads; the result does not depend on them"},
                 1.0, 1024.0, [](Scene& s, double v) { s.threads = static_cast<int>(v); });
  threads.whole = true;
  keys.push_back(threads);
  return keys;
}

const std::vector<Key>& keys() {
  static const std::vector<Key> all = [] {
    std::vector<Key> collected;
    for (auto* part :
         {track_keys, wheelset_keys, material_keys, pose_keys, load_keys, solve_keys}) {
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

void set_number(Scene& scene, std::string_view name, double value) {
  const Key& key = find_key(name);
  const bool permitted =
      value >= key.least && value <= key.greatest && (!key.whole || value == std::floor(value));
  if (!key.set_number || !permitted) {
    refuse(key, text_of(value));
  }
  key.set_number(scene, value);
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
    std::string text = "[";
    for (const double value : values) {
      text += (text.size() > 1 ? ", " : "") + text_of(value);
    }
    refuse(key, text + "]");
  }
}

} // namespace wrc
