/// Results of patches, of their parts, and sensitivities through the C interface.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <vector>

#include "all_results.hpp"

namespace patch_results_test {
namespace {

/// Sums over a few hundred elements.
constexpr double rounding = 1e-10;

/// A left wheel on tread and flange at once, with comparable forces.
ScenePointer solve_two_patches() {
  ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"track.rail", "56E1"},
            {"pose.lateral", 6.15},
            {"pose.yaw", 0.005},
            {"solve.side", "left"}});
  return scene;
}

TEST(Patches, AreNamedOneByOneWithTheirFields) {
  const ScenePointer scene = solve_two_patches();
  wrc_scene* s = scene.get();
  std::set<std::string> names;
  for (std::int64_t i = 0; i < wrc_scene_number_count(s); ++i) {
    names.insert(wrc_scene_number_name(s, i));
  }
  EXPECT_FALSE(names.contains("left.patches.2.pmax"));
  EXPECT_EQ(number_of(s, "left.patch_count"), 2.0);
  for (const std::string patch : {"left.patches.0.", "left.patches.1."}) {
    for (const std::string& name : words_of(
             "pmax pmax_element area normal_force vertical_force lateral_force "
             "longitudinal_force pressure_force.x pressure_force.y pressure_force.z "
             "pressure_moment.x pressure_moment.y pressure_moment.z approach angle "
             "semi_axes.longitudinal semi_axes.lateral radii.longitudinal radii.lateral "
             "coupling_weight regions fill grid.lateral grid.longitudinal "
             "element_size.lateral element_size.longitudinal x y z s_wheel w_wheel t_rail v_rail "
             "rolling_radius wheel_angle centroid.x centroid.y centroid.z "
             "centroid.s_wheel centroid.angle")) {
      EXPECT_TRUE(names.contains(patch + name)) << patch << name;
    }
    const auto number = [&](const char* name) { return number_of(s, (patch + name).c_str()); };
    EXPECT_EQ(number("regions"), 1.0);
    EXPECT_GE(number("coupling_weight"), 0.0);
    EXPECT_LE(number("coupling_weight"), 1.0);
    const auto size =
        static_cast<std::size_t>(number("grid.lateral") * number("grid.longitudinal"));
    for (const char* name : {"x", "y", "z", "undeformed_distance", "pressure", "displacement"}) {
      EXPECT_EQ(field_of(s, patch + name).size(), size) << patch << name;
    }
    const auto pressure = field_of(s, patch + "pressure");
    const double force = std::accumulate(pressure.begin(), pressure.end(), 0.0) *
                         number("element_size.lateral") * number("element_size.longitudinal");
    // Pressures push along the rail's normals, which differ: the amount of their sum is the force.
    EXPECT_NEAR(force, number("normal_force"), 1e-3 * force);
    EXPECT_EQ(*std::max_element(pressure.begin(), pressure.end()), number("pmax_element"));
  }
  for (const char* name : {"x", "pressure", "displacement"}) {
    EXPECT_EQ(field_of(s, std::string("left.") + name),
              field_of(s, std::string("left.patches.0.") + name));
  }
}

TEST(Patches, ForcesAndMomentsAddUp) {
  const ScenePointer scene = solve_two_patches();
  wrc_scene* s = scene.get();
  const auto number = [s](const std::string& name) { return number_of(s, name.c_str()); };
  const std::vector<std::string> patches{"left.patches.0.", "left.patches.1."};
  const double normal_force = number("left.normal_force");
  for (const char* name :
       {"normal_force", "vertical_force", "lateral_force", "longitudinal_force", "area"}) {
    const double sum = number(patches[0] + name) + number(patches[1] + name);
    EXPECT_NEAR(number(std::string("left.") + name), sum, rounding * normal_force) << name;
  }
  EXPECT_EQ(number("left.pmax"),
            std::max(number(patches[0] + "pmax"), number(patches[1] + "pmax")));
  EXPECT_GT(number(patches[0] + "normal_force"), number(patches[1] + "normal_force"));
  // Each has the direction that its angle says.
  constexpr double load_balance = 1e-4; // N
  EXPECT_NEAR(number("left.vertical_force"), 80000.0, load_balance);
  std::array<double, 3> moment{};
  for (const std::string& patch : patches) {
    const double force = number(patch + "normal_force");
    EXPECT_NEAR(number(patch + "vertical_force"), force * std::cos(number(patch + "angle")),
                rounding * force);
    EXPECT_NEAR(number(patch + "lateral_force"), -force * std::sin(number(patch + "angle")),
                rounding * force);
    const auto moment_at = [&](const std::string& place, const std::string& about) {
      const double x = number(place + "x") - number(about + "x");
      const double y = number(place + "y") - number(about + "y");
      const double z = number(place + "z") - number(about + "z");
      const double fx = number(patch + "longitudinal_force");
      const double fy = number(patch + "lateral_force");
      const double fz = number(patch + "vertical_force");
      return std::array{y * fz - z * fy, z * fx - x * fz, x * fy - y * fx};
    };
    // Nearly that of the force at the centroid: forces of places have directions of their own.
    const auto at_centroid = moment_at(patch + "centroid.", patch);
    const auto about_first = moment_at(patch, patches[0]);
    constexpr std::array names{"pressure_moment.x", "pressure_moment.y", "pressure_moment.z"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      EXPECT_NEAR(number(patch + names[i]), at_centroid[i], 0.03 * force) << patch << names[i];
      moment[i] += number(patch + names[i]) + about_first[i];
    }
  }
  EXPECT_NEAR(number("left.pressure_moment.x"), moment[0], rounding * 1e3 * normal_force);
  EXPECT_NEAR(number("left.pressure_moment.y"), moment[1], rounding * 1e3 * normal_force);
  EXPECT_NEAR(number("left.pressure_moment.z"), moment[2], rounding * 1e3 * normal_force);
  for (const char* name : {"x", "y", "z", "s_wheel", "w_wheel", "t_rail", "v_rail",
                           "rolling_radius", "wheel_angle", "angle"}) {
    double mean = 0.0;
    for (const std::string& patch : patches) {
      mean += number(patch + "normal_force") / normal_force * number(patch + "centroid." + name);
    }
    EXPECT_NEAR(number(std::string("left.centroid.") + name), mean,
                rounding * std::max(std::abs(mean), 1.0))
        << name;
  }
}

/// Two lobes some 6.5 mm apart that share a plane and a load.
ScenePointer solve_one_contact_of_two_parts() {
  ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"track.rail", "UIC60-Manchester"},
            {"solve.side", "right"},
            {"pose.lateral", -5.0},
            {"pose.roll", 0.0},
            {"load.both", 10000.0}});
  return scene;
}

TEST(PartsOfAPatch, MakeUpTheWhole) {
  const ScenePointer scene = solve_one_contact_of_two_parts();
  wrc_scene* s = scene.get();
  const auto number = [s](const std::string& name) { return number_of(s, name.c_str()); };
  const std::string whole = "right.patches.0.";
  const std::vector<std::string> parts{whole + "parts.0.", whole + "parts.1."};
  double value = 0.0;
  EXPECT_EQ(wrc_scene_number(s, "right.patches.1.pmax", &value), WRC_UNKNOWN_NAME);
  EXPECT_EQ(wrc_scene_number(s, (whole + "parts.2.pmax").c_str(), &value), WRC_UNKNOWN_NAME);
  EXPECT_EQ(wrc_scene_number(s, (parts[0] + "parts.0.pmax").c_str(), &value), WRC_UNKNOWN_NAME);
  const double force = number(whole + "normal_force");
  const double angle = number(whole + "plane_angle");
  EXPECT_GT(number(parts[0] + "normal_force"), number(parts[1] + "normal_force"));
  EXPECT_EQ(number(whole + "regions"), 2.0);
  EXPECT_EQ(number(whole + "coupling_weight"), 0.0);
  for (const char* name : {"vertical_force", "lateral_force", "area"}) {
    EXPECT_NEAR(number(whole + name), number(parts[0] + name) + number(parts[1] + name),
                rounding * force)
        << name;
  }
  // Parts have one plane, and forces of directions of their own.
  EXPECT_LT(force, number(parts[0] + "normal_force") + number(parts[1] + "normal_force"));
  for (const char* name : {"pmax", "pmax_element", "approach"}) {
    EXPECT_EQ(number(whole + name), std::max(number(parts[0] + name), number(parts[1] + name)));
  }
  const auto pressures_of = [&](const std::string& part) {
    const auto pressure = field_of(s, part + "pressure");
    return std::accumulate(pressure.begin(), pressure.end(), 0.0) *
           number(part + "element_size.lateral") * number(part + "element_size.longitudinal");
  };
  double moment = 0.0;
  double centre = 0.0;
  double pressures = 0.0;
  for (const std::string& part : parts) {
    EXPECT_EQ(number(part + "plane_angle"), angle);
    EXPECT_NE(number(part + "angle"), angle);
    EXPECT_EQ(number(part + "coupling_weight"), 1.0);
    const double y = number(part + "y") - number(whole + "y");
    const double z = number(part + "z") - number(whole + "z");
    moment += number(part + "pressure_moment.x") + y * number(part + "vertical_force") -
              z * number(part + "lateral_force");
    const double along = (number(part + "centroid.y") - number(whole + "y")) * std::cos(angle) +
                         (number(part + "centroid.z") - number(whole + "z")) * std::sin(angle);
    centre += pressures_of(part) * along;
    pressures += pressures_of(part);
  }
  centre /= pressures;
  EXPECT_NEAR(number(whole + "pressure_moment.x"), moment, 1e-3 * std::abs(moment));
  const double along = (number(whole + "centroid.y") - number(whole + "y")) * std::cos(angle) +
                       (number(whole + "centroid.z") - number(whole + "z")) * std::sin(angle);
  EXPECT_NEAR(along, centre, 1e-9);
  // The lobes are much farther apart than they are wide.
  EXPECT_GT(number(whole + "semi_axes.lateral"), 3.0 * number(parts[0] + "semi_axes.lateral"));
}

TEST(PartsOfAPatch, HaveTheirFieldsAndACombinedOne) {
  const ScenePointer scene = solve_one_contact_of_two_parts();
  wrc_scene* s = scene.get();
  const auto number = [s](const std::string& name) { return number_of(s, name.c_str()); };
  const auto force_of = [&](const std::string& patch) {
    const auto pressure = field_of(s, patch + "pressure");
    EXPECT_EQ(pressure.size(), static_cast<std::size_t>(number(patch + "grid.lateral") *
                                                        number(patch + "grid.longitudinal")));
    return std::accumulate(pressure.begin(), pressure.end(), 0.0) *
           number(patch + "element_size.lateral") * number(patch + "element_size.longitudinal");
  };
  const std::string whole = "right.patches.0.";
  for (const std::string& patch : {whole, whole + "parts.0.", whole + "parts.1."}) {
    EXPECT_NEAR(force_of(patch), number(patch + "normal_force"),
                0.015 * number(patch + "normal_force"))
        << patch;
  }
  EXPECT_NEAR(force_of(whole), force_of(whole + "parts.0.") + force_of(whole + "parts.1."),
              1e-9 * force_of(whole));
  // The elements of the part with the largest pressure are those of the whole.
  const auto pressure = field_of(s, whole + "pressure");
  EXPECT_NEAR(*std::max_element(pressure.begin(), pressure.end()), number(whole + "pmax_element"),
              1e-6 * number(whole + "pmax_element"));
  // Under pressure the gap is closed: undeformed distance + displacement = a constant, up to what
  // elements of another size make of the second part.
  const auto distance = field_of(s, whole + "undeformed_distance");
  const auto displacement = field_of(s, whole + "displacement");
  const double largest = *std::max_element(displacement.begin(), displacement.end());
  double least_gap = 1e9;
  double greatest_gap = -1e9;
  const double peak = *std::max_element(pressure.begin(), pressure.end());
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (pressure[i] > 0.1 * peak) {
      least_gap = std::min(least_gap, distance[i] + displacement[i]);
      greatest_gap = std::max(greatest_gap, distance[i] + displacement[i]);
    }
  }
  EXPECT_LT(greatest_gap - least_gap, 0.03 * largest);
  std::int64_t count = 5;
  for (const char* name : {"right.patches.0.parts.2.pressure", "right.patches.0.parts.pressure",
                           "right.patches.0.parts.0.parts.0.pressure"}) {
    EXPECT_EQ(wrc_scene_field(s, name, nullptr, 0, &count), WRC_UNKNOWN_NAME) << name;
  }
}

TEST(PartsOfAPatch, ExistOnlyWithAJoiningDistance) {
  const ScenePointer scene = solve_one_contact_of_two_parts();
  wrc_scene* s = scene.get();
  solve(s, {{"solve.joining_distance", 0.0}});
  double value = 0.0;
  EXPECT_EQ(wrc_scene_number(s, "right.patches.0.parts.0.pmax", &value), WRC_UNKNOWN_NAME);
  EXPECT_NEAR(number_of(s, "right.patches.1.coupling_weight"),
              std::cos(number_of(s, "right.patches.1.plane_angle") -
                       number_of(s, "right.patches.0.plane_angle")),
              rounding);
  EXPECT_GT(std::abs(number_of(s, "right.patches.1.angle") - number_of(s, "right.patches.0.angle")),
            0.1);
}

TEST(Patches, ResidualsIncludeDisplacementsByOtherPatches) {
  // Nodes of the interaction differ from those of the solution.
  constexpr double interpolation = 5e-3;
  const ScenePointer scene = solve_two_patches();
  wrc_scene* s = scene.get();
  EXPECT_LT(number_of(s, "left.residuals.complementarity"), interpolation);
  EXPECT_GT(number_of(s, "left.residuals.least_gap"), -interpolation);
  EXPECT_LT(number_of(s, "left.residuals.load_balance"), rounding);
}

TEST(Patches, AnUnknownIndexIsReportedWithItsName) {
  const ScenePointer scene = solve_two_patches();
  double value = 7.0;
  std::int64_t count = 5;
  for (const char* name :
       {"left.patches.2.pmax", "left.patches.-1.pmax", "left.patches.1", "left.patches.1.",
        "left.patches..pmax", "left.patches.x.pmax", "left.patches.0.centroid.distances",
        "left.patches.99999999999999999999.pmax", "left.near_contacts.99.s_wheel"}) {
    EXPECT_EQ(wrc_scene_number(scene.get(), name, &value), WRC_UNKNOWN_NAME) << name;
    EXPECT_TRUE(contains(wrc_scene_error(scene.get()), name)) << wrc_scene_error(scene.get());
  }
  for (const char* name : {"left.patches.2.pressure", "left.patches.-1.x", "left.patches.0",
                           "left.patches.0.", "left.patches.0.rail_y", "right.patches.0.x"}) {
    EXPECT_EQ(wrc_scene_field(scene.get(), name, nullptr, 0, &count), WRC_UNKNOWN_NAME) << name;
    EXPECT_TRUE(contains(wrc_scene_error(scene.get()), name)) << wrc_scene_error(scene.get());
  }
  EXPECT_EQ(value, 7.0);
  EXPECT_EQ(count, 5);
}

TEST(Patches, AreEmptyWithoutContact) {
  const ScenePointer scene = make_small_scene();
  wrc_scene* s = scene.get();
  solve(s, {{"pose.vertical", 500.0}});
  double value = 0.0;
  EXPECT_EQ(wrc_scene_number(s, "left.patches.0.pmax", &value), WRC_UNKNOWN_NAME);
  for (const char* name :
       {"left.area", "left.pressure_moment.x", "left.patch_count", "left.fill"}) {
    EXPECT_EQ(number_of(s, name), 0.0) << name;
  }
}

constexpr const char* sensitivity_names[] = {
    ".pressure_force.y.lateral", ".pressure_force.y.vertical", ".pressure_force.y.roll",
    ".pressure_force.z.lateral", ".pressure_force.z.vertical", ".pressure_force.z.roll",
};
constexpr const char* condensed_names[] = {
    ".at_load.pressure_force.y.lateral",
    ".at_load.pressure_force.y.roll",
    ".at_load.vertical.lateral",
    ".at_load.vertical.roll",
};

/// The wheelset at a position, its roll prescribed.
void solve_at(wrc_scene* scene, double lateral, double roll) {
  solve(scene,
        {{"solve.grid", std::vector{96.0, 64.0}}, {"pose.lateral", lateral}, {"pose.roll", roll}});
}

TEST(Sensitivities, SidesMirrorEachOther) {
  const ScenePointer left = make_scene();
  const ScenePointer right = make_scene();
  solve_at(left.get(), 4.0, 1e-3);
  solve_at(right.get(), -4.0, -1e-3);
  const auto expect_mirrored = [&](const std::string& name, double sign) {
    const double of_left = number_of(left.get(), ("left.sensitivities" + name).c_str());
    const double of_right = number_of(right.get(), ("right.sensitivities" + name).c_str());
    EXPECT_NE(of_left, 0.0) << name;
    EXPECT_EQ(of_right, sign * of_left) << name;
  };
  // Forces and motions across change their sign in the mirror, a roll does too.
  const double signs[] = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0};
  for (std::size_t i = 0; i < std::size(sensitivity_names); ++i) {
    expect_mirrored(sensitivity_names[i], signs[i]);
  }
  const double condensed_signs[] = {1.0, 1.0, -1.0, -1.0};
  for (std::size_t i = 0; i < std::size(condensed_names); ++i) {
    expect_mirrored(condensed_names[i], condensed_signs[i]);
  }
  // The wheel is pressed back; at constant load less sideways than at constant height.
  EXPECT_LT(number_of(left.get(), "left.sensitivities.pressure_force.z.vertical"), 0.0);
  EXPECT_LT(number_of(left.get(), "left.sensitivities.pressure_force.y.lateral"), 0.0);
}

TEST(Sensitivities, AtConstantLoadAgreeWithDifferences) {
  // The grid follows the contact from one position to the next: 1.8 % of the largest rate at most.
  constexpr double step = 2e-3;
  constexpr double arm = 750.0;
  constexpr double tolerance = 0.02;
  // At 5.6 mm a second lobe of a few elements has just begun: its stiffness is known to a tenth.
  for (const double lateral : {0.0, 3.0, 5.8}) {
    const ScenePointer scene = make_scene();
    wrc_scene* s = scene.get();
    solve_at(s, lateral, 5e-4);
    double found[4];
    for (std::size_t i = 0; i < std::size(condensed_names); ++i) {
      found[i] = number_of(s, (std::string("left.sensitivities") + condensed_names[i]).c_str());
    }
    const auto difference = [&](bool rolls, double (*value)(wrc_scene*)) {
      const double by = rolls ? step / arm : step;
      double values[2];
      for (const int end : {0, 1}) {
        const double change = end == 0 ? -by : by;
        solve_at(s, rolls ? lateral : lateral + change, rolls ? 5e-4 + change : 5e-4);
        values[end] = value(s);
      }
      return (values[1] - values[0]) / (2.0 * by);
    };
    const auto force = [](wrc_scene* of) { return number_of(of, "left.lateral_force"); };
    const auto height = [](wrc_scene* of) {
      return number_of(of, "left.vertical") - number_of(of, "left.depth");
    };
    const double largest_force = std::max(std::abs(found[0]), std::abs(found[1]) / arm);
    const double largest_height = std::max(std::abs(found[2]), std::abs(found[3]) / arm);
    EXPECT_NEAR(found[0], difference(false, force), tolerance * largest_force) << lateral;
    EXPECT_NEAR(found[1] / arm, difference(true, force) / arm, tolerance * largest_force)
        << lateral;
    EXPECT_NEAR(found[2], difference(false, height), tolerance * largest_height) << lateral;
    EXPECT_NEAR(found[3] / arm, difference(true, height) / arm, tolerance * largest_height)
        << lateral;
  }
}

} // namespace
} // namespace patch_results_test
