#include <algorithm>
#include <array>
#include <cstring>

#include "batch.hpp"
#include "scene/patch_summary.hpp"
#include "scene/static_equilibrium.hpp"
#include "scene/vehicle_step.hpp"
#include "table/table_equilibrium.hpp"
#include "table/table_step.hpp"

namespace {

/// Sizes that the arguments of a step have had or may have.
bool is_struct_size(uint64_t size) {
  constexpr uint64_t least = 10 * sizeof(double); // of the version that introduced them
  constexpr uint64_t most = 4096;                 // more is no size of a struct
  return size >= least && size <= most && size % 8 == 0;
}

/// The arguments that caller and library know; of none, none.
wrc_step_arguments known_part(const wrc_step_arguments* given, bool of_table = false) {
  wrc_step_arguments known{};
  if (given != nullptr) {
    if (!is_struct_size(given->struct_size)) {
      wrc::throw_invalid_argument("struct_size", static_cast<double>(given->struct_size),
                                  "sizeof(wrc_step_arguments)");
    }
    std::memcpy(&known, given, std::min<std::size_t>(given->struct_size, sizeof known));
  }
  if (!of_table && (known.likely_errors != nullptr || known.outputs != nullptr ||
                    known.output_errors != nullptr)) {
    wrc::throw_invalid_argument("likely_errors, outputs or output_errors", "given",
                                "only steps by a table have them");
  }
  return known;
}

wrc_step_arguments classic_arguments(const double* rails, double* by_position, double* by_velocity,
                                     int32_t* states) {
  wrc_step_arguments arguments{};
  arguments.struct_size = sizeof arguments;
  arguments.rails = rails;
  arguments.by_position = by_position;
  arguments.by_velocity = by_velocity;
  arguments.states = states;
  return arguments;
}

/// The arrays of a step, for one wheelset after the other.
struct StepArrays {
  const double* positions;
  const double* velocities;
  double* forces;
  wrc_step_arguments optional;

  [[nodiscard]] bool are_complete() const {
    return positions != nullptr && velocities != nullptr && forces != nullptr;
  }
  [[nodiscard]] wrc::VehicleState state(std::size_t wheelset) const {
    const auto numbers = [wheelset]<std::size_t count>(const double* values,
                                                       std::array<double, count> to) {
      std::copy_n(values + count * wheelset, count, to.begin());
      return to;
    };
    const wrc::SixNumbers six{};
    wrc::VehicleState state;
    state.position = numbers(positions, six);
    if (velocities != nullptr) {
      state.velocity = numbers(velocities, six);
    }
    if (optional.rails != nullptr) {
      state.rails = numbers(optional.rails, six);
    }
    if (optional.rail_velocities != nullptr) {
      state.rail_velocities = numbers(optional.rail_velocities, six);
    }
    if (optional.curvature != nullptr) {
      state.curvature = optional.curvature[wheelset];
    }
    if (optional.friction != nullptr) {
      state.friction = numbers(optional.friction, std::array<double, 2>{});
    }
    state.time_step = optional.time_step;
    state.derivatives = optional.by_position != nullptr || optional.by_velocity != nullptr ||
                        optional.by_rail != nullptr || optional.by_rail_velocity != nullptr;
    return state;
  }
  void put(std::size_t wheelset, const std::array<wrc::WheelForces, 2>& wheels) const {
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      const std::size_t wheel = 2 * wheelset + i;
      const wrc::WheelForces& found = wheels[i];
      std::copy(found.force.begin(), found.force.end(), forces + 6 * wheel);
      put_columns(optional.by_position, wheel, found.by_position);
      put_columns(optional.by_velocity, wheel, found.by_velocity);
      put_columns(optional.by_rail, wheel, found.by_rail);
      put_columns(optional.by_rail_velocity, wheel, found.by_rail_velocity);
      if (optional.states != nullptr) {
        optional.states[wheel] = found.state;
      }
    }
  }

private:
  template <std::size_t count>
  static void put_columns(double* to, std::size_t wheel,
                          const std::array<wrc::SixNumbers, count>& columns) {
    for (std::size_t i = 0; to != nullptr && i < count; ++i) {
      std::copy(columns[i].begin(), columns[i].end(), to + 6 * (count * wheel + i));
    }
  }
};

/// Fills in all arrays that were given.
wrc_status put_step(wrc::TableObject& table, const StepArrays& arrays, const wrc::TableStep& step,
                    double* error) {
  arrays.put(0, step.wheels);
  for (std::size_t i = 0; i < step.errors.size(); ++i) {
    if (error != nullptr) {
      error[i] = step.errors[i][0];
    }
    if (double* likely = arrays.optional.likely_errors; likely != nullptr) {
      std::copy(step.errors[i].begin() + 1, step.errors[i].end(), likely + 2 * i);
    }
    for (const auto& [to, from] :
         {std::pair(arrays.optional.outputs, &step.outputs[i]),
          std::pair(arrays.optional.output_errors, &step.output_errors[i])}) {
      if (to != nullptr) {
        std::copy(from->begin(), from->end(), to + from->size() * i);
      }
    }
  }
  if (!step.converged) {
    table.error = "not converged: the exact solution";
    return WRC_NOT_CONVERGED;
  }
  return WRC_OK;
}

/// Whether flags of places or outputs were asked for.
bool wants_places(const wrc_step_arguments& wanted) {
  return wanted.states != nullptr || wanted.outputs != nullptr || wanted.output_errors != nullptr;
}

wrc::StaticLoads static_loads(int32_t kind, const double* loads) {
  wrc::require_pointer(loads, "loads");
  if (kind != WRC_LOADS_OF_WHEELS && kind != WRC_LOAD_OF_AXLE) {
    wrc::throw_invalid_argument("kind", kind, "WRC_LOADS_OF_WHEELS or WRC_LOAD_OF_AXLE");
  }
  return {kind == WRC_LOAD_OF_AXLE ? wrc::LoadsOf::axle : wrc::LoadsOf::wheels,
          {loads[0], loads[1]}};
}

/// One step; on failure scene, history and arrays stay as they were.
wrc_status step(wrc::SolverObject& solver, wrc::SceneObject& scene, const StepArrays& arrays,
                wrc::HistoryObject* history, std::size_t wheelset) {
  wrc::VehicleState state = arrays.state(wheelset);
  if (history != nullptr) {
    state.history = history->accepted;
  }
  wrc::Scene posed = wrc::scene_at(scene.scene, state);
  wrc::SceneResult result = solver.solver.solve(posed);
  auto forces = wrc::wheel_forces(result, posed.convention, state.derivatives);
  if (state.derivatives) {
    wrc::add_varying_columns(posed, solver.solver, forces);
  }
  const auto after = history != nullptr ? wrc::history_after(result) : nullptr;
  const wrc_status status = scene.take_result(std::move(result));
  arrays.put(wheelset, forces);
  if (history != nullptr) {
    history->after = after;
    posed.history = nullptr; // of this step alone
    posed.time_step = 0.0;
  }
  scene.scene = std::move(posed);
  return status;
}

/// The histories of a batch; none if there are none.
wrc_status take_histories(const wrc_step_arguments& arguments, int64_t count,
                          wrc::HandlesInUse<wrc_history>& taken, std::string& error) {
  return arguments.histories != nullptr ? wrc::take_all(count > 1 ? "histories" : "history",
                                                        arguments.histories, count, taken, error)
                                        : WRC_OK;
}

} // namespace

extern "C" {

wrc_status wrc_history_create(wrc_history** history) {
  return wrc::create(history);
}

void wrc_history_destroy(wrc_history* history) {
  wrc::destroy(history);
}

const char* wrc_history_error(const wrc_history* history) {
  return wrc::error_of(history);
}

wrc_status wrc_history_accept(wrc_history* history) {
  return wrc::guard(history, [](wrc::HistoryObject& object) {
    if (object.after) {
      object.accepted = std::move(object.after);
      object.after = nullptr;
    }
    return WRC_OK;
  });
}

wrc_status wrc_history_clear(wrc_history* history) {
  return wrc::guard(history, [](wrc::HistoryObject& object) {
    object = wrc::HistoryObject();
    return WRC_OK;
  });
}

wrc_status wrc_history_copy(wrc_history* history, wrc_history* from) {
  return wrc::guard(history, [&](wrc::HistoryObject& object) -> wrc_status {
    if (history == from) {
      return WRC_OK;
    }
    const auto used = wrc::use(from);
    if (!used.held()) {
      object.error = std::string("from: ") + wrc::reason_of(used);
      return used.exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
    object.accepted = used.object().accepted;
    object.after = used.object().after;
    return WRC_OK;
  });
}

wrc_status wrc_solver_step_with(wrc_solver* solver, wrc_scene* scene, const double* position,
                                const double* velocity, const wrc_step_arguments* arguments,
                                double* force) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    return wrc::with_scene(object, scene, [&](wrc::SceneObject& posed) {
      wrc::require_pointer(position, "position");
      wrc::require_pointer(velocity, "velocity");
      wrc::require_pointer(force, "force");
      const StepArrays arrays{position, velocity, force, known_part(arguments)};
      wrc::HandlesInUse<wrc_history> histories;
      if (const wrc_status status = take_histories(arrays.optional, 1, histories, posed.error);
          status != WRC_OK) {
        return status;
      }
      return step(object, posed, arrays, histories.empty() ? nullptr : &histories.front()->object(),
                  0);
    });
  });
}

wrc_status wrc_solver_step(wrc_solver* solver, wrc_scene* scene, const double* position,
                           const double* velocity, const double* rails, double* force,
                           double* by_position, double* by_velocity, int32_t* states) {
  const wrc_step_arguments arguments = classic_arguments(rails, by_position, by_velocity, states);
  return wrc_solver_step_with(solver, scene, position, velocity, &arguments, force);
}

wrc_status wrc_step_batch(wrc_solver* const* solvers, wrc_scene* const* scenes, int64_t count,
                          int32_t threads, const double* positions, const double* velocities,
                          const double* rails, double* forces, double* by_positions,
                          double* by_velocities, int32_t* states, wrc_status* statuses) {
  const wrc_step_arguments arguments =
      classic_arguments(rails, by_positions, by_velocities, states);
  return wrc_step_batch_with(solvers, scenes, count, threads, positions, velocities, &arguments,
                             forces, statuses);
}

wrc_status wrc_step_batch_with(wrc_solver* const* solvers, wrc_scene* const* scenes, int64_t count,
                               int32_t threads, const double* positions, const double* velocities,
                               const wrc_step_arguments* arguments, double* forces,
                               wrc_status* statuses) {
  if (!wrc::is_permitted_batch(count, threads) ||
      (count > 0 && (solvers == nullptr || scenes == nullptr)) ||
      (arguments != nullptr && !is_struct_size(arguments->struct_size))) {
    return WRC_INVALID_ARGUMENT;
  }
  const StepArrays arrays{positions, velocities, forces, known_part(arguments)};
  if (count > 0 && !arrays.are_complete()) {
    return WRC_INVALID_ARGUMENT;
  }
  try {
    wrc::HandlesInUse<wrc_solver> with;
    wrc::HandlesInUse<wrc_scene> taken;
    wrc::HandlesInUse<wrc_history> histories;
    std::string error;
    wrc_status status = wrc::take_all("solvers", solvers, count, with, error);
    if (status == WRC_OK) {
      status = wrc::take_all("scenes", scenes, count, taken, error);
    }
    if (status == WRC_OK) {
      status = take_histories(arrays.optional, count, histories, error);
    }
    if (status != WRC_OK) {
      taken.clear();
      return wrc::refuse_batch(scenes, count, statuses, status, error);
    }
    return wrc::run_all(taken.size(), threads, statuses, [&] {
      return [&](std::size_t i) {
        wrc::SceneObject& scene = taken[i]->object();
        wrc::HistoryObject* history = histories.empty() ? nullptr : &histories[i]->object();
        return wrc::run(scene, [&] { return step(with[i]->object(), scene, arrays, history, i); });
      };
    });
  } catch (...) {
    return WRC_OUT_OF_MEMORY;
  }
}

wrc_status wrc_solver_equilibrium(wrc_solver* solver, wrc_scene* scene, int32_t kind,
                                  const double* loads, const double* velocity,
                                  const wrc_step_arguments* arguments, double* position,
                                  double* force) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    return wrc::with_scene(object, scene, [&](wrc::SceneObject& posed) {
      const wrc::StaticLoads carried = static_loads(kind, loads);
      wrc::require_pointer(position, "position");
      wrc::require_pointer(force, "force");
      const StepArrays arrays{position, velocity, force, known_part(arguments)};
      if (arrays.optional.histories != nullptr) {
        wrc::throw_invalid_argument("histories", "given", "an equilibrium has none");
      }
      const wrc::VehicleState state = arrays.state(0);
      wrc::StaticEquilibrium found =
          wrc::find_static_equilibrium(posed.scene, state, carried, object.solver);
      auto forces = wrc::wheel_forces(found.result, posed.scene.convention, state.derivatives);
      if (state.derivatives) {
        wrc::add_varying_columns(found.scene, object.solver, forces);
      }
      wrc_status status = posed.take_result(std::move(found.result));
      if (status == WRC_OK && !found.converged) {
        posed.error = "the loads are met within " + wrc::short_text_of(found.unbalanced) +
                      " of themselves only";
        status = WRC_NOT_CONVERGED;
      }
      arrays.put(0, forces);
      position[2] = found.vertical;
      position[3] = found.roll;
      posed.scene = std::move(found.scene);
      return status;
    });
  });
}

wrc_status wrc_table_step(wrc_table* table, wrc_solver* solver, wrc_scene* scene,
                          const double* position, const double* velocity,
                          const wrc_step_arguments* arguments, double* force, double* error) {
  return wrc::guard(table, [&](wrc::TableObject& object) -> wrc_status {
    wrc::require_pointer(position, "position");
    wrc::require_pointer(velocity, "velocity");
    wrc::require_pointer(force, "force");
    if (!object.table) {
      object.error = "there is no table yet: build or load one";
      return WRC_NO_RESULT;
    }
    const StepArrays arrays{position, velocity, force, known_part(arguments, true)};
    if (arrays.optional.histories != nullptr) {
      wrc::throw_invalid_argument("histories", "given", "a table has no steps of time");
    }
    const wrc_step_arguments& wanted = arrays.optional;
    const bool places =
        wanted.states != nullptr || wanted.outputs != nullptr || wanted.output_errors != nullptr;
    const auto put = [&](const wrc::TableStep& step) {
      return put_step(object, arrays, step, error);
    };
    if (solver == nullptr && scene == nullptr) {
      return put(wrc::step_in_table(*object.table, arrays.state(0), nullptr, places));
    }
    const auto with = wrc::use(solver);
    const auto posed = wrc::use(scene);
    if (!with.held() || !posed.held()) {
      const bool is_solver = !with.held();
      const bool busy = is_solver ? with.exists() : posed.exists();
      object.error = is_solver ? std::string("solver: ") + wrc::reason_of(with)
                               : std::string("scene: ") + wrc::reason_of(posed);
      return busy ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
    const wrc::ExactAnswer exact{posed.object().scene, with.object().solver};
    return put(wrc::step_in_table(*object.table, arrays.state(0), &exact, places));
  });
}

wrc_status wrc_table_equilibrium(wrc_table* table, int32_t kind, const double* loads,
                                 const double* velocity, const wrc_step_arguments* arguments,
                                 double* position, double* force, double* error) {
  return wrc::guard(table, [&](wrc::TableObject& object) -> wrc_status {
    const wrc::StaticLoads carried = static_loads(kind, loads);
    wrc::require_pointer(position, "position");
    wrc::require_pointer(force, "force");
    if (!object.table) {
      object.error = "there is no table yet: build or load one";
      return WRC_NO_RESULT;
    }
    const StepArrays arrays{position, velocity, force, known_part(arguments, true)};
    if (arrays.optional.histories != nullptr) {
      wrc::throw_invalid_argument("histories", "given", "an equilibrium has none");
    }
    wrc::VehicleState state = arrays.state(0);
    const wrc::TableEquilibrium found = wrc::find_table_equilibrium(*object.table, state, carried);
    if (!found.converged) {
      object.error = "the loads are met nowhere in the table";
      return WRC_NOT_CONVERGED;
    }
    state.position[2] = found.vertical;
    state.position[3] = found.roll;
    const wrc::TableStep step =
        wrc::step_in_table(*object.table, state, nullptr, wants_places(arrays.optional));
    position[2] = found.vertical;
    position[3] = found.roll;
    return put_step(object, arrays, step, error);
  });
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
                                    "must be a patch of the result");
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
