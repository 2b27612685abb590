#include "half_space/fft.hpp"
#include "handles.hpp"

namespace {

constexpr int64_t most_values = int64_t{1} << 28;
constexpr int32_t most_repeats = 1000;

/// Runs a body that belongs to no handle, so that a failure shows in the status alone.
template <class Body> wrc_status guard_process(Body&& body) noexcept {
  try {
    std::forward<Body>(body)();
    return WRC_OK;
  } catch (...) {
    std::string error;
    return wrc::status_of_current_exception(error);
  }
}

} // namespace

extern "C" {

wrc_status wrc_set_planner_lock(void (*lock)(void* context), void (*unlock)(void* context),
                                void* context) {
  return guard_process([&] { wrc::set_planner_lock({lock, unlock, context}); });
}

wrc_status wrc_load_wisdom(const char* path) {
  return guard_process([&] {
    wrc::require_pointer(path, "path");
    wrc::load_wisdom(path);
  });
}

wrc_status wrc_save_wisdom(const char* path) {
  return guard_process([&] {
    wrc::require_pointer(path, "path");
    wrc::save_wisdom(path);
  });
}

wrc_status wrc_measure_transform(int64_t rows, int64_t columns, int32_t repeats,
                                 double* median_ms) {
  return guard_process([&] {
    wrc::require_pointer(median_ms, "median_ms");
    if (rows < 1 || columns < 1 || rows > most_values || columns > most_values / rows) {
      wrc::throw_invalid_argument("rows x columns",
                                  std::to_string(rows) + " x " + std::to_string(columns),
                                  "allowed is 1 to 2^28 values");
    }
    if (repeats < 1 || repeats > most_repeats) {
      wrc::throw_invalid_argument("repeats", repeats, "allowed is 1 to 1000");
    }
    *median_ms = wrc::measure_transform(static_cast<std::size_t>(rows),
                                        static_cast<std::size_t>(columns), repeats);
  });
}
}
