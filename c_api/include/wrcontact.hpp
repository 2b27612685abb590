// wrcontact for C++: the C interface with owned handles and exceptions; header only, C++17.
//
// Everything is documented in wrcontact.h: units, frame, keys, names of results, thread rules.
// Handles are owned and can be moved, not copied. A failure throws wrcontact::Error with the status
// and the text of the handle; a solution that has not converged does not throw: solve() returns
// false and the results are there. Nothing here crosses the library's boundary but C calls, so a
// program may be built with another compiler or standard library than the library. Since 0.2.
#ifndef WRCONTACT_HPP
#define WRCONTACT_HPP

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "wrcontact.h"

namespace wrcontact {

class Error : public std::runtime_error {
public:
  Error(wrc_status status, const std::string& text)
      : std::runtime_error(text.empty() ? wrc_status_name(status) : text), status_(status) {}
  wrc_status status() const noexcept { return status_; }

private:
  wrc_status status_;
};

namespace detail {

/// A handle and the functions of its kind.
template <class Handle, wrc_status (*create)(Handle**), void (*destroy)(Handle*),
          const char* (*error)(const Handle*)>
class Owner {
public:
  Owner() {
    const wrc_status status = create(&handle_);
    if (status != WRC_OK) {
      throw Error(status, "");
    }
  }
  ~Owner() { destroy(handle_); }
  Owner(Owner&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Owner& operator=(Owner&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Owner(const Owner&) = delete;
  Owner& operator=(const Owner&) = delete;

  /// For calls of the C interface; still owned here.
  Handle* handle() const noexcept { return handle_; }

protected:
  void check(wrc_status status) const {
    if (status != WRC_OK) {
      throw Error(status, error(handle_));
    }
  }
  /// Whether a solution has converged; throws if there is none.
  bool converged(wrc_status status) const {
    if (status != WRC_NOT_CONVERGED) {
      check(status);
    }
    return status == WRC_OK;
  }
  /// The value that a call stores in its last argument: a number, a text.
  template <class Value, class Call, class... Arguments>
  Value value_of(Call call, const Arguments&... arguments) const {
    Value value{};
    check(call(handle_, arguments..., &value));
    return value;
  }
  /// Texts of a call that gives them one by one.
  template <class Call> std::vector<std::string> texts_of(Call call) const {
    std::vector<std::string> texts;
    for (std::int64_t i = 0; const char* text = call(handle_, i); ++i) {
      texts.emplace_back(text);
    }
    return texts;
  }
  /// All values of a call that copies as wrc_scene_field does.
  template <class Copy> std::vector<double> copied(Copy&& copy) const {
    std::int64_t count = 0;
    check(copy(nullptr, std::int64_t{0}, &count));
    std::vector<double> values(static_cast<std::size_t>(count));
    check(copy(values.data(), count, &count));
    return values;
  }

private:
  Handle* handle_ = nullptr;
};

} // namespace detail

/// A wheel or rail profile (wrc_profile).
class Profile : public detail::Owner<wrc_profile, wrc_profile_create, wrc_profile_destroy,
                                     wrc_profile_error> {
public:
  void load_standard(const std::string& name) {
    check(wrc_profile_load_standard(handle(), name.c_str()));
  }
  void load_file(const std::string& path, const wrc_read_options* options = nullptr) {
    check(wrc_profile_load_file(handle(), path.c_str(), options));
  }
  /// `kind` is WRC_WHEEL or WRC_RAIL.
  void set_points(const std::string& name, std::int32_t kind, const std::vector<double>& lateral,
                  const std::vector<double>& height,
                  std::optional<double> smoothing_wavelength = std::nullopt) {
    if (lateral.size() != height.size()) {
      throw Error(WRC_INVALID_ARGUMENT, "lateral and height differ in length");
    }
    wrc_read_options options{};
    options.struct_size = sizeof options;
    options.kind = kind;
    options.kind_given = 1;
    if (smoothing_wavelength) { // 0: none
      options.smoothing_wavelength =
          *smoothing_wavelength == 0.0 ? WRC_SMOOTHING_NONE : *smoothing_wavelength;
    }
    check(wrc_profile_set_points(handle(), name.c_str(), lateral.data(), height.data(),
                                 static_cast<std::int64_t>(lateral.size()), &options));
  }
  void write(const std::string& path, double spacing) const {
    check(wrc_profile_write(handle(), path.c_str(), spacing));
  }

  std::int32_t kind() const { return value_of<std::int32_t>(wrc_profile_kind); }
  std::string text(const std::string& name) const {
    return value_of<const char*>(wrc_profile_text, name.c_str());
  }
  std::vector<std::string> corrections() const { return texts_of(wrc_profile_correction); }
  std::vector<std::string> warnings() const { return texts_of(wrc_profile_warning); }
  struct Points {
    std::vector<double> lateral;
    std::vector<double> height;
  };
  /// `which` is WRC_POINTS_READ or WRC_POINTS_DROPPED.
  Points points(std::int32_t which) const {
    std::int64_t count = 0;
    check(wrc_profile_points(handle(), which, nullptr, nullptr, 0, &count));
    const auto size = static_cast<std::size_t>(count);
    Points all{std::vector<double>(size), std::vector<double>(size)};
    check(
        wrc_profile_points(handle(), which, all.lateral.data(), all.height.data(), count, &count));
    return all;
  }
  double length() const { return value_of<double>(wrc_profile_length); }
  std::vector<double> nodes() const {
    return copied([this](double* values, std::int64_t capacity, std::int64_t* count) {
      return wrc_profile_nodes(handle(), values, capacity, count);
    });
  }

  /// Reads a surface of slices; returns the number of its sheets, for wrc_profile_surface_at.
  std::int64_t load_surface(const std::string& path, const wrc_read_options* options = nullptr,
                            double smoothing_length = -1.0) {
    return value_of<std::int64_t>(wrc_profile_load_surface, path.c_str(), options,
                                  smoothing_length);
  }
  std::vector<std::string> surface_lines() const { return texts_of(wrc_profile_surface_line); }

  struct Point {
    double lateral, height, angle, curvature;
  };
  /// The curve at an arc length.
  Point at(double arc) const {
    Point point{};
    check(wrc_profile_at(handle(), arc, &point.lateral, &point.height, &point.angle,
                         &point.curvature));
    return point;
  }
};

/// Names of the built-in profiles of a kind, WRC_WHEEL or WRC_RAIL.
inline std::vector<std::string> standard_profile_names(std::int32_t kind) {
  std::vector<std::string> names;
  for (std::int64_t i = 0; const char* name = wrc_profile_standard_name(kind, i); ++i) {
    names.emplace_back(name);
  }
  return names;
}

/// A key of a scene; the texts belong to the library and stay.
struct SceneKey {
  const char *name, *default_value, *allowed, *meaning;
};
/// All keys, in the order of a scene file.
inline std::vector<SceneKey> scene_keys() {
  std::vector<SceneKey> keys(static_cast<std::size_t>(wrc_scene_key_count()));
  std::int64_t i = 0;
  for (SceneKey& key : keys) {
    wrc_scene_key(i++, &key.name, &key.default_value, &key.allowed, &key.meaning);
  }
  return keys;
}

/// The inputs of a scene and its results (wrc_scene).
class Scene
    : public detail::Owner<wrc_scene, wrc_scene_create, wrc_scene_destroy, wrc_scene_error> {
public:
  void set(const std::string& key, double value) {
    check(wrc_scene_set_number(handle(), key.c_str(), value));
  }
  void set(const std::string& key, const std::string& value) {
    if (value.find('\0') != std::string::npos) { // C would not read on
      throw Error(WRC_INVALID_ARGUMENT, key + ": the text has a zero byte; it must have none");
    }
    check(wrc_scene_set_text(handle(), key.c_str(), value.c_str()));
  }
  void set(const std::string& key, const char* value) {
    check(wrc_scene_set_text(handle(), key.c_str(), value));
  }
  /// Whole numbers, so that 0 is no null pointer, and lists in braces.
  template <class Whole, std::enable_if_t<std::is_integral<Whole>::value, int> = 0>
  void set(const std::string& key, Whole value) {
    set(key, static_cast<double>(value));
  }
  void set(const std::string& key, std::initializer_list<double> values) {
    set(key, std::vector<double>(values));
  }
  void set(const std::string& key, const std::vector<double>& values) {
    check(wrc_scene_set_numbers(handle(), key.c_str(), values.data(),
                                static_cast<std::int64_t>(values.size())));
  }
  void set(const std::string& key, const Profile& profile) {
    check(wrc_scene_set_profile(handle(), key.c_str(), profile.handle()));
  }
  double get_number(const std::string& key) const {
    return value_of<double>(wrc_scene_get_number, key.c_str());
  }
  std::string get_text(const std::string& key) const {
    return value_of<const char*>(wrc_scene_get_text, key.c_str());
  }
  std::vector<double> get_numbers(const std::string& key) const {
    return copied([&](double* values, std::int64_t capacity, std::int64_t* count) {
      return wrc_scene_get_numbers(handle(), key.c_str(), values, capacity, count);
    });
  }
  /// Writes a file that wrc_case solves again.
  void write(const std::string& path) const { check(wrc_scene_write(handle(), path.c_str())); }

  /// False if the iteration has not converged.
  bool solve() { return converged(wrc_scene_solve(handle())); }

  bool has_number(const std::string& name) const {
    double value = 0.0;
    return wrc_scene_number(handle(), name.c_str(), &value) == WRC_OK;
  }
  double number(const std::string& name) const {
    return value_of<double>(wrc_scene_number, name.c_str());
  }
  /// The number, or another value if the scene has none of this name.
  double number_or(const std::string& name, double otherwise) const {
    double value = otherwise;
    return wrc_scene_number(handle(), name.c_str(), &value) == WRC_OK ? value : otherwise;
  }
  /// Ids, the same for all scenes, of keys and of names of results. Since 0.3.
  std::int32_t key_id(const std::string& key) const {
    return value_of<std::int32_t>(wrc_scene_key_id, key.c_str());
  }
  std::int32_t number_id(const std::string& name) const {
    return value_of<std::int32_t>(wrc_scene_number_id, name.c_str());
  }
  /// "MPa", "N mm/s", ... by convention.units. Since 0.3.
  std::string number_unit(const std::string& name) const {
    return value_of<const char*>(wrc_scene_number_unit, name.c_str());
  }
  /// Of a key: "mm", or "" if it holds no number. Since 0.4.
  std::string key_unit(const std::string& key) const {
    return value_of<const char*>(wrc_scene_key_unit, key.c_str());
  }
  /// Sets all or, if one is refused, none. Ids (std::int32_t) and values (double) are a
  /// std::vector, a std::array or the like, of the same length. Since 0.3.
  template <class Ids, class Values> void set_numbers_by_id(const Ids& ids, const Values& values) {
    check(wrc_scene_set_numbers_by_id(handle(), ids.data(), values.data(),
                                      common_length(ids, values)));
  }
  /// Fills the values; results that do not exist are NaN. Since 0.3.
  template <class Ids, class Values> void numbers_by_id(const Ids& ids, Values&& values) const {
    check(wrc_scene_numbers_by_id(handle(), ids.data(), values.data(), common_length(ids, values)));
  }
  std::string text(const std::string& name) const {
    return value_of<const char*>(wrc_scene_text, name.c_str());
  }
  /// All warnings of the solution, each with the profile or wheel it concerns. Since 0.3.
  std::vector<std::string> warnings() const { return texts_of(wrc_scene_warning); }
  std::vector<double> field(const std::string& name) const {
    return copied([&](double* values, std::int64_t capacity, std::int64_t* count) {
      return wrc_scene_field(handle(), name.c_str(), values, capacity, count);
    });
  }
  std::vector<std::string> number_names() const { return texts_of(wrc_scene_number_name); }
  std::vector<std::string> text_names() const { return texts_of(wrc_scene_text_name); }

  /// Entries of a list of results, for example of "left.patches".
  int count_of(const std::string& list) const {
    const std::string prefix = list + '.';
    int count = 0;
    for (const auto& names : {number_names(), text_names()}) {
      for (const std::string& name : names) {
        if (name.compare(0, prefix.size(), prefix) == 0) {
          count = std::max(count, std::stoi(name.substr(prefix.size())) + 1);
        }
      }
    }
    return count;
  }

  /// A table over values of keys (wrc_scene_tabulate), the first key fastest; into a file as well
  /// if a path is given. Since 0.3.
  std::vector<double> tabulate(const std::vector<std::pair<std::string, std::vector<double>>>& axes,
                               const std::vector<std::string>& results, std::int32_t threads = 1,
                               const std::string& path = "") {
    std::string keys;
    std::string names;
    std::vector<double> values;
    std::vector<std::int64_t> counts;
    std::size_t size = results.size();
    for (const auto& [key, of_key] : axes) {
      keys += key + ' ';
      values.insert(values.end(), of_key.begin(), of_key.end());
      counts.push_back(static_cast<std::int64_t>(of_key.size()));
      size *= of_key.size();
    }
    for (const std::string& name : results) {
      names += name + ' ';
    }
    std::vector<double> table(size);
    check(wrc_scene_tabulate(handle(), keys.c_str(), values.data(), counts.data(), names.c_str(),
                             threads, path.c_str(), table.data()));
    return table;
  }

  /// All contact patches, in an order that stays from step to step. Since 0.3.
  std::vector<wrc_patch> patches() const {
    std::int64_t count = 0;
    check(wrc_scene_patches(handle(), nullptr, sizeof(wrc_patch), 0, &count));
    std::vector<wrc_patch> all(static_cast<std::size_t>(count));
    if (count > 0) {
      check(wrc_scene_patches(handle(), all.data(), sizeof(wrc_patch), count, &count));
    }
    return all;
  }

private:
  friend class Solver;

  template <class Ids, class Values>
  static std::int64_t common_length(const Ids& ids, const Values& values) {
    if (ids.size() != values.size()) {
      throw Error(WRC_INVALID_ARGUMENT, "ids and values differ in length");
    }
    return static_cast<std::int64_t>(ids.size());
  }
};

/// Results of a step of a wheelset (wrc_solver_step). Since 0.3.
struct Step {
  std::array<double, 12> force{};       ///< of the left wheel, then of the right one
  std::array<double, 72> by_position{}; ///< zeros unless requested, as by_velocity
  std::array<double, 72> by_velocity{};
  std::array<std::int32_t, 2> states{};
};

/// What the contacts of a wheelset remember from one step of time to the next (wrc_history). Since
/// 0.3.
class History : public detail::Owner<wrc_history, wrc_history_create, wrc_history_destroy,
                                     wrc_history_error> {
public:
  /// Later steps start from the state after the last one.
  void accept() { check(wrc_history_accept(handle())); }
  /// Back to no displacements.
  void clear() { check(wrc_history_clear(handle())); }
  /// Takes over the state of another one.
  void copy(const History& from) { check(wrc_history_copy(handle(), from.handle())); }
};

/// Further arguments and results of a step (wrc_step_arguments); inputs that are not set stay as in
/// the scene. Since 0.3.
struct StepArguments {
  std::optional<std::array<double, 6>> rails;
  std::optional<std::array<double, 6>> rail_velocities;
  std::optional<double> curvature;
  std::optional<std::array<double, 2>> friction;
  const History* history = nullptr; ///< creep forces of a step of time from it; none: steady
  double time_step = 0.0;           ///< s, with a history
  bool derivatives = false;
  std::array<double, 36> by_rail{}; ///< zeros unless derivatives are requested
  std::array<double, 36> by_rail_velocity{};
};

/// Data kept from one scene to the next (wrc_solver).
class Solver
    : public detail::Owner<wrc_solver, wrc_solver_create, wrc_solver_destroy, wrc_solver_error> {
public:
  /// False if the iteration has not converged; failures are those of the scene.
  bool solve(Scene& scene) { return scene.converged(wrc_solver_solve(handle(), scene.handle())); }
  /// "planner" or "precision" (wrc_solver_set_text). Since 0.4.
  void set(const std::string& key, const std::string& value) {
    check(wrc_solver_set_text(handle(), key.c_str(), value.c_str()));
  }
  void clear() { check(wrc_solver_clear(handle())); }
  /// A step; false if it has not converged. `rails`: as in the scene if null. Since 0.3.
  bool step(Scene& scene, const std::array<double, 6>& position,
            const std::array<double, 6>& velocity, Step& result, bool derivatives = false,
            const std::array<double, 6>* rails = nullptr) {
    return scene.converged(
        wrc_solver_step(handle(), scene.handle(), position.data(), velocity.data(),
                        rails != nullptr ? rails->data() : nullptr, result.force.data(),
                        derivatives ? result.by_position.data() : nullptr,
                        derivatives ? result.by_velocity.data() : nullptr, result.states.data()));
  }
  /// The same with further arguments (wrc_solver_step_with). Since 0.3.
  bool step(Scene& scene, const std::array<double, 6>& position,
            const std::array<double, 6>& velocity, Step& result, StepArguments& arguments) {
    wrc_history* history = nullptr;
    const wrc_step_arguments passed = passed_on(arguments, result, history);
    return scene.converged(wrc_solver_step_with(handle(), scene.handle(), position.data(),
                                                velocity.data(), &passed, result.force.data()));
  }
  /// Sets height and roll of the position such that the wheels carry these loads
  /// (wrc_solver_equilibrium, WRC_LOADS_OF_WHEELS or WRC_LOAD_OF_AXLE); velocity: as in the scene
  /// if null. False if the loads are met only roughly. Since 0.3.
  bool equilibrium(Scene& scene, std::int32_t kind, const std::array<double, 2>& loads,
                   std::array<double, 6>& position, Step& result, StepArguments& arguments,
                   const std::array<double, 6>* velocity = nullptr) {
    wrc_history* history = nullptr;
    const wrc_step_arguments passed = passed_on(arguments, result, history);
    return scene.converged(wrc_solver_equilibrium(handle(), scene.handle(), kind, loads.data(),
                                                  velocity != nullptr ? velocity->data() : nullptr,
                                                  &passed, position.data(), result.force.data()));
  }
  /// Forces of a patch at the caller's creepages (wrc_solver_creep): longitudinal, lateral,
  /// spin moment; and if requested their 9 derivatives. Since 0.3.
  std::array<double, 3> creep(Scene& scene, std::int64_t patch,
                              const std::array<double, 3>& creepages,
                              std::array<double, 9>* by_creepage = nullptr) {
    std::array<double, 3> forces{};
    scene.check(wrc_solver_creep(handle(), scene.handle(), patch, creepages.data(), forces.data(),
                                 by_creepage != nullptr ? by_creepage->data() : nullptr));
    return forces;
  }

private:
  friend class Table;
  /// `history` holds the handle as long as the arguments are used.
  static wrc_step_arguments passed_on(StepArguments& arguments, Step& result,
                                      wrc_history*& history) {
    wrc_step_arguments passed{};
    passed.struct_size = sizeof passed;
    passed.rails = arguments.rails ? arguments.rails->data() : nullptr;
    passed.rail_velocities =
        arguments.rail_velocities ? arguments.rail_velocities->data() : nullptr;
    passed.curvature = arguments.curvature ? &*arguments.curvature : nullptr;
    passed.friction = arguments.friction ? arguments.friction->data() : nullptr;
    passed.states = result.states.data();
    history = arguments.history != nullptr ? arguments.history->handle() : nullptr;
    passed.histories = history != nullptr ? &history : nullptr;
    passed.time_step = arguments.time_step;
    if (arguments.derivatives) {
      passed.by_position = result.by_position.data();
      passed.by_velocity = result.by_velocity.data();
      passed.by_rail = arguments.by_rail.data();
      passed.by_rail_velocity = arguments.by_rail_velocity.data();
    }
    return passed;
  }
};

/// Solves each scene by itself; the status of each.
inline std::vector<wrc_status> solve_batch(const std::vector<Scene*>& scenes,
                                           std::int32_t threads) {
  std::vector<wrc_scene*> handles;
  handles.reserve(scenes.size());
  for (const Scene* scene : scenes) {
    handles.push_back(scene->handle());
  }
  std::vector<wrc_status> statuses(scenes.size(), WRC_INVALID_ARGUMENT);
  // Handles are owned, so that only the number of threads can be refused for all of them.
  wrc_solve_batch(handles.data(), static_cast<std::int64_t>(handles.size()), threads,
                  statuses.data());
  return statuses;
}

} // namespace wrcontact

#include "wrcontact_grid.hpp"  // IWYU pragma: export
#include "wrcontact_table.hpp" // IWYU pragma: export

#endif
