/// Calls of the whole interface in any order with any arguments, good and bad: nothing may crash,
/// hang, print or end the program, and every status must be one that there is.
///
/// Files are written into the working folder. Arrays are as long as the counts given, or the counts
/// are absurd: a count that is merely wrong is beyond what a C function can know. Handles are one
/// set for the whole process, which any number of threads may use and destroy at the same time;
/// arrays are a thread's own.
#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "wrcontact.h"

/// Where the calls and their arguments come from.
class Choices {
public:
  virtual ~Choices() = default;
  /// A whole number from 0 to `end` - 1.
  virtual std::uint64_t below(std::uint64_t end) = 0;
  [[nodiscard]] virtual bool ended() const { return false; }
};

class SeededChoices : public Choices {
public:
  explicit SeededChoices(std::uint64_t seed) : generator_(seed) {}
  std::uint64_t below(std::uint64_t end) override { return generator_() % end; }

private:
  std::mt19937_64 generator_;
};

/// So many calls, or until the choices end. Tells the first status that may not be, if there is
/// one.
std::optional<wrc_status> unheard_of_status(Choices& choices, long calls);

/// Fills the places from which calls take their handles.
void make_handles();
/// Destroys all handles, which the next calls may still use, and fills the thread's arrays with
/// zeros.
void destroy_handles();
