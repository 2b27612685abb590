/// Tables of the numbers of contact damage: stresses, wear, fatigue (scene/number_tables.hpp).
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "scene/number_table.hpp"

namespace wrc::number_tables {

/// A number of a part of the damage that may not have been requested.
template <class Part, class Value>
std::optional<double> of_part(const std::optional<Part>& part, Value&& value) {
  return part ? std::optional<double>(value(*part)) : std::nullopt;
}

/// Of a patch, or the worst of a wheel's.
inline constexpr std::array damage_numbers{
    Number<ContactDamage>{"stress.von_mises_max", stress,
                          [](const ContactDamage& d) {
                            return of_part(d.stress,
                                           [](const GreatestStress& s) { return s.von_mises; });
                          }},
    Number<ContactDamage>{"stress.shear", stress,
                          [](const ContactDamage& d) {
                            return of_part(d.stress, [](const auto& s) { return s.shear; });
                          }},
    Number<ContactDamage>{"stress.tension", stress,
                          [](const ContactDamage& d) {
                            return of_part(d.stress, [](const auto& s) { return s.tension; });
                          }},
    Number<ContactDamage>{"stress.depth", length,
                          [](const ContactDamage& d) {
                            return of_part(d.stress, [](const auto& s) { return s.depth; });
                          }},
    Number<ContactDamage>{"stress.along", length,
                          [](const ContactDamage& d) {
                            return of_part(d.stress, [](const auto& s) { return s.x; });
                          }},
    Number<ContactDamage>{"stress.across", length,
                          [](const ContactDamage& d) {
                            return of_part(d.stress, [](const auto& s) { return s.y; });
                          }},
    Number<ContactDamage>{"stress.error_estimate", pure,
                          [](const ContactDamage& d) {
                            const auto error =
                                of_part(d.stress, [](const auto& s) { return s.error_estimate; });
                            return error && std::isfinite(*error) ? error : std::nullopt;
                          }},
    Number<ContactDamage>{"wear.tgamma", force,
                          [](const ContactDamage& d) {
                            return of_part(d.wear, [](const auto& w) { return w.tgamma; });
                          }},
    Number<ContactDamage>{"wear.tgamma_with_spin", force,
                          [](const ContactDamage& d) {
                            return of_part(d.wear,
                                           [](const auto& w) { return w.tgamma_with_spin; });
                          }},
    Number<ContactDamage>{
        "wear.volume", surface,
        [](const ContactDamage& d) { return d.wear ? d.wear->volume : std::nullopt; }},
    Number<ContactDamage>{
        "wear.depth_max", length,
        [](const ContactDamage& d) { return d.wear ? d.wear->depth : std::nullopt; }},
    Number<ContactDamage>{"fatigue.friction", pure,
                          [](const ContactDamage& d) {
                            return of_part(d.fatigue, [](const auto& f) { return f.friction; });
                          }},
    Number<ContactDamage>{"fatigue.pressure_ratio", pure,
                          [](const ContactDamage& d) {
                            return of_part(d.fatigue,
                                           [](const auto& f) { return f.pressure_ratio; });
                          }},
    Number<ContactDamage>{"fatigue.elastic_limit", pure,
                          [](const ContactDamage& d) {
                            return of_part(d.fatigue,
                                           [](const auto& f) { return f.limits.elastic; });
                          }},
    Number<ContactDamage>{"fatigue.shakedown_limit", pure,
                          [](const ContactDamage& d) {
                            return of_part(d.fatigue,
                                           [](const auto& f) { return f.limits.shakedown; });
                          }},
    Number<ContactDamage>{"fatigue.surface_index", pure,
                          [](const ContactDamage& d) {
                            return of_part(d.fatigue,
                                           [](const auto& f) { return f.surface_index; });
                          }},
    Number<ContactDamage>{"fatigue.rail_damage", pure,
                          [](const ContactDamage& d) {
                            return of_part(d.fatigue, [](const auto& f) { return f.rail_damage; });
                          }},
};

} // namespace wrc::number_tables
