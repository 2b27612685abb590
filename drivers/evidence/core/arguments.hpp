/// The arguments of a program that takes a few numbers in a fixed order.
///
/// `--help` prints the usage; what is no number, out of range or too much is one line on stderr and
/// exit code 2, and what goes wrong later one line and 1. Thread rule: plain values.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace wrc::evidence {

struct WrongArgument : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The number that a word is, or WrongArgument.
template <class Number, class Permits>
Number number_of(const std::string& word, const std::string& name, Permits&& permits,
                 const std::string& allowed) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !permits(value)) {
    throw WrongArgument(name + " = \"" + word + "\": must be " + allowed);
  }
  return value;
}

/// A whole number from `least` on; int, since that bounds what all programs count.
inline int whole_number_of(const std::string& word, const std::string& name, int least = 1) {
  return number_of<int>(
      word, name, [least](int value) { return value >= least; },
      "a whole number from " + std::to_string(least) + " to " +
          std::to_string(std::numeric_limits<int>::max()));
}

inline double positive_number_of(const std::string& word, const std::string& name) {
  return number_of<double>(
      word, name, [](double value) { return value > 0.0 && std::isfinite(value); },
      "a number above 0");
}

class Arguments {
public:
  explicit Arguments(std::vector<std::string> words) : words_(std::move(words)) {}

  [[nodiscard]] std::size_t count() const { return words_.size(); }
  /// Of a place from 0; `usual` where there is none, as below.
  [[nodiscard]] std::string text(std::size_t place, const std::string& usual = {}) const {
    return place < words_.size() ? words_[place] : usual;
  }
  [[nodiscard]] int whole(std::size_t place, const char* name, int usual, int least = 1) const {
    return place < words_.size() ? whole_number_of(words_[place], name, least) : usual;
  }
  [[nodiscard]] double positive(std::size_t place, const char* name, double usual) const {
    return place < words_.size() ? positive_number_of(words_[place], name) : usual;
  }
  void refuse_beyond(std::size_t most) const {
    if (words_.size() > most) {
      throw WrongArgument('"' + words_[most] + "\" is one argument too many");
    }
  }

private:
  std::vector<std::string> words_;
};

/// `usage`: its first word is the program's name, `work` returns the exit code.
template <class Work> int run(int argc, char** argv, std::string_view usage, Work&& work) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const std::string name(usage.substr(0, usage.find(' ')));
  for (const std::string& word : words) {
    if (word == "--help" || word == "-h") {
      std::printf("usage: %.*s", static_cast<int>(usage.size()), usage.data());
      return 0;
    }
  }
  try {
    return std::forward<Work>(work)(Arguments(std::move(words)));
  } catch (const WrongArgument& error) {
    std::fprintf(stderr, "%s: %s (see %s --help)\n", name.c_str(), error.what(), name.c_str());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return 1;
  }
}

} // namespace wrc::evidence
