// Fields of a patch and outlines of a side: computed on request.
#include <algorithm>
#include <array>

#include "half_space/displacement_operator.hpp"
#include "scene/patch_fields.hpp"
#include "scene/result_names.hpp"
#include "wheel/combined_contact.hpp"

namespace wrc {
namespace {

using namespace dimensions;

using Values = std::vector<double>;

/// Element centres in the track frame, one coordinate.
template <class Coordinate>
Values element_places(const PatchResult& patch, Coordinate&& coordinate) {
  Values values;
  values.reserve(patch.grid.element_count());
  for (std::size_t row = 0; row < patch.grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < patch.grid.longitudinal_count; ++column) {
      values.push_back(coordinate(
          patch.frame.to_track(patch.grid.longitudinal(column), patch.grid.lateral(row), 0.0)));
    }
  }
  return values;
}

Values undeformed_distance(const WheelDetails& side, const PatchResult& patch) {
  return patch.parts.empty() ? patch.undeformed_distance : combined_distance(patch, side);
}

Values pressure(const WheelDetails& /*side*/, const PatchResult& patch) {
  return patch.parts.empty() ? patch.pressure : combined_pressure(patch);
}

Values displacement(const WheelDetails& side, const PatchResult& patch) {
  if (!patch.parts.empty()) {
    return combined_displacement(patch, side);
  }
  Values values(patch.grid.element_count());
  DisplacementOperator(patch.grid, side.combined_modulus, side.elements)
      .apply(patch.pressure, values);
  return values;
}

/// The rail's outline at the nodes of its curve.
template <class Coordinate> Values rail_outline(const WheelResult& side, Coordinate&& coordinate) {
  Values values;
  const Curve& curve = side.details.rail->graph().curve();
  for (const double arc : curve.starts()) {
    values.push_back(coordinate(curve.at(arc)));
  }
  return values;
}

/// The wheel's contact locus at its height under load.
template <class Coordinate> Values wheel_outline(const WheelResult& side, Coordinate&& coordinate) {
  Values values;
  const WheelDetails& details = side.details;
  const Rotation rotation(details.pose);
  const Curve& curve = details.wheel->graph().curve();
  for (const double arc : curve.starts()) {
    if (const auto locus = details.wheel->locus(curve.at(arc), details.pose, rotation)) {
      values.push_back(coordinate(locus->position));
    }
  }
  return values;
}

/// Of the creep grid; empty without creep forces, and of a patch with parts.
Values creep_field(const PatchResult& patch, std::vector<double> CreepResult::*field,
                   double mirror = 1.0) {
  if (!patch.creep) {
    return {};
  }
  Values values = (*patch.creep).*field;
  for (double& value : values) {
    value *= mirror;
  }
  return values;
}

/// Places of the creep grid's elements in the track frame.
template <class Coordinate> Values creep_places(const PatchResult& patch, Coordinate&& coordinate) {
  Values values;
  if (!patch.creep) {
    return values;
  }
  const Grid& grid = patch.creep->grid;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      values.push_back(
          coordinate(patch.frame.to_track(grid.longitudinal(column), grid.lateral(row), 0.0)));
    }
  }
  return values;
}

constexpr std::array patch_fields{
    PatchField{"x", length,
               [](const WheelDetails&, const PatchResult& patch) {
                 return element_places(patch, [](const Vector3& place) { return place.x; });
               }},
    PatchField{"y", turning_length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 const double mirror = side.mirror;
                 return element_places(patch,
                                       [mirror](const Vector3& place) { return mirror * place.y; });
               }},
    PatchField{"z", turning_length,
               [](const WheelDetails&, const PatchResult& patch) {
                 return element_places(patch, [](const Vector3& place) { return place.z; });
               }},
    PatchField{"undeformed_distance", length, undeformed_distance},
    PatchField{"pressure", {Quantity::stress, false}, pressure},
    PatchField{"displacement", length, displacement},
    PatchField{"traction_x",
               {Quantity::stress, false},
               [](const WheelDetails&, const PatchResult& patch) {
                 return creep_field(patch, &CreepResult::traction_x);
               }},
    PatchField{"traction_y",
               {Quantity::stress, true},
               [](const WheelDetails& side, const PatchResult& patch) {
                 return creep_field(patch, &CreepResult::traction_y, side.mirror);
               }},
    PatchField{"slip_x", pure,
               [](const WheelDetails&, const PatchResult& patch) {
                 return creep_field(patch, &CreepResult::slip_x);
               }},
    PatchField{"slip_y", turning,
               [](const WheelDetails& side, const PatchResult& patch) {
                 return creep_field(patch, &CreepResult::slip_y, side.mirror);
               }},
    PatchField{"creep_pressure",
               {Quantity::stress, false},
               [](const WheelDetails&, const PatchResult& patch) {
                 return creep_field(patch, &CreepResult::pressure);
               }},
    PatchField{"creep_x", length,
               [](const WheelDetails&, const PatchResult& patch) {
                 return creep_places(patch, [](const Vector3& place) { return place.x; });
               }},
    PatchField{"creep_y", turning_length,
               [](const WheelDetails& side, const PatchResult& patch) {
                 const double mirror = side.mirror;
                 return creep_places(patch,
                                     [mirror](const Vector3& place) { return mirror * place.y; });
               }},
    PatchField{"creep_z", turning_length,
               [](const WheelDetails&, const PatchResult& patch) {
                 return creep_places(patch, [](const Vector3& place) { return place.z; });
               }},
};

/// All in the track frame: y and z.
struct Outline {
  std::string_view name;
  Values (*compute)(const WheelResult&);
};

constexpr std::array outlines{
    Outline{"rail_y",
            [](const WheelResult& side) {
              const double mirror = side.details.mirror;
              return rail_outline(
                  side, [mirror](const CurvePoint& point) { return mirror * point.lateral; });
            }},
    Outline{"rail_z",
            [](const WheelResult& side) {
              return rail_outline(side, [](const CurvePoint& point) { return point.height; });
            }},
    Outline{"wheel_y",
            [](const WheelResult& side) {
              const double mirror = side.details.mirror;
              return wheel_outline(side,
                                   [mirror](const Vector3& place) { return mirror * place.y; });
            }},
    Outline{"wheel_z",
            [](const WheelResult& side) {
              const double vertical = side.details.vertical;
              return wheel_outline(side,
                                   [vertical](const Vector3& place) { return place.z + vertical; });
            }},
};

} // namespace

std::optional<std::vector<double>> field_values(const SceneResult& result, std::string_view name,
                                                const Convention& convention) {
  const auto all_told = [&convention](Values values, const Dimension& dimension) {
    if (convention != Convention{}) {
      for (double& value : values) {
        value = to_caller(value, convention, dimension);
      }
    }
    return values;
  };
  const bool left = strip_prefix(name, "left.");
  const auto& side = left || !strip_prefix(name, "right.") ? result.left : result.right;
  if (!side || (!left && &side == &result.left)) {
    return std::nullopt;
  }
  for (const Outline& outline : outlines) {
    if (outline.name == name) {
      return all_told(outline.compute(*side), turning_length);
    }
  }
  const PatchResult* patch = side->patches.empty() ? nullptr : &side->patches.front();
  std::size_t index = 0;
  if (strip_prefix(name, "patches.")) {
    if (!strip_index(name, side->patches.size(), index)) {
      return std::nullopt;
    }
    patch = &side->patches[index];
    if (strip_prefix(name, "parts.")) {
      if (!strip_index(name, patch->parts.size(), index)) {
        return std::nullopt;
      }
      patch = &patch->parts[index];
    }
  }
  const auto named = [name](const PatchField& field) { return field.name == name; };
  const auto found = std::find_if(patch_fields.begin(), patch_fields.end(), named);
  const PatchField* field = found != patch_fields.end() ? &*found : damage_field(name);
  if (field == nullptr) {
    return std::nullopt;
  }
  return patch == nullptr ? Values{}
                          : all_told(field->compute(side->details, *patch), field->dimension);
}

} // namespace wrc
