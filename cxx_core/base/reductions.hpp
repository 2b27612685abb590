/// Sums, products, multiples and least values of many numbers, vectorised.
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

/// Of float or double; the sum in double.
template <typename Real> double dot(const Real* one, const Real* other, std::size_t count);
/// to += factor from.
template <typename Real>
void add_scaled(Real* to, double factor, const Real* from, std::size_t count);
/// to = factor from.
template <typename Real>
void scale_to(Real* to, double factor, const Real* from, std::size_t count);

} // namespace wrc
