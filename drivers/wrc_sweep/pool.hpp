/// Threads that solve the scenes they are given.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "wrc_sweep/journal.hpp"
#include "wrc_sweep/study.hpp"

namespace driver {

class Pool {
public:
  Pool(const Study& study, int threads);
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  /// Waits for scenes being solved; drops those not yet begun.
  ~Pool();

  void give(const std::vector<std::int64_t>& scenes);
  /// Takes back scenes that nobody has begun.
  void drop();
  /// Scenes given and not yet begun.
  [[nodiscard]] std::size_t waiting() const;
  /// Scenes given whose rows have not been taken.
  [[nodiscard]] std::size_t open() const;
  /// Rows that are finished; waits for the first one, at most `patience`. Throws what a thread has
  /// thrown.
  std::vector<Row> take(std::chrono::milliseconds patience);

private:
  void work(const Study& study);

  mutable std::mutex mutex_;
  std::condition_variable given_;
  std::condition_variable finished_;
  std::deque<std::int64_t> queue_;
  std::vector<Row> rows_;
  std::size_t open_ = 0;
  bool ended_ = false;
  std::exception_ptr trouble_;
  std::vector<std::jthread> threads_;
};

} // namespace driver
