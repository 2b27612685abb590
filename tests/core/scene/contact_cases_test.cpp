// Cases computed by an independent boundary element program (CONTACT), tangent convention.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "keys/scene_keys.hpp"
#include "mechanics/normal_solver.hpp"
#include "remesh/undeformed_distance.hpp"
#include "scene/solve_scene.hpp"
#include "support/reference_data.hpp"

namespace wrc::test::contact_cases_test {
namespace {

/// Asked of pmax and approach of every patch; or the change that a lateral shift of this size
/// makes.
constexpr double tolerance = 0.005;
constexpr double shift = 0.01; // mm
/// The contact reference, mm, and the plane's angle, rad. Both programs weigh places with the
/// square of the penetration; CONTACT's figures are rounded to 1e-4.
constexpr double place_tolerance = 0.3;
constexpr double angle_tolerance = 0.002;
/// Of the forces of patches that share a load.
constexpr double share_tolerance = 0.01;
/// The built-in rail lies up to 4.4e-5 mm beside the points that CONTACT has read. That is a
/// fifteenth of the approach of the small patch in this case, which has to be computed from
/// those points.
constexpr const char* delicate_case = "extreme-160";

Scene scene_of(const nlohmann::json& entry) {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = entry.at("rail");
  scene.left.wheel.name = scene.right.wheel.name = entry.at("wheel");
  set_text(scene, "track.inclination", entry.at("cant").get<std::string>());
  scene.track.gauge = entry.at("gauge_mm");
  scene.track.gauge_height = entry.at("gauge_height_mm");
  scene.back_to_back = entry.at("back_to_back_mm");
  scene.tape_offset = entry.at("tape_offset_mm");
  scene.left.radius = scene.right.radius = entry.at("wheel_radius_mm");
  scene.wheel_material =
      scene.rail_material = {entry.at("youngs_modulus_MPa"), entry.at("poisson")};
  scene.side = entry.at("side") == "left" ? SideChoice::left : SideChoice::right;
  scene.lateral = entry.at("lateral_mm");
  scene.yaw = entry.at("yaw_rad");
  scene.roll = entry.at("roll_rad").get<double>();
  scene.left.load = scene.right.load = entry.at("vertical_load_N");
  scene.accuracy = 3e-4;
  scene.interaction = Interaction::near; // CONTACT's rule
  return scene;
}

/// What CONTACT tells of a patch.
struct Told {
  double pmax = 0.0;     ///< largest element value
  double approach = 0.0; ///< along the normal, at the element centre with the least distance
  double normal_force = 0.0;
};

/// The elements of CONTACT: squares of constant pressure, one of them centred at the contact
/// reference, over the potential contact area of a patch.
Grid equal_grid(const Grid& area, double element) {
  const auto around = [element](double first, double step, std::size_t count) {
    const double begin = std::floor((first - 0.5 * step) / element);
    const double end = std::ceil((first + (static_cast<double>(count) - 0.5) * step) / element);
    return std::pair(begin * element, static_cast<std::size_t>(end - begin) + 1);
  };
  const auto [lateral, rows] = around(area.lateral_first, area.lateral_step, area.lateral_count);
  const auto [longitudinal, columns] =
      around(area.longitudinal_first, area.longitudinal_step, area.longitudinal_count);
  return {rows, columns, element, element, lateral, longitudinal};
}

double deepest_overlap(const PatchGap& gap, double approach) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < gap.shares.size(); ++i) {
    deepest = std::max(deepest, gap.shares[i] * approach - gap.undeformed_distance[i]);
  }
  return deepest;
}

/// The scene, with all of its patches on CONTACT's elements at the depth found.
std::vector<Told> solve_on_equal_grids(const Scene& scene, double element, double load,
                                       WheelResult& side) {
  SceneResult result = solve_scene(scene);
  side = std::move(result.left ? *result.left : *result.right);
  const WheelDetails& details = side.details;
  const PosedPair pair{*details.wheel, *details.rail, details.pose, side.vertical - side.depth};
  std::vector<std::vector<double>> distances;
  std::vector<std::vector<double>> shares;
  std::vector<PatchGap> gaps;
  for (const PatchResult* patch : solved_patches(side)) {
    const Grid grid = equal_grid(patch->grid, element);
    distances.push_back(sample_undeformed_distance(pair, patch->frame, grid));
    shares.push_back(RailNormals(*details.rail, patch->frame, grid).shares({0.0, 0.0, 1.0}));
    gaps.push_back({grid, {}});
  }
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    gaps[k].undeformed_distance = distances[k];
    gaps[k].shares = shares[k];
  }
  NormalProblem problem;
  problem.patches = gaps;
  problem.combined_modulus = details.request.combined_modulus;
  problem.load = load;
  problem.interaction = details.interaction ? &*details.interaction : nullptr;
  const NormalSolution solution = NormalSolver().solve(problem);
  std::vector<Told> told;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const std::vector<double>& pressure = solution.patches[k].pressure;
    told.push_back({*std::max_element(pressure.begin(), pressure.end()),
                    deepest_overlap(gaps[k], solution.approach), solution.patches[k].normal_force});
  }
  return told;
}

/// The reference's patches, largest force first.
std::vector<nlohmann::json> ordered_patches(const nlohmann::json& entry) {
  std::vector<nlohmann::json> patches = entry.at("patches");
  std::stable_sort(patches.begin(), patches.end(), [](const auto& one, const auto& other) {
    return one.at("normal_force_N").template get<double>() >
           other.at("normal_force_N").template get<double>();
  });
  return patches;
}

TEST(ContactCases, AllAgree) {
  const nlohmann::json cases = reference_data("contact_cases.json").at("cases");
  EXPECT_EQ(cases.size(), 23u);
  for (const auto& entry : cases) {
    const std::string id = entry.at("id");
    SCOPED_TRACE(id);
    Scene scene = scene_of(entry);
    if (id == delicate_case) {
      scene.left.rail.name = scene.right.rail.name =
          reference_file("profiles/UIC60-Manchester.txt").string();
      scene.track.inclination = 0.0; // already in the points
    }
    const double element = entry.at("element_mm");
    const double load = entry.at("vertical_load_N");
    WheelResult side;
    const std::vector<Told> told = solve_on_equal_grids(scene, element, load, side);
    const auto patches = ordered_patches(entry);
    ASSERT_EQ(side.patches.size(), patches.size());
    ASSERT_EQ(told.size(), patches.size()) << "a patch of several parts";
    EXPECT_NEAR(side.force.z, entry.at("total_vertical_force_N").get<double>(),
                1e-6 * side.force.z);
    // Changes made by a shift to either side.
    std::vector<Told> change(patches.size());
    for (const double sign : {-1.0, 1.0}) {
      Scene shifted = scene;
      shifted.lateral += sign * shift;
      WheelResult other_side;
      const std::vector<Told> other = solve_on_equal_grids(shifted, element, load, other_side);
      for (std::size_t k = 0; k < std::min(patches.size(), other.size()); ++k) {
        change[k].pmax = std::max(change[k].pmax, std::abs(other[k].pmax - told[k].pmax));
        change[k].approach =
            std::max(change[k].approach, std::abs(other[k].approach - told[k].approach));
      }
    }
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const auto value = [&](const char* name) { return patches[k].at(name).get<double>(); };
      const PatchResult& patch = side.patches[k];
      const double pmax = value("pmax_MPa");
      const double approach = value("approach_mm");
      const double force = value("normal_force_N");
      EXPECT_NEAR(told[k].pmax, pmax, std::max(tolerance * pmax, change[k].pmax));
      EXPECT_NEAR(told[k].approach, approach, std::max(tolerance * approach, change[k].approach));
      EXPECT_NEAR(told[k].normal_force, force, share_tolerance * force);
      EXPECT_NEAR(patch.reference.y, value("y_track_mm"), place_tolerance);
      EXPECT_NEAR(patch.reference.z, value("z_track_mm"), place_tolerance);
      EXPECT_NEAR(patch.reference.s_wheel, value("s_wheel_mm"), place_tolerance);
      // CONTACT states the plane.
      EXPECT_NEAR(patch.plane_angle, value("contact_angle_rad"), angle_tolerance);
    }
    // On the right wheel the rail pushes to the left: positive in both conventions.
    const double lateral = entry.at("total_lateral_force_N_right_positive");
    EXPECT_GT(side.force.y * lateral, 0.0);
  }
}

} // namespace
} // namespace wrc::test::contact_cases_test
