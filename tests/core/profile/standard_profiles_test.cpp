/// Built-in profiles: names, junctions, gauge dimensions, constructions.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/profile.hpp"
#include "profile/standard_profiles.hpp"

namespace wrc::test::standard_profiles_test {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
/// Pieces reproduce the segments to 1e-11; what is left is rounding of the file's numbers.
constexpr double exact = 1e-10;

std::vector<std::string_view> all_names() {
  std::vector<std::string_view> names = standard_profile_names(ProfileKind::wheel);
  const auto rails = standard_profile_names(ProfileKind::rail);
  names.insert(names.end(), rails.begin(), rails.end());
  return names;
}

/// Lateral coordinate at which the curve first passes a height, seen from `from` towards `to`
/// (arc lengths), by bisection in the first bracket.
double lateral_at_height(const Curve& curve, double height, double from, double to) {
  constexpr int steps = 4000;
  const auto arc = [&](int i) { return from + (to - from) * i / steps; };
  for (int i = 0; i < steps; ++i) {
    double a = arc(i);
    double b = arc(i + 1);
    const double sign = curve.at(a).height - height;
    if (sign * (curve.at(b).height - height) > 0.0)
      continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (a + b);
      (sign * (curve.at(middle).height - height) > 0.0 ? a : b) = middle;
    }
    return curve.at(0.5 * (a + b)).lateral;
  }
  ADD_FAILURE() << "height " << height << " is not met";
  return NAN;
}

double arc_of_tip(const Curve& curve) {
  double best = 0.0;
  for (double s = 0.0; s < curve.length(); s += 0.001)
    if (curve.at(s).height > curve.at(best).height)
      best = s;
  return best;
}

/// Lateral coordinate of the flank at a height above the taping line.
double flank(const Curve& curve, double height) {
  return lateral_at_height(curve, height, arc_of_tip(curve), curve.length());
}

/// Flange thickness: from the flange back (-70) to the flank.
double thickness(const Curve& curve, double height) {
  return flank(curve, height) + 70.0;
}

/// Width of a rail head at a depth below its top.
double width(const Curve& curve, double depth) {
  return lateral_at_height(curve, -depth, curve.length(), 0.5 * curve.length()) -
         lateral_at_height(curve, -depth, 0.0, 0.5 * curve.length());
}

TEST(StandardProfiles, HaveOtherNames) {
  for (const auto& [name, standard] : {std::pair("uic60", "60E1"),
                                       {"UIC60", "60E1"},
                                       {"S49", "49E1"},
                                       {"S54", "54E3"},
                                       {"UIC54", "54E1"},
                                       {"UIC54E", "54E2"},
                                       {"U50", "50E6"},
                                       {"BS113A", "56E1"},
                                       {"60e1", "60E1"},
                                       {"uic60-manchester", "UIC60-Manchester"}}) {
    EXPECT_EQ(standard_name(name, ProfileKind::rail), standard) << name;
    EXPECT_EQ(standard_name(name, ProfileKind::wheel), "") << name;
    EXPECT_EQ(standard_profile(name).name, standard);
  }
  EXPECT_EQ(standard_name("s1002", ProfileKind::wheel), "S1002");
  EXPECT_EQ(standard_name("S1002.prw", ProfileKind::wheel), "");
}

TEST(StandardProfiles, AreTheOnesOfTheList) {
  const std::vector<std::string_view> wheels = {"S1002", "LMA", "LM", "LM-paper"};
  const std::vector<std::string_view> rails = {
      "60E1", "UIC60-Manchester", "CHN60", "60E2", "54E1", "54E2", "54E3", "49E1", "56E1", "50E6"};
  EXPECT_EQ(standard_profile_names(ProfileKind::wheel), wheels);
  EXPECT_EQ(standard_profile_names(ProfileKind::rail), rails);
}

TEST(StandardProfiles, HaveATitleSourceAndConfidence) {
  for (const std::string_view name : all_names()) {
    const Profile profile = standard_profile(name);
    EXPECT_EQ(profile.name, name);
    EXPECT_FALSE(profile.title.empty());
    EXPECT_FALSE(profile.source.empty());
    EXPECT_FALSE(profile.confidence.empty());
  }
  for (const std::string_view name : {"LM", "LM-paper"}) {
    EXPECT_NE(standard_profile(name).title.find("reconstruction"), std::string::npos);
    EXPECT_EQ(standard_profile(name).confidence, "low");
  }
}

TEST(StandardProfiles, UnknownNameListsThePermittedOnes) {
  try {
    (void)standard_profile("S1003");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unknown_name);
    const std::string text = error.what();
    for (const std::string_view name : all_names())
      EXPECT_NE(text.find(name), std::string::npos) << text;
  }
}

TEST(StandardProfiles, RunAlongAUnitTangentFromFlangeToFieldSide) {
  for (const std::string_view name : all_names()) {
    SCOPED_TRACE(name);
    const Curve curve = standard_profile(name).curve;
    for (std::size_t piece = 0; piece < curve.piece_count(); ++piece) {
      const double length = curve.starts()[piece + 1] - curve.starts()[piece];
      EXPECT_LE(length, max_node_distance + 1e-12);
      for (const double part : {0.0, 0.31, 0.5, 0.83, 1.0}) {
        const CurvePoint point = curve.at(piece, part * length);
        EXPECT_NEAR(std::hypot(point.tangent_lateral, point.tangent_height), 1.0, 1e-9);
        EXPECT_GT(point.tangent_lateral, -1e-12);
        EXPECT_NEAR(point.tangent_lateral * point.second_lateral +
                        point.tangent_height * point.second_height,
                    0.0, 1e-8);
        // Central difference of the position: truncation curvature^2 step^2 / 6, rounding
        // 1e-14/step.
        const double step = 1e-4;
        const CurvePoint before = curve.at(piece, part * length - step);
        const CurvePoint after = curve.at(piece, part * length + step);
        EXPECT_NEAR((after.lateral - before.lateral) / (2.0 * step), point.tangent_lateral, 1e-9);
        EXPECT_NEAR((after.height - before.height) / (2.0 * step), point.tangent_height, 1e-9);
      }
    }
  }
}

TEST(StandardProfiles, FollowTheirArcs) {
  for (const std::string_view name : all_names()) {
    SCOPED_TRACE(name);
    const Curve curve = standard_profile(name).curve;
    double begin = 0.0;
    for (const Segment& segment : standard_profile_segments(name)) {
      const double length = curve_of(std::vector{segment}).length();
      if (const auto* arc = std::get_if<ArcSegment>(&segment.shape)) {
        for (int i = 1; i < 200; ++i) {
          const CurvePoint point = curve.at(begin + length * i / 200.0);
          EXPECT_NEAR(std::hypot(point.lateral - arc->centre[0], point.height - arc->centre[1]),
                      arc->radius, 2e-11)
              << segment.label;
          EXPECT_NEAR(std::abs(point.curvature()) * arc->radius, 1.0, 1e-8) << segment.label;
        }
      }
      begin += length;
    }
    EXPECT_NEAR(begin, curve.length(), 1e-9);
  }
}

struct Meeting {
  std::string before;
  double gap;  ///< mm
  double kink; ///< degrees, absolute
};

void expect_junctions(std::string_view name, const std::vector<Meeting>& special) {
  SCOPED_TRACE(name);
  for (const Junction& junction : junctions_of(standard_profile_segments(name))) {
    const auto found = std::find_if(special.begin(), special.end(), [&](const Meeting& one) {
      return one.before == junction.before;
    });
    const double kink = std::abs(junction.kink) * degrees;
    if (found == special.end()) {
      EXPECT_LT(junction.gap, exact) << junction.before;
      EXPECT_LT(kink, 1e-9) << junction.before;
    } else {
      // The table gives three digits.
      EXPECT_NEAR(junction.gap, found->gap, 0.005 * found->gap + exact) << junction.before;
      EXPECT_NEAR(kink, found->kink, 0.005 * found->kink + 1e-9) << junction.before;
    }
  }
}

TEST(StandardProfiles, S1002IsClosedWithinTheRoundingOfItsCoefficients) {
  const Curve& printed = standard_profile("S1002").curve;
  const Curve closed = printed.without_steps();
  double largest_move = 0.0;
  double largest_bend = 0.0;
  for (double arc = 0.0; arc < printed.length(); arc += 0.01) {
    const CurvePoint before = printed.at(arc);
    const CurvePoint after = closed.at(arc);
    const double move = std::hypot(after.lateral - before.lateral, after.height - before.height);
    if (std::abs(before.lateral + 35.0) > 2.5 && std::abs(before.lateral + 26.0) > 2.5) {
      EXPECT_EQ(move, 0.0) << before.lateral;
    }
    largest_move = std::max(largest_move, move);
    largest_bend = std::max(largest_bend, std::abs(after.curvature() - before.curvature()));
  }
  // Rounding in the last digits of polynomial C adds up to 2.4e-4 mm at -35 and 9e-5 mm at -26.
  EXPECT_NEAR(largest_move, 0.5 * 1.183e-4, 1e-6);
  EXPECT_LT(largest_bend, 1e-4); // of 1/13 per mm
}

TEST(StandardProfiles, S1002KeepsTheGapsOfItsCoefficients) {
  int known = 0;
  for (const Junction& junction : junctions_of(standard_profile_segments("S1002"))) {
    const double kink = std::abs(junction.kink) * degrees;
    if (junction.after == "C polynomial") {
      ++known;
      EXPECT_NEAR(junction.lateral, -35.0, exact);
      EXPECT_NEAR(junction.gap, 1.183e-4, 1e-7);
      EXPECT_NEAR(kink, 2.40e-4, 1e-6);
    } else if (junction.after == "B polynomial") {
      ++known;
      EXPECT_NEAR(junction.lateral, -26.0, exact);
      EXPECT_NEAR(junction.gap, 3.65e-5, 1e-7);
      EXPECT_NEAR(kink, 1.74e-4, 1e-6);
    } else if (junction.after == "chamfer 5x45") {
      ++known;
      EXPECT_NEAR(kink, 45.0 - std::atan(0.066666667) * degrees, 1e-9);
    } else {
      EXPECT_LT(junction.gap, 7e-8) << junction.before;
      EXPECT_LT(kink, 3e-7) << junction.before;
    }
  }
  EXPECT_EQ(known, 3);
}

TEST(StandardProfiles, OtherJunctionsClose) {
  expect_junctions("LMA", {{"1:40", 0.0, 2.3819786501}, {"1:15", 0.0, 41.185925166}});
  expect_junctions("LM", {{"1:8", 0.0, 37.874983651}});
  expect_junctions("LM-paper", {{"1:8", 0.0, 37.874983651}});
  for (const std::string_view name : standard_profile_names(ProfileKind::rail))
    expect_junctions(name, {});
}

TEST(StandardProfiles, S1002PolynomialCIsTheOneOfTheStandard) {
  constexpr long double standard[] = {-4.320221063e3L,  -1.038384026e3L,  -1.065501873e2L,
                                      -6.051367875L,    -2.054332446e-1L, -4.169739389e-3L,
                                      -4.687195829e-5L, -2.252755540e-7L};
  const std::vector<Segment> segments = standard_profile_segments("S1002");
  const auto segment = std::find_if(segments.begin(), segments.end(),
                                    [](const Segment& one) { return one.label == "C polynomial"; });
  ASSERT_NE(segment, segments.end());
  const auto& shifted = std::get<PolynomialSegment>(segment->shape);
  for (double y = -35.0; y <= -26.0; y += 0.1) {
    long double plain = 0.0L;
    for (std::size_t i = std::size(standard); i-- > 0;)
      plain = plain * static_cast<long double>(y) + standard[i];
    double value = 0.0;
    for (std::size_t i = shifted.coefficients.size(); i-- > 0;)
      value = value * (y - shifted.expansion_point) + shifted.coefficients[i];
    // Cancellation of the plain form in extended precision: 1e4 * 1e-19 with some growth. Where
    // long double is double this is 1e-11.
    const double cancellation = sizeof(long double) > sizeof(double) ? 1e-13 : 1e-10;
    EXPECT_NEAR(value, static_cast<double>(plain), cancellation);
  }
}

TEST(StandardProfiles, S1002Gauges) {
  const Curve curve = standard_profile("S1002").curve;
  EXPECT_NEAR(curve.at(0.0).lateral, -70.0, exact);
  EXPECT_NEAR(curve.at(curve.length()).lateral, 65.0, exact);
  const CurvePoint tip = curve.at(arc_of_tip(curve));
  EXPECT_NEAR(tip.height, 28.0, 1e-6); // scan of 0.001 mm on R12
  EXPECT_NEAR(tip.lateral, -55.0, 1e-3);
  EXPECT_NEAR(thickness(curve, 10.0), 32.5, 1e-6); // the standard rounds to nine decimals
  EXPECT_NEAR(thickness(curve, 12.0), 31.573236, 1e-6);
  // qR: lateral distance of the flank 10 mm above the taping line and 2 mm below the tip.
  EXPECT_NEAR(flank(curve, 10.0) - flank(curve, 26.0), 10.793816, 1e-6);
  const double taping = lateral_at_height(curve, 0.0, arc_of_tip(curve), curve.length());
  EXPECT_NEAR(taping, 0.0, exact);
}

TEST(StandardProfiles, LmaGauges) {
  const Curve curve = standard_profile("LMA").curve;
  EXPECT_NEAR(curve.at(arc_of_tip(curve)).height, 28.0, 1e-6);
  EXPECT_NEAR(thickness(curve, 10.0), 32.9, 2e-6); // constants recovered to a rounding of 1e-6
  EXPECT_NEAR(thickness(curve, 12.0), 31.974141, 2e-6);
  // Break points of the table.
  for (const Position& spot :
       {Position{-62.307692, 24.659229}, Position{-52.557372, 27.912969},
        Position{-40.265268, 18.152060}, Position{-38.053345, 12.074853},
        Position{-28.4709, 3.326818}, Position{-10.75, 0.499254}, Position{4.253514, -0.126465},
        Position{30.0, -0.770127}, Position{60.0, -2.770127}}) {
    double distance = INFINITY;
    for (double s = 0.0; s < curve.length(); s += 1e-3) {
      const CurvePoint point = curve.at(s);
      distance = std::min(
          distance,
          std::abs((spot[0] - point.lateral) * point.tangent_height -
                   (spot[1] - point.height) * point.tangent_lateral) +
              std::max(0.0, std::hypot(spot[0] - point.lateral, spot[1] - point.height) - 1e-3));
    }
    EXPECT_LT(distance, 2e-6) << spot[0];
  }
}

TEST(StandardProfiles, LmReconstructionGauges) {
  const Curve lm = standard_profile("LM").curve;
  EXPECT_NEAR(lm.at(arc_of_tip(lm)).height, 27.0, 1e-6);
  EXPECT_NEAR(thickness(lm, 12.0), 32.0, 1e-6);
  const Curve paper = standard_profile("LM-paper").curve;
  EXPECT_NEAR(thickness(paper, 12.0), 31.311501, 1e-6);
  // Same tread on both.
  EXPECT_NEAR(lateral_at_height(lm, -2.0, lm.length(), 0.5 * lm.length()),
              lateral_at_height(paper, -2.0, paper.length(), 0.5 * paper.length()), exact);
}

TEST(StandardProfiles, RailsAreSymmetricWithTheTopAtZero) {
  for (const std::string_view name : standard_profile_names(ProfileKind::rail)) {
    SCOPED_TRACE(name);
    const Curve curve = standard_profile(name).curve;
    for (double s = 0.0; s <= 0.5 * curve.length(); s += 0.37) {
      const CurvePoint left = curve.at(s);
      const CurvePoint right = curve.at(curve.length() - s);
      EXPECT_NEAR(left.lateral, -right.lateral, exact);
      EXPECT_NEAR(left.height, right.height, exact);
    }
    const CurvePoint top = curve.at(0.5 * curve.length());
    EXPECT_NEAR(top.lateral, 0.0, exact);
    EXPECT_NEAR(top.height, 0.0, exact);
    EXPECT_NEAR(top.tangent_height, 0.0, 1e-12);
    EXPECT_LT(curve.at(0.0).height, -30.0);
  }
}

TEST(StandardProfiles, RailHeadWidths) {
  // Widths to the digits the sources print.
  const Curve rail = standard_profile("60E1").curve;
  EXPECT_NEAR(width(rail, 14.0), 71.96267, 1e-5);
  EXPECT_NEAR(width(rail, 14.3), 71.999626, 1e-6);
  EXPECT_NEAR(width(rail, 16.0), 72.169626, 1e-6);
  const Curve china = standard_profile("CHN60").curve;
  EXPECT_NEAR(width(china, 14.0), 70.763842, 1e-6);
  EXPECT_NEAR(width(china, 16.0), 70.966666, 1e-6);
  EXPECT_NEAR(2.0 * china.at(china.length()).lateral, 73.0, exact);
  const Curve manchester = standard_profile("UIC60-Manchester").curve;
  EXPECT_NEAR(width(manchester, 14.0), 71.968812, 1e-6);
  EXPECT_NEAR(width(manchester, 16.0), 72.174026, 1e-6);
}

/// A head by the rule of EN 13674-1: tangent arcs between break widths, then the side.
struct Head {
  std::string_view name;
  std::vector<double> radii;
  std::vector<double> break_widths;
  double side_slope;    ///< 1:side_slope from the vertical
  double fishing_slope; ///< 1:fishing_slope
  double apex;          ///< depth at which the fishing plane meets the axis
  Position tangent;     ///< published, round to four decimals
};

Position heading(double lateral, double depth) {
  const double norm = std::hypot(lateral, depth);
  return {lateral / norm, depth / norm};
}

TEST(StandardProfiles, HeadsFollowTheConstructionOfEn13674) {
  const std::vector<Head> heads = {
      {"60E1", {300, 80, 13}, {20.456, 52.053}, 20, 2.75, 51, {35.9998, 14.29996}},
      {"60E2", {200, 70, 16, 8}, {23.778, 48.913, 70.774}, 20, 2.75, 51, {35.9999, 14.3002}},
      {"54E1", {300, 80, 13}, {20.024, 49.727}, 20, 2.75, 49.4, {35.0001, 14.1001}},
      {"54E2", {300, 80, 13}, {18.946, 46.310}, 20, 2.75, 51.4, {33.505, 13.850}},
      {"54E3", {300, 80, 13}, {15.267, 46.835}, 17.2, 3, 55, {33.4999, 13.9999}},
      {"49E1", {300, 80, 13}, {15.267, 46.835}, 17.2, 3, 51.5, {33.4999, 13.9999}},
      {"56E1", {305, 80, 12.7}, {11.787, 51.235}, 20, 2.75, 49.21, {34.9251, 14.5301}},
      {"50E6", {200, 60, 13}, {30.942, 43.838}, 20, 3, 49, {32.5001, 13.5800}},
  };
  for (const Head& head : heads) {
    SCOPED_TRACE(head.name);
    const std::vector<Segment> all = standard_profile_segments(head.name);
    ASSERT_EQ(all.size(), 2 * (head.radii.size() + 1));
    const std::span<const Segment> right = std::span(all).last(head.radii.size() + 1);
    // Angle of the curve's normal from the vertical; arcs change it by asin of widths.
    double angle = 0.0;
    double lateral = 0.0;
    double depth = 0.0;
    for (std::size_t i = 0; i < head.radii.size(); ++i) {
      const double radius = head.radii[i];
      const double centre = lateral - radius * std::sin(angle);
      const double next = i < head.break_widths.size()
                              ? std::asin((0.5 * head.break_widths[i] - centre) / radius)
                              : std::atan2(head.side_slope, 1.0);
      lateral = centre + radius * std::sin(next);
      depth += radius * (std::cos(angle) - std::cos(next));
      angle = next;
      const auto& arc = std::get<ArcSegment>(right[i].shape);
      EXPECT_EQ(arc.radius, radius);
      EXPECT_NEAR(arc.centre[0], centre, exact);
      EXPECT_NEAR(arc.end[0], lateral, exact);
      EXPECT_NEAR(arc.end[1], -depth, exact);
    }
    EXPECT_NEAR(lateral, head.tangent[0], 6e-5);
    EXPECT_NEAR(depth, head.tangent[1], 6e-5);
    const auto& side = std::get<LineSegment>(right.back().shape);
    const Position along = heading(side.end[0] - side.start[0], side.end[1] - side.start[1]);
    const Position expected = heading(1.0, -head.side_slope);
    EXPECT_NEAR(along[0], expected[0], 1e-12);
    EXPECT_NEAR(along[1], expected[1], 1e-12);
    EXPECT_NEAR(-side.end[1], head.apex - side.end[0] / head.fishing_slope, exact);
  }
}

TEST(StandardProfiles, CornersOfTheRails) {
  const auto corner = [](std::string_view name) {
    const Curve curve = standard_profile(name).curve;
    return curve.at(curve.length());
  };
  EXPECT_NEAR(corner("60E1").lateral, 37.159191, 1e-6);
  EXPECT_NEAR(corner("60E1").height, -37.487567, 1e-6);
  EXPECT_NEAR(corner("CHN60").lateral, 36.5, exact);
  EXPECT_NEAR(corner("CHN60").height, -36.333333, 1e-6);
  EXPECT_NEAR(corner("UIC60-Manchester").lateral, 37.1614, 1e-4);
  EXPECT_NEAR(corner("UIC60-Manchester").height, -37.4868, 1e-4);
}

TEST(StandardProfiles, AFileOfAnotherSpellingComesFirst) {
  const std::filesystem::path before = std::filesystem::current_path();
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "wrcontact_names";
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  EXPECT_EQ(standard_name("s49", ProfileKind::rail), "49E1");
  std::ofstream("s49") << "0 0\n";
  std::ofstream("49E1") << "0 0\n";
  EXPECT_EQ(standard_name("s49", ProfileKind::rail), "");
  EXPECT_EQ(standard_name("S49", ProfileKind::rail), "49E1");
  EXPECT_EQ(standard_name("49E1", ProfileKind::rail), "49E1") << "its own name";
  std::filesystem::current_path(before);
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace wrc::test::standard_profiles_test
