// Numbers of a result by id, and all there are, by name: the one list that the C interface, JSON
// and tables are made of.
#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "results/grade.hpp"
#include "scene/noise_spread.hpp"
#include "scene/number_ids.hpp"
#include "scene/number_tables.hpp"
#include "scene/solve_scene.hpp"

namespace wrc {
namespace {

using namespace number_tables;

/// What is read, and for whom.
struct Reading {
  const NumberId& id;
  const Convention& convention;
  /// Whether it is of a number that is always there, if not-a-number at times.
  mutable bool is_always = false;

  /// From a table; `none` if there is nothing the number could belong to.
  template <class Owner, std::size_t count>
  double value(const std::array<Number<Owner>, count>& table,
               const std::type_identity_t<Owner>* owner) const {
    const Number<Owner>& number = table[id.entry];
    is_always = owner != nullptr && number.always;
    return owner != nullptr ? to_caller(number.value(*owner), convention, number.dimension) : none;
  }
};

template <class Owner> auto address_of(const Owner& owner) {
  return owner ? &*owner : nullptr;
}

template <class Owner> const Owner* at(const std::vector<Owner>& owners, std::size_t index) {
  return index < owners.size() ? &owners[index] : nullptr;
}

double patch_value(const WheelResult& side, const Reading& reading) {
  const NumberId& id = reading.id;
  const PatchResult* patch = at(side.patches, id.index);
  if (patch != nullptr && id.part > 0) {
    patch = at(patch->parts, id.part - 1);
  }
  if (patch == nullptr) {
    return none;
  }
  switch (id.group) {
  case NumberGroup::reference:
    return reading.value(place_numbers, &patch->reference);
  case NumberGroup::patch_centroid:
    return reading.value(centroid_numbers, &patch->centroid);
  case NumberGroup::creep:
    return reading.value(creep_numbers, address_of(patch->creep));
  case NumberGroup::damage:
    return reading.value(damage_numbers, address_of(patch->damage));
  default:
    return reading.value(patch_numbers, patch);
  }
}

/// The result of the wheel that the number is of.
std::optional<SceneWheel>& side_of(SceneResult& result, const NumberId& id) {
  return id.right ? result.right : result.left;
}

/// Not-a-number where too few solutions with likely curves have the number.
double spread_value(SceneResult& result, const Reading& reading) {
  const auto value_in = [&](const SceneSpread& spread) {
    return reading.id.group == NumberGroup::scene_spread
               ? reading.value(scene_spread_numbers, &spread)
               : reading.value(spread_numbers, reading.id.right ? &spread.right : &spread.left);
  };
  const bool exists = !std::isnan(value_in(exact_spread(result)));
  const double value = exists ? value_in(spread_of(result)) : none;
  reading.is_always = exists;
  return value;
}

/// Not-a-number where the solution with the smoothed profiles fails.
double smoothed_value(SceneResult& result, const Reading& reading) {
  const std::optional<SceneWheel>& side = side_of(result, reading.id);
  const SmoothedScene* const smoothed = side && side->solved ? smoothed_of(result) : nullptr;
  if (smoothed == nullptr) {
    return none;
  }
  const double value =
      reading.value(smoothed_numbers, reading.id.right ? &smoothed->right : &smoothed->left);
  reading.is_always = true;
  return value;
}

double side_value(SceneWheel& side, const Reading& reading) {
  switch (reading.id.group) {
  case NumberGroup::side:
    return reading.value(side_numbers, &side);
  case NumberGroup::total:
    return reading.value(total_numbers, address_of(side.total));
  case NumberGroup::rigid_contact:
    return reading.value(touch_numbers, &side.rigid_contact);
  case NumberGroup::centroid:
    return reading.value(centroid_numbers, &side.centroid);
  case NumberGroup::residuals:
    return reading.value(residual_numbers, side.solved ? &side.residuals() : nullptr);
  case NumberGroup::sensitivities:
    return reading.value(sensitivity_numbers, side.sensitivities());
  case NumberGroup::at_load: {
    const WheelRates* rates = side.sensitivities();
    return reading.value(condensed_numbers,
                         rates != nullptr ? address_of(rates->at_load) : nullptr);
  }
  case NumberGroup::jacobian:
    return reading.value(jacobian_numbers, side.jacobian());
  case NumberGroup::side_damage:
    return reading.value(damage_numbers, address_of(side.damage));
  case NumberGroup::near_contact:
    return reading.value(touch_numbers, at(side.near_contacts, reading.id.index));
  default:
    return patch_value(side, reading);
  }
}

std::optional<WheelForce> wheelset_force(const SceneResult& result) {
  if (!result.left || !result.left->total || !result.right || !result.right->total) {
    return std::nullopt;
  }
  const WheelForce& left = *result.left->total;
  const WheelForce& right = *result.right->total;
  return WheelForce{left.force + right.force, left.moment + right.moment};
}

/// Values of a table for an owner; without one, those that are always there.
template <class Owner, std::size_t count>
void add_names(std::vector<std::string>& names, const std::string& prefix,
               const std::array<Number<Owner>, count>& table,
               const std::type_identity_t<Owner>* owner = nullptr) {
  for (const Number<Owner>& number : table) {
    if (number.always || (owner != nullptr && !std::isnan(number.value(*owner)))) {
      names.push_back(prefix + std::string(number.name));
    }
  }
}

void add_patch_names(std::vector<std::string>& names, const std::string& prefix,
                     const PatchResult& patch) {
  add_names(names, prefix, patch_numbers, &patch);
  add_names(names, prefix, place_numbers);
  add_names(names, prefix + "centroid.", centroid_numbers);
  if (patch.creep) {
    add_names(names, prefix, creep_numbers, &*patch.creep);
  }
  add_names(names, prefix, damage_numbers, address_of(patch.damage));
  for (std::size_t i = 0; i < patch.parts.size(); ++i) {
    add_patch_names(names, prefix + "parts." + std::to_string(i) + '.', patch.parts[i]);
  }
}

bool has_creep_derivatives(const WheelResult& side) {
  const auto patches = solved_patches(side);
  return std::any_of(patches.begin(), patches.end(), [](const PatchResult* patch) {
    return patch->creep && patch->creep->derivatives;
  });
}

void add_side_names(std::vector<std::string>& names, const std::string& prefix, SceneWheel& side) {
  add_names(names, prefix + "rigid_contact.", touch_numbers);
  for (std::size_t i = 0; i < side.near_contacts.size(); ++i) {
    add_names(names, prefix + "near_contacts." + std::to_string(i) + '.', touch_numbers);
  }
  add_names(names, prefix, side_numbers, &side);
  add_names(names, prefix, damage_numbers, address_of(side.damage));
  if (side.total) {
    add_names(names, prefix + "total.", total_numbers);
  }
  add_names(names, prefix + "centroid.", centroid_numbers);
  if (side.solved) {
    add_names(names, prefix + "residuals.", residual_numbers);
  }
  // Results of solutions that have not converged may be not-a-number. Others are not computed for a
  // name.
  const bool converged = side.stop_reason == StopReason::tolerance_met;
  if (side.solved && !side.patches.empty() && !side.validity && !is_pressed_again(side) &&
      ((converged && side.depth > 0.0) || side.sensitivities() != nullptr)) {
    add_names(names, prefix + "sensitivities.", sensitivity_numbers);
    add_names(names, prefix + "sensitivities.at_load.", condensed_numbers);
    if (has_creep_derivatives(side)) {
      add_names(names, prefix + "jacobian.", jacobian_numbers);
    }
  }
  for (std::size_t i = 0; i < side.patches.size(); ++i) {
    add_patch_names(names, prefix + "patches." + std::to_string(i) + '.', side.patches[i]);
  }
}

void add_side_texts(std::vector<std::pair<std::string, std::string>>& texts,
                    const std::string& prefix, const WheelResult& side) {
  texts.emplace_back(prefix + "model", side.model);
  texts.emplace_back(prefix + "model_reason", side.model_reason);
  texts.emplace_back(prefix + "steels", side.steels);
  texts.emplace_back(prefix + "stop_reason", name_of(side.stop_reason));
  for (std::size_t i = 0; i < side.warnings.size(); ++i) {
    texts.emplace_back(prefix + "warnings." + std::to_string(i), side.warnings[i].text);
  }
}

} // namespace

std::vector<std::string> number_names(SceneResult& result) {
  std::vector<std::string> names;
  add_names(names, "", scene_numbers, &result);
  const SceneSpread spread = exact_spread(result);
  add_names(names, "spread.", scene_spread_numbers, &spread);
  for (const bool right : {false, true}) {
    std::optional<SceneWheel>& side = right ? result.right : result.left;
    const std::string prefix = right ? "right." : "left.";
    if (side) {
      add_side_names(names, prefix, *side);
      add_names(names, prefix + "spread.", spread_numbers, right ? &spread.right : &spread.left);
      if (result.noise && side->solved) {
        for (const auto& number : smoothed_numbers) { // not computed for a name
          names.push_back(prefix + "smoothed_" + std::string(number.name));
        }
      }
    }
  }
  if (wheelset_force(result)) {
    add_names(names, "wheelset.", total_numbers);
  }
  add_names(names, "time_ms.", time_numbers);
  return names;
}

namespace {

double read(SceneResult& result, const Reading& reading) {
  switch (reading.id.group) {
  case NumberGroup::scene:
    return reading.value(scene_numbers, &result);
  case NumberGroup::time:
    return reading.value(time_numbers, &result.time);
  case NumberGroup::wheelset: {
    const auto force = wheelset_force(result);
    return reading.value(total_numbers, address_of(force));
  }
  case NumberGroup::spread:
  case NumberGroup::scene_spread:
    return spread_value(result, reading);
  case NumberGroup::smoothed:
    return smoothed_value(result, reading);
  default:
    break;
  }
  std::optional<SceneWheel>& side = side_of(result, reading.id);
  return side ? side_value(*side, reading) : none;
}

} // namespace

double number_value(SceneResult& result, const NumberId& id, const Convention& convention) {
  return read(result, {id, convention});
}

std::optional<double> number_value(SceneResult& result, std::string_view name,
                                   const Convention& convention) {
  const auto id = number_id(name);
  if (!id) {
    return std::nullopt;
  }
  const Reading reading{*id, convention};
  const double value = read(result, reading);
  return std::isnan(value) && !reading.is_always ? std::nullopt : std::optional(value);
}

std::string number_unit(const NumberId& id, Units units) {
  return unit_in(units, with_table(id.group, [&id](const auto& table) {
                   return table[id.entry].dimension.unit;
                 }));
}

std::vector<std::pair<std::string, std::string>> text_values(const SceneResult& result,
                                                             const Convention& convention) {
  std::vector<std::pair<std::string, std::string>> texts;
  texts.emplace_back("model", result.model);
  texts.emplace_back("solver", result.solver == SolverChoice::paper ? "paper" : "default");
  texts.emplace_back("units", name_of(convention.units));
  texts.emplace_back("frame", name_of(convention.frame));
  for (std::size_t i = 0; i < result.corrections.size(); ++i) {
    texts.emplace_back("corrections." + std::to_string(i), result.corrections[i]);
  }
  const Warnings warnings = all_warnings(result);
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    texts.emplace_back("warnings." + std::to_string(i), warnings[i].text);
  }
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    texts.emplace_back("warning_classes." + std::to_string(i), name_of(warnings[i].kind));
  }
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    texts.emplace_back("warning_grades." + std::to_string(i), name_of(grade_of(warnings[i])));
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
