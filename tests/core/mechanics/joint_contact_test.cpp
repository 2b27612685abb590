/// Patches solved together: each must be the solution of its own problem at the shared approach,
/// and the loads must add up. References: the same patch by itself, dense sums, one grid over both.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "half_space/displacement_operator.hpp"
#include "mechanics/patch_coupling.hpp"
#include "support/errors.hpp"
#include "support/solver_checks.hpp"

namespace wrc::test::joint_contact_test {
namespace {

/// A patch with a gap of its own.
struct OwnedPatch {
  Grid grid;
  std::vector<double> distance;
  double share = 1.0;

  [[nodiscard]] PatchGap gap() const { return {grid, distance, share}; }
};

/// A body over a patch that touches `offset` mm (along the normal) after the first one.
OwnedPatch hertz_patch(std::size_t rows, std::size_t columns, double lateral_step, double step,
                       double radius, double offset, double share) {
  OwnedPatch patch{centred_grid(rows, columns, lateral_step, step), {}, share};
  patch.distance = hertz_gap(patch.grid, 1.0 / radius, 1.5 / radius);
  for (double& value : patch.distance) {
    value += offset;
  }
  return patch;
}

/// Tread and flange: sizes, steps, radii and angles differ; the third hardly touches.
std::vector<OwnedPatch> tread_and_flange() {
  return {hertz_patch(60, 50, 0.15, 0.2, 300.0, 0.0, std::cos(0.05)),
          hertz_patch(34, 70, 0.05, 0.08, 40.0, 0.012, std::cos(1.1)),
          hertz_patch(21, 23, 0.1, 0.1, 150.0, 0.06, std::cos(0.3))};
}

std::vector<PatchGap> gaps_of(const std::vector<OwnedPatch>& patches) {
  std::vector<PatchGap> gaps;
  gaps.reserve(patches.size());
  for (const OwnedPatch& patch : patches) {
    gaps.push_back(patch.gap());
  }
  return gaps;
}

NormalProblem joint_with_load(const std::vector<PatchGap>& gaps, double load, double tolerance) {
  NormalProblem problem;
  problem.patches = gaps;
  problem.combined_modulus = steel_modulus;
  problem.load = load;
  problem.tolerance = tolerance;
  return problem;
}

/// Pressures of a joint solution against those of each patch alone at the approach found, and the
/// load they make.
void expect_each_patch_solved(const NormalProblem& problem, const NormalSolution& solution,
                              const std::string& name) {
  EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met) << name;
  double largest = 0.0;
  double load = 0.0;
  std::vector<PatchSolution> alone;
  for (std::size_t k = 0; k < problem.patches.size(); ++k) {
    const PatchGap& patch = problem.patches[k];
    PatchProblem one(patch.grid, patch.undeformed_distance, problem.combined_modulus);
    one.approach = solution.approach * patch.approach_cosine;
    alone.push_back(solve_exactly(one));
    largest =
        std::max(largest, *std::max_element(alone[k].pressure.begin(), alone[k].pressure.end()));
    load += patch.approach_cosine * solution.patches[k].normal_force;
  }
  for (std::size_t k = 0; k < problem.patches.size(); ++k) {
    double error = 0.0;
    for (std::size_t i = 0; i < alone[k].pressure.size(); ++i) {
      error = std::max(error, std::abs(alone[k].pressure[i] - solution.patches[k].pressure[i]));
    }
    // The approach has an error of its own, of the order of the tolerance.
    EXPECT_LE(error, 2.0 * problem.tolerance * largest) << name << " patch " << k;
  }
  if (problem.load) {
    EXPECT_NEAR(load, *problem.load, load_rounding * *problem.load) << name;
  }
}

TEST(JointContact, EachPatchIsSolvedAndTheLoadAddsUp) {
  const std::vector<OwnedPatch> patches = tread_and_flange();
  const std::vector<PatchGap> gaps = gaps_of(patches);
  for (const Precision precision : {Precision::mixed, Precision::double_only}) {
    NormalSolver solver(PlannerRigor::estimate, precision);
    // From one patch in contact to all three.
    for (const double load : {50.0, 5e3, 4e4}) {
      for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
        const NormalProblem problem = joint_with_load(gaps, load, tolerance);
        const std::string name =
            std::to_string(load) + " N, tolerance " + std::to_string(tolerance);
        const NormalSolution solution = solver.solve(problem);
        expect_each_patch_solved(problem, solution, name);
        NormalProblem by_approach = problem;
        by_approach.load.reset();
        by_approach.approach = solution.approach;
        expect_each_patch_solved(by_approach, solver.solve(by_approach), name + " by approach");
      }
    }
  }
}

TEST(JointContact, OrderOfPatchesDoesNotMatter) {
  std::vector<OwnedPatch> patches = tread_and_flange();
  const double tolerance = 1e-8;
  NormalSolver solver;
  const std::vector<PatchGap> gaps = gaps_of(patches);
  const NormalSolution forward = solver.solve(joint_with_load(gaps, 2e4, tolerance));
  const std::vector<PatchGap> reversed(gaps.rbegin(), gaps.rend());
  const NormalSolution backward = solver.solve(joint_with_load(reversed, 2e4, tolerance));
  EXPECT_NEAR(forward.approach, backward.approach, tolerance * forward.approach);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(forward.patches[k].normal_force, backward.patches[2 - k].normal_force,
                10.0 * tolerance * 2e4);
  }
}

TEST(JointContact, SharedApproachCostsFewMoreConvolutions) {
  // Two patches that differ in size, load and angle, against two that are alike: those take as many
  // as one of them alone on the same grids.
  const OwnedPatch patch = hertz_patch(128, 64, 0.1, 0.2, 300.0, 0.0, 1.0);
  NormalSolver solver;
  const NormalSolution alike = solver.solve(joint_with_load({patch.gap(), patch.gap()}, 4e4, 1e-5));
  const OwnedPatch other = hertz_patch(120, 60, 0.1, 0.2, 250.0, 0.004, std::cos(0.4));
  const NormalSolution both =
      solver.solve(joint_with_load({patch.gap(), other.gap()}, 3.5e4, 1e-5));
  EXPECT_LE(both.convolutions, 1.3 * alike.convolutions + 1.0)
      << alike.convolutions << " and " << both.convolutions;
  // A patch with a hundredth of the load: one step length for all would serve the larger one.
  const OwnedPatch small = hertz_patch(40, 64, 0.05, 0.1, 300.0, 0.0395, 1.0);
  const NormalSolution unequal =
      solver.solve(joint_with_load({patch.gap(), small.gap()}, 2e4, 1e-5));
  EXPECT_GT(unequal.patches[1].normal_force, 0.0);
  EXPECT_LT(unequal.patches[1].normal_force, 0.02 * unequal.patches[0].normal_force);
  EXPECT_LE(unequal.convolutions, 1.3 * alike.convolutions + 1.0)
      << alike.convolutions << " and " << unequal.convolutions;
}

TEST(JointContact, ZeroLoadGivesNoPressure) {
  const std::vector<OwnedPatch> patches = tread_and_flange();
  const std::vector<PatchGap> gaps = gaps_of(patches);
  NormalSolver solver;
  const NormalSolution solution = solver.solve(joint_with_load(gaps, 0.0, 1e-5));
  EXPECT_NEAR(solution.approach,
              *std::min_element(patches[0].distance.begin(), patches[0].distance.end()) /
                  patches[0].share,
              1e-15);
  for (const auto& patch : solution.patches) {
    EXPECT_EQ(patch.normal_force, 0.0);
  }
}

/// Two lobes on one grid, cut into two patches in the same plane.
struct CutPlane {
  OwnedPatch whole;
  std::vector<OwnedPatch> parts;
  PatchInteraction interaction;
};

CutPlane cut_plane() {
  CutPlane plane;
  plane.whole.grid = centred_grid(120, 50, 0.1, 0.12);
  const Grid& grid = plane.whole.grid;
  for (std::size_t i = 0; i < grid.lateral_count; ++i) {
    for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
      const double x = grid.longitudinal(j);
      const double y = grid.lateral(i);
      const double lobe = y < 0.0 ? (y + 3.0) * (y + 3.0) / 160.0 : (y - 2.6) * (y - 2.6) / 60.0;
      plane.whole.distance.push_back(x * x / 600.0 + lobe + (y < 0.0 ? 0.0 : 0.004));
    }
  }
  for (const auto& [first, count] : {std::pair<std::size_t, std::size_t>{0, 55}, {62, 58}}) {
    OwnedPatch part;
    part.grid = grid;
    part.grid.lateral_count = count;
    part.grid.lateral_first = 0.0;
    const double* begin = plane.whole.distance.data() + first * grid.longitudinal_count;
    part.distance.assign(begin, begin + count * grid.longitudinal_count);
    plane.parts.push_back(part);
    plane.interaction.places.push_back({grid.lateral(first), 0.0});
  }
  plane.interaction.coupling_weight = {1.0, 1.0, 1.0, 1.0};
  return plane;
}

/// Both ways to solve a cut plane.
struct CutPlaneSolutions {
  PatchSolution whole;
  NormalSolution joint;
};

CutPlaneSolutions solve_both_ways(const CutPlane& plane, double load) {
  constexpr double tolerance = 1e-8;
  NormalSolver solver;
  CutPlaneSolutions found;
  found.whole = solver.solve(with_load(plane.whole.grid, plane.whole.distance, load, tolerance));
  const std::vector<PatchGap> gaps = gaps_of(plane.parts);
  NormalProblem problem = joint_with_load(gaps, load, tolerance);
  problem.interaction = &plane.interaction;
  found.joint = solver.solve(problem);
  return found;
}

TEST(JointContact, CoupledPatchesOfOnePlaneAreOneContact) {
  const CutPlane plane = cut_plane();
  const double load = 1e4;
  const auto [whole, joint] = solve_both_ways(plane, load);
  EXPECT_EQ(joint.stop_reason, StopReason::tolerance_met);
  // Interpolation between sixteen nodes each way, with less distance than they would like.
  constexpr double node_error = 2e-6;
  EXPECT_NEAR(joint.approach, whole.approach, node_error * whole.approach);
  const double largest = *std::max_element(whole.pressure.begin(), whole.pressure.end());
  double error = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t first = k == 0 ? 0 : 62 * plane.whole.grid.longitudinal_count;
    for (std::size_t i = 0; i < joint.patches[k].pressure.size(); ++i) {
      error = std::max(error, std::abs(joint.patches[k].pressure[i] - whole.pressure[first + i]));
    }
  }
  EXPECT_LE(error, 5.0 * node_error * largest);
  // Without interaction the approach is less by what the lobes displace at each other.
  const std::vector<PatchGap> gaps = gaps_of(plane.parts);
  EXPECT_LT(NormalSolver().solve(joint_with_load(gaps, load, 1e-8)).approach,
            0.95 * whole.approach);
}

TEST(JointContact, FindsContactMissedByCoarseGridsInBothInteractingPatches) {
  CutPlane plane = cut_plane();
  const std::size_t columns = plane.whole.grid.longitudinal_count;
  // Single elements far outside, as deep as the first lobe.
  for (const auto& [part, row, column] : {std::array<std::size_t, 3>{0, 3, 4}, {1, 54, 45}}) {
    plane.parts[part].distance[row * columns + column] = 0.0;
    plane.whole.distance[((part == 0 ? 0 : 62) + row) * columns + column] = 0.0;
  }
  const auto [whole, joint] = solve_both_ways(plane, 1e4);
  EXPECT_EQ(joint.stop_reason, StopReason::tolerance_met);
  EXPECT_GT(joint.patches[0].pressure[3 * columns + 4], 0.0);
  EXPECT_GT(joint.patches[1].pressure[54 * columns + 45], 0.0);
  constexpr double node_error = 1e-4; // boxes now reach to the corners
  EXPECT_NEAR(joint.approach, whole.approach, node_error * whole.approach);
  const double largest = *std::max_element(whole.pressure.begin(), whole.pressure.end());
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t first = k == 0 ? 0 : 62 * columns;
    for (std::size_t i = 0; i < joint.patches[k].pressure.size(); ++i) {
      ASSERT_NEAR(joint.patches[k].pressure[i], whole.pressure[first + i],
                  5.0 * node_error * largest);
    }
  }
}

TEST(JointContact, InteractionGrowsWithTheCouplingWeight) {
  CutPlane plane = cut_plane();
  const std::vector<PatchGap> gaps = gaps_of(plane.parts);
  NormalProblem problem = joint_with_load(gaps, 1e4, 1e-6);
  NormalSolver solver;
  double last = solver.solve(problem).approach;
  problem.interaction = &plane.interaction;
  for (const double coupling_weight : {0.0, 0.25, 0.5, 1.0}) {
    plane.interaction.coupling_weight[1] = plane.interaction.coupling_weight[2] = coupling_weight;
    const double approach = solver.solve(problem).approach;
    EXPECT_GE(approach, last * (1.0 - 1e-5)) << coupling_weight;
    last = approach;
  }
}

TEST(PatchCoupling, IsSymmetricAndAgreesWithDirectSums) {
  const CutPlane plane = cut_plane();
  std::vector<Grid> boxes;
  for (std::size_t k = 0; k < 2; ++k) {
    const Grid& grid = plane.parts[k].grid;
    boxes.push_back({grid.lateral_count, grid.longitudinal_count, grid.lateral_step,
                     grid.longitudinal_step, plane.interaction.places[k].lateral,
                     grid.longitudinal_first});
  }
  PatchCoupling coupling(boxes, {0.0, 1.0, 1.0, 0.0});
  NodeField loads = coupling.field();
  // Half an ellipsoid of pressure in either box.
  std::vector<std::vector<double>> pressure(2);
  std::vector<std::vector<double>> displacement(2);
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < boxes[k].lateral_count; ++i) {
      for (std::size_t j = 0; j < boxes[k].longitudinal_count; ++j) {
        const double y = (static_cast<double>(i) - 28.0) / 20.0;
        const double x = (static_cast<double>(j) - 22.0 - 4.0 * static_cast<double>(k)) / 18.0;
        pressure[k].push_back(std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
      }
    }
    coupling.gather(k, pressure[k].data(), loads.load);
  }
  coupling.transfer(loads);
  for (std::size_t k = 0; k < 2; ++k) {
    displacement[k].assign(pressure[k].size(), 0.0);
    coupling.add_others(loads, k, displacement[k].data());
  }
  const double element = boxes[0].lateral_step * boxes[0].longitudinal_step;
  const auto expected = [&](std::size_t i, std::size_t j) {
    double sum = 0.0;
    for (std::size_t k = 0; k < boxes[0].lateral_count; ++k) {
      for (std::size_t l = 0; l < boxes[0].longitudinal_count; ++l) {
        const double across = boxes[1].lateral_first + 0.1 * static_cast<double>(i) -
                              boxes[0].lateral_first - 0.1 * static_cast<double>(k);
        const double along = 0.12 * (static_cast<double>(j) - static_cast<double>(l));
        sum +=
            pressure[0][k * boxes[0].longitudinal_count + l] * element / std::hypot(across, along);
      }
    }
    return sum / boxes[1].longitudinal_step;
  };
  const auto found = [&](std::size_t i, std::size_t j) {
    return displacement[1][i * boxes[1].longitudinal_count + j];
  };
  const double largest = expected(0, 25);
  for (std::size_t i = 0; i < boxes[1].lateral_count; i += 9) {
    for (std::size_t j = 0; j < boxes[1].longitudinal_count; j += 7) {
      EXPECT_NEAR(found(i, j), expected(i, j), 1e-7 * largest) << i << ", " << j;
    }
  }
  // No pressure sees the nodes: it would see a kink, which has a peak of its own.
  const auto bend = [](const auto& field, std::size_t i) {
    return field(i - 1, 25) - 2.0 * field(i, 25) + field(i + 1, 25);
  };
  for (std::size_t i = 1; i + 1 < boxes[1].lateral_count; ++i) {
    EXPECT_NEAR(bend(found, i), bend(expected, i), 1e-7 * largest) << i;
  }
  double one_way = 0.0;
  double other_way = 0.0;
  for (std::size_t i = 0; i < pressure[0].size(); ++i) {
    one_way += pressure[0][i] * displacement[0][i];
  }
  for (std::size_t i = 0; i < pressure[1].size(); ++i) {
    other_way += pressure[1][i] * displacement[1][i];
  }
  EXPECT_NEAR(one_way, other_way, 1e-12 * one_way);
  EXPECT_NEAR(coupling.energy(loads, 0, 1), coupling.energy_unit(0) * one_way,
              1e-12 * coupling.energy_unit(0) * one_way);
}

/// Two boxes of half an ellipsoid of pressure each, one beside the other.
struct TwoBoxes {
  static constexpr std::size_t rows = 20;
  static constexpr std::size_t columns = 24;
  std::vector<Grid> boxes;
  std::vector<double> pressure;

  /// `apart`: in half lengths of a box; `shifted`: along, in lengths.
  TwoBoxes(double longitudinal_step, double apart, double shifted) {
    constexpr double lateral_step = 0.1;
    const double half = 0.5 * lateral_step * (rows - 1);
    boxes = {{rows, columns, lateral_step, longitudinal_step, 0.0, 0.0},
             {rows, columns, lateral_step, longitudinal_step, (2.0 + apart) * half,
              shifted * longitudinal_step * columns}};
    for (std::size_t i = 0; i < rows * columns; ++i) {
      const double y = (static_cast<double>(i / columns) - 0.5 * (rows - 1)) / (0.5 * rows);
      const double x = (static_cast<double>(i % columns) - 0.5 * (columns - 1)) / (0.5 * columns);
      pressure.push_back(std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
  }
  [[nodiscard]] double between(std::size_t here, std::size_t there) const {
    const auto place = [](const Grid& box, std::size_t i) {
      return std::array{box.lateral_first + box.lateral_step * static_cast<double>(i / columns),
                        box.longitudinal_first +
                            box.longitudinal_step * static_cast<double>(i % columns)};
    };
    const auto a = place(boxes[1], here);
    const auto b = place(boxes[0], there);
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  }
};

/// What half an ellipsoid of pressure displaces eight rows beyond it, with boxes that hold so many
/// rows without pressure in between.
double displaced_beyond_empty_rows(std::size_t empty) {
  constexpr std::size_t rows = 96;
  constexpr std::size_t columns = 24;
  constexpr double step = 0.1;
  const std::size_t count = rows + empty;
  PatchCoupling coupling(
      {{count, columns, step, step, 0.0, 0.0},
       {count, columns, step, step, step * static_cast<double>(rows + 8 - empty), 0.0}},
      {0.0, 1.0, 1.0, 0.0});
  std::vector<double> pressure(count * columns);
  for (std::size_t i = 0; i < rows * columns; ++i) {
    const double y = (static_cast<double>(i / columns) - 0.5 * (rows - 1)) / (0.5 * rows);
    const double x = (static_cast<double>(i % columns) - 0.5 * (columns - 1)) / (0.5 * columns);
    pressure[i] = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
  }
  NodeField field = coupling.field();
  coupling.gather(0, pressure.data(), field.load);
  coupling.transfer(field);
  std::vector<double> found(pressure.size());
  coupling.add_others(field, 1, found.data());
  return found[empty * columns + columns / 2];
}

TEST(PatchCoupling, DoesNotDependOnRowsWithoutPressureBetweenTheBoxes) {
  const double apart = displaced_beyond_empty_rows(0);
  for (const std::size_t empty : {2U, 3U, 4U}) {
    EXPECT_NEAR(displaced_beyond_empty_rows(empty) / apart, 1.0, 1e-4) << empty;
  }
}

TEST(PatchCoupling, MeetsTheRequestedErrorOnSeparateBoxes) {
  for (const double error : {1e-3, 1e-4, 1e-5}) {
    for (const double step : {0.03, 0.1, 0.3}) {
      for (const double apart : {1.0, 1.5, 3.0, 8.0}) {
        for (const double shifted : {0.0, 0.5, 1.5}) {
          const TwoBoxes two(step, apart, shifted);
          PatchCoupling coupling(two.boxes, {0.0, 1.0, 1.0, 0.0}, error);
          NodeField field = coupling.field();
          for (const std::size_t k : {0U, 1U}) {
            coupling.gather(k, two.pressure.data(), field.load);
          }
          coupling.transfer(field);
          std::vector<double> found(two.pressure.size());
          coupling.add_others(field, 1, found.data());
          double largest = 0.0;
          double worst = 0.0;
          double energy = 0.0;
          for (std::size_t i = 0; i < found.size(); ++i) {
            double expected = 0.0;
            for (std::size_t j = 0; j < found.size(); ++j) {
              expected += two.pressure[j] * 0.1 / two.between(i, j);
            }
            largest = std::max(largest, expected);
            worst = std::max(worst, std::abs(found[i] - expected));
            energy += two.pressure[i] * expected;
          }
          EXPECT_LE(worst, 1.5 * error * largest) << step << ' ' << apart << ' ' << shifted;
          // Good enough to decide on the length of a step.
          const double sum = std::accumulate(two.pressure.begin(), two.pressure.end(), 0.0);
          const double rough = coupling.rough_energy(0, sum, 1, sum);
          EXPECT_NEAR(rough / (coupling.energy_unit(1) * energy), 1.0, 0.3)
              << step << ' ' << apart << ' ' << shifted;
          EXPECT_EQ(coupling.rough_energy(1, sum, 0, sum), rough);
        }
      }
    }
  }
}

TEST(JointContact, InvalidInputIsNamed) {
  const OwnedPatch patch = hertz_patch(8, 8, 1.0, 1.0, 300.0, 0.0, 1.0);
  NormalSolver solver;
  const auto expect_named = [&solver](const NormalProblem& problem, const char* name) {
    expect_error(
        ErrorCode::invalid_argument, [&] { solver.solve(problem); }, name);
  };
  std::vector<PatchGap> gaps;
  expect_named(joint_with_load(gaps, 1.0, 1e-3), "patches");
  gaps.push_back(patch.gap());
  expect_named(joint_with_load(gaps, -1.0, 1e-3), "load");
  NormalProblem both = joint_with_load(gaps, 1.0, 1e-3);
  both.approach = 1.0;
  expect_named(both, "approach");
  PatchInteraction interaction;
  NormalProblem coupled = joint_with_load(gaps, 1.0, 1e-3);
  coupled.interaction = &interaction;
  expect_named(coupled, "interaction.places");
  interaction.places.resize(1);
  interaction.coupling_weight = {2.0};
  expect_named(coupled, "interaction.coupling_weight");
  gaps[0].approach_cosine = 0.0;
  expect_named(joint_with_load(gaps, 1.0, 1e-3), "approach_cosine");
}

} // namespace
} // namespace wrc::test::joint_contact_test
