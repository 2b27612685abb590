// Samples of the contact locus: parabolas between them, derivatives, tops and stretches.
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

Sample sample_at(double y, double penetration, bool top = false) {
  Sample sample{};
  sample.y = y;
  sample.s = y;
  sample.penetration = penetration;
  sample.curvature = 1.0 / 460.0;
  sample.top = top;
  return sample;
}

/// A parabola c y^2 + b y + a has one second derivative, and its bulge is exact; so is the rate of
/// a slope that grows evenly.
TEST(LocusSamples, DerivativesAndBulgeOfAParabolaAreExact) {
  constexpr double a = 0.1;
  constexpr double b = 0.05;
  constexpr double c = -0.004;
  constexpr double slope_rate = -0.003;
  const auto at = [](double y) {
    Sample sample = sample_at(y, a + b * y + c * y * y);
    sample.slope = 0.1 + slope_rate * y;
    return sample;
  };
  std::vector<Sample> samples{at(0.0), at(0.7), at(1.9), at(2.4)};
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    patch_finding::set_derivatives(samples[i - 1], samples[i], samples[i + 1]);
    EXPECT_NEAR(samples[i].second, 2.0 * c, 1e-14);
    EXPECT_NEAR(samples[i].slope_rate, slope_rate, 1e-14);
  }
  const double bulge = patch_finding::bulge_between(samples[1], samples[2]);
  const double middle = at(1.3).penetration;
  EXPECT_NEAR(0.25 * bulge, middle - 0.5 * (samples[1].penetration + samples[2].penetration),
              1e-14);
}

/// The way down along a parabola ends where it crosses the level.
TEST(LocusSamples, DescentEndsAtTheGivenLevel) {
  const Sample higher = sample_at(0.0, 0.3);
  const Sample lower = sample_at(2.0, -0.2);
  for (const double bulge : {-0.2, 0.0, 0.1, 0.3}) {
    for (const double level : {0.0, 0.1, -0.15}) {
      const double t = patch_finding::way_down(higher, lower, bulge, level);
      EXPECT_GT(t, 0.0);
      EXPECT_LT(t, 1.0);
      EXPECT_NEAR(0.3 - 0.5 * t + bulge * t * (1.0 - t), level, 1e-14) << bulge << ' ' << level;
    }
  }
}

/// A top is where its parabola is level: penetration falls to both sides by the square.
TEST(LocusSamples, TheParabolaBesideATopStartsLevel) {
  const Sample top = sample_at(0.0, 0.3, true);
  const Sample beside = sample_at(1.0, 0.1);
  EXPECT_NEAR(patch_finding::bulge_between(top, beside), 0.2, 1e-15);
  // 0.3 - 0.2 t^2 = 0.25
  EXPECT_NEAR(patch_finding::way_down(top, beside, 0.2, 0.25), 0.5, 1e-14);
}

TEST(LocusSamples, ABulgeAddsNoTop) {
  Sample from = sample_at(0.0, 0.10);
  Sample to = sample_at(3.0, 0.11);
  from.second = to.second = -1.0;
  EXPECT_DOUBLE_EQ(patch_finding::bulge_between(from, to), 0.11 - 0.10);
  to.second = 1.0; // a turning point lies between
  EXPECT_EQ(patch_finding::bulge_between(from, to), 0.0);
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

/// Penetration by a made-up distance, and the places as they are.
struct Source {
  using Real = double;
  [[nodiscard]] Sample place_of(const DistanceSample& sample, double limit) const {
    return sample_at(sample.wheel.position.y, limit - sample.distance);
  }
  [[nodiscard]] Sample place_of(const ContactCandidate& contact, double penetration) const {
    return sample_at(contact.wheel.position.y, penetration, true);
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
    tops += samples[i].top ? 1U : 0U;
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
    found += !sample.top && sample.penetration > 0.0 ? 1U : 0U;
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
