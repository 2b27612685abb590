#include "handles.hpp"

#include <algorithm>
#include <exception>

#include "base/fork.hpp"
#include "keys/key_warnings.hpp"
#include "keys/scene_keys.hpp"

namespace wrc {

namespace {

// A process may fork while its threads use the library: the child is given all locks free. What
// another thread had in use stays in use there (WRC_BUSY), since that thread is missing.

template <class... Objects> struct Tables {
  static void lock() { (HandleTable<Objects>::instance().lock(), ...); }
  static void unlock() { (HandleTable<Objects>::instance().unlock(), ...); }
  static void renew_locks() { (HandleTable<Objects>::instance().renew_lock(), ...); }
};
using AllTables = Tables<SceneObject, SolverObject, HistoryObject, ProfileObject, NormalObject,
                         RollingObject, TableObject>;

void before_fork() noexcept {
  try {
    scene_keys();               // no other thread is making its tables ...
    (void)KeyWarnings(Scene()); // ... or this one
  } catch (...) {
    // No memory for them yet.
  }
  lock_for_fork();
  AllTables::lock();
}

void after_fork_in_parent() noexcept {
  AllTables::unlock();
  unlock_after_fork();
}

void after_fork_in_child() noexcept {
  AllTables::renew_locks();
  unlock_after_fork();
}

[[maybe_unused]] const bool registered =
    call_around_forks(before_fork, after_fork_in_parent, after_fork_in_child);

} // namespace

void keep_text(std::string& error, const char* text) noexcept {
  try {
    error = text;
  } catch (...) {
    error.clear();
  }
}

wrc_status status_of_current_exception(std::string& error) noexcept {
  try {
    throw;
  } catch (const Error& failure) {
    keep_text(error, failure.what());
    return static_cast<wrc_status>(failure.code());
  } catch (const std::bad_alloc&) {
    keep_text(error, "out of memory");
    return WRC_OUT_OF_MEMORY;
  } catch (const std::exception& failure) {
    keep_text(error, failure.what());
    return WRC_INTERNAL;
  } catch (...) {
    keep_text(error, "unknown failure");
    return WRC_INTERNAL;
  }
}

void require_pointer(const void* pointer, const char* name) {
  if (pointer == nullptr) {
    throw_invalid_argument(name, "NULL", "a pointer must be given");
  }
}

void require_list(const void* pointer, const char* name, std::int64_t count) {
  constexpr std::int64_t most = std::int64_t{1} << 20;
  if (count < 0 || count > most) {
    throw_invalid_argument("count", std::to_string(count),
                           "must be between 0 and " + std::to_string(most));
  }
  if (count > 0) {
    require_pointer(pointer, name);
  }
}

wrc_status copy_values(const double* from, std::size_t length, double* values,
                       std::int64_t capacity, std::int64_t* count, std::string& error) {
  require_pointer(count, "count");
  *count = static_cast<std::int64_t>(length);
  if (capacity <= 0) {
    return WRC_OK;
  }
  require_pointer(values, "values");
  if (*count > capacity) {
    error = "capacity = " + std::to_string(capacity) + ": needed is " + std::to_string(*count);
    return WRC_TOO_SMALL;
  }
  // Without zeros of negative sign.
  std::transform(from, from + length, values, [](double value) { return value + 0.0; });
  return WRC_OK;
}

} // namespace wrc
