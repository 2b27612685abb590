/// Scenes with lists of slices: equal slices, sides, threads, what was solved before, and places.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "creep/rolling_frame.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/solve_scene.hpp"
#include "scene/varying_lists.hpp"
#include "scene/vehicle_step.hpp"
#include "support/errors.hpp"

namespace wrc::test::varying_scene_test {
namespace {

/// All numbers but times.
void expect_same(SceneResult one, SceneResult other) {
  const std::vector<std::string> names = number_names(one);
  ASSERT_EQ(names, number_names(other));
  for (const std::string& name : names) {
    if (name.find("time") != std::string::npos)
      continue;
    const auto first = number_value(one, name);
    const auto second = number_value(other, name);
    ASSERT_TRUE(first && second) << name;
    EXPECT_TRUE(*first == *second || (std::isnan(*first) && std::isnan(*second)))
        << name << ": " << *first << ", " << *second;
  }
}

/// How contact is solved: the default, vertical gaps, approximate models.
struct Solved {
  const char* name;
  GapConvention gap;
  ModelRequest model;
  double model_error; ///< of pmax, by which cubics between rows change curvatures

  [[nodiscard]] Scene of(Scene scene) const {
    scene.gap = gap;
    scene.model = model;
    return scene;
  }
};
constexpr std::array all_solved{
    Solved{"default", GapConvention::tangent, ModelRequest::automatic, 0.0},
    Solved{"vertical", GapConvention::vertical, ModelRequest::automatic, 0.0},
    Solved{"hertz", GapConvention::tangent, ModelRequest::hertz, 1e-3},
    Solved{"kik-piotrowski", GapConvention::tangent, ModelRequest::kik_piotrowski, 1e-3}};

TEST_F(VaryingScene, EqualSlicesGiveTheBitsOfTheirProfile) {
  const std::string rail =
      list("equal.slcs", "60E1", {-50.0, 0.0, 30.0, 100.0}, [](double) { return 0.0; });
  const std::string wheel =
      list("equal.slcw", "S1002", {-1.0, 0.0, 2.0}, [](double) { return 0.0; });
  const Scene scene = scene_on(rail, wheel);
  Scene given = scene;
  ReadOptions options;
  options.smoothing_wavelength = 0.0;
  const auto profile = [&](const std::string& name, ProfileKind kind) {
    options.kind = kind;
    return std::make_shared<const Profile>(first_of(read_sliced_profile(name, options), kind));
  };
  for (SceneSide* side : {&given.left, &given.right}) {
    side->rail.given = profile(rail, ProfileKind::rail);
    side->wheel.given = profile(wheel, ProfileKind::wheel);
  }
  for (const Solved& each : all_solved)
    expect_same(solve_scene(each.of(scene)), solve_scene(each.of(given)));
}

/// Slices that differ far away only: the search of bodies that vary, and other elements.
TEST_F(VaryingScene, SlicesThatAreEqualNearbyGiveTheProfileToTheAccuracy) {
  const auto bump = [](double place) { return place > 1500.0 ? 1.0 : 0.0; };
  const std::vector<double> places = places_every(-1000.0, 2000.0, 50.0);
  Scene scene = scene_on(list("far.slcs", "60E1", places, bump));
  scene.accuracy = 1e-3;
  Scene equal = scene_on(list("same.slcs", "60E1", places, [](double) { return 0.0; }));
  equal.accuracy = 1e-3;
  const double load = scene.left.load;
  for (const Solved& each : all_solved) {
    const SceneResult one = solve_scene(each.of(scene));
    const SceneResult other = solve_scene(each.of(equal));
    EXPECT_NEAR(one.roll, other.roll, 1e-12);
    EXPECT_NEAR(one.vertical, other.vertical, 1e-9);
    for (const auto& [a, b] : {std::pair(&one.left, &other.left), {&one.right, &other.right}}) {
      EXPECT_LT(norm((*a)->force - (*b)->force), 1e-3 * load) << each.name;
      EXPECT_LT(norm((*a)->total->force - (*b)->total->force), 1e-3 * load) << each.name;
      EXPECT_NEAR((*a)->pmax, (*b)->pmax, (1e-2 + each.model_error) * (*b)->pmax) << each.name;
      EXPECT_NEAR((*a)->depth, (*b)->depth, 1e-3 * (*b)->depth) << each.name;
      EXPECT_NEAR((*a)->validity.value_or(1.0), (*b)->validity.value_or(1.0), 2e-2) << each.name;
    }
  }
}

/// The flat begins within reach of the search, far from the contact: both searches find the same.
/// What is left is that of iterations, on flanges most.
TEST_F(VaryingScene, AFlatThatIsNotTouchedChangesNoForce) {
  const std::string wheel = list("beside.slcw", "S1002", places_every(-0.2, 0.2, 0.005),
                                 [](double theta) { return -rounded_depth(theta, 0.6, 0.06); });
  const std::array<std::array<double, 3>, 5> poses{{{-2.0, 3e-3, 5e-9},
                                                    {0.0, 3e-3, 5e-9},
                                                    {1.5, 3e-3, 5e-9},
                                                    {3.0, 3e-3, 5e-9},
                                                    {6.0, -5e-3, 5e-8}}};
  for (const auto& pose : poses) {
    const auto solved = [&](double pitch) {
      Scene scene = scene_on("60E1", wheel);
      scene.lateral = pose[0];
      scene.yaw = pose[1];
      scene.pitch = pitch;
      return *solve_scene(scene).left;
    };
    const SceneWheel round = solved(2.0);
    const SceneWheel beside = solved(0.17);
    ASSERT_TRUE(round.details.pair().is_prismatic_along(along_track));
    ASSERT_FALSE(beside.details.pair().is_prismatic_along(along_track));
    EXPECT_NEAR(beside.depth, round.depth, 1e-7 * round.depth);
    EXPECT_LT(norm(beside.force - round.force), pose[2] * norm(round.force));
    EXPECT_LT(norm(beside.total->force - round.total->force), 1e-6 * norm(round.force));
  }
}

/// Under yaw the contact locus turns back across the rail beside the flange: rows there have two
/// least distances.
TEST_F(VaryingScene, AContactWhereTheLocusTurnsBackIsFound) {
  const std::string wheel = list("beside.slcw", "S1002", places_every(-0.2, 0.2, 0.005),
                                 [](double theta) { return -rounded_depth(theta, 0.6, 0.06); });
  for (const double lateral : {5.8, 5.9}) {
    const auto solved = [&](double pitch) {
      Scene scene = scene_on("60E1", wheel);
      scene.lateral = lateral;
      scene.yaw = 0.04;
      scene.pitch = pitch;
      scene.motion.reset();
      return *solve_scene(scene).left;
    };
    const SceneWheel round = solved(2.0);
    const SceneWheel beside = solved(0.4);
    ASSERT_TRUE(round.details.pair().is_prismatic_along(along_track));
    ASSERT_FALSE(beside.details.pair().is_prismatic_along(along_track));
    EXPECT_NEAR(beside.vertical, round.vertical, 1e-9);
    EXPECT_LT(norm(beside.force - round.force), 1e-3 * norm(round.force));
  }
}

TEST_F(VaryingScene, MirrorsToTheLastBit) {
  Scene one = scene_on(wavy_rail(), wheel_with_flat());
  one.left.displacement = {0.5, -0.3, 0.005};
  Scene other = one;
  other.lateral = -one.lateral;
  other.yaw = -one.yaw;
  other.motion = mirrored(*one.motion);
  std::swap(other.left.displacement, other.right.displacement);
  other.right.displacement = mirrored(one.left.displacement);
  const SceneResult first = solve_scene(one);
  const SceneResult second = solve_scene(other);
  EXPECT_EQ(first.roll, -second.roll);
  EXPECT_EQ(first.vertical, second.vertical);
  for (const auto& [here, there] :
       {std::pair(&first.left, &second.right), {&first.right, &second.left}}) {
    const WheelResult& a = **here;
    const WheelResult& b = **there;
    EXPECT_EQ(a.force.x, b.force.x);
    EXPECT_EQ(a.force.y, -b.force.y);
    EXPECT_EQ(a.total->force.x, b.total->force.x);
    EXPECT_EQ(a.total->force.y, -b.total->force.y);
    EXPECT_EQ(a.total->moment.y, b.total->moment.y);
    EXPECT_EQ(a.centroid.x, b.centroid.x);
    EXPECT_EQ(a.centroid.y, -b.centroid.y);
    ASSERT_EQ(a.patches.size(), b.patches.size());
    for (std::size_t k = 0; k < a.patches.size(); ++k)
      EXPECT_EQ(a.patches[k].pressure, b.patches[k].pressure);
  }
}

TEST_F(VaryingScene, ThreadsAndEarlierScenesChangeNoBit) {
  const Scene scene = scene_on(wavy_rail(), wheel_with_flat());
  const SceneResult alone = solve_scene(scene);
  Scene threads = scene;
  threads.threads = 2;
  expect_same(alone, solve_scene(threads));
  SceneSolver solver;
  Scene before = scene;
  before.along = -60.0;
  before.pitch = 0.0;
  before.lateral = -4.0;
  (void)solver.solve(before);
  expect_same(alone, solver.solve(scene));
  (void)solver.solve(scene_on("60E1"));
  SceneSolver beside = solver.beside();
  expect_same(alone, beside.solve(scene));
}

/// Places along are rounded to 2e-13 mm, which the choice of elements and the iterations see.
TEST_F(VaryingScene, DoesNotDependOnWhereTheOriginOfPlacesIs) {
  const Scene here = scene_on(wavy_rail());
  Scene there = scene_on(wavy_rail(1000.0));
  there.along = here.along + 1000.0;
  const SceneResult one = solve_scene(here);
  const SceneResult other = solve_scene(there);
  const double load = here.left.load;
  EXPECT_NEAR(one.vertical, other.vertical, 1e-10);
  for (const auto& [a, b] : {std::pair(&one.left, &other.left), {&one.right, &other.right}}) {
    EXPECT_LT(norm((*a)->force - (*b)->force), 1e-7 * load);
    EXPECT_LT(norm((*a)->total->force - (*b)->total->force), 1e-6 * load);
    EXPECT_NEAR((*a)->depth, (*b)->depth, 1e-7 * (*b)->depth);
  }
}

TEST_F(VaryingScene, EachRevolutionIsTheSame) {
  const std::string wheel = wheel_with_flat();
  Scene scene = scene_on("60E1", wheel);
  const SceneResult one = solve_scene(scene);
  scene.pitch += 2.0 * std::numbers::pi;
  const SceneResult other = solve_scene(scene);
  EXPECT_NEAR(one.vertical, other.vertical, 1e-10);
  EXPECT_LT(norm(one.left->total->force - other.left->total->force), 1e-6 * scene.left.load);
  scene.pitch = 1.0; // off the flat
  EXPECT_GT(std::abs(solve_scene(scene).vertical - one.vertical), 0.05);
}

/// The second of three slices lacks the line along the head: the parts beside it end there.
TEST_F(VaryingScene, TheSideOfAPartIsAState) {
  Scene scene = scene_on(
      with_features(list("side.slcs", "60E1", {-300.0, 0.0, 300.0}, [](double) { return 0.0; }),
                    "3", "-300 0 66 999\n0 -1 66 999\n300 0 66 999\n"));
  scene.side = SideChoice::left;
  scene.roll = 0.0;
  scene.lateral = scene.yaw = scene.along = scene.pitch = 0.0;
  SceneResult result = solve_scene(scene);
  const auto& warnings = result.left->warnings;
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const Warning& warning) {
    return warning.text.find("the side of a part") != std::string::npos;
  }));
  EXPECT_EQ(*number_value(result, "left.state"), 32.0);
}

/// Slices 50 mm apart, of which the lower one reaches beyond the other; a contact near the flange,
/// where tractions turn with the direction of rolling.
TEST_F(VaryingScene, ARisingRailIsALevelOneOnATurnedTrack) {
  const std::vector<double> places = places_every(-300.0, 300.0, 50.0);
  for (const double slope : {0.1, 0.19}) {
    const double cosine = 1.0 / std::hypot(1.0, slope);
    const auto scene_of = [&](const std::string& rail) {
      Scene scene = scene_on(rail);
      scene.side = SideChoice::left;
      scene.track.inclination = 0.0;
      scene.roll = 0.0;
      scene.left.rail.options.rail_origin = scene.right.rail.options.rail_origin = 753.0;
      scene.lateral = 6.0;
      scene.yaw = scene.along = scene.pitch = 0.0;
      scene.accuracy = 1e-3;
      scene.curved = CurvedChoice::by_accuracy;
      scene.motion = Motion{.speed = 20000.0, .pitch = 0.996 * 20000.0 / 460.0};
      return scene;
    };
    const SceneResult rising = solve_scene(
        scene_of(list("rising.slcs", "60E1", places, [slope](double x) { return slope * x; })));
    Scene level = scene_of(list(
        "level.slcs", "60E1", places, [](double) { return 0.0; }, 0.0, cosine));
    level.motion->speed /= cosine;
    level.left.load /= cosine;
    const SceneResult flat = solve_scene(level);
    const double load = level.left.load;
    const double angle = std::atan(slope);
    EXPECT_GT(flat.left->patches.at(0).frame.angle(), 0.3);
    EXPECT_NEAR(rising.left->pmax, flat.left->pmax, level.accuracy * flat.left->pmax) << slope;
    EXPECT_LT(norm(rising.left->force - tilted(flat.left->force, angle)), 1e-4 * load) << slope;
    EXPECT_LT(norm(rising.left->total->force - tilted(flat.left->total->force, angle)),
              level.accuracy * load)
        << slope;
  }
}

/// In the same way, without creep forces, at two angles of contact. Planes are means over rows, of
/// which the search has others.
TEST_F(VaryingScene, ModelsOnARisingRailAreThoseOfALevelOne) {
  const std::vector<double> places = places_every(-300.0, 300.0, 50.0);
  const double slope = 0.15;
  const double cosine = 1.0 / std::hypot(1.0, slope);
  const std::string rising =
      list("model_rising.slcs", "60E1", places, [slope](double x) { return slope * x; });
  // Of a level one the slices differ far away.
  const std::string level = list(
      "model_level.slcs", "60E1", places, [](double x) { return x > 280.0 ? 1.0 : 0.0; }, 0.0,
      cosine);
  for (const Solved& each : {all_solved[2], all_solved[3]})
    for (const double lateral : {0.0, 6.0}) {
      const auto scene_on_rail = [&](const std::string& rail) {
        Scene scene = each.of(scene_on(rail));
        scene.side = SideChoice::left;
        scene.track.inclination = 0.0;
        scene.left.rail.options.rail_origin = scene.right.rail.options.rail_origin = 753.0;
        scene.roll = 0.0;
        scene.lateral = lateral;
        scene.yaw = scene.along = scene.pitch = 0.0;
        scene.motion.reset();
        return scene;
      };
      const SceneResult up = solve_scene(scene_on_rail(rising));
      Scene on_level = scene_on_rail(level);
      on_level.left.load /= cosine;
      const SceneResult flat = solve_scene(on_level);
      EXPECT_NEAR(up.left->pmax, flat.left->pmax, 2e-3 * flat.left->pmax)
          << each.name << ' ' << lateral;
      EXPECT_LT(norm(up.left->force - tilted(flat.left->force, std::atan(slope))),
                2e-3 * on_level.left.load)
          << each.name << ' ' << lateral;
    }
}

/// Derivatives of vertical gaps, against differences at a prescribed position.
TEST_F(VaryingScene, VerticalGapsHaveDerivatives) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = wavy_rail();
  scene.side = SideChoice::left;
  scene.gap = GapConvention::vertical;
  scene.roll = 0.0;
  scene.along = 12.0;
  scene.accuracy_of = AccuracyOf::forces;
  SceneSolver solver;
  scene.vertical = solver.solve(scene).left->details.vertical;
  SceneResult result = solver.solve(scene);
  ASSERT_NE(result.left->sensitivities(), nullptr);
  const double rate = result.left->sensitivities()->by_pressures.vertical.force.z;
  constexpr double step = 2e-3;
  const auto force_at = [&](double by) {
    Scene moved = scene;
    *moved.vertical += by;
    return solver.solve(moved).left->force.z;
  };
  EXPECT_NEAR(rate, (force_at(step) - force_at(-step)) / (2.0 * step), 1e-2 * std::abs(rate));
}

/// At a prescribed position, where the rail's wave rises.
TEST_F(VaryingScene, ForcesHaveDerivativesAlongTheTrackAndBesidesToo) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = wavy_rail();
  scene.side = SideChoice::left;
  scene.roll = 0.0;
  scene.along = 12.0;
  scene.accuracy_of = AccuracyOf::forces;
  scene.derivatives = true;
  SceneSolver solver;
  scene.vertical = solver.solve(scene).left->details.vertical;
  SceneResult result = solver.solve(scene);
  auto forces = wheel_forces(result, scene.convention, true);
  add_varying_columns(scene, solver, forces);
  const auto force_at = [&](double Scene::*place, double step) {
    Scene moved = scene;
    moved.*place += step;
    SceneResult there = solver.solve(moved);
    return wheel_forces(there, scene.convention, false)[0].force;
  };
  constexpr double step = 2e-3;
  for (const auto& [place, column] : {std::pair(&Scene::along, 0U), {&Scene::lateral, 1U}}) {
    const SixNumbers ahead = force_at(place, step);
    const SixNumbers behind = force_at(place, -step);
    const SixNumbers& found = forces[0].by_position[column];
    for (std::size_t row = 0; row < 3; ++row)
      EXPECT_NEAR(found[row], (ahead[row] - behind[row]) / (2.0 * step),
                  1e-2 * std::abs(forces[0].by_position[2][2]) * (column == 0U ? 0.01 : 0.1))
          << column << ' ' << row;
  }
  EXPECT_NE(forces[0].by_position[0][2], 0.0);
  EXPECT_EQ(forces[0].by_position[4], SixNumbers{});
  scene.along = 120.0; // the last slice: from one side
  forces[0].by_position[0] = {};
  add_varying_columns(scene, solver, forces);
  EXPECT_NE(forces[0].by_position[0][2], 0.0);
}

} // namespace
} // namespace wrc::test::varying_scene_test
