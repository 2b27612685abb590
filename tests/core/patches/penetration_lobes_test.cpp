// Lobes of penetration: ends, joins and integrals against closed forms.
#include "patches/penetration_lobes.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::penetration_lobes_test {
namespace {

using Sample = patch_finding::LocusSample<double>;
using Lobe = patch_finding::Lobe<double>;

constexpr double curvature = 1.0 / 460.0;

/// Of a penetration over y, with samples `step` apart.
template <class Penetration>
std::vector<Sample> samples_of(double first, double last, double step, double slope,
                               const Penetration& penetration) {
  std::vector<Sample> samples;
  const auto count = static_cast<std::size_t>(std::lround((last - first) / step));
  for (std::size_t i = 0; i <= count; ++i) {
    const double y = first + step * static_cast<double>(i);
    Sample sample{};
    sample.y = sample.s = y;
    sample.slope = slope;
    sample.z = slope * y;
    sample.penetration = penetration(y);
    constexpr double near = 1e-5;
    sample.steepness = (penetration(y + near) - penetration(y - near)) / (2.0 * near);
    sample.curvature = curvature;
    samples.push_back(sample);
  }
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    patch_finding::set_slope_rate(samples[i - 1], samples[i], samples[i + 1]);
  }
  return samples;
}

std::vector<Lobe> lobes_of(const std::vector<Sample>& samples, std::size_t contact, double depth) {
  return patch_finding::LobeFinder<double>(samples, contact, depth).find();
}

/// g = d (1 - t^2), t = (y - y0)/w, on a rail of constant slope m = tan(angle): the overlap along
/// its normal is g cos(angle), and the normal meets the rail at y - a g, a = m cos^2(angle). The
/// weight g^2 x_l is an integral of (1 - t^2)^2.5, 5 pi/16 over -1 to 1, and the mean of g so
/// weighted is 7/8 d. Along the rail a g moves the mean of y by -5/7 of a times that, that of s by
/// 2/7: by parts, the integral of g^2.5 y g' is -2/7 of that of g^3.5.
TEST(PenetrationLobes, IntegralsOfAParabolaAreClosedForms) {
  constexpr double depth = 0.08;
  constexpr double middle = 3.2;
  constexpr double width = 5.0;
  constexpr double slope = 0.1;
  const std::vector<Sample> samples = samples_of(-4.0, 10.0, 0.1, slope, [](double y) {
    return depth * (1.0 - std::pow((y - middle) / width, 2));
  });
  const std::vector<Lobe> lobes = lobes_of(samples, 72, depth);
  ASSERT_EQ(lobes.size(), 1U);
  const Lobe& lobe = lobes.front();
  EXPECT_NEAR(lobe.y_first, middle - width, 1e-9);
  EXPECT_NEAR(lobe.y_last, middle + width, 1e-9);
  EXPECT_NEAR(lobe.angle, std::atan(slope), 1e-12);
  EXPECT_NEAR(lobe.width, 2.0 * width * std::sqrt(1.0 + slope * slope), 1e-8);
  const double cosine = std::cos(std::atan(slope));
  const double across = slope * cosine * cosine * 7.0 / 8.0 * depth;
  EXPECT_NEAR(lobe.moments.y / lobe.moments.weight, middle - 5.0 / 7.0 * across, 1e-5);
  EXPECT_NEAR(lobe.moments.s / lobe.moments.weight, middle + 2.0 / 7.0 * across, 1e-5);
  EXPECT_NEAR(lobe.deepest.penetration, depth, 1e-15);
  EXPECT_EQ(lobe.penetration_next, 0.0);
  // Half the length of the virtual penetration: k x^2/2 = g cos(angle).
  EXPECT_NEAR(lobe.half_length, std::sqrt(2.0 * depth * cosine / curvature), 1e-9);
  // (g cos/d)^2 sqrt(g cos/(d k)) dy/cos, integrated.
  const double weight =
      cosine * std::sqrt(cosine / curvature) * width * 5.0 * std::acos(-1.0) / 16.0;
  EXPECT_NEAR(lobe.moments.weight, weight, 1e-4 * weight);
}

/// cos over two periods: two lobes that meet at a penetration of their own.
TEST(PenetrationLobes, MinimaSeparateLobesThatTouch) {
  constexpr double depth = 0.1;
  const std::vector<Sample> samples = samples_of(-1.0, 17.0, 0.25, 0.0, [](double y) {
    return 0.06 - 0.04 * std::cos(0.25 * std::acos(-1.0) * y) - 0.04 * (y < 0.0 || y > 16.0);
  });
  const std::vector<Lobe> lobes = lobes_of(samples, 20, depth);
  ASSERT_EQ(lobes.size(), 2U);
  EXPECT_NEAR(lobes[0].y_last, 8.0, 1e-12);
  EXPECT_NEAR(lobes[1].y_first, 8.0, 1e-12);
  EXPECT_NEAR(lobes[0].penetration_next, 0.02, 1e-12);
  EXPECT_EQ(lobes[1].penetration_next, 0.0);
  EXPECT_NEAR(lobes[0].deepest.y, 4.0, 1e-12);
  EXPECT_NEAR(lobes[1].deepest.y, 12.0, 1e-12);
}

TEST(PenetrationLobes, JoinedLobesAreTheSumOfTheirParts) {
  const std::vector<Sample> samples = samples_of(-12.0, 12.0, 0.2, 0.0, [](double y) {
    return y < 0.0 ? 0.05 - 0.01 * std::pow(y + 6.0, 2) : 0.03 - 0.01 * std::pow(y - 6.0, 2);
  });
  std::vector<Lobe> lobes = lobes_of(samples, 30, 0.05);
  ASSERT_EQ(lobes.size(), 2U);
  Lobe joined = lobes[0];
  joined.join(lobes[1]);
  EXPECT_EQ(joined.joined, 2);
  EXPECT_EQ(joined.y_first, lobes[0].y_first);
  EXPECT_EQ(joined.y_last, lobes[1].y_last);
  EXPECT_EQ(joined.deepest.y, lobes[0].deepest.y);
  EXPECT_DOUBLE_EQ(joined.moments.weight, lobes[0].moments.weight + lobes[1].moments.weight);
  const double mean = joined.moments.y / joined.moments.weight;
  EXPECT_GT(mean, -6.0);
  EXPECT_LT(mean, 0.0) << "nearer to the deeper one";
}

/// A touch without any depth to tell from nothing still is a lobe.
TEST(PenetrationLobes, ATouchIsALobeOfWidthZero) {
  const std::vector<Sample> samples =
      samples_of(-1.0, 1.0, 1.0, 0.2, [](double y) { return -y * y; });
  const std::vector<Lobe> lobes = lobes_of(samples, 1, 1e-12);
  ASSERT_EQ(lobes.size(), 1U);
  EXPECT_EQ(lobes.front().y_first, 0.0);
  EXPECT_EQ(lobes.front().y_last, 0.0);
  EXPECT_EQ(lobes.front().deepest.y, 0.0);
}

} // namespace
} // namespace wrc::test::penetration_lobes_test
