// Results by name: the one list that the C interface, JSON and tables are made of.
#include <algorithm>
#include <array>

#include "pressure/contact_area.hpp"
#include "scene/result_names.hpp"
#include "scene/solve_scene.hpp"
#include "wheel/total_force.hpp"
#include "wheel/wheel_sensitivities.hpp"

namespace wrc {
namespace {

using namespace dimensions;

/// A number in mm, y left, z up, and what it is.
struct Value {
  double value;
  Dimension dimension;
};

/// A name and how to read its value.
template <class Owner> struct Number {
  std::string_view name;
  Dimension dimension;
  double (*value)(const Owner&);
};

/// The value of a name in a table; none if it is not there.
template <class Owner, std::size_t count>
std::optional<Value> find_in(const std::array<Number<Owner>, count>& table, const Owner& owner,
                             std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const auto& entry) { return entry.name == name; });
  return found == table.end() ? std::nullopt
                              : std::optional(Value{found->value(owner), found->dimension});
}

template <class Owner, std::size_t count>
void add_names(std::vector<std::string>& names, const std::string& prefix,
               const std::array<Number<Owner>, count>& table) {
  for (const auto& entry : table) {
    names.push_back(prefix + std::string(entry.name));
  }
}

constexpr std::array place_numbers{
    Number<ContactPoint>{"x", length, [](const ContactPoint& p) { return p.x; }},
    Number<ContactPoint>{"y", turning_length, [](const ContactPoint& p) { return p.y; }},
    Number<ContactPoint>{"z", turning_length, [](const ContactPoint& p) { return p.z; }},
    Number<ContactPoint>{"s_wheel", length, [](const ContactPoint& p) { return p.s_wheel; }},
    Number<ContactPoint>{"w_wheel", length, [](const ContactPoint& p) { return p.w_wheel; }},
    Number<ContactPoint>{"t_rail", length, [](const ContactPoint& p) { return p.t_rail; }},
    Number<ContactPoint>{"v_rail", length, [](const ContactPoint& p) { return p.v_rail; }},
    Number<ContactPoint>{"rolling_radius", length,
                         [](const ContactPoint& p) { return p.rolling_radius; }},
    Number<ContactPoint>{"wheel_angle", pure, [](const ContactPoint& p) { return p.wheel_angle; }},
};

/// Of a touch only; a patch has an angle of its own.
constexpr std::array touch_numbers{
    Number<ContactPoint>{"angle", pure, [](const ContactPoint& p) { return p.angle; }},
    Number<ContactPoint>{"distance", length, [](const ContactPoint& p) { return p.distance; }},
};

/// Computed on request, unless a model has given it.
double area_of_patch(const PatchResult& patch) {
  if (patch.parts.empty()) {
    return patch.area ? *patch.area : contact_area(patch.grid, patch.pressure);
  }
  double area = 0.0;
  for (const PatchResult& part : patch.parts) {
    area += area_of_patch(part);
  }
  return area;
}

double regions_of_patch(const PatchResult& patch) {
  if (patch.parts.empty()) {
    return static_cast<double>(pressure_regions(patch.grid, patch.pressure).size());
  }
  double count = 0.0;
  for (const PatchResult& part : patch.parts) {
    count += regions_of_patch(part);
  }
  return count;
}

constexpr std::array patch_numbers{
    Number<PatchResult>{"pmax", stress, [](const PatchResult& p) { return p.pmax; }},
    Number<PatchResult>{"area", surface, area_of_patch},
    Number<PatchResult>{"pmax_element", stress,
                        [](const PatchResult& p) { return p.pmax_element; }},
    Number<PatchResult>{"normal_force", pure, [](const PatchResult& p) { return p.normal_force; }},
    Number<PatchResult>{"vertical_force", turning_force,
                        [](const PatchResult& p) { return p.force.z; }},
    Number<PatchResult>{"lateral_force", turning_force,
                        [](const PatchResult& p) { return p.force.y; }},
    Number<PatchResult>{"longitudinal_force", pure, [](const PatchResult& p) { return p.force.x; }},
    Number<PatchResult>{"moment.x", moment, [](const PatchResult& p) { return p.moment.x; }},
    Number<PatchResult>{"moment.y", turning_moment,
                        [](const PatchResult& p) { return p.moment.y; }},
    Number<PatchResult>{"moment.z", turning_moment,
                        [](const PatchResult& p) { return p.moment.z; }},
    Number<PatchResult>{"approach", length, [](const PatchResult& p) { return p.approach; }},
    Number<PatchResult>{"angle", pure, [](const PatchResult& p) { return p.angle; }},
    Number<PatchResult>{"semi_axes.0", length,
                        [](const PatchResult& p) { return p.semi_axis_longitudinal; }},
    Number<PatchResult>{"semi_axes.1", length,
                        [](const PatchResult& p) { return p.semi_axis_lateral; }},
    Number<PatchResult>{"radii.0", length,
                        [](const PatchResult& p) { return p.radius_longitudinal; }},
    Number<PatchResult>{"radii.1", length, [](const PatchResult& p) { return p.radius_lateral; }},
    Number<PatchResult>{"closeness", pure, [](const PatchResult& p) { return p.coupling_weight; }},
    Number<PatchResult>{"regions", pure, regions_of_patch},
    Number<PatchResult>{"lobes", pure,
                        [](const PatchResult& p) { return static_cast<double>(p.lobes); }},
    Number<PatchResult>{"fill", pure, [](const PatchResult& p) { return p.fill; }},
    Number<PatchResult>{
        "grid.0", pure,
        [](const PatchResult& p) { return static_cast<double>(p.grid.lateral_count); }},
    Number<PatchResult>{
        "grid.1", pure,
        [](const PatchResult& p) { return static_cast<double>(p.grid.longitudinal_count); }},
    Number<PatchResult>{"element_size.0", length,
                        [](const PatchResult& p) { return p.grid.lateral_step; }},
    Number<PatchResult>{"element_size.1", length,
                        [](const PatchResult& p) { return p.grid.longitudinal_step; }},
};

/// With creep forces only.
constexpr std::array creep_numbers{
    Number<CreepResult>{"creepage.longitudinal", pure,
                        [](const CreepResult& c) { return c.creepages.longitudinal; }},
    Number<CreepResult>{"creepage.lateral", turning_angle,
                        [](const CreepResult& c) { return c.creepages.lateral; }},
    Number<CreepResult>{"creepage.spin", turning_curvature,
                        [](const CreepResult& c) { return c.creepages.spin; }},
    Number<CreepResult>{"creep_force.longitudinal", pure,
                        [](const CreepResult& c) { return c.longitudinal_force; }},
    Number<CreepResult>{"creep_force.lateral", turning_force,
                        [](const CreepResult& c) { return c.lateral_force; }},
    Number<CreepResult>{"spin_moment", turning_moment,
                        [](const CreepResult& c) { return c.spin_moment; }},
    Number<CreepResult>{"slip_area", surface, [](const CreepResult& c) { return c.slip_area; }},
    Number<CreepResult>{"adhesion_area", surface,
                        [](const CreepResult& c) { return c.adhesion_area; }},
    Number<CreepResult>{"traction_max", stress,
                        [](const CreepResult& c) { return c.largest_traction; }},
    Number<CreepResult>{"wear_number", pure,
                        [](const CreepResult& c) { return c.power_per_speed; }},
    Number<CreepResult>{"friction_power", moment,
                        [](const CreepResult& c) { return c.friction_power; }},
    Number<CreepResult>{"numerical_loss", pure,
                        [](const CreepResult& c) { return c.numerical_loss; }},
    Number<CreepResult>{"creep_residual", pure, [](const CreepResult& c) { return c.residual; }},
    Number<CreepResult>{"creep_convolutions", pure,
                        [](const CreepResult& c) { return static_cast<double>(c.convolutions); }},
    Number<CreepResult>{
        "creep_grid.0", pure,
        [](const CreepResult& c) { return static_cast<double>(c.grid.lateral_count); }},
    Number<CreepResult>{
        "creep_grid.1", pure,
        [](const CreepResult& c) { return static_cast<double>(c.grid.longitudinal_count); }},
    Number<CreepResult>{"creep_element_size.0", length,
                        [](const CreepResult& c) { return c.grid.lateral_step; }},
    Number<CreepResult>{"creep_element_size.1", length,
                        [](const CreepResult& c) { return c.grid.longitudinal_step; }},
};

constexpr std::array side_numbers{
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
    Number<WheelResult>{"normal_force", pure, [](const WheelResult& r) { return r.normal_force; }},
    Number<WheelResult>{"vertical_force", turning_force,
                        [](const WheelResult& r) { return r.force.z; }},
    Number<WheelResult>{"lateral_force", turning_force,
                        [](const WheelResult& r) { return r.force.y; }},
    Number<WheelResult>{"longitudinal_force", pure, [](const WheelResult& r) { return r.force.x; }},
    Number<WheelResult>{"moment.x", moment, [](const WheelResult& r) { return r.moment.x; }},
    Number<WheelResult>{"moment.y", turning_moment,
                        [](const WheelResult& r) { return r.moment.y; }},
    Number<WheelResult>{"moment.z", turning_moment,
                        [](const WheelResult& r) { return r.moment.z; }},
    Number<WheelResult>{"approach", length, [](const WheelResult& r) { return r.approach; }},
    Number<WheelResult>{"depth", length, [](const WheelResult& r) { return r.depth; }},
    Number<WheelResult>{"angle", pure, [](const WheelResult& r) { return r.angle; }},
    Number<WheelResult>{"iterations", pure,
                        [](const WheelResult& r) { return static_cast<double>(r.iterations); }},
    Number<WheelResult>{"convolutions", pure,
                        [](const WheelResult& r) { return static_cast<double>(r.convolutions); }},
    Number<WheelResult>{"solutions", pure,
                        [](const WheelResult& r) { return static_cast<double>(r.solutions); }},
};

constexpr std::array total_numbers{
    Number<TotalForce>{"force.x", pure, [](const TotalForce& t) { return t.force.x; }},
    Number<TotalForce>{"force.y", turning_force, [](const TotalForce& t) { return t.force.y; }},
    Number<TotalForce>{"force.z", turning_force, [](const TotalForce& t) { return t.force.z; }},
    Number<TotalForce>{"moment.x", moment, [](const TotalForce& t) { return t.moment.x; }},
    Number<TotalForce>{"moment.y", turning_moment, [](const TotalForce& t) { return t.moment.y; }},
    Number<TotalForce>{"moment.z", turning_moment, [](const TotalForce& t) { return t.moment.z; }},
};

/// Of the first patch, also returned for the wheel.
constexpr std::array<std::string_view, 5> first_patch_names{"fill", "grid.0", "grid.1",
                                                            "element_size.0", "element_size.1"};

constexpr std::array residual_numbers{
    Number<Residuals>{"load_balance", pure, [](const Residuals& r) { return r.load_balance; }},
    Number<Residuals>{"least_gap", pure, [](const Residuals& r) { return r.least_gap; }},
    Number<Residuals>{"complementarity", pure,
                      [](const Residuals& r) { return r.complementarity; }},
};

constexpr std::array sensitivity_numbers{
    Number<WheelRates>{"lateral_force.lateral", stiffness,
                       [](const WheelRates& r) { return r.force.lateral.force.y; }},
    Number<WheelRates>{"lateral_force.vertical", stiffness,
                       [](const WheelRates& r) { return r.force.vertical.force.y; }},
    Number<WheelRates>{"lateral_force.roll", turning_force,
                       [](const WheelRates& r) { return r.force.roll.force.y; }},
    Number<WheelRates>{"vertical_force.lateral", stiffness,
                       [](const WheelRates& r) { return r.force.lateral.force.z; }},
    Number<WheelRates>{"vertical_force.vertical", stiffness,
                       [](const WheelRates& r) { return r.force.vertical.force.z; }},
    Number<WheelRates>{"vertical_force.roll", turning_force,
                       [](const WheelRates& r) { return r.force.roll.force.z; }},
};

/// With the height following, so that the vertical force stays.
constexpr std::array condensed_numbers{
    Number<CondensedRates>{"lateral_force.lateral", stiffness,
                           [](const CondensedRates& r) { return r.lateral.wheel.force.y; }},
    Number<CondensedRates>{"lateral_force.roll", turning_force,
                           [](const CondensedRates& r) { return r.roll.wheel.force.y; }},
    Number<CondensedRates>{"vertical.lateral", pure,
                           [](const CondensedRates& r) { return r.lateral.vertical; }},
    Number<CondensedRates>{"vertical.roll", turning_length,
                           [](const CondensedRates& r) { return r.roll.vertical; }},
};

constexpr std::array time_numbers{
    Number<StageMilliseconds>{"profile", pure,
                              [](const StageMilliseconds& t) { return t.profile; }},
    Number<StageMilliseconds>{"setup", pure, [](const StageMilliseconds& t) { return t.setup; }},
    Number<StageMilliseconds>{"geometry", pure,
                              [](const StageMilliseconds& t) { return t.geometry; }},
    Number<StageMilliseconds>{"remesh", pure, [](const StageMilliseconds& t) { return t.remesh; }},
    Number<StageMilliseconds>{"mechanics", pure,
                              [](const StageMilliseconds& t) { return t.mechanics; }},
    Number<StageMilliseconds>{"rolling", pure,
                              [](const StageMilliseconds& t) { return t.rolling; }},
    Number<StageMilliseconds>{"total", pure, [](const StageMilliseconds& t) { return t.total; }},
};

std::optional<Value> touch_value(const ContactPoint& place, std::string_view name) {
  const auto value = find_in(place_numbers, place, name);
  return value ? value : find_in(touch_numbers, place, name);
}

std::optional<Value> sensitivity_value(WheelResult& side, std::string_view name) {
  // Unknown names cost no solution.
  const bool at_load = strip_prefix(name, "at_load.");
  const bool known = at_load ? find_in(condensed_numbers, CondensedRates{}, name).has_value()
                             : find_in(sensitivity_numbers, WheelRates{}, name).has_value();
  const WheelRates* rates = known ? sensitivities_of(side) : nullptr;
  if (rates == nullptr || (at_load && !rates->at_load)) {
    return std::nullopt;
  }
  return at_load ? find_in(condensed_numbers, *rates->at_load, name)
                 : find_in(sensitivity_numbers, *rates, name);
}

std::optional<Value> patch_value(const PatchResult& patch, std::string_view name) {
  std::size_t index = 0;
  if (strip_prefix(name, "parts.")) {
    return strip_index(name, patch.parts.size(), index) ? patch_value(patch.parts[index], name)
                                                        : std::nullopt;
  }
  if (strip_prefix(name, "centroid.")) {
    return touch_value(patch.centroid, name);
  }
  auto value = find_in(patch_numbers, patch, name);
  if (!value && patch.creep) {
    value = find_in(creep_numbers, *patch.creep, name);
    if (name == "creep_error_estimate" && patch.creep->error_estimate) {
      value = Value{*patch.creep->error_estimate, pure};
    }
  }
  return value ? value : find_in(place_numbers, patch.reference, name);
}

std::optional<Value> side_value(WheelResult& side, std::string_view name) {
  std::size_t index = 0;
  if (strip_prefix(name, "rigid_contact.")) {
    return touch_value(side.rigid_contact, name);
  }
  if (strip_prefix(name, "near_contacts.")) {
    return strip_index(name, side.near_contacts.size(), index)
               ? touch_value(side.near_contacts[index], name)
               : std::nullopt;
  }
  if (strip_prefix(name, "patches.")) {
    return strip_index(name, side.patches.size(), index) ? patch_value(side.patches[index], name)
                                                         : std::nullopt;
  }
  if (strip_prefix(name, "centroid.")) {
    return touch_value(side.centroid, name);
  }
  if (std::find(first_patch_names.begin(), first_patch_names.end(), name) !=
      first_patch_names.end()) {
    const PatchResult none;
    return find_in(patch_numbers, side.patches.empty() ? none : side.patches.front(), name);
  }
  if (strip_prefix(name, "residuals.")) {
    // Unknown names cost no convolution.
    const bool known = find_in(residual_numbers, Residuals{}, name) && side.solved;
    return known ? find_in(residual_numbers, residuals_of(side), name) : std::nullopt;
  }
  if (strip_prefix(name, "sensitivities.")) {
    return sensitivity_value(side, name);
  }
  if (strip_prefix(name, "total.")) {
    return side.solved ? find_in(total_numbers, total_force(side), name) : std::nullopt;
  }
  if (name == "error_estimate") {
    return side.error_estimate ? std::optional(Value{*side.error_estimate, pure}) : std::nullopt;
  }
  if (name == "validity") {
    return side.validity ? std::optional(Value{*side.validity, pure}) : std::nullopt;
  }
  return find_in(side_numbers, side, name);
}

void add_centroid_names(std::vector<std::string>& names, const std::string& centroid) {
  add_names(names, centroid, place_numbers);
  names.push_back(centroid + "angle");
}

void add_patch_names(std::vector<std::string>& names, const std::string& prefix,
                     const PatchResult& patch) {
  add_names(names, prefix, patch_numbers);
  add_names(names, prefix, place_numbers);
  add_centroid_names(names, prefix + "centroid.");
  if (patch.creep) {
    add_names(names, prefix, creep_numbers);
    if (patch.creep->error_estimate) {
      names.push_back(prefix + "creep_error_estimate");
    }
  }
  for (std::size_t i = 0; i < patch.parts.size(); ++i) {
    add_patch_names(names, prefix + "parts." + std::to_string(i) + '.', patch.parts[i]);
  }
}

void add_side_names(std::vector<std::string>& names, const std::string& prefix,
                    const WheelResult& side) {
  const auto add_touch = [&names](const std::string& touch) {
    add_names(names, touch, place_numbers);
    add_names(names, touch, touch_numbers);
  };
  add_touch(prefix + "rigid_contact.");
  for (std::size_t i = 0; i < side.near_contacts.size(); ++i) {
    add_touch(prefix + "near_contacts." + std::to_string(i) + '.');
  }
  add_names(names, prefix, side_numbers);
  if (side.solved) {
    add_names(names, prefix + "total.", total_numbers);
  }
  add_centroid_names(names, prefix + "centroid.");
  for (const std::string_view name : first_patch_names) {
    names.push_back(prefix + std::string(name));
  }
  if (side.error_estimate) {
    names.push_back(prefix + "error_estimate");
  }
  if (side.validity) {
    names.push_back(prefix + "validity");
  }
  if (side.solved) {
    add_names(names, prefix + "residuals.", residual_numbers);
  }
  if (side.solved && !side.patches.empty() && !side.validity) {
    add_names(names, prefix + "sensitivities.", sensitivity_numbers);
    add_names(names, prefix + "sensitivities.at_load.", condensed_numbers);
  }
  for (std::size_t i = 0; i < side.patches.size(); ++i) {
    add_patch_names(names, prefix + "patches." + std::to_string(i) + '.', side.patches[i]);
  }
}

void add_side_texts(std::vector<std::pair<std::string, std::string>>& texts,
                    const std::string& prefix, const WheelResult& side) {
  texts.emplace_back(prefix + "model", side.model);
  texts.emplace_back(prefix + "model_reason", side.model_reason);
  texts.emplace_back(prefix + "stop_reason", name_of(side.stop_reason));
  for (std::size_t i = 0; i < side.warnings.size(); ++i) {
    texts.emplace_back(prefix + "warnings." + std::to_string(i), side.warnings[i]);
  }
}

bool has_wheelset_force(const SceneResult& result) {
  return result.left && result.left->solved && result.right && result.right->solved;
}

TotalForce wheelset_force(const SceneResult& result) {
  const TotalForce left = total_force(*result.left);
  const TotalForce right = total_force(*result.right);
  return {left.force + right.force, left.moment + right.moment};
}

std::optional<Value> value_of(SceneResult& result, std::string_view name) {
  if (name == "roll") {
    return Value{result.roll, pure};
  }
  if (name == "vertical") {
    return Value{result.vertical, turning_length};
  }
  if (name == "rolling_radius_difference" && result.rolling_radius_difference) {
    return Value{*result.rolling_radius_difference, length};
  }
  if (strip_prefix(name, "time_ms.")) {
    return find_in(time_numbers, result.time, name);
  }
  if (strip_prefix(name, "wheelset.")) {
    return has_wheelset_force(result) ? find_in(total_numbers, wheelset_force(result), name)
                                      : std::nullopt;
  }
  if (strip_prefix(name, "left.")) {
    return result.left ? side_value(*result.left, name) : std::nullopt;
  }
  return strip_prefix(name, "right.") && result.right ? side_value(*result.right, name)
                                                      : std::nullopt;
}

} // namespace

std::vector<std::string> number_names(const SceneResult& result) {
  std::vector<std::string> names{"roll", "vertical"};
  if (result.rolling_radius_difference) {
    names.emplace_back("rolling_radius_difference");
  }
  if (result.left) {
    add_side_names(names, "left.", *result.left);
  }
  if (result.right) {
    add_side_names(names, "right.", *result.right);
  }
  if (has_wheelset_force(result)) {
    add_names(names, "wheelset.", total_numbers);
  }
  add_names(names, "time_ms.", time_numbers);
  return names;
}

std::optional<double> number_value(SceneResult& result, std::string_view name,
                                   const Convention& convention) {
  const auto value = value_of(result, name);
  return value ? std::optional(to_caller(value->value, convention, value->dimension))
               : std::nullopt;
}

std::vector<std::pair<std::string, std::string>> text_values(const SceneResult& result,
                                                             const Convention& convention) {
  std::vector<std::pair<std::string, std::string>> texts;
  texts.emplace_back("model", result.model);
  texts.emplace_back("solver", name_of(result.solver));
  texts.emplace_back("units", name_of(convention.units));
  texts.emplace_back("frame", name_of(convention.frame));
  for (std::size_t i = 0; i < result.corrections.size(); ++i) {
    texts.emplace_back("corrections." + std::to_string(i), result.corrections[i]);
  }
  if (result.left) {
    add_side_texts(texts, "left.", *result.left);
  }
  if (result.right) {
    add_side_texts(texts, "right.", *result.right);
  }
  return texts;
}

} // namespace wrc
