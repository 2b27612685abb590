/// Rates of the contact planes against central differences of the patches found at moved poses.
#include "derivatives/plane_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "geometry/contact_search.hpp"
#include "profile/standard_profiles.hpp"

namespace wrc::test::plane_rates_test {
namespace {

/// The nearer difference counts: a curvature of a profile may jump within the longer step, and the
/// rounding of places shows in the shorter one.
constexpr std::array<double, 2> steps{2e-6, 1e-5}; // mm
/// Distance of the wheelset's centre from the contact, mm: a turn moves it by so much more.
constexpr double arm = 750.0;
/// What differences of this step leave, of the largest rate.
constexpr double difference_tolerance = 1e-5;

struct Case {
  const char* name;
  const char* wheel;
  const char* rail;
  double lateral;
  double depth;
  double yaw = 0.0;
  double roll = 0.0;
  double joining_distance = 0.0;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class PlaneRatesOf : public testing::TestWithParam<Case> {};

TEST_P(PlaneRatesOf, AreThoseOfCentralDifferences) {
  const Case& c = GetParam();
  const double back_to_back = std::string(c.wheel) == "S1002" ? 1360.0 : 1353.0;
  const WheelSurface wheel(standard_profile(c.wheel), {back_to_back, 70.0, 460.0});
  const RailSurface rail(standard_profile(c.rail), {1435.0, 14.0, std::atan(0.025)});
  const Pose pose{c.lateral, c.yaw, c.roll};
  const ContactScan scan = search_contacts(wheel, rail, pose, 0.0);
  const double height = -scan.candidates.front().distance - c.depth;
  const MovingPatches moving =
      find_moving_patches(wheel, rail, pose, scan, c.depth, {c.joining_distance});
  const ContactPatches plain = find_contact_patches(scan, c.depth, {c.joining_distance});
  ASSERT_EQ(moving.found.patches.size(), plain.patches.size());
  ASSERT_EQ(moving.rates.size(), plain.patches.size());
  for (std::size_t k = 0; k < plain.patches.size(); ++k) {
    EXPECT_EQ(moving.found.patches[k].angle, plain.patches[k].angle);
    EXPECT_EQ(moving.found.patches[k].mean_y, plain.patches[k].mean_y);
    EXPECT_EQ(moving.found.patches[k].weight, plain.patches[k].weight);
  }
  for (std::size_t k = 0; k < plain.patches.size(); ++k) {
    const PlaneRates& rates = moving.rates[k];
    const auto largest = [](const ByMotion<double>& by) {
      return std::max({std::abs(by.lateral), std::abs(by.vertical), std::abs(by.roll) / arm,
                       std::abs(by.yaw) / arm});
    };
    for (std::size_t motion = 0; motion < 4; ++motion) {
      std::array<ContactPatches, 2> ahead;
      std::array<ContactPatches, 2> behind;
      for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto found = [&](double sign) {
          Pose at = pose;
          double z = height;
          (motion == 0   ? at.lateral
           : motion == 1 ? z
           : motion == 2 ? at.roll
                         : at.yaw) += sign * (motion < 2 ? steps[i] : steps[i] / arm);
          const ContactScan moved = search_contacts(wheel, rail, at, 0.0);
          return find_contact_patches(moved, -moved.candidates.front().distance - z,
                                      {c.joining_distance});
        };
        ahead[i] = found(1.0);
        behind[i] = found(-1.0);
      }
      const double unit = motion < 2 ? 1.0 : arm;
      const auto compare = [&](const char* what, const ByMotion<double>& rate, const auto& value) {
        const double here =
            std::array{rate.lateral, rate.vertical, rate.roll, rate.yaw}.at(motion) / unit;
        double error = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < steps.size(); ++i) {
          const double difference = (value(ahead[i]) - value(behind[i])) / (2.0 * steps[i]);
          error = std::min(error, std::abs(here - difference));
        }
        EXPECT_LE(error, difference_tolerance * largest(rate))
            << what << " of patch " << k << ", motion " << motion;
      };
      compare("angle", rates.angle,
              [k](const ContactPatches& all) { return all.patches.at(k).angle; });
      if (k > 0) {
        compare("closeness", moving.link_rates[k - 1],
                [k](const ContactPatches& all) { return all.links.at(k - 1); });
      }
      compare("mean y", rates.mean_y,
              [k](const ContactPatches& all) { return all.patches.at(k).mean_y; });
      if (c.yaw != 0.0) {
        compare("mean x", rates.mean_x,
                [k](const ContactPatches& all) { return all.patches.at(k).mean_x; });
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Positions, PlaneRatesOf,
    testing::Values(
        Case{"middle", "S1002", "60E1", 0.3, 0.05},
        Case{"outwards", "S1002", "60E1", -3.0, 0.05, 0.0, 1e-3},
        Case{"two lobes", "S1002", "60E1", 3.0, 0.05},
        Case{"flange root", "S1002", "60E1", 5.6, 0.1},
        Case{"flange", "S1002", "60E1", 6.8, 0.1, 0.0, 1e-3},
        Case{"two patches", "S1002", "60E1", 6.0, 0.14, 0.02, 1e-3},
        Case{"yawed", "S1002", "60E1", 1.0, 0.05, 0.02},
        Case{"yawed flange", "S1002", "60E1", 6.5, 0.1, 0.03, 1e-3},
        Case{"Manchester two lobes", "S1002", "UIC60-Manchester", 5.0, 0.06, 0.0, 4e-4},
        Case{"turned by distance", "S1002", "UIC60-Manchester", 5.0, 0.005, 0.0, 0.0, 4.0},
        Case{"close by distance", "S1002", "UIC60-Manchester", 5.0, 0.022, 0.0, 0.0, 4.0},
        Case{"close by distance and yawed", "S1002", "UIC60-Manchester", 5.01, 0.022, 0.012, 2e-4,
             4.0},
        Case{"LMA middle", "LMA", "60E1", 0.2, 0.06},
        Case{"LMA outwards", "LMA", "CHN60", -4.0, 0.06, 0.0, -5e-4},
        Case{"LMA inwards", "LMA", "CHN60", 4.0, 0.06, 0.01},
        Case{"LMA flange", "LMA", "CHN60", 9.0, 0.1, -0.02, 1e-3}),
    [](const testing::TestParamInfo<Case>& tested) {
      std::string name = tested.param.name;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

} // namespace
} // namespace wrc::test::plane_rates_test
