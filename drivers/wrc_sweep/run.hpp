/// Solves the scenes of a study that are not in its journal yet, on threads and ranks.
#pragma once

#include "wrc_sweep/journal.hpp"
#include "wrc_sweep/progress.hpp"
#include "wrc_sweep/ranks.hpp"

namespace driver {

/// Rank 0: hands out the scenes, and solves some itself on `threads` threads. Returns when all are
/// done, or after an interrupt when those begun are done.
void run_study(const Study& study, int threads, const Ranks& ranks, Journal& journal,
               Progress& progress);
/// Other ranks: solve what rank 0 hands out.
void serve_study(const Study& study, int threads, const Ranks& ranks);

} // namespace driver
