/// How many cases a test tries: a few in every run, all of them where WRCONTACT_TEST_EXTENT is
/// "long", as in the ctests with the label "long" (tests/README.md). Both ask the same question.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace wrc::test {

inline bool is_long_run() {
  const char* extent = std::getenv("WRCONTACT_TEST_EXTENT");
  return extent != nullptr && std::string_view(extent) == "long";
}

template <class T> T by_extent(T all, T few) {
  return is_long_run() ? all : few;
}

/// All of them, or so many, evenly spread from the first one on.
template <class T> std::vector<T> some_of(const std::vector<T>& all, std::size_t few) {
  if (is_long_run() || few >= all.size()) {
    return all;
  }
  std::vector<T> chosen;
  for (std::size_t i = 0; i < few; ++i) {
    chosen.push_back(all[i * all.size() / few]);
  }
  return chosen;
}
template <class T> std::vector<T> some_of(std::initializer_list<T> all, std::size_t few) {
  return some_of(std::vector<T>(all), few);
}

} // namespace wrc::test
