/// Results along a line of equal steps: how far each step leaves the slope around it, and what else
/// changed there.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "wrcontact.hpp"

namespace smoothness {

/// Steps before and after a step whose slope it is compared with.
inline constexpr std::size_t window = 10;

/// For n + 1 + 2 window values, the deviations of the n steps in the middle: of each, its
/// difference to the median of the steps up to `window` before and after it. A jump shows at its
/// step with its whole height and nowhere else, since a median ignores single steps. Curvature does
/// not show: wherever the slope grows or falls throughout the window, the median is the step in its
/// middle, and the deviation is exactly 0.
std::vector<double> deviations(const std::vector<double>& values);

/// What a side was solved with: numbers of patches, parts and solutions, grids, warnings.
using Facts = std::map<std::string, std::string>;
Facts facts_of(const wrcontact::Scene& scene, const std::string& side);
/// What differs, in one line.
std::string changes(const Facts& before, const Facts& after);

/// Beyond the limit: one step of one side.
struct Flag {
  std::string where;
  std::string quantity; ///< the one that deviates most
  double deviation = 0.0;
  std::string changed;
};

/// A side's results along the line.
class Line {
public:
  /// `judged` quantities count against the limit, others are measured only.
  Line(std::string side, std::vector<std::string> judged, std::vector<std::string> others);
  void add(const wrcontact::Scene& scene);

  /// Largest deviation of each quantity: of forces relative to `force`, of all else to itself.
  [[nodiscard]] std::map<std::string, double> worst(double force) const;
  /// `place` and the step tell where.
  [[nodiscard]] std::vector<Flag> flags(double force, double limit, const std::string& place) const;
  [[nodiscard]] const std::vector<double>& values(const std::string& quantity) const {
    return values_.at(quantity);
  }

private:
  [[nodiscard]] double scale(const std::string& quantity, double force) const;
  std::string side_;
  std::vector<std::string> judged_;
  std::map<std::string, std::vector<double>> values_;
  std::vector<Facts> facts_;
};

} // namespace smoothness
