/// Surfaces that swing between slices, and rises that are too steep for the search.
#include "geometry/along_check.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"

namespace wrc::test::along_check_test {
namespace {

AlongCheck check_of(const std::vector<double>& places,
                    const std::function<double(double)>& height) {
  const SlicedProfile profile = crown_along(places, height);
  return check_along(profile, sheets_of(profile, 0.0, 0.0));
}

std::string text_of_all(const AlongCheck& check, ProfileKind kind) {
  std::string text;
  for (const Warning& warning : warnings_of(check, kind)) {
    EXPECT_EQ(warning.kind, WarningClass::profile_swing);
    text += warning.text + '\n';
  }
  return text;
}

/// 0.3 mm within 1 mm, between slices 100 mm apart: the spline goes 0.057 mm beyond both.
TEST(AlongCheck, FindsTheSwingsBesideAStep) {
  const AlongCheck check = check_of({-300.0, -100.0, -0.5, 0.5, 100.0, 300.0},
                                    [](double x) { return x < 0.0 ? 0.0 : 0.3; });
  EXPECT_NEAR(std::abs(check.swing.size), 0.057, 0.004);
  EXPECT_EQ(check.swing.intervals, 2U);
  const std::string text = text_of_all(check, ProfileKind::rail);
  EXPECT_NE(text.find("between slices 2 and 3 the rail is 0.05"), std::string::npos) << text;
  EXPECT_NE(text.find("mm below both (as in 1 other interval): add slices there, or state "
                      "smoothing_along of the rail"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("the rail rises by 0.3 mm within 1 mm at 0 mm, steeper than 1:5"),
            std::string::npos)
      << text;
}

/// A crest is above the slices on both sides of it as well.
TEST(AlongCheck, HasNothingToSayOfWaves) {
  for (const double step : {5.0, 10.0, 12.5}) { // 8 and more in a wave
    const AlongCheck check = check_of(places_every(-300.0, 300.0, step), [](double x) {
      return 0.1 * std::cos(2.0 * std::numbers::pi * (x - 3.1) / 100.0);
    });
    EXPECT_LT(std::abs(check.swing.size), 0.005) << step;
    EXPECT_EQ(text_of_all(check, ProfileKind::rail), "") << step;
  }
}

TEST(AlongCheck, FindsSteepRampsOverSeveralSlices) {
  const auto ramp = [](double slope) {
    return check_of(places_every(-5.0, 5.0, 0.1), [slope](double x) {
      const double share = std::clamp(0.5 + x * slope / 0.3, 0.0, 1.0);
      return 0.3 * share * share * (3.0 - 2.0 * share);
    });
  };
  const AlongCheck steep = ramp(0.5);
  EXPECT_NEAR(steep.rise.size, 0.28, 0.02); // less its ends, which are flatter than 1:5
  EXPECT_NEAR(steep.rise.length, 0.5, 0.1);
  EXPECT_NEAR(steep.rise.place, 0.0, 0.1);
  EXPECT_NE(text_of_all(steep, ProfileKind::rail).find("the rail rises by 0.2"), std::string::npos);
  EXPECT_EQ(text_of_all(ramp(0.1), ProfileKind::rail), ""); // 1:6.7 in its middle
}

/// The ends of a chord of 60 mm are kinks of 0.065 rad; 6 mm from slice to slice is too far.
TEST(AlongCheck, FindsWhatStandsProudBesideASharpFlat) {
  const auto flat = [](double step) {
    const SlicedProfile profile = profile_of(places_every(-0.15, 0.15, step), [](double theta) {
      return curve_of([&](double) { return Height{-chord_depth(theta, 460.0, 60.0), 0.0, 0.0}; });
    });
    return check_along(profile, sheets_of(profile, 0.0, 2.0 * std::numbers::pi, {"mm", 460.0}),
                       {"mm", 460.0});
  };
  const AlongCheck coarse = flat(0.3 / 22.0);
  EXPECT_NEAR(coarse.swing.size, 0.023, 0.003);
  EXPECT_NE(text_of_all(coarse, ProfileKind::wheel).find("smoothing_along of the wheel"),
            std::string::npos);
  EXPECT_EQ(coarse.rise.size, 0.0);
  EXPECT_EQ(text_of_all(flat(0.002), ProfileKind::wheel), "");
}

/// Slices around the wheel, none within 0.1 rad of a flat's end: the same wherever the list begins.
TEST(AlongCheck, LooksBetweenTheLastSliceAndTheFirst) {
  const auto check = [](double begin) {
    std::vector<double> places;
    for (int i = 0; i < 60; ++i)
      places.push_back(begin + 2.0 * std::numbers::pi * i / 60);
    const SlicedProfile profile = profile_of(places, [](double theta) {
      const double near = std::remainder(theta, 2.0 * std::numbers::pi);
      return curve_of([&](double) { return Height{std::abs(near) < 0.06 ? -0.5 : 0.0, 0.0, 0.0}; });
    });
    return check_along(profile, sheets_of(profile, 0.0, 2.0 * std::numbers::pi, {"mm", 460.0}),
                       {"mm", 460.0});
  };
  const double step = 2.0 * std::numbers::pi / 60;
  const AlongCheck middle = check(-30.0 * step);
  const AlongCheck seam = check(step); // the step down is between the last slice and the first
  EXPECT_GT(std::abs(middle.swing.size), 0.01);
  EXPECT_NEAR(seam.swing.size, middle.swing.size, 1e-9);
  EXPECT_EQ(seam.swing.intervals, middle.swing.intervals);
}

TEST(AlongCheck, ReportsTheLargestSwing) {
  EXPECT_EQ(swing_text({}), "between slices the surface is nowhere above or below both");
  AlongCheck check;
  check.swing.size = -0.004;
  check.swing.slice = 2;
  check.swing.slice_next = 3;
  EXPECT_EQ(swing_text(check), "between slices the surface is above or below both by at most "
                               "0.004 mm, between slices 2 and 3");
  EXPECT_TRUE(warnings_of(check, ProfileKind::rail).empty());
}

} // namespace
} // namespace wrc::test::along_check_test
