/// Many solutions in one call, on several threads.
///
/// Thread rule: these functions start the threads and wait for them.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "base/worker_threads.hpp"
#include "handles.hpp"

namespace wrc {

inline constexpr int32_t max_threads = 1024;                // not a tuning constant
inline constexpr int64_t max_batch_size = int64_t{1} << 24; // not a tuning constant

inline bool is_permitted_batch(int64_t count, int32_t threads) {
  return count >= 0 && count <= max_batch_size && threads >= 1 && threads <= max_threads;
}

template <class Handle> using HandlesInUse = std::vector<std::unique_ptr<InUse<Object<Handle>>>>;

/// All handles of a batch, or the status and the text that say why they are not available.
template <class Handle>
wrc_status take_all(const char* name, Handle* const* handles, int64_t count,
                    HandlesInUse<Handle>& taken, std::string& error) {
  for (int64_t i = 0; i < count; ++i) {
    const auto& handle =
        taken.emplace_back(std::make_unique<InUse<Object<Handle>>>(entry_of(handles[i])));
    if (!handle->held()) {
      const bool is_twice = std::find(handles, handles + i, handles[i]) != handles + i;
      error = name + (count > 1 ? '[' + std::to_string(i) + ']' : std::string()) + ": " +
              (is_twice ? "the same handle as another one: they must all be different"
               : handles[i] == nullptr ? "NULL: a handle must be given"
                                       : reason_of(*handle));
      return handle->exists() && !is_twice ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
  }
  return WRC_OK;
}

/// Of a batch whose handles are not available: the status of each scene, and the text of those that
/// nobody uses.
inline wrc_status refuse_batch(wrc_scene* const* scenes, int64_t count, wrc_status* statuses,
                               wrc_status status, const std::string& error) {
  for (int64_t i = 0; i < count; ++i) {
    if (const auto used = use(scenes[i]); used.held()) {
      keep_text(used.object().error, error.c_str());
    }
    if (statuses != nullptr) {
      statuses[i] = status;
    }
  }
  return status;
}

/// Calls a worker for each index on up to `threads` threads; each thread has its worker from
/// `make_worker`. Statuses (or null) hold what the worker returns for an index. Returns the first
/// status that is not WRC_OK.
template <class MakeWorker>
wrc_status run_all(std::size_t count, int32_t threads, wrc_status* statuses,
                   const MakeWorker& make_worker) {
  const DefaultFloatingPoint floating_point; // for the threads too
  std::vector<wrc_status> own(statuses == nullptr ? count : 0);
  wrc_status* results = statuses == nullptr ? own.data() : statuses;
  run_tasks(count, threads, {}, [&] {
    return [results, worker = make_worker()](std::size_t i) mutable { results[i] = worker(i); };
  });
  const auto* failed =
      std::find_if(results, results + count, [](wrc_status status) { return status != WRC_OK; });
  return failed == results + count ? WRC_OK : *failed;
}

} // namespace wrc
