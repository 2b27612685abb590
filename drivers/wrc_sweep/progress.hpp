/// One line on stderr that says how far a study is and how long it will take.
#pragma once

#include <chrono>
#include <cstdint>

namespace driver {

class Progress {
public:
  /// `before`: done by an earlier run.
  Progress(bool shown, std::int64_t before, std::int64_t all);
  /// Draws the line at most ten times a second.
  void show(std::int64_t done, std::int64_t failed);
  /// Draws the last state and ends the line.
  void finish(std::int64_t done, std::int64_t failed);

private:
  using Clock = std::chrono::steady_clock;
  void draw(std::int64_t done, std::int64_t failed) const;

  bool shown_;
  std::int64_t before_;
  std::int64_t all_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
};

} // namespace driver
