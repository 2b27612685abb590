/// What a warning says where solve.element_limit leaves an accuracy fewer elements than it needs.
///
/// Thread rule: a pure function.
#pragma once

#include <string>

namespace wrc {

/// That a limit holds, how many elements would be needed, and what lifts it.
std::string text_of_limit(double wanted, double limit);

} // namespace wrc
