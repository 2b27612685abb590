/// What a host program does with FFTW itself.
#pragma once

#include <cstddef>
#include <mutex>

/// Plans a transform of `length` values under the host's lock, transforms a one followed by zeros,
/// and destroys the plan; the mean of the spectrum, which is 1.
double sum_of_transform(std::recursive_mutex& planner, std::size_t length);
