// Results by name: the one list that the C interface, JSON and tables are made of.
#include <algorithm>
#include <array>

#include "scene/solve_scene.hpp"

namespace wrc {
namespace {

using Numbers = std::vector<std::pair<std::string, double>>;
using Texts = std::vector<std::pair<std::string, std::string>>;

constexpr std::array<std::string_view, 10> names_of_fields{
    "x",      "y",       "z",      "undeformed_distance", "pressure", "displacement", "rail_y",
    "rail_z", "wheel_y", "wheel_z"};

void add_place(Numbers& numbers, const std::string& prefix, const ContactPlace& place) {
  numbers.emplace_back(prefix + "x", place.x);
  numbers.emplace_back(prefix + "y", place.y);
  numbers.emplace_back(prefix + "z", place.z);
  numbers.emplace_back(prefix + "s_wheel", place.s_wheel);
  numbers.emplace_back(prefix + "w_wheel", place.w_wheel);
  numbers.emplace_back(prefix + "t_rail", place.t_rail);
  numbers.emplace_back(prefix + "v_rail", place.v_rail);
  numbers.emplace_back(prefix + "rolling_radius", place.rolling_radius);
}

void add_touch(Numbers& numbers, const std::string& prefix, const ContactPlace& place) {
  add_place(numbers, prefix, place);
  numbers.emplace_back(prefix + "angle", place.angle);
  numbers.emplace_back(prefix + "wheel_angle", place.wheel_angle);
  numbers.emplace_back(prefix + "distance", place.distance);
}

void add_side(Numbers& numbers, const std::string& side, const SideResult& result) {
  const std::string prefix = side + '.';
  add_touch(numbers, prefix + "rigid_contact.", result.rigid_contact);
  for (std::size_t i = 0; i < result.near_contacts.size(); ++i) {
    add_touch(numbers, prefix + "near_contacts." + std::to_string(i) + '.',
              result.near_contacts[i]);
  }
  const auto add = [&](std::string_view name, double value) {
    numbers.emplace_back(prefix + std::string(name), value);
  };
  add("vertical", result.vertical);
  add("pmax", result.pmax);
  add("pmax_element", result.pmax_element);
  add("area", result.area);
  add("normal_force", result.normal_force);
  add("vertical_force", result.vertical_force);
  add("lateral_force", result.lateral_force);
  add("approach", result.approach);
  add("depth", result.depth);
  add("angle", result.angle);
  if (result.error_estimate) {
    add("error_estimate", *result.error_estimate);
  }
  add("iterations", result.iterations);
  add("regrown", result.regrown);
  add("fill", result.fill);
  add("residuals.load_balance", result.residuals.load_balance);
  add("residuals.least_gap", result.residuals.least_gap);
  add("residuals.complementarity", result.residuals.complementarity);
  add("grid.0", static_cast<double>(result.grid.lateral_count));
  add("grid.1", static_cast<double>(result.grid.longitudinal_count));
  add("element_size.0", result.grid.lateral_step);
  add("element_size.1", result.grid.longitudinal_step);
  for (std::size_t i = 0; i < result.patches.size(); ++i) {
    const PatchResult& patch = result.patches[i];
    const std::string name = prefix + "patches." + std::to_string(i) + '.';
    numbers.emplace_back(name + "pmax", patch.pmax);
    numbers.emplace_back(name + "area", patch.area);
    numbers.emplace_back(name + "normal_force", patch.normal_force);
    numbers.emplace_back(name + "approach", patch.approach);
    numbers.emplace_back(name + "angle", patch.angle);
    add_place(numbers, name, patch.centre);
    numbers.emplace_back(name + "semi_axes.0", patch.semi_axis_longitudinal);
    numbers.emplace_back(name + "semi_axes.1", patch.semi_axis_lateral);
  }
}

void add_side(Texts& texts, const std::string& side, const SideResult& result) {
  texts.emplace_back(side + ".stop_reason", name_of(result.stop_reason));
  for (std::size_t i = 0; i < result.warnings.size(); ++i) {
    texts.emplace_back(side + ".warnings." + std::to_string(i), result.warnings[i]);
  }
}

} // namespace

std::vector<std::pair<std::string, double>> number_values(const SceneResult& result) {
  Numbers numbers;
  numbers.emplace_back("roll", result.roll);
  numbers.emplace_back("vertical", result.vertical);
  if (result.rolling_radius_difference) {
    numbers.emplace_back("rolling_radius_difference", *result.rolling_radius_difference);
  }
  if (result.left) {
    add_side(numbers, "left", *result.left);
  }
  if (result.right) {
    add_side(numbers, "right", *result.right);
  }
  numbers.emplace_back("time_ms.profile", result.time.profile);
  numbers.emplace_back("time_ms.setup", result.time.setup);
  numbers.emplace_back("time_ms.geometry", result.time.geometry);
  numbers.emplace_back("time_ms.remesh", result.time.remesh);
  numbers.emplace_back("time_ms.mechanics", result.time.mechanics);
  numbers.emplace_back("time_ms.total", result.time.total);
  return numbers;
}

std::vector<std::pair<std::string, std::string>> text_values(const SceneResult& result) {
  Texts texts;
  texts.emplace_back("model", result.model);
  texts.emplace_back("solver", result.solver);
  texts.emplace_back("units", "mm, N, MPa, rad");
  for (std::size_t i = 0; i < result.corrections.size(); ++i) {
    texts.emplace_back("corrections." + std::to_string(i), result.corrections[i]);
  }
  if (result.left) {
    add_side(texts, "left", *result.left);
  }
  if (result.right) {
    add_side(texts, "right", *result.right);
  }
  return texts;
}

std::span<const std::string_view> field_names() {
  return names_of_fields;
}

std::span<const double> field_values(const SceneResult& result, std::string_view name) {
  const auto dot = name.find('.');
  if (dot == std::string_view::npos) {
    return {};
  }
  const std::string_view side_name = name.substr(0, dot);
  const auto& side = side_name == "left" ? result.left : result.right;
  if ((side_name != "left" && side_name != "right") || !side) {
    return {};
  }
  const std::array<const std::vector<double>*, names_of_fields.size()> fields{
      &side->fields.x,        &side->fields.y,
      &side->fields.z,        &side->fields.undeformed_distance,
      &side->fields.pressure, &side->fields.displacement,
      &side->section.rail_y,  &side->section.rail_z,
      &side->section.wheel_y, &side->section.wheel_z};
  const auto found =
      std::find(names_of_fields.begin(), names_of_fields.end(), name.substr(dot + 1));
  return found == names_of_fields.end()
             ? std::span<const double>{}
             : std::span<const double>(
                   *fields[static_cast<std::size_t>(found - names_of_fields.begin())]);
}

} // namespace wrc
