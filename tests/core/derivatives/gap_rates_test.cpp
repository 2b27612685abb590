/// Rates of the undeformed distance against central differences of the sampled distance, and in
/// closed form for a cylinder.
#include "derivatives/gap_rates.hpp"

#include <array>
#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "geometry/wheelset_equilibrium.hpp"
#include "patches/plane_area.hpp"
#include "profile/standard_profiles.hpp"
#include "remesh/undeformed_distance.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::gap_rates_test {
namespace {

constexpr double wheel_radius = 460.0;
/// Rays are met to 3e-13 mm and distances rounded to 1e-13 mm, over a step of 2e-5 mm; the largest
/// difference seen is 9e-9.
constexpr double step = 1e-5;
constexpr double difference_tolerance = 4e-8;
/// Distance of the wheelset's centre from the contact, mm: a turn moves it by so much more.
constexpr double arm = 750.0;

struct Case {
  double lateral;
  double yaw;
  double roll;
  GapConvention gap;
  const char* rail = "60E1";
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.rail << ", y " << c.lateral << ", yaw " << c.yaw << ", roll " << c.roll;
}

std::array<RigidMotion, 4> all_motions(const Pose& pose) {
  return {lateral_motion(), vertical_motion(), roll_motion(pose.yaw), {{}, {0.0, 0.0, 1.0}}};
}

class GapRates : public testing::TestWithParam<Case> {};

TEST_P(GapRates, AreThoseOfCentralDifferences) {
  const Case& c = GetParam();
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(standard_profile(c.rail), {1435.0, 14.0, std::atan(0.025)});
  EquilibriumRequest request;
  request.lateral = c.lateral;
  request.yaw = c.yaw;
  request.roll = c.roll;
  request.right = false;
  const auto equilibrium = find_equilibrium({wheel, rail}, {wheel, rail}, request);
  const auto& contact = equilibrium.left->scan.candidates.front();
  const double vertical = equilibrium.left->vertical - 0.08;
  const PosedPair posed{wheel, rail, equilibrium.left->pose, vertical};
  const Vector3 place = contact.wheel.position;
  const Vector3 origin{place.x, place.y, rail.graph().at_lateral(place.y).height};
  const ContactFrame frame = c.gap == GapConvention::vertical
                                 ? vertical_frame(origin, Rotation(posed.pose))
                                 : tangent_frame(origin, contact.rail_angle);
  const Grid grid = grid_over({-4.0, 4.0, -7.0, 7.0}, 23, 17);
  const auto motions = all_motions(posed.pose);
  std::vector<std::vector<double>> rates;
  compute_gap_rates(posed, frame, grid, {}, motions, rates);
  ASSERT_EQ(rates.size(), motions.size());

  const auto moved = [&](std::size_t motion, double by) {
    Pose pose = posed.pose;
    double height = vertical;
    (motion == 0 ? pose.lateral : motion == 1 ? height : motion == 2 ? pose.roll : pose.yaw) += by;
    return sample_undeformed_distance({wheel, rail, pose, height}, frame, grid);
  };
  for (std::size_t motion = 0; motion < motions.size(); ++motion) {
    const double unit = motion < 2 ? 1.0 : arm;
    const auto ahead = moved(motion, step / unit);
    const auto behind = moved(motion, -step / unit);
    double worst = 0.0;
    for (std::size_t i = 0; i < grid.element_count(); ++i) {
      ASSERT_LT(ahead[i], no_material_distance);
      worst =
          std::max(worst, std::abs(rates[motion][i] / unit - (ahead[i] - behind[i]) / 2 / step));
    }
    EXPECT_LE(worst, difference_tolerance) << "motion " << motion;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Poses, GapRates,
    testing::Values(Case{0.0, 0.0, 0.0, GapConvention::vertical},
                    Case{3.0, 0.0, 2e-3, GapConvention::vertical},
                    Case{3.0, 0.04, -2e-3, GapConvention::vertical},
                    Case{0.0, 0.0, 0.0, GapConvention::tangent},
                    Case{-4.0, 0.0, 3e-3, GapConvention::tangent},
                    Case{5.0, -0.05, 4e-4, GapConvention::tangent},
                    Case{5.5, 0.0, 4e-4, GapConvention::tangent},
                    Case{2.0, 0.02, 1e-3, GapConvention::tangent, "UIC60-Manchester"},
                    Case{6.5, 0.01, 1e-3, GapConvention::tangent, "UIC60-Manchester"},
                    Case{7.0, 0.0, 1e-3, GapConvention::tangent}));

TEST(GapRatesOfACylinder, InClosedForm) {
  // The wheel's height over x is z - sqrt(r^2 - x^2) whatever y: lowering it changes the distance
  // by one, shifting it along its axis by nothing; a roll lifts a place by its distance from the
  // centre along the axis.
  const WheelSurface wheel(cylindrical_wheel(), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(circular_rail(300.0), {1435.0, 14.0, 0.0});
  const double rail_axis = 717.5 + 35.0;
  const PosedPair posed{wheel, rail, {}, wheel_radius};
  const ContactFrame frame = tangent_frame({0.0, rail_axis, 0.0}, 0.0);
  const Grid grid = grid_over({-8.0, 8.0, -9.0, 9.0}, 7, 10);
  const auto motions = all_motions(posed.pose);
  std::vector<std::vector<double>> rates;
  compute_gap_rates(posed, frame, grid, {}, motions, rates);
  constexpr double rounding = 1e-12;
  for (std::size_t i = 0; i < grid.element_count(); ++i) {
    const double y = rail_axis + grid.lateral(i / grid.longitudinal_count);
    EXPECT_NEAR(rates[0][i], 0.0, rounding);
    EXPECT_NEAR(rates[1][i], 1.0, rounding);
    EXPECT_NEAR(rates[2][i], y, rounding * y);
  }
}

TEST(GapRatesOfElements, OnlySelectedElementsAreComputed) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, std::atan(0.025)});
  const PosedPair posed{wheel, rail, {0.5, 0.01, 1e-4}, wheel_radius};
  const ContactFrame frame =
      tangent_frame({0.0, 750.0, rail.graph().at_lateral(750.0).height}, 0.03);
  const Grid grid = grid_over({-4.0, 4.0, -7.0, 7.0}, 12, 15);
  std::vector<double> wanted(grid.element_count(), 0.0);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = i % 7 < 3 && i > 30 && i / 15 != 8 ? 2.5 : 0.0;
  }
  const auto motions = all_motions(posed.pose);
  std::vector<std::vector<double>> all;
  std::vector<std::vector<double>> some(9, std::vector<double>(3, 1.0)); // of an earlier call
  compute_gap_rates(posed, frame, grid, {}, motions, all);
  compute_gap_rates(posed, frame, grid, wanted, motions, some);
  for (std::size_t motion = 0; motion < motions.size(); ++motion) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double expected = wanted[i] > 0.0 ? all[motion][i] : 0.0;
      EXPECT_NEAR(some[motion][i], expected, 1e-12 * arm);
    }
  }
}

TEST(GapRatesOfElements, AreZeroWhereThereIsNoWheel) {
  const WheelSurface wheel(cylindrical_wheel(), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(circular_rail(300.0), {1435.0, 14.0, 0.0});
  const PosedPair posed{wheel, rail, {}, wheel_radius};
  const ContactFrame frame = tangent_frame({0.0, 752.5, 0.0}, 0.0);
  const Grid grid = grid_over({-10.0, 10.0, -500.0, 500.0}, 3, 20);
  std::vector<std::vector<double>> rates;
  const std::array<RigidMotion, 1> down{vertical_motion()};
  compute_gap_rates(posed, frame, grid, {}, down, rates);
  for (std::size_t i = 0; i < grid.element_count(); ++i) {
    const bool beyond = std::abs(grid.longitudinal(i % 20)) > wheel_radius;
    EXPECT_NEAR(rates[0][i], beyond ? 0.0 : 1.0, 1e-12);
  }
}

} // namespace
} // namespace wrc::test::gap_rates_test
