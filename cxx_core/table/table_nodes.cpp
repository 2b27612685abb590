#include "table/table_nodes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "scene/model_choice.hpp"
#include "table/constants.hpp"

namespace wrc {
namespace {

std::uint64_t add_to_checksum(std::uint64_t sum, double number) {
  return (sum ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3ULL;
}

/// A patch as the table has it.
struct PatchNumbers {
  double normal = 0.0;
  Vector3 by_longitudinal;     ///< xi over the turning
  Vector3 by_lateral, lateral; ///< eta over the turning, and over the velocity
  Vector3 by_spin;             ///< phi over the turning
  std::array<double, 4> law{}; ///< as TablePart: of xi, eta, the spin, and the spin's in x
  double log_ratio = 0.0, size = 0.0;
};

PatchNumbers patch_numbers_of(const PatchResult& patch, const Vector3& centre,
                              const std::array<double, 9>& by_creepage) {
  PatchNumbers numbers;
  numbers.normal = patch.normal_force;
  double force = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (const LoadedRow& row : patch.slip.value().rows) {
    force += row.force;
    x += row.first;
    y += row.force * row.lateral;
  }
  x /= force;
  y /= force;
  const ContactFrame& frame = patch.frame;
  const Vector3 arm = frame.origin - patch.approach * frame.normal - centre;
  std::array<Vector3, 3> velocity;
  std::array<Vector3, 3> turning;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& by = patch.slip->creepages_by_twist[i];
    velocity[i] = by[0] * frame.longitudinal + by[1] * frame.lateral + by[2] * frame.normal;
    turning[i] = cross(arm, velocity[i]) + by[3] * frame.longitudinal + by[4] * frame.lateral +
                 by[5] * frame.normal;
  }
  // From the reference to the centre of the pressures.
  numbers.by_longitudinal = turning[0] - y * turning[2];
  numbers.by_lateral = turning[1] + x * turning[2];
  numbers.lateral = velocity[1];
  numbers.by_spin = turning[2];
  const std::array<double, 9>& by = by_creepage;
  numbers.law = {-by[0], -by[4], -(by[5] + y * by[3] - x * by[4]),
                 -(by[2] + y * by[0] - x * by[1])};
  const double a = std::max(patch.semi_axis_longitudinal, 0.5 * patch.grid.longitudinal_step);
  const double b = std::max(patch.semi_axis_lateral, 0.5 * patch.grid.lateral_step);
  numbers.log_ratio = std::clamp(std::log(a / b), -largest_law_log_ratio, largest_law_log_ratio);
  numbers.size = std::sqrt(a * b);
  return numbers;
}

} // namespace

void check_scene_of_table(const Scene& scene) {
  if (const ModelChoice model = choose_model(scene); model.approximate) {
    throw_invalid_argument("solve.model", model.name,
                           "must be \"auto\" or \"half-space\" in a table");
  }
  if (!is_prismatic(scene)) {
    throw_invalid_argument("profiles", "a slices file, or harmonics",
                           "in a table rails do not vary along the track, nor wheels around their "
                           "circumference");
  }
  for (const auto& [steel, key] : {std::pair(&scene.wheel_steel, "material.wheel.yield_stress"),
                                   std::pair(&scene.rail_steel, "material.rail.yield_stress")}) {
    if (steel->yield_stress) {
      throw_invalid_argument(key, *steel->yield_stress,
                             "must be \"none\" in a table: its bodies are elastic");
    }
  }
  if (scene.curved != CurvedChoice::no) {
    throw_invalid_argument("solve.curved", "not \"no\"", "contact in a table is in planes");
  }
  for (const auto& [side, key] :
       {std::pair(&scene.left, "friction.left"), std::pair(&scene.right, "friction.right")}) {
    if (side->friction.falls() || !side->friction.places.empty()) {
      throw_invalid_argument(
          key, side->friction.coefficient,
          "in a table friction neither falls with slip nor depends on the place");
    }
  }
  if (!(scene.left.wheel == scene.right.wheel) || !(scene.left.rail == scene.right.rail) ||
      scene.left.radius != scene.right.radius) {
    throw_invalid_argument(
        "profiles.right", scene.right.wheel.name,
        "a table serves two wheels alike: profiles and radii of both sides must be "
        "the same");
  }
}

TableIdentity identity_of_table(const Scene& scene) {
  TableIdentity identity;
  identity.wheel = scene.left.wheel.name;
  identity.rail = scene.left.rail.name;
  identity.numbers = {scene.left.radius,
                      scene.back_to_back,
                      scene.tape_offset,
                      scene.track.gauge,
                      scene.track.gauge_height,
                      scene.track.inclination,
                      scene.wheel_material.youngs_modulus,
                      scene.wheel_material.poisson,
                      scene.rail_material.youngs_modulus,
                      scene.rail_material.poisson,
                      static_cast<double>(scene.solver),
                      scene.joining_distance};
  return identity;
}

std::uint64_t checksum_of_profiles(const WheelSurface& wheel, const RailSurface& rail) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (const Curve* curve : {&wheel.graph().curve(), &rail.nominal()}) {
    for (const double start : curve->starts()) {
      const CurvePoint point = curve->at(start);
      sum = add_to_checksum(add_to_checksum(sum, point.lateral), point.height);
    }
  }
  return sum;
}

TableNodes::TableNodes(const Scene& scene, SceneSolver solver, ContactTable& table)
    : scene_(scene), solver_(std::move(solver)), table_(table) {
  scene_.side = SideChoice::left;
  scene_.until = Module::mechanics;
  scene_.accuracy_of = AccuracyOf::forces;
  scene_.accuracy = node_accuracy;
  scene_.grid.reset();
  scene_.load_of = LoadOf::pressures;
  scene_.damage = {};
  scene_.threads = 1;
  scene_.derivatives = false;
  scene_.pitch_is_free = false;
  scene_.motion.emplace().speed = speed_of_nodes;
  for (SceneSide* side : {&scene_.left, &scene_.right}) {
    side->displacement = {};
    side->velocity = {};
    side->creepages.reset();
  }
  scene_.left.load = table.ranges.load;
  scene_.creep = CreepModel::linear; // the cheapest that finds the geometry of slip
}

Scene TableNodes::posed(double lateral, double roll, double yaw) const {
  Scene scene = scene_;
  scene.lateral = pose_of_taping_point(table_, lateral, 0.0, roll).lateral;
  scene.roll = roll;
  scene.yaw = yaw;
  return scene;
}

SceneWheel& TableNodes::solve(const Scene& scene) {
  result_ = solver_.solve(scene);
  return *result_.left;
}

void TableNodes::measure() {
  Scene scene = scene_;
  scene.lateral = 0.0;
  scene.yaw = 0.0;
  scene.roll = 0.0;
  scene.vertical.reset();
  scene.until = Module::geometry;
  scene.motion.reset();
  const SceneWheel& wheel = solve(scene);
  wheel_ = wheel.details.wheel;
  rail_ = wheel.details.rail;
  table_.taping_line = wheel_->taping_line();
  table_.radius = wheel_->radius();
  table_.rail_y = rail_->origin_y();
  table_.rail_z = rail_->origin_z();
  table_.identity.profiles = checksum_of_profiles(*wheel_, *rail_);
}

double TableNodes::touch_height(double lateral, double roll, double yaw) {
  if (!search_) {
    if (!wheel_) {
      Scene scene = scene_;
      scene.until = Module::geometry;
      scene.motion.reset();
      scene.vertical.reset();
      scene.lateral = scene.yaw = 0.0;
      scene.roll = 0.0;
      const SceneWheel& wheel = solve(scene);
      wheel_ = wheel.details.wheel;
      rail_ = wheel.details.rail;
    }
    search_.emplace(*wheel_, *rail_);
  }
  const TablePose pose = pose_of_taping_point(table_, lateral, 0.0, roll);
  search_->scan({pose.lateral, yaw, roll});
  const LocusSpot spot = search_->least_spots(0.0).front();
  return -search_->candidate(spot).distance - pose.vertical;
}

double TableNodes::depth_at_load(double lateral, double roll, double yaw) {
  Scene scene = posed(lateral, roll, yaw);
  scene.vertical.reset();
  scene.creep = CreepModel::none;
  return solve(scene).depth;
}

TableNodes::Parts TableNodes::parts(double lateral, double height, double roll, double yaw) {
  Scene scene = posed(lateral, roll, yaw);
  scene.vertical = pose_of_taping_point(table_, lateral, height, roll).vertical;
  const SceneWheel& wheel = solve(scene);
  Parts parts{};
  if (wheel.patches.empty()) {
    return parts;
  }
  const Vector3 centre{0.0, scene.lateral, *scene.vertical};
  scene.accuracy = table_creep_accuracy;
  scene.creep = CreepModel::full;
  Vector3 force;
  Vector3 moment;
  double normal = 0.0;
  PatchNumbers sum;
  for (const PatchResult& patch : wheel.patches) {
    const ContactPoint& reference = patch.reference;
    force = force + patch.force;
    moment = moment + patch.moment +
             cross(Vector3{reference.x, reference.y, reference.z} - centre, patch.force);
    const CreepResult creep = solver_.solve_creep(scene, wheel, patch, {}, true);
    const PatchNumbers numbers = patch_numbers_of(patch, centre, creep.derivatives->by_creepage);
    const double weight = numbers.normal;
    normal += weight;
    sum.by_longitudinal = sum.by_longitudinal + weight * numbers.by_longitudinal;
    sum.by_lateral = sum.by_lateral + weight * numbers.by_lateral;
    sum.lateral = sum.lateral + weight * numbers.lateral;
    sum.by_spin = sum.by_spin + weight * numbers.by_spin;
    sum.log_ratio += weight * numbers.log_ratio;
    sum.size += weight * numbers.size;
    for (std::size_t i = 0; i < sum.law.size(); ++i) {
      sum.law[i] += numbers.law[i];
    }
  }
  const double p = std::cbrt(force.z * force.z);
  const double inverse = 1.0 / normal;
  const double angle = std::atan2(sum.lateral.z, sum.lateral.y);
  const Vector3 by_lateral = inverse * sum.by_lateral;
  const auto put = [&parts](TablePart part, double number) {
    parts[static_cast<std::size_t>(part)] = number;
  };
  put(TablePart::load, p);
  put(TablePart::lateral, force.y / force.z);
  put(TablePart::longitudinal, force.x / (force.z * yaw));
  put(TablePart::moment_x, moment.x / force.z);
  put(TablePart::moment_y, moment.y / (force.z * yaw));
  put(TablePart::moment_z, moment.z / (force.z * yaw));
  put(TablePart::normal, normal / force.z);
  put(TablePart::arm_x, (std::cos(angle) * by_lateral.z - std::sin(angle) * by_lateral.y) / yaw);
  put(TablePart::arm_y, -inverse * sum.by_longitudinal.z);
  put(TablePart::arm_z, inverse * sum.by_longitudinal.y);
  put(TablePart::angle, angle);
  put(TablePart::spin_by_pitch, inverse * sum.by_spin.y);
  put(TablePart::spin_by_yaw, inverse * sum.by_spin.z);
  put(TablePart::longitudinal_law, sum.law[0] / p);
  put(TablePart::lateral_law, sum.law[1] / p);
  put(TablePart::spin_law, sum.law[2] / force.z);
  put(TablePart::cross_law, sum.law[3] / force.z);
  put(TablePart::log_ratio, inverse * sum.log_ratio);
  put(TablePart::size, inverse * sum.size / std::sqrt(p));
  const auto place = place_parts_of(wheel);
  std::copy(place.begin(), place.end(), parts.begin() + table_part_count);
  return parts;
}

SceneWheel& TableNodes::solve_exactly(const TableState& state, bool derivatives, double accuracy) {
  Scene scene = scene_;
  scene.accuracy = accuracy;
  scene.derivatives = derivatives;
  scene.creep = CreepModel::full;
  scene.lateral = state.position[1];
  scene.vertical = state.position[2];
  scene.roll = state.position[3];
  scene.yaw = state.position[5];
  scene.left.friction.coefficient = state.friction;
  scene.standstill_speed = table_.standstill_speed;
  Motion& motion = *scene.motion;
  motion.speed = state.velocity[0];
  motion.lateral = state.velocity[1];
  motion.vertical = state.velocity[2];
  motion.roll = state.velocity[3];
  motion.pitch = state.velocity[4];
  motion.yaw = state.velocity[5];
  return solve(scene);
}

} // namespace wrc
