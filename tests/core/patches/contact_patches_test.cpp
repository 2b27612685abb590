#include "patches/contact_patches.hpp"

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "geometry/wheelset_equilibrium.hpp"
#include "patches/contact_patch.hpp"
#include "patches/patch_finder.hpp"
#include "support/reference_data.hpp"
#include "support/simple_profiles.hpp"

namespace wrc::test::contact_patches_test {
namespace {

/// Of two lobes or patches: signed separation and the difference of their angles.
double coupling_weight_of(double separation, double angle_difference) {
  return smoothstep(patch_finding::affinity(separation, angle_difference));
}

constexpr double wheel_radius = 460.0;
constexpr Interaction near_ones = Interaction::near;

SideEquilibrium equilibrium_of(const WheelSurface& wheel, const RailSurface& rail, double lateral,
                               double yaw = 0.0, double roll = 0.0) {
  EquilibriumRequest request;
  request.lateral = lateral;
  request.yaw = yaw;
  request.roll = roll;
  request.right = false;
  return *find_equilibrium({wheel, rail}, {wheel, rail}, request).left;
}

ContactScan scan_of(const Profile& wheel, const Profile& rail, double lateral) {
  return equilibrium_of(WheelSurface(wheel, {1360.0, 70.0, wheel_radius}),
                        RailSurface(rail, {1435.0, 14.0, rail.name == "circle" ? 0.0 : 0.025}),
                        lateral)
      .scan;
}

/// A scan made up: distance and slope of the rail over y from 0 to 40 mm. The nearest node is the
/// first contact.
ContactScan made_up(const std::function<double(double)>& distance,
                    const std::function<double(double)>& slope, double spacing = 0.4) {
  ContactScan scan;
  for (double y = 0.0; y <= 40.0; y += spacing) {
    constexpr double near = 1e-5;
    scan.samples.push_back({{{0.0, y, 0.0}, y, 1.0 / wheel_radius},
                            distance(y),
                            slope(y),
                            0.0,
                            0.0,
                            (distance(y + near) - distance(y - near)) / (2.0 * near)});
  }
  const auto nearest =
      std::min_element(scan.samples.begin(), scan.samples.end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; });
  ContactCandidate contact;
  contact.wheel.position = nearest->wheel.position;
  contact.wheel.lateral = nearest->wheel.lateral;
  contact.wheel.normal_curvature = nearest->wheel.normal_curvature;
  contact.distance = nearest->distance;
  contact.rail_angle = nearest->rail_angle();
  scan.candidates.push_back(contact);
  return scan;
}

struct Bowl {
  double y;
  double bottom;
};

/// The lowest of several parabolas with a radius of 100 mm.
ContactScan bowls(const std::vector<Bowl>& all, const std::function<double(double)>& slope) {
  return made_up(
      [&](double y) {
        double least = 1e9;
        for (const Bowl& bowl : all) {
          least = std::min(least, bowl.bottom + (y - bowl.y) * (y - bowl.y) / 200.0);
        }
        return least;
      },
      slope);
}

double flat(double /*y*/) {
  return 0.0;
}

void expect_sound(const ContactPatches& found) {
  ASSERT_FALSE(found.patches.empty());
  ASSERT_LT(found.main, found.patches.size());
  ASSERT_EQ(found.links.size() + 1, found.patches.size());
  double shares = 0.0;
  for (std::size_t k = 0; k < found.patches.size(); ++k) {
    const ContactPatch& patch = found.patches[k];
    shares += patch.weight;
    EXPECT_LE(patch.y_first, patch.contact_first);
    EXPECT_LE(patch.contact_first, patch.contact_last);
    EXPECT_LE(patch.contact_last, patch.y_last);
    EXPECT_LE(patch.y_first, patch.mean_y + 1e-9);
    EXPECT_GE(patch.y_last, patch.mean_y - 1e-9);
    EXPECT_LE(patch.limit_first, patch.y_first);
    EXPECT_GE(patch.limit_last, patch.y_last);
    EXPECT_GT(patch.deepest, 0.0);
    EXPECT_LE(patch.deepest, found.patches[found.main].deepest);
    EXPECT_TRUE(std::isfinite(patch.angle));
    EXPECT_TRUE(std::isfinite(patch.half_length));
    if (k > 0) {
      EXPECT_GE(found.links[k - 1], 0.0);
      EXPECT_LT(found.links[k - 1], 1.0);
      EXPECT_EQ(patch.limit_first, found.patches[k - 1].limit_last);
    }
  }
  EXPECT_NEAR(shares, 1.0, 1e-12);
}

double mean_angle(const ContactPatches& found) {
  return std::accumulate(
      found.patches.begin(), found.patches.end(), 0.0,
      [](double sum, const ContactPatch& patch) { return sum + patch.weight * patch.angle; });
}

TEST(ContactPatches, ParabolasInClosedForm) {
  // Half axes sqrt(2 r d) and sqrt(2 R d). Circles are not parabolas, and penetration is linear
  // between nodes: some 1e-3.
  const ContactScan scan = scan_of(cylindrical_wheel(), circular_rail(300.0), 0.0);
  for (const double depth : {1e-12, 1e-6, 1e-4, 1e-2, 0.1}) {
    SCOPED_TRACE(depth);
    const ContactPatches found = find_contact_patches(scan, depth);
    expect_sound(found);
    ASSERT_EQ(found.patches.size(), 1u);
    const ContactPatch& patch = found.patches[0];
    const double half_width = std::sqrt(2.0 * 300.0 * depth);
    EXPECT_NEAR(patch.y_last - patch.y_first, 2.0 * half_width, 0.02 * half_width);
    EXPECT_NEAR(patch.contact_last - patch.contact_first, std::sqrt(0.55) * 2.0 * half_width,
                0.02 * half_width);
    EXPECT_NEAR(patch.half_length, std::sqrt(2.0 * wheel_radius * depth), 1e-3 * patch.half_length);
    EXPECT_NEAR(patch.angle, 0.0, 1e-4);
    EXPECT_NEAR(patch.mean_y, 752.5, 2e-2 * half_width + 1e-9);
    EXPECT_EQ(patch.deepest, depth);
    EXPECT_EQ(patch.weight, 1.0);
  }
}

TEST(ContactPatches, WeightIsTheSquareOfThePenetration) { // parabola, slope grows linearly
  const ContactPatches found =
      find_contact_patches(bowls({{20.0, 0.0}}, [](double y) { return 0.01 * (y - 20.0); }), 0.08);
  EXPECT_NEAR(found.patches[0].mean_y, 20.0, 1e-6);
  EXPECT_NEAR(found.patches[0].angle, 0.0, 1e-6);
  const double half = 0.5 * (found.patches[0].y_last - found.patches[0].y_first);
  EXPECT_NEAR(found.patches[0].deviation, 0.01 * half / std::sqrt(8.0), 1e-5);
  // A wedge, penetration d (1 - t) over 0 < t < 1: int t (1 - t)^2.5 / int (1 - t)^2.5 = 1 / 4.5.
  const ContactScan wedge =
      made_up([](double y) { return y < 10.0 ? 10.0 - y : 0.01 * (y - 10.0); }, flat, 0.1);
  EXPECT_NEAR(find_contact_patches(wedge, 0.1).patches[0].mean_y, 10.0 + 10.0 / 4.5, 0.1);
}

TEST(ContactPatches, OnlyTheFirstContactWithoutSamples) {
  ContactScan scan = scan_of(standard_profile("S1002"), standard_profile("60E1"), 3.0);
  scan.samples.clear();
  const ContactPatches found = find_contact_patches(scan, 0.1);
  expect_sound(found);
  EXPECT_DOUBLE_EQ(found.patches[0].angle, scan.candidates.front().rail_angle);
}

TEST(ContactPatches, AnyDepth) {
  std::vector<ContactScan> scans;
  for (const double lateral : {-30.0, -10.0, 0.0, 5.0, 6.3, 8.0}) {
    scans.push_back(scan_of(standard_profile("S1002"), standard_profile("60E1"), lateral));
  }
  scans.push_back(scan_of(wheel_with_flank(), circular_rail(300.0), -1.35));
  // The rail's edge under the tread: contact at the end of what the wheel can see.
  scans.push_back(made_up([](double y) { return 0.05 * y; }, flat));
  scans.push_back(made_up([](double y) { return 0.05 * (40.0 - y); }, flat));
  for (const ContactScan& scan : scans) {
    for (double depth = 1e-300; depth <= 50.0; depth *= depth < 1e-12 ? 1e12 : 1.5) {
      SCOPED_TRACE(depth);
      expect_sound(find_contact_patches(scan, depth));
    }
  }
}

TEST(ContactPatches, LobesInOnePlaneByTheirDistance) {
  // Two equal bowls: half widths sqrt(200 d) = 4 mm each.
  constexpr double depth = 0.08;
  const auto found_at = [](double distance) {
    return find_contact_patches(bowls({{10.0, 0.0}, {10.0 + distance, 0.0}}, flat), depth);
  };
  EXPECT_EQ(found_at(7.6).patches.size(), 1u); // over a valley
  EXPECT_EQ(found_at(8.4).patches.size(), 1u); // D = 0.05
  const ContactPatches near = found_at(10.4);  // D = 0.3
  expect_sound(near);
  ASSERT_EQ(near.patches.size(), 2u);
  EXPECT_NEAR(near.coupling_weight(0, 1, near_ones), 0.5, 0.05);
  EXPECT_EQ(near.coupling_weight(1, 1, near_ones), 1.0);
  const ContactPatches far = found_at(12.4); // D = 0.55
  ASSERT_EQ(far.patches.size(), 2u);
  EXPECT_EQ(far.coupling_weight(0, 1, near_ones), 0.0);
  EXPECT_NEAR(far.patches[0].limit_last, 16.2, 0.05);
  EXPECT_NEAR(far.patches[0].weight, 0.5, 0.02);
}

TEST(ContactPatches, TurnAndInteractByTheirDistanceInMillimetres) {
  // Two bowls of half widths sqrt(200 d) = 4 and sqrt(200 (d - 0.06)) = 2 mm, planes 0.1 rad apart:
  // independent by their widths when penetrations are 4 mm apart or more.
  constexpr double depth = 0.08;
  constexpr double joining_distance = 1.6;
  constexpr double nodes = 0.1; // mm; penetrations end between nodes
  const auto found_at = [](double distance) {
    const double border = 14.0 + 0.5 * distance;
    const auto slope = [border](double y) { return y < border ? 0.0 : std::tan(0.1); };
    return find_contact_patches(bowls({{10.0, 0.0}, {16.0 + distance, 0.06}}, slope), depth,
                                {joining_distance});
  };
  for (const double distance : {4.0, 4.4, 4.7, 5.2}) {
    SCOPED_TRACE(distance);
    const ContactPatches found = found_at(distance);
    expect_sound(found);
    ASSERT_EQ(found.patches.size(), 2u);
    const ContactPatch& one = found.patches[0];
    const ContactPatch& other = found.patches[1];
    const double apart = other.y_first - one.y_last;
    EXPECT_NEAR(apart, distance, nodes);
    const double turned = std::clamp(3.0 - apart / joining_distance, 0.0, 1.0);
    const double mean = one.weight * one.angle_unturned + other.weight * other.angle_unturned;
    EXPECT_NEAR(one.angle, one.angle_unturned + turned * (mean - one.angle_unturned), 1e-4);
    EXPECT_NEAR(other.angle, other.angle_unturned + turned * (mean - other.angle_unturned), 1e-4);
    EXPECT_EQ(found.coupling_weight(0, 1, near_ones), 0.0);
    EXPECT_FALSE(other.shares_plane_with_previous);
  }
  for (const double distance : {2.0, 2.6, 3.0}) { // close by their widths, too
    SCOPED_TRACE(distance);
    const ContactPatches found = found_at(distance);
    ASSERT_EQ(found.patches.size(), 2u);
    EXPECT_TRUE(found.patches[1].shares_plane_with_previous);
    EXPECT_FALSE(found.patches[0].shares_plane_with_previous);
    EXPECT_EQ(found.patches[0].angle, found.patches[1].angle);
    const double apart = found.patches[1].y_first - found.patches[0].y_last;
    const double by_width = coupling_weight_of(apart / 8.0, 0.1);
    EXPECT_NEAR(found.coupling_weight(0, 1, near_ones),
                std::max(by_width, std::clamp(2.0 - apart / joining_distance, 0.0, 1.0)), 0.03);
  }
  EXPECT_NE(found_at(3.6).patches[0].angle, found_at(3.6).patches[1].angle);
}

TEST(ContactPatches, DistanceDoesNotTurnPlanesThatDifferMuch) {
  const auto bend = [](double y) { return y < 16.0 ? 0.0 : std::tan(0.4); };
  const ContactScan scan = bowls({{10.0, 0.0}, {20.0, 0.0}}, bend);
  const ContactPatches near = find_contact_patches(scan, 0.08, {10.0});
  const ContactPatches alone = find_contact_patches(scan, 0.08);
  ASSERT_EQ(near.patches.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(near.patches[k].angle, alone.patches[k].angle);
    EXPECT_FALSE(near.patches[k].shares_plane_with_previous);
  }
  EXPECT_EQ(near.links, alone.links);
}

TEST(ContactPatches, LobesInDifferentPlanesStayApart) {
  // As before but over a valley of half the depth, with planes 0.4 rad apart.
  const auto bend = [](double y) { return y < 12.8 ? 0.0 : std::tan(0.4); };
  const ContactScan scan = bowls({{10.0, 0.0}, {15.6, 0.0}}, bend);
  const ContactPatches found = find_contact_patches(scan, 0.08);
  expect_sound(found);
  ASSERT_EQ(found.patches.size(), 2u);
  EXPECT_GT(found.coupling_weight(0, 1, near_ones), 0.0);
  const double own_difference = found.patches[1].angle_unturned - found.patches[0].angle_unturned;
  const double difference = found.patches[1].angle - found.patches[0].angle;
  EXPECT_NEAR(own_difference, 0.4, 0.01);
  // angle = own + w (mean - own)
  EXPECT_NEAR(difference, (1.0 - found.coupling_weight(0, 1, near_ones)) * own_difference, 1e-12);
  // Crown and flank of 60 degrees, 35 mm apart.
  const ContactScan corner = scan_of(wheel_with_flank(), circular_rail(300.0), -1.35);
  EXPECT_EQ(find_contact_patches(corner, 0.03).patches.size(), 1u);
  const ContactPatches deep = find_contact_patches(corner, 0.1);
  ASSERT_EQ(deep.patches.size(), 2u);
  EXPECT_EQ(deep.main, 1u);
  EXPECT_EQ(deep.coupling_weight(0, 1, near_ones), 0.0);
  EXPECT_NEAR(deep.coupling_weight(0, 1, Interaction::all),
              std::cos(deep.patches[0].angle - deep.patches[1].angle), 1e-15);
  EXPECT_NEAR(deep.patches[0].deepest_s, -31.15, 0.5);
}

TEST(ContactPatches, CouplingWeightOfAChainIsThatOfItsWeakestLink) {
  const auto curved = [](double y) { return 0.005 * y; };
  const ContactPatches found = find_contact_patches(
      bowls({{5.0, 0.0}, {15.2, 0.0}, {26.0, 0.0}}, curved), 0.08); // D = 0.28 and 0.35
  expect_sound(found);
  ASSERT_EQ(found.patches.size(), 3u);
  EXPECT_GT(found.coupling_weight(0, 1, near_ones), found.coupling_weight(1, 2, near_ones));
  EXPECT_GT(found.coupling_weight(1, 2, near_ones), 0.0);
  EXPECT_EQ(found.coupling_weight(2, 0, near_ones), found.coupling_weight(1, 2, near_ones));
  // Turning moves planes together and leaves their weighted mean alone.
  double own = 0.0;
  for (const ContactPatch& patch : found.patches) {
    own += patch.weight * patch.angle_unturned;
  }
  EXPECT_NEAR(mean_angle(found), own, 1e-5);
  EXPECT_GT(found.patches[0].angle, found.patches[0].angle_unturned);
  EXPECT_LT(found.patches[2].angle, found.patches[2].angle_unturned);
}

TEST(ContactPatches, RoughProfileIsOnePatch) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(0.0, 0.02);
  const ContactScan scan =
      made_up([&](double y) { return (y - 20.0) * (y - 20.0) / 600.0 + noise(random); },
              [](double y) { return 0.002 * (y - 20.0); }, 0.05);
  const ContactPatches found = find_contact_patches(scan, 0.1);
  expect_sound(found);
  EXPECT_EQ(found.patches.size(), 1u);
  for (double depth = 1e-6; depth < 0.1; depth *= 1.1) {
    expect_sound(find_contact_patches(scan, depth));
  }
}

TEST(ContactPatches, CouplingWeightFallsWithSeparationAndAngle) {
  EXPECT_EQ(coupling_weight_of(0.1, 0.0), 1.0);
  EXPECT_EQ(coupling_weight_of(0.5, 0.0), 0.0);
  EXPECT_EQ(coupling_weight_of(-0.8, 0.5), coupling_weight_of(-0.8, -0.5));
  EXPECT_LT(coupling_weight_of(-0.8, 0.5), 1.0);
  EXPECT_EQ(coupling_weight_of(-1.0, 0.5), 1.0);
  EXPECT_EQ(coupling_weight_of(0.0, 0.5), 0.0);
  for (double separation = -1.0; separation < 1.0; separation += 0.01) {
    for (double angle = 0.0; angle < 0.5; angle += 0.01) {
      EXPECT_LE(coupling_weight_of(separation + 0.01, angle),
                coupling_weight_of(separation, angle));
      EXPECT_LE(coupling_weight_of(separation, angle + 0.01),
                coupling_weight_of(separation, angle));
    }
  }
}

struct DepthSweep {
  const char* wheel;
  const char* rail;
  double lateral;
};

class ContinuousInDepth : public testing::TestWithParam<DepthSweep> {};

/// Per step of 1 % in depth. A second lobe of a tenth of a radian to the side that takes over half
/// of the weight does so over about half of the depth; coupling weight goes from 0 to 1 while a gap
/// of half a width closes, which the flat valleys of worn-shaped profiles do within some per cent.
constexpr double largest_mean_step = 2e-3;
/// A step cut into 50 must come down to steps that are much smaller: what jumps does not.
constexpr int cuts = 50;
constexpr double largest_part = 0.25;
constexpr double small_step = 0.01;

TEST_P(ContinuousInDepth, AnglesAndCouplingWeights) {
  const DepthSweep& c = GetParam();
  const ContactScan scan = scan_of(standard_profile(c.wheel), standard_profile(c.rail), c.lateral);
  const auto link = [](const ContactPatches& found) {
    return found.links.empty() ? 1.0 : found.links[0];
  };
  ContactPatches before = find_contact_patches(scan, 1e-4);
  double depth_before = 1e-4;
  for (double depth = 1.01e-4; depth < 0.3; depth *= 1.01) {
    const ContactPatches found = find_contact_patches(scan, depth);
    expect_sound(found);
    EXPECT_LE(found.patches.size(), 2u);
    EXPECT_LT(std::abs(mean_angle(found) - mean_angle(before)), largest_mean_step) << depth;
    const bool born = found.patches.size() > before.patches.size();
    const double step = std::abs(link(found) - link(before));
    if (!born && step > small_step) {
      double largest = 0.0;
      ContactPatches last = before;
      for (int cut = 1; cut <= cuts; ++cut) {
        const ContactPatches here =
            find_contact_patches(scan, std::lerp(depth_before, depth, cut / double(cuts)));
        largest = std::max(largest, std::abs(link(here) - link(last)));
        last = here;
      }
      EXPECT_LT(largest, largest_part * step + 1e-6) << depth;
    }
    before = found;
    depth_before = depth;
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, ContinuousInDepth,
                         testing::Values(DepthSweep{"S1002", "UIC60-Manchester", 5.0},
                                         DepthSweep{"S1002", "60E1", 5.0},
                                         DepthSweep{"S1002", "60E1", 5.5},
                                         DepthSweep{"S1002", "60E1", 0.0},
                                         DepthSweep{"LMA", "CHN60", 5.0}));

TEST(ContactPatches, AreaStaysInItsTerritory) {
  const WheelSurface wheel(standard_profile("S1002"), {1360.0, 70.0, wheel_radius});
  const RailSurface rail(standard_profile("UIC60-Manchester"), {1435.0, 14.0, 0.025});
  const SideEquilibrium equilibrium = equilibrium_of(wheel, rail, 5.0);
  const ContactPatches found = find_contact_patches(equilibrium.scan, 0.03);
  ASSERT_EQ(found.patches.size(), 2u);
  for (const ContactPatch& patch : found.patches) {
    const Vector3 origin{patch.mean_x, patch.mean_y,
                         rail.graph().heights().at(patch.mean_y).height};
    const ContactFrame frame = tangent_frame(origin, patch.angle);
    const PlaneArea area = area_of(patch, rail, frame);
    EXPECT_NEAR(area.width(), (patch.y_last - patch.y_first) / std::cos(patch.angle),
                0.05 * area.width());
    EXPECT_NEAR(area.length(), patch.x_last - patch.x_first, 1e-9);
    const PlaneArea inside = within_limits(area, patch, rail, frame);
    EXPECT_EQ(inside.lateral_first, area.lateral_first);
    EXPECT_EQ(inside.lateral_last, area.lateral_last);
    const PlaneArea clamped = within_limits(area.widened(20.0), patch, rail, frame);
    const bool first = &patch == found.patches.data();
    const double edge = first ? clamped.lateral_last : clamped.lateral_first;
    const double height =
        rail.graph().heights().at(first ? patch.limit_last : patch.limit_first).height;
    const Vector3 place{origin.x, first ? patch.limit_last : patch.limit_first, height};
    EXPECT_NEAR(edge, dot(place - origin, frame.lateral), 1e-9);
    EXPECT_GT(clamped.width(), area.width());
    ContactPatch beyond = patch; // under yaw as a whole
    beyond.limit_first = patch.y_last + 1.0;
    EXPECT_NEAR(within_limits(area, beyond, rail, frame).width(), 1e-3 * area.length(), 1e-12);
  }
}

/// CONTACT prints angles to 1e-4 rad and samples profiles at steps of its own; it weighs with the
/// vertical penetration, which differs from the normal one on curved flanks.
constexpr double angle_tolerance = 1.5e-3;
constexpr double place_tolerance = 0.06;

TEST(ContactPatches, PlanesAgreeWithAnIndependentProgram) {
  const nlohmann::json reference = reference_data("contact_cases.json");
  for (const auto& entry : reference.at("cases")) {
    SCOPED_TRACE(entry.at("id").get<std::string>());
    const double cant = std::stod(entry.at("cant").get<std::string>().substr(2)); // "1:40"
    const WheelSurface wheel(
        standard_profile(entry.at("wheel").get<std::string>()),
        {entry.at("back_to_back_mm"), entry.at("tape_offset_mm"), entry.at("wheel_radius_mm")});
    const RailSurface rail(
        standard_profile(entry.at("rail").get<std::string>()),
        {entry.at("gauge_mm"), entry.at("gauge_height_mm"), std::atan(1.0 / cant)});
    // All on the right: mirrored.
    ASSERT_EQ(entry.at("side"), "right");
    const SideEquilibrium equilibrium =
        equilibrium_of(wheel, rail, -entry.at("lateral_mm").get<double>(),
                       -entry.at("yaw_rad").get<double>(), -entry.at("roll_rad").get<double>());
    const auto& first = entry.at("patches").at(0);
    const double angle = -first.at("contact_angle_rad").get<double>();
    const double depth = first.at("approach_mm").get<double>() / std::cos(angle);
    const ContactPatches found = find_contact_patches(equilibrium.scan, depth);
    expect_sound(found);
    ASSERT_EQ(found.patches.size(), entry.at("patches").size());
    const ContactPatch& main = found.patches[found.main];
    EXPECT_NEAR(main.angle, angle, angle_tolerance);
    EXPECT_NEAR(main.mean_y, -first.at("y_track_mm").get<double>(), place_tolerance);
    EXPECT_NEAR(main.mean_s, first.at("s_wheel_mm").get<double>(), place_tolerance);
    EXPECT_NEAR(rail.graph().heights().at(main.mean_y).height, first.at("z_track_mm").get<double>(),
                place_tolerance);
    if (found.patches.size() == 2) {
      // The program turns the small plane towards the other one; places do not depend on that.
      const auto& second = entry.at("patches").at(1);
      EXPECT_EQ(found.coupling_weight(0, 1, near_ones), 0.0);
      EXPECT_NEAR(found.patches[0].mean_y, -second.at("y_track_mm").get<double>(), place_tolerance);
    }
  }
}

} // namespace
} // namespace wrc::test::contact_patches_test
