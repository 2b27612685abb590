/// Models of creep forces (solve.creep) on the patches of scenes: errors beside the time they take.
///
/// Truth: the full theory at `creep_truth_accuracy`. An error is that of Fx and Fy over mu N and of
/// Mz over mu N c, with N and c = sqrt(product of semi-axes) of the patch as truth has it. All
/// accuracies are of forces (solve.accuracy_of). The full theory at an accuracy has the normal
/// contact of that accuracy, so that its errors are all that a user gets for his request; the other
/// models have that of `creep_model_accuracy`.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "support/random_scenes.hpp"
#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {

inline constexpr double creep_truth_accuracy = 5e-5;
inline constexpr double creep_model_accuracy = 1e-3;

struct CreepWay {
  const char* model; ///< of solve.creep
  double accuracy = creep_model_accuracy;
};
/// From the cheapest to the most accurate.
inline constexpr std::array creep_ways{
    CreepWay{"linear"},     CreepWay{"shen-hedrick-elkins"}, CreepWay{"polach"},
    CreepWay{"fastsim"},    CreepWay{"full", 1e-1},          CreepWay{"full", 3e-2},
    CreepWay{"full", 1e-2}, CreepWay{"full", 3e-3},          CreepWay{"full", 1e-3}};

/// A scene of the family's group `spread`, with friction of 0.1 to 0.5, and the source of its
/// creepages; or a step of a wheelset in motion.
struct CreepCase {
  Case scene;
  std::array<double, 3> direction{}; ///< of the linear forces of the three creepages, of length 1
  double size = 0.0;                 ///< of these forces, in mu N: 0.1 to 10; 0: in motion
};
std::vector<CreepCase> make_creep_cases(std::size_t count);
/// Steps spread over the run of support/service_run.hpp, three pairs of profiles in turn.
std::vector<CreepCase> make_motion_cases(std::size_t count);

/// Errors of a patch.
struct CreepError {
  std::array<double, 3> values{}; ///< with sign: Fx, Fy, Mz
  std::optional<double> estimate;
  [[nodiscard]] double largest() const;
};

/// A wheel with its patches, none if their number differs from the reference.
struct CreepWheel {
  std::vector<CreepError> patches;
  bool comparable = true;
};

struct CreepRun {
  double time_us = 0.0;               ///< of creep forces, median, for each patch
  std::array<CreepWheel, 2> wheels{}; ///< left and right
};

struct CreepMeasured {
  driver::Settings settings;  ///< with creepages, the same of both wheels, or a motion
  std::string failure;        ///< why there is none; else empty
  std::vector<CreepRun> runs; ///< of creep_ways
};

/// Times each way at most `repeats` times. Never throws for what a scene may do: that is its
/// `failure`.
CreepMeasured measure_creep(const CreepCase& one, int repeats);

/// Errors of a way over all patches.
struct CreepRow {
  std::string model;
  double accuracy = 0.0;
  int patches = 0;
  int left_out = 0; ///< wheels with another number of patches than truth
  std::array<double, 3> rms{}, error_99{}, worst{}; ///< of Fx, Fy, Mz
  double median_us = 0.0;
  // Largest of the three errors of the full theory:
  std::optional<double> met;             ///< fraction within the accuracy
  std::optional<double> bounded;         ///< fraction of estimates that are not smaller
  std::optional<double> median_estimate; ///< over the error
};
std::vector<CreepRow> creep_rows(const std::vector<CreepMeasured>& all);

void print_creep_summary(const std::vector<CreepMeasured>& all, std::ostream& out);
nlohmann::json creep_json_of(const std::vector<CreepMeasured>& all);
/// Writes tradeoff_creep.png, errors over time, into a folder that exists.
void draw_creep(const std::vector<CreepMeasured>& all, const std::filesystem::path& folder);

} // namespace tradeoff
