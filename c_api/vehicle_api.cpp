#include <algorithm>
#include <array>
#include <cstring>

#include "batch.hpp"
#include "scene/patch_summary.hpp"
#include "scene/vehicle_step.hpp"

namespace {

/// The arrays of a step, for one wheelset after the other; some may be null.
struct StepArrays {
  const double* positions;
  const double* velocities;
  const double* rails;
  double* forces;
  double* by_positions;
  double* by_velocities;
  int32_t* states;

  [[nodiscard]] bool are_complete() const {
    return positions != nullptr && velocities != nullptr && forces != nullptr;
  }
  [[nodiscard]] wrc::VehicleState state(std::size_t wheelset) const {
    const auto six = [wheelset](const double* values) {
      wrc::SixNumbers numbers;
      std::copy_n(values + 6 * wheelset, 6, numbers.begin());
      return numbers;
    };
    wrc::VehicleState state{six(positions), six(velocities), {}, false};
    if (rails != nullptr) {
      state.rails = six(rails);
    }
    state.derivatives = by_positions != nullptr || by_velocities != nullptr;
    return state;
  }
  void put(std::size_t wheelset, const std::array<wrc::WheelForces, 2>& wheels) const {
    double* force = forces + 12 * wheelset;
    double* by_position = by_positions == nullptr ? nullptr : by_positions + 72 * wheelset;
    double* by_velocity = by_velocities == nullptr ? nullptr : by_velocities + 72 * wheelset;
    const auto append = [](double*& to, const wrc::SixNumbers& numbers) {
      if (to != nullptr) {
        to = std::copy(numbers.begin(), numbers.end(), to);
      }
    };
    for (std::size_t i = 0; states != nullptr && i < wheels.size(); ++i) {
      states[2 * wheelset + i] = wheels[i].state;
    }
    for (const wrc::WheelForces& wheel : wheels) {
      append(force, wheel.force);
      for (std::size_t i = 0; i < 6; ++i) {
        append(by_position, wheel.by_position[i]);
        append(by_velocity, wheel.by_velocity[i]);
      }
    }
  }
};

/// One step; on failure scene and arrays stay as they were.
wrc_status step(wrc::SolverObject& solver, wrc::SceneObject& scene, const StepArrays& arrays,
                std::size_t wheelset) {
  const wrc::VehicleState state = arrays.state(wheelset);
  wrc::Scene posed = wrc::scene_at(scene.scene, state);
  wrc::SceneResult result = solver.solver.solve(posed);
  const auto forces = wrc::wheel_forces(result, posed.convention, state.derivatives);
  const wrc_status status = scene.take_result(std::move(result));
  arrays.put(wheelset, forces);
  scene.scene = std::move(posed);
  return status;
}

} // namespace

extern "C" {

wrc_status wrc_solver_step(wrc_solver* solver, wrc_scene* scene, const double* position,
                           const double* velocity, const double* rails, double* force,
                           double* by_position, double* by_velocity, int32_t* states) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    return wrc::with_scene(object, scene, [&](wrc::SceneObject& posed) {
      wrc::require_pointer(position, "position");
      wrc::require_pointer(velocity, "velocity");
      wrc::require_pointer(force, "force");
      return step(object, posed,
                  {position, velocity, rails, force, by_position, by_velocity, states}, 0);
    });
  });
}

wrc_status wrc_step_batch(wrc_solver* const* solvers, wrc_scene* const* scenes, int64_t count,
                          int32_t threads, const double* positions, const double* velocities,
                          const double* rails, double* forces, double* by_positions,
                          double* by_velocities, int32_t* states, wrc_status* statuses) {
  const StepArrays arrays{positions,    velocities,    rails, forces,
                          by_positions, by_velocities, states};
  if (!wrc::is_permitted_batch(count, threads) ||
      (count > 0 && (solvers == nullptr || scenes == nullptr || !arrays.are_complete()))) {
    return WRC_INVALID_ARGUMENT;
  }
  try {
    wrc::HandlesInUse<wrc_solver> with;
    wrc::HandlesInUse<wrc_scene> taken;
    if (const wrc_status status = wrc::take_all(solvers, count, with); status != WRC_OK) {
      return status;
    }
    if (const wrc_status status = wrc::take_all(scenes, count, taken); status != WRC_OK) {
      return status;
    }
    return wrc::run_all(taken.size(), threads, statuses, [&] {
      return [&](std::size_t i) {
        wrc::SceneObject& scene = taken[i]->object();
        return wrc::run(scene, [&] { return step(with[i]->object(), scene, arrays, i); });
      };
    });
  } catch (...) {
    return WRC_OUT_OF_MEMORY;
  }
}

wrc_status wrc_solver_creep(wrc_solver* solver, wrc_scene* scene, int64_t patch,
                            const double* creepages, double* forces, double* by_creepage) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    return wrc::with_scene(object, scene, [&](wrc::SceneObject& solved) {
      wrc::require_pointer(creepages, "creepages");
      wrc::require_pointer(forces, "forces");
      if (!solved.result) {
        return wrc::no_result(solved);
      }
      if (patch < 0) {
        wrc::throw_invalid_argument("patch (counted from 0)", static_cast<double>(patch),
                                    "allowed are the patches of the result");
      }
      const wrc::PatchCreep creep = wrc::creep_of(
          solved.scene, *solved.result, static_cast<std::size_t>(patch),
          {creepages[0], creepages[1], creepages[2]}, by_creepage != nullptr, object.solver);
      std::copy(creep.forces.begin(), creep.forces.end(), forces);
      if (by_creepage != nullptr) {
        std::copy(creep.by_creepage.begin(), creep.by_creepage.end(), by_creepage);
      }
      return WRC_OK;
    });
  });
}

wrc_status wrc_scene_patches(wrc_scene* scene, wrc_patch* patches, int64_t struct_size,
                             int64_t capacity, int64_t* count) {
  static_assert(sizeof(wrc_patch) == sizeof(wrc::PatchSummary));
  return wrc::with_result(scene, [&](wrc::SceneObject& object) -> wrc_status {
    wrc::require_pointer(count, "count");
    // Members were added at the end, and more may be: the caller gets those that both know.
    constexpr int64_t first = 22 * sizeof(double); // of the version that introduced it
    constexpr int64_t most = 4096;                 // of any version; more is no size of a struct
    if (struct_size < first || struct_size > most || struct_size % 8 != 0) {
      wrc::throw_invalid_argument("struct_size", static_cast<double>(struct_size),
                                  "sizeof(wrc_patch)");
    }
    if (capacity < 0) {
      wrc::throw_invalid_argument("capacity", static_cast<double>(capacity), "0 or more");
    }
    const auto found = wrc::patch_summaries(*object.result, object.scene.convention);
    *count = static_cast<int64_t>(found.size());
    if (capacity == 0) {
      return WRC_OK;
    }
    wrc::require_pointer(patches, "patches");
    if (capacity < *count) {
      object.error = "capacity = " + std::to_string(capacity) + ": there are " +
                     std::to_string(*count) + " patches";
      return WRC_TOO_SMALL;
    }
    auto* to = reinterpret_cast<unsigned char*>(patches);
    for (const wrc::PatchSummary& patch : found) {
      std::memset(to, 0, static_cast<std::size_t>(struct_size));
      std::memcpy(to, &patch, std::min(static_cast<std::size_t>(struct_size), sizeof patch));
      to += struct_size;
    }
    return WRC_OK;
  });
}

} // extern "C"
