/// What stands behind the opaque handles, and the guard every entry point runs in.
#pragma once

#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "mechanics/normal_contact.hpp"
#include "mechanics/normal_solver.hpp"
#include "mechanics/pressure_field.hpp"
#include "profile/profile.hpp"
#include "scene/scene.hpp"
#include "scene/solve_scene.hpp"
#include "wrcontact.h"

struct wrc_scene {
  wrc::Scene scene;
  std::optional<wrc::SceneResult> result;
  // Made of the result when they are first asked for.
  mutable std::vector<std::string> number_names;
  mutable std::vector<std::pair<std::string, std::string>> texts;
  std::optional<std::pair<std::string, std::vector<double>>> field; ///< the last one asked for
  std::string error;

  /// Takes a new result in; returns the status that tells of it.
  wrc_status take_result(wrc::SceneResult&& new_result);
};

struct wrc_solver {
  wrc::SceneSolver solver;
  std::string error;
};

struct wrc_profile {
  std::optional<wrc::Profile> profile;
  std::vector<std::string> corrections;
  std::string error;
};

/// What was asked at the last solve of a wrc_normal, and what came out.
struct wrc_normal_result {
  std::shared_ptr<const std::vector<double>> distance; ///< what the problem's span refers to
  wrc::NormalProblem problem;
  wrc::NormalSolution solution; ///< displacement: empty until it is asked for
  wrc::PressureRegion summary;
  std::optional<wrc::Residuals> residuals;
};

struct wrc_normal {
  std::shared_ptr<const std::vector<double>> distance;
  wrc::NormalProblem problem; ///< its span is set at each solve
  bool paper_method = false;
  wrc::Precision precision = wrc::Precision::mixed;
  wrc::PlannerRigor rigor = wrc::PlannerRigor::estimate;
  std::optional<wrc::NormalSolver> solver; ///< none until first used with these settings
  std::optional<wrc_normal_result> result;
  std::string error;
};

namespace wrc {

/// Turns the exception in flight into a status and a text. Never throws.
wrc_status status_of_current_exception(std::string& error) noexcept;
/// Keeps a text if memory allows.
void keep_text(std::string& error, const char* text) noexcept;

/// Runs a body that returns a status; nothing it throws gets past here.
template <class Handle, class Body> wrc_status guard(Handle* handle, Body&& body) noexcept {
  if (handle == nullptr) {
    return WRC_INVALID_ARGUMENT;
  }
  try {
    handle->error.clear();
    return std::forward<Body>(body)();
  } catch (...) {
    return status_of_current_exception(handle->error);
  }
}

/// Creates a handle.
template <class Handle> wrc_status create(Handle** handle) noexcept {
  if (handle == nullptr) {
    return WRC_INVALID_ARGUMENT;
  }
  *handle = nullptr;
  try {
    *handle = new Handle;
    return WRC_OK;
  } catch (...) {
    return WRC_OUT_OF_MEMORY;
  }
}

/// Throws Error(invalid_argument) if a pointer that must be given is NULL.
void require_pointer(const void* pointer, const char* name);

/// Copies values into the caller's array as wrc_scene_field documents.
wrc_status copy_values(const double* from, std::size_t length, double* values,
                       std::int64_t capacity, std::int64_t* count, std::string& error);

} // namespace wrc
