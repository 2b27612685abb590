// What contact a penetration leads to: the scale of Hertz's pressures on a paraboloid, and how it
// follows the penetration.
#include "accuracy/expected_contact.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::expected_contact_test {
namespace {

using Sample = patch_finding::LocusSample<double>;

constexpr double depth = 0.1;
constexpr double half_width = 8.0; ///< of the penetration

/// A locus along y at height 0, nodes every 0.5 mm, a wheel with a curvature of 1/460 mm.
template <class Penetration> std::vector<Sample> samples_of(const Penetration& penetration) {
  std::vector<Sample> samples;
  for (int i = -20; i <= 20; ++i) {
    Sample& sample = samples.emplace_back();
    sample.y = 0.5 * i;
    sample.penetration = penetration(sample.y);
    constexpr double near = 1e-5;
    sample.steepness = (penetration(sample.y + near) - penetration(sample.y - near)) / (2.0 * near);
    sample.curvature = 1.0 / 460.0;
  }
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    set_slope_rate(samples[i - 1], samples[i], samples[i + 1]);
  }
  return samples;
}

ExpectedContact contact_of(const std::vector<Sample>& samples) {
  ContactPatch penetration;
  penetration.mean_y = 1.0;
  penetration.deepest = depth;
  return expected_contact(penetration, tangent_frame({0.0, 0.0, 0.0}, 0.0),
                          {-half_width, half_width, -10.0, 10.0}, samples);
}

double parabola(double y) {
  return depth * (1.0 - y * y / (half_width * half_width));
}

/// The virtual penetration ends where 0.55 of the depth is used up. Hertz: of an ellipse as wide,
/// the contact of bodies whose semi-axes the penetration's are times sqrt(0.5).
TEST(ExpectedContact, OfAParaboloidIsNearlyHertzs) {
  const ExpectedContact contact = contact_of(samples_of(parabola));
  EXPECT_EQ(contact.mean_y, 1.0);
  EXPECT_EQ(contact.width, 16.0);
  EXPECT_EQ(contact.length, 20.0);
  EXPECT_NEAR(contact.scale.across, 2.0 * half_width * std::sqrt(0.5), 0.05 * half_width);
  const double half_length = std::sqrt(2.0 * 460.0 * depth);
  EXPECT_NEAR(contact.scale.along, 2.0 * half_length * std::sqrt(0.5), 0.05 * half_length);
  EXPECT_NEAR(contact.middle, 0.5, 1e-12);
}

/// Half as wide, on the left half of the area; what lies below the level counts for nothing.
TEST(ExpectedContact, IsNarrowForNarrowPenetration) {
  const auto narrow = [](double y) { return y > 0.0 ? parabola(2.0 * y - 8.0) : 0.4 * depth; };
  const ExpectedContact wide = contact_of(samples_of(parabola));
  const ExpectedContact contact = contact_of(samples_of(narrow));
  EXPECT_NEAR(contact.scale.across, 0.5 * wide.scale.across, 0.02 * wide.scale.across);
  EXPECT_NEAR(contact.scale.along, wide.scale.along, 0.02 * wide.scale.along);
  EXPECT_NEAR(contact.middle, 12.0 / 16.0, 1e-3);
}

/// Without sudden changes where a row passes a node: a step moves the scale as the one before.
TEST(ExpectedContact, FollowsThePenetrationSmoothly) {
  std::vector<double> across;
  for (int step = 0; step < 400; ++step) {
    const double place = 1e-3 * step;
    across.push_back(
        contact_of(samples_of([&](double y) { return parabola(y - place); })).scale.across);
  }
  for (std::size_t i = 2; i < across.size(); ++i) {
    EXPECT_NEAR(across[i] - across[i - 1], across[i - 1] - across[i - 2], 2e-4 * across[0]);
  }
}

TEST(ExpectedContact, HasOneRowIfNonePenetrates) {
  const ExpectedContact contact = contact_of(samples_of([](double) { return -depth; }));
  EXPECT_NEAR(contact.scale.across, 16.0 / 65.0, 1e-12);
  EXPECT_NEAR(contact.scale.along, 20.0 / 65.0, 1e-12);
  EXPECT_EQ(contact.middle, 0.5);
}

} // namespace
} // namespace wrc::test::expected_contact_test
