// Keys of friction, creepages and speed.
#include <array>
#include <cmath>

#include "scene/key_makers.hpp"

namespace wrc {
namespace {

using namespace dimensions;
using namespace key_makers;

/// Largest permitted creepage, and spin in 1/mm.
/// origin: reasoned: full sliding in every case.
constexpr double max_creepage = 10.0;

/// [longitudinal, lateral, spin], or none.
Key creepage_key(std::string_view name, std::string_view meaning,
                 std::optional<Creepages> Scene::*member) {
  constexpr std::array dimensions_of{pure, turning_angle, turning_curvature};
  Key key;
  key.description = {name, "\"none\"",
                     "[longitudinal, lateral, spin], each -10 to 10 (spin 1/mm), or \"none\"",
                     meaning};
  key.get = [member, dimensions_of](const Scene& scene) {
    if (!(scene.*member)) {
      return KeyValue(std::string("none"));
    }
    const Creepages& creepages = *(scene.*member);
    std::vector<double> values{creepages.longitudinal, creepages.lateral, creepages.spin};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = to_caller(values[i], scene.convention, dimensions_of[i]);
    }
    return KeyValue(values);
  };
  key.set_text = [member](Scene& scene, std::string_view value) {
    if (value == "none") {
      (scene.*member).reset();
    }
    return value == "none";
  };
  key.set_numbers = [member, dimensions_of](Scene& scene, std::span<const double> values) {
    if (values.size() != dimensions_of.size()) {
      return false;
    }
    std::array<double, 3> inside{};
    for (std::size_t i = 0; i < inside.size(); ++i) {
      inside[i] = from_caller(values[i], scene.convention, dimensions_of[i]);
      if (!(std::abs(inside[i]) <= max_creepage)) {
        return false;
      }
    }
    scene.*member = Creepages{inside[0], inside[1], inside[2]};
    return true;
  };
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
    const auto& left = scene.left_creepages;
    const auto& right = scene.right_creepages;
    if (!left && !right) {
      return KeyValue(std::string("none"));
    }
    return left && right && (*left).*component == (*right).*component ? KeyValue((*left).*component)
                                                                      : KeyValue();
  };
  key.set_number = [component](Scene& scene, double value) {
    for (auto* side : {&scene.left_creepages, &scene.right_creepages}) {
      if (!*side) {
        side->emplace();
      }
      (**side).*component = value;
    }
  };
  key.set_text = [](Scene& scene, std::string_view value) {
    if (value == "none") {
      scene.left_creepages.reset();
      scene.right_creepages.reset();
    }
    return value == "none";
  };
  return key;
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
  key.set_number = [component](Scene& scene, double value) {
    if (!scene.motion) {
      scene.motion.emplace();
    }
    (*scene.motion).*component = value;
  };
  key.set_text = [](Scene& scene, std::string_view value) {
    if (value == "none") {
      scene.motion.reset();
    }
    return value == "none";
  };
  return key;
}

/// A rate, or rolling with the speed.
Key pitch_key() {
  Key key;
  key.description = {"motion.pitch", "\"rolling\"", "-1e5 to 1e5 rad/s, or \"rolling\"",
                     "of the axle, positive when it rolls forward; rolling: speed over the nominal "
                     "radius"};
  key.min = -1e5;
  key.max = 1e5;
  key.get = [](const Scene& scene) {
    return scene.motion && scene.motion->pitch ? KeyValue(*scene.motion->pitch)
                                               : KeyValue(std::string("rolling"));
  };
  key.set_number = [](Scene& scene, double value) {
    if (!scene.motion) {
      scene.motion.emplace();
    }
    scene.motion->pitch = value;
  };
  key.set_text = [](Scene& scene, std::string_view value) {
    if (value == "rolling" && scene.motion) {
      scene.motion->pitch.reset();
    }
    return value == "rolling";
  };
  return key;
}

constexpr std::string_view speed_range = "-1e6 to 1e6 mm/s, or \"none\"";
constexpr std::string_view rate_range = "-1e3 to 1e3 rad/s, or \"none\"";
constexpr std::string_view creepage_range = "-10 to 10, or \"none\"";
constexpr std::string_view spin_range = "-10 to 10 1/mm, or \"none\"";

} // namespace

std::vector<Key> make_rolling_keys() {
  constexpr Range range{0.0, 10.0};
  constexpr std::string_view allowed = "0 to 10";
  const auto left = &Scene::left_friction;
  const auto right = &Scene::right_friction;
  return {
      number_key({"friction.coefficient", "0.3", allowed, "coefficient of friction of each wheel"},
                 range, pure, left, right),
      number_key({"friction.left", "0.3", allowed, "coefficient of friction of the left wheel"},
                 range, pure, left),
      number_key({"friction.right", "0.3", allowed, "coefficient of friction of the right wheel"},
                 range, pure, right),
      creepage_key("creepage.left",
                   "creepages of the left wheel, wheel minus rail over the speed, in the plane of "
                   "each patch at its reference; creep forces are computed then",
                   &Scene::left_creepages),
      creepage_key("creepage.right", "creepages of the right wheel", &Scene::right_creepages),
      component_key("creepage.longitudinal", creepage_range, "longitudinal creepage of both wheels",
                    pure, &Creepages::longitudinal),
      component_key("creepage.lateral", creepage_range, "lateral creepage of both wheels",
                    turning_angle, &Creepages::lateral),
      component_key("creepage.spin", spin_range, "spin creepage of both wheels", turning_curvature,
                    &Creepages::spin),
      motion_key("motion.speed", speed_range,
                 "along the track, backwards below 0; any of motion.* makes creepages from the "
                 "motion where none are given, else the speed is that of the frictional power",
                 1e6, length, &Motion::speed),
      pitch_key(),
      motion_key("motion.lateral", speed_range, "lateral velocity of the wheelset's centre", 1e6,
                 turning_length, &Motion::lateral),
      motion_key("motion.vertical", speed_range, "its vertical velocity", 1e6, turning_length,
                 &Motion::vertical),
      motion_key("motion.roll", rate_range, "rate of the roll", 1e3, pure, &Motion::roll),
      motion_key("motion.yaw", rate_range, "rate of the yaw, against the track", 1e3, turning_angle,
                 &Motion::yaw),
      motion_key("motion.curvature", "-1e-3 to 1e-3 1/mm, or \"none\"",
                 "of the track, positive in left-hand curves", 1e-3, turning_curvature,
                 &Motion::curvature),
      word_key<std::optional<CreepModel>>(
          {"solve.creep", "\"auto\"",
           "\"auto\", \"none\", \"linear\", \"shen-hedrick-elkins\", \"polach\", \"fastsim\", "
           "\"fastsim-strips\" or \"full\"",
           "model of creep forces where creepages are given; auto: full, Kalker's full theory to "
           "solve.accuracy; fastsim-strips on the patch's own pressures, the others on an ellipse"},
          {{"auto", std::nullopt},
           {"none", CreepModel::none},
           {"linear", CreepModel::linear},
           {"shen-hedrick-elkins", CreepModel::shen_hedrick_elkins},
           {"polach", CreepModel::polach},
           {"fastsim", CreepModel::fastsim},
           {"fastsim-strips", CreepModel::fastsim_strips},
           {"full", CreepModel::full}},
          &Scene::creep)};
}

} // namespace wrc
