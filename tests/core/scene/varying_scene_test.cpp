/// Scenes with lists of slices: equal slices, sides, threads, what was solved before, and places.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "creep/rolling_frame.hpp"
#include "geometry/varying_shapes.hpp"
#include "profile/standard_profiles.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/solve_scene.hpp"
#include "scene/vehicle_step.hpp"
#include "support/errors.hpp"

namespace wrc::test::varying_scene_test {
namespace {

class VaryingScene : public ::testing::Test {
protected:
  VaryingScene()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ("wrcontact_varying_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~VaryingScene() override { std::filesystem::remove_all(folder_); }

  /// A list of a built-in profile, raised by a height at each place; places are moved and heights
  /// of the profile multiplied.
  [[nodiscard]] std::string list(const std::string& name, const std::string& profile,
                                 const std::vector<double>& places,
                                 const std::function<double(double)>& height, double moved = 0.0,
                                 double flattened = 1.0) const {
    const Curve curve = standard_profile(profile).curve;
    std::ofstream list(folder_ / name);
    list.precision(17);
    list << moved << " 1.0\n" << places.size() << "\n0 0 0\n1\n";
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::string slice = name + "_" + std::to_string(i) + ".txt";
      list << places[i] << " '" << slice << "'\n";
      std::ofstream file(folder_ / slice);
      file.precision(17);
      const int count = static_cast<int>(curve.length() / 0.5);
      for (int k = 0; k <= count; ++k) {
        const CurvePoint point = curve.at(curve.length() * k / count);
        file << point.lateral << ' ' << flattened * point.height + height(places[i]) << '\n';
      }
    }
    return folder_ / name;
  }
  [[nodiscard]] std::string wavy_rail(double moved = 0.0) const {
    return list(
        "wave" + std::to_string(moved) + ".slcs", "60E1", places_every(-120.0, 120.0, 4.0),
        [](double x) { return 0.05 * std::cos(2.0 * std::numbers::pi * x / 50.0); }, moved);
  }
  [[nodiscard]] std::string wheel_with_flat() const {
    return list("flat.slcw", "S1002", places_every(-0.2, 0.2, 0.01),
                [](double theta) { return -rounded_depth(theta, 0.6, 0.06); });
  }
  /// A flat with sharp ends.
  [[nodiscard]] std::string wheel_with_chord() const {
    return list("chord.slcw", "S1002", places_every(-0.1, 0.1, 0.004),
                [](double theta) { return -chord_depth(theta, 460.0, 57.0); });
  }

  /// A 60E1 that is absent between -half and half.
  [[nodiscard]] std::string rail_with_gap(const std::string& name, double half) const {
    const std::vector<double> places{-300.0, -half, 0.0, half, 300.0};
    std::ostringstream features;
    for (const double place : places)
      features << place << (place == 0.0 ? " -1 -1\n" : " 0 999\n");
    return with_features(list(name, "60E1", places, [](double) { return 0.0; }), "2",
                         features.str());
  }

  /// A list with lines of features at its end.
  static std::string with_features(const std::string& path, const std::string& count,
                                   const std::string& lines) {
    std::ifstream file(path);
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    text.replace(text.find("0 0 0\n"), 1, count);
    std::ofstream(path) << text << lines;
    return path;
  }

private:
  std::filesystem::path folder_;
};

Scene scene_on(const std::string& rail, const std::string& wheel = "S1002") {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = rail;
  scene.left.wheel.name = scene.right.wheel.name = wheel;
  for (SceneSide* side : {&scene.left, &scene.right})
    side->rail.smoothing = side->wheel.smoothing = 0.0;
  scene.lateral = 1.5;
  scene.yaw = 0.003;
  scene.along = 7.0;
  scene.pitch = 0.03;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  scene.motion = Motion{.speed = 20000.0, .lateral = 10.0};
  return scene;
}

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
      scene.track.cant = 0.0;
      scene.roll = 0.0;
      scene.track.origin = 753.0;
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
        scene.track.cant = 0.0;
        scene.track.origin = 753.0;
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

/// p^2 bends within an element of the edge there, by which the elements' number alone does not go.
TEST_F(VaryingScene, CreepForcesAtTheEndsOfAFlatStateTheirError) {
  Scene scene = scene_on("60E1", wheel_with_chord());
  scene.side = SideChoice::left;
  SceneSolver solver;
  const auto forces_at = [&](double accuracy) {
    scene.accuracy = accuracy;
    SceneResult result = solver.solve(scene);
    const auto value = [&](const char* name) { return *number_value(result, name); };
    return std::array{value("left.patches.0.creep_force.longitudinal"),
                      value("left.patches.0.creep_force.lateral"),
                      value("left.patches.0.normal_force"),
                      value("left.patches.0.creep_error_estimate")};
  };
  double worst = 0.0;
  for (const double pitch : {0.01, 0.02, 0.03, 0.04}) {
    scene.pitch = pitch;
    const auto truth = forces_at(5e-4);
    const auto found = forces_at(1e-2);
    const double error = std::hypot(found[0] - truth[0], found[1] - truth[1]) / (0.3 * truth[2]);
    EXPECT_LE(error, found[3]) << pitch;
    worst = std::max(worst, error);
  }
  EXPECT_GT(worst, 1e-2); // so the scenes are among those that need it
}

/// A crest along the rail, for which a second grid has more columns; without them pmax is 5.2 % too
/// large.
TEST_F(VaryingScene, TheLargestPressureAtTheEndsOfAFlatMeetsTheAccuracy) {
  Scene scene = scene_on("60E1", wheel_with_chord());
  scene.side = SideChoice::left;
  scene.accuracy_of = AccuracyOf::pressures;
  scene.motion.reset();
  scene.pitch = 0.01;
  SceneSolver solver;
  const auto pmax_at = [&](double accuracy) {
    scene.accuracy = accuracy;
    SceneResult result = solver.solve(scene);
    return *number_value(result, "left.pmax");
  };
  const double truth = pmax_at(1e-3);
  EXPECT_NEAR(pmax_at(1e-2), truth, 1e-2 * truth);
}

TEST_F(VaryingScene, RefusesPlacesWithoutARail) {
  Scene scene = scene_on(wavy_rail());
  scene.along = 121.0;
  expect_error(
      ErrorCode::no_contact, [&] { (void)solve_scene(scene); }, "121");
  scene.along = 119.0; // the rail ends 1 mm ahead
  EXPECT_NO_THROW((void)solve_scene(scene));
}

Scene level_on(const std::string& rail) {
  Scene scene = scene_on(rail);
  scene.lateral = scene.yaw = scene.along = 0.0;
  scene.roll = 0.0;
  return scene;
}

/// It sinks by half^2 / (2 r) between the ends.
TEST_F(VaryingScene, AWheelStandsOnBothEndsOfAShortGap) {
  const double half = 2.0;
  Scene scene = level_on("60E1");
  const double whole = solve_scene(scene).vertical;
  const std::string rail = rail_with_gap("gap.slcs", half);
  scene.left.rail.name = scene.right.rail.name = rail;
  const SceneResult over = solve_scene(scene);
  EXPECT_NEAR(whole - over.vertical, half * half / 920.0, 2e-4);
  EXPECT_NEAR(over.left->force.z, scene.left.load, 1e-3 * scene.left.load);
  EXPECT_TRUE(over.left->meets_part_end);
  for (const PatchResult& patch : over.left->patches) { // one, of both ends
    EXPECT_NEAR(patch.centroid.y, 750.0, 10.0);
    EXPECT_NEAR(patch.reference.y, 750.0, 10.0);
    EXPECT_NEAR(patch.reference.z, 0.0, 1.0);
  }
  scene.left.rail.name = "60E1"; // the other way around
  EXPECT_NO_THROW((void)solve_scene(scene));
}

TEST_F(VaryingScene, AWideGapStopsItsOwnWheelOnly) {
  Scene scene = level_on("60E1");
  scene.left.rail.name = rail_with_gap("wide.slcs", 150.0);
  expect_error(
      ErrorCode::no_contact, [&] { (void)solve_scene(scene); },
      "the wheel is over a gap of the rail at 0 mm along it: the nearest part is 150 mm away");
  scene.side = SideChoice::right;
  EXPECT_TRUE(solve_scene(scene).right);
  scene.along = 400.0; // where the left rail has no slices
  EXPECT_TRUE(solve_scene(scene).right);
  scene.side = SideChoice::left;
  expect_error(
      ErrorCode::no_contact, [&] { (void)solve_scene(scene); }, "400");
}

TEST_F(VaryingScene, SwingsBetweenSlicesAreWarnings) {
  const auto warnings_on = [](const std::string& rail) {
    Scene scene = level_on(rail);
    scene.until = Module::geometry;
    return all_warnings(solve_scene(scene));
  };
  const Warnings swings =
      warnings_on(list("joint.slcs", "60E1", {-300.0, -100.0, -0.5, 0.5, 100.0, 300.0},
                       [](double x) { return x < 0.0 ? 0.0 : 0.3; }));
  ASSERT_EQ(swings.size(), 2U);
  EXPECT_EQ(swings[0].kind, WarningClass::profile_swing);
  EXPECT_NE(swings[0].text.find("between slices 2 and 3 the rail is"), std::string::npos);
  EXPECT_NE(swings[1].text.find("steeper than 1:5"), std::string::npos);
  EXPECT_TRUE(warnings_on(wavy_rail()).empty());
}

TEST_F(VaryingScene, RefusesWhatSlicesAndWavesCannotHave) {
  Scene scene;
  const auto solve = [&scene] { (void)solve_scene(scene); };
  scene.left.rail.name = wavy_rail();
  VehicleState state;
  state.velocity = SixNumbers{1e4};
  state.history = std::make_shared<const ContactHistory>();
  state.time_step = 1e-3;
  expect_error(
      ErrorCode::invalid_argument, [&] { (void)scene_at(scene, state); }, "history", "varies");
  scene = Scene();
  scene.left.wheel.name = wavy_rail();
  expect_error(ErrorCode::invalid_argument, solve, "those of a wheel");
  scene = Scene();
  scene.left.wheel.name = scene.right.wheel.name = wheel_with_flat();
  scene.wheel_placement.lateral_shift = 1.0;
  expect_error(ErrorCode::invalid_argument, solve, "profile_shift");
  scene = Scene();
  scene.left.wheel.harmonics = {{700, 0.02, 0.0}};
  expect_error(ErrorCode::invalid_argument, solve, "wheelset.harmonics = 700", "12 mm");
  scene.left.wheel.harmonics = {{10, 20.0, 0.0}};
  expect_error(ErrorCode::invalid_argument, solve, "wheelset.harmonics = 20", "slopes");
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
