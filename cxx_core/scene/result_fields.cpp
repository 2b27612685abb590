// Fields of a patch and outlines of a side: computed on request.
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "creep/rolling_frame.hpp"
#include "results/combined_contact.hpp"
#include "scene/noise_spread.hpp"
#include "scene/patch_fields.hpp"
#include "scene/result_names.hpp"

namespace wrc {
namespace {

using namespace dimensions;

using Values = std::vector<double>;

/// Centres of a grid's elements in the track frame, one coordinate.
template <double Vector3::*coordinate>
Values places_on(const Grid& grid, const WheelDetails& side, const PatchResult& patch) {
  const RollingFrame frame(side.mirror);
  Values values;
  values.reserve(grid.element_count());
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      const Vector3 place = patch.frame.to_track(grid.longitudinal(column), grid.lateral(row), 0.0);
      values.push_back(frame.mirrored(place).*coordinate);
    }
  }
  return values;
}

template <double Vector3::*coordinate>
Values element_places(const WheelDetails& side, const PatchResult& patch) {
  return places_on<coordinate>(patch.grid, side, patch);
}

/// Those of the creep grid; empty without creep forces.
template <double Vector3::*coordinate>
Values creep_places(const WheelDetails& side, const PatchResult& patch) {
  return patch.creep ? places_on<coordinate>(patch.creep->grid, side, patch) : Values{};
}

/// A field on the creep grid; empty without creep forces, and for a patch with parts.
template <Values CreepResult::*field>
Values creep_field(const WheelDetails& /*side*/, const PatchResult& patch) {
  return patch.creep ? (*patch.creep).*field : Values{};
}

/// A component along y, in the track frame.
template <Values CreepResult::*field>
Values lateral_creep_field(const WheelDetails& side, const PatchResult& patch) {
  const RollingFrame frame(side.mirror);
  Values values = creep_field<field>(side, patch);
  for (double& value : values) {
    value = frame.mirrored_lateral(value);
  }
  return values;
}

Values undeformed_distance(const WheelDetails& side, const PatchResult& patch) {
  return patch.parts.empty() ? patch.undeformed_distance : combined_distance(patch, side);
}

/// Scale of inclined rows (remesh/row_scales.hpp); 1 for a contact with parts, which have their
/// own.
Values row_scale(const WheelDetails& /*side*/, const PatchResult& patch) {
  return scales_of_elements(patch);
}

Values pressure(const WheelDetails& /*side*/, const PatchResult& patch) {
  return patch.parts.empty() ? patch.pressure : combined_pressure(patch);
}

Values displacement(const WheelDetails& side, const PatchResult& patch) {
  if (!patch.parts.empty()) {
    return combined_displacement(patch, side);
  }
  return displacement_of(patch, side);
}

/// The rail's outline at the wheelset, at the nodes of the curves of its parts.
template <class Coordinate> Values rail_outline(const WheelResult& side, Coordinate&& coordinate) {
  Values values;
  for (const Curve& curve : side.details.rail->sections()) {
    for (const double arc : curve.starts()) {
      values.push_back(coordinate(curve.at(arc)));
    }
  }
  return values;
}

/// The wheel's contact locus at its height under load.
template <class Coordinate> Values wheel_outline(const WheelResult& side, Coordinate&& coordinate) {
  Values values;
  const WheelDetails& details = side.details;
  const LocusPose pose(details.pose);
  const Curve& curve = details.wheel->graph().curve();
  for (const double arc : curve.starts()) {
    const CurvePoint point = curve.at(arc);
    bool exists = false;
    const LocusAngle angle = pose.angle_at(point.slope(), exists);
    if (exists) {
      values.push_back(coordinate(details.wheel->locus(point, angle, pose).position));
    }
  }
  return values;
}

/// A number of each lobe of a patch.
struct LobeField {
  std::string_view name;
  Dimension dimension;
  double (*number)(const PressureLobe&);
};

template <double ContactPoint::*coordinate> double at_centroid(const PressureLobe& lobe) {
  return lobe.centroid.*coordinate;
}

template <double Vector3::*component> double of_force(const PressureLobe& lobe) {
  return lobe.force.*component;
}

constexpr Dimension turning_stress{Quantity::stress, true};

constexpr std::array patch_fields{
    PatchField{"x", length, element_places<&Vector3::x>},
    PatchField{"y", turning_length, element_places<&Vector3::y>},
    PatchField{"z", turning_length, element_places<&Vector3::z>},
    PatchField{"undeformed_distance", length, undeformed_distance},
    PatchField{"row_scale", pure, row_scale},
    PatchField{"pressure", stress, pressure},
    PatchField{"displacement", length, displacement},
    PatchField{"traction_x", stress, creep_field<&CreepResult::traction_x>},
    PatchField{"traction_y", turning_stress, lateral_creep_field<&CreepResult::traction_y>},
    PatchField{"slip_x", pure, creep_field<&CreepResult::slip_x>},
    PatchField{"slip_y", turning, lateral_creep_field<&CreepResult::slip_y>},
    PatchField{"creep_pressure", stress, creep_field<&CreepResult::pressure>},
    PatchField{"creep_x", length, creep_places<&Vector3::x>},
    PatchField{"creep_y", turning_length, creep_places<&Vector3::y>},
    PatchField{"creep_z", turning_length, creep_places<&Vector3::z>},
};

constexpr std::array lobe_fields{
    LobeField{"lobe_normal_force", force,
              [](const PressureLobe& lobe) { return norm(lobe.force); }},
    LobeField{"lobe_force_x", force, of_force<&Vector3::x>},
    LobeField{"lobe_force_y", turning_force, of_force<&Vector3::y>},
    LobeField{"lobe_force_z", turning_force, of_force<&Vector3::z>},
    LobeField{"lobe_angle", angle, [](const PressureLobe& lobe) { return lobe.angle; }},
    LobeField{"lobe_x", length, at_centroid<&ContactPoint::x>},
    LobeField{"lobe_y", turning_length, at_centroid<&ContactPoint::y>},
    LobeField{"lobe_z", turning_length, at_centroid<&ContactPoint::z>},
    LobeField{"lobe_s_wheel", length, at_centroid<&ContactPoint::s_wheel>},
    LobeField{"lobe_t_rail", length, at_centroid<&ContactPoint::t_rail>},
    LobeField{"lobe_semi_axes_longitudinal", length,
              [](const PressureLobe& lobe) { return lobe.semi_axis_longitudinal; }},
    LobeField{"lobe_semi_axes_lateral", length,
              [](const PressureLobe& lobe) { return lobe.semi_axis_lateral; }},
    LobeField{"lobe_rolling_radius", length, at_centroid<&ContactPoint::rolling_radius>},
};

/// All in the track frame: y and z.
struct Outline {
  std::string_view name;
  Values (*compute)(const WheelResult&);
};

constexpr std::array outlines{
    Outline{"rail_y",
            [](const WheelResult& side) {
              const RollingFrame frame(side.details.mirror);
              return rail_outline(side, [&frame](const CurvePoint& point) {
                return frame.mirrored_lateral(point.lateral);
              });
            }},
    Outline{"rail_z",
            [](const WheelResult& side) {
              return rail_outline(side, [](const CurvePoint& point) { return point.height; });
            }},
    Outline{"wheel_y",
            [](const WheelResult& side) {
              const RollingFrame frame(side.details.mirror);
              return wheel_outline(
                  side, [&frame](const Vector3& place) { return frame.mirrored(place).y; });
            }},
    Outline{"wheel_z",
            [](const WheelResult& side) {
              const double vertical = side.details.vertical;
              return wheel_outline(side,
                                   [vertical](const Vector3& place) { return place.z + vertical; });
            }},
};

/// The parts of a field's name: "left.patches.0.parts.1.pressure".
struct FieldName {
  bool is_right = false;
  bool is_of_patch = false; ///< named with an index; else of the wheel or its first patch
  std::size_t patch = 0;
  std::optional<std::size_t> part;
  std::string_view field;
};

/// Of the scene: what a spread is computed from.
struct SpreadField {
  std::string_view name;
  std::vector<double> SceneSpread::*values;
};
constexpr std::array spread_fields{
    SpreadField{"spread.likely_radius_differences", &SceneSpread::likely_differences},
    SpreadField{"spread.smoothed_radius_differences", &SceneSpread::smoothed_differences}};

/// None for a name without a side, or with an index that is none.
std::optional<FieldName> parts_of(std::string_view name) {
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  FieldName parts;
  parts.is_right = strip_prefix(name, "right.");
  if (!parts.is_right && !strip_prefix(name, "left.")) {
    return std::nullopt;
  }
  parts.is_of_patch = strip_prefix(name, "patches.");
  if (parts.is_of_patch &&
      (!strip_index(name, any, parts.patch) ||
       (strip_prefix(name, "parts.") && !strip_index(name, any, parts.part.emplace())))) {
    return std::nullopt;
  }
  parts.field = name;
  return parts;
}

template <class List> const auto* named(const List& list, std::string_view name) {
  const auto found =
      std::ranges::find_if(list, [name](const auto& entry) { return entry.name == name; });
  return found != list.end() ? &*found : nullptr;
}

const PatchField* patch_field(std::string_view name) {
  const PatchField* field = named(patch_fields, name);
  return field != nullptr ? field : damage_field(name);
}

} // namespace

std::optional<std::vector<double>> field_values(SceneResult& result, std::string_view name,
                                                const Convention& convention) {
  const auto all_told = [&convention](Values values, const Dimension& dimension) {
    if (convention != Convention{}) {
      for (double& value : values) {
        value = to_caller(value, convention, dimension);
      }
    }
    return values;
  };
  if (const SpreadField* const field = named(spread_fields, name)) {
    return all_told(spread_of(result).*field->values, length);
  }
  const std::optional<FieldName> at = parts_of(name);
  if (!at) {
    return std::nullopt;
  }
  auto& side = at->is_right ? result.right : result.left;
  if (!side || (at->is_of_patch && at->patch >= side->patches.size()) ||
      (at->part && *at->part >= side->patches[at->patch].parts.size())) {
    return std::nullopt;
  }
  if (const Outline* outline = named(outlines, at->field); outline && !at->is_of_patch) {
    return all_told(outline->compute(*side), turning_length);
  }
  if (const LobeField* field = named(lobe_fields, at->field)) {
    Values values;
    if (!side->patches.empty()) {
      std::ranges::transform(side->lobes(at->patch, at->part), std::back_inserter(values),
                             field->number);
    }
    return all_told(std::move(values), field->dimension);
  }
  const PatchField* field = patch_field(at->field);
  if (field == nullptr) {
    return std::nullopt;
  }
  if (side->patches.empty()) {
    return Values{};
  }
  const PatchResult& patch = side->patches[at->patch];
  return all_told(field->compute(side->details, at->part ? patch.parts[*at->part] : patch),
                  field->dimension);
}

bool names_field(std::string_view name) {
  const std::optional<FieldName> at = parts_of(name);
  return named(spread_fields, name) ||
         (at && ((named(outlines, at->field) && !at->is_of_patch) ||
                 named(lobe_fields, at->field) || patch_field(at->field)));
}

std::vector<std::string> possible_field_names() {
  std::vector<std::string> names;
  const auto add = [&names](const char* prefix, const auto& list) {
    for (const auto& entry : list) {
      names.push_back(std::string(prefix).append(entry.name));
    }
  };
  add("", spread_fields);
  add("left.", outlines);
  add("left.patches.0.", lobe_fields);
  add("left.patches.0.", patch_fields);
  add("left.patches.0.", damage_fields());
  return names;
}

} // namespace wrc
