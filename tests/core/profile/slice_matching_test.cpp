/// Which stretches of neighbouring slices correspond, and the features that follow from it.
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "profile/slice_matching.hpp"
#include "profile/spline.hpp"
#include "support/errors.hpp"

namespace wrc::test::slice_matching_test {
namespace {

constexpr double crown = 300.0;   // radius, mm
constexpr double accuracy = 2e-3; // of arc lengths: chords of 0.5 mm, mm

/// The crown from one lateral place to another.
Curve cut(double from, double to) {
  std::vector<Position> points;
  const int count = static_cast<int>(std::lround((to - from) / 0.5));
  for (int i = 0; i <= count; ++i) {
    const double y = from + (to - from) * i / count;
    points.push_back({y, std::sqrt(crown * crown - y * y) - crown});
  }
  return curve_through(points);
}

double arc_between(double from, double to) {
  return crown * (std::asin(to / crown) - std::asin(from / crown));
}

FoundFeatures found_in(const std::vector<Curve>& curves) {
  std::vector<const Curve*> slices;
  for (const Curve& curve : curves)
    slices.push_back(&curve);
  return find_features(slices);
}

/// Which features a slice has: "xx." for the first two of three.
std::string pattern(const std::vector<std::optional<double>>& features) {
  std::string text;
  for (const std::optional<double>& feature : features)
    text += feature ? 'x' : '.';
  return text;
}

TEST(SliceMatching, TheCommonStretchBeginsWhereTheShorterSliceDoes) {
  const SliceMatch match = match_slices(cut(-30.0, 30.0), cut(-60.0, 30.0));
  EXPECT_FALSE(match.is_whole);
  EXPECT_EQ(match.begin, 0.0);
  EXPECT_NEAR(match.next_begin, arc_between(-60.0, -30.0), accuracy);
  EXPECT_EQ(match.end, cut(-30.0, 30.0).length());
  EXPECT_EQ(match.next_end, cut(-60.0, 30.0).length());
}

TEST(SliceMatching, BothMayReachBeyondEachOther) {
  const SliceMatch match = match_slices(cut(-40.0, 20.0), cut(-20.0, 40.0));
  EXPECT_NEAR(match.begin, arc_between(-40.0, -20.0), accuracy);
  EXPECT_EQ(match.next_begin, 0.0);
  EXPECT_EQ(match.end, cut(-40.0, 20.0).length());
  EXPECT_NEAR(match.next_end, arc_between(-20.0, 20.0), accuracy);
}

/// Equal in length as a whole, and unlike where both are: 2 mm deep, the groove adds 0.7 mm.
TEST(SliceMatching, BothMayReachBeyondEachOtherWhereTheirShapesDiffer) {
  const auto grooved = [](double from, double to, double depth) {
    std::vector<Position> points;
    for (double y = from; y <= to; y += 0.5) {
      const double groove =
          std::abs(y) < 8.0 ? std::pow(std::cos(y * std::numbers::pi / 16.0), 2) : 0.0;
      points.push_back({y, std::sqrt(crown * crown - y * y) - crown - depth * groove});
    }
    return curve_through(points);
  };
  const SliceMatch match = match_slices(grooved(-45.0, 30.0, 0.0), grooved(-30.0, 44.5, 2.0));
  EXPECT_FALSE(match.is_whole);
  EXPECT_NEAR(match.begin, arc_between(-45.0, -30.0), 0.1);
  EXPECT_EQ(match.next_begin, 0.0);
}

TEST(SliceMatching, SlicesThatVaryGraduallyCorrespondAsAWhole) {
  EXPECT_TRUE(match_slices(cut(-30.0, 30.0), cut(-31.0, 31.0)).is_whole);
  const FoundFeatures found = found_in({cut(-30.0, 30.0), cut(-31.0, 31.0), cut(-32.0, 32.0)});
  EXPECT_TRUE(found.of_slices.empty());
  EXPECT_TRUE(found.notes.empty());
}

/// Below, the lower slice reaches beyond the higher one at both ends.
TEST(SliceMatching, SlicesOfARisingRailCorrespondAsAWhole) {
  const auto head = [](double height) {
    std::vector<Position> points;
    for (int i = -144; i <= 144; ++i) { // 72 mm wide, 30 mm high
      const double across = std::abs(i) <= 72 ? 0.5 * i : std::copysign(36.0, i);
      const double below = std::abs(i) <= 72 ? 0.0 : 0.42 * (std::abs(i) - 72);
      points.push_back({across, height - across * across / 600.0 - below});
    }
    return curve_through(points);
  };
  for (const double rise : {7.0, 10.0, 20.0})
    for (const double sign : {1.0, -1.0})
      EXPECT_TRUE(match_slices(head(0.0), head(sign * rise)).is_whole) << sign * rise;
}

/// Its left side lies nearer to the right side before, which runs the other way.
TEST(SliceMatching, ABladeThatMovesByItsWidthStaysWhole) {
  const auto blade = [](double at) {
    std::vector<Position> points;
    for (int i = 0; i <= 80; ++i)
      points.push_back({at + 0.05 * (i - 40), -0.02 * (i - 40) * (i - 40)});
    return curve_through(points);
  };
  for (const double shift : {1.0, 3.0, 4.0, 6.0})
    EXPECT_TRUE(match_slices(blade(0.0), blade(shift)).is_whole) << shift;
}

TEST(SliceMatching, EndsBecomeFeaturesThatGoOnAlongTheList) {
  const std::vector<Curve> curves{cut(-30.0, 30.0), cut(-30.0, 30.0), cut(-60.0, 30.0),
                                  cut(-60.0, 30.0)};
  const FoundFeatures found = found_in(curves);
  ASSERT_EQ(found.of_slices.size(), 4U);
  EXPECT_EQ(pattern(found.of_slices[1]), ".xx");
  EXPECT_EQ(pattern(found.of_slices[2]), "xxx");
  EXPECT_EQ(found.of_slices[1][1], 0.0);
  EXPECT_EQ(found.of_slices[1][2], curves[1].length());
  EXPECT_EQ(found.of_slices[2][0], 0.0);
  EXPECT_NEAR(found.of_slices[3][1].value(), arc_between(-60.0, -30.0), accuracy);
  EXPECT_EQ(found.of_slices[3][2], curves[3].length());
  ASSERT_EQ(found.notes.size(), 2U);
  EXPECT_EQ(found.notes[1], "between slices 2 and 3: the first 30.36 mm of slice 3 begin");
}

/// Ends that lie only beyond some slices are spread over what these have instead.
TEST(SliceMatching, NoSliceHasAHole) {
  const std::vector<Curve> curves{cut(-30.0, 30.0), cut(-30.0, 20.0), cut(-30.0, 45.0),
                                  cut(-30.0, 45.0), cut(-45.0, 10.0), cut(-30.0, 30.0)};
  const FoundFeatures found = found_in(curves);
  ASSERT_EQ(found.of_slices.size(), curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::vector<std::optional<double>>& features = found.of_slices[i];
    const std::string text = pattern(features);
    const std::size_t first = text.find('x');
    const std::size_t last = text.rfind('x');
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(text.substr(first, last - first + 1).find('.'), std::string::npos) << text;
    EXPECT_EQ(features[first], 0.0);
    EXPECT_EQ(features[last], curves[i].length());
    for (std::size_t k = first; k < last; ++k)
      EXPECT_LT(features[k].value(), features[k + 1].value());
  }
}

TEST(SliceMatching, SlicesWithNothingInCommonInterruptTheSurface) {
  EXPECT_TRUE(match_slices(cut(-60.0, -20.0), cut(20.0, 60.0)).is_empty());
  const FoundFeatures found =
      found_in({cut(-60.0, -20.0), cut(-60.0, -20.0), cut(20.0, 60.0), cut(20.0, 60.0)});
  ASSERT_EQ(found.of_slices.size(), 4U);
  EXPECT_EQ(pattern(found.of_slices[1]), "xx..");
  EXPECT_EQ(pattern(found.of_slices[2]), "..xx");
  EXPECT_EQ(found.notes.at(1),
            "between slices 2 and 3 the surface is interrupted: they have nothing in common");
}

/// Slices cut at the same two places in turn: each place is one line where that goes on.
TEST(SliceMatching, EndsAtTheSamePlaceAreOneFeature) {
  for (const double drift : {0.0, 0.013, 0.1}) {
    std::vector<Curve> curves;
    for (int i = 0; i < 14; ++i)
      curves.push_back(cut(-30.0 + drift * i, i % 2 == 0 ? 30.0 : 40.0));
    const FoundFeatures found = found_in(curves);
    ASSERT_EQ(found.notes.size(), 12U);
    EXPECT_EQ(found.notes[11], "and so between 3 other pairs of slices");
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_EQ(pattern(found.of_slices[i]).substr(0, 2), "xx");
      EXPECT_NEAR(found.of_slices[i][1].value(),
                  arc_between(-30.0 + drift * static_cast<double>(i), 30.0), accuracy);
      double last = -1.0;
      for (const std::optional<double>& feature : found.of_slices[i]) {
        if (!feature)
          continue;
        EXPECT_GT(*feature, last + 0.1) << drift << ' ' << i;
        last = *feature;
      }
    }
  }
}

TEST(SliceMatching, ListsThatDifferInTooManyPlacesAreRefused) {
  std::vector<Curve> curves;
  for (int i = 0; i < 220; ++i) // each reaches 10 mm beyond both neighbours
    curves.push_back(i % 2 == 0 ? cut(-100.0 + 0.1 * i, 60.0 + 0.1 * i)
                                : cut(-90.0 + 0.1 * i, 70.0 + 0.1 * i));
  test::expect_error(
      ErrorCode::invalid_argument, [&] { (void)found_in(curves); }, "more than 200",
      "needs features");
}

} // namespace
} // namespace wrc::test::slice_matching_test
