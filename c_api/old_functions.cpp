// Functions that have left the interface: programs linked with an earlier version find them here.
// No header declares them any more, so that a program that calls them no longer compiles.
#include "half_space/fft.hpp"
#include "handles.hpp"

namespace {

constexpr int64_t most_values = int64_t{1} << 28;
constexpr int32_t most_repeats = 1000;

} // namespace

extern "C" {

WRC_API wrc_status wrc_solver_forget(wrc_solver* solver, int32_t profiles);
WRC_API wrc_status wrc_measure_transform(int64_t rows, int64_t columns, int32_t repeats,
                                         double* median_ms);

/// wrc_solver_clear with `profiles` not 0; with 0 nothing.
wrc_status wrc_solver_forget(wrc_solver* solver, int32_t profiles) {
  return wrc::guard(solver, [&](wrc::SolverObject& object) {
    if (profiles != 0) {
      object.solver.forget();
    }
    return WRC_OK;
  });
}

/// Time of FFTW's own two-dimensional transform and its inverse, which benchmarks measure
/// themselves.
wrc_status wrc_measure_transform(int64_t rows, int64_t columns, int32_t repeats,
                                 double* median_ms) {
  return wrc::guard_process([&] {
    wrc::require_pointer(median_ms, "median_ms");
    if (rows < 1 || columns < 1 || rows > most_values || columns > most_values / rows) {
      wrc::throw_invalid_argument("rows x columns",
                                  std::to_string(rows) + " x " + std::to_string(columns),
                                  "must be between 1 and 2^28 values");
    }
    if (repeats < 1 || repeats > most_repeats) {
      wrc::throw_invalid_argument("repeats", repeats, "must be between 1 and 1000");
    }
    *median_ms = wrc::measure_transform(static_cast<std::size_t>(rows),
                                        static_cast<std::size_t>(columns), repeats);
  });
}
}
