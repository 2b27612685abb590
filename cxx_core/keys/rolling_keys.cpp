// Keys of friction, creepages and speed.
#include <array>
#include <cmath>
#include <iterator>

#include "base/error.hpp"
#include "keys/constants.hpp"
#include "keys/key_makers.hpp"
#include "keys/scene_key_table.hpp"

namespace wrc {
namespace {

using namespace dimensions;
using namespace key_makers;

using Sides = std::vector<SceneSide Scene::*>;

/// The coefficient of friction of one or both wheels, everywhere on them.
Key friction_key(std::string_view name, std::string_view meaning, const Sides& sides) {
  Key key;
  key.description = {name, "0.3", "0 to 10", meaning};
  key.min = 0.0;
  key.max = max_friction;
  key.get = [sides](const Scene& scene) {
    const FrictionLaw& law = (scene.*sides.front()).friction;
    const FrictionLaw& other = (scene.*sides.back()).friction;
    return law.coefficient == other.coefficient ? KeyValue(law.coefficient) : KeyValue();
  };
  key.set_number = [sides](Scene& scene, double value) {
    for (SceneSide Scene::*side : sides) {
      (scene.*side).friction.coefficient = value;
      (scene.*side).friction.places.clear();
    }
  };
  return key;
}

/// [s, coefficient, s, coefficient, ...] with s rising, or nothing if it is not that.
std::vector<FrictionAtPlace> friction_places(std::span<const double> values,
                                             const Convention& convention) {
  std::vector<FrictionAtPlace> places;
  const bool pairs = values.size() % 2 == 0 && values.size() <= 2 * max_friction_places;
  for (std::size_t i = 0; pairs && i < values.size(); i += 2) {
    const double s = from_caller(values[i], convention, length);
    const bool rises = places.empty() || s > places.back().s;
    const bool permitted = values[i + 1] >= 0.0 && values[i + 1] <= max_friction;
    if (!(std::abs(s) <= 200.0) || !rises || !permitted) {
      return {};
    }
    places.push_back({s, values[i + 1]});
  }
  return places;
}

/// The coefficient of friction by position on the wheel.
Key friction_places_key(std::string_view name, std::string_view meaning, const Sides& sides) {
  Key key;
  key.description = {name, "\"none\"",
                     "[s, coefficient, s, coefficient, ...] with rising s of -200 to 200 mm and "
                     "coefficients of 0 to 10, or \"none\"",
                     meaning};
  key.get = [sides](const Scene& scene) {
    const auto& places = (scene.*sides.front()).friction.places;
    if (places != (scene.*sides.back()).friction.places) {
      return KeyValue();
    }
    std::vector<double> values;
    for (const FrictionAtPlace& place : places) {
      values.push_back(to_caller(place.s, scene.convention, length));
      values.push_back(place.coefficient);
    }
    return values.empty() ? KeyValue(std::string("none")) : KeyValue(values);
  };
  const auto set = [sides](Scene& scene, const std::vector<FrictionAtPlace>& places) {
    std::vector<std::vector<FrictionAtPlace>> copies(sides.size(), places); // may run out of memory
    for (std::size_t i = 0; i < sides.size(); ++i) {
      (scene.*sides[i]).friction.places = std::move(copies[i]);
    }
  };
  key.set_text = [set](Scene& scene, std::string_view value) {
    if (value == "none") {
      set(scene, {});
    }
    return value == "none";
  };
  key.set_numbers = [set](Scene& scene, std::span<const double> values) {
    const std::vector<FrictionAtPlace> places = friction_places(values, scene.convention);
    if (!places.empty()) {
      set(scene, places);
    }
    return !places.empty();
  };
  return key;
}

/// A number of the law of both wheels.
Key friction_law_key(KeyDescription description, Range range, Dimension dimension,
                     double FrictionLaw::*member) {
  const auto of = [member](SceneSide Scene::*side) {
    return [ side, member ](auto& scene) -> auto& {
      return (scene.*side).friction.*member;
    };
  };
  return number_key(description, range, dimension, of(&Scene::left), of(&Scene::right));
}

std::vector<Key> friction_keys() {
  const Sides both{&Scene::left, &Scene::right};
  return {
      friction_key("friction.coefficient", "coefficient of friction of each wheel", both),
      friction_places_key("friction.places",
                          "coefficient of friction of each wheel by position on its profile, s "
                          "from the taping line to "
                          "the field side; linear between the given positions, constant beyond",
                          both),
      friction_key("friction.left", "coefficient of friction of the left wheel", {&Scene::left}),
      friction_places_key("friction.left_places",
                          "coefficient of friction by position on the profile of the left wheel",
                          {&Scene::left}),
      friction_key("friction.right", "coefficient of friction of the right wheel", {&Scene::right}),
      friction_places_key("friction.right_places",
                          "coefficient of friction by position on the profile of the right wheel",
                          {&Scene::right}),
      friction_law_key({"friction.limit_ratio", "1.0", "0 to 1",
                        "fraction of the coefficient that remains at high slip speed (Polach's A); "
                        "used with friction.decay"},
                       {0.0, 1.0}, pure, &FrictionLaw::limit_ratio),
      friction_law_key({"friction.decay", "0.0", "0 to 1 s/mm",
                        "decay of the coefficient with the slip speed w, by the factor (1 - "
                        "limit_ratio) exp(-decay w) + limit_ratio (Polach's B)"},
                       {0.0, 1.0}, Dimension{Quantity::stiffness, false, "s/mm"},
                       &FrictionLaw::decay)};
}

/// Sets what a key has to "none", the only text it takes.
template <class Reset> auto none_or_refuse(Reset reset) {
  return [reset](Scene& scene, std::string_view value) {
    if (value == "none") {
      reset(scene);
    }
    return value == "none";
  };
}

/// [longitudinal, lateral, spin], or none.
Key creepage_key(std::string_view name, std::string_view meaning, SceneSide Scene::*side) {
  Key key = three_key(
      {name, "\"none\"", "[longitudinal, lateral, spin], each -10 to 10 (spin 1/mm), or \"none\"",
       meaning},
      {max_creepage, max_creepage, max_creepage}, {pure, turning, turning_curvature},
      [side](const Scene& scene) -> std::optional<Three> {
        const auto& creepages = (scene.*side).creepages;
        return creepages ? std::optional(
                               Three{creepages->longitudinal, creepages->lateral, creepages->spin})
                         : std::nullopt;
      },
      [side](Scene& scene, const Three& values) {
        (scene.*side).creepages = Creepages{values[0], values[1], values[2]};
      });
  key.set_text = none_or_refuse([side](Scene& scene) { (scene.*side).creepages.reset(); });
  return key;
}

/// One of the three of both wheels; the others are 0 unless they are set.
Key component_key(std::string_view name, std::string_view allowed, std::string_view meaning,
                  Dimension dimension, double Creepages::*component) {
  Key key;
  key.description = {name, "\"none\"", allowed, meaning};
  key.dimension = dimension;
  key.min = -max_creepage;
  key.max = max_creepage;
  key.get = [component](const Scene& scene) {
    const auto& left = scene.left.creepages;
    const auto& right = scene.right.creepages;
    if (!left && !right) {
      return KeyValue(std::string("none"));
    }
    return left && right && (*left).*component == (*right).*component ? KeyValue((*left).*component)
                                                                      : KeyValue();
  };
  key.set_number = [component](Scene& scene, double value) {
    for (auto* side : {&scene.left.creepages, &scene.right.creepages}) {
      if (!*side) {
        side->emplace();
      }
      (**side).*component = value;
    }
  };
  key.set_text = none_or_refuse([](Scene& scene) {
    scene.left.creepages.reset();
    scene.right.creepages.reset();
  });
  return key;
}

Motion& motion_of(Scene& scene) {
  return scene.motion ? *scene.motion : scene.motion.emplace();
}

/// One of the velocities; the others are 0 unless they are set.
Key motion_key(std::string_view name, std::string_view allowed, std::string_view meaning,
               double limit, Dimension dimension, double Motion::*component) {
  Key key;
  key.description = {name, "\"none\"", allowed, meaning};
  key.dimension = dimension;
  key.min = -limit;
  key.max = limit;
  key.get = [component](const Scene& scene) {
    return scene.motion ? KeyValue((*scene.motion).*component) : KeyValue(std::string("none"));
  };
  key.set_number = [component](Scene& scene, double value) { motion_of(scene).*component = value; };
  key.set_text = none_or_refuse([](Scene& scene) {
    scene.motion.reset();
    scene.pitch_is_free = false;
  });
  return key;
}

Key creep_key() {
  Key key = word_key<std::optional<CreepModel>>(
      {"solve.creep", "\"auto\"",
       "\"auto\", \"none\", \"linear\", \"shen-hedrick-elkins\", \"polach\", \"fastsim\" or "
       "\"full\"",
       "model of creep forces if creepages or a motion are given; auto: full, which is Kalker's "
       "full theory to solve.accuracy on the patch's pressures; the others work on an ellipse"},
      {{"auto", std::nullopt},
       {"none", CreepModel::none},
       {"linear", CreepModel::linear},
       {"shen-hedrick-elkins", CreepModel::shen_hedrick_elkins},
       {"polach", CreepModel::polach},
       {"fastsim", CreepModel::fastsim},
       {"full", CreepModel::full}},
      &Scene::creep);
  key.set_text = [set = key.set_text](Scene& scene, std::string_view value) {
    if (value == "fastsim-strips") {
      throw_invalid_argument("solve.creep", "fastsim-strips",
                             "is no longer there: \"full\" at solve.accuracy = 0.1 has smaller "
                             "errors and takes less time");
    }
    return set(scene, value);
  };
  return key;
}

/// A rate, or rolling with the speed, or free.
Key pitch_key() {
  Key key;
  key.description = {
      "motion.pitch", "\"rolling\"", "-1e5 to 1e5 rad/s, \"rolling\" or \"free\"",
      "rotation rate of the axle, positive when it rolls forward; rolling: speed over nominal "
      "radius; free: the rate at which contact forces balance motion.torque"};
  key.dimension = rate;
  key.min = -1e5;
  key.max = 1e5;
  key.get = [](const Scene& scene) {
    return scene.motion && scene.motion->pitch
               ? KeyValue(*scene.motion->pitch)
               : KeyValue(std::string(scene.pitch_is_free ? "free" : "rolling"));
  };
  key.set_number = [](Scene& scene, double value) {
    motion_of(scene).pitch = value;
    scene.pitch_is_free = false;
  };
  key.set_text = [](Scene& scene, std::string_view value) {
    const bool free = value == "free";
    if (!free && value != "rolling") {
      return false;
    }
    if (free || scene.motion) { // rolling by itself does not move
      motion_of(scene).pitch.reset();
    }
    scene.pitch_is_free = free;
    return true;
  };
  return key;
}

Key vertical_key() {
  Key key =
      motion_key("motion.vertical", "-1e6 to 1e6 mm/s, \"follow\" or \"none\"",
                 "vertical velocity of the wheelset's centre; follow, the default: 0, or where a "
                 "rail or a wheel varies the velocity at which each wheel stays on its rail",
                 1e6, turning_speed, &Motion::vertical);
  key.get = [get = key.get](const Scene& scene) {
    return scene.motion && !scene.motion->vertical_is_given ? KeyValue(std::string("follow"))
                                                            : get(scene);
  };
  key.set_number = [set = key.set_number](Scene& scene, double value) {
    set(scene, value);
    scene.motion->vertical_is_given = true;
  };
  key.set_text = [set = key.set_text](Scene& scene, std::string_view value) {
    if (value != "follow") {
      return set(scene, value);
    }
    if (scene.motion) { // following by itself does not move
      scene.motion->vertical = 0.0;
      scene.motion->vertical_is_given = false;
    }
    return true;
  };
  return key;
}

Key acceleration_key() {
  using Six = std::array<double, 6>;
  constexpr double most = 1e9;
  return list_key<6>(
      {"motion.acceleration", "[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]",
       "[along the track, lateral, vertical, roll, pitch, yaw], each -1e9 to 1e9 mm/s^2 or rad/s^2",
       "rates of the velocities of motion.*; forces do not depend on them, but with "
       "solve.derivatives creep_steady_error does, the error of steady creep forces where they "
       "change along the path"},
      {most, most, most, most, most, most},
      {length, turning_length, turning_length, pure, pure, turning},
      [](const Scene& scene) -> std::optional<Six> { return scene.acceleration; },
      [](Scene& scene, const Six& values) { scene.acceleration = values; });
}

constexpr std::string_view speed_range = "-1e6 to 1e6 mm/s, or \"none\"";
constexpr std::string_view rate_range = "-1e3 to 1e3 rad/s, or \"none\"";
constexpr std::string_view creepage_range = "-10 to 10, or \"none\"";
constexpr std::string_view spin_range = "-10 to 10 1/mm, or \"none\"";

} // namespace

std::vector<Key> make_rolling_keys() {
  std::vector<Key> keys = friction_keys();
  std::vector<Key> others{
      component_key("creepage.longitudinal", creepage_range, "longitudinal creepage of both wheels",
                    pure, &Creepages::longitudinal),
      component_key("creepage.lateral", creepage_range, "lateral creepage of both wheels", turning,
                    &Creepages::lateral),
      component_key("creepage.spin", spin_range, "spin creepage of both wheels", turning_curvature,
                    &Creepages::spin),
      creepage_key("creepage.left",
                   "creepages of the left wheel, wheel minus rail divided by the speed, in the "
                   "plane of each patch at its reference; setting them requests creep forces",
                   &Scene::left),
      creepage_key("creepage.right", "creepages of the right wheel", &Scene::right),
      motion_key("motion.speed", speed_range,
                 "speed along the track, negative when running backwards; if creepages are not "
                 "given, any key of motion.* computes them from the motion; otherwise the speed "
                 "affects only the frictional power",
                 1e6, speed, &Motion::speed),
      pitch_key(),
      number_key({"motion.torque", "0.0", "-1e12 to 1e12 N mm",
                  "torque about the axle, positive when it drives forward; used with motion.pitch "
                  "= \"free\""},
                 {-1e12, 1e12}, moment, &Scene::torque),
      motion_key("motion.lateral", speed_range, "lateral velocity of the wheelset's centre", 1e6,
                 turning_speed, &Motion::lateral),
      vertical_key(),
      motion_key("motion.roll", rate_range, "roll rate of the wheelset", 1e3, rate, &Motion::roll),
      motion_key("motion.yaw", rate_range, "yaw rate of the wheelset, relative to the track", 1e3,
                 turning_rate, &Motion::yaw),
      motion_key("motion.curvature", "-1e-3 to 1e-3 1/mm, or \"none\"",
                 "curvature of the track, positive in left-hand curves", 1e-3, turning_curvature,
                 &Motion::curvature),
      acceleration_key(),
      number_key({"motion.standstill_speed", "1.0", "1e-3 to 1e5 mm/s",
                  "V0: creepages are slip velocities over (V^2 + V0^2)^(1/2), so that creep forces "
                  "go to 0 with the velocities; at standstill friction saturates at a sliding "
                  "speed of about 0.003 V0"},
                 {1e-3, 1e5}, speed, &Scene::standstill_speed),
      creep_key(),
      word_key<bool>(
          {"solve.derivatives", "\"no\"", "\"no\" or \"yes\"",
           "whether to compute derivatives of creep forces and the Jacobian of all contact forces"},
          {{"no", false}, {"yes", true}}, &Scene::derivatives)};
  keys.insert(keys.end(), std::make_move_iterator(others.begin()),
              std::make_move_iterator(others.end()));
  return keys;
}

} // namespace wrc
