/// The scenes on which accuracy is measured: always the same ones.
///
/// Groups: `table1` (the paper's Table 1 at 21 lateral displacements), `manchester` (S1002 on the
/// Manchester UIC60), `two-patch` (S1002 on 56E1 where tread and flange carry together), `flange`
/// (displacements at the flange), and `spread`: pairs of profiles drawn in turn; displacement, yaw,
/// load (1 kN to 300 kN, uniform in its logarithm) and cant drawn from a fixed seed.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "support/scene.hpp"

namespace tradeoff {

struct Case {
  std::string name;
  std::string group;
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::pair<std::string, double>> numbers;

  void apply(driver::Scene& scene) const;
  /// A number of the scene that the family sets, or a value to take if it does not.
  [[nodiscard]] double number_or(const std::string& key, double otherwise) const;
  /// Keys and values in one line.
  [[nodiscard]] std::string text() const;
};

/// The first `count` scenes of the family, groups mixed so that few already show all of them; all
/// groups but `spread` have an end, `spread` has none.
std::vector<Case> make_family(std::size_t count);

} // namespace tradeoff
