/// Work on several threads, and lines on stderr that say how far it is.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "support/stopwatch.hpp"

namespace driver {

/// Calls work(i) for all i below `count` on `threads` threads, this one included: each takes the
/// next i. Throws what the work of the smallest i has thrown, at the end.
template <class Work> void for_each_index(std::size_t count, int threads, Work work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> failures(count);
  const auto work_on = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) {
      others.emplace_back(work_on);
    }
    work_on();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) {
      std::rethrow_exception(failure);
    }
  }
}

/// Counts finished work, and reports it at most every other second, and at the end.
class ProgressLines {
public:
  explicit ProgressLines(std::size_t count) : count_(count) {}

  /// By any thread: one more is done. tell(done, seconds since the start) prints a line.
  template <class Tell> void one_done(Tell tell) {
    const std::scoped_lock lock(mutex_);
    ++done_;
    const double seconds = watch_.seconds();
    if (done_ < count_ && seconds - reported_ < 2.0) {
      return;
    }
    reported_ = seconds;
    tell(done_, seconds);
  }

private:
  std::mutex mutex_;
  std::size_t count_;
  std::size_t done_ = 0;
  Stopwatch watch_;
  double reported_ = 0.0;
};

} // namespace driver
