/// Numbers of the library beside the numbers they should be.
#pragma once

#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace driver {

/// How far a number may be off, and why that much.
struct Tolerance {
  std::string name;
  double relative = 0.0;
  std::string reason;
};

struct Check {
  std::string group; ///< "paper", "contact", "own"
  std::string name;  ///< of the case
  std::string result;
  double expected = 0.0;
  double actual = 0.0;
  Tolerance tolerance;
  std::string trouble; ///< why there is no number, "" if there is one

  [[nodiscard]] double deviation() const {
    return expected == 0.0 ? actual : actual / expected - 1.0;
  }
  [[nodiscard]] bool passed() const {
    // Not "greater than": a NaN must fail.
    return trouble.empty() && std::abs(deviation()) <= tolerance.relative;
  }
};

/// Wheel/rail cases of a JSON file such as tests/reference/contact_cases.json. Throws
/// Failure if it cannot be understood.
std::vector<Check> run_contact_cases(const std::filesystem::path& file);

/// Solves the cases of a file. Cases of the group "own" take what they expect from the baselines.
/// Throws Failure for a file that cannot be understood.
std::vector<Check> run_stored_cases(const std::filesystem::path& cases,
                                    const std::filesystem::path& baselines);

/// Writes the actual values of all own checks as the new baselines; returns a line for each value
/// that has changed. Throws Failure, and writes nothing, if one of them has no value.
std::vector<std::string> update_baselines(const std::vector<Check>& checks,
                                          const std::filesystem::path& baselines);

void print_checks(const std::vector<Check>& checks, std::ostream& out);

} // namespace driver
