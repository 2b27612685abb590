/// Independent tasks on several threads.
///
/// Each task writes a place of its own, so that results are the same for any number of threads. The
/// first thing that a task throws ends all of it and is thrown again. Thread rule: starts the
/// threads and waits for them.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace wrc {

/// Called now and then by the calling thread with the finished fraction; throws to stop.
using Progress = std::function<void(double)>;

/// `make_worker()` makes what a thread calls with the index of each of its tasks.
template <class MakeWorker>
void run_tasks(std::size_t count, int threads, const Progress& progress,
               const MakeWorker& make_worker) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr reason;
  std::mutex of_reason;
  const auto work = [&](bool reports) {
    try {
      auto worker = make_worker();
      for (std::size_t i = next.fetch_add(1); i < count && !failed; i = next.fetch_add(1)) {
        worker(i);
        if (reports && progress) {
          progress(static_cast<double>(i + 1) / static_cast<double>(count));
        }
      }
    } catch (...) {
      const std::lock_guard guard(of_reason);
      if (!failed.exchange(true)) {
        reason = std::current_exception();
      }
    }
  };
  std::vector<std::thread> others;
  try {
    const std::size_t most = std::min(static_cast<std::size_t>(threads), count);
    for (std::size_t i = 1; i < most; ++i) {
      others.emplace_back(work, false);
    }
  } catch (...) {
    // Fewer threads than requested: the same results, later.
  }
  work(true);
  for (std::thread& other : others) {
    other.join();
  }
  if (reason) {
    std::rethrow_exception(reason);
  }
  if (progress) {
    progress(1.0);
  }
}

} // namespace wrc
