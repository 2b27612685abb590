/// The result of one wheel: points of contact, forces, patches.
///
/// In the track frame (geometry/frames.hpp), both sides alike: results of the right side are those
/// of a left one mirrored. Forces and moments are those of the rail on the wheel.
/// Units mm, N, N mm, MPa, rad. Thread rule: plain values.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accuracy/grid_solution.hpp"
#include "base/heap_optional.hpp"
#include "base/warning.hpp"
#include "geometry/frames.hpp"
#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "mechanics/normal_contact.hpp"
#include "records/creep_result.hpp"
#include "records/damage_result.hpp"
#include "records/friction_law.hpp"
#include "records/motion.hpp"
#include "records/rates.hpp"
#include "records/slip_geometry.hpp"
#include "records/wheel_request.hpp"
#include "remesh/surface_rays.hpp"
#include "remesh/undeformed_distance.hpp"
#include "rolling/kalker_coefficients.hpp"

namespace wrc {

/// A point where wheel and rail meet.
struct ContactPoint {
  double x = 0.0, y = 0.0, z = 0.0; ///< track frame
  double angle = 0.0;               ///< of the rail's tangent about x, > 0: rises to the left
  double s_wheel = 0.0;
  double w_wheel = 0.0;
  double wheel_angle = 0.0; ///< t of the wheel point about the axle, rad
  double t_rail = 0.0;
  double v_rail = 0.0;         ///< height in the rail profile's own frame
  double rolling_radius = 0.0; ///< at the contact point
  double distance = 0.0;       ///< vertical, at the first touch; 0 for the first contact
};

/// A patch as it was solved (left-hand frame of the side), and what it is in the track frame.
struct PatchResult : Patch {
  double pmax = 0.0;         ///< of elements only where `is_unbounded`
  double pmax_element = 0.0; ///< largest element value
  bool is_unbounded = false; ///< pressures: an end of a body cuts them, or no element resolves them
  Vector3 force;             ///< of the pressures
  Vector3 total_force;       ///< with creep forces
  Vector3 moment;            ///< of the pressures, about the contact reference
  double angle = 0.0;        ///< about x, of the tangent across the force; > 0: rises to the left
  double plane_angle = 0.0;  ///< likewise, of the plane
  ContactPoint reference;    ///< weighted mean point of penetration, through which the plane goes
  ContactPoint centroid;     ///< centre of pressure, on the rail's surface
  double semi_axis_longitudinal = 0.0;
  double semi_axis_lateral = 0.0;
  double radius_longitudinal = 0.0; ///< of curvature, of the Hertzian bodies with these semi-axes
  double radius_lateral = 0.0;
  double fill = 0.0; ///< fraction of the elements under pressure
  int lobes = 1;     ///< local maxima of penetration joined on its grid, or in its plane
  HeapOptional<CreepResult> creep;         ///< if creep forces were requested
  std::optional<SlipGeometry> slip;        ///< with them, if slip is that of each element
  HeapOptional<ContactDamage> damage;      ///< if any of it was requested
  HeapOptional<KalkerCoefficients> kalker; ///< likewise (creep/patch_coefficients.hpp)
  /// The parts, if several patches have one plane, each as it was solved; else empty. Everything
  /// else is then that of the parts together (results/combined_contact.hpp), on a grid for fields
  /// only, which are computed on request.
  std::vector<PatchResult> parts;
};

/// What the fields of all patches have in common.
struct WheelDetails {
  double mirror = 1.0;   ///< +1 on the left, -1 on the right: from the side's left-hand frame
  Pose pose;             ///< left-hand frame of the side
  double vertical = 0.0; ///< height of the wheelset's centre
  WheelRequest request;  ///< that was solved
  std::optional<PatchInteraction> interaction; ///< of the patches as they were solved
  std::optional<double> load;                  ///< vertical, of the normal problem; or none
  std::optional<WheelsetMotion> motion;        ///< from which creepages follow, left-hand frame
  FrictionLaw friction;                        ///< of creep forces
  std::shared_ptr<const WheelSurface> wheel;
  std::shared_ptr<const RailSurface> rail;
  DamageRequest damage{}; ///< what of it was requested

  /// Wheel and rail as they were solved.
  [[nodiscard]] PosedPair pair() const { return {*wheel, *rail, pose, vertical}; }
};

/// Filled in by make_wheel_result (results/), then solve_creep_forces (creep/), at last by
/// complete_wheel (scene/solve_scene.cpp).
struct WheelResult {
  ContactPoint rigid_contact;
  std::vector<ContactPoint> near_contacts; ///< further ones, nearest first
  double vertical = 0.0; ///< height of the wheelset's centre at which this wheel first touches
  double pmax = 0.0;     ///< largest one of the patches; of elements only where `is_unbounded`
  double pmax_element = 0.0;
  double normal_force = 0.0; ///< sum over the patches of the amounts of their forces
  Vector3 force;             ///< of the pressures; with creep forces: `total`
  Vector3 moment;            ///< of the pressures, about the reference of the first patch
  /// Force-weighted mean of the patches' centres of pressure: it moves without jumps.
  ContactPoint centroid;
  /// All contact forces together (creep/total_force.hpp), if the mechanics have run.
  std::optional<WheelForce> total;
  HeapOptional<ContactDamage> damage;         ///< worst of the patches, if any of it was requested
  double approach = 0.0;                      ///< of the first patch
  double depth = 0.0;                         ///< vertical approach, from the first touch
  double angle = 0.0;                         ///< of the first patch
  std::optional<double> error_estimate;       ///< discretisation and model together, ...
  std::optional<double> discretisation_error; ///< ... and each alone
  std::optional<double> model_error;
  std::optional<double> validity; ///< of an approximate model, see patch_model.hpp
  std::string model;              ///< used for this side, and ...
  std::string model_reason;       ///< ... why
  std::string steels;             ///< of wheel and rail, and where their yield stress is from
  int iterations = 0;
  int convolutions = 0;
  int solutions = 0;
  StopReason stop_reason = StopReason::tolerance_met;
  std::optional<int> state;         ///< flags of results/wheel_state.hpp, of mechanics
  bool solved = false;              ///< the mechanics have run
  bool meets_part_end = false;      ///< an end of a body that varies is in the contact
  bool is_unbounded = false;        ///< one of the patches
  bool is_cut = false;              ///< one of them, by an end of a body
  std::vector<PatchResult> patches; ///< largest normal force first
  Warnings warnings;
  WheelDetails details;
};

/// The patches as they were solved, those of one plane one by one. Valid as long as the result.
std::vector<const PatchResult*> solved_patches(const WheelResult& side);

/// The bodies whose steel yields in the solution that a patch is of; none if it is elastic.
std::span<const YieldingBody> yielding_of(const Patch& patch, const WheelDetails& side);

/// Whether it is a later pass over a groove, of which no derivatives are known.
bool is_pressed_again(const WheelResult& side);

/// "patch 1: ", with which warnings of a patch begin; nothing if the wheel has one patch only.
std::string of_patch(const WheelResult& wheel, std::size_t index);

} // namespace wrc
