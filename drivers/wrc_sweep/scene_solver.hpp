/// Solves scenes of a study one by one, each as if it were the only one.
#pragma once

#include "wrc_sweep/row.hpp"
#include "wrc_sweep/study.hpp"

namespace driver {

class SceneSolver {
public:
  explicit SceneSolver(const Study& study) : study_(study) {}
  /// Never throws for a scene that cannot be solved: the row tells why.
  Row solve(std::int64_t index);

private:
  void read_results(Row& row) const;

  const Study& study_;
  Scene scene_;
  /// Keeps profiles, tables and plans, but nothing that the answer depends on.
  Solver solver_;
};

} // namespace driver
