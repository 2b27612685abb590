/// Wheels whose contacts are solved along curves: against an independent solver, and as derivatives
/// of an elastic energy, which needs no reference.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "extent.hpp"
#include "mechanics/normal_solver.hpp"
#include "remesh/mean_curve.hpp"
#include "remesh/rail_normals.hpp"
#include "remesh/undeformed_distance.hpp"
#include "results/residuals.hpp"
#include "support/energy_pairs.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::curved_contact_test {
namespace {

Scene left_wheel(const std::string& rail, double lateral) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = rail;
  scene.lateral = lateral;
  scene.side = SideChoice::left;
  scene.curved = CurvedChoice::yes;
  return scene;
}

/// Forces and depths to 1e-3, pressures to 2e-3: the reference states 1e-4 to 1e-3 for itself.
TEST(CurvedContact, EqualsAnIndependentSolver) {
  const nlohmann::json cases = reference_data("force_direction.json").at("cases");
  EXPECT_EQ(cases.size(), 23u);
  for (const auto& entry : cases) {
    Scene scene = scene_of_direction(entry);
    scene.curved = CurvedChoice::yes;
    const double load = scene.left.load;
    const SceneResult result = solve_scene(scene);
    const WheelResult& wheel = *result.left;
    const auto& curved = entry.at("curved");
    const std::string where =
        scene.left.rail.name + ", " + std::to_string(scene.lateral) + ", " + std::to_string(load);
    const double amount = norm(wheel.force);
    EXPECT_NEAR(wheel.force.y, curved.at("Fy").get<double>(), 1e-3 * amount) << where;
    EXPECT_NEAR(wheel.force.z, load, 1e-9 * load) << where;
    EXPECT_NEAR(wheel.pmax, curved.at("pmax").get<double>(), 2e-3 * wheel.pmax) << where;
    EXPECT_NEAR(wheel.vertical - wheel.depth, curved.at("z").get<double>(), 3e-4) << where;
    // The sum of the pressures along their own normals depends on the curve, to second order in the
    // inclination of the surfaces to it.
    double pressures = 0.0;
    for (const PatchResult& patch : wheel.patches) {
      pressures += patch.normal_force;
    }
    EXPECT_NEAR(pressures, curved.at("N").get<double>(), 2e-3 * pressures) << where;
  }
}

TEST(CurvedContact, ForcesAreDerivativesOfItsEnergyAndTheirDerivativesAreSymmetric) {
  Draw draw;
  for (int i = 0; i < by_extent(24, 6); ++i) {
    Scene scene = frictionless_wheel(draw, i);
    scene.curved = CurvedChoice::yes;
    const EnergyErrors errors = energy_errors(scene);
    const auto trace = [&] {
      return scene.left.wheel.name + " on " + scene.left.rail.name + " at " +
             std::to_string(scene.lateral);
    };
    EXPECT_LE(errors.energy, 1e-3) << trace();
    EXPECT_LE(errors.sensitivities, 1e-3) << trace();
    EXPECT_LE(errors.pairs, 1e-3) << trace();
    EXPECT_LE(errors.reported, 4e-3) << trace();
  }
}

/// A single patch on the curve over a plane that is turned against its own, at its position.
Vector3 force_over_plane(const WheelResult& wheel, double turn) {
  const PatchResult& patch = wheel.patches.at(0);
  const PosedPair pair = wheel.details.pair();
  ContactFrame frame = tangent_frame(patch.frame.origin, patch.frame.angle() + turn);
  Grid grid = patch.grid;
  const double room = 0.2 * grid.lateral_step * static_cast<double>(grid.lateral_count);
  grid.lateral_first -= room;
  grid.lateral_step *= 1.4;
  const double last = grid.lateral(grid.lateral_count - 1);
  frame.curve = mean_curve(pair, frame, grid.lateral_first, last).curve;
  const RailNormals rail(pair.rail, frame, grid);
  const std::vector<double> distance = sample_undeformed_distance(pair, frame, grid);
  const std::vector<double> angles = row_angles(frame, grid);
  const PatchGap gap{grid, distance, 1.0, {}, {}, angles};
  NormalProblem problem;
  problem.patches = {&gap, 1};
  problem.combined_modulus = wheel.details.request.combined_modulus;
  problem.approach = 0.0;
  problem.elements = wheel.details.request.elements;
  return rail.force(NormalSolver().solve(problem).patches[0].pressure).force;
}

/// Ten times less than in planes (energy_test.cpp): curves over any of them are nearly the same.
TEST(CurvedContact, TheDirectionOfThePlaneBelowDoesNotMatter) {
  for (const double lateral : {0.0, 3.0, 5.0, 6.0, 6.5, 7.0, 8.0}) {
    Scene scene = left_wheel("UIC60-Manchester", lateral);
    scene.grid = {{96, 64}};
    const SceneResult result = solve_scene(scene);
    ASSERT_EQ(solved_patches(*result.left).size(), 1u) << lateral;
    const Vector3 here = force_over_plane(*result.left, 0.0);
    for (const double turn : {-0.1, -0.02, 0.02, 0.1}) {
      const Vector3 turned = force_over_plane(*result.left, turn);
      EXPECT_LE(norm(turned - here), 4e-4 * norm(here)) << lateral << ", " << turn;
    }
  }
}

TEST(CurvedContact, MeetsItsConditions) {
  for (const double lateral : {0.0, 5.0, 6.0, 7.0}) {
    SceneResult result = solve_scene(left_wheel("UIC60-Manchester", lateral));
    const Residuals residuals = residuals_of(*result.left);
    EXPECT_LT(residuals.complementarity, 1e-3) << lateral;
    EXPECT_GT(residuals.least_gap, -1e-3) << lateral;
    EXPECT_LT(residuals.load_balance, 1e-9) << lateral;
  }
}

/// On treads planes are right to 1e-3 of the pressures.
TEST(CurvedContact, HardlyDiffersFromAPlaneOnATread) {
  Scene scene = left_wheel("60E1", 0.0);
  const SceneResult curved = solve_scene(scene);
  scene.curved = CurvedChoice::no;
  const SceneResult plane = solve_scene(scene);
  EXPECT_NE(curved.left->pmax, plane.left->pmax);
  EXPECT_NEAR(curved.left->pmax, plane.left->pmax, 1e-3 * plane.left->pmax);
  EXPECT_NEAR(curved.left->force.y, plane.left->force.y, 1e-4 * norm(plane.left->force));
  EXPECT_NEAR(curved.left->depth, plane.left->depth, 1e-3 * plane.left->depth);
  EXPECT_NEAR(curved.left->patches[0].turn.range(), plane.left->patches[0].turn.range(), 1e-3);
  EXPECT_LT(*curved.left->model_error, *plane.left->model_error);
}

/// One curve for both lobes, whose fields lie on it too.
TEST(CurvedContact, JoinedPatchesLieOnOneCurve) {
  Scene scene = left_wheel("CHN60", 4.576851748452517);
  scene.yaw = -0.002959786977713627;
  scene.left.load = scene.right.load = 23686.89556895026;
  scene.accuracy = 1e-2;
  const SceneResult result = solve_scene(scene);
  const auto patch = std::ranges::find_if(
      result.left->patches, [](const PatchResult& one) { return one.parts.size() > 1; });
  ASSERT_NE(patch, result.left->patches.end());
  ASSERT_TRUE(patch->frame.curve);
  for (const PatchResult& part : patch->parts) {
    const Vector3 there = part.frame.to_track(0.0, 0.0, 0.0);
    const double lateral = patch->frame.lateral_of(part.frame.origin - patch->frame.origin);
    const Vector3 here = patch->frame.to_track(0.0, lateral, 0.0);
    EXPECT_NEAR(there.y, here.y, 1e-3);
    EXPECT_NEAR(there.z, here.z, 1e-3);
  }
}

TEST(CurvedContact, IsRefusedWithVerticalGaps) {
  Scene scene = left_wheel("60E1", 0.0);
  scene.gap = GapConvention::vertical;
  EXPECT_THROW(solve_scene(scene), Error);
  scene.curved = CurvedChoice::by_accuracy;
  const SceneResult automatic = solve_scene(scene);
  scene.curved = CurvedChoice::no;
  EXPECT_EQ(automatic.left->patches[0].pressure, solve_scene(scene).left->patches[0].pressure);
}

/// A plane where the accuracy has room for it, the curve where it has not.
TEST(CurvedContact, IsTakenAsFarAsTheAccuracyNeedsIt) {
  const auto pmax = [](CurvedChoice curved, double accuracy) {
    Scene scene = left_wheel("UIC60-Manchester", 6.0);
    scene.curved = curved;
    scene.accuracy = accuracy;
    scene.grid = {{64, 32}};
    return solve_scene(scene).left->pmax;
  };
  const double plane = pmax(CurvedChoice::no, 1e-3);
  const double curved = pmax(CurvedChoice::yes, 1e-3);
  EXPECT_GT(std::abs(plane - curved), 1e-3 * plane);
  EXPECT_EQ(pmax(CurvedChoice::by_accuracy, 0.1), plane);
  EXPECT_EQ(pmax(CurvedChoice::by_accuracy, 1e-3), curved);
  // In between smoothly, from one to the other.
  double before = plane;
  for (double accuracy = 5e-2; accuracy > 5e-3; accuracy *= 0.9) {
    const double here = pmax(CurvedChoice::by_accuracy, accuracy);
    EXPECT_LT(std::abs(here - before), 0.35 * std::abs(plane - curved)) << accuracy;
    before = here;
  }
  EXPECT_NEAR(before, curved, 0.05 * std::abs(plane - curved));
}

/// Greatest second difference of the lateral force over 400 steps of 0.1 um, over the load.
double roughness(CurvedChoice curved, double place) {
  SceneSolver solver;
  std::vector<double> forces;
  for (int step = 0; step < 400; ++step) {
    Scene scene = left_wheel("60E1", place + 1e-4 * step);
    scene.curved = curved;
    scene.accuracy_of = AccuracyOf::forces;
    forces.push_back(solver.solve(scene).left->force.y / 80000.0);
  }
  double worst = 0.0;
  for (std::size_t i = 2; i < forces.size(); ++i) {
    worst = std::max(worst, std::abs(forces[i] - 2.0 * forces[i - 1] + forces[i - 2]));
  }
  return worst;
}

/// Along small steps as in planes, where lobes join and where the plane bends to the curve. With
/// two lobes all leave up to 9.4e-6 of the load, as rows of elements come into contact, at places
/// of their own in each; less than 1e-7 elsewhere.
TEST(CurvedContact, ForcesFollowTheSceneAsInPlanes) {
  for (const double place : some_of({4.35, 4.6, 4.8, 5.2, 5.9}, 2)) {
    const double of_planes = roughness(CurvedChoice::no, place);
    for (const CurvedChoice curved : {CurvedChoice::yes, CurvedChoice::by_accuracy}) {
      EXPECT_LT(roughness(curved, place), std::max(1e-7, 1.3 * of_planes)) << place;
    }
  }
}

/// With `auto` at 4.4744 mm a second lobe begins 10 mm away: the part of the curve does not change
/// at once, by which the depth would jump by 1.1e-4.
TEST(CurvedContact, ALobeThatIsBornBendsNothingAtFirst) {
  SceneSolver solver;
  std::vector<double> depths;
  for (int step = 0; step < 40; ++step) {
    Scene scene = left_wheel("60E1", 4.4742 + 1e-5 * step);
    scene.side = SideChoice::both;
    scene.curved = CurvedChoice::by_accuracy;
    scene.accuracy_of = AccuracyOf::forces;
    depths.push_back(solver.solve(scene).left->depth);
  }
  for (std::size_t i = 2; i < depths.size(); ++i) {
    EXPECT_LT(std::abs(depths[i] - 2.0 * depths[i - 1] + depths[i - 2]), 1e-5 * depths[i]);
  }
}

} // namespace
} // namespace wrc::test::curved_contact_test
