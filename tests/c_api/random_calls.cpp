// Random sequences of calls (see call_sequences.hpp). Usage: random_calls COUNT SEED [CALLS], in
// a folder that may be filled with files; CALLS of a sequence, 100 if not given. Nothing is printed
// if all goes well.
#include <cstdio>
#include <cstdlib>

#include "call_sequences.hpp"

/// There if no_side_effects.c has been preloaded.
extern "C" __attribute__((weak)) void watch_calls(int begin);

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::fputs("usage: random_calls COUNT SEED [CALLS]\n", stderr);
    return 2;
  }
  const long count = std::strtol(argv[1], nullptr, 10);
  SeededChoices choices(std::strtoull(argv[2], nullptr, 10));
  if (watch_calls != nullptr) {
    watch_calls(1);
  }
  const long calls = argc > 3 ? std::strtol(argv[3], nullptr, 10) : 100;
  constexpr long sequences_of_a_life = 50; // of handles
  for (long i = 0; i < count; ++i) {
    if (const auto status = unheard_of_status(choices, calls)) {
      std::fprintf(stderr, "sequence %ld: status %d\n", i, *status);
      return 1;
    }
    if (i % sequences_of_a_life == sequences_of_a_life - 1) {
      destroy_handles();
    }
  }
  if (watch_calls != nullptr) {
    watch_calls(0);
  }
  return 0;
}
