#include "scene/solve_scene.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>

#include "error.hpp"
#include "profile/readers.hpp"

namespace wrc {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
}

/// A built-in profile by name, or else a file of that name.
Profile load_profile(const std::string& name, ProfileKind kind, double smoothing,
                     const std::string& key, std::vector<std::string>& corrections) {
  const auto names = standard_profile_names(kind);
  if (std::find(names.begin(), names.end(), name) != names.end()) {
    if (smoothing > 0.0) {
      throw_invalid_argument(key + "_smoothing", smoothing,
                             "allowed is 0 with a built-in profile, which is exact");
    }
    return standard_profile(name);
  }
  try {
    ReadOptions options;
    options.kind = kind;
    options.smoothing_wavelength = smoothing;
    ReadResult read = read_profile(name, options);
    for (const std::string& correction : read.corrections) {
      corrections.push_back(name);
      corrections.back().append(": ").append(correction);
    }
    return std::move(read.profile);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::file_unreadable) {
      throw;
    }
    std::string text = key + " = \"" + name + "\": allowed is a profile file or one of";
    for (const auto known : names) {
      text += ' ';
      text += known;
    }
    throw Error(ErrorCode::unknown_name, text + " (" + error.what() + ")");
  }
}

/// `side` is +1 on the left and -1 on the right: the mirror from the side's left-hand frame.
ContactPlace place_of(const ContactCandidate& candidate, const WheelSurface& wheel,
                      const RailSurface& rail, double vertical, double side) {
  ContactPlace place;
  const Vector3 position = candidate.wheel.position;
  const double rail_z = position.z - candidate.distance;
  place.x = position.x;
  place.y = side * position.y;
  place.z = rail_z;
  place.angle = side * candidate.rail_angle;
  place.s_wheel = candidate.wheel.lateral;
  place.w_wheel = candidate.wheel.height;
  place.wheel_angle = candidate.wheel.wheel_angle;
  rail.to_profile_frame(position.y, rail_z, place.t_rail, place.v_rail);
  place.rolling_radius = wheel.radius() + candidate.wheel.height;
  place.distance = candidate.distance + vertical;
  return place;
}

PatchResult patch_of(const PressureRegion& region, const SideSolution& solution,
                     const PosedPair& pair, double side) {
  PatchResult patch;
  patch.pmax = region.peak_pressure;
  patch.area = region.area;
  patch.normal_force = region.normal_force;
  patch.approach = solution.approach;
  patch.angle = side * solution.frame.angle();
  patch.semi_axis_longitudinal = region.semi_axis_longitudinal;
  patch.semi_axis_lateral = region.semi_axis_lateral;
  const SurfacePlace surface =
      surfaces_at(pair, solution.frame, region.centroid_longitudinal, region.centroid_lateral);
  ContactPlace& centre = patch.centre;
  centre.x = surface.rail.x;
  centre.y = side * surface.rail.y;
  centre.z = surface.rail.z;
  centre.angle = side * surface.rail_angle;
  centre.s_wheel = surface.wheel_lateral;
  centre.w_wheel = surface.wheel_height;
  centre.rolling_radius = pair.wheel.radius() + surface.wheel_height;
  pair.rail.to_profile_frame(surface.rail.y, surface.rail.z, centre.t_rail, centre.v_rail);
  return patch;
}

SideFields fields_of(SideSolution& solution, double side) {
  SideFields fields;
  const Grid& grid = solution.grid;
  fields.x.reserve(grid.element_count());
  fields.y.reserve(grid.element_count());
  fields.z.reserve(grid.element_count());
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const Vector3 place =
          solution.frame.to_track(grid.longitudinal(column), grid.lateral(row), 0.0);
      fields.x.push_back(place.x);
      fields.y.push_back(side * place.y);
      fields.z.push_back(place.z);
    }
  }
  fields.undeformed_distance = std::move(solution.undeformed_distance);
  fields.pressure = std::move(solution.normal.pressure);
  fields.displacement = std::move(solution.normal.displacement);
  return fields;
}

CrossSection section_of(const WheelSurface& wheel, const RailSurface& rail,
                        const SideEquilibrium& equilibrium, double vertical, double side) {
  CrossSection section;
  const Curve& rail_curve = rail.graph().curve();
  for (const double arc : rail_curve.starts()) {
    const CurvePoint point = rail_curve.at(arc);
    section.rail_y.push_back(side * point.lateral);
    section.rail_z.push_back(point.height);
  }
  const Rotation rotation(equilibrium.pose);
  const Curve& wheel_curve = wheel.graph().curve();
  for (const double arc : wheel_curve.starts()) {
    if (const auto locus = wheel.locus(wheel_curve.at(arc), equilibrium.pose, rotation)) {
      section.wheel_y.push_back(side * locus->position.y);
      section.wheel_z.push_back(locus->position.z + vertical);
    }
  }
  return section;
}

SideResult result_of(SideSolution solution, const WheelSurface& wheel, const RailSurface& rail,
                     const SideEquilibrium& equilibrium, double side) {
  SideResult result;
  result.vertical = equilibrium.vertical;
  const auto& candidates = equilibrium.scan.candidates;
  result.rigid_contact = place_of(candidates.front(), wheel, rail, equilibrium.vertical, side);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    result.near_contacts.push_back(
        place_of(candidates[i], wheel, rail, equilibrium.vertical, side));
  }
  result.warnings = std::move(solution.warnings);
  result.section = section_of(wheel, rail, equilibrium, solution.vertical, side);
  result.iterations = solution.iterations;
  result.regrown = solution.regrown;
  result.angle = result.rigid_contact.angle;
  if (!solution.in_contact) {
    return result;
  }
  result.angle = side * solution.frame.angle();
  result.pmax = solution.peak_pressure;
  result.normal_force = solution.normal.normal_force;
  result.vertical_force = result.normal_force * solution.frame.normal.z;
  result.lateral_force = side * result.normal_force * solution.frame.normal.y;
  result.approach = solution.approach;
  result.depth = solution.approach / solution.frame.normal.z;
  result.error_estimate = solution.error_estimate;
  result.stop_reason = solution.normal.stop_reason;
  result.residuals = solution.normal.residuals;
  result.grid = solution.grid;
  const PosedPair pair{wheel, rail, equilibrium.pose, solution.vertical};
  std::size_t in_contact = 0;
  for (const PressureRegion& region : solution.regions) {
    result.area += region.area;
    result.pmax_element = std::max(result.pmax_element, region.largest_element_pressure);
    in_contact += region.element_count;
    result.patches.push_back(patch_of(region, solution, pair, side));
  }
  result.fill =
      static_cast<double>(in_contact) / static_cast<double>(solution.grid.element_count());
  result.fields = fields_of(solution, side);
  return result;
}

} // namespace

SceneResult solve_scene(const Scene& scene) {
  const auto start = Clock::now();
  SceneResult result;
  const Profile wheel_profile = load_profile(scene.wheel, ProfileKind::wheel, scene.wheel_smoothing,
                                             "wheelset.wheel", result.corrections);
  const Profile rail_profile = load_profile(scene.rail, ProfileKind::rail, scene.rail_smoothing,
                                            "track.rail", result.corrections);
  result.time.profile = milliseconds_since(start);

  const auto setup_start = Clock::now();
  const WheelSurface wheel(wheel_profile, scene.wheelset);
  const RailSurface rail(rail_profile, scene.track);
  const double modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  result.time.setup = milliseconds_since(setup_start);

  const auto geometry_start = Clock::now();
  EquilibriumRequest request;
  request.lateral = scene.lateral;
  request.yaw = scene.yaw;
  request.roll = scene.roll;
  request.left = scene.side != SideChoice::right;
  request.right = scene.side != SideChoice::left;
  request.near_tolerance = scene.near_tolerance;
  const WheelsetEquilibrium equilibrium = find_equilibrium(wheel, rail, request);
  result.roll = equilibrium.roll;
  result.vertical = equilibrium.vertical;
  result.time.geometry = milliseconds_since(geometry_start);

  result.model = "half-space";
  result.solver = "paper";
  const auto solve = [&](const SideEquilibrium& side, double load) {
    SideRequest side_request;
    side_request.gap = scene.gap;
    side_request.combined_modulus = modulus;
    if (scene.vertical) {
      side_request.vertical = scene.vertical;
    } else if (scene.normal_load) {
      side_request.normal_load = scene.normal_load;
    } else {
      side_request.vertical_load = load;
    }
    side_request.accuracy = scene.accuracy;
    side_request.grid = scene.grid;
    side_request.tolerance = scene.tolerance;
    return solve_side(wheel, rail, side, side_request);
  };
  std::future<SideSolution> right;
  if (equilibrium.right) {
    const bool beside = scene.threads > 1 && equilibrium.left;
    right = std::async(beside ? std::launch::async : std::launch::deferred, solve,
                       std::cref(*equilibrium.right), scene.right_load);
  }
  const auto add_times = [&result](const SideSolution& solution) {
    result.time.remesh += 1e3 * solution.times.remesh;
    result.time.mechanics += 1e3 * solution.times.mechanics;
  };
  if (equilibrium.left) {
    SideSolution solution = solve(*equilibrium.left, scene.left_load);
    add_times(solution);
    result.left = result_of(std::move(solution), wheel, rail, *equilibrium.left, 1.0);
  }
  if (equilibrium.right) {
    SideSolution solution = right.get();
    add_times(solution);
    result.right = result_of(std::move(solution), wheel, rail, *equilibrium.right, -1.0);
  }
  if (result.left && result.right) {
    result.rolling_radius_difference =
        result.left->rigid_contact.rolling_radius - result.right->rigid_contact.rolling_radius;
  }
  result.time.total = milliseconds_since(start);
  return result;
}

} // namespace wrc
