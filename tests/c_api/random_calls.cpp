// Random sequences of calls (see call_sequences.hpp). Usage: random_calls COUNT SEED [CALLS
// [THREADS]], in a folder that may be filled with files; CALLS of a sequence, 100 if not given;
// COUNT sequences on each of so many threads, which share their handles. Nothing is printed if all
// goes well.
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "call_sequences.hpp"

/// There if no_side_effects.c has been preloaded.
extern "C" __attribute__((weak)) void watch_calls(int begin);

namespace {

/// False if a status is none that there is.
bool run(long count, std::uint64_t seed, long calls) {
  constexpr long sequences_of_a_life = 50; // of handles
  SeededChoices choices(seed);
  for (long i = 0; i < count; ++i) {
    if (const auto status = unheard_of_status(choices, calls)) {
      std::fprintf(stderr, "seed %llu, sequence %ld: status %d\n",
                   static_cast<unsigned long long>(seed), i, *status);
      return false;
    }
    if (i % sequences_of_a_life == sequences_of_a_life - 1) {
      destroy_handles();
    }
  }
  return true;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 5) {
    std::fputs("usage: random_calls COUNT SEED [CALLS [THREADS]]\n", stderr);
    return 2;
  }
  const long count = std::strtol(argv[1], nullptr, 10);
  const std::uint64_t seed = std::strtoull(argv[2], nullptr, 10);
  const long calls = argc > 3 ? std::strtol(argv[3], nullptr, 10) : 100;
  const long threads = argc > 4 ? std::strtol(argv[4], nullptr, 10) : 1;
  if (watch_calls != nullptr) {
    watch_calls(1);
  }
  std::atomic<bool> good{true};
  std::vector<std::thread> others;
  for (long i = 1; i < threads; ++i) {
    others.emplace_back([&good, count, calls, own = seed + static_cast<std::uint64_t>(i)] {
      if (!run(count, own, calls)) {
        good = false;
      }
    });
  }
  if (!run(count, seed, calls)) {
    good = false;
  }
  for (std::thread& thread : others) {
    thread.join();
  }
  if (watch_calls != nullptr) {
    watch_calls(0);
  }
  return good ? 0 : 1;
}
