/// Tables of the numbers of a result: names, dimensions, and where the values are.
///
/// A result is read by name or by id (scene/number_ids.hpp); a line here makes a number known to
/// both, to the C interface, JSON and studies. What is computed when it is read is computed by
/// these getters. Values in mm, y left, z up. Thread rule: constants; getters are pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "pressure/contact_area.hpp"
#include "scene/damage_tables.hpp"
#include "scene/number_ids.hpp"
#include "scene/number_table.hpp"
#include "scene/rate_tables.hpp"

namespace wrc::number_tables {

using namespace dimensions;

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
    Number<ContactPoint>{"x", length, [](const ContactPoint& p) { return p.x; }},
    Number<ContactPoint>{"y", turning_length, [](const ContactPoint& p) { return p.y; }},
    Number<ContactPoint>{"z", turning_length, [](const ContactPoint& p) { return p.z; }},
    Number<ContactPoint>{"s_wheel", length, [](const ContactPoint& p) { return p.s_wheel; }},
    Number<ContactPoint>{"w_wheel", length, [](const ContactPoint& p) { return p.w_wheel; }},
    Number<ContactPoint>{"t_rail", length, [](const ContactPoint& p) { return p.t_rail; }},
    Number<ContactPoint>{"v_rail", length, [](const ContactPoint& p) { return p.v_rail; }},
    Number<ContactPoint>{"rolling_radius", length,
                         [](const ContactPoint& p) { return p.rolling_radius; }},
    Number<ContactPoint>{"wheel_angle", angle, [](const ContactPoint& p) { return p.wheel_angle; }},
};

inline constexpr auto centroid_numbers =
    joined(place_numbers, std::array{Number<ContactPoint>{
                              "angle", angle, [](const ContactPoint& p) { return p.angle; }}});

inline constexpr auto touch_numbers = joined(
    centroid_numbers, std::array{Number<ContactPoint>{
                          "distance", length, [](const ContactPoint& p) { return p.distance; }}});

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

inline constexpr std::array patch_numbers{
    Number<PatchResult>{"pmax", stress, [](const PatchResult& p) { return p.pmax; }},
    Number<PatchResult>{"area", surface, [](const PatchResult& p) { return area_of_patch(p); }},
    Number<PatchResult>{"pmax_element", stress,
                        [](const PatchResult& p) { return p.pmax_element; }},
    Number<PatchResult>{"normal_force", force, [](const PatchResult& p) { return p.normal_force; }},
    Number<PatchResult>{"vertical_force", turning_force,
                        [](const PatchResult& p) { return p.force.z; }},
    Number<PatchResult>{"lateral_force", turning_force,
                        [](const PatchResult& p) { return p.force.y; }},
    Number<PatchResult>{"longitudinal_force", force,
                        [](const PatchResult& p) { return p.force.x; }},
    Number<PatchResult>{"moment.x", moment, [](const PatchResult& p) { return p.moment.x; }},
    Number<PatchResult>{"moment.y", turning_moment,
                        [](const PatchResult& p) { return p.moment.y; }},
    Number<PatchResult>{"moment.z", turning_moment,
                        [](const PatchResult& p) { return p.moment.z; }},
    Number<PatchResult>{"approach", length, [](const PatchResult& p) { return p.approach; }},
    Number<PatchResult>{"angle", angle, [](const PatchResult& p) { return p.angle; }},
    Number<PatchResult>{"semi_axes.0", length,
                        [](const PatchResult& p) { return p.semi_axis_longitudinal; }},
    Number<PatchResult>{"semi_axes.1", length,
                        [](const PatchResult& p) { return p.semi_axis_lateral; }},
    Number<PatchResult>{"radii.0", length,
                        [](const PatchResult& p) { return p.radius_longitudinal; }},
    Number<PatchResult>{"radii.1", length, [](const PatchResult& p) { return p.radius_lateral; }},
    Number<PatchResult>{"closeness", pure, [](const PatchResult& p) { return p.coupling_weight; }},
    Number<PatchResult>{"regions", pure, [](const PatchResult& p) { return regions_of_patch(p); }},
    Number<PatchResult>{"lobes", pure, [](const PatchResult& p) { return p.lobes; }},
    Number<PatchResult>{"fill", pure, [](const PatchResult& p) { return p.fill; }},
    Number<PatchResult>{"grid.0", pure, [](const PatchResult& p) { return p.grid.lateral_count; }},
    Number<PatchResult>{"grid.1", pure,
                        [](const PatchResult& p) { return p.grid.longitudinal_count; }},
    Number<PatchResult>{"element_size.0", length,
                        [](const PatchResult& p) { return p.grid.lateral_step; }},
    Number<PatchResult>{"element_size.1", length,
                        [](const PatchResult& p) { return p.grid.longitudinal_step; }},
};

/// With creep forces only.
inline constexpr auto creep_numbers = joined(
    std::array{
        Number<CreepResult>{"creepage.longitudinal", pure,
                            [](const CreepResult& c) { return c.creepages.longitudinal; }},
        Number<CreepResult>{"creepage.lateral", turning,
                            [](const CreepResult& c) { return c.creepages.lateral; }},
        Number<CreepResult>{"creepage.spin", turning_curvature,
                            [](const CreepResult& c) { return c.creepages.spin; }},
        Number<CreepResult>{"creep_force.longitudinal", force,
                            [](const CreepResult& c) { return c.longitudinal_force; }},
        Number<CreepResult>{"creep_force.lateral", turning_force,
                            [](const CreepResult& c) { return c.lateral_force; }},
        Number<CreepResult>{"spin_moment", turning_moment,
                            [](const CreepResult& c) { return c.spin_moment; }},
        Number<CreepResult>{"friction", pure, [](const CreepResult& c) { return c.friction; }},
        Number<CreepResult>{"slip_area", surface, [](const CreepResult& c) { return c.slip_area; }},
        Number<CreepResult>{"adhesion_area", surface,
                            [](const CreepResult& c) { return c.adhesion_area; }},
        Number<CreepResult>{"traction_max", stress,
                            [](const CreepResult& c) { return c.largest_traction; }},
        Number<CreepResult>{"wear_number", force,
                            [](const CreepResult& c) { return c.power_per_speed; }},
        Number<CreepResult>{"friction_power", power,
                            [](const CreepResult& c) { return c.friction_power; }},
        Number<CreepResult>{"numerical_loss", pure,
                            [](const CreepResult& c) { return c.numerical_loss; }},
        Number<CreepResult>{"creep_residual", pure,
                            [](const CreepResult& c) { return c.residual; }},
        Number<CreepResult>{"creep_convolutions", pure,
                            [](const CreepResult& c) { return c.convolutions; }},
        Number<CreepResult>{"creep_grid.0", pure,
                            [](const CreepResult& c) { return c.grid.lateral_count; }},
        Number<CreepResult>{"creep_grid.1", pure,
                            [](const CreepResult& c) { return c.grid.longitudinal_count; }},
        Number<CreepResult>{"creep_element_size.0", length,
                            [](const CreepResult& c) { return c.grid.lateral_step; }},
        Number<CreepResult>{"creep_element_size.1", length,
                            [](const CreepResult& c) { return c.grid.longitudinal_step; }},
        Number<CreepResult>{"creep_error_estimate", pure,
                            [](const CreepResult& c) { return c.error_estimate; }}},
    creep_rate_numbers);

/// Zeros without one.
inline const PatchResult& first_patch(const WheelResult& wheel) {
  static const PatchResult zeros;
  return wheel.patches.empty() ? zeros : wheel.patches.front();
}

inline constexpr std::array side_numbers{
    Number<WheelResult>{"vertical", turning_length,
                        [](const WheelResult& r) { return r.vertical; }},
    Number<WheelResult>{"pmax", stress, [](const WheelResult& r) { return r.pmax; }},
    Number<WheelResult>{"pmax_element", stress,
                        [](const WheelResult& r) { return r.pmax_element; }},
    Number<WheelResult>{"area", surface,
                        [](const WheelResult& r) {
                          double area = 0.0;
                          for (const PatchResult& patch : r.patches) {
                            area += area_of_patch(patch);
                          }
                          return area;
                        }},
    Number<WheelResult>{"normal_force", force, [](const WheelResult& r) { return r.normal_force; }},
    Number<WheelResult>{"vertical_force", turning_force,
                        [](const WheelResult& r) { return r.force.z; }},
    Number<WheelResult>{"lateral_force", turning_force,
                        [](const WheelResult& r) { return r.force.y; }},
    Number<WheelResult>{"longitudinal_force", force,
                        [](const WheelResult& r) { return r.force.x; }},
    Number<WheelResult>{"moment.x", moment, [](const WheelResult& r) { return r.moment.x; }},
    Number<WheelResult>{"moment.y", turning_moment,
                        [](const WheelResult& r) { return r.moment.y; }},
    Number<WheelResult>{"moment.z", turning_moment,
                        [](const WheelResult& r) { return r.moment.z; }},
    Number<WheelResult>{"approach", length, [](const WheelResult& r) { return r.approach; }},
    Number<WheelResult>{"depth", length, [](const WheelResult& r) { return r.depth; }},
    Number<WheelResult>{"angle", angle, [](const WheelResult& r) { return r.angle; }},
    Number<WheelResult>{"iterations", pure, [](const WheelResult& r) { return r.iterations; }},
    Number<WheelResult>{"convolutions", pure, [](const WheelResult& r) { return r.convolutions; }},
    Number<WheelResult>{"solutions", pure, [](const WheelResult& r) { return r.solutions; }},
    Number<WheelResult>{"state", pure,
                        [](const WheelResult& r) { return std::optional<double>(r.state); }},
    Number<WheelResult>{"patch_count", pure, [](const WheelResult& r) { return r.patches.size(); }},
    Number<WheelResult>{"fill", pure, [](const WheelResult& r) { return first_patch(r).fill; }},
    Number<WheelResult>{"grid.0", pure,
                        [](const WheelResult& r) { return first_patch(r).grid.lateral_count; }},
    Number<WheelResult>{
        "grid.1", pure,
        [](const WheelResult& r) { return first_patch(r).grid.longitudinal_count; }},
    Number<WheelResult>{"element_size.0", length,
                        [](const WheelResult& r) { return first_patch(r).grid.lateral_step; }},
    Number<WheelResult>{"element_size.1", length,
                        [](const WheelResult& r) { return first_patch(r).grid.longitudinal_step; }},
    Number<WheelResult>{"error_estimate", pure,
                        [](const WheelResult& r) { return r.error_estimate; }},
    Number<WheelResult>{"validity", pure, [](const WheelResult& r) { return r.validity; }},
};

inline constexpr std::array total_numbers{
    Number<TotalForce>{"force.x", force, [](const TotalForce& t) { return t.force.x; }},
    Number<TotalForce>{"force.y", turning_force, [](const TotalForce& t) { return t.force.y; }},
    Number<TotalForce>{"force.z", turning_force, [](const TotalForce& t) { return t.force.z; }},
    Number<TotalForce>{"moment.x", moment, [](const TotalForce& t) { return t.moment.x; }},
    Number<TotalForce>{"moment.y", turning_moment, [](const TotalForce& t) { return t.moment.y; }},
    Number<TotalForce>{"moment.z", turning_moment, [](const TotalForce& t) { return t.moment.z; }},
};

inline constexpr std::array residual_numbers{
    Number<Residuals>{"load_balance", pure, [](const Residuals& r) { return r.load_balance; }},
    Number<Residuals>{"least_gap", pure, [](const Residuals& r) { return r.least_gap; }},
    Number<Residuals>{"complementarity", pure,
                      [](const Residuals& r) { return r.complementarity; }},
};

inline constexpr std::array sensitivity_numbers{
    Number<WheelRates>{"lateral_force.lateral", stiffness,
                       [](const WheelRates& r) { return r.force.lateral.force.y; }},
    Number<WheelRates>{"lateral_force.vertical", stiffness,
                       [](const WheelRates& r) { return r.force.vertical.force.y; }},
    Number<WheelRates>{"lateral_force.roll", turning_force_by_angle,
                       [](const WheelRates& r) { return r.force.roll.force.y; }},
    Number<WheelRates>{"lateral_force.yaw", force_by_angle,
                       [](const WheelRates& r) { return r.force.yaw.force.y; }},
    Number<WheelRates>{"vertical_force.lateral", stiffness,
                       [](const WheelRates& r) { return r.force.lateral.force.z; }},
    Number<WheelRates>{"vertical_force.vertical", stiffness,
                       [](const WheelRates& r) { return r.force.vertical.force.z; }},
    Number<WheelRates>{"vertical_force.roll", turning_force_by_angle,
                       [](const WheelRates& r) { return r.force.roll.force.z; }},
    Number<WheelRates>{"vertical_force.yaw", force_by_angle,
                       [](const WheelRates& r) { return r.force.yaw.force.z; }},
};

/// With the height following, so that the vertical force stays.
inline constexpr std::array condensed_numbers{
    Number<CondensedRates>{"lateral_force.lateral", stiffness,
                           [](const CondensedRates& r) { return r.lateral.wheel.force.y; }},
    Number<CondensedRates>{"lateral_force.roll", turning_force_by_angle,
                           [](const CondensedRates& r) { return r.roll.wheel.force.y; }},
    Number<CondensedRates>{"vertical.lateral", pure,
                           [](const CondensedRates& r) { return r.lateral.vertical; }},
    Number<CondensedRates>{"vertical.roll", turning_length_by_angle,
                           [](const CondensedRates& r) { return r.roll.vertical; }},
};

inline constexpr std::array scene_numbers{
    Number<SceneResult>{"roll", angle, [](const SceneResult& r) { return r.roll; }},
    Number<SceneResult>{"vertical", turning_length,
                        [](const SceneResult& r) { return r.vertical; }},
    Number<SceneResult>{"rolling_radius_difference", length,
                        [](const SceneResult& r) { return r.rolling_radius_difference; }},
    Number<SceneResult>{"pitch", angle, [](const SceneResult& r) { return r.pitch; }},
};

inline constexpr std::array time_numbers{
    Number<StageMilliseconds>{"profile", milliseconds,
                              [](const StageMilliseconds& t) { return t.profile; }},
    Number<StageMilliseconds>{"setup", milliseconds,
                              [](const StageMilliseconds& t) { return t.setup; }},
    Number<StageMilliseconds>{"geometry", milliseconds,
                              [](const StageMilliseconds& t) { return t.geometry; }},
    Number<StageMilliseconds>{"remesh", milliseconds,
                              [](const StageMilliseconds& t) { return t.remesh; }},
    Number<StageMilliseconds>{"mechanics", milliseconds,
                              [](const StageMilliseconds& t) { return t.mechanics; }},
    Number<StageMilliseconds>{"rolling", milliseconds,
                              [](const StageMilliseconds& t) { return t.rolling; }},
    Number<StageMilliseconds>{"damage", milliseconds,
                              [](const StageMilliseconds& t) { return t.damage; }},
    Number<StageMilliseconds>{"total", milliseconds,
                              [](const StageMilliseconds& t) { return t.total; }},
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
