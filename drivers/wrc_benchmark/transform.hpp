/// Time of a fast Fourier transform, which times of solutions are compared with.
#pragma once

#include "wrc_benchmark/problem.hpp"

namespace benchmark {

/// Median time in ms of `repeats` pairs of a real transform of this size in double precision and
/// its inverse, by FFTW's own two-dimensional transform with estimated plans. Planning and one pair
/// beforehand are not timed. Throws driver::Failure. May be called from several threads.
double measure_transform(const GridSize& size, int repeats);

} // namespace benchmark
