/// Solves the scenes of a study that are not in its journal yet, on threads and ranks, and writes
/// the results of a finished study.
#pragma once

#include <cstdint>
#include <filesystem>

#include "support/stopwatch.hpp"
#include "wrc_sweep/journal.hpp"
#include "wrc_sweep/ranks.hpp"

namespace driver {

/// One line on stderr that says how far a study is and how long it will take.
class Progress {
public:
  /// `before`: done by an earlier run.
  Progress(bool shown, std::int64_t before, std::int64_t all);
  /// Draws the line at most ten times a second.
  void show(std::int64_t done, std::int64_t failed);
  /// Draws the last state and ends the line.
  void finish(std::int64_t done, std::int64_t failed);

private:
  void draw(std::int64_t done, std::int64_t failed) const;

  bool shown_;
  std::int64_t before_;
  std::int64_t all_;
  Stopwatch watch_;
  double last_ = -1.0; ///< seconds
};

/// From now on Ctrl-C and SIGTERM end a study after the scenes being solved; the second one ends
/// the program at once.
void catch_interrupts();

/// Rank 0: hands out the scenes, and solves some itself on `threads` threads. Returns when all are
/// done, or after an interrupt when those begun are done.
void run_study(const Study& study, int threads, const Ranks& ranks, Journal& journal,
               Progress& progress);
/// Other ranks: solve what rank 0 hands out.
void serve_study(const Study& study, int threads, const Ranks& ranks);

/// One line per scene: number, the keys that vary, results, grade and count of warnings, then
/// texts: status, message, warnings. Fields are not in it.
void write_csv(const Study& study, Journal& journal, const std::filesystem::path& path);
/// NetCDF-4 (HDF5): a dimension for each key that varies, a variable for each result; fields of all
/// patches one after the other, as a contiguous ragged array of the CF conventions.
void write_netcdf(const Study& study, Journal& journal, const std::filesystem::path& path);

} // namespace driver
