#include "call_sequences.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

#include "call_arguments.hpp"

namespace {

/// Handles of a kind, alive, destroyed and never made. All threads use them.
template <class Handle> class Pool {
public:
  Pool(wrc_status (*create)(Handle**), void (*destroy)(Handle*))
      : create_(create), destroy_(destroy) {}

  void make() { make_at(below(handles_.size())); }
  void make_all() {
    for (std::size_t i = 0; i < handles_.size(); ++i) {
      make_at(i);
    }
  }
  void destroy_one() { destroy_(any()); }
  Handle* any() {
    switch (below(24)) {
    case 0:
      return nullptr;
    case 1:
      return reinterpret_cast<Handle*>(any_bits());
    case 2: // of any kind: numbers are small
      return reinterpret_cast<Handle*>(32 * below(4000));
    default:
      return any_of(handles_).load();
    }
  }
  void destroy_all() {
    const std::lock_guard<std::mutex> guard(lock_);
    for (Handle* handle : all_) {
      destroy_(handle);
    }
    all_.clear();
  }

private:
  void make_at(std::size_t place) {
    Handle* handle = nullptr;
    if (create_(&handle) == WRC_OK) {
      handles_[place] = handle; // what stood there is lost, as in bad programs
      const std::lock_guard<std::mutex> guard(lock_);
      all_.push_back(handle);
    }
  }

  wrc_status (*create_)(Handle**);
  void (*destroy_)(Handle*);
  std::array<std::atomic<Handle*>, 3> handles_{};
  std::mutex lock_;
  std::vector<Handle*> all_;
};

Pool<wrc_scene> scenes(wrc_scene_create, wrc_scene_destroy);
Pool<wrc_solver> solvers(wrc_solver_create, wrc_solver_destroy);
Pool<wrc_profile> profiles(wrc_profile_create, wrc_profile_destroy);
Pool<wrc_history> histories(wrc_history_create, wrc_history_destroy);
Pool<wrc_normal> normals(wrc_normal_create, wrc_normal_destroy);
Pool<wrc_rolling> rollings(wrc_rolling_create, wrc_rolling_destroy);

/// Solutions that take milliseconds: a small grid, at most.
void bound_cost(wrc_scene* scene) {
  const double grid[] = {static_cast<double>(3 + below(38)), static_cast<double>(3 + below(38))};
  wrc_scene_set_numbers(scene, "solve.grid", grid, 2);
  wrc_scene_set_number(scene, "solve.threads", static_cast<double>(1 + below(2)));
}

wrc_status call_scene() {
  wrc_scene* scene = scenes.any();
  double number = 0.0;
  const char* text = nullptr;
  std::int64_t count = 0;
  switch (below(20)) {
  case 0:
    scenes.make();
    return WRC_OK;
  case 1:
    scenes.destroy_one();
    return WRC_OK;
  case 2:
  case 3:
  case 4:
    return wrc_scene_set_number(scene, any_text(), any_number());
  case 5:
  case 6:
    return wrc_scene_set_text(scene, any_text(), any_text());
  case 7:
    return wrc_scene_set_numbers(scene, any_text(), any_array(), any_count());
  case 8:
    return wrc_scene_get_number(scene, any_text(), maybe(&number));
  case 9:
    return wrc_scene_get_text(scene, any_text(), maybe(&text));
  case 10:
    return wrc_scene_get_numbers(scene, any_text(), any_array(), any_capacity(), maybe(&count));
  case 11:
    return wrc_scene_set_profile(scene, any_text(), profiles.any());
  case 12:
    return wrc_scene_write(scene, any_text());
  case 13:
    bound_cost(scene);
    return wrc_scene_solve(scene);
  case 14:
    return wrc_scene_number(scene, any_text(), maybe(&number));
  case 15:
    return wrc_scene_text(scene, any_text(), maybe(&text));
  case 16:
    return wrc_scene_field(scene, any_text(), any_array(), any_capacity(), maybe(&count));
  case 17:
    wrc_scene_number_name(scene, any_count());
    wrc_scene_text_name(scene, any_count());
    wrc_scene_warning(scene, any_count());
    return wrc_scene_number_count(scene) >= 0 && wrc_scene_text_count(scene) >= 0 ? WRC_OK : -1;
  case 18:
    return wrc_scene_error(scene) != nullptr ? WRC_OK : -1;
  default: {
    const char* texts[4] = {};
    return wrc_scene_key(any_count(), maybe(&texts[0]), &texts[1], &texts[2], &texts[3]);
  }
  }
}

wrc_status call_by_id() {
  wrc_scene* scene = scenes.any();
  std::int32_t id = 0;
  const char* unit = nullptr;
  switch (below(5)) {
  case 0:
    return wrc_scene_key_id(scene, any_text(), maybe(&id));
  case 1:
    return wrc_scene_number_id(scene, any_text(), maybe(&id));
  case 2:
    return wrc_scene_set_numbers_by_id(scene, any_ids(), any_array(), any_count());
  case 3:
    return below(2) == 0 ? wrc_scene_number_unit(scene, any_text(), maybe(&unit))
                         : wrc_scene_key_unit(scene, any_text(), maybe(&unit));
  default:
    return wrc_scene_numbers_by_id(scene, any_ids(), any_array(), any_count());
  }
}

wrc_status call_solver() {
  wrc_solver* solver = solvers.any();
  wrc_scene* scene = scenes.any();
  switch (below(7)) {
  case 0:
    solvers.make();
    return WRC_OK;
  case 1:
    solvers.destroy_one();
    return WRC_OK;
  case 2:
    bound_cost(scene);
    return wrc_solver_solve(solver, scene);
  case 3:
    return wrc_solver_clear(solver);
  case 4:
    return wrc_solver_error(solver) != nullptr ? WRC_OK : -1;
  case 5: // not "planner", which no text is: plans by trial take seconds each
    return wrc_solver_set_text(solver, below(2) == 0 ? "precision" : any_text(),
                               below(2) == 0 ? "double" : any_text());
  default: {
    wrc_scene* batch[3] = {scene, scenes.any(), scenes.any()};
    for (wrc_scene* each : batch) {
      bound_cost(each);
    }
    wrc_status statuses[3] = {};
    static constexpr std::array<std::int64_t, 5> counts{0, 1, 3, -1,
                                                        std::numeric_limits<std::int64_t>::max()};
    return wrc_solve_batch(maybe(batch), any_of(counts), static_cast<std::int32_t>(below(4)),
                           maybe(statuses));
  }
  }
}

/// A position that is mostly plausible.
void fill_position(double* position) {
  const double usual[] = {0.0, 3.0, 459.88, 1e-4, 0.0, 1e-3};
  for (std::size_t i = 0; i < 6; ++i) {
    position[i] = below(40) == 0 ? any_number() : usual[i];
  }
}

wrc_status call_history() {
  wrc_history* history = histories.any();
  switch (below(6)) {
  case 0:
    histories.make();
    return WRC_OK;
  case 1:
    histories.destroy_one();
    return WRC_OK;
  case 2:
    return wrc_history_clear(history);
  case 3:
    return wrc_history_copy(history, histories.any());
  default:
    return wrc_history_accept(history);
  }
}

wrc_status call_vehicle() {
  thread_local double positions[64], velocities[12], forces[24], by_positions[144],
      by_velocities[144];
  thread_local std::int32_t states[4];
  thread_local wrc_patch patches[8];
  wrc_solver* solver = solvers.any();
  wrc_scene* scene = scenes.any();
  std::int64_t count = 0;
  for (const std::size_t wheelset : {0U, 1U}) {
    fill_position(positions + 6 * wheelset);
    fill_position(velocities + 6 * wheelset);
  }
  switch (below(7)) {
  case 5:
    return call_history();
  case 6: {
    wrc_history* history = histories.any();
    wrc_step_arguments arguments{};
    arguments.struct_size = sizeof arguments;
    arguments.histories = below(8) == 0 ? nullptr : &history;
    arguments.time_step = below(8) == 0 ? any_number() : 1e-3;
    arguments.by_velocity = maybe(by_velocities);
    bound_cost(scene);
    return wrc_solver_step_with(solver, scene, positions, velocities, &arguments, forces);
  }
  case 0:
    bound_cost(scene);
    return wrc_solver_step(solver, scene, maybe(positions), maybe(velocities),
                           below(2) == 0 ? nullptr : velocities, maybe(forces), maybe(by_positions),
                           maybe(by_velocities), maybe(states));
  case 1: {
    wrc_solver* with[2] = {solver, solvers.any()};
    wrc_scene* batch[2] = {scene, scenes.any()};
    wrc_status statuses[2] = {};
    bound_cost(batch[0]);
    bound_cost(batch[1]);
    return wrc_step_batch(maybe(with), maybe(batch), static_cast<std::int64_t>(below(4)) - 1,
                          static_cast<std::int32_t>(below(4)), positions, velocities, nullptr,
                          forces, maybe(by_positions), maybe(by_velocities), maybe(states),
                          maybe(statuses));
  }
  case 2:
    return wrc_scene_patches(scene, maybe(patches), sizeof *patches,
                             static_cast<std::int64_t>(below(10)) - 1, maybe(&count));
  case 3:
    return wrc_solver_creep(solver, scene, static_cast<std::int64_t>(below(4)) - 1,
                            maybe(velocities), maybe(forces), maybe(by_positions));
  default: {
    const std::int64_t counts[8] = {static_cast<std::int64_t>(below(3)), 1, 1, 1, 1, 1, 1, 1};
    bound_cost(scene);
    return wrc_scene_tabulate(scene, below(2) == 0 ? any_text() : "pose.lateral pose.yaw",
                              maybe(positions), maybe(counts),
                              below(2) == 0 ? any_text() : "left.pmax roll",
                              static_cast<std::int32_t>(below(4)), nullptr, maybe(forces));
  }
  }
}

wrc_status call_profile() {
  wrc_profile* profile = profiles.any();
  double number = 0.0;
  const char* text = nullptr;
  std::int64_t count = 0;
  std::int32_t kind = 0;
  wrc_read_options options{};
  options.struct_size = below(4) == 0 ? any_bits() : sizeof options;
  options.kind_given = static_cast<std::int32_t>(below(2));
  options.kind = static_cast<std::int32_t>(below(3));
  options.mirror_lateral = static_cast<std::int32_t>(below(4)) - 1;
  options.strict = static_cast<std::int32_t>(below(2));
  options.scale = below(2) == 0 ? 0.0 : any_number();
  options.smoothing_wavelength = below(2) == 0 ? 0.0 : any_number();
  if (options.struct_size > sizeof options) {
    options.struct_size = below(2) == 0 ? 8 : 0; // the caller's struct is no longer than this
  }
  switch (below(13)) {
  case 0:
    profiles.make();
    return WRC_OK;
  case 1:
    profiles.destroy_one();
    return WRC_OK;
  case 2:
  case 3:
    return wrc_profile_load_standard(profile, any_text());
  case 4:
    return wrc_profile_load_file(profile, any_text(), maybe(&options));
  case 5: {
    thread_local std::array<double, array_length> lateral{};
    for (std::size_t i = 0; i < array_length; ++i) {
      lateral[i] = static_cast<double>(i) - 30.0;
    }
    return wrc_profile_set_points(profile, any_text(), maybe(lateral.data()), any_array(),
                                  below(2) == 0 ? 60 : any_count(), maybe(&options));
  }
  case 6:
    return wrc_profile_write(profile, any_text(), any_number());
  case 7:
    return wrc_profile_kind(profile, maybe(&kind));
  case 8:
    return wrc_profile_text(profile, any_text(), maybe(&text));
  case 9:
    return wrc_profile_length(profile, maybe(&number));
  case 10:
    return wrc_profile_nodes(profile, any_array(), any_capacity(), maybe(&count));
  case 11:
    wrc_profile_correction(profile, any_count());
    wrc_profile_warning(profile, any_count());
    wrc_profile_points(profile, static_cast<std::int32_t>(below(4)) - 1, any_array(), any_array(),
                       any_capacity(), maybe(&count));
    wrc_profile_standard_name(static_cast<std::int32_t>(below(4)) - 1, any_count());
    wrc_profile_load_surface(profile, any_text(), nullptr, any_number(), maybe(&count));
    wrc_profile_surface_line(profile, any_count());
    wrc_profile_surface_at(profile, any_count(), any_number(), any_number(), maybe(&number),
                           nullptr, nullptr);
    return wrc_profile_error(profile) != nullptr ? WRC_OK : -1;
  default:
    return wrc_profile_at(profile, any_number(), maybe(&number), nullptr, nullptr, nullptr);
  }
}

wrc_status call_normal() {
  wrc_normal* normal = normals.any();
  double number = 0.0;
  const char* text = nullptr;
  std::int64_t count = 0;
  switch (below(12)) {
  case 0:
    normals.make();
    return WRC_OK;
  case 1:
    normals.destroy_one();
    return WRC_OK;
  case 2:
    return wrc_normal_set_grid(normal, any_count(), any_count(), any_number(), any_number());
  case 3:
    return wrc_normal_set_grid(normal, 16, 16, std::abs(any_number()), 0.1);
  case 4:
  case 5:
    return wrc_normal_set_distance(normal, any_array(), below(2) == 0 ? 256 : any_count());
  case 6:
    return wrc_normal_set_number(normal, any_text(), any_number());
  case 7:
    wrc_normal_set_number(normal, "maximum_iterations", 200.0);
    return wrc_normal_solve(normal);
  case 8:
    return wrc_normal_set_text(normal, any_text(), any_text());
  case 9:
    return wrc_normal_number(normal, any_text(), maybe(&number));
  case 10:
    return wrc_normal_text(normal, any_text(), maybe(&text));
  default:
    return wrc_normal_error(normal) != nullptr
               ? wrc_normal_field(normal, any_text(), any_array(), any_capacity(), maybe(&count))
               : -1;
  }
}

wrc_status call_rolling() {
  wrc_rolling* rolling = rollings.any();
  double number = 0.0;
  std::int64_t count = 0;
  switch (below(13)) {
  case 0:
    rollings.make();
    return WRC_OK;
  case 1:
    rollings.destroy_one();
    return WRC_OK;
  case 2:
    return wrc_rolling_set_grid(rolling, any_count(), any_count(), any_number(), any_number());
  case 3:
    return wrc_rolling_set_grid(rolling, 16, 16, std::abs(any_number()), 0.1);
  case 4:
    return wrc_rolling_set_pressure(rolling, any_array(), below(2) == 0 ? 256 : any_count());
  case 5:
    return wrc_rolling_set_previous(rolling, any_array(), any_array(),
                                    below(2) == 0 ? 256 : any_count());
  case 6:
    return wrc_rolling_set_number(rolling, any_text(), any_number());
  case 7:
    wrc_rolling_set_number(rolling, "maximum_iterations", 20.0);
    return wrc_rolling_solve(rolling);
  case 8:
    return wrc_rolling_set_text(rolling, any_text(), any_text());
  case 9:
    return wrc_rolling_number(rolling, any_text(), maybe(&number));
  case 10:
    return wrc_rolling_advance(rolling);
  case 11:
    return wrc_rolling_set_slip(rolling, any_array(), any_array(),
                                below(2) == 0 ? 256 : any_count());
  default:
    return wrc_rolling_error(rolling) != nullptr
               ? wrc_rolling_field(rolling, any_text(), any_array(), any_capacity(), maybe(&count))
               : -1;
  }
}

wrc_status call_process() {
  void (*const one_function)(void*) = below(2) == 0 ? nullptr : +[](void*) {};
  switch (below(4)) {
  case 0:
    return wrc_load_wisdom(any_text());
  case 1:
    return wrc_save_wisdom(maybe("wisdom"));
  case 2:
    return wrc_set_planner_lock(nullptr, one_function, nullptr);
  default:
    return wrc_version() != nullptr &&
                   wrc_status_name(static_cast<wrc_status>(any_bits())) != nullptr
               ? WRC_OK
               : -1;
  }
}

wrc_status any_call() {
  static constexpr auto often = std::to_array(
      {call_process, call_solver, call_solver, call_profile, call_profile, call_profile,
       call_normal,  call_normal, call_normal, call_normal,  call_rolling, call_rolling,
       call_rolling, call_scene,  call_scene,  call_scene,   call_scene,   call_scene,
       call_scene,   call_by_id,  call_vehicle});
  return any_of(often)();
}

} // namespace

void make_handles() {
  scenes.make_all();
  solvers.make_all();
  histories.make_all();
  profiles.make_all();
  normals.make_all();
  rollings.make_all();
}

void destroy_handles() {
  scenes.destroy_all();
  solvers.destroy_all();
  histories.destroy_all();
  profiles.destroy_all();
  normals.destroy_all();
  rollings.destroy_all();
  clear_arrays();
}

std::optional<wrc_status> unheard_of_status(Choices& from, long calls) {
  choose_from(from);
  for (long i = 0; i < calls && !from.ended(); ++i) {
    const wrc_status status = any_call();
    if (status < WRC_OK || status > WRC_BUSY || status == WRC_INTERNAL) {
      return status;
    }
  }
  return std::nullopt;
}
