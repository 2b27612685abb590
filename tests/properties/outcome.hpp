/// What a scene came to, read through the interface: status, text and numbers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "wrcontact.hpp"

namespace properties {

struct Outcome {
  wrc_status status = WRC_OK;
  std::string error;
  std::map<std::string, double> numbers; ///< but for times and sensitivities
  std::map<std::string, std::string> texts;
  /// Of the patches and their parts ("left.patches.0.parts.1"), with `with_fields`.
  std::map<std::string, std::vector<double>> pressures;

  Outcome(const wrcontact::Scene& scene, wrc_status status, bool with_fields = false);

  [[nodiscard]] bool has_results() const { return status == WRC_OK || status == WRC_NOT_CONVERGED; }
  [[nodiscard]] bool has(const std::string& name) const { return numbers.contains(name); }
  [[nodiscard]] double at(const std::string& name) const { return numbers.at(name); }
  /// Whether one of a side's warnings has these words.
  [[nodiscard]] bool warns(const std::string& side, const std::string& words) const;
  /// Whether a side's warnings tell that the accuracy was not reached.
  [[nodiscard]] bool is_told_inaccurate(const std::string& side) const;
  /// "left" and "right", as far as they were solved.
  [[nodiscard]] std::vector<std::string> sides() const;
  /// The name of the first number whose bits differ; empty if none do.
  [[nodiscard]] std::string difference_to(const Outcome& other) const;
};

} // namespace properties
