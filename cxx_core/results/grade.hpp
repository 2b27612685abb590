/// How far the numbers of a result can be used, from its warnings: the one rule of all outputs.
///
/// Fine: as accurate as requested; warnings, if any, are remarks on the input. A little over: the
/// error estimate exceeds the accuracy, but is at most twice as large. Do not use: the estimate is
/// larger or not known, or a warning says that the numbers are not those of the bodies meant.
/// docs/warnings.md has the grade of each class. Thread rule: pure functions.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/warning.hpp"

namespace wrc {

/// Values of the result `grade`, and those of the C interface.
enum class Grade : std::uint8_t { fine = 0, slightly_over = 1, do_not_use = 2 };

/// "fine", "a little over", "do not use".
std::string_view name_of(Grade grade);

Grade grade_of(const Warning& warning);
/// The worst of them; fine without any.
Grade grade_of(const Warnings& warnings);

} // namespace wrc
