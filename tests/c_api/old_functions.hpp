/// Functions that have left the interface, as earlier headers declared them: the library keeps them
/// for programs linked with these. Times of transforms are a way to plan of any size at once.
#pragma once

#include "wrcontact.h"

extern "C" {
wrc_status wrc_solver_forget(wrc_solver* solver, int32_t profiles);
wrc_status wrc_measure_transform(int64_t rows, int64_t columns, int32_t repeats, double* median_ms);
}
