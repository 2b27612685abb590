// Fields and outlines of a side, and its residuals: computed when they are asked for.
#include <algorithm>
#include <array>
#include <utility>

#include "scene/solve_scene.hpp"

namespace wrc {
namespace {

using Values = std::vector<double>;

NormalProblem problem_of(const SideResult& side) {
  NormalProblem problem;
  problem.grid = side.grid;
  problem.undeformed_distance = side.details.undeformed_distance;
  problem.combined_modulus = side.details.combined_modulus;
  problem.normal_load = side.details.normal_load;
  if (!problem.normal_load) {
    problem.approach = 0.0;
  }
  return problem;
}

bool has_elements(const SideResult& side) {
  return side.grid.element_count() > 0;
}

/// Element centres in the track frame, one coordinate.
template <class Coordinate> Values element_places(const SideResult& side, Coordinate&& coordinate) {
  Values values;
  values.reserve(side.grid.element_count());
  for (std::size_t row = 0; row < side.grid.lateral_count; ++row) {
    for (std::size_t column = 0; column < side.grid.longitudinal_count; ++column) {
      values.push_back(coordinate(side.details.frame.to_track(side.grid.longitudinal(column),
                                                              side.grid.lateral(row), 0.0)));
    }
  }
  return values;
}

Values displacement(const SideResult& side) {
  if (!has_elements(side)) {
    return {};
  }
  NormalSolution solution;
  solution.pressure = side.details.pressure;
  solution.approach = side.details.problem_approach;
  complete_solution(problem_of(side), solution);
  return std::move(solution.displacement);
}

/// The rail's outline at the nodes of its curve.
template <class Coordinate> Values rail_outline(const SideResult& side, Coordinate&& coordinate) {
  Values values;
  const Curve& curve = side.details.rail->graph().curve();
  for (const double arc : curve.starts()) {
    values.push_back(coordinate(curve.at(arc)));
  }
  return values;
}

/// The wheel's contact locus at its height under load.
template <class Coordinate> Values wheel_outline(const SideResult& side, Coordinate&& coordinate) {
  Values values;
  const SideDetails& details = side.details;
  const Rotation rotation(details.pose);
  const Curve& curve = details.wheel->graph().curve();
  for (const double arc : curve.starts()) {
    if (const auto locus = details.wheel->locus(curve.at(arc), details.pose, rotation)) {
      values.push_back(coordinate(locus->position));
    }
  }
  return values;
}

struct Field {
  std::string_view name;
  Values (*compute)(const SideResult&);
};

constexpr std::array fields{
    Field{"x",
          [](const SideResult& side) {
            return element_places(side, [](const Vector3& place) { return place.x; });
          }},
    Field{"y",
          [](const SideResult& side) {
            const double mirror = side.details.mirror;
            return element_places(side,
                                  [mirror](const Vector3& place) { return mirror * place.y; });
          }},
    Field{"z",
          [](const SideResult& side) {
            return element_places(side, [](const Vector3& place) { return place.z; });
          }},
    Field{"undeformed_distance",
          [](const SideResult& side) { return side.details.undeformed_distance; }},
    Field{"pressure", [](const SideResult& side) { return side.details.pressure; }},
    Field{"displacement", displacement},
    Field{"rail_y",
          [](const SideResult& side) {
            const double mirror = side.details.mirror;
            return rail_outline(
                side, [mirror](const CurvePoint& point) { return mirror * point.lateral; });
          }},
    Field{"rail_z",
          [](const SideResult& side) {
            return rail_outline(side, [](const CurvePoint& point) { return point.height; });
          }},
    Field{"wheel_y",
          [](const SideResult& side) {
            const double mirror = side.details.mirror;
            return wheel_outline(side, [mirror](const Vector3& place) { return mirror * place.y; });
          }},
    Field{"wheel_z",
          [](const SideResult& side) {
            const double vertical = side.details.vertical;
            return wheel_outline(side,
                                 [vertical](const Vector3& place) { return place.z + vertical; });
          }},
};

} // namespace

const Residuals& residuals_of(SideResult& side) {
  if (!side.residuals) {
    side.residuals = has_elements(side) ? compute_residuals(problem_of(side), side.details.pressure,
                                                            side.details.problem_approach)
                                        : Residuals{};
  }
  return *side.residuals;
}

std::optional<std::vector<double>> field_values(const SceneResult& result, std::string_view name) {
  const auto dot = std::min(name.find('.'), name.size());
  const std::string_view side_name = name.substr(0, dot);
  const auto& side = side_name == "left" ? result.left : result.right;
  if ((side_name != "left" && side_name != "right") || !side) {
    return std::nullopt;
  }
  const std::string_view field_name = name.substr(std::min(dot + 1, name.size()));
  const auto found = std::find_if(fields.begin(), fields.end(), [field_name](const Field& field) {
    return field.name == field_name;
  });
  return found == fields.end() ? std::nullopt : std::optional(found->compute(*side));
}

} // namespace wrc
