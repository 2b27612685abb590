/// What the measurements of all scenes say together: as table, JSON and
/// pictures.
#pragma once

#include <array>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "support/statistics.hpp"
#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {

void print_summary(const std::vector<Measured>& all, std::ostream& out);
nlohmann::json json_of(const std::vector<Measured>& all);

/// Writes tradeoff_work_precision.png, tradeoff_asked.png, tradeoff_estimate.png and
/// tradeoff_models.png (with models measured) into a folder that exists.
void draw_pictures(const std::vector<Measured>& all, const std::filesystem::path& folder,
                   bool with_models);

/// Ways whose accuracy is requested.
inline constexpr std::array asked_labels{"forces", "pressures", "double"};

using driver::median;
using driver::quantile;

/// Statistics of a requested accuracy, over all wheels.
struct AskedRow {
  std::string label; ///< of the way
  double asked = 0.0;
  int samples = 0;
  int left_out = 0; ///< wheels besides, whose truth is not good to half the accuracy
  double met = 0.0; ///< fraction that meets the accuracy in all its quantities
  double median_error = 0.0;
  double error_95 = 0.0;
  double error_99 = 0.0;
  double worst = 0.0;           ///< error over accuracy
  double bounded = 0.0;         ///< fraction of estimates that are not smaller than the error
  double median_estimate = 0.0; ///< over the error
  double reported = 0.0; ///< fraction of missed accuracies that a warning or the estimate reports
  double median_ms = 0.0;
};
std::vector<AskedRow> asked_rows(const std::vector<Measured>& all);

/// 95th percentile of one quantity's error over the row's wheels, relative to its allowance.
double counted_95(const std::vector<Measured>& all, const AskedRow& row, Quantity quantity);
/// As it counts.
std::string name_of(Quantity quantity);

/// A wheel's run beyond the requested accuracy.
struct Miss {
  std::string options; ///< of wrc_case, to replay it
  std::string side, label, quantity, warnings;
  double asked = 0.0, error = 0.0, estimate = 0.0, truth_uncertainty = 0.0;
};
/// Worst first, by error over accuracy.
std::vector<Miss> misses(const std::vector<Measured>& all);

/// Statistics of a model: errors of pmax and approach by validity.
struct ModelRow {
  std::string label;
  double validity_from = 0.0, validity_to = 0.0;
  int samples = 0;
  double median_pmax = 0.0, pmax_95 = 0.0, worst_pmax = 0.0, median_approach = 0.0,
         approach_95 = 0.0;
  double within_10 = 0.0; ///< fraction with both errors below 10 %
  double median_ms = 0.0;
};
/// Whether pmax and depth are.
bool is_within(const WheelError& error, double limit);
std::vector<ModelRow> model_rows(const std::vector<Measured>& all);

/// Accuracy of pressures against the best prescribed grid, of the scenes with grids.
struct HandRow {
  double asked = 0.0;
  int scenes = 0;            ///< with a grid that meets the accuracy
  double median_ratio = 0.0; ///< time over that of the best grid
  double ratio_90 = 0.0;
  double within = 0.0; ///< fraction within 1.5 times
};
std::vector<HandRow> hand_rows(const std::vector<Measured>& all);

} // namespace tradeoff
