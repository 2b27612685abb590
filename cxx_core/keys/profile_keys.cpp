// Keys of the track and the wheelset: profiles, where they are.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "keys/key_makers.hpp"
#include "keys/profile_text.hpp"
#include "keys/scene_key_table.hpp"

namespace wrc {
namespace {

using namespace dimensions;
using namespace key_makers;

using Sides = std::vector<SceneSide Scene::*>;

/// A profile on one or both sides by name, with its options, or given by the program.
Key profile_key(std::string_view name, std::string_view meaning, ProfileKind kind,
                ProfileChoice SceneSide::*choice, const Sides& sides) {
  const ProfileKey named{name, kind};
  const bool rail = kind == ProfileKind::rail;
  // Strings may run out of memory, and then nothing is set.
  const auto change = [=](Scene& scene, const auto& each) {
    std::vector<ProfileChoice> chosen;
    for (SceneSide Scene::*side : sides) {
      each(chosen.emplace_back((scene.*side).*choice));
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
      (scene.*sides[i]).*choice = std::move(chosen[i]);
    }
  };
  const auto common = [=](const Scene& scene, const auto& of) {
    const auto first = KeyValue(of((scene.*sides.front()).*choice));
    return first == KeyValue(of((scene.*sides.back()).*choice)) ? first : KeyValue();
  };
  Key key;
  key.description = {name, rail ? "\"60E1\"" : "\"S1002\"",
                     rail ? "a text: a built-in rail or a profile file, and options of it behind "
                            "\"; \": smoothing, smoothing_along, origin, rotation, align_to"
                          : "a text: a built-in wheel or a profile file, and options of it behind "
                            "\"; \": smoothing, smoothing_along, origin, shift, rotation, align_to",
                     meaning};
  key.get = [=](const Scene& scene) {
    return common(scene,
                  [&](const ProfileChoice& one) { return profile_text(one, scene.convention); });
  };
  key.set_text = [=](Scene& scene, std::string_view text) {
    change(scene,
           [&](ProfileChoice& one) { set_profile_text(one, text, named, scene.convention); });
    return !text.empty();
  };
  key.set_profile = [=](Scene& scene, const Profile& profile) {
    if (profile.kind == kind) {
      const bool built_in = profile.points.empty();
      const auto given = built_in ? nullptr : std::make_shared<const Profile>(profile);
      change(scene, [&](ProfileChoice& one) {
        one = {profile.name, given, {}, std::move(one.harmonics)};
      });
    }
    return profile.kind == kind;
  };
  key.get_option = [=](const Scene& scene, std::string_view option) {
    return common(scene, [&](const ProfileChoice& one) {
      return profile_option(one, option, named, scene.convention);
    });
  };
  key.set_option = [=](Scene& scene, std::string_view option, std::string_view value) {
    change(scene, [&](ProfileChoice& one) {
      set_profile_option(one, option, value, named, scene.convention);
    });
  };
  key.option_unit = [=](std::string_view option, Units units) {
    return profile_option_unit(option, named, units);
  };
  return key;
}

/// What is said of a key with a rail's displacement, or its velocity.
struct RailMoves {
  std::string_view allowed;
  Three limits;
  std::array<Dimension, 3> dimensions_of{turning_length, turning_length, pure};
};

constexpr RailMoves displacements{
    "[lateral, vertical, roll], each -1e4 to 1e4 mm, the roll -0.2 to 0.2 rad", {1e4, 1e4, 0.2}};
constexpr RailMoves velocities{
    "[lateral, vertical, roll], each -1e6 to 1e6 mm/s, the roll -1e3 to 1e3 rad/s",
    {1e6, 1e6, 1e3}};
constexpr RailMoves slopes{"[lateral, vertical, roll], each -1 to 1, the roll -0.01 to 0.01 rad/mm",
                           {1.0, 1.0, 0.01},
                           {turning, turning, stiffness}};

Key rail_key(std::string_view name, const RailMoves& moves, std::string_view meaning,
             SceneSide Scene::*side, RailDisplacement SceneSide::*member) {
  return three_key(
      {name, "[0.0, 0.0, 0.0]", moves.allowed, meaning}, moves.limits, moves.dimensions_of,
      [side, member](const Scene& scene) -> std::optional<Three> {
        const RailDisplacement& moved = (scene.*side).*member;
        return Three{moved.lateral, moved.height, moved.roll};
      },
      [side, member](Scene& scene, const Three& values) {
        (scene.*side).*member = {values[0], values[1], values[2]};
      });
}

/// "1:n" as the angle atan(1/n).
bool parse_inclination(std::string_view text, double& inclination) {
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
  inclination = (negative ? -1.0 : 1.0) * std::atan(1.0 / n);
  return true;
}

/// Waves of a wheel's radius.
Key harmonics_key(std::string_view name, std::string_view meaning, const Sides& sides) {
  Key key;
  key.description = {
      name, "\"none\"",
      "[order, amplitude, phase, ...], at most 100 waves of 12 mm or more in length, with slopes "
      "up to 0.2, amplitudes of -50 to 50 mm and phases of -1e6 to 1e6 rad; or \"none\"",
      meaning};
  key.get = [sides](const Scene& scene) {
    const auto& waves = (scene.*sides.front()).wheel.harmonics;
    if (waves != (scene.*sides.back()).wheel.harmonics) {
      return KeyValue();
    }
    std::vector<double> values;
    for (const RadiusHarmonic& wave : waves) {
      values.insert(values.end(),
                    {static_cast<double>(wave.order),
                     to_caller(wave.amplitude, scene.convention, length), wave.phase});
    }
    return values.empty() ? KeyValue(std::string("none")) : KeyValue(values);
  };
  const auto set = [sides](Scene& scene, const std::vector<RadiusHarmonic>& waves) {
    std::vector<std::vector<RadiusHarmonic>> copies(sides.size(), waves); // may run out of memory
    for (std::size_t i = 0; i < sides.size(); ++i) {
      (scene.*sides[i]).wheel.harmonics = std::move(copies[i]);
    }
  };
  key.set_text = [set](Scene& scene, std::string_view value) {
    if (value == "none") {
      set(scene, {});
    }
    return value == "none";
  };
  key.set_numbers = [set](Scene& scene, std::span<const double> values) {
    constexpr std::size_t most_waves = 100;
    if (values.empty() || values.size() % 3 != 0 || values.size() > 3 * most_waves) {
      return false;
    }
    std::vector<RadiusHarmonic> waves;
    for (std::size_t i = 0; i < values.size(); i += 3) {
      const double amplitude = from_caller(values[i + 1], scene.convention, length);
      if (!(values[i] >= 1.0 && values[i] <= 1000.0 && values[i] == std::floor(values[i]) &&
            std::abs(amplitude) <= 50.0 && std::abs(values[i + 2]) <= 1e6)) {
        return false;
      }
      waves.push_back({static_cast<int>(values[i]), amplitude, values[i + 2]});
    }
    set(scene, waves);
    return true;
  };
  return key;
}

} // namespace

std::vector<Key> make_track_keys() {
  std::vector<Key> keys;
  keys.push_back(number_key(
      {"track.gauge", "1435.0", "600 to 1700 mm",
       "distance between the gauge faces at the gauge height"},
      {600.0, 1700.0}, length, [](auto& s) -> auto& { return s.track.gauge; }));
  keys.push_back(number_key(
      {"track.gauge_height", "14.0", "1 to 30 mm",
       "where the gauge is measured, below the top of the inclined rail"},
      {1.0, 30.0}, length, [](auto& s) -> auto& { return s.track.gauge_height; }));
  Key inclination = number_key(
      {"track.inclination", "\"1:40\"", "\"1:n\" or \"-1:n\" with n >= 5, or -0.2 to 0.2 rad",
       "inclination of the rails towards the track centre"},
      {-0.2, 0.2}, angle, [](auto& s) -> auto& { return s.track.inclination; });
  inclination.set_text = [](Scene& s, std::string_view v) {
    return parse_inclination(v, s.track.inclination);
  };
  keys.push_back(inclination);
  const auto rail = [&](std::string_view name, std::string_view meaning, const Sides& sides) {
    keys.push_back(profile_key(name, meaning, ProfileKind::rail, &SceneSide::rail, sides));
  };
  const auto moves = [&](auto... arguments) { keys.push_back(rail_key(arguments...)); };
  rail("track.rail", "profile of both rails", {&Scene::left, &Scene::right});
  rail("track.left.rail", "profile of the left rail", {&Scene::left});
  moves("track.left.displacement", displacements,
        "displacement of the left rail from its nominal position, for track irregularities or "
        "flexible track; roll about the origin of its profile",
        &Scene::left, &SceneSide::displacement);
  moves("track.left.velocity", velocities,
        "velocity of the left rail on flexible track; affects creepages from motion.*",
        &Scene::left, &SceneSide::velocity);
  moves("track.left.slope", slopes,
        "change of track.left.displacement along the track, of irregularities; with "
        "solve.derivatives creep_steady_error depends on it, forces do not",
        &Scene::left, &SceneSide::slope);
  rail("track.right.rail", "profile of the right rail", {&Scene::right});
  moves("track.right.displacement", displacements, "displacement of the right rail", &Scene::right,
        &SceneSide::displacement);
  moves("track.right.velocity", velocities, "velocity of the right rail", &Scene::right,
        &SceneSide::velocity);
  moves("track.right.slope", slopes, "change of track.right.displacement along the track",
        &Scene::right, &SceneSide::slope);
  return keys;
}

std::vector<Key> make_wheelset_keys() {
  std::vector<Key> keys;
  const auto wheel = [&](std::string_view name, std::string_view meaning, const Sides& sides) {
    keys.push_back(profile_key(name, meaning, ProfileKind::wheel, &SceneSide::wheel, sides));
  };
  const auto radius = [&](std::string_view name, std::string_view meaning, auto... sides) {
    keys.push_back(number_key({name, "460.0", "50 to 5000 mm", meaning}, {50.0, 5000.0}, length,
                              place_of(sides, &SceneSide::radius)...));
  };
  wheel("wheelset.wheel", "profile of both wheels", {&Scene::left, &Scene::right});
  keys.push_back(harmonics_key(
      "wheelset.harmonics",
      "waves of the radius around both wheels, amplitude cos(order theta - phase): order 1 is an "
      "eccentricity, higher ones polygons; theta points down at pose.pitch = theta",
      {&Scene::left, &Scene::right}));
  keys.push_back(number_key(
      {"wheelset.back_to_back", "1360.0", "500 to 1650 mm",
       "distance between the inner faces of the wheels"},
      {500.0, 1650.0}, length, [](auto& s) -> auto& { return s.back_to_back; }));
  keys.push_back(number_key(
      {"wheelset.tape_offset", "70.0", "20 to 120 mm",
       "distance from the inner face to the taping line"},
      {20.0, 120.0}, length, [](auto& s) -> auto& { return s.tape_offset; }));
  radius("wheelset.radius", "nominal rolling radius, at the taping line", &Scene::left,
         &Scene::right);
  wheel("wheelset.left.wheel", "profile of the left wheel", {&Scene::left});
  keys.push_back(harmonics_key("wheelset.left.harmonics", "waves of the radius of the left wheel",
                               {&Scene::left}));
  radius("wheelset.left.radius", "nominal radius of the left wheel", &Scene::left);
  wheel("wheelset.right.wheel", "profile of the right wheel", {&Scene::right});
  keys.push_back(harmonics_key("wheelset.right.harmonics", "waves of the radius of the right wheel",
                               {&Scene::right}));
  radius("wheelset.right.radius", "nominal radius of the right wheel", &Scene::right);
  return keys;
}

} // namespace wrc
