#include "half_space/fft.hpp"
#include "handles.hpp"

extern "C" {

wrc_status wrc_set_planner_lock(void (*lock)(void* context), void (*unlock)(void* context),
                                void* context) {
  return wrc::guard_process([&] { wrc::set_planner_lock({lock, unlock, context}); });
}

wrc_status wrc_load_wisdom(const char* path) {
  return wrc::guard_process([&] {
    wrc::require_pointer(path, "path");
    wrc::load_wisdom(path);
  });
}

wrc_status wrc_save_wisdom(const char* path) {
  return wrc::guard_process([&] {
    wrc::require_pointer(path, "path");
    wrc::save_wisdom(path);
  });
}
}
