/// Problems of one patch and their solutions, with what belongs to the patch at hand.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "mechanics/normal_contact.hpp"
#include "support/contact_cases.hpp"

namespace wrc::test {

/// Owns its patch, but not the distances.
struct PatchProblem : NormalProblem {
  PatchProblem(const Grid& grid, std::span<const double> distance, double modulus)
      : patch{grid, distance} {
    patches = {&patch, 1};
    combined_modulus = modulus;
  }
  PatchProblem(const PatchProblem& other) : NormalProblem(other), patch(other.patch) {
    patches = {&patch, 1};
  }
  PatchProblem& operator=(const PatchProblem& other) {
    NormalProblem::operator=(other);
    patch = other.patch;
    patches = {&patch, 1};
    return *this;
  }
  ~PatchProblem() = default;

  PatchGap patch;
};

struct PatchSolution : NormalSolution, NormalSolution::Patch {
  PatchSolution() = default;
  PatchSolution(NormalSolution solution)
      : NormalSolution(std::move(solution)), NormalSolution::Patch(patches.front()) {}
};

inline PatchProblem with_load(const Grid& grid, const std::vector<double>& distance, double load,
                              double tolerance) {
  PatchProblem problem(grid, distance, steel_modulus);
  problem.load = load;
  problem.tolerance = tolerance;
  return problem;
}
inline PatchProblem with_approach(const Grid& grid, const std::vector<double>& distance,
                                  double approach, double tolerance) {
  PatchProblem problem(grid, distance, steel_modulus);
  problem.approach = approach;
  problem.tolerance = tolerance;
  return problem;
}
PatchProblem with_load(const Grid&, std::vector<double>&&, double, double) = delete;
PatchProblem with_approach(const Grid&, std::vector<double>&&, double, double) = delete;

} // namespace wrc::test
