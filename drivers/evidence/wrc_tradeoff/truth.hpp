/// What accuracies, error estimates and warnings are worth: errors of the results of wheels as
/// vehicles use them, against solutions along curves that are 100 to 1000 times as accurate.
///
/// Scenes of four kinds. `wheels`: all built-in wheels on all built-in rails with the dimensions
/// that belong to them, radii worn by up to a tenth, inclination 0, 1:40 or 1:20, lateral
/// displacements to 8 mm, yaw to 10 mrad on half of them, 20 to 150 kN a wheel. `creep`: the same,
/// with creep forces from a motion. `flats`: a wheel with a flat, sharp or rounded, at or beside
/// it, and `crossings`: one on the crossing of drivers/studies; both with creep forces. Slices are
/// written into the folder truth_lists, where the program runs.
///
/// Truth: solve.curved "yes" at `curved_accuracy`, creep forces at `creep_truth_accuracy`. The
/// difference to a truth four times as coarse is its uncertainty. Results whose uncertainty exceeds
/// half of their bound are counted separately.
#pragma once

#include <array>
#include <cstddef>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {

inline constexpr double curved_accuracy = 1e-5;
inline constexpr std::array judged_accuracies{1e-2, 1e-3};

/// Errors that are judged. Depth and normal force, moments and centre of pressure, and the area,
/// which counts by its share, are as in WheelError; creep forces of all patches together are over
/// mu N, the spin moment over mu N c, with c = sqrt(product of semi-axes).
inline constexpr std::array judged_names{"depth, force", "lateral force", "moments",
                                         "pmax",         "creep forces",  "spin moment"};
inline constexpr std::size_t judged_pmax = 3;
inline constexpr std::size_t first_of_creep = 4;
/// Not a number: the wheel does not have it.
using JudgedErrors = std::array<double, judged_names.size()>;

/// Scenes of `wheels` wheels, and for ten of them three with creep forces, two on flats and two on
/// the crossing.
std::vector<Case> make_truth_cases(std::size_t wheels);

/// Truths in a file, a line for each wheel or wheelset: a later run need not solve them again.
class TruthFile {
public:
  /// Reads what the file has, if there is one; without a path nothing is kept.
  explicit TruthFile(const std::string& path);
  [[nodiscard]] std::optional<nlohmann::json> find(const std::string& options) const;
  /// By any thread.
  void add(const std::string& options, const nlohmann::json& truth);

private:
  std::map<std::string, nlohmann::json> known_;
  std::ofstream file_;
  std::mutex mutex_;
};

/// A wheel at an accuracy.
struct Judged {
  std::string accuracy_of;
  double accuracy = 0.0;
  JudgedErrors errors{};
  JudgedErrors uncertainty{};       ///< of the truth
  std::array<double, 2> estimate{}; ///< of normal contact, of creep forces
  std::string warnings;             ///< of a grade above fine
};

struct TruthMeasured {
  Case scene;
  std::string failure;      ///< why there is none; else empty
  std::vector<Judged> runs; ///< of each wheel, meaning and accuracy
};

/// Never throws for what a scene may do: that is its `failure`.
TruthMeasured measure_truth(const Case& scene, TruthFile& truths);

void print_truth_summary(const std::vector<TruthMeasured>& all, std::ostream& out);
nlohmann::json truth_json_of(const std::vector<TruthMeasured>& all);

} // namespace tradeoff
