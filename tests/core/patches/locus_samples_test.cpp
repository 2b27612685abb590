// Samples of the contact locus: cubics between them, tops and stretches.
#include "patches/locus_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/wheelset_equilibrium.hpp"
#include "patches/contact_patches.hpp"
#include "profile/standard_profiles.hpp"
#include "remesh/undeformed_distance.hpp"

namespace wrc::test::locus_samples_test {
namespace {

using Sample = patch_finding::LocusSample<double>;

Sample sample_at(double y, double penetration, double steepness = 0.0) {
  Sample sample{};
  sample.y = y;
  sample.s = y;
  sample.penetration = penetration;
  sample.steepness = steepness;
  sample.curvature = 1.0 / 460.0;
  return sample;
}

/// A cubic without a top in between is met everywhere, in both directions.
TEST(LocusSamples, PenetrationBetweenThemIsACubic) {
  const auto at = [](double y) {
    return sample_at(y, 0.1 - 0.05 * y - 0.004 * y * y + 0.001 * y * y * y,
                     -0.05 - 0.008 * y + 0.003 * y * y);
  };
  const patch_finding::Rise<double> down(at(0.7), at(1.9));
  const patch_finding::Rise<double> up(at(1.9), at(0.7));
  for (const double share : {0.0, 0.1, 0.5, 0.8, 1.0}) {
    EXPECT_NEAR(down.at(share), at(0.7 + 1.2 * share).penetration, 1e-15);
    EXPECT_NEAR(up.at(share), at(1.9 - 1.2 * share).penetration, 1e-15);
    if (share > 0.0) {
      EXPECT_NEAR(down.way_down(at(0.7 + 1.2 * share).penetration), share, 1e-9);
    }
  }
}

/// A slope that grows evenly has this rate.
TEST(LocusSamples, RatesOfSlopesAreExact) {
  constexpr double rate = -0.003;
  std::array<Sample, 3> samples{sample_at(0.0, 0.1), sample_at(0.7, 0.1), sample_at(1.9, 0.1)};
  for (Sample& sample : samples) {
    sample.slope = 0.1 + rate * sample.y;
  }
  patch_finding::set_slope_rate(samples[0], samples[1], samples[2]);
  EXPECT_NEAR(samples[1].slope_rate, rate, 1e-14);
}

/// From a top penetration falls by the square: 0.3 - 0.2 t^2 = 0.25.
TEST(LocusSamples, TheParabolaBesideATopStartsLevel) {
  const patch_finding::Rise<double> rise(sample_at(0.0, 0.3), sample_at(1.0, 0.1, -0.4));
  EXPECT_NEAR(rise.at(0.5), 0.25, 1e-15);
  EXPECT_NEAR(rise.way_down(0.25), 0.5, 1e-14);
}

/// Slopes of a kink, or of a body's end, make no top and no valley.
TEST(LocusSamples, NothingBetweenTwoIsOutsideThem) {
  for (const double first : {-1e300, -0.3, 0.0, 1.0, 1e300}) {
    for (const double last : {-1e300, -0.3, 0.0, 1.0, 1e300}) {
      const patch_finding::Rise<double> rise(sample_at(0.0, 0.11, first),
                                             sample_at(3.0, 0.10, last));
      for (double share = 0.0; share <= 1.0; share += 0.01) {
        // Two slopes of four times the mean leave it by a tenth of the difference.
        EXPECT_GE(rise.at(share), 0.10 - 0.002) << first << ' ' << last;
        EXPECT_LE(rise.at(share), 0.11 + 0.002) << first << ' ' << last;
      }
      for (const double level : {0.1, 0.103, 0.11}) {
        const double way = rise.way_down(level);
        EXPECT_GE(way, 0.0);
        EXPECT_LE(way, 1.0);
      }
    }
  }
}

/// z = x'^2/(2 R) + f(y'), turned by the yaw: on the locus the second derivative along x is
/// k/(1 - tan(yaw) dx/dy). The locus of a cone (f = m y') is straight: dx/dy = -tan(yaw) gives
/// k cos^2(yaw), that of the cone seen obliquely.
TEST(LocusSamples, CurvatureIsTurnedWithTheLocus) {
  constexpr double yaw_tangent = 0.02;
  Sample before = sample_at(-1.0, 0.1);
  Sample here = sample_at(0.0, 0.1);
  Sample after = sample_at(1.0, 0.1);
  before.x = yaw_tangent;
  after.x = -yaw_tangent;
  const double curvature = here.curvature;
  patch_finding::turn_curvature(before, here, after, yaw_tangent);
  EXPECT_NEAR(here.curvature, curvature / (1.0 + yaw_tangent * yaw_tangent), 1e-15);
}

/// Of a top, to know it by.
constexpr double top_mark = 1.0;

/// Penetration by a made-up distance, and the places as they are.
struct Source {
  using Real = double;
  [[nodiscard]] Sample place_of(const DistanceSample& sample, double limit) const {
    return sample_at(sample.wheel.position.y, limit - sample.distance);
  }
  [[nodiscard]] Sample place_of(const ContactCandidate& contact, double penetration) const {
    Sample top = sample_at(contact.wheel.position.y, penetration);
    top.ahead = top_mark;
    return top;
  }
  [[nodiscard]] double yaw_tangent() const { return 0.0; }
};

TEST(LocusSamples, CoverThePenetratingStretchesAndTheirTops) {
  ContactScan scan;
  for (int i = 0; i <= 80; ++i) {
    const double y = 0.5 * i;
    const double distance = std::min(std::pow(y - 10.2, 2), std::pow(y - 30.1, 2) + 3.0) / 200.0;
    scan.samples.push_back({{{0.0, y, 0.0}, y, 1.0 / 460.0}, distance, 0.0});
  }
  for (const auto& [y, distance] : {std::array{10.2, 0.0}, std::array{30.1, 3.0 / 200.0}}) {
    ContactCandidate contact;
    contact.wheel.position.y = contact.wheel.lateral = y;
    contact.distance = distance;
    scan.candidates.push_back(contact);
  }
  constexpr double depth = 0.02;
  const Source source;
  const patch_finding::LocusSampler<Source> sampler(scan, depth, source);
  const std::vector<Sample>& samples = sampler.samples();
  EXPECT_EQ(samples[sampler.first_contact()].y, 10.2);
  EXPECT_EQ(samples[sampler.first_contact()].penetration, depth);
  std::size_t tops = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    tops += samples[i].ahead == top_mark ? 1U : 0U;
    EXPECT_LE(samples[i].penetration, depth);
    if (i > 0) {
      EXPECT_GT(samples[i].y, samples[i - 1].y);
    }
  }
  EXPECT_EQ(tops, 2U);
  // Every node that penetrates is there, and the ends are outside.
  std::size_t penetrating = 0;
  for (const DistanceSample& sample : scan.samples) {
    penetrating += sample.distance < depth ? 1U : 0U;
  }
  std::size_t found = 0;
  for (const Sample& sample : samples) {
    found += sample.ahead != top_mark && sample.penetration > 0.0 ? 1U : 0U;
  }
  EXPECT_EQ(found, penetrating);
  EXPECT_LE(samples.front().penetration, 0.0);
  EXPECT_LE(samples.back().penetration, 0.0);
}

/// Second differences of distances along the rail, through the locus at the root of the flange:
/// with 50 mrad of yaw they are an eighth less than the curvature in rolling direction.
TEST(LocusSamples, CurvatureIsThatAlongTheRail) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, 460.0});
  const RailSurface rail(standard_profile("60E1"), {1435.0, 14.0, 0.025});
  constexpr double depth = 0.1;
  for (const double yaw : {0.0, 0.05, -0.05}) {
    EquilibriumRequest request;
    request.lateral = 6.5;
    request.yaw = yaw;
    request.roll = 0.0;
    request.right = false;
    const SideEquilibrium side = *find_equilibrium({wheel, rail}, {wheel, rail}, request).left;
    const ContactPatches found = find_contact_patches(side.scan, depth);
    const ContactPatch& patch = found.patches[found.main];
    const auto samples = locus_samples(side.scan, depth);
    const auto at = std::ranges::min_element(
        samples, {}, [&](const auto& sample) { return std::abs(sample.y - patch.mean_y); });
    const ContactFrame frame = tangent_frame({at->x, at->y, at->z}, std::atan(at->slope));
    const std::vector<double> distance = sample_undeformed_distance(
        {wheel, rail, side.pose, side.vertical - depth}, frame, {1, 3, 1.0, 1.0, 0.0, -1.0});
    EXPECT_NEAR(at->curvature, distance[0] - 2.0 * distance[1] + distance[2], 0.05 * at->curvature);
  }
}

/// At kinks differences say anything: 100 times the curvature in rolling direction, or a hundredth.
TEST(LocusSamples, CurvatureIsBounded) {
  Sample before{};
  Sample after{};
  after.y = 1.0;
  const auto turned = [&](double x) {
    Sample here{};
    here.curvature = 1.0;
    after.x = x;
    patch_finding::turn_curvature(before, here, after, 0.1);
    return here.curvature;
  };
  EXPECT_DOUBLE_EQ(turned(-10.0), 0.5);
  EXPECT_DOUBLE_EQ(turned(20.0), 100.0);
  EXPECT_DOUBLE_EQ(turned(-1e4), 0.01);
}

} // namespace
} // namespace wrc::test::locus_samples_test
