/// Tables of the numbers of contact damage: stresses, wear, fatigue (scene/number_tables.hpp).
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "scene/number_table.hpp"

namespace wrc::number_tables {

/// A number of a part of the damage that may not have been requested.
template <auto part, auto... path>
inline constexpr auto member_of_part = [](const ContactDamage& damage) {
  const auto& found = damage.*part;
  return found ? std::optional<double>(member<path...>(*found)) : std::nullopt;
};
template <auto... path>
inline constexpr auto of_stress = member_of_part<&ContactDamage::stress, path...>;
template <auto... path>
inline constexpr auto of_wear = member_of_part<&ContactDamage::wear, path...>;
template <auto... path>
inline constexpr auto of_fatigue = member_of_part<&ContactDamage::fatigue, path...>;

using OfDamage = Number<ContactDamage>;

/// Numbers of a patch, or the worst of a wheel's.
inline constexpr std::array damage_numbers{
    OfDamage{"stress.von_mises_max", stress, of_stress<&GreatestStress::von_mises>},
    OfDamage{"stress.shear", stress, of_stress<&GreatestStress::shear>},
    OfDamage{"stress.tension", stress, of_stress<&GreatestStress::tension>},
    OfDamage{"stress.depth", length, of_stress<&GreatestStress::depth>},
    OfDamage{"stress.along", length, of_stress<&GreatestStress::x>},
    OfDamage{"stress.across", length, of_stress<&GreatestStress::y>},
    OfDamage{"stress.error_estimate", pure,
             [](const ContactDamage& damage) {
               const auto error = of_stress<&GreatestStress::error_estimate>(damage);
               return error && std::isfinite(*error) ? error : std::nullopt;
             }},
    OfDamage{"wear.tgamma", force, of_wear<&WearTotals::tgamma>},
    OfDamage{"wear.tgamma_with_spin", force, of_wear<&WearTotals::tgamma_with_spin>},
    OfDamage{"wear.volume", surface, of_wear<&WearTotals::volume>},
    OfDamage{"wear.depth_max", length, of_wear<&WearTotals::depth>},
    OfDamage{"groove.depth_max", length, member<&ContactDamage::groove_depth>},
    OfDamage{"fatigue.friction", pure, of_fatigue<&Fatigue::friction>},
    OfDamage{"fatigue.pressure_ratio", pure, of_fatigue<&Fatigue::pressure_ratio>},
    OfDamage{"fatigue.elastic_limit", pure,
             of_fatigue<&Fatigue::limits, &ShakedownLimits::elastic>},
    OfDamage{"fatigue.shakedown_limit", pure,
             of_fatigue<&Fatigue::limits, &ShakedownLimits::shakedown>},
    OfDamage{"fatigue.surface_index", pure, of_fatigue<&Fatigue::surface_index>},
    OfDamage{"fatigue.rail_damage", pure, of_fatigue<&Fatigue::rail_damage>},
};

} // namespace wrc::number_tables
