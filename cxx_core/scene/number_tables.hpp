/// Tables of the numbers of a result: names, dimensions, and where the values are.
///
/// A result is read by name or by id (scene/number_ids.hpp); a line here makes a number known to
/// both, to the C interface, JSON and studies. What is computed when it is read is computed by
/// these getters. Values in mm, y left, z up. Thread rule: constants; getters are pure functions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "derivatives/steady_error.hpp"
#include "pressure/contact_area.hpp"
#include "results/grade.hpp"
#include "scene/damage_tables.hpp"
#include "scene/number_group.hpp"
#include "scene/number_table.hpp"
#include "scene/rate_tables.hpp"
#include "scene/scene_warnings.hpp"

namespace wrc::number_tables {

using namespace dimensions;

using OfPatch = Number<PatchResult>;
using OfWheel = Number<WheelResult>;
using OfCreep = Number<CreepResult>;
using OfPoint = Number<ContactPoint>;
using OfTotal = Number<WheelForce>;
using OfResiduals = Number<Residuals>;
using OfTime = Number<StageMilliseconds>;
using OfScene = Number<SceneResult>;

/// Two tables as one.
template <class Owner, std::size_t count, std::size_t more>
constexpr auto joined(const std::array<Number<Owner>, count>& table,
                      const std::array<Number<Owner>, more>& other) {
  return [&]<std::size_t... i, std::size_t... j>(std::index_sequence<i...>,
                                                 std::index_sequence<j...>) {
    return std::array{table[i]..., other[j]...};
  }
  (std::make_index_sequence<count>(), std::make_index_sequence<more>());
}

inline constexpr std::array place_numbers{
    OfPoint{"x", length, member<&ContactPoint::x>},
    OfPoint{"y", turning_length, member<&ContactPoint::y>},
    OfPoint{"z", turning_length, member<&ContactPoint::z>},
    OfPoint{"s_wheel", length, member<&ContactPoint::s_wheel>},
    OfPoint{"w_wheel", length, member<&ContactPoint::w_wheel>},
    OfPoint{"t_rail", length, member<&ContactPoint::t_rail>},
    OfPoint{"v_rail", length, member<&ContactPoint::v_rail>},
    OfPoint{"rolling_radius", length, member<&ContactPoint::rolling_radius>},
    OfPoint{"wheel_angle", angle, member<&ContactPoint::wheel_angle>},
};

inline constexpr auto centroid_numbers =
    joined(place_numbers, std::array{OfPoint{"angle", angle, member<&ContactPoint::angle>}});

inline constexpr auto touch_numbers = joined(
    centroid_numbers, std::array{OfPoint{"distance", length, member<&ContactPoint::distance>}});

/// Computed on request, unless a model has given it.
inline double area_of_patch(const PatchResult& patch) {
  if (patch.parts.empty()) {
    return patch.area ? *patch.area : contact_area(patch.grid, patch.pressure);
  }
  double area = 0.0;
  for (const PatchResult& part : patch.parts) {
    area += area_of_patch(part);
  }
  return area;
}

inline double regions_of_patch(const PatchResult& patch) {
  if (patch.parts.empty()) {
    return static_cast<double>(pressure_regions(patch.grid, patch.pressure).size());
  }
  double count = 0.0;
  for (const PatchResult& part : patch.parts) {
    count += regions_of_patch(part);
  }
  return count;
}

/// A largest pressure; not-a-number where it has no bound, or none that the elements show.
inline double peak_of(bool is_unbounded, double value) {
  return is_unbounded ? none : value;
}

/// Largest pressure without yielding.
inline double elastic_peak_of(const PatchResult& patch) {
  return patch.elastic_peak.value_or(patch.pmax);
}

inline double elastic_peak_of(const WheelResult& wheel) {
  double peak = 0.0;
  for (const PatchResult& patch : wheel.patches) {
    peak = std::max(peak, elastic_peak_of(patch));
  }
  return peak;
}

/// None of an approximate model.
inline std::optional<double> of_plane(const PatchResult& patch, double value) {
  return patch.area ? std::nullopt : std::optional(value);
}

/// If they were requested.
inline std::optional<double> kalker_of(const PatchResult& patch,
                                       double KalkerCoefficients::*coefficient) {
  return patch.kalker ? std::optional((*patch.kalker).*coefficient) : std::nullopt;
}

inline constexpr std::array patch_numbers{
    OfPatch{"pmax", stress, [](const PatchResult& p) { return peak_of(p.is_unbounded, p.pmax); }},
    OfPatch{"pmax_elastic", stress,
            [](const PatchResult& p) { return peak_of(p.is_unbounded, elastic_peak_of(p)); }},
    OfPatch{"area", surface, [](const PatchResult& p) { return area_of_patch(p); }},
    OfPatch{"pmax_element", stress,
            [](const PatchResult& p) { return peak_of(p.is_unbounded, p.pmax_element); }},
    OfPatch{"normal_force", force, [](const PatchResult& p) { return norm(p.force); }},
    OfPatch{"vertical_force", turning_force, member<&PatchResult::total_force, &Vector3::z>},
    OfPatch{"lateral_force", turning_force, member<&PatchResult::total_force, &Vector3::y>},
    OfPatch{"longitudinal_force", force, member<&PatchResult::total_force, &Vector3::x>},
    OfPatch{"pressure_force.x", force, member<&PatchResult::force, &Vector3::x>},
    OfPatch{"pressure_force.y", turning_force, member<&PatchResult::force, &Vector3::y>},
    OfPatch{"pressure_force.z", turning_force, member<&PatchResult::force, &Vector3::z>},
    OfPatch{"pressure_moment.x", moment, member<&PatchResult::moment, &Vector3::x>},
    OfPatch{"pressure_moment.y", turning_moment, member<&PatchResult::moment, &Vector3::y>},
    OfPatch{"pressure_moment.z", turning_moment, member<&PatchResult::moment, &Vector3::z>},
    OfPatch{"approach", length, member<&PatchResult::approach>},
    OfPatch{"angle", angle, member<&PatchResult::angle>},
    OfPatch{"plane_angle", angle, member<&PatchResult::plane_angle>},
    OfPatch{"turn", pure, [](const PatchResult& p) { return of_plane(p, p.turn.range()); }},
    OfPatch{"plane_error", pure, [](const PatchResult& p) { return of_plane(p, p.plane_error); }},
    OfPatch{"semi_axes.longitudinal", length, member<&PatchResult::semi_axis_longitudinal>},
    OfPatch{"semi_axes.lateral", length, member<&PatchResult::semi_axis_lateral>},
    OfPatch{"radii.longitudinal", length, member<&PatchResult::radius_longitudinal>},
    OfPatch{"radii.lateral", length, member<&PatchResult::radius_lateral>},
    OfPatch{"kalker.c11", pure,
            [](const PatchResult& p) { return kalker_of(p, &KalkerCoefficients::c11); }},
    OfPatch{"kalker.c22", pure,
            [](const PatchResult& p) { return kalker_of(p, &KalkerCoefficients::c22); }},
    OfPatch{"kalker.c23", pure,
            [](const PatchResult& p) { return kalker_of(p, &KalkerCoefficients::c23); }},
    OfPatch{"kalker.c33", pure,
            [](const PatchResult& p) { return kalker_of(p, &KalkerCoefficients::c33); }},
    OfPatch{"coupling_weight", pure, member<&PatchResult::coupling_weight>},
    OfPatch{"regions", pure, [](const PatchResult& p) { return regions_of_patch(p); }},
    OfPatch{"lobes", pure, member<&PatchResult::lobes>},
    OfPatch{"fill", pure, member<&PatchResult::fill>},
    OfPatch{"grid.lateral", pure, member<&PatchResult::grid, &Grid::lateral_count>},
    OfPatch{"grid.longitudinal", pure, member<&PatchResult::grid, &Grid::longitudinal_count>},
    OfPatch{"element_size.lateral", length, member<&PatchResult::grid, &Grid::lateral_step>},
    OfPatch{"element_size.longitudinal", length,
            member<&PatchResult::grid, &Grid::longitudinal_step>},
};

/// Of elements and of steady rolling together, which are independent.
inline std::optional<double> creep_error_of(const CreepResult& creep) {
  return creep.error_estimate && creep.steady_error
             ? std::optional(std::hypot(*creep.error_estimate, *creep.steady_error))
             : creep.error_estimate;
}

/// With creep forces only.
inline constexpr auto creep_numbers = joined(
    std::array{
        OfCreep{"creepage.longitudinal", pure,
                member<&CreepResult::creepages, &Creepages::longitudinal>},
        OfCreep{"creepage.lateral", turning, member<&CreepResult::creepages, &Creepages::lateral>},
        OfCreep{"creepage.spin", turning_curvature,
                member<&CreepResult::creepages, &Creepages::spin>},
        OfCreep{"slip_variation", pure, member<&CreepResult::slip_variation>},
        OfCreep{"creep_force.longitudinal", force, member<&CreepResult::longitudinal_force>},
        OfCreep{"creep_force.lateral", turning_force, member<&CreepResult::lateral_force>},
        OfCreep{"spin_moment", turning_moment, member<&CreepResult::spin_moment>},
        OfCreep{"friction", pure, member<&CreepResult::friction>},
        OfCreep{"slip_area", surface, member<&CreepResult::slip_area>},
        OfCreep{"adhesion_area", surface, member<&CreepResult::adhesion_area>},
        OfCreep{"traction_max", stress, member<&CreepResult::largest_traction>},
        OfCreep{"wear_number", force, member<&CreepResult::power_per_speed>},
        OfCreep{"friction_power", power, member<&CreepResult::friction_power>},
        OfCreep{"numerical_loss", pure, member<&CreepResult::numerical_loss>},
        OfCreep{"creep_residual", pure, member<&CreepResult::residual>},
        OfCreep{"creep_convolutions", pure, member<&CreepResult::convolutions>},
        OfCreep{"creep_grid.lateral", pure, member<&CreepResult::grid, &Grid::lateral_count>},
        OfCreep{"creep_grid.longitudinal", pure,
                member<&CreepResult::grid, &Grid::longitudinal_count>},
        OfCreep{"creep_element_size.lateral", length,
                member<&CreepResult::grid, &Grid::lateral_step>},
        OfCreep{"creep_element_size.longitudinal", length,
                member<&CreepResult::grid, &Grid::longitudinal_step>},
        OfCreep{"creep_error_estimate", pure,
                [](const CreepResult& r) { return creep_error_of(r); }},
        OfCreep{"creep_steady_error", pure, member<&CreepResult::steady_error>}},
    creep_rate_numbers);

/// Zeros without one.
inline const PatchResult& first_patch(const WheelResult& wheel) {
  static const PatchResult zeros;
  return wheel.patches.empty() ? zeros : wheel.patches.front();
}

/// Force of the rail on the wheel, by pressures and creep forces, where the mechanics have run.
inline Vector3 force_on(const WheelResult& wheel) {
  return wheel.total ? wheel.total->force : wheel.force;
}

/// T gamma of its patches together, with creep forces only.
inline std::optional<double> wear_number_of(const WheelResult& wheel) {
  std::optional<double> sum;
  for (const PatchResult& patch : wheel.patches) {
    if (patch.creep) {
      sum = sum.value_or(0.0) + patch.creep->power_per_speed;
    }
  }
  return sum;
}

/// Y/Q of the wheel on the rail, Y positive towards the field side; none without a vertical force.
inline std::optional<double> derailment_quotient_of(const WheelResult& wheel) {
  const Vector3 force = force_on(wheel);
  return force.z > 0.0 ? std::optional(-wheel.details.mirror * force.y / force.z) : std::nullopt;
}

inline constexpr std::array side_numbers{
    OfWheel{"vertical", turning_length, member<&WheelResult::vertical>},
    OfWheel{"pmax", stress, [](const WheelResult& r) { return peak_of(r.is_unbounded, r.pmax); }},
    OfWheel{"pmax_elastic", stress,
            [](const WheelResult& r) { return peak_of(r.is_unbounded, elastic_peak_of(r)); }},
    OfWheel{"pmax_element", stress,
            [](const WheelResult& r) { return peak_of(r.is_unbounded, r.pmax_element); }},
    OfWheel{"area", surface,
            [](const WheelResult& r) {
              double area = 0.0;
              for (const PatchResult& patch : r.patches) {
                area += area_of_patch(patch);
              }
              return area;
            }},
    OfWheel{"normal_force", force, member<&WheelResult::normal_force>},
    OfWheel{"vertical_force", turning_force, [](const WheelResult& r) { return force_on(r).z; }},
    OfWheel{"lateral_force", turning_force, [](const WheelResult& r) { return force_on(r).y; }},
    OfWheel{"longitudinal_force", force, [](const WheelResult& r) { return force_on(r).x; }},
    OfWheel{"derailment_quotient", pure,
            [](const WheelResult& r) { return derailment_quotient_of(r); }},
    OfWheel{"wear_number", force, [](const WheelResult& r) { return wear_number_of(r); }},
    OfWheel{"pressure_force.x", force, member<&WheelResult::force, &Vector3::x>},
    OfWheel{"pressure_force.y", turning_force, member<&WheelResult::force, &Vector3::y>},
    OfWheel{"pressure_force.z", turning_force, member<&WheelResult::force, &Vector3::z>},
    OfWheel{"pressure_moment.x", moment, member<&WheelResult::moment, &Vector3::x>},
    OfWheel{"pressure_moment.y", turning_moment, member<&WheelResult::moment, &Vector3::y>},
    OfWheel{"pressure_moment.z", turning_moment, member<&WheelResult::moment, &Vector3::z>},
    OfWheel{"approach", length, member<&WheelResult::approach>},
    OfWheel{"depth", length, member<&WheelResult::depth>},
    OfWheel{"angle", angle, member<&WheelResult::angle>},
    OfWheel{"iterations", pure, member<&WheelResult::iterations>},
    OfWheel{"convolutions", pure, member<&WheelResult::convolutions>},
    OfWheel{"solutions", pure, member<&WheelResult::solutions>},
    OfWheel{"state", pure, [](const WheelResult& r) { return std::optional<double>(r.state); }},
    OfWheel{"patch_count", pure, [](const WheelResult& r) { return r.patches.size(); }},
    OfWheel{"fill", pure, [](const WheelResult& r) { return first_patch(r).fill; }},
    OfWheel{"grid.lateral", pure,
            [](const WheelResult& r) { return first_patch(r).grid.lateral_count; }},
    OfWheel{"grid.longitudinal", pure,
            [](const WheelResult& r) { return first_patch(r).grid.longitudinal_count; }},
    OfWheel{"element_size.lateral", length,
            [](const WheelResult& r) { return first_patch(r).grid.lateral_step; }},
    OfWheel{"element_size.longitudinal", length,
            [](const WheelResult& r) { return first_patch(r).grid.longitudinal_step; }},
    OfWheel{"error_estimate", pure, member<&WheelResult::error_estimate>},
    OfWheel{"discretisation_error", pure, member<&WheelResult::discretisation_error>},
    OfWheel{"model_error", pure, member<&WheelResult::model_error>},
    OfWheel{"creep_steady_error", pure, [](const WheelResult& r) { return steady_error_of(r); }},
    OfWheel{"validity", pure, member<&WheelResult::validity>},
    OfWheel{"warning_count", pure, [](const WheelResult& r) { return r.warnings.size(); }},
    OfWheel{"grade", pure,
            [](const WheelResult& r) { return static_cast<int>(grade_of(r.warnings)); }},
};

inline constexpr std::array total_numbers{
    OfTotal{"force.x", force, member<&WheelForce::force, &Vector3::x>},
    OfTotal{"force.y", turning_force, member<&WheelForce::force, &Vector3::y>},
    OfTotal{"force.z", turning_force, member<&WheelForce::force, &Vector3::z>},
    OfTotal{"moment.x", moment, member<&WheelForce::moment, &Vector3::x>},
    OfTotal{"moment.y", turning_moment, member<&WheelForce::moment, &Vector3::y>},
    OfTotal{"moment.z", turning_moment, member<&WheelForce::moment, &Vector3::z>},
};

inline constexpr std::array residual_numbers{
    OfResiduals{"load_balance", pure, member<&Residuals::load_balance>},
    OfResiduals{"least_gap", pure, member<&Residuals::least_gap>},
    OfResiduals{"complementarity", pure, member<&Residuals::complementarity>},
};

inline constexpr std::array spread_numbers{
    Number<WheelSpread>{"pmax", stress, member<&WheelSpread::pmax>},
    Number<WheelSpread>{"area", surface, member<&WheelSpread::area>},
    Number<WheelSpread>{"grade", pure,
                        [](const WheelSpread& s) {
                          return s.grade ? std::optional<double>(static_cast<int>(*s.grade))
                                         : std::nullopt;
                        }},
};
/// With the wavelength at that place of smoothed_waves.
template <std::size_t place, std::optional<double> PressedNumbers::*number>
inline constexpr auto smoothed = [](const SmoothedScene::Wheel& w) { return w[place].*number; };
using OfSmoothed = Number<SmoothedScene::Wheel>;
/// With profiles of points only.
inline constexpr std::array smoothed_numbers{
    OfSmoothed{"0mm.pmax", stress, smoothed<0, &PressedNumbers::pmax>},
    OfSmoothed{"0mm.area", surface, smoothed<0, &PressedNumbers::area>},
    OfSmoothed{"3mm.pmax", stress, smoothed<1, &PressedNumbers::pmax>},
    OfSmoothed{"3mm.area", surface, smoothed<1, &PressedNumbers::area>},
    OfSmoothed{"5mm.pmax", stress, smoothed<2, &PressedNumbers::pmax>},
    OfSmoothed{"5mm.area", surface, smoothed<2, &PressedNumbers::area>},
    OfSmoothed{"8mm.pmax", stress, smoothed<3, &PressedNumbers::pmax>},
    OfSmoothed{"8mm.area", surface, smoothed<3, &PressedNumbers::area>},
    OfSmoothed{"15mm.pmax", stress, smoothed<4, &PressedNumbers::pmax>},
    OfSmoothed{"15mm.area", surface, smoothed<4, &PressedNumbers::area>},
};
static_assert(smoothed_waves == std::array{0.0, 3.0, 5.0, 8.0, 15.0}); // of the names
inline constexpr std::array scene_spread_numbers{
    Number<SceneSpread>{"rolling_radius_difference", length,
                        member<&SceneSpread::rolling_radius_difference>},
};

inline constexpr std::array sensitivity_numbers{
    Number<WheelRates>{"pressure_force.y.lateral", stiffness,
                       [](const WheelRates& r) { return r.force.lateral.force.y; }},
    Number<WheelRates>{"pressure_force.y.vertical", stiffness,
                       [](const WheelRates& r) { return r.force.vertical.force.y; }},
    Number<WheelRates>{"pressure_force.y.roll", turning_force_by_angle,
                       [](const WheelRates& r) { return r.force.roll.force.y; }},
    Number<WheelRates>{"pressure_force.y.yaw", force_by_angle,
                       [](const WheelRates& r) { return r.force.yaw.force.y; }},
    Number<WheelRates>{"pressure_force.z.lateral", stiffness,
                       [](const WheelRates& r) { return r.force.lateral.force.z; }},
    Number<WheelRates>{"pressure_force.z.vertical", stiffness,
                       [](const WheelRates& r) { return r.force.vertical.force.z; }},
    Number<WheelRates>{"pressure_force.z.roll", turning_force_by_angle,
                       [](const WheelRates& r) { return r.force.roll.force.z; }},
    Number<WheelRates>{"pressure_force.z.yaw", force_by_angle,
                       [](const WheelRates& r) { return r.force.yaw.force.z; }},
};

/// With the height following, so that the vertical force of pressures stays.
inline constexpr std::array condensed_numbers{
    Number<CondensedRates>{"pressure_force.y.lateral", stiffness,
                           [](const CondensedRates& r) { return r.lateral.wheel.force.y; }},
    Number<CondensedRates>{"pressure_force.y.roll", turning_force_by_angle,
                           [](const CondensedRates& r) { return r.roll.wheel.force.y; }},
    Number<CondensedRates>{"vertical.lateral", pure,
                           [](const CondensedRates& r) { return r.lateral.vertical; }},
    Number<CondensedRates>{"vertical.roll", turning_length_by_angle,
                           [](const CondensedRates& r) { return r.roll.vertical; }},
};

inline constexpr std::array scene_numbers{
    OfScene{"roll", angle, member<&SceneResult::roll>},
    OfScene{"vertical", turning_length, member<&SceneResult::vertical>},
    OfScene{"rolling_radius_difference", length, member<&SceneResult::rolling_radius_difference>},
    OfScene{"pitch", rate, member<&SceneResult::pitch>},
    OfScene{"warning_count", pure, [](const SceneResult& r) { return warning_count(r); }},
    OfScene{"grade", pure,
            [](const SceneResult& r) { return static_cast<int>(grade_of(all_warnings(r))); }},
};

inline constexpr std::array time_numbers{
    OfTime{"profile", milliseconds, member<&StageMilliseconds::profile>},
    OfTime{"setup", milliseconds, member<&StageMilliseconds::setup>},
    OfTime{"geometry", milliseconds, member<&StageMilliseconds::geometry>},
    OfTime{"remesh", milliseconds, member<&StageMilliseconds::remesh>},
    OfTime{"mechanics", milliseconds, member<&StageMilliseconds::mechanics>},
    OfTime{"rolling", milliseconds, member<&StageMilliseconds::rolling>},
    OfTime{"damage", milliseconds, member<&StageMilliseconds::damage>},
    OfTime{"total", milliseconds, member<&StageMilliseconds::total>},
};

/// Calls a function with the table of a group.
template <class Function>
constexpr decltype(auto) with_table(NumberGroup group, Function&& function) {
  switch (group) {
  case NumberGroup::time:
    return function(time_numbers);
  case NumberGroup::side:
    return function(side_numbers);
  case NumberGroup::wheelset:
  case NumberGroup::total:
    return function(total_numbers);
  case NumberGroup::rigid_contact:
  case NumberGroup::near_contact:
    return function(touch_numbers);
  case NumberGroup::centroid:
  case NumberGroup::patch_centroid:
    return function(centroid_numbers);
  case NumberGroup::residuals:
    return function(residual_numbers);
  case NumberGroup::spread:
    return function(spread_numbers);
  case NumberGroup::scene_spread:
    return function(scene_spread_numbers);
  case NumberGroup::smoothed:
    return function(smoothed_numbers);
  case NumberGroup::sensitivities:
    return function(sensitivity_numbers);
  case NumberGroup::at_load:
    return function(condensed_numbers);
  case NumberGroup::jacobian:
    return function(jacobian_numbers);
  case NumberGroup::patch:
    return function(patch_numbers);
  case NumberGroup::reference:
    return function(place_numbers);
  case NumberGroup::creep:
    return function(creep_numbers);
  case NumberGroup::side_damage:
  case NumberGroup::damage:
    return function(damage_numbers);
  case NumberGroup::scene:
    break;
  }
  return function(scene_numbers);
}

} // namespace wrc::number_tables
