/// The elements that a wheel may take if solve.element_limit does not say, and what a warning says
/// where that leaves an accuracy fewer than it needs.
///
/// Thread rule: pure functions.
#pragma once

#include <string>

namespace wrc {

/// The limit of an accuracy: many times what contacts usually take.
double limit_by_accuracy(double accuracy);

/// That a limit holds, how many elements would be needed, and what lifts it.
std::string text_of_limit(double wanted, double limit);

} // namespace wrc
