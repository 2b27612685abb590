// Fields of stresses below the surface and of wear: computed on request.
#include <algorithm>
#include <array>

#include "creep/rolling_frame.hpp"
#include "results/contact_damage.hpp"
#include "scene/patch_fields.hpp"

namespace wrc {
namespace {

using namespace dimensions;

using Values = std::vector<double>;

/// A number at each point of the section of stresses, positions along it running fastest.
template <class Number>
Values section_field(const WheelDetails& side, const PatchResult& patch, Number&& number) {
  const StressSection section = stress_section(side, patch);
  Values values;
  for (std::size_t i = 0; i < section.stresses.size(); ++i) {
    values.push_back(number(section, i));
  }
  return values;
}

/// A component, in the track frame.
template <StressComponent component>
Values stress_field(const WheelDetails& side, const PatchResult& patch) {
  const RollingFrame frame(side.mirror);
  return section_field(side, patch, [&frame](const StressSection& section, std::size_t i) {
    return frame.mirrored(section.stresses[i])[component];
  });
}

constexpr std::array fields{
    PatchField{"stress_place", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return section_field(side, patch, [](const StressSection& s, std::size_t i) {
                   return s.places[i % s.places.size()];
                 });
               }},
    PatchField{"stress_depth", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return section_field(side, patch, [](const StressSection& s, std::size_t i) {
                   return s.depths[i / s.places.size()];
                 });
               }},
    PatchField{"stress_von_mises",
               {Quantity::stress, false},
               [](const WheelDetails& side, const PatchResult& patch) {
                 return section_field(side, patch, [](const StressSection& s, std::size_t i) {
                   return von_mises(s.stresses[i]);
                 });
               }},
    PatchField{"stress_shear",
               {Quantity::stress, false},
               [](const WheelDetails& side, const PatchResult& patch) {
                 return section_field(side, patch, [](const StressSection& s, std::size_t i) {
                   return greatest_shear(s.stresses[i]);
                 });
               }},
    PatchField{"stress_xx", {Quantity::stress, false}, stress_field<xx>},
    PatchField{"stress_yy", {Quantity::stress, false}, stress_field<yy>},
    PatchField{"stress_zz", {Quantity::stress, false}, stress_field<zz>},
    PatchField{"stress_xy", {Quantity::stress, true}, stress_field<xy>},
    PatchField{"stress_xz", {Quantity::stress, false}, stress_field<xz>},
    PatchField{"stress_yz", {Quantity::stress, true}, stress_field<yz>},
    PatchField{"frictional_energy",
               {Quantity::stress, false},
               [](const WheelDetails& side, const PatchResult& patch) {
                 return patch_wear(side, patch).energy;
               }},
    PatchField{"wear_depth", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return patch_wear(side, patch).depth;
               }},
    PatchField{"wear_s_wheel", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return wear_places(side, patch).s_wheel;
               }},
    PatchField{"wear_t_rail", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return wear_places(side, patch).t_rail;
               }},
    PatchField{"groove_depth_wheel", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return patch_groove(side, patch)[0];
               }},
    PatchField{"groove_depth_rail", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return patch_groove(side, patch)[1];
               }},
    PatchField{"groove_s_wheel", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return groove_places(side, patch).s_wheel;
               }},
    PatchField{"groove_t_rail", length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return groove_places(side, patch).t_rail;
               }},
};

} // namespace

const PatchField* damage_field(std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [name](const PatchField& field) { return field.name == name; });
  return found != fields.end() ? &*found : nullptr;
}

std::span<const PatchField> damage_fields() {
  return fields;
}

} // namespace wrc
