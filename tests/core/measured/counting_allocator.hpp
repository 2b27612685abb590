/// The memory in use, as operator new gives it, and its peak: replaces the operators of the
/// program.
#pragma once

#include <cstddef>

/// Bytes in use now.
std::size_t memory_in_use();
/// The most since the last call of reset_peak_memory().
std::size_t peak_memory();
void reset_peak_memory();
