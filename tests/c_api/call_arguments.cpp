#include "call_arguments.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

thread_local Choices* choices = nullptr;

/// While it lives, choices are pseudo-random numbers from a single one: for arrays.
class FromOneChoice {
public:
  FromOneChoice() : seeded_(below(std::uint64_t{1} << 32)), before_(choices) { choices = &seeded_; }
  FromOneChoice(const FromOneChoice&) = delete;
  FromOneChoice& operator=(const FromOneChoice&) = delete;
  ~FromOneChoice() { choices = before_; }

private:
  SeededChoices seeded_;
  Choices* before_;
};

/// Keys, names, words, paths and nonsense, with bars between them.
constexpr const char* words =
    "|.|left.|left.patches.|left.patches.0.|left.patches.99999999999999999999.pmax|"
    "left.patches.-1.pmax|left.patches.0.pressure|right.patches.1.undeformed_distance|"
    "left.displacement|right.rail_y|left.wheel_z|left.pmax|right.area|"
    "left.residuals.least_gap|left.sensitivities.pressure_force.z.vertical|"
    "left.sensitivities.at_load.vertical.roll|roll|units|model|left.stop_reason|"
    "left.warnings.0|solve|none|both|left|tangent|vertical|geometry|remesh|mechanics|SI|mm|"
    "right-down|left-up|paper|default|double|mixed|1:20|-1:1e999|S1002|60E1|CHN60|LMA|"
    "a file.txt|a scene.toml|wheel.prw|rail.prr|worn.whl|/|/dev/zero|/proc/self/mem|"
    "nowhere/at all.txt|\xff\xfe\x01\n\"\\|pmax|approach|pressure|displacement|normal_load|"
    "combined_modulus|tolerance|maximum_iterations|solver|precision|stop_reason|shear_modulus|"
    "friction|longitudinal_creepage|spin_creepage|contact|transient|shift|difference|first-order|"
    "lateral_force|traction_x|slip_y|title|name";

thread_local std::array<double, array_length> values{};
thread_local std::array<std::int32_t, array_length> ids{};

} // namespace

void choose_from(Choices& given) {
  choices = &given;
}

std::uint64_t below(std::uint64_t end) {
  return choices->below(end);
}

std::uint64_t any_bits() {
  return below(std::numeric_limits<std::uint64_t>::max());
}

double any_number() {
  static const std::array special{0.0,
                                  -0.0,
                                  1.0,
                                  -1.0,
                                  0.3,
                                  2.0,
                                  1e-3,
                                  40.0,
                                  1435.0,
                                  460.0,
                                  8e4,
                                  2.1e5,
                                  1e300,
                                  -1e300,
                                  std::numeric_limits<double>::max(),
                                  std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
  if (below(3) == 0) {
    return any_of(special);
  }
  const double exponent = -6.0 + 12.0 * static_cast<double>(below(1000)) / 1000.0;
  return (below(2) == 0 ? 1.0 : -1.0) * std::pow(10.0, exponent);
}

const char* any_text() {
  static const std::string endless(20000, 'x');
  static const std::vector<std::string> kept = [] {
    std::vector<std::string> all;
    std::istringstream from(words);
    for (std::string word; std::getline(from, word, '|');) {
      all.push_back(word);
    }
    return all;
  }();
  static const std::vector<const char*> texts = [] {
    std::vector<const char*> list{nullptr};
    for (const std::string& word : kept) {
      list.push_back(word.c_str());
    }
    list.push_back(endless.c_str());
    for (std::int64_t i = 0; i < wrc_scene_key_count(); ++i) {
      const char* text[4] = {};
      wrc_scene_key(i, &text[0], &text[1], &text[2], &text[3]);
      list.push_back(text[0]);
      list.push_back(text[0]);
    }
    return list;
  }();
  return any_of(texts);
}

double* any_array() {
  const FromOneChoice one;
  for (std::size_t i = 0; i < 64; ++i) {
    values[below(array_length)] = any_number();
  }
  if (below(4) == 0) { // a paraboloid
    for (std::size_t i = 0; i < array_length; ++i) {
      const double x = static_cast<double>(i % 16) - 7.5;
      const double y = static_cast<double>(i / 16) - 7.5;
      values[i] = 1e-4 * (x * x + y * y);
    }
  }
  return below(16) == 0 ? nullptr : values.data();
}

std::int32_t* any_ids() {
  const FromOneChoice one;
  wrc_scene* scene = nullptr;
  if (wrc_scene_create(&scene) == WRC_OK) {
    for (std::size_t i = 0; i < 64; ++i) {
      std::int32_t& id = ids[below(2) == 0 ? i : below(array_length)];
      switch (below(3)) {
      case 0:
        wrc_scene_key_id(scene, any_text(), &id);
        break;
      case 1:
        wrc_scene_number_id(scene, any_text(), &id);
        break;
      default:
        id = static_cast<std::int32_t>(any_bits());
      }
    }
    wrc_scene_destroy(scene);
  }
  return maybe(ids.data());
}

std::int64_t any_count() {
  static constexpr std::array<std::int64_t, 7> absurd{0,
                                                      -1,
                                                      std::numeric_limits<std::int64_t>::max(),
                                                      std::numeric_limits<std::int64_t>::min(),
                                                      std::int64_t{1} << 60,
                                                      -7,
                                                      (std::int64_t{1} << 31) + 1};
  switch (below(4)) {
  case 0:
    return any_of(absurd);
  case 1:
    return 2;
  case 2:
    return 256;
  default:
    return static_cast<std::int64_t>(below(array_length));
  }
}

std::int64_t any_capacity() {
  const std::int64_t count = any_count();
  return count > static_cast<std::int64_t>(array_length) ? 0 : count;
}

void clear_arrays() {
  values.fill(0.0);
  ids.fill(0);
}
