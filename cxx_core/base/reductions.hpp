/// Sums and least values of many numbers, vectorised.
///
/// Their order is fixed by the instruction set, so that the same machine gives the same bits.
/// Thread rule: pure functions.
#pragma once

#include <cstddef>

namespace wrc {

double sum_of(const double* values, std::size_t count);
/// Infinite if there are none.
double least_of(const double* values, std::size_t count);
/// Smallest ratio of values to positive others.
double least_ratio(const double* values, const double* others, std::size_t count);
bool all_finite(const double* values, std::size_t count);

} // namespace wrc
