/// A scene: everything that is requested, with the defaults of the paper's Table 1.
///
/// Values are reached by the keys of a scene file (keys/scene_keys.hpp), which also hold their
/// permitted ranges. Units mm, N, MPa, rad; track frame of geometry/frames.hpp.
/// Thread rule: a plain value.
#pragma once

#include <bitset>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "half_space/fft.hpp"
#include "half_space/material.hpp"
#include "half_space/steel.hpp"
#include "keys/constants.hpp"
#include "keys/convention.hpp"
#include "measured/read_options.hpp"
#include "mechanics/normal_contact.hpp"
#include "profile/profile.hpp"
#include "records/creep_choice.hpp"
#include "records/damage_result.hpp"
#include "records/friction_law.hpp"
#include "records/motion.hpp"
#include "records/wheel_request.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

struct ContactHistory; // creep/elastic_history.hpp

enum class SideChoice { both, left, right };
/// What carries a load: the vertical force of the pressures, that of all contact forces
/// (scene/total_load.hpp), or the pressures' force along the normal of the patch.
enum class LoadOf { pressures, total, normal };
enum class ModelRequest { automatic, half_space, hertz, kik_piotrowski };

/// How a profile is read and placed: what stands behind its name (keys/profile_text.hpp).
struct ProfileOptions {
  /// Wavelength in mm for a profile read from a file, 0: none; automatic if not set.
  std::optional<double> smoothing{};
  std::optional<double> smoothing_along{}; ///< of slices, mm; as their file says if not set
  ProfilePlacement placement{};            ///< of a profile read from a file
  /// Of a rail: its profile's origin from the track centre (TrackDimensions); by the gauge if not
  /// set.
  std::optional<double> rail_origin{};
  bool operator==(const ProfileOptions&) const = default;
};

struct ProfileChoice {
  std::string name; ///< of a built-in profile, or a file
  /// Used instead of one of that name if given, which is then its name.
  std::shared_ptr<const Profile> given{};
  ProfileOptions options{};
  std::vector<RadiusHarmonic> harmonics{}; ///< of a wheel's radius
  bool operator==(const ProfileChoice&) const = default;
};

/// What may differ from side to side.
struct SceneSide {
  ProfileChoice wheel{"S1002"};
  double radius = 460.0; ///< of the wheel at the taping line
  ProfileChoice rail{"60E1"};
  RailDisplacement displacement; ///< of the rail, track frame
  RailDisplacement velocity;     ///< of the rail, mm/s and rad/s
  RailDisplacement slope;        ///< change of its displacement along the track, 1 and rad/mm
  double load = 80000.0;         ///< of the wheel, N
  FrictionLaw friction;
  /// Creepages of all patches, at their references; without any on both sides: from `motion`.
  std::optional<Creepages> creepages;
};

/// Keys by their ids, the indices in scene_keys (keys/scene_keys.hpp).
using KeySet = std::bitset<256>;

struct Scene : WheelOptions {
  Convention convention; ///< of the numbers outside; those here are in mm, y left, z up

  SceneSide left;
  SceneSide right;
  TrackDimensions track;
  double back_to_back = 1360.0;
  double tape_offset = 70.0; ///< taping line to inner face

  Material wheel_material{210000.0, 0.3};
  Material rail_material{210000.0, 0.3};
  Steel wheel_steel;
  Steel rail_steel;
  DamageRequest damage; ///< except Poisson's ratio and shear yield, which are those of the body
  std::optional<double> shear_yield; ///< of `damage`; by the body's yield stress if not set
  bool kalker = false;               ///< whether PatchResult::kalker is requested

  double lateral = 0.0;
  double yaw = 0.0;
  /// Of the wheelset's centre along the track, mm, and turn about its axle, rad: which part of
  /// rails and wheels that vary is in contact.
  double along = 0.0;
  double pitch = 0.0;
  std::optional<double> roll;     ///< prescribed; solved if not set
  std::optional<double> vertical; ///< prescribed height of the wheelset's centre; solved if not set

  LoadOf load_of = LoadOf::pressures; ///< what carries the sides' loads

  /// What creepages follow from where none are given; else its speed is that of the power. Without
  /// either there are no creep forces.
  std::optional<Motion> motion;
  double standstill_speed = Motion{}.standstill_speed; ///< of the motion
  std::array<double, 6> acceleration{};                ///< of the motion
  /// Whether CreepResult::steady_error is found: not in solutions on the way to another.
  bool steady_errors = true;
  bool pitch_is_free = false; ///< of the motion: such that contact forces hold the torque
  double torque = 0.0;        ///< about the axle, N mm, > 0 drives forwards
  bool derivatives = false;   ///< of creep forces, whether they are kept for a Jacobian
  SlipChoice slip;            ///< of creep forces from a motion; no key has it
  /// A step of time of creep forces from the motion, s, and what it starts from; 0: steady rolling.
  double time_step = 0.0;
  std::shared_ptr<const ContactHistory> history;
  std::optional<CreepModel> creep; ///< automatic if not set: full where there are creepages

  SideChoice side = SideChoice::both;
  ModelRequest model = ModelRequest::automatic;
  double near_tolerance = 0.1; ///< contacts listed as near: distance at first touch, mm
  int threads = 1;

  /// Keys that were set, other than to their default; which of them have no effect beside others is
  /// in keys/key_warnings.hpp.
  KeySet given;

  Scene();

  [[nodiscard]] bool has_creepages() const { return left.creepages || right.creepages; }
  /// Over which the axle's speed is that of rolling, mm.
  [[nodiscard]] double nominal_radius() const { return 0.5 * (left.radius + right.radius); }
};

/// What a solver of scenes does its work with: no result changes by more than its tolerance.
struct SolverOptions {
  PlannerRigor planner = PlannerRigor::estimate;
  Precision precision = Precision::mixed; ///< of the iteration for pressures
};

std::vector<YieldingBody> yielding_bodies_of(const Scene& scene);
/// With Poisson's ratio and shear yield of the body that it asks for.
DamageRequest damage_request_of(const Scene& scene);

/// Whether a profile is that of a slices file.
bool is_sliced(const ProfileChoice& choice);
/// Whether the waves of a wheel's radius are large enough to change a result of this accuracy.
bool has_waves(const ProfileChoice& wheel, double accuracy);
/// Whether both rails are prismatic along the track and both wheels round, as their profiles say:
/// slices may be equal.
bool has_prismatic_rails(const Scene& scene);
bool has_round_wheels(const Scene& scene);
inline bool is_prismatic(const Scene& scene) {
  return has_prismatic_rails(scene) && has_round_wheels(scene);
}

} // namespace wrc
