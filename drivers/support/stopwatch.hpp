/// Time that went by, and time that processors worked.
#pragma once

#include <chrono>
#include <ctime>
#include <utility>

namespace driver {

class Stopwatch {
public:
  /// Since it was made or lap() was called.
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  /// Milliseconds since it was made or last read by this.
  double lap() {
    const Clock::time_point now = Clock::now();
    return 1e3 * std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// The same of the processor's time in this process: what else goes on in the machine does not
/// count.
class ProcessorStopwatch {
public:
  double lap() {
    const double now = milliseconds();
    return now - std::exchange(start_, now);
  }

private:
  static double milliseconds() {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }
  double start_ = milliseconds();
};

} // namespace driver
