/// Rates of the wheel's forces against central differences of the whole way on fixed planes and
/// grids: the distance sampled anew at the moved position, and the contact problem solved anew.
#include "derivatives/patch_rates.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "creep/rolling_frame.hpp"
#include "half_space/material.hpp"
#include "mechanics/normal_solver.hpp"
#include "profile/standard_profiles.hpp"
#include "remesh/undeformed_distance.hpp"
#include "support/patch_problem.hpp"
#include "wheel/solve_wheel.hpp"

namespace wrc::test::patch_rates_test {
namespace {

const double modulus = combined_modulus({210000.0, 0.3}, {210000.0, 0.3});
constexpr double wheel_load = 80000.0;

/// Pressures are solved to 1e-11 and change by 1e-5 over a step, which is so small that no element
/// joins or leaves. The largest difference seen is 1.2e-7 of the largest entry.
constexpr double solver_tolerance = 1e-11;
constexpr double step = 5e-7;
constexpr double difference_tolerance = 1e-6;
/// Distance of the wheelset's centre from the contact, mm: a turn moves it by so much more.
constexpr double arm = 750.0;

struct Case {
  const char* name;
  const char* rail;
  double lateral;
  double yaw = 0.0;
  double roll = 0.0;
  GapConvention gap = GapConvention::tangent;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

/// Position of the wheelset, and the force of the rail on the wheel as a function of it.
class Side {
public:
  Side(const char* rail, const Pose& at)
      : wheel_(standard_profile("S1002"), {1360.0, 70.0, 460.0}),
        rail_(standard_profile(rail), {1435.0, 14.0, std::atan(0.025)}), pose(at) {
    EquilibriumRequest request;
    request.lateral = at.lateral;
    request.yaw = at.yaw;
    request.roll = at.roll;
    request.right = false;
    request.near_tolerance = 1.0;
    equilibrium = *find_equilibrium({wheel_, rail_}, {wheel_, rail_}, request).left;
  }

  /// The patches under the load, in the planes that the solution takes.
  void press(GapConvention gap) {
    WheelRequest request;
    request.gap = gap;
    request.combined_modulus = modulus;
    request.vertical_load = wheel_load;
    request.grid = {{56, 40}};
    NormalSolver solver;
    const WheelSolution solution = solve_wheel(wheel_, rail_, equilibrium, request, solver);
    ASSERT_TRUE(solution.in_contact);
    vertical = solution.vertical;
    for (const Patch& patch : solution.patches) {
      patches.push_back({patch.frame, patch.grid, {}});
    }
    solve();
  }

  /// Patches at this depth in planes of their own, at all places where that touches.
  void lower(double depth) {
    vertical = equilibrium.vertical - depth;
    for (const ContactCandidate& place : equilibrium.scan.candidates) {
      if (place.distance + equilibrium.vertical < depth) {
        const Vector3 at = place.wheel.position;
        const Vector3 origin{at.x, at.y, rail_.graph().at_lateral(at.y).height};
        const double length = 1.2 * std::sqrt(2.0 * 460.0 * depth);
        patches.push_back({tangent_frame(origin, place.rail_angle),
                           grid_over({-3.0, 3.0, -length, length}, 60, 30),
                           {}});
      }
    }
    solve();
  }

  [[nodiscard]] PosedPair pair() const { return {wheel_, rail_, pose, vertical}; }

  /// Pressures at a position; patches stay where they are.
  [[nodiscard]] std::vector<std::vector<double>> pressures(const Pose& at, double height) const {
    static NormalSolver solver(PlannerRigor::estimate, Precision::double_only);
    std::vector<std::vector<double>> result;
    for (const LoadedPatch& patch : patches) {
      const auto distance =
          sample_undeformed_distance({wheel_, rail_, at, height}, patch.frame, patch.grid);
      PatchProblem problem(patch.grid, distance, modulus);
      problem.approach = 0.0;
      problem.tolerance = solver_tolerance;
      PatchSolution solution = solver.solve(problem);
      EXPECT_EQ(solution.stop_reason, StopReason::tolerance_met);
      result.push_back(std::move(solution.pressure));
    }
    return result;
  }

  /// Written out once more, element by element.
  [[nodiscard]] WheelForce force(const std::vector<std::vector<double>>& pressure, const Pose& at,
                                 double height) const {
    WheelForce sum;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const Grid& grid = patches[k].grid;
      const ContactFrame& frame = patches[k].frame;
      RailRay ray(rail_, frame);
      for (std::size_t i = 0; i < grid.element_count(); ++i) {
        if (!(pressure[k][i] > 0.0)) {
          continue;
        }
        const double along = grid.longitudinal(i % grid.longitudinal_count);
        const double across = grid.lateral(i / grid.longitudinal_count);
        const Vector3 place = frame.to_track(along, across, *ray.solve(along, across));
        const Vector3 normal = ray.line().normal().normal;
        const Vector3 f =
            (pressure[k][i] * grid.element_area() / dot(frame.normal, normal)) * normal;
        sum.force = sum.force + f;
        sum.moment = sum.moment + cross(place - Vector3{0.0, at.lateral, height}, f);
      }
    }
    return sum;
  }

  /// Central difference; `same` tells whether the elements in contact are the same.
  [[nodiscard]] WheelForce difference(std::size_t motion, bool& same) const {
    WheelForce forces[2];
    same = true;
    const double by = motion < 2 ? step : step / arm;
    for (const int end : {0, 1}) {
      Pose at = pose;
      double height = vertical;
      (motion == 0   ? at.lateral
       : motion == 1 ? height
       : motion == 2 ? at.roll
                     : at.yaw) += end == 0 ? -by : by;
      const auto pressure = pressures(at, height);
      for (std::size_t k = 0; k < pressure.size(); ++k) {
        for (std::size_t i = 0; i < pressure[k].size(); ++i) {
          same = same && (pressure[k][i] > 0.0) == (solved[k][i] > 0.0);
        }
      }
      forces[end] = force(pressure, at, height);
    }
    const double scale = 0.5 / by;
    return {scale * (forces[1].force - forces[0].force),
            scale * (forces[1].moment - forces[0].moment)};
  }

  [[nodiscard]] WheelSensitivity sensitivities(SensitivityRequest request = {}) const {
    static InfluenceCache cache;
    ContactStiffness stiffness(cache);
    request.combined_modulus = modulus;
    return compute_patch_rates(pair(), patches, request, stiffness);
  }

private:
  void solve() {
    solved = pressures(pose, vertical);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      patches[k].pressure = solved[k];
    }
  }

  WheelSurface wheel_;
  RailSurface rail_;

public:
  Pose pose;
  SideEquilibrium equilibrium;
  double vertical = 0.0;
  std::vector<LoadedPatch> patches;
  std::vector<std::vector<double>> solved;
};

const WheelForce& of_motion(const ForceRates& rates, std::size_t motion) {
  return motion == 0   ? rates.lateral
         : motion == 1 ? rates.vertical
         : motion == 2 ? rates.roll
                       : rates.yaw;
}

/// Of forces by distance: turns and moments over the arm.
double difference_of(const WheelForce& a, const WheelForce& b, std::size_t motion) {
  const Vector3 apart = a.force - b.force;
  const Vector3 turning = (1.0 / arm) * (a.moment - b.moment);
  const double unit = motion < 2 ? 1.0 : arm;
  return std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z), std::abs(turning.x),
                   std::abs(turning.y), std::abs(turning.z)}) /
         unit;
}

double largest_entry(const ForceRates& rates) {
  double largest = 0.0;
  for (std::size_t motion = 0; motion < 4; ++motion) {
    largest = std::max(largest, difference_of(of_motion(rates, motion), {}, motion));
  }
  return largest;
}

void expect_differences(const Side& side, const char* name) {
  const WheelSensitivity found = side.sensitivities();
  EXPECT_EQ(found.stop_reason, StopReason::tolerance_met);
  const WheelForce force = side.force(side.solved, side.pose, side.vertical);
  EXPECT_LE(difference_of(found.force, force, 0), 1e-11 * wheel_load);
  for (std::size_t motion = 0; motion < 4; ++motion) {
    bool same = false;
    const WheelForce expected = side.difference(motion, same);
    EXPECT_TRUE(same) << "elements in contact change: choose another grid";
    const double error = difference_of(of_motion(found.force_rates, motion), expected, motion) /
                         largest_entry(found.force_rates);
    EXPECT_LE(error, difference_tolerance) << name << ", motion " << motion;
  }
}

class Sensitivities : public testing::TestWithParam<Case> {};

TEST_P(Sensitivities, AreThoseOfCentralDifferences) {
  const Case& c = GetParam();
  Side side(c.rail, {c.lateral, c.yaw, c.roll});
  side.press(c.gap);
  expect_differences(side, c.name);
}

INSTANTIATE_TEST_SUITE_P(
    Positions, Sensitivities,
    testing::Values(Case{"middle", "60E1", 0.0}, Case{"outwards", "60E1", -3.0, 0.0, 1e-3},
                    Case{"two lobes", "60E1", 3.0}, Case{"rolled", "60E1", 4.5, 0.0, 2e-3},
                    Case{"flange root", "60E1", 5.6}, Case{"flange", "60E1", 6.8, 0.0, 1e-3},
                    Case{"yawed", "60E1", 1.0, 0.02}, Case{"yawed flange", "60E1", 6.5, 0.03, 1e-3},
                    Case{"vertical gaps", "60E1", 2.0, 0.02, 2e-3, GapConvention::vertical},
                    Case{"Manchester", "UIC60-Manchester", 0.2},
                    Case{"Manchester outwards", "UIC60-Manchester", -5.0},
                    Case{"Manchester inwards", "UIC60-Manchester", 3.0, 0.0, -1e-3},
                    Case{"Manchester two lobes", "UIC60-Manchester", 5.0, 0.0, 4e-4},
                    Case{"Manchester flange", "UIC60-Manchester", 6.61, -0.01, 1e-3}),
    [](const testing::TestParamInfo<Case>& tested) {
      std::string name = tested.param.name;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

/// Does nothing: only the way of the solution is that of patches that interact.
class NoInfluence : public PatchInfluence {
public:
  void add(std::span<const std::vector<double>> /*pressure*/,
           std::span<std::vector<double>> /*displacement*/) override {}
};

void expect_same(const ForceRates& a, const ForceRates& b, double tolerance) {
  for (std::size_t motion = 0; motion < 4; ++motion) {
    EXPECT_LE(difference_of(of_motion(a, motion), of_motion(b, motion), motion),
              tolerance * largest_entry(b))
        << motion;
  }
}

TEST(SensitivitiesOfPatches, AgreeWithDifferencesForSeveralPlanes) {
  Side side("60E1", {6.0, 0.02, 1e-3}); // the root of the flange, and its face
  side.lower(0.14);
  ASSERT_GE(side.patches.size(), 2u);
  expect_differences(side, "patches");

  const WheelSensitivity by_force = side.sensitivities();
  ASSERT_EQ(by_force.patches.size(), side.patches.size());
  ForceRates sum;
  for (const PatchSensitivity& patch : by_force.patches) {
    sum = sum + patch.force_rates;
    EXPECT_GT(patch.normal_force, 0.0);
    EXPECT_LT(patch.normal_force_rates.vertical, 0.0);
  }
  expect_same(sum, by_force.force_rates, 1e-14);

  NoInfluence influence;
  SensitivityRequest request;
  request.influence = &influence;
  const WheelSensitivity by_motion = side.sensitivities(request);
  expect_same(by_motion.force_rates, by_force.force_rates, 1e-7);
}

TEST(SensitivitiesOfPatches, AreAbsentWithoutContact) {
  Side side("60E1", {1.0, 0.0, 0.0});
  side.press(GapConvention::tangent);
  std::vector<double> nothing(side.solved[0].size(), 0.0);
  side.patches[0].pressure = nothing;
  const WheelSensitivity found = side.sensitivities();
  EXPECT_EQ(largest_entry(found.force_rates), 0.0);
  EXPECT_FALSE(condense_at_vertical_load(found.force_rates));
  InfluenceCache cache;
  ContactStiffness stiffness(cache);
  EXPECT_THROW(compute_patch_rates(side.pair(), {}, {modulus}, stiffness), Error);
  EXPECT_THROW(compute_patch_rates(side.pair(), side.patches, {}, stiffness), Error);
}

/// What a turning plane changes, against differences on grids that turn with it.
TEST(SensitivitiesOfPatches, TurningPlanes) {
  Side side("60E1", {5.6, 0.0, 0.0});
  side.press(GapConvention::tangent);
  const auto with_angle = [&](double turn) {
    Side turned = side;
    LoadedPatch& patch = turned.patches[0];
    patch.frame = tangent_frame(patch.frame.origin, patch.frame.angle() + turn);
    const auto pressure = turned.pressures(side.pose, side.vertical);
    return turned.force(pressure, side.pose, side.vertical);
  };
  constexpr double by = 2e-6;
  const WheelForce ahead = with_angle(by);
  const WheelForce behind = with_angle(-by);
  const WheelForce expected{(0.5 / by) * (ahead.force - behind.force),
                            (0.5 / by) * (ahead.moment - behind.moment)};
  const ForceRates still = side.sensitivities().force_rates;
  const std::vector<double> distance =
      sample_undeformed_distance(side.pair(), side.patches[0].frame, side.patches[0].grid);
  side.patches[0].angle_rates.lateral = 1.0;
  side.patches[0].grid_motion.emplace(); // elements stay in the plane
  side.patches[0].undeformed_distance = distance;
  const ForceRates found = side.sensitivities().force_rates;
  const WheelForce turning = found.lateral + -1.0 * still.lateral;
  // By differences over rows; small, since directions of planes hardly count.
  EXPECT_LT(difference_of(turning, expected, 0), 0.03 * wheel_load);
  EXPECT_LT(difference_of(expected, {}, 0), 0.3 * wheel_load);
}

/// Of any rates pairs become equal, and what the height does and what is left at constant load
/// stays.
TEST(SensitivitiesOfPatches, AreMadeSymmetricByTheLawsOfEnergy) {
  const ForceRates before{{{0.0, -3.0, 1.0}, {-700.0, 1.0, 40.0}},
                          {{0.0, 1.1, -9.0}, {-6800.0, 2.0, 11.0}},
                          {{0.0, -690.0, -6700.0}, {-5.6e6, 8.0, 60.0}},
                          {{0.0, 41.0, 10.0}, {70.0, 9.0, -50.0}}};
  const Pose pose{1.0, 0.02, 0.003};
  const WheelForce force{{0.0, -8e3, 8e4}, {-6e7, 1e5, 2e5}};
  ForceRates rates = before;
  make_symmetric(rates, force, pose);
  const Vector3 axis{std::cos(pose.yaw), std::sin(pose.yaw), 0.0};
  const Vector3 by_yaw{-axis.y, axis.x, 0.0};
  const auto rolling = [&](const WheelForce& rate) { return dot(rate.moment, axis); };
  EXPECT_NEAR(rates.lateral.force.z, rates.vertical.force.y, 1e-9);
  EXPECT_NEAR(rolling(rates.lateral), rates.roll.force.y, 1e-6);
  EXPECT_NEAR(rolling(rates.vertical), rates.roll.force.z, 1e-6);
  EXPECT_NEAR(rates.lateral.moment.z, rates.yaw.force.y, 1e-9);
  EXPECT_NEAR(rates.vertical.moment.z, rates.yaw.force.z, 1e-9);
  EXPECT_NEAR(rolling(rates.yaw) + dot(force.moment, by_yaw), rates.roll.moment.z, 1e-3);
  expect_same({rates.vertical, rates.vertical, rates.vertical, rates.vertical},
              {before.vertical, before.vertical, before.vertical, before.vertical}, 1e-12);
  EXPECT_NEAR(condense_at_vertical_load(rates)->lateral.wheel.force.y,
              condense_at_vertical_load(before)->lateral.wheel.force.y, 1e-9);
  // No moment about the axle comes or goes.
  const Vector3 axle = Rotation(pose).to_track({0.0, 1.0, 0.0});
  EXPECT_NEAR(dot(rates.roll.moment - before.roll.moment, axle), 0.0, 1e-3);
}

TEST(SensitivitiesAtConstantLoad, HeightFollows) {
  Side side("60E1", {5.0, 0.0, 5e-4});
  side.press(GapConvention::tangent);
  const WheelSensitivity found = side.sensitivities();
  const auto condensed = condense_at_vertical_load(found.force_rates);
  ASSERT_TRUE(condensed);
  for (const bool turns : {false, true}) {
    const CondensedRates::Motion& motion = turns ? condensed->roll : condensed->lateral;
    const double by = turns ? step / arm : step;
    WheelForce forces[2];
    for (const int end : {0, 1}) {
      const double sign = end == 0 ? -1.0 : 1.0;
      Pose at = side.pose;
      (turns ? at.roll : at.lateral) += sign * by;
      const double height = side.vertical + sign * by * motion.vertical;
      forces[end] = side.force(side.pressures(at, height), at, height);
    }
    const Vector3 rate = (0.5 / by) * (forces[1].force - forces[0].force);
    const Vector3 moment = (0.5 / by) * (forces[1].moment - forces[0].moment);
    const double tolerance = difference_tolerance * largest_entry(found.force_rates);
    const double unit = turns ? arm : 1.0;
    EXPECT_EQ(motion.wheel.force.z, 0.0);
    EXPECT_NEAR(rate.z / unit, 0.0, tolerance);
    EXPECT_NEAR(rate.y / unit, motion.wheel.force.y / unit, tolerance);
    EXPECT_NEAR(moment.x / unit / arm, motion.wheel.moment.x / unit / arm, tolerance);
  }
}

TEST(SensitivitiesOfTheRightSide, AreThoseOfTheMirror) {
  // The right wheel of a pose is the left one of the mirrored pose.
  const Pose pose{-4.0, -0.015, -1e-3};
  Side side("60E1", mirrored(pose));
  side.press(GapConvention::tangent);
  const ForceRates found = RollingFrame(-1.0).mirrored(side.sensitivities().force_rates);
  const auto force_at = [&](const Pose& at, double height) {
    const WheelForce left = side.force(side.pressures(mirrored(at), height), mirrored(at), height);
    // Moments about axes in the mirror's plane turn the other way in it.
    return WheelForce{{left.force.x, -left.force.y, left.force.z},
                      {-left.moment.x, left.moment.y, -left.moment.z}};
  };
  for (std::size_t motion = 0; motion < 4; ++motion) {
    const double by = motion < 2 ? step : step / arm;
    const auto moved = [&](double sign) {
      Pose at = pose;
      double height = side.vertical;
      (motion == 0   ? at.lateral
       : motion == 1 ? height
       : motion == 2 ? at.roll
                     : at.yaw) += sign * by;
      return force_at(at, height);
    };
    const WheelForce ahead = moved(1.0);
    const WheelForce behind = moved(-1.0);
    const WheelForce expected{(0.5 / by) * (ahead.force - behind.force),
                              (0.5 / by) * (ahead.moment - behind.moment)};
    EXPECT_LE(difference_of(of_motion(found, motion), expected, motion),
              difference_tolerance * largest_entry(found));
  }
  expect_same(RollingFrame(-1.0).mirrored(found), side.sensitivities().force_rates, 0.0);
}

} // namespace
} // namespace wrc::test::patch_rates_test
