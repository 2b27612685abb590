#include "scene/scene_key_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "scene/key_makers.hpp"

namespace wrc {
namespace {

using namespace dimensions;
using namespace key_makers;

using Sides = std::vector<SceneSide Scene::*>;

/// The name of a profile on one or both sides, or a profile given by the program.
Key profile_key(KeyDescription description, ProfileKind kind, ProfileChoice SceneSide::*choice,
                const Sides& sides) {
  const auto set = [choice, sides](Scene& scene, std::string_view name,
                                   const std::shared_ptr<const Profile>& given) {
    std::vector<std::string> names(sides.size(), std::string(name)); // may run out of memory
    for (std::size_t i = 0; i < sides.size(); ++i) {
      ProfileChoice& chosen = (scene.*sides[i]).*choice;
      chosen.name = std::move(names[i]);
      chosen.given = given;
    }
  };
  Key key;
  key.description = description;
  key.get = [choice, sides](const Scene& scene) {
    const std::string& name = ((scene.*sides.front()).*choice).name;
    return name == ((scene.*sides.back()).*choice).name ? KeyValue(name) : KeyValue();
  };
  key.set_text = [set](Scene& scene, std::string_view name) {
    if (!name.empty()) {
      set(scene, name, nullptr);
    }
    return !name.empty();
  };
  key.set_profile = [set, kind](Scene& scene, const Profile& profile) {
    if (profile.kind == kind) {
      const bool built_in = profile.points.empty();
      set(scene, profile.name, built_in ? nullptr : std::make_shared<const Profile>(profile));
    }
    return profile.kind == kind;
  };
  return key;
}

/// A wavelength at which profiles are smoothed, on one or both sides.
struct Smoothing {
  std::optional<double> ProfileChoice::*member;
  Range range;
  std::string_view allowed;
};

constexpr Smoothing across{
    &ProfileChoice::smoothing, {0.0, 100.0}, "\"auto\", or 0 (none) to 100 mm"};
constexpr Smoothing along{
    &ProfileChoice::smoothing_along, {0.0, 1e6}, "\"auto\", or 0 (none) to 1e6 mm"};

Key smoothing_key(const Smoothing& smoothing, std::string_view name, std::string_view meaning,
                  ProfileChoice SceneSide::*choice, const Sides& sides) {
  const auto of = [ choice, member = smoothing.member ](auto& side) -> auto& {
    return (side.*choice).*member;
  };
  Key key;
  key.description = {name, "\"auto\"", smoothing.allowed, meaning};
  key.dimension = length;
  key.min = smoothing.range.min;
  key.max = smoothing.range.max;
  key.get = [of, sides](const Scene& scene) {
    const std::optional<double>& value = of(scene.*sides.front());
    if (value != of(scene.*sides.back())) {
      return KeyValue();
    }
    return value ? KeyValue(*value) : KeyValue(std::string("auto"));
  };
  key.set_number = [of, sides](Scene& scene, double value) {
    for (SceneSide Scene::*side : sides) {
      of(scene.*side) = value;
    }
  };
  key.set_text = [of, sides](Scene& scene, std::string_view value) {
    if (value != "auto") {
      return false;
    }
    for (SceneSide Scene::*side : sides) {
      of(scene.*side).reset();
    }
    return true;
  };
  return key;
}

/// What is said of a key with a rail's displacement, or its velocity.
struct RailMoves {
  std::string_view allowed;
  Three limits;
};

constexpr RailMoves displacements{
    "[lateral, vertical, roll], each -1e4 to 1e4 mm, the roll -0.2 to 0.2 rad", {1e4, 1e4, 0.2}};
constexpr RailMoves velocities{
    "[lateral, vertical, roll], each -1e6 to 1e6 mm/s, the roll -1e3 to 1e3 rad/s",
    {1e6, 1e6, 1e3}};

Key rail_key(std::string_view name, const RailMoves& moves, std::string_view meaning,
             SceneSide Scene::*side, RailDisplacement SceneSide::*member) {
  return three_key(
      {name, "[0.0, 0.0, 0.0]", moves.allowed, meaning}, moves.limits,
      {turning_length, turning_length, pure},
      [side, member](const Scene& scene) -> std::optional<Three> {
        const RailDisplacement& moved = (scene.*side).*member;
        return Three{moved.lateral, moved.height, moved.roll};
      },
      [side, member](Scene& scene, const Three& values) {
        (scene.*side).*member = {values[0], values[1], values[2]};
      });
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

Key rail_origin_key() {
  constexpr Range range{-2000.0, 2000.0};
  Key key;
  key.description = {"track.rail_origin", "\"gauge\"", "\"gauge\" or -2000 to 2000 mm",
                     "where rails are: by gauge and rail top, or the origin of their profiles this "
                     "far outside the track centre, at height 0"};
  key.dimension = length;
  key.min = range.min;
  key.max = range.max;
  key.get = [](const Scene& scene) {
    return scene.track.origin ? KeyValue(*scene.track.origin) : KeyValue(std::string("gauge"));
  };
  key.set_number = [](Scene& scene, double value) { scene.track.origin = value; };
  key.set_text = [](Scene& scene, std::string_view value) {
    if (value == "gauge") {
      scene.track.origin.reset();
    }
    return value == "gauge";
  };
  return key;
}

std::vector<Key> track_keys() {
  std::vector<Key> keys;
  keys.push_back(number_key(
      {"track.gauge", "1435.0", "600 to 1700 mm",
       "distance between the gauge faces at the gauge height"},
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
  keys.push_back(rail_origin_key());
  constexpr std::string_view allowed = "a text: a built-in rail or a profile file";
  const auto rail = [&](std::string_view name, std::string_view meaning, const Sides& sides) {
    keys.push_back(profile_key({name, "\"60E1\"", allowed, meaning}, ProfileKind::rail,
                               &SceneSide::rail, sides));
  };
  const auto smoothing = [&](std::string_view name, std::string_view meaning, const Sides& sides) {
    keys.push_back(smoothing_key(across, name, meaning, &SceneSide::rail, sides));
  };
  const auto moves = [&](auto... arguments) { keys.push_back(rail_key(arguments...)); };
  rail("track.rail", "profile of both rails", {&Scene::left, &Scene::right});
  smoothing("track.rail_smoothing", "smoothing wavelength of rail profiles read from a file",
            {&Scene::left, &Scene::right});
  keys.push_back(smoothing_key(along, "track.rail_smoothing_along",
                               "of rails that vary: waves along the track of this length are "
                               "halved, 0: the surface passes through the slices; auto: as the "
                               "slices file says",
                               &SceneSide::rail, {&Scene::left, &Scene::right}));
  rail("track.left.rail", "profile of the left rail", {&Scene::left});
  smoothing("track.left.rail_smoothing", "its smoothing wavelength, if read from a file",
            {&Scene::left});
  moves("track.left.displacement", displacements,
        "displacement of the left rail from its nominal position, for track irregularities or "
        "flexible track; roll about the origin of its profile",
        &Scene::left, &SceneSide::displacement);
  moves("track.left.velocity", velocities,
        "velocity of the left rail on flexible track; affects creepages from motion.*",
        &Scene::left, &SceneSide::velocity);
  rail("track.right.rail", "profile of the right rail", {&Scene::right});
  smoothing("track.right.rail_smoothing", "its smoothing wavelength, if read from a file",
            {&Scene::right});
  moves("track.right.displacement", displacements, "displacement of the right rail", &Scene::right,
        &SceneSide::displacement);
  moves("track.right.velocity", velocities, "velocity of the right rail", &Scene::right,
        &SceneSide::velocity);
  return keys;
}

Key align_key() {
  Key key;
  key.description = {"wheelset.align_to", "\"none\"",
                     "\"none\" or a text: a built-in wheel or a profile file",
                     "nominal profile on which wheel profiles read from a file are laid where they "
                     "are not worn"};
  key.get = [](const Scene& scene) {
    return KeyValue(scene.align_to.empty() ? std::string("none") : scene.align_to);
  };
  key.set_text = [](Scene& scene, std::string_view value) {
    if (value == "none")
      scene.align_to.clear();
    else if (!value.empty())
      scene.align_to = value;
    return !value.empty();
  };
  return key;
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

std::vector<Key> wheelset_keys() {
  std::vector<Key> keys;
  constexpr std::string_view allowed = "a text: a built-in wheel or a profile file";
  const auto wheel = [&](std::string_view name, std::string_view meaning, const Sides& sides) {
    keys.push_back(profile_key({name, "\"S1002\"", allowed, meaning}, ProfileKind::wheel,
                               &SceneSide::wheel, sides));
  };
  const auto smoothing = [&](std::string_view name, std::string_view meaning, const Sides& sides) {
    keys.push_back(smoothing_key(across, name, meaning, &SceneSide::wheel, sides));
  };
  const auto radius = [&](std::string_view name, std::string_view meaning, auto... sides) {
    keys.push_back(number_key({name, "460.0", "50 to 5000 mm", meaning}, {50.0, 5000.0}, length,
                              place_of(sides, &SceneSide::radius)...));
  };
  wheel("wheelset.wheel", "profile of both wheels", {&Scene::left, &Scene::right});
  keys.push_back(smoothing_key(along, "wheelset.wheel_smoothing_along",
                               "the same of wheels that vary, on their circumference",
                               &SceneSide::wheel, {&Scene::left, &Scene::right}));
  keys.push_back(harmonics_key(
      "wheelset.harmonics",
      "waves of the radius around both wheels, amplitude cos(order theta - phase): order 1 is an "
      "eccentricity, higher ones polygons; theta points down at pose.pitch = theta",
      {&Scene::left, &Scene::right}));
  smoothing("wheelset.wheel_smoothing", "smoothing wavelength of wheel profiles read from a file",
            {&Scene::left, &Scene::right});
  keys.push_back(number_key(
      {"wheelset.back_to_back", "1360.0", "500 to 1650 mm",
       "distance between the inner faces of the wheels"},
      {500.0, 1650.0}, length, [](auto& s) -> auto& { return s.back_to_back; }));
  keys.push_back(number_key(
      {"wheelset.tape_offset", "70.0", "20 to 120 mm",
       "distance from the inner face to the taping line"},
      {20.0, 120.0}, length, [](auto& s) -> auto& { return s.tape_offset; }));
  keys.push_back(word_key<WheelOrigin>(
      {"wheelset.profile_origin", "\"auto\"", "\"auto\", \"tape\" or \"flange-back\"",
       "where wheel profiles read from a file have lateral 0"},
      {{"auto", WheelOrigin::by_file},
       {"tape", WheelOrigin::tape},
       {"flange-back", WheelOrigin::flange_back}},
      [](auto& s) -> auto& { return s.profile_origin; }));
  keys.push_back(number_key(
      {"wheelset.profile_shift", "0.0", "-500 to 500 mm",
       "shift added to lateral positions of wheel profiles read from a file, instead of "
       "wheelset.profile_origin, so that the taping line is at 0; 0: none"},
      {-500.0, 500.0}, length, [](auto& s) -> auto& { return s.profile_shift; }));
  keys.push_back(optional_key(
      {"wheelset.profile_rotation", "\"auto\"", "\"auto\" or -0.5 to 0.5 rad",
       "rotation of wheel profiles read from a file, anticlockwise in (lateral, height) about the "
       "taping line; \"auto\": that of parallel faces, else a warning where a tilt shows; 0: none"},
      {-0.5, 0.5}, pure, &Scene::profile_rotation, "auto"));
  keys.push_back(align_key());
  radius("wheelset.radius", "nominal rolling radius, at the taping line", &Scene::left,
         &Scene::right);
  wheel("wheelset.left.wheel", "profile of the left wheel", {&Scene::left});
  keys.push_back(harmonics_key("wheelset.left.harmonics", "waves of the radius of the left wheel",
                               {&Scene::left}));
  smoothing("wheelset.left.wheel_smoothing", "its smoothing wavelength, if read from a file",
            {&Scene::left});
  radius("wheelset.left.radius", "nominal radius of the left wheel", &Scene::left);
  wheel("wheelset.right.wheel", "profile of the right wheel", {&Scene::right});
  keys.push_back(harmonics_key("wheelset.right.harmonics", "waves of the radius of the right wheel",
                               {&Scene::right}));
  smoothing("wheelset.right.wheel_smoothing", "its smoothing wavelength, if read from a file",
            {&Scene::right});
  radius("wheelset.right.radius", "nominal radius of the right wheel", &Scene::right);
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
      optional_key({"material.yield_pressure", "\"none\"", "\"none\" or 1 to 1e9 MPa",
                    "maximum pressure above which left.state and right.state report beyond yield; "
                    "changes no other result"},
                   {1.0, 1e9}, stress, &Scene::yield_pressure, "none"),
      modulus("material.wheel.youngs_modulus", "Young's modulus of the wheel alone", wheel_modulus),
      poisson("material.wheel.poisson", "Poisson's ratio of the wheel alone", wheel_poisson),
      modulus("material.rail.youngs_modulus", "Young's modulus of the rail alone", rail_modulus),
      poisson("material.rail.poisson", "Poisson's ratio of the rail alone", rail_poisson)};
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
  keys.push_back(number_key({"pose.pitch", "0.0", "-1e9 to 1e9 rad",
                             "turn of the wheelset about its axle, positive rolling forwards: the "
                             "angle of the slices of a wheel that varies that points down; no "
                             "effect on other wheels"},
                            {-1e9, 1e9}, pure, &Scene::pitch));
  keys.push_back(
      number_key({"pose.yaw", "0.0", "-0.2 to 0.2 rad", "yaw, anticlockwise seen from above"},
                 {-0.2, 0.2}, turning_angle, &Scene::yaw));
  Key roll = optional_key({"pose.roll", "\"solve\"", "\"solve\", \"en15302\" or -0.2 to 0.2 rad",
                           "roll, positive lifts the left wheel; solve: both wheels touch; "
                           "en15302: no roll, each wheel separately"},
                          {-0.2, 0.2}, pure, &Scene::roll, "solve");
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
  keys.push_back(word_key<GapConvention>(
      {"solve.gap", "\"tangent\"", "\"tangent\" or \"vertical\"",
       "direction in which the gap is measured; vertical as in the paper"},
      {{"tangent", GapConvention::tangent}, {"vertical", GapConvention::vertical}}, &Scene::gap));
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
  keys.push_back(word_key<SolverChoice>(
      {"solve.solver", "\"default\"", "\"default\" or \"paper\"",
       "solver of the half-space; paper is Polonsky & Keer 1999, for comparison"},
      {{name_of(SolverChoice::standard), SolverChoice::standard},
       {name_of(SolverChoice::paper), SolverChoice::paper}},
      &Scene::solver));
  keys.push_back(word_key<std::optional<Elements>>(
      {"solve.elements", "\"auto\"", "\"auto\", \"smooth\" or \"constant\"",
       "pressure on an element: smooth through the values at the centres, which is more accurate; "
       "or constant on each, as in other programs; auto: smooth, with solver paper constant"},
      {{"auto", std::nullopt}, {"smooth", Elements::smooth}, {"constant", Elements::constant}},
      &Scene::elements));
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
  keys.push_back(number_key({"solve.tolerance", "1e-5", "1e-13 to 0.1",
                             "tolerance of the iteration on a given solve.grid: largest error of a "
                             "pressure relative to the maximum pressure (solver paper: of a gap); "
                             "without solve.grid it follows from the accuracy"},
                            {1e-13, 0.1}, pure, &Scene::tolerance));
  Key limit = number_key({"solve.element_limit", "100000", "a whole number, 1000 to 67108864",
                          "largest number of elements that an accuracy may use for all patches of "
                          "a wheel together, and for their creep forces; if it needs more, "
                          "elements are larger and a warning says so; solve.grid has no limit"},
                         {1e3, 67108864.0}, pure, &Scene::element_limit);
  limit.whole = true;
  keys.push_back(limit);
  return keys;
}

std::vector<Key> solution_keys() {
  std::vector<Key> keys;
  keys.push_back(word_key<Precision>(
      {"solve.precision", "\"mixed\"", "\"mixed\" or \"double\"",
       "precision of the iteration; mixed is faster and meets the same tolerance"},
      {{"mixed", Precision::mixed}, {"double", Precision::double_only}}, &Scene::precision));
  keys.push_back(word_key<PlannerRigor>(
      {"solve.planner", "\"estimate\"", "\"estimate\" or \"measure\"",
       "how FFTW chooses its algorithms: by rule, or by timing them once"},
      {{"estimate", PlannerRigor::estimate}, {"measure", PlannerRigor::measure}}, &Scene::planner));
  keys.push_back(word_key<Interaction>(
      {"solve.interaction", "\"all\"", "\"all\" or \"near\"",
       "which patches of a wheel displace each other: all, in proportion to the cosine between "
       "their planes, or those close to each other, as in CONTACT"},
      {{"all", Interaction::all}, {"near", Interaction::near}}, &Scene::interaction));
  keys.push_back(
      number_key({"solve.joining_distance", "4", "0 to 100 mm",
                  "penetrations closer than twice this distance share a plane and count as one "
                  "contact, unless their angles differ greatly; 0: only their widths decide"},
                 {0.0, 100.0}, length, &Scene::joining_distance));
  keys.push_back(number_key(
      {"solve.near_tolerance", "0.1", "0 to 10 mm",
       "further contacts are listed if their distance at first touch is smaller than this"},
      {0.0, 10.0}, length, &Scene::near_tolerance));
  Key threads;
  threads.description = {"solve.threads", "1", "a whole number, 1 to 1024",
                         "number of threads; results do not depend on it"};
  threads.min = 1.0;
  threads.max = 1024.0;
  threads.whole = true;
  threads.get = [](const Scene& s) { return KeyValue(static_cast<double>(s.threads)); };
  threads.set_number = [](Scene& s, double v) { s.threads = static_cast<int>(v); };
  keys.push_back(threads);
  return keys;
}

} // namespace

std::vector<Key> make_scene_keys() {
  std::vector<Key> collected;
  for (auto* part :
       {convention_keys, track_keys, wheelset_keys, material_keys, pose_keys, make_load_keys,
        make_rolling_keys, method_keys, accuracy_keys, solution_keys, make_damage_keys}) {
    for (Key& key : part()) {
      collected.push_back(std::move(key));
    }
  }
  return collected;
}

} // namespace wrc
