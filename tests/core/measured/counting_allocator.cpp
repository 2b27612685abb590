// A file of its own: inlined into the tests, gcc takes new and free for a mismatched pair.
#include "counting_allocator.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace {

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> peak{0};

} // namespace

std::size_t memory_in_use() {
  return in_use;
}

std::size_t peak_memory() {
  return peak;
}

void reset_peak_memory() {
  peak = in_use.load();
}

void* operator new(std::size_t size) {
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  in_use += malloc_usable_size(memory);
  peak = std::max(peak.load(), in_use.load());
  return memory;
}

void operator delete(void* memory) noexcept {
  in_use -= malloc_usable_size(memory);
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}
