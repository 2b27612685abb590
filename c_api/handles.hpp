/// What stands behind the opaque handles, and the guard every entry point runs in.
#pragma once

#include <memory>
#include <new>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "floating_point.hpp"
#include "half_space/fft.hpp"
#include "half_space/material.hpp"
#include "handle_table.hpp"
#include "keys/scene.hpp"
#include "measured/readers.hpp"
#include "mechanics/normal_contact.hpp"
#include "mechanics/normal_solver.hpp"
#include "pressure/pressure_field.hpp"
#include "profile/profile.hpp"
#include "rolling/rolling_contact.hpp"
#include "scene/profile_surface.hpp"
#include "scene/solve_scene.hpp"
#include "scene/surface_cache.hpp"
#include "scene/vehicle_step.hpp"
#include "table/contact_table.hpp"
#include "wrcontact.h"

namespace wrc {

struct SceneObject {
  Scene scene;
  std::optional<SceneResult> result;
  std::shared_ptr<SurfaceCache> surfaces; ///< of its last solutions by itself; none: there was none
  // Made from the result when first requested.
  std::vector<std::string> number_names;
  std::vector<std::pair<std::string, std::string>> texts;
  std::optional<Warnings> warnings;
  std::optional<std::pair<std::string, std::vector<double>>> field; ///< the last one requested
  std::vector<double> numbers;                                      ///< the last ones read by id
  std::string input_text; ///< the last text of an input requested
  std::string unit;       ///< the last one requested
  std::string error;
  /// A name that no result has, until the error's text is read: programs try names, and looking for
  /// the nearest ones takes as long as a small solution.
  std::optional<std::string> unknown_result;

  /// Takes a new result in; returns its status.
  wrc_status take_result(SceneResult&& new_result);
};

struct SolverObject {
  SceneSolver solver;
  SolverOptions options;
  std::string error;
};

struct HistoryObject {
  std::shared_ptr<const ContactHistory> accepted = std::make_shared<const ContactHistory>();
  std::shared_ptr<const ContactHistory> after; ///< the last step since; none: there was none
  std::string error;
};

struct ProfileObject {
  std::optional<Profile> profile;
  ReadResult read; ///< of a profile that was read, without the profile itself
  std::optional<ProfileSurface> surface;
  std::vector<std::string> surface_lines;
  std::string error;

  void take(ReadResult&& result) {
    profile = std::move(result.profile);
    read = std::move(result);
  }
};

/// The problem last solved by a wrc_normal, and its solution.
struct NormalResult {
  std::shared_ptr<const std::vector<double>> distance; ///< what the patch's span refers to
  std::vector<PatchGap> patches;                       ///< one: what the problem's span refers to
  NormalProblem problem;
  NormalSolution solution;
  PressureRegion summary;
  Warnings warnings;
  std::vector<double> displacement; ///< mm; empty until requested
  std::optional<Residuals> residuals;
};

struct NormalObject {
  NormalObject() {
    const Material steel{210000.0, 0.3};
    problem.combined_modulus = combined_modulus(steel, steel);
  }

  Grid grid;
  std::shared_ptr<const std::vector<double>> distance;
  NormalProblem problem; ///< its span is set at each solve
  bool paper_method = false;
  std::optional<Elements> elements; ///< smooth, but constant with the paper's method, if not set
  SolverOptions options;
  std::optional<NormalSolver> solver; ///< none until first used with these settings
  std::optional<NormalResult> result;
  std::string error;
};

struct RollingObject {
  RollingObject() {
    const Material steel{210000.0, 0.28};
    problem.shear_modulus = steel.youngs_modulus / (2.0 * (1.0 + steel.poisson));
    problem.poisson = steel.poisson;
  }

  std::vector<double> pressure;
  std::vector<double> slip_x; ///< of each element, in addition to creepages; empty: none
  std::vector<double> slip_y;
  std::vector<double> previous_x; ///< tractions before a step or a shift; empty: none
  std::vector<double> previous_y;
  RollingProblem problem; ///< its spans are set at each solve
  bool fastsim = false;   ///< instead of the full model
  RollingSolver solver;
  std::optional<RollingSolution> result;
  std::string error;
};

struct TableObject {
  std::shared_ptr<const ContactTable> table; ///< none until built, loaded or shared
  std::vector<std::string> lines;            ///< about it; made when first requested
  std::string error;

  void take(std::shared_ptr<const ContactTable> other) {
    table = std::move(other);
    lines.clear();
  }
};

/// From the kind of a handle to the kind of object it stands for, and the table of these.
template <class Handle> struct ObjectOf;
template <> struct ObjectOf<wrc_scene> {
  using type = SceneObject;
  static constexpr const char* missing = "scene = NULL: a handle must be given";
};
template <> struct ObjectOf<wrc_solver> {
  using type = SolverObject;
  static constexpr const char* missing = "solver = NULL: a handle must be given";
};
template <> struct ObjectOf<wrc_history> {
  using type = HistoryObject;
  static constexpr const char* missing = "history = NULL: a handle must be given";
};
template <> struct ObjectOf<wrc_profile> {
  using type = ProfileObject;
  static constexpr const char* missing = "profile = NULL: a handle must be given";
};
template <> struct ObjectOf<wrc_normal> {
  using type = NormalObject;
  static constexpr const char* missing = "normal = NULL: a handle must be given";
};
template <> struct ObjectOf<wrc_rolling> {
  using type = RollingObject;
  static constexpr const char* missing = "rolling = NULL: a handle must be given";
};

template <> struct ObjectOf<wrc_table> {
  using type = TableObject;
  static constexpr const char* missing = "table = NULL: a handle must be given";
};

template <class Handle> using Object = typename ObjectOf<std::remove_const_t<Handle>>::type;

/// Why an object cannot be used.
template <class AnObject> const char* reason_of(const InUse<AnObject>& used) noexcept {
  return used.exists() ? "the handle is in use by another thread"
                       : "the handle has been destroyed, or is one of another kind";
}

/// Turns the exception in flight into a status and a text. Never throws.
wrc_status status_of_current_exception(std::string& error) noexcept;
/// Keeps a text if memory allows.
void keep_text(std::string& error, const char* text) noexcept;

/// Runs a body that belongs to no handle, so that a failure shows in the status alone.
template <class Body> wrc_status guard_process(Body&& body) noexcept {
  try {
    std::forward<Body>(body)();
    return WRC_OK;
  } catch (...) {
    std::string error;
    return status_of_current_exception(error);
  }
}

template <class Handle> std::uintptr_t number_of_handle(Handle* handle) noexcept {
  return reinterpret_cast<std::uintptr_t>(handle);
}

template <class Handle> auto entry_of(Handle* handle) {
  return HandleTable<Object<Handle>>::instance().find(number_of_handle(handle));
}

/// The object of a handle, for this call alone.
template <class Handle> InUse<Object<Handle>> use(Handle* handle) {
  return InUse<Object<Handle>>(entry_of(handle));
}

/// Runs a body that returns a status; what it throws becomes a status and the object's error text.
template <class AnObject, class Body> wrc_status run(AnObject& object, Body&& body) noexcept {
  try {
    object.error.clear();
    return std::forward<Body>(body)();
  } catch (...) {
    return status_of_current_exception(object.error);
  }
}

/// Runs a body that returns a status with the object of a handle; nothing it throws gets past here,
/// and the caller's floating-point environment is untouched.
template <class Handle, class Body> wrc_status guard(Handle* handle, Body&& body) noexcept {
  try {
    const auto used = use(handle);
    if (!used.held()) {
      return used.exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
    const DefaultFloatingPoint floating_point;
    return run(used.object(), [&] { return std::forward<Body>(body)(used.object()); });
  } catch (...) {
    return WRC_OUT_OF_MEMORY; // of a lock
  }
}

/// As guard, for functions that return something else; `otherwise` if the handle cannot be used.
/// The error text of the last call stays.
template <class Value, class Handle, class Body>
Value look_at(Handle* handle, Value otherwise, Body&& body) noexcept {
  try {
    const auto used = use(handle);
    const DefaultFloatingPoint floating_point;
    return used.held() ? static_cast<Value>(std::forward<Body>(body)(used.object())) : otherwise;
  } catch (...) {
    return otherwise;
  }
}

template <class Handle> const char* error_of(Handle* handle) noexcept {
  if (handle == nullptr) {
    return ObjectOf<std::remove_const_t<Handle>>::missing;
  }
  try {
    const auto used = use(handle);
    return used.held() ? used.object().error.c_str() : reason_of(used);
  } catch (...) {
    return "";
  }
}

/// Creates a handle.
template <class Handle> wrc_status create(Handle** handle) noexcept {
  if (handle == nullptr) {
    return WRC_INVALID_ARGUMENT;
  }
  *handle = nullptr;
  const DefaultFloatingPoint floating_point;
  try {
    if constexpr (std::is_same_v<Handle, wrc_solver>) { // its solutions plan long lines only
      prepare_transforms();
    }
    // A handle is a number by design. NOLINTNEXTLINE(performance-no-int-to-ptr)
    *handle = reinterpret_cast<Handle*>(HandleTable<Object<Handle>>::instance().add());
    return WRC_OK;
  } catch (...) {
    std::string nowhere;
    return status_of_current_exception(nowhere);
  }
}

template <class Handle> void destroy(Handle* handle) noexcept {
  try {
    HandleTable<Object<Handle>>::instance().remove(number_of_handle(handle));
  } catch (...) {
    // The lock failed: the object stays.
  }
}

/// One of some lines of text; NULL past their end.
inline const char* line_of(const std::vector<std::string>& lines, std::int64_t index) {
  return index >= 0 && index < static_cast<std::int64_t>(lines.size())
             ? lines[static_cast<std::size_t>(index)].c_str()
             : nullptr;
}

/// Throws Error(invalid_argument) if a pointer that must be given is NULL.
void require_pointer(const void* pointer, const char* name);

/// Runs a body with the scene that a call on a solver is for; its status and text are the scene's.
template <class Body> wrc_status with_scene(SolverObject& solver, wrc_scene* scene, Body&& body) {
  require_pointer(scene, "scene");
  const auto used = use(scene);
  if (!used.held()) {
    solver.error = std::string("scene: ") + reason_of(used);
    return used.exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
  }
  return run(used.object(), [&] { return std::forward<Body>(body)(used.object()); });
}

inline wrc_status no_result(SceneObject& scene) {
  scene.error = "the scene has not been solved yet";
  return WRC_NO_RESULT;
}

/// Runs a body that needs results.
template <class Body> wrc_status with_result(wrc_scene* scene, Body&& body) {
  return guard(scene, [&](SceneObject& object) {
    return object.result ? std::forward<Body>(body)(object) : no_result(object);
  });
}

/// Throws Error(invalid_argument) unless `count` is that of a list of ids, with a pointer to it.
void require_list(const void* pointer, const char* name, std::int64_t count);

/// Throws Error(invalid_argument) if the length of an array is negative.
void require_capacity(std::int64_t capacity);

/// Copies values into the caller's array as wrc_scene_field documents.
wrc_status copy_values(const double* from, std::size_t length, double* values,
                       std::int64_t capacity, std::int64_t* count, std::string& error);

} // namespace wrc
